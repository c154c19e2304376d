use super::Quat;
use crate::contract::sealed::Sealed;
use crate::contract::{Quaternion, delegate_quaternion};
use crate::number::Real;

impl<R: Real> Sealed for Quat<R> {}

impl<R: Real> Quaternion for Quat<R> {
    type Level = ();
    type Real = R;
    type Mask = bool;

    #[inline]
    fn identity((): ()) -> Self {
        Self::IDENTITY
    }
    #[inline]
    fn normalize_checked(self) -> (Self, bool) {
        self.try_normalize().map_or((Self::from_array([R::NAN; 4]), true), |unit| (unit, false))
    }
    delegate_quaternion!();
}
