//! [`Panel`]: one contest.

use super::bars::{Bars, bars};
use super::{LINE, PANEL, SIZE};
use crate::results::{Row, best_own};
use dq8_fixtures::legible::{width, wrapped};
use std::fmt::{self, Write};

const CAPTION: f64 = 13.0;
const CAPTION_LINE: f64 = 17.0;
/// Names end here, bars begin a little to the right, the longest ends where there is room for the
/// numbers behind.
const NAMES: f64 = 152.0;
const BARS: f64 = NAMES + 7.0;
const NUMBERS: f64 = 6.0;
/// Bars that are longer than so many times the median are cut, so that the others can be told
/// apart.
const CUT: f64 = 3.0;
/// Above and below a bar, and between those of one name and the next.
const AROUND: f64 = 2.0;
const BETWEEN: f64 = 4.0;

pub(crate) struct Panel<'a> {
    caption: String,
    bars: Vec<Bars<'a>>,
    /// The time of the longest bar, and how long that is.
    most: f64,
    longest: f64,
    best: Option<f64>,
}

impl<'a> Panel<'a> {
    /// Of rows that begin with the fastest.
    pub(crate) fn of(rows: &[&'a Row]) -> Self {
        let slowest = rows[rows.len() - 1].min;
        let best = best_own(rows, |_| true);
        let bars = bars(rows);
        let labels =
            bars.iter().flat_map(|bars| &bars.rows).map(|(row, kind)| label(row, kind.said, best));
        let widest = labels.map(|label| width(&label, SIZE, false)).fold(0.0, f64::max);
        Self {
            caption: format!("{} {}: {}", rows[0].job, rows[0].size, rows[0].title),
            bars,
            most: slowest.min(CUT * rows[rows.len() / 2].min),
            longest: PANEL - BARS - NUMBERS - widest,
            best,
        }
    }

    fn length(&self, ns: f64) -> f64 {
        self.longest * (ns / self.most).min(1.0)
    }

    /// Gives back where it ends.
    pub(crate) fn write(&self, out: &mut String, left: f64, top: f64) -> Result<f64, fmt::Error> {
        let mut y = top;
        for line in wrapped(&self.caption, CAPTION, true, PANEL) {
            writeln!(
                out,
                r#"<text class="caption" x="{left}" y="{}">{}</text>"#,
                y + CAPTION,
                escaped(&line)
            )?;
            y += CAPTION_LINE;
        }
        for bars in &self.bars {
            y += BETWEEN;
            let own = bars.rows[0].0.is_own();
            let class = if own { "name own" } else { "name" };
            // A number stays with what it counts.
            let name = bars.name.replace(" lanes", "\u{a0}lanes");
            let names = wrapped(&name, SIZE, own, NAMES);
            for (line, name) in names.iter().enumerate() {
                let (x, y) = (left + NAMES, y + SIZE + LINE * line as f64);
                writeln!(out, r#"<text class="{class}" x="{x}" y="{y}">{}</text>"#, escaped(name))?;
            }
            for (line, (row, kind)) in bars.rows.iter().enumerate() {
                let y = y + LINE * line as f64;
                self.write_bar(out, [left + BARS, y], row, kind.class)?;
                let (x, y) =
                    (left + BARS + self.length(row.min.max(row.median)) + NUMBERS, y + SIZE);
                writeln!(
                    out,
                    r#"<text x="{x:.1}" y="{y}">{}</text>"#,
                    label(row, kind.said, self.best)
                )?;
            }
            y += LINE * names.len().max(bars.rows.len()) as f64;
        }
        Ok(y)
    }

    fn write_bar(&self, out: &mut String, [x, y]: [f64; 2], row: &Row, class: &str) -> fmt::Result {
        let (width, height) = (self.length(row.min), LINE - 2.0 * AROUND);
        let top = y + AROUND;
        writeln!(
            out,
            r#"<rect class="{class}" x="{x}" y="{top}" width="{width:.1}" height="{height}"/>"#
        )?;
        if row.min > self.most {
            let x = x + 0.9 * self.longest;
            writeln!(out, r#"<path class="cut" d="M{x:.1} {}l6 {}"/>"#, y + LINE, -LINE)
        } else if row.median <= self.most {
            let x = x + self.length(row.median);
            writeln!(out, r#"<path class="median" d="M{x:.1} {top}v{height}"/>"#)
        } else {
            Ok(())
        }
    }
}

/// Behind the bar: its time, and with which instructions, or how many times the best of dq8.
fn label(row: &Row, said: &str, best: Option<f64>) -> String {
    let time = rounded(row.min);
    match best {
        _ if !said.is_empty() => format!("{time} {said}"),
        Some(best) if !row.is_own() => format!("{time} ({}×)", ratio(row.min / best)),
        _ => time,
    }
}

fn ratio(times: f64) -> String {
    if times < 1e4 { format!("{times:.1}") } else { rounded(times) }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

/// Three digits, as many as times repeat from run to run.
fn rounded(number: f64) -> String {
    let before = number.abs().log10().floor() as i32 + 1;
    if (-2..=6).contains(&before) {
        format!("{number:.*}", (3 - before).max(0) as usize)
    } else {
        format!("{number:.2e}")
    }
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn numbers_have_three_digits() {
        for (number, text) in [
            (0.361, "0.361"),
            (1.3244, "1.32"),
            (45.555, "45.6"),
            (9999.0, "9999"),
            (1e12, "1.00e12"),
            (1e-9, "1.00e-9"),
        ] {
            assert_eq!(rounded(number), text);
        }
    }
}
