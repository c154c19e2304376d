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
