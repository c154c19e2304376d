//! The results as a page: a table of the best of each kind, and one of all contenders.

use crate::best::{Best, KINDS};
use crate::forms::{COLUMNS, forms};
use crate::results::{Results, best_own};
use std::fmt::{self, Write};

const HEADING: &str = "\
# Side by side

`cargo run --release --example compare -- --md OUT` writes this page, and [results](results.md) says on which machine.
Numbers are nanoseconds per transform in `f32` on one thread, the least of all rounds.

## The best of each kind

In brackets: dq8 with AVX2, where other instructions are quicker.

";

const ALL: &str = "
## All contenders

The columns are the instructions that a row ran with; peers have those of a default build. The last column divides by the
least time of dq8.

";

pub(crate) fn text(results: &Results) -> Result<String, fmt::Error> {
    let mut text = String::from(HEADING);
    text.push_str("| job |");
    KINDS.iter().try_for_each(|(name, _)| write!(text, " {name} |"))?;
    writeln!(text, "\n|{}", "---|".repeat(KINDS.len() + 1))?;
    for Best { job, title, times } in Best::of_all(results) {
        write!(text, "| {job}, {title} |")?;
        for time in times {
            match time {
                Some(time) => write!(text, " {time} |")?,
                None => text.push_str(" – |"),
            }
        }
        text.push('\n');
    }
    text.push_str(ALL);
    writeln!(text, "| job | contender | {} | × dq8 |", COLUMNS.join(" | "))?;
    writeln!(text, "|{}", "---|".repeat(COLUMNS.len() + 3))?;
    for rows in results.contests() {
        let best = best_own(&rows, |_| true);
        for form in forms(&rows) {
            write!(text, "| {} {} | {} |", rows[0].job, rows[0].size, form.name)?;
            for least in form.least {
                match least {
                    Some(ns) => write!(text, " {} |", rounded(ns))?,
                    None => text.push_str(" |"),
                }
            }
            let peer = best.zip(form.least.last().copied().flatten()).filter(|_| !form.is_own);
            writeln!(
                text,
                "{} |",
                peer.map_or(String::new(), |(own, ns)| format!(" {:.1}", ns / own))
            )?;
        }
    }
    Ok(text)
}

/// Three digits, as many as times repeat from run to run.
fn rounded(number: f64) -> String {
    let before = number.abs().log10().floor() as i32 + 1;
    format!("{number:.*}", (3 - before).max(0) as usize)
}

#[cfg(test)]
mod tests {
    use super::{rounded, text};
    use crate::results::{Results, Row};
    use dq8::Backend;

    #[test]
    fn numbers_have_three_digits() {
        for (number, text) in
            [(0.361, "0.361"), (1.3244, "1.32"), (45.555, "45.6"), (9999.0, "9999")]
        {
            assert_eq!(rounded(number), text);
        }
    }

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
        let text = text(&results).unwrap();
        let has = |row: &str| assert!(text.lines().any(|line| line == row), "{row}: {text}");
        has("| J1 L1, product | 0.50 | 1.25 | 2.00 | – | 0.75 |");
        // All of them, too.
        has("| J1 L1 | dq8 8 lanes | | 0.500 | | |");
        has("| J1 L1 | dq8 scalar | | | 4.00 | |");
        has("| J1 L1 | glam Mat4 | | | 3.00 | 6.0 |");
    }

    #[test]
    fn slower_lanes_of_avx2_are_in_brackets() {
        let Some(avx2) = Backend::avx2() else { return };
        let mut results = Results::default();
        let of_avx2 = Row { backend: Some(avx2), ..Row::sample("dq8 8 lanes AVX2", 0.75) };
        results.rows.extend([Row::sample("dq8 8 lanes AVX-512", 0.5), of_avx2]);
        let row = "| J1 L1, product | 0.50 (0.75) | – | – | – | – |";
        assert!(text(&results).unwrap().lines().any(|line| line == row));
    }
}
