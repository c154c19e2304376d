//! The traits [`Motion`], [`Quaternion`] and [`DualNumber`], implemented for the types on lanes.

use super::{Dual, DualQuat, Quat};
use crate::contract::sealed::Sealed;
use crate::contract::{DualNumber, Motion, Quaternion};
use crate::contract::{delegate_dual_number, delegate_motion, delegate_quaternion};
use crate::geometry::{DualVector, Line, Mean, Plane, Screw, Twist, Wrench};
use dq8_simd::Lanes;

impl<L: Lanes> Sealed for Dual<L> {}

impl<L: Lanes> DualNumber for Dual<L> {
    type Real = L;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn parts(self) -> [L; 2] {
        [self.real, self.dual]
    }
    delegate_dual_number!();
}

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

impl<L: Lanes> Sealed for DualQuat<L> {}

impl<L: Lanes> Motion for DualQuat<L> {
    type Level = L::Level;
    type Real = L;
    type Mask = L::Mask;
    type Dual = Dual<L>;
    type Quat = Quat<L>;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn identity(level: L::Level) -> Self {
        Self::identity(level)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn normalize_checked(self) -> (Self, L::Mask) {
        self.normalize_checked()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn inverse_checked(self) -> (Self, L::Mask) {
        self.inverse_checked()
    }
    delegate_motion!();
}
