use super::Quat;
use crate::contract::sealed::Sealed;
use crate::contract::{Quaternion, delegate_quaternion};
use dq8_simd::Lanes;

impl<L: Lanes> Sealed for Quat<L> {}

impl<L: Lanes> Quaternion for Quat<L> {
    type Level = L::Level;
    type Real = L;
    type Mask = L::Mask;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn identity(level: L::Level) -> Self {
        Self::identity(level)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn normalize_checked(self) -> (Self, L::Mask) {
        self.normalize_checked()
    }
    delegate_quaternion!();
}
