//! What a change of frame does to twists and wrenches.

use super::{DualQuat, vector};
use crate::geometry::{Twist, Wrench};
use dq8_simd::Lanes;

impl<L: Lanes> DualQuat<L> {
    /// ω′ = Rω, v′ = Rv + t × ω′; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn adjoint(self, twist: Twist<L>) -> Twist<L> {
        let angular = self.real().rotate(twist.angular);
        let turned = self.real().rotate(twist.linear);
        Twist { angular, linear: vector::cross_onto(self.translation(), angular, turned) }
    }

    /// f′ = Rf, τ′ = Rτ + t × f′; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn coadjoint(self, wrench: Wrench<L>) -> Wrench<L> {
        let force = self.real().rotate(wrench.force);
        let turned = self.real().rotate(wrench.torque);
        Wrench { force, torque: vector::cross_onto(self.translation(), force, turned) }
    }
}
