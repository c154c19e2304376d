//! The motion of a constant twist in closed form, on lanes: `exp(τξ)·p` without an axis, a
//! division or a branch.
//!
//! With ξ = (ω, v), φ = τ|ω| and the velocity of the point u = ω×p + v,
//!
//! ```text
//! exp(τξ)·p = p + Sτ u + Cτ² ω×u + Dτ³ (ω·v) ω
//! S = sin φ / φ,   C = (1 − cos φ) / φ²,   D = (φ − sin φ) / φ³
//! ```
//!
//! It is Rodrigues' formula for the rotation, with the integral of the translation (Selig 2005,
//! *Geometric Fundamentals of Robotics*, §4.3), sorted by p: the terms in ω×(ω×p) and ω×v
//! are ω×u. S, C and D are power series in φ², so that nothing cancels where φ vanishes.

use dq8::Lanes;
use dq8::batch::{cos_sin, vector};
use dq8::simd::{Float, Mask};

/// The longest turn within a segment, in radians. Longer segments are cut into parts, so the series
/// are short.
pub(crate) const LONGEST: f64 = 0.5;

/// So many parts that none turns by more than the longest turn; one where the turn is not finite,
/// as from a pose that is NaN.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "saturates; the turn is not negative"
)]
pub(crate) fn parts(turn: f64) -> usize {
    if turn.is_finite() { (turn / LONGEST) as usize + 1 } else { 1 }
}

/// A twist for one second, and what depends on it alone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Screw<L> {
    angular: [L; 3],
    linear: [L; 3],
    /// |ω|²
    square: L,
    /// ω·v
    pitch: L,
}

impl<L: Lanes> Screw<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn new([a, b, c, x, y, z]: [L; 6]) -> Self {
        let (angular, linear) = ([a, b, c], [x, y, z]);
        let (square, pitch) = (vector::dot(angular, angular), vector::dot(angular, linear));
        Self { angular, linear, square, pitch }
    }

    /// Where the point is after a time in seconds.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn moved(self, time: L, point: [L; 3]) -> [L; 3] {
        let velocity = vector::cross_onto(self.angular, point, self.linear);
        let turned = vector::cross(self.angular, velocity);
        let square = time * time;
        let [s, c, d] = integrals(square * self.square);
        let moved = vector::scale_onto(velocity, s * time, point);
        let moved = vector::scale_onto(turned, c * square, moved);
        vector::scale_onto(self.angular, d * square * (time * self.pitch), moved)
    }
}

/// S, C and D of φ². Lanes beyond the longest turn, which are met only where a motion goes on
/// outside its stamps, take sine and cosine; each lane decides for itself, so its bits do not
/// depend on the others.
#[cfg_attr(not(opt_level_0), inline(always))]
fn integrals<L: Lanes>(square: L) -> [L; 3] {
    let near = series(square);
    // A little more: the first and the last of the time of a part may round to beyond it.
    let is_near = square.le(square.constant(1.01 * LONGEST * LONGEST));
    if is_near.all() {
        return near;
    }
    let one = square.constant(1.0);
    // Where the series serve, any angle will do.
    let square = L::select(is_near, one, square);
    let angle = square.sqrt();
    let (cos, sin) = cos_sin(angle);
    // 1 − cos φ = sin² φ / (1 + cos φ) cancels near π, this near 0, which is not met.
    let far = [sin / angle, (one - cos) / square, (angle - sin) / (square * angle)];
    vector::select(is_near, near, far)
}

/// Taylor's series, as far as the roundoff of the lanes' numbers at the longest turn.
#[cfg_attr(not(opt_level_0), inline(always))]
fn series<L: Lanes>(square: L) -> [L; 3] {
    if <L::Real as Float>::SINGLE {
        [
            horner(square, [1.0, -1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0]),
            horner(square, [0.5, -1.0 / 24.0, 1.0 / 720.0, -1.0 / 40320.0]),
            horner(square, [1.0 / 6.0, -1.0 / 120.0, 1.0 / 5040.0]),
        ]
    } else {
        [
            horner(square, alternating::<7>(1.0)),
            horner(square, alternating::<7>(2.0)),
            horner(square, alternating::<7>(3.0)),
        ]
    }
}

/// (−1)ⁿ / (2n + first)!, n = 0, 1, …
const fn alternating<const N: usize>(first: f64) -> [f64; N] {
    let mut coefficients = [0.0; N];
    // 1/1!, 1/2! and 1/3!
    let (mut next, mut factor) = (if first == 3.0 { 1.0 / 6.0 } else { 1.0 / first }, first);
    let mut n = 0;
    while n < N {
        coefficients[n] = next;
        next /= -(factor + 1.0) * (factor + 2.0);
        factor += 2.0;
        n += 1;
    }
    coefficients
}

/// c₀ + c₁x + …
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn horner<L: Lanes, const N: usize>(x: L, coefficients: [f64; N]) -> L {
    let mut sum = x.constant(coefficients[N - 1]);
    let mut n = N - 1;
    while n > 0 {
        n -= 1;
        sum = sum.mul_add(x, x.constant(coefficients[n]));
    }
    sum
}
