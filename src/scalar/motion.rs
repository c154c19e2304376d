use super::{Dual, DualQuat, Quat};
use crate::contract::sealed::Sealed;
use crate::contract::{Motion, delegate_motion};
use crate::geometry::{DualVector, Line, Mean, Plane, Screw, Twist, Wrench};
use crate::number::Real;

impl<R: Real> Sealed for DualQuat<R> {}

impl<R: Real> Motion for DualQuat<R> {
    type Level = ();
    type Real = R;
    type Mask = bool;
    type Dual = Dual<R>;
    type Quat = Quat<R>;

    #[inline]
    fn identity((): ()) -> Self {
        Self::IDENTITY
    }
    #[inline]
    fn normalize_checked(self) -> (Self, bool) {
        self.try_normalize().map_or((Self::nan(), true), |unit| (unit, false))
    }
    #[inline]
    fn inverse_checked(self) -> (Self, bool) {
        self.try_inverse().map_or((Self::nan(), true), |inverse| (inverse, false))
    }
    delegate_motion!();
}
