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

/// Lanes against scalar. About 1.6 times the worst of 150 000 random cases of each kind, built for
/// SSE2 and for AVX2 with fused multiplication.
#[rustfmt::skip]
pub static LANES: &[Bound] = &[
    line("identity", 0.0, "constants"),
    line("from_rotation", 0.0, "copies"),
    line("from_translation", 0.0, "a product with one half is exact"),
    line("from_rotation_translation", 3.0, "fused products, and another order of summands"),
    line("from_translation_rotation", 3.0, "fused products, and another order of summands"),
    line("mul_rotation_translation", 8.0, "as mul; (q + ½pt)r in lanes, q·r + p·(½tr) in scalar"),
    line("from_matrix3x4", 7.0, "a quaternion normalized, a product with the translation"),
    line("from_screw", 5.0, "sine and cosine are polynomials, where scalar asks the library"),
    line("rotation", 0.0, "copies"),
    line("translation", 11.0, "fused products, another order of summands, doubled"),
    line("to_matrix3x4", 11.0, "as translation; products are doubled at another step"),
    line("to_matrix4", 11.0, "as to_matrix3x4"),
    line("to_screw", 18.0, "the angle by a polynomial; slide and moment by a reciprocal length"),
    line("conjugate_dual", 0.0, "signs"),
    line("conjugate", 0.0, "signs"),
    line("conjugate_both", 0.0, "signs"),
    line("canonical", 0.0, "signs"),
    line("scale", 0.0, "one product"),
    line("scale_dual", 3.5, "a fused sum of two products"),
    line("dot", 5.5, "fused sums of four products"),
    line("norm", 9.0, "scalar sums the squares of ratios to the largest component"),
    line("normalize", 12.5, "another length; the part of q along p is a difference"),
    line("normalize_checked", 12.5, "as normalize"),
    line("is_unit", 0.0, "a truth value"),
    line("inverse", 32.0, "another length, which divides thrice around p*qp*"),
    line("inverse_checked", 32.0, "as inverse"),
    line("abs_diff_eq", 0.0, "a truth value"),
    line("transform_point", 13.0, "rotation and translation in one sum, doubled at its end"),
    line("transform_vector", 12.0, "fused products, doubled at another step"),
    line("transform_line", 23.0, "two vectors and a product of a translation"),
    line("transform_plane", 22.0, "a vector and its product with a translation"),
    line("nlerp", 12.5, "a fused sum, then as normalize"),
    line("dlb", 12.5, "a fused sum, then as normalize"),
    line("log", 14.0, "a factor that is a polynomial in y, where scalar has axis and atan2"),
    line("exp", 6.0, "sine and cosine are polynomials, where scalar asks the library"),
    line("pow", 17.0, "as log, times t, as exp"),
    line("sqrt", 5.5, "no exponential in lanes: cos(Θ/2) and the vector part over 2 cos(Θ/2)"),
    line("sclerp", 8.5, "slerp about the middle in lanes, a(a*b)ᵗ in scalar"),
    line("sclerp_long", 10.5, "as sclerp; the scale already holds how near the antipode is"),
    line("add", 0.0, "one sum"),
    line("sub", 0.0, "one difference"),
    line("mul", 8.0, "fused products, another order of summands"),
    line("neg", 0.0, "signs"),
];

