//! Adjoint maps of twists and wrenches, and Jacobians of the exponential of SE(3), on dual numbers:
//! with u = x·x,
//!
//! ```text
//! J_l(x) y   = y +   A(u) x×y + B(u) x×(x×y)
//! J_l⁻¹(x) y = y − ½      x×y + C(u) x×(x×y)
//! ```
//!
//! The coefficients are analytic in u: see [`even`](super::even).

use super::even::{exponential_integrals, half_cotangent};
use super::{Dual, DualQuat, vector};
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

impl<L: Lanes> DualQuat<L> {
    /// exp(½(x + δy)) ≈ exp(½δ J_l(x) y) exp(½x) with x = `at`, y = `along`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn left_jacobian(at: Twist<L>, along: Twist<L>) -> Twist<L> {
        let (first, second) = exponential_integrals(square(at));
        let once = lie_bracket(at, along);
        times_onto(second, lie_bracket(at, once), times_onto(first, once, along))
    }

    /// exp(½(x + δy)) ≈ exp(½x) exp(½δ J_r(x) y)
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn right_jacobian(at: Twist<L>, along: Twist<L>) -> Twist<L> {
        Self::left_jacobian(-at, along)
    }

    /// 2 log(exp(½δy) exp(½x)) ≈ x + δ J_l⁻¹(x) y; infinite at |ω| = 2π.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn left_jacobian_inverse(at: Twist<L>, along: Twist<L>) -> Twist<L> {
        let u = square(at);
        let minus_half = Dual::new(u.real.constant(-0.5), u.real.constant(0.0));
        let once = lie_bracket(at, along);
        times_onto(half_cotangent(u), lie_bracket(at, once), times_onto(minus_half, once, along))
    }

    /// 2 log(exp(½x) exp(½δy)) ≈ x + δ J_r⁻¹(x) y; infinite at |ω| = 2π.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn right_jacobian_inverse(at: Twist<L>, along: Twist<L>) -> Twist<L> {
        Self::left_jacobian_inverse(-at, along)
    }

    /// J_l(x) as 6×6 matrices, rows, of columns `[ωx, ωy, ωz, vx, vy, vz]`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn left_jacobian_matrix(at: Twist<L>) -> [[L; 6]; 6] {
        matrix(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |along| Self::left_jacobian(at, along),
            at,
        )
    }

    /// J_l⁻¹(x) as 6×6 matrices, in the order of
    /// [`left_jacobian_matrix`](Self::left_jacobian_matrix).
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn left_jacobian_inverse_matrix(at: Twist<L>) -> [[L; 6]; 6] {
        matrix(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |along| Self::left_jacobian_inverse(at, along),
            at,
        )
    }
}

/// The matrix of a linear map: its columns are what it does to the unit twists, on the lanes of
/// `any`. (The name of a function for the map is a call that is not inlined.)
#[cfg_attr(not(opt_level_0), inline(always))]
fn matrix<L: Lanes>(map: impl Fn(Twist<L>) -> Twist<L>, any: Twist<L>) -> [[L; 6]; 6] {
    let mut rows = [any.to_array(); 6];
    for column in 0..6 {
        let mut unit = [any.angular[0].constant(0.0); 6];
        unit[column] = unit[column].constant(1.0);
        let image = map(Twist::from_array(unit)).to_array();
        for (row, value) in rows.iter_mut().zip(image) {
            row[column] = value;
        }
    }
    rows
}

/// x·x
#[cfg_attr(not(opt_level_0), inline(always))]
fn square<L: Lanes>(x: Twist<L>) -> Dual<L> {
    let across = vector::dot(x.angular, x.linear);
    Dual::new(vector::dot(x.angular, x.angular), across + across)
}

/// x × y, the Lie bracket [x, y]: ad_x y, how fast y changes that is carried along by the twist x.
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn lie_bracket<L: Lanes>(x: Twist<L>, y: Twist<L>) -> Twist<L> {
    let moved = vector::cross(x.linear, y.angular);
    Twist {
        angular: vector::cross(x.angular, y.angular),
        linear: vector::cross_onto(x.angular, y.linear, moved),
    }
}

/// (a + εb)x + y
#[cfg_attr(not(opt_level_0), inline(always))]
fn times_onto<L: Lanes>(factor: Dual<L>, x: Twist<L>, y: Twist<L>) -> Twist<L> {
    let linear = vector::scale_onto(x.angular, factor.dual, y.linear);
    Twist {
        angular: vector::scale_onto(x.angular, factor.real, y.angular),
        linear: vector::scale_onto(x.linear, factor.real, linear),
    }
}
