//! The errors allowed: one line for each operation and kind of input, with its reason.
//!
//! Unit: the unit roundoff u of the type, 2⁻²⁴ for `f32` and 2⁻⁵³ for `f64`, times the scale of the
//! vector ([`operation::scale`](crate::operation::scale), max(1, |t|) for unit motions). One bound
//! serves both types, the scalar reference and every lane type: the formulas are the same, and fused
//! or not is less than a factor of two. Bounds are about one and a half times the worst that has been
//! measured; where one is large, the reason says what it is made of.

/// One line of the table.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    pub op: &'static str,
    /// The kinds of input it is for; empty for all that no line above names.
    pub kinds: &'static [&'static str],
    /// The largest error allowed, in units of u · scale.
    pub units: f64,
    pub reason: &'static str,
}

const fn line(
    op: &'static str,
    kinds: &'static [&'static str],
    units: f64,
    reason: &'static str,
) -> Bound {
    Bound { op, kinds, units, reason }
}

/// Small or no rotation: what peers lose.
const SMALL: &[&str] = &["near0", "close", "translation"];

/// The table.
#[rustfmt::skip]
pub static BOUNDS: &[Bound] = &[
    line("conj_dual", &[], 0.0, "signs only"),
    line("conj_quat", &[], 0.0, "signs only"),
    line("conj_both", &[], 0.0, "signs only"),
    line("mul", &[], 2.5, "sums of 4 and 8 products"),
    line("norm", &[], 2.0, "a sum of squares, half of whose error the root takes away"),
    line("normalize", &[], 3.5, "norm, reciprocal, product, and the part of q along p"),
    line("inverse", &[], 5.0, "two divisions by the norm, two quaternion products"),
    line("from_rotation_translation", &[], 4.0, "the rotation is normalised first"),
    line("translation", &[], 8.0, "normalised first; then sums of 4 products of q and p, doubled"),
    line("vector", &[], 12.0, "normalised first; an error of p counts twice on each side of v"),
    line("matrix", &[], 13.0, "normalised first; squares of p, doubled, and the translation"),
    line("point", &[], 14.0, "a vector and a translation"),
    line("line", &[], 11.0, "three vectors and a product of a translation, over 1 + |l|"),
    line("log", SMALL, 4.0, "no cancellation: the vector part keeps its relative precision"),
    line("log", &[], 6.0, "normalised first; then one factor that varies slowly"),
    line("exp", &[], 2.5, "even functions of the square, one product"),
    line("pow", SMALL, 4.0, "no cancellation: the vector part keeps its relative precision"),
    line("pow", &[], 6.0, "normalised first; log, times t, exp"),
    line("sclerp", SMALL, 5.0, "both ends normalised; slerp about their middle"),
    line("sclerp", &[], 8.0, "both ends normalised; the scalar reference has two more products"),
    line("screw", &[], 17.0, "normalised first; the angle is up to π, so 1 ulp of it is 4 u"),
    line("dlb", &[], 4.0, "up to 4 poses normalised, summed, normalised"),
];

/// The line for an operation and a kind of input.
pub fn bound(op: &str, kind: &str) -> Option<&'static Bound> {
    let of_op = || BOUNDS.iter().filter(|bound| bound.op == op);
    of_op()
        .find(|bound| bound.kinds.contains(&kind))
        .or_else(|| of_op().find(|bound| bound.kinds.is_empty()))
}

/// The unit roundoff: half the distance from 1 to the next number.
pub const fn unit_roundoff(single: bool) -> f64 {
    if single { f32::EPSILON as f64 / 2.0 } else { f64::EPSILON / 2.0 }
}
