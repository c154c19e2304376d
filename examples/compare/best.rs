//! [`Best`]: the best of each kind in one contest, as documents and the chart show it.

use crate::results::{Results, Row};
use dq8::Backend;
use std::fmt;

/// A heading, and which rows are meant.
type Kind = (&'static str, fn(&Row) -> bool);

pub(crate) const KINDS: [Kind; 5] = [
    ("dq8 blocks", |row| row.is_own() && in_blocks(row)),
    ("dq8 plain", |row| row.is_own() && !in_blocks(row) && !has_other_keys(row)),
    ("glam", |row| row.contender.starts_with("glam")),
    ("nalgebra `UnitDualQuaternion`", |row| row.contender == "nalgebra UnitDualQuaternion"),
    ("lane peer", |row| !row.is_own() && in_blocks(row)),
];

/// Packed for lanes: blocks of this crate, and types of eight lanes.
fn in_blocks(row: &Row) -> bool {
    row.contender.contains("lanes") || row.contender.ends_with("x8")
}

/// Packed clips of eight bytes a key: not the input that all others have.
fn has_other_keys(row: &Row) -> bool {
    row.contender.starts_with("dq8 packed")
}

#[derive(Debug, PartialEq)]
pub(crate) struct Best {
    /// The job and its size.
    pub(crate) job: String,
    pub(crate) title: String,
    pub(crate) times: [Option<Time>; KINDS.len()],
}

/// Nanoseconds a transform, rounded to what is written, so that the chart is that of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Time {
    pub(crate) least: f64,
    /// With AVX2, where this crate has quicker instructions.
    pub(crate) avx2: Option<f64>,
}

impl Best {
    pub(crate) fn of_all(results: &Results) -> Vec<Self> {
        results.contests().map(|rows| Self::of(&rows)).collect()
    }

    /// Of the rows of one contest, the fastest first.
    fn of(rows: &[&Row]) -> Self {
        let hundredths = |ns: f64| (ns * 100.0).round() / 100.0;
        let times = KINDS.map(|(_, belongs)| {
            let mut of_kind = rows.iter().filter(|row| belongs(row));
            let best = of_kind.clone().next()?;
            let avx2 = of_kind.find(|row| row.backend.is_some() && row.backend == Backend::avx2());
            let slower = avx2.filter(|avx2| best.min < avx2.min);
            Some(Time {
                least: hundredths(best.min),
                avx2: slower.map(|avx2| hundredths(avx2.min)),
            })
        });
        let of = rows[0];
        Self { job: format!("{} {}", of.job, of.size), title: of.title.clone(), times }
    }
}

impl fmt::Display for Time {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.2}", self.least)?;
        self.avx2.map_or(Ok(()), |avx2| write!(f, " ({avx2:.2})"))
    }
}
