//! [`Bound`]: how large an error may be, and why; [`Scale`]: what it is measured against.
//!
//! Unit: the unit roundoff u of the type, 2⁻²⁴ for `f32` and 2⁻⁵³ for `f64`, times a
//! scale. One bound serves both types, the scalar reference and every lane type: the formulas are
//! the same, and fused or not is less than a factor of two. Bounds are about one and a half times
//! the worst that has been measured; where one is large, the reason says what it is made of.

use dq8::Real;

/// One line of a table.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// The kinds of input it is for; empty for all that no line above names.
    pub kinds: &'static [&'static str],
    /// The largest error allowed, in units of u · scale.
    pub units: f64,
    pub reason: &'static str,
}

/// A bound for the kinds of input named.
pub const fn on(kinds: &'static [&'static str], units: f64, reason: &'static str) -> Bound {
    Bound { kinds, units, reason }
}

/// A bound for all that no line above names.
pub const fn within(units: f64, reason: &'static str) -> Bound {
    on(&[], units, reason)
}

/// The bound for a kind of input.
pub fn find<'b>(bounds: &'b [Bound], kind: &str) -> Option<&'b Bound> {
    let named = bounds.iter().find(|bound| bound.kinds.contains(&kind));
    named.or_else(|| bounds.iter().find(|bound| bound.kinds.is_empty()))
}

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
    /// How often something was done, which is not compared.
    Count,
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
    /// For numbers among which no turn is tiny.
    pub const fn new(plain: f64, length: f64) -> Self {
        Self { plain, turn: plain, length, moment: length }
    }

    pub fn of(&self, kind: Kind) -> f64 {
        match kind {
            Kind::Plain => self.plain,
            Kind::Turn => self.turn,
            Kind::Length => self.length,
            Kind::Moment => self.moment,
            Kind::Count => f64::INFINITY,
        }
    }
}

/// The distance of two numbers in units of u · `scale`. Equal numbers and two NaN have none; NaN
/// or an infinity beside a number is infinitely far.
pub fn distance(left: f64, right: f64, scale: f64, single: bool) -> f64 {
    if left == right || left.is_nan() && right.is_nan() {
        return 0.0;
    }
    // Below the normal numbers the last place no longer shrinks.
    let smallest = if single { f64::from(f32::MIN_POSITIVE) } else { f64::MIN_POSITIVE };
    let distance = (left - right).abs() / scale.max(smallest) / unit_roundoff(single);
    if distance.is_nan() { f64::INFINITY } else { distance }
}

/// The unit roundoff: half the distance from 1 to the next number.
pub const fn unit_roundoff(single: bool) -> f64 {
    if single { f32::EPSILON as f64 / 2.0 } else { f64::EPSILON / 2.0 }
}

/// The largest number.
pub fn largest(single: bool) -> f64 {
    if single { f32::MAX.into() } else { f64::MAX }
}

/// The largest half angle that lanes know: 2¹⁶ and 2⁴⁵.
pub fn largest_half_angle(single: bool) -> f64 {
    2f64.powi(if single { 16 } else { 45 })
}

/// The unit roundoff of a number type.
pub fn roundoff<R: Real>() -> f64 {
    R::EPSILON.into() / 2.0
}

/// What `R` makes of numbers.
pub fn rounded<R: Real, const N: usize>(numbers: [f64; N]) -> [R; N] {
    numbers.map(R::from_f64)
}

/// Numbers as `f64`, exact.
pub fn exact<R: Real, const N: usize>(numbers: [R; N]) -> [f64; N] {
    numbers.map(Into::into)
}

/// How far two dual quaternions lie apart as motions, whatever their sign: the components of the
/// rotation as they are, the others in units of `length`. NaN is infinitely far.
pub fn apart(a: [f64; 8], b: [f64; 8], length: f64) -> f64 {
    let with_sign = |sign: f64| {
        let differences = a.iter().zip(b).map(|(a, b)| (a - sign * b).abs());
        let scaled = differences.enumerate().map(|(i, d)| if i < 4 { d } else { d / length });
        scaled.fold(0.0, |worst: f64, d| if d.is_nan() { f64::INFINITY } else { worst.max(d) })
    };
    with_sign(1.0).min(with_sign(-1.0))
}
