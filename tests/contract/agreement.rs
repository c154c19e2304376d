//! How far two ways to the same number may lie apart: lanes and the scalar path, and the two sides of
//! a law. One line an operation or law, with its reason.
//!
//! Unit: the unit roundoff u of the type, 2⁻²⁴ for `f32` and 2⁻⁵³ for `f64`, times a [`Scale`]. The
//! errors of a single way against the truth are in [`tolerance`](crate::tolerance).

use crate::tolerance::unit_roundoff;

/// What the error of a number is measured against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The components of rotations and directions.
    Plain,
    /// The vector part of a rotation, or an angle: relative to itself, however small it is.
    Turn,
    /// What grows with the translation.
    Length,
    /// The moment of a screw axis, which a small angle sends to infinity.
    Moment,
}

/// The scale of each [`Kind`].
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    pub plain: f64,
    pub turn: f64,
    pub length: f64,
    pub moment: f64,
}

impl Scale {
    pub fn of(&self, kind: Kind) -> f64 {
        match kind {
            Kind::Plain => self.plain,
            Kind::Turn => self.turn,
            Kind::Length => self.length,
            Kind::Moment => self.moment,
        }
    }
}

/// The distance of two numbers in units of u · `scale`. Equal numbers and two NaN have none; NaN or
/// an infinity beside a number is infinitely far.
pub fn distance(left: f64, right: f64, scale: f64, single: bool) -> f64 {
    if left == right || left.is_nan() && right.is_nan() {
        return 0.0;
    }
    // Below the normal numbers the last place no longer shrinks.
    let smallest = if single { f64::from(f32::MIN_POSITIVE) } else { f64::MIN_POSITIVE };
    let distance = (left - right).abs() / scale.max(smallest) / unit_roundoff(single);
    if distance.is_nan() { f64::INFINITY } else { distance }
}

/// One line of a table.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    pub name: &'static str,
    /// The largest distance allowed, in units of u · scale.
    pub units: f64,
    pub reason: &'static str,
}

const fn line(name: &'static str, units: f64, reason: &'static str) -> Bound {
    Bound { name, units, reason }
}

/// Lanes against scalar. About 1.6 times the worst of 20 000 random cases of each kind, over all lane
/// types, built for SSE2 and for AVX2 with fused multiplication.
#[rustfmt::skip]
pub static LANES: &[Bound] = &[
    line("identity", 0.0, "constants"),
    line("from_rotation", 0.0, "copies"),
    line("from_translation", 0.0, "a product with one half is exact"),
    line("from_rotation_translation", 3.0, "fused products, and another order of summands"),
    line("from_translation_rotation", 3.0, "fused products, and another order of summands"),
    line("from_matrix3x4", 7.0, "the quaternion is multiplied by a reciprocal where scalar divides"),
    line("from_screw", 5.0, "sine and cosine are polynomials, where scalar asks the library"),
    line("rotation", 0.0, "copies"),
    line("translation", 11.0, "fused products, another order of summands, doubled"),
    line("to_matrix3x4", 11.0, "as translation; products are doubled at another step"),
    line("to_matrix4", 11.0, "as to_matrix3x4"),
    line("to_screw", 16.0, "the angle by a polynomial; slide and moment by a reciprocal length"),
    line("conjugate_dual", 0.0, "signs"),
    line("conjugate", 0.0, "signs"),
    line("conjugate_both", 0.0, "signs"),
    line("canonical", 0.0, "signs"),
    line("scale", 0.0, "one product"),
    line("scale_dual", 3.5, "a fused sum of two products"),
    line("dot", 5.5, "fused sums of four products"),
    line("norm", 8.0, "another sum of squares, and a reciprocal length"),
    line("normalize", 10.0, "a reciprocal length, where scalar divides; the part of q along p"),
    line("normalize_checked", 10.0, "as normalize"),
    line("is_unit", 0.0, "a truth value"),
    line("inverse", 28.0, "three products with a reciprocal length, where scalar divides, around qp*"),
    line("inverse_checked", 28.0, "as inverse"),
    line("abs_diff_eq", 0.0, "a truth value"),
    line("transform_point", 12.0, "rotation and translation in one sum, doubled at its end"),
    line("transform_vector", 11.0, "fused products, doubled at another step"),
    line("transform_line", 20.0, "two vectors and a product of a translation"),
    line("transform_plane", 18.0, "a vector and its product with a translation"),
    line("nlerp", 9.0, "a fused sum, then as normalize"),
    line("dlb", 10.0, "a fused sum, then as normalize"),
    line("log", 14.0, "a factor that is a polynomial in y, where scalar has axis and atan2"),
    line("exp", 6.0, "sine and cosine are polynomials, where scalar asks the library"),
    line("pow", 13.0, "as log, times t, as exp"),
    line("sqrt", 5.0, "no exponential in lanes: cos(Θ/2) and the vector part over 2 cos(Θ/2)"),
    line("sclerp", 7.0, "slerp about the middle in lanes, a(a*b)ᵗ in scalar"),
    line("sclerp_long", 9.0, "as sclerp; the scale already holds how near the antipode is"),
    line("add", 0.0, "one sum"),
    line("sub", 0.0, "one difference"),
    line("mul", 6.5, "fused products, another order of summands"),
    line("neg", 0.0, "signs"),
];

/// The line of a table for `name`.
///
/// # Panics
/// If there is none.
pub fn bound(table: &[Bound], name: &str) -> f64 {
    let line = table.iter().find(|bound| bound.name == name);
    line.unwrap_or_else(|| panic!("no line for {name} in the table")).units
}
