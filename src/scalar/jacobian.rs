//! Adjoint maps of twists and wrenches, and Jacobians of the exponential of SE(3), on dual numbers.
//!
//! Twists are dual vectors, and the Lie bracket of se(3) is their dual cross product x × y =
//! ω×η + ε(ω×w + v×η). So the Jacobians of SE(3) are those of SO(3) with dual numbers in
//! place of real numbers (the transfer principle). With u = x·x = ω·ω + 2ε ω·v:
//!
//! ```text
//! J_l(x) y   = y +   A x×y + B x×(x×y),  A = (1 − cos √u)/u, B = (√u − sin √u)/√u³
//! J_l⁻¹(x) y = y − ½ x×y   + C x×(x×y),  C = (1 − (√u/2) cot(√u/2))/u
//! ```

use super::{Dual, DualQuat, vector};
use crate::geometry::{Twist, Wrench};
use crate::number::Real;

impl<R: Real> Twist<R> {
    /// The zero twist, which is the twist of a body at rest.
    pub const ZERO: Self = Self::from_array([R::ZERO; 6]);
}

impl<R: Real> DualQuat<R> {
    /// Returns Ad_σ ξ = σ(ω + εv)σ*: ω′ = Rω, v′ = Rv + t × ω′ (Murray, Li, Sastry
    /// 1994, eq. 2.58), which is also the formula for lines. It converts a twist from the body's
    /// frame to the fixed frame; `conjugate().adjoint()` converts it back. Ad_{ab} = Ad_a Ad_b. σ
    /// must be unit.
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// let pose = DualQuat::from_translation([2.0_f32, 0.0, 0.0]);
    /// let turning = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0; 3] };
    /// // At the fixed origin, what turns with a body at x = 2 moves down.
    /// assert_eq!(pose.adjoint(turning).linear, [0.0, -2.0, 0.0]);
    /// ```
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("action_matrix", "Ad"))]
    pub fn adjoint(self, twist: Twist<R>) -> Twist<R> {
        crate::scalar::must_be_unit::motions("DualQuat::adjoint", [self]);
        let (angular, linear) = self.carry(twist.angular, twist.linear);
        Twist { angular, linear }
    }

    /// Returns the co-adjoint action on a wrench: f′ = Rf, τ′ = Rτ + t × f′. It converts a
    /// wrench from the body's frame to the fixed frame, so that the power of a wrench on a twist is
    /// the same in both frames. σ must be unit.
    ///
    /// The map is (Ad_σ⁻¹)ᵀ, a left action: the map of a product ab applies the map of b
    /// first, then the map of a (Murray, Li and Sastry 1994, §2.5).
    ///
    /// ```
    /// use dq8::{DualQuat, geometry::Wrench};
    /// let pose = DualQuat::from_translation([2.0_f32, 0.0, 0.0]);
    /// let weight = Wrench { force: [0.0, 0.0, -9.0], torque: [0.0; 3] };
    /// assert_eq!(pose.coadjoint(weight).torque, [0.0, 18.0, 0.0]);
    /// ```
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn coadjoint(self, wrench: Wrench<R>) -> Wrench<R> {
        crate::scalar::must_be_unit::motions("DualQuat::coadjoint", [self]);
        let (force, torque) = self.carry(wrench.force, wrench.torque);
        Wrench { force, torque }
    }
}

impl<R: Real> DualQuat<R> {
    /// The left Jacobian of SE(3) at the twist x = `at`, applied to y = `along`. It says how the
    /// motion exp(½x) changes on its *spatial* side if x changes by δy, with a small δ:
    /// exp(½(x + δy)) ≈ exp(½δ J_l(x) y) exp(½x).
    ///
    /// The formula is that of Barfoot & Furgale 2014 and Barfoot 2017, eq. 7.85, where the
    /// translation comes first. `at` is a twist as [`to_twist`](Self::to_twist) gives it, in
    /// radians and lengths, with any |ω|. At |ω| = 2π, 4π, … the Jacobian is singular, but
    /// finite.
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// let at = Twist { angular: [0.0_f64, 0.0, 1.0], linear: [1.0, 2.0, 3.0] };
    /// let along = Twist { angular: [1.0, 0.0, 0.0], linear: [0.0, 1.0, 0.0] };
    /// let step = 1e-6;
    /// let (a, b) = (DualQuat::from_twist(at), DualQuat::from_twist(at + along.scale(step)));
    /// let change = (b * a.conjugate()).to_twist().scale(1.0 / step);
    /// let error = change - DualQuat::left_jacobian(at, along);
    /// assert!(error.to_array().iter().all(|e| e.abs() < 1e-5));
    /// ```
    #[inline]
    pub fn left_jacobian(at: Twist<R>, along: Twist<R>) -> Twist<R> {
        let u = square(at);
        let (first, second) = if u.real < R::ONE {
            (series(u, &COSINE_SERIES), series(u, &SINE_SERIES))
        } else {
            let angle = u.sqrt();
            ((Dual::ONE - angle.cos()) / u, (angle - angle.sin()) / (angle * u))
        };
        let once = lie_bracket(at, along);
        along + times(first, once) + times(second, lie_bracket(at, once))
    }

