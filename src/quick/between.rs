//! Interpolation on a screw, as an angle from the middle of the way as in `batch/screw.rs`. A
//! register holds one quaternion, and the lanes of one register evaluate several polynomials.

use super::quad::{dots, halves, join, load, sum, sums, turn_toward};
use super::{Four, Number};
use crate::batch::even_coefficients as coefficients;
use dq8_simd::Lanes;

/// Returns cos(τΘ/2)/cos(Θ/2) m + sin(τΘ/2)/sin(Θ/2) h, with τ = 2t − 1, m = (a ± b)/2
/// and h = (±b − a)/2, where Θ is the dual angle between the dual quaternions a and ±b.
/// Returns `None` for t outside [−½, 3/2].
#[inline]
pub(super) fn sclerp<F: Number>(a: [F; 8], b: [F; 8], t: F) -> Option<[F; 8]> {
    let ([p, q], [r, s]) = (halves(a), halves(b));
    let turn = turn_toward(p, r);
    let (r, s) = (r ^ turn, s ^ turn);
    let (ahead, ahead_dual) = (p + r, q + s);
    let (back, back_dual) = (p - r, q - s);
    let [chord, across, ..] = dots(back, back, back_dual).to_array();
    let weights = Weights::of(chord, across, t)?;
    let (middle, along) = (load([weights.middle; 4]), load([weights.along; 4]));
    let (middle_dual, along_dual) = (load([weights.middle_dual; 4]), load([weights.along_dual; 4]));
    let ahead_dual = ahead_dual * middle + ahead * middle_dual;
    let back_dual = back_dual * along + back * along_dual;
    Some(join(ahead * middle + back * along, ahead_dual + back_dual))
}

/// Interpolates between two rotations along the shorter arc, as [`sclerp`] does between motions.
#[inline]
pub(super) fn slerp<F: Number>(a: [F; 4], b: [F; 4], t: F) -> Option<[F; 4]> {
    let (a, b): (F::Four, F::Four) = (load(a), load(b));
    let b = b ^ turn_toward(a, b);
    let (ahead, back) = (a + b, a - b);
    let weights = Weights::of(sum(back * back), F::default(), t)?;
    Some((ahead * load([weights.middle; 4]) + back * load([weights.along; 4])).to_array())
}

/// The weights of [`sclerp`]: the dual numbers that multiply the sum a ± b (`middle`) and the
/// difference a ∓ b (`along`).
struct Weights<F> {
    middle: F,
    middle_dual: F,
    along: F,
    along_dual: F,
}

impl<F: Number> Weights<F> {
    /// Returns the weights cos √v/√(4 − C) and w sin(√v)/√v, with w = (½ − t)K(C) and
    /// v = Cw² = (τΘ/2)². C is the squared chord of Θ, the dual number `chord` + 2ε`across`,
    /// and K is the ratio of the arc to the chord. The two polynomials, one after the other, take
    /// most of the time, so their inputs are computed first, and everything independent of them is
    /// computed while they wait.
    #[inline(always)]
    fn of(chord: F, across: F, t: F) -> Option<Self> {
        let (half, one) = (t.constant(0.5), t.constant(1.0));
        let back = half - t;
        let squared = back * back;
        let chord_back = chord * squared;
        let [arc, slope, ..] = long_polynomials::<F::Four>(F::ARC, chord).to_array();
        let v = chord_back * (arc * arc);
        // Beyond |τ| = 2 the textbook form is used, because v may exceed (π/2)², up to which the
        // polynomials are accurate. For ends closer than half a turn v stays smaller, but an error
        // of their norms would be multiplied by |τ|. The comparison is here because no other
        // instruction waits for it.
        if !squared.le(one) {
            return None;
        }
        let secant = one / Lanes::sqrt(one.constant(4.0) - chord);
        let (w, w_slope) = (back * arc, back * slope);
        let v_slope = w * (w + chord * (w_slope + w_slope));
        let (secant_dual, w_dual) = (across * secant, (across + across) * w_slope);
        let (falling, rising) = (secant_dual * (secant * secant), secant_dual * v_slope);
        let bending = (across + across) * (w * v_slope);
        let [cos, sinc, sinc_slope, _] = horner::<F::Four>(F::WAVES, load([v; 4])).to_array();
        Some(Self {
            middle: cos * secant,
            middle_dual: cos * falling - sinc * rising,
            along: w * sinc,
            along_dual: w_dual * sinc + bending * sinc_slope,
        })
    }
}

