use super::Quat;
use crate::quaternion::{Quaternion, delegate_quaternion};
use crate::real::Real;
use crate::shared_trait::sealed::Sealed;

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