/// The two sides of a law, from one implementation. About 1.6 times the worst of all implementations
/// in 60 000 random cases, built for SSE2 and for AVX2 with fused multiplication.
#[rustfmt::skip]
pub static LAWS: &[Bound] = &[
    line("(ab)c = a(bc)", 11.0, "two products a side, summed in another order"),
    line("a1 = 1a = a", 0.0, "products with one and zero are exact"),
    line("a(b + c) = ab + ac", 12.0, "one product of a sum against a sum of products"),
    line("(ab)• = a•b•", 0.0, "every rounding is symmetric in the sign of q"),
    line("(ab)* = b*a*, (ab)⋄ = b⋄a⋄", 8.0, "one product a side, summed in another order"),
    line("σ⋄ = (σ*)•", 0.0, "signs"),
    line("σσ* = σ*σ = norm²", 14.0, "a product against the square of a root"),
    line("norm(ab) = norm(a) norm(b)", 10.0, "three norms and a product"),
    line("|p| = 1, p·q = 0", 10.0, "one normalization; p·q is the difference that is left"),
    line("normalize(cσ) = normalize(σ)", 12.0, "two normalizations and the product with c"),
    line("σσ⁻¹ = σ⁻¹σ = 1", 15.0, "an inverse and a product"),
    line("σ⁻¹ = σ*", 22.0, "|p| is only unit to 2 u, and its square divides q"),
    line("r + ½εtr = σ", 11.0, "a translation and the product with the rotation"),
    line("from_matrix(to_matrix(σ)) = ±σ", 13.0, "nine products of p, and the largest sum of them divides the others"),
    line("(ab)v = a(bv)", 29.0, "an error of p counts twice on each side of v, four times here"),
    line("σ(1 + εv)σ⋄, σ(l + εm)σ*", 17.0, "two products against one rotation and a translation"),
    line("[R | t](v, 1) = σv", 4.0, "the same products, summed in another order"),
    line("|σu − σv| = |u − v|", 12.0, "|p| is only unit to 2 u, which scales all distances"),
    line("x × l = m, n·x = d", 30.0, "a moved point against a moved line and plane, a product of both"),
    line("exp(log σ) = ±σ", 15.0, "a factor and its reciprocal, each from its own function"),
    line("from_screw(to_screw(σ)) = ±σ", 15.0, "axis, angle, moment and slide, each rounded, and products of them"),
    line("σˢσᵗ = σˢ⁺ᵗ", 6.0, "three powers and a product; the scale grows with the exponents"),
    line("σ¹ = ±σ, σ⁰ = 1", 15.0, "as exp(log σ)"),
    line("(√σ)² = ±σ", 15.0, "a root and a product, or two ways to half a screw"),
    line("sclerp(a, b, 0) = a, sclerp(a, b, 1) = ±b", 20.0, "at 1 the scalar way is a(a*b), which has |a|² in it"),
    line("sclerp(ca, cb, t) = c sclerp(a, b, t)", 11.0, "two interpolations and three products; the scale grows with t"),
    line("sclerp(a, b, t) = a(a*b)ᵗ", 7.0, "two products and a power against slerp about the middle, in lanes"),
    line("sclerp(a, b, t) = sclerp(a, −b, t)", 0.0, "the sign is fixed before the first rounding"),
];

/// Lanes against scalar, for what is not in the contract. About 1.6 times the worst of 60 000 random
/// cases, in units of u · max(1, |the number|).
#[rustfmt::skip]
pub static INHERENT: &[Bound] = &[
    line("Quat::from_parts", 0.0, "copies"),
    line("Quat::from_xyzw", 0.0, "copies"),
    line("Quat::from_axis_angle", 6.0, "sine and cosine are polynomials, where scalar asks the library"),
    line("Quat::conjugate", 0.0, "signs"),
    line("Quat::dot", 4.0, "a fused sum of four products"),
    line("Quat::norm", 7.0, "scalar sums the squares of ratios to the largest component"),
    line("Quat::normalize", 7.0, "another length"),
    line("Quat::scale", 0.0, "one product"),
    line("Quat::rotate", 20.0, "fused products, doubled at another step; |v| is up to 3.5"),
    line("Quat::to_matrix3", 4.0, "fused products, doubled at another step"),
    line("Quat::from_matrix3", 22.0, "another length divides; as a matrix again, to_matrix3 of two quaternions"),
    line("Quat::add", 0.0, "one sum"),
    line("Quat::sub", 0.0, "one difference"),
    line("Quat::mul", 5.0, "fused products, another order of summands"),
    line("Quat::neg", 0.0, "signs"),
    line("Dual::add", 0.0, "one sum"),
    line("Dual::sub", 0.0, "one difference"),
    line("Dual::mul", 3.5, "a fused sum of two products"),
    line("Dual::div", 27.0, "a fused difference that may cancel, divided by no less than 1/16"),
    line("Dual::neg", 0.0, "signs"),
    line("Dual::sqrt", 0.0, "the same quotient of the same root"),
    line("Dual::apply", 0.0, "one product"),
    line("Dual::inverse", 7.0, "the square of a reciprocal, where scalar divides twice"),
];

/// The line of a table for `name`.
///
/// # Panics
/// If there is none.
pub fn bound(table: &[Bound], name: &str) -> f64 {
    let line = table.iter().find(|bound| bound.name == name);
    line.unwrap_or_else(|| panic!("no line for {name} in the table")).units
}
