//! Lines, planes and points together: which pass through which, and how far apart they are.
//!
//! Directions and normals may have any length but zero; what is returned has length 1. Numbers may
//! be of any size as long as the answer is finite: no square of a coordinate is taken.
//!
//! Two directions whose sine is at most eight units of roundoff are parallel, and so are treated:
//! the rounding of unit vectors alone makes such a sine, and an answer divided by it would be
//! noise.

mod crossing;
mod error;
mod line;
mod perpendicular;
mod plane;

pub use error::IncidenceError;
pub use perpendicular::CommonPerpendicular;

use crate::number::Real;
use crate::scalar::vector::{self, Length};

/// Eight units of roundoff: two of each direction, doubled.
fn parallel_sine<R: Real>() -> R {
    R::EPSILON * R::from(4.0)
}

/// The vector with length 1, and the length that it had.
fn unit<R: Real>(
    vector: [R; 3],
    what: &'static str,
) -> Result<([R; 3], Length<R>), IncidenceError> {
    let norm = vector::norm(vector);
    if norm > R::ZERO && vector.iter().all(|c| c.is_finite()) {
        let length = Length::of(vector, norm);
        Ok((length.divide(vector), length))
    } else {
        Err(IncidenceError::NoDirection { what, length: norm.into() })
    }
}

/// The numbers, if all are finite.
fn finite<R: Real, const N: usize>(
    numbers: [R; N],
    what: &'static str,
) -> Result<[R; N], IncidenceError> {
    match numbers.iter().find(|c| !c.is_finite()) {
        Some(&value) => Err(IncidenceError::NotFinite { what, value: value.into() }),
        None => Ok(numbers),
    }
}

/// The larger of two lengths: what the rounding of a distance is relative to.
fn size<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    vector::norm(a).max_or_nan(vector::norm(b))
}
