//! Implementations of the contract traits for the types of the scalar reference.

use super::{Dual, DualQuat, Quat};
use crate::contract::sealed::Sealed;
use crate::contract::{DualNumber, Motion, Quaternion};
use crate::contract::{delegate_dual_number, delegate_motion, delegate_quaternion};
use crate::geometry::{DualVector, Line, Mean, Plane, Screw, Twist, Wrench};
use crate::number::Real;

impl<R: Real> Sealed for Dual<R> {}

impl<R: Real> DualNumber for Dual<R> {
    type Real = R;

    #[inline]
    fn parts(self) -> [R; 2] {
        [self.real, self.dual]
    }
    delegate_dual_number!();
}

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
