//! Adjoint maps of twists and wrenches, and Jacobians of the exponential of SE(3). Twists x = ω +
//! εv are dual vectors. With the dual number u = x·x, the left Jacobian and its inverse are
//!
//! ```text
//! J_l(x) y   = y +   A(u) x×y + B(u) x×(x×y)
//! J_l⁻¹(x) y = y − ½      x×y + C(u) x×(x×y)
//! ```
//!
//! The coefficients A, B and C are analytic in u and are computed by [`even`](super::even).

use super::even::{exponential_integrals, half_cotangent};
use super::{Dual, DualQuat, vector};
use crate::geometry::{Twist, Wrench};
use dq8_simd::Lanes;

impl<L: Lanes> DualQuat<L> {
    /// Returns the twist moved by unit σ (with rotation R and translation t): its angular part is
    /// ω′ = Rω, its linear part v′ = Rv + t × ω′.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn adjoint(self, twist: Twist<L>) -> Twist<L> {
        let (angular, linear) = self.carry(twist.angular, twist.linear);
        Twist { angular, linear }
    }

    /// Returns the wrench moved by unit σ (with rotation R and translation t): its force is f′ =
    /// Rf, its torque τ′ = Rτ + t × f′.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn coadjoint(self, wrench: Wrench<L>) -> Wrench<L> {
        let (force, torque) = self.carry(wrench.force, wrench.torque);
        Wrench { force, torque }
    }
}

impl<L: Lanes> DualQuat<L> {
    /// Returns J_l(x) y, the left Jacobian at the twist x = `at` applied to the twist y = `along`,
    /// with exp(½(x + δy)) ≈ exp(½δ J_l(x) y) exp(½x) for small δ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn left_jacobian(at: Twist<L>, along: Twist<L>) -> Twist<L> {
        let (first, second) = exponential_integrals(square(at));
        let once = lie_bracket(at, along);
        times_onto(second, lie_bracket(at, once), times_onto(first, once, along))
    }

    /// Returns J_r(x) y, the right Jacobian at the twist x = `at` applied to the twist y = `along`,
    /// with exp(½(x + δy)) ≈ exp(½x) exp(½δ J_r(x) y) for small δ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn right_jacobian(at: Twist<L>, along: Twist<L>) -> Twist<L> {
        Self::left_jacobian(-at, along)
    }

    /// Returns J_l⁻¹(x) y, the inverse of the left Jacobian at x = `at` applied to y = `along`,
    /// with 2 log(exp(½δy) exp(½x)) ≈ x + δ J_l⁻¹(x) y for small δ. The result is
    /// infinite at |ω| = 2π.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn left_jacobian_inverse(at: Twist<L>, along: Twist<L>) -> Twist<L> {
        let u = square(at);
        let minus_half = Dual::new(u.real.constant(-0.5), u.real.constant(0.0));
        let once = lie_bracket(at, along);
        times_onto(half_cotangent(u), lie_bracket(at, once), times_onto(minus_half, once, along))
    }

    /// Returns J_r⁻¹(x) y, the inverse of the right Jacobian at x = `at` applied to y = `along`,
    /// with 2 log(exp(½x) exp(½δy)) ≈ x + δ J_r⁻¹(x) y for small δ. The result is
    /// infinite at |ω| = 2π.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn right_jacobian_inverse(at: Twist<L>, along: Twist<L>) -> Twist<L> {
        Self::left_jacobian_inverse(-at, along)
    }

    /// Returns the rows of the 6×6 matrices of the left Jacobian J_l(x), x = `at`. They act on
    /// columns `[ωx, ωy, ωz, vx, vy, vz]`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn left_jacobian_matrix(at: Twist<L>) -> [[L; 6]; 6] {
        matrix(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |along| Self::left_jacobian(at, along),
            at,
        )
    }

    /// Returns the rows of the 6×6 matrices of the inverse left Jacobian J_l⁻¹(x), x = `at`,
    /// with twists in the order of [`left_jacobian_matrix`](Self::left_jacobian_matrix).
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

/// Returns the rows of the matrix of a linear map on twists. Its columns are the images of the six
/// unit twists. The value of `any` does not matter, because it only serves to make constants on
/// lanes. Callers pass a closure marked `inline(always)`, because the compiler does not inline a
/// function that is passed by name.
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

/// Returns the dual number x·x = |ω|² + 2ε ω·v of the twist x = ω + εv.
#[cfg_attr(not(opt_level_0), inline(always))]
fn square<L: Lanes>(x: Twist<L>) -> Dual<L> {
    let across = vector::dot(x.angular, x.linear);
    Dual::new(vector::dot(x.angular, x.angular), across + across)
}

/// Returns the Lie bracket [x, y] = ad_x y of two twists, their cross product x × y. It is the
/// rate of change of y while a motion with the twist x carries y along.
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn lie_bracket<L: Lanes>(x: Twist<L>, y: Twist<L>) -> Twist<L> {
    let moved = vector::cross(x.linear, y.angular);
    Twist {
        angular: vector::cross(x.angular, y.angular),
        linear: vector::cross_onto(x.angular, y.linear, moved),
    }
}

/// Returns (a + εb)x + y for the dual number a + εb = `factor`.
#[cfg_attr(not(opt_level_0), inline(always))]
fn times_onto<L: Lanes>(factor: Dual<L>, x: Twist<L>, y: Twist<L>) -> Twist<L> {
    let linear = vector::scale_onto(x.angular, factor.dual, y.linear);
    Twist {
        angular: vector::scale_onto(x.angular, factor.real, y.angular),
        linear: vector::scale_onto(x.linear, factor.real, linear),
    }
}
