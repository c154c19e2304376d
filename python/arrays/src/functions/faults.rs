//! [`Fault`], a mistake in elements that people have typed, and the search for the first element
//! that has it.

use crate::argument::{Argument, Input};
use crate::law::load;
use crate::number::Number;
use crate::shape::tuple;
use crate::threads::{GRAIN, Threads};
use dq8::simd::Mask;
use dq8::{Backend, Kernel, Lanes, Level, Real};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The largest difference of lengths, and of products of rows, from those of a rotation. Numbers
/// that were typed with four digits are nearer.
pub(super) const TOLERANCE: f64 = 1e-3;

/// A fault of an element of `C` numbers, which makes it no motion. NaN is no fault: it stays in its
/// row.
pub(super) trait Fault<const C: usize>: Copy + Send + Sync {
    /// Returns the lanes whose elements have this fault.
    fn is_in<L: Lanes>(self, element: [L; C]) -> L::Mask;
    /// Returns the text of the error for an element that has this fault.
    fn reason<R: Number>(self, element: [R; C]) -> String;
}

/// An error about the first element of an argument that has a fault.
pub(super) fn refuse<R: Number, F: Fault<C>, const C: usize>(
    argument: &Argument<'_>,
    fault: F,
) -> PyResult<()> {
    let elements = Input::<R>::of(argument)?;
    let (records, first) = (elements.records::<C>(), AtomicUsize::new(usize::MAX));
    let threads = Threads::for_elements(records.len());
    threads.run(elements.py(), || {
        threads.each(records.chunks(GRAIN).enumerate(), &|(piece, records)| {
            if let Some(index) = Backend::best().run(First { records, fault }) {
                first.fetch_min(piece * GRAIN + index, Ordering::Relaxed);
            }
            true
        });
        Ok(())
    })?;
    let first = first.into_inner();
    let Some(&element) = records.get(first) else { return Ok(()) };
    let mut rest = first;
    let mut index: Vec<_> = elements
        .leading()
        .iter()
        .rev()
        .map(|&size| {
            let at = rest % size;
            rest /= size;
            at
        })
        .collect();
    index.reverse();
    let name = argument.name();
    let which = if index.is_empty() { String::new() } else { format!(" {}", tuple(&index)) };
    Err(PyValueError::new_err(format!("`{name}`{which}: {}.", fault.reason(element))))
}

/// The first of some elements that has a fault.
struct First<'s, R, F, const C: usize> {
    records: &'s [[R; C]],
    fault: F,
}

impl<R: Number, F: Fault<C>, const C: usize> Kernel for First<'_, R, F, C> {
    type Output = Option<usize>;
    const WIDE: bool = false;

    #[inline(always)]
    fn run<V: Level>(self, level: V) -> Option<usize> {
        let mut first = 0;
        while let Some(rest) = self.records.get(first..).filter(|rest| !rest.is_empty()) {
            let faulty = self.fault.is_in::<R::Lanes<V>>(load(level, rest)?);
            // Lanes without an element are not looked at.
            let lane = faulty.to_bitmask().trailing_zeros() as usize;
            if lane < rest.len().min(R::Lanes::<V>::LANES) {
                return Some(first + lane);
            }
            first += R::Lanes::<V>::LANES;
        }
        None
    }
}

/// A rotation whose length is not 1.
#[derive(Clone, Copy)]
pub(super) struct NotUnit;

impl Fault<4> for NotUnit {
    #[inline(always)]
    fn is_in<L: Lanes>(self, [x, y, z, w]: [L; 4]) -> L::Mask {
        is_off(x * x + y * y + z * z + w * w)
    }
    fn reason<R: Number>(self, element: [R; 4]) -> String {
        let length = length(&element);
        format!(
            "the length of {element:?} is {length}, which must be 1: divide by it, or pass `check=False` to take them as they are"
        )
    }
}

/// An axis whose direction has another length than 1, or a moment that is not at right angles to
/// it.
#[derive(Clone, Copy)]
pub(super) struct NoAxis;

impl Fault<8> for NoAxis {
    #[inline(always)]
    fn is_in<L: Lanes>(self, [a, b, c, d, e, f, ..]: [L; 8]) -> L::Mask {
        let (along, moment) = (a * d + b * e + c * f, d * d + e * e + f * f);
        let most = a.constant(TOLERANCE * TOLERANCE);
        let skew = (most + most * moment).lt(along * along);
        is_off(a * a + b * b + c * c) | skew | moment.eq(a.constant(f64::INFINITY))
    }
    fn reason<R: Number>(self, [a, b, c, d, e, f, ..]: [R; 8]) -> String {
        if length(&[d, e, f]).is_infinite() {
            return format!("the moment of the axis, {:?}, is too large or infinite", [d, e, f]);
        }
        let length = length(&[a, b, c]);
        if (length - 1.0).abs() > TOLERANCE {
            return format!(
                "the length of the direction {:?} is {length}, which must be 1: divide by it, or pass `check=False`",
                [a, b, c]
            );
        }
        "the moment of the axis is not at right angles to its direction: it is point × direction"
            .to_owned()
    }
}

/// Returns the lanes in which the square of a length is not 1.
#[inline(always)]
fn is_off<L: Lanes>(square: L) -> L::Mask {
    square.constant(2.0 * TOLERANCE).lt((square - square.constant(1.0)).abs())
}

fn length<R: Number>(numbers: &[R]) -> f64 {
    let squares = numbers.iter().map(|&number| number.into() * number.into());
    <f64 as Real>::sqrt(squares.sum::<f64>())
}
