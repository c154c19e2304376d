//! What a change of frame does to twists and wrenches.

use super::DualQuat;
use crate::geometry::{Twist, Wrench};
use dq8_simd::Lanes;

impl<L: Lanes> DualQuat<L> {
    /// ω′ = Rω, v′ = Rv + t × ω′; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn adjoint(self, twist: Twist<L>) -> Twist<L> {
        let (angular, linear) = self.carry(twist.angular, twist.linear);
        Twist { angular, linear }
    }

    /// f′ = Rf, τ′ = Rτ + t × f′; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn coadjoint(self, wrench: Wrench<L>) -> Wrench<L> {
        let (force, torque) = self.carry(wrench.force, wrench.torque);
        Wrench { force, torque }
    }
}
