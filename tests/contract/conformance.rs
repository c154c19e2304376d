//! Runs all vectors on one implementation and keeps the worst error of each operation and kind.

use crate::implementation::On;
use crate::vectors::Vector;
use std::collections::BTreeMap;

/// The worst error of an implementation on the vectors of one operation and kind.
#[derive(Clone, Debug)]
pub struct Worst {
    pub op: String,
    pub kind: String,
    pub implementation: &'static str,
    /// The row of the worst error.
    pub row: usize,
    /// How many vectors there were.
    pub vectors: usize,
    /// Relative to the scale of the vector.
    pub error: f64,
    /// What the table allows.
    pub allowed: f64,
}

impl Worst {
    /// Whether the error is more than the table allows; an error that is no number is.
    pub fn breaks_bound(&self) -> bool {
        self.error.is_nan() || self.error > self.allowed
    }
}

/// The worst errors of `on`, by operation and kind.
///
/// # Errors
/// If the table has no line for an operation; the message names the row.
pub fn worst_errors(on: On, vectors: &[Vector]) -> Result<Vec<Worst>, String> {
    // Vectors that are computed together must be of one shape.
    let mut groups: BTreeMap<_, Vec<&Vector>> = BTreeMap::new();
    for vector in vectors.iter().filter(|vector| vector.is_on(on)) {
        let key = (vector.op.as_str(), vector.kind.as_str(), vector.shape());
        groups.entry(key).or_default().push(vector);
    }
    let mut worst: BTreeMap<(&str, &str), Worst> = BTreeMap::new();
    for ((op, kind, _), group) in groups {
        let bound = group[0].bound().ok_or_else(|| {
            format!("row {}: the table has no bound for {op} ({kind})", group[0].row)
        })?;
        let entry = worst.entry((op, kind)).or_insert_with(|| Worst {
            op: op.to_owned(),
            kind: kind.to_owned(),
            implementation: on.name,
            row: group[0].row,
            vectors: 0,
            error: 0.0,
            allowed: bound.units * on.roundoff(),
        });
        for chunk in group.chunks(on.lanes) {
            for (vector, answer) in chunk.iter().zip(chunk[0].answers(on, chunk)) {
                let error = vector.error(&answer);
                entry.vectors += 1;
                if error > entry.error || error.is_nan() {
                    (entry.error, entry.row) = (error, vector.row);
                }
            }
        }
    }
    Ok(worst.into_values().collect())
}