/// Evaluates two polynomials with a row of coefficients for each power of x⁴. Fewer steps have to
/// wait for each other than in Horner's scheme, but the number of steps is larger. This is faster
/// for polynomials with many terms.
#[inline(always)]
fn long_polynomials<V: Four>([a, b]: [&[[V::Number; 4]]; 2], x: V::Number) -> V {
    let square = x * x;
    let powers: V = load([x.constant(1.0), x, square, square * x]);
    let fourth: V = load([square * square; 4]);
    sums(horner(a, fourth) * powers, horner(b, fourth) * powers)
}

/// Evaluates a polynomial in each lane by Horner's scheme, with the lowest coefficients in the
/// first row.
#[inline(always)]
fn horner<V: Four>(rows: &[[V::Number; 4]], x: V) -> V {
    let last = rows.len() - 1;
    let mut sum = load(rows[last]);
    for power in (0..last).rev() {
        sum = sum * x + load(rows[power]);
    }
    sum
}

/// The coefficients of `batch/even_coefficients.rs`, arranged so that the lanes of one register
/// evaluate several polynomials.
pub trait Even: Sized + 'static {
    /// The coefficients of arcsin(√c/2)/(√c/2) and of its derivative by c, those of four powers
    /// in each row.
    const ARC: [&'static [[Self; 4]]; 2];
    /// The coefficients of cos √v, of sin(√v)/√v and of the derivative of sin(√v)/√v by
    /// v, those of one power in each row.
    const WAVES: &'static [[Self; 4]];
}

/// The implementations for `f32` and `f64` differ in names only, but arithmetic on constants cannot
/// be generic.
macro_rules! even {
    ($real:ty, $arc:ident, $cos:ident, $sinc:ident) => {
        const _: () = {
            const fn slope<const N: usize>(of: [$real; N]) -> [$real; N] {
                let mut slope = [0.0; N];
                let mut power = 1;
                while power < N {
                    slope[power - 1] = power as $real * of[power];
                    power += 1;
                }
                slope
            }
            /// Returns rows with the coefficients of `first`, of `second` and of the derivative of
            /// `second`.
            const fn beside<const N: usize>(
                first: [$real; N],
                second: [$real; N],
            ) -> [[$real; 4]; N] {
                let (third, mut rows) = (slope(second), [[0.0; 4]; N]);
                let mut power = 0;
                while power < N {
                    rows[power] = [first[power], second[power], third[power], 0.0];
                    power += 1;
                }
                rows
            }
            const QUARTER: usize = coefficients::$arc.len().div_ceil(4);
            /// Arranges coefficients in rows of four powers each, with zeros after the last
            /// coefficient.
            const fn by_fours<const N: usize>(of: [$real; N]) -> [[$real; 4]; QUARTER] {
                let mut rows = [[0.0; 4]; QUARTER];
                let mut power = 0;
                while power < N {
                    rows[power / 4][power % 4] = of[power];
                    power += 1;
                }
                rows
            }
            impl Even for $real {
                const ARC: [&'static [[Self; 4]]; 2] =
                    [&by_fours(coefficients::$arc), &by_fours(slope(coefficients::$arc))];
                const WAVES: &'static [[Self; 4]] =
                    &beside(coefficients::$cos, coefficients::$sinc);
            }
        };
    };
}
even!(f32, ARC_F32, COS_F32, SINC_F32);
even!(f64, ARC_F64, COS_F64, SINC_F64);
