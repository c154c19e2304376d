//! The results as a table for documents, one row a contest: the best of each kind.

use crate::results::{Results, Row};
use dq8::Backend;
use std::fmt::{self, Write};

/// A heading, and which rows are meant.
type Column = (&'static str, fn(&Row) -> bool);

const COLUMNS: [Column; 5] = [
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

/// Nanoseconds a transform, the least of each column; in brackets this crate's on AVX2 where other
/// instructions are faster.
pub(crate) fn text(results: &Results) -> Result<String, fmt::Error> {
    let mut text = String::from("| job |");
    COLUMNS.iter().try_for_each(|(name, _)| write!(text, " {name} |"))?;
    writeln!(text, "\n|{}", "---|".repeat(COLUMNS.len() + 1))?;
    for rows in results.contests() {
        let Some(of) = rows.first() else { continue };
        write!(text, "| {} {}, {} |", of.job, of.size, of.title)?;
        for (_, belongs) in COLUMNS {
            // The fastest first.
            let mut of_kind = rows.iter().filter(|row| belongs(row));
            let best = of_kind.clone().next();
            let avx2 = of_kind.find(|row| row.backend.is_some() && row.backend == Backend::avx2());
            match best {
                Some(best) => write!(text, " {:.2}", best.min)?,
                None => text.push_str(" –"),
            }
            if let Some(avx2) = avx2.filter(|avx2| best.is_some_and(|best| best.min < avx2.min)) {
                write!(text, " ({:.2})", avx2.min)?;
            }
            text.push_str(" |");
        }
        text.push('\n');
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::text;
    use crate::results::{Results, Row};
    use dq8::Backend;

    #[test]
    fn each_kind_has_its_best_and_nobody_has_a_dash() {
        let rows = [
            ("dq8 8 lanes AVX2", 0.5),
            ("dq8 AoS AVX2", 1.25),
            ("dq8 scalar", 4.0),
            ("dq8 packed, AoS AVX2", 1.0),
            ("glam Mat4", 3.0),
            ("glam Affine3A", 2.0),
            ("ultraviolet Isometry3x8", 0.75),
        ];
        let mut results = Results::default();
        results.rows.extend(rows.map(|(name, min)| Row::sample(name, min)));
        let row = "| J1 L1, product | 0.50 | 1.25 | 2.00 | – | 0.75 |";
        assert_eq!(text(&results).unwrap().lines().nth(2), Some(row));
    }

    #[test]
    fn slower_lanes_of_avx2_are_in_brackets() {
        let Some(avx2) = Backend::avx2() else { return };
        let mut results = Results::default();
        let of_avx2 = Row { backend: Some(avx2), ..Row::sample("dq8 8 lanes AVX2", 0.75) };
        results.rows.extend([Row::sample("dq8 8 lanes AVX-512", 0.5), of_avx2]);
        let row = "| J1 L1, product | 0.50 (0.75) | – | – | – | – |";
        assert_eq!(text(&results).unwrap().lines().nth(2), Some(row));
    }
}