    /// The right Jacobian of SE(3) at the twist x = `at`, applied to y = `along`. It says how the
    /// motion exp(½x) changes on its *body* side if x changes by δy, with a small δ: exp(½(x +
    /// δy)) ≈ exp(½x) exp(½δ J_r(x) y). J_r(x) = J_l(−x), and J_l(x) = Ad_{exp ½x} J_r(x).
    #[inline]
    pub fn right_jacobian(at: Twist<R>, along: Twist<R>) -> Twist<R> {
        Self::left_jacobian(-at, along)
    }

    /// The inverse of the left Jacobian at the twist x = `at`, applied to y = `along`. It says how
    /// the twist x of a motion changes if the motion changes by the small *spatial* twist δy: 2
    /// log(exp(½δy) exp(½x)) ≈ x + δ J_l⁻¹(x) y (Barfoot 2017, §7.1.5; not in the sources
    /// of dq8).
    ///
    /// The domain is |ω| < 2π: the result is **infinite at |ω| = 2π** and at every multiple of
    /// it, and errors near 2π grow like 1/(2π − |ω|). A twist from
    /// [`to_twist`](Self::to_twist) has |ω| ≤ π.
    #[inline]
    pub fn left_jacobian_inverse(at: Twist<R>, along: Twist<R>) -> Twist<R> {
        let u = square(at);
        let second = if u.real < R::ONE {
            series(u, &COTANGENT_SERIES)
        } else {
            let half = u.sqrt() * Dual::new(R::HALF, R::ZERO);
            (Dual::ONE - half * half.cos() / half.sin()) / u
        };
        let once = lie_bracket(at, along);
        along - once.scale(R::HALF) + times(second, lie_bracket(at, once))
    }

    /// The inverse of the right Jacobian at the twist x = `at`, applied to y = `along`:
    /// J_r⁻¹(x) = J_l⁻¹(−x). It says how the twist x of a motion changes if the motion
    /// changes by the small *body* twist δy. The domain is that of
    /// [`left_jacobian_inverse`](Self::left_jacobian_inverse).
    #[inline]
    pub fn right_jacobian_inverse(at: Twist<R>, along: Twist<R>) -> Twist<R> {
        Self::left_jacobian_inverse(-at, along)
    }

    /// The left Jacobian as a 6×6 matrix [J, 0; Q, J], with rows and columns in the order
    /// `[ωx, ωy, ωz, vx, vy, vz]` (Barfoot 2017, eq. 7.85b, with the blocks in the opposite
    /// order).
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// let sliding = Twist { angular: [0.0_f32; 3], linear: [0.0, 0.0, 2.0] };
    /// let rows = DualQuat::left_jacobian_matrix(sliding);
    /// assert_eq!(rows[0], [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    /// assert_eq!(rows[3], [0.0, -1.0, 0.0, 1.0, 0.0, 0.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn left_jacobian_matrix(at: Twist<R>) -> [[R; 6]; 6] {
        matrix(at, Self::left_jacobian)
    }

    /// The inverse of the left Jacobian as a 6×6 matrix, with rows and columns in the order
    /// `[ωx, ωy, ωz, vx, vy, vz]`. The domain is that of
    /// [`left_jacobian_inverse`](Self::left_jacobian_inverse).
    #[inline]
    #[must_use]
    pub fn left_jacobian_inverse_matrix(at: Twist<R>) -> [[R; 6]; 6] {
        matrix(at, Self::left_jacobian_inverse)
    }
}

