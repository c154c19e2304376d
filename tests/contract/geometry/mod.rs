//! The tables of what is no operation of motions: lines, planes, quaternions and other forms of
//! rotations, maps, dual numbers. They are held to answers of 60 digits (`vectors/geometry.jsonl`)
//! and to nothing else here.
//!
//! ```text
//! "name in the file"(field: its shape, …) -> shape of the answer, scales of errors, [bounds],
//!     how scalar, lanes;
//! ```
//!
//! `how` says whether there may be no answer: `tried` has an error in the scalar reference and a
//! mask on lanes, `plain` has neither; `alone` may have an error, and is not on lanes. Where both
//! sides have the same text there is one. The numbers of a quaternion begin with w, in fields and
//! in answers, and those of unit shapes are normalized first.

#[macro_use]
mod entry;
mod duals;
mod lines;
mod maps;
mod matrices;
mod quaternions;
mod rotations;
mod scale;
mod screws;

use crate::bound::Bound;
use crate::implementation::On;
use crate::lanes::{MAX_LANES, Row};
use crate::sample::{Proof, Sample};
use crate::vectors::Vector;
use dq8::{DualQuat, Lanes, Real, batch};

/// An operation of one implementation: a row for each number in, and for each number of the answer
/// out; none where the scalar reference has an error.
pub type Call = fn(&[Row]) -> Vec<Row>;

/// One operation of a table.
#[derive(Debug)]
pub struct Operation {
    pub name: &'static str,
    /// Fields with their shapes.
    fields: &'static [(&'static str, &'static str)],
    /// What the error of each number of the answer is measured against.
    scales: fn(&Vector) -> Vec<f64>,
    pub(crate) bounds: &'static [Bound],
}

/// A place in the tables.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    table: usize,
    index: usize,
}

/// The operations of an implementation, table by table.
pub trait Geometry: Sample {
    const GEOMETRY: &'static [&'static [Option<Call>]];
}

/// All tables, for both sides in one order.
macro_rules! tables {
    ($($table:ident)*) => {
        const TABLES: &[&[Operation]] = &[$($table::OPERATIONS),*];

        impl<R: Real> Geometry for DualQuat<R> {
            const GEOMETRY: &'static [&'static [Option<Call>]] = &[$($table::Scalar::<R>::CALLS),*];
        }

        impl<L: Lanes<Level: Proof>> Geometry for batch::DualQuat<L> {
            const GEOMETRY: &'static [&'static [Option<Call>]] = &[$($table::OnLanes::<L>::CALLS),*];
        }
    };
}

tables! { lines rotations matrices maps quaternions duals screws }

/// Every operation and its place.
pub fn operations() -> impl Iterator<Item = (Place, &'static Operation)> {
    TABLES.iter().enumerate().flat_map(|(table, operations)| {
        let each = operations.iter().enumerate();
        each.map(move |(index, operation)| (Place { table, index }, operation))
    })
}

impl Place {
    fn operation(self) -> &'static Operation {
        &TABLES[self.table][self.index]
    }

    pub fn name(self) -> &'static str {
        self.operation().name
    }

    /// The shape that each number is part of.
    pub fn shapes(self) -> impl Iterator<Item = &'static str> {
        let fields = self.operation().fields.iter();
        fields.flat_map(|&(_, shape)| std::iter::repeat_n(shape, entry::length(shape)))
    }

    /// Fields with their lengths.
    pub(crate) fn fields(self) -> impl Iterator<Item = (&'static str, usize)> {
        self.operation().fields.iter().map(|&(field, shape)| (field, entry::length(shape)))
    }

    /// The answers of `on` to vectors of this operation, at most as many as it has lanes; NaN where
    /// there is none.
    pub(crate) fn answers(self, on: On, vectors: &[&Vector]) -> Vec<Vec<f64>> {
        let given = |vector: &&Vector| {
            self.fields()
                .flat_map(|(field, length)| vector.input(field)[..length].to_vec())
                .collect()
        };
        let given: Vec<Vec<f64>> = vectors.iter().map(given).collect();
        let answers = self.answers_given(on, &given).into_iter().zip(vectors);
        let none = |(answer, vector): (Vec<f64>, &&Vector)| match answer.len() {
            0 => vec![f64::NAN; vector.out.len()],
            _ => answer,
        };
        answers.map(none).collect()
    }

    /// Whether `on` has the operation.
    pub fn is_on(self, on: On) -> bool {
        on.geometry[self.table][self.index].is_some()
    }

    /// The answers to numbers, those of all fields for each lane, for at most as many lanes as `on`
    /// has; lanes beyond repeat the first. Empty where the scalar reference has an error.
    pub fn answers_given(self, on: On, given: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let row = |number: usize| {
            let mut row = [0.0; MAX_LANES];
            for (lane, slot) in row.iter_mut().enumerate().take(on.lanes) {
                *slot = on.round(given.get(lane).unwrap_or(&given[0])[number]);
            }
            row
        };
        let rows: Vec<Row> = (0..given[0].len()).map(row).collect();
        let call =
            on.geometry[self.table][self.index].expect("an operation that this implementation has");
        let rows = call(&rows);
        (0..given.len()).map(|lane| rows.iter().map(|row| row[lane]).collect()).collect()
    }

    /// The largest error of `answer`, each number relative to its own scale. NaN counts as
    /// infinite.
    pub(crate) fn error(self, vector: &Vector, answer: &[f64]) -> f64 {
        let scales = (self.operation().scales)(vector);
        assert_eq!(scales.len(), vector.out.len(), "{}: a scale for each number", vector.op);
        let errors = answer.iter().zip(&vector.out).zip(scales).map(|((a, b), scale)| {
            // No error would be seen beside a scale that is infinite.
            let scale = if scale.is_finite() { scale } else { 0.0 };
            if a == b { 0.0 } else { (a - b).abs() / scale.max(f32::MIN_POSITIVE.into()) }
        });
        errors
            .fold(0.0, |worst, error| if error.is_nan() { f64::INFINITY } else { worst.max(error) })
    }
}