/// The coefficients (−1)ᵏ/(2k + 2)! of A = (1 − cos √u)/u as a power series of u. For u < 1
/// the first term left out is below 10⁻¹⁹.
const COSINE_SERIES: [f64; 9] = [
    1.0 / 2.0,
    -1.0 / 24.0,
    1.0 / 720.0,
    -1.0 / 40_320.0,
    1.0 / 3_628_800.0,
    -1.0 / 479_001_600.0,
    1.0 / 87_178_291_200.0,
    -1.0 / 20_922_789_888_000.0,
    1.0 / 6_402_373_705_728_000.0,
];

/// The coefficients (−1)ᵏ/(2k + 3)! of B = (√u − sin √u)/√u³ as a power series of u.
/// For u < 1 the first term left out is below 10⁻¹⁹.
const SINE_SERIES: [f64; 9] = [
    1.0 / 6.0,
    -1.0 / 120.0,
    1.0 / 5_040.0,
    -1.0 / 362_880.0,
    1.0 / 39_916_800.0,
    -1.0 / 6_227_020_800.0,
    1.0 / 1_307_674_368_000.0,
    -1.0 / 355_687_428_096_000.0,
    1.0 / 121_645_100_408_832_000.0,
];

/// The coefficients |B₂ₖ|/(2k)! of C = (1 − (√u/2) cot(√u/2))/u as a power series of u,
/// with Bernoulli's numbers B₂ₖ. For u < 1 the first term left out is below 10⁻¹⁸.
const COTANGENT_SERIES: [f64; 11] = [
    1.0 / 12.0,
    1.0 / 720.0,
    1.0 / 30_240.0,
    1.0 / 1_209_600.0,
    1.0 / 47_900_160.0,
    691.0 / 1_307_674_368_000.0,
    1.0 / 74_724_249_600.0,
    3_617.0 / 10_670_622_842_880_000.0,
    43_867.0 / 5_109_094_217_170_944_000.0,
    174_611.0 / 802_857_662_698_291_200_000.0,
    77_683.0 / 14_101_100_039_391_805_440_000.0,
];

/// Returns the power series Σ cₖuᵏ with the given `coefficients`. For small u the closed forms
/// would lose digits: the derivative of B, for example, is a small difference divided by u.
#[inline]
fn series<R: Real>(u: Dual<R>, coefficients: &[f64]) -> Dual<R> {
    coefficients.iter().rev().fold(Dual::ZERO, |sum, &coefficient| {
        sum * u + Dual::new(R::from_f64(coefficient), R::ZERO)
    })
}

/// Returns the dual number x·x.
#[inline]
fn square<R: Real>(x: Twist<R>) -> Dual<R> {
    Dual::new(vector::dot(x.angular, x.angular), R::TWO * vector::dot(x.angular, x.linear))
}

/// Returns x × y, the Lie bracket [x, y]: the rate of change of a twist y that the twist x carries
/// along (Lynch & Park, *Modern Robotics*, 2017, definition 8.4).
#[inline]
pub fn lie_bracket<R: Real>(x: Twist<R>, y: Twist<R>) -> Twist<R> {
    let linear =
        vector::add(vector::cross(x.angular, y.linear), vector::cross(x.linear, y.angular));
    Twist { angular: vector::cross(x.angular, y.angular), linear }
}

/// Returns the product (a + εb)(ω + εv) of a dual number and a twist.
#[inline]
fn times<R: Real>(factor: Dual<R>, twist: Twist<R>) -> Twist<R> {
    let linear = vector::add(
        vector::scale(twist.linear, factor.real),
        vector::scale(twist.angular, factor.dual),
    );
    Twist { angular: vector::scale(twist.angular, factor.real), linear }
}

/// Returns the matrix of the linear map y ↦ `map(at, y)`: its columns are the images of the unit
/// twists.
#[inline]
fn matrix<R: Real>(at: Twist<R>, map: fn(Twist<R>, Twist<R>) -> Twist<R>) -> [[R; 6]; 6] {
    let mut rows = [[R::ZERO; 6]; 6];
    for column in 0..6 {
        let mut unit = [R::ZERO; 6];
        unit[column] = R::ONE;
        let image = map(at, Twist::from_array(unit)).to_array();
        for (row, value) in rows.iter_mut().zip(image) {
            row[column] = value;
        }
    }
    rows
}
