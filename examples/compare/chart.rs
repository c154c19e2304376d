//! The results as a picture: a panel a contest, a bar a contender.

use crate::results::{Results, Row};
use dq8::Backend;
use std::fmt::{self, Write};

const COLUMNS: usize = 3;
const MARGIN: f64 = 40.0;
const GAP: f64 = 40.0;
const PANEL: f64 = 500.0;
/// Where bars begin, right of the names, and how long the longest is.
const BARS: f64 = 245.0;
const LONGEST: f64 = 180.0;
const LINE: f64 = 18.0;
const HEADING: f64 = 120.0;
const CAPTION: f64 = 34.0;
const WIDTH: f64 = 2.0 * MARGIN + COLUMNS as f64 * PANEL + (COLUMNS - 1) as f64 * GAP;

/// Bars that are longer than so many times the median are cut, so that the others can be told apart.
const CUT: f64 = 3.0;

const STYLE: &str = "\
text{font-family:sans-serif;font-size:12px;fill:#333}\
.title{font-size:24px;font-weight:bold}.caption{font-size:15px;font-weight:bold}\
.name{text-anchor:end}.own{font-weight:bold}\
.avx512{fill:#0072b2}.avx2{fill:#56b4e9}.portable{fill:#009e73}.scalar{fill:#a3d9c5}\
.peer{fill:#bbb}.median{stroke:#333;stroke-width:1.5}.cut{stroke:#fff;stroke-width:3}";

const LEGEND: [(&str, &str); 5] = [
    ("avx512", "dq8 AVX-512"),
    ("avx2", "dq8 AVX2"),
    ("portable", "dq8 portable"),
    ("scalar", "dq8 scalar"),
    ("peer", "peers"),
];

pub(crate) fn picture(results: &Results) -> Result<String, fmt::Error> {
    let mut body = String::new();
    write_heading(&mut body)?;
    let mut bottoms = [HEADING; COLUMNS];
    for rows in results.contests() {
        // Into the column that ends first.
        let column = (0..COLUMNS).min_by(|&a, &b| bottoms[a].total_cmp(&bottoms[b])).unwrap_or(0);
        let left = MARGIN + column as f64 * (PANEL + GAP);
        bottoms[column] = write_panel(&mut body, left, bottoms[column], &rows)? + GAP;
    }
    let height = bottoms.into_iter().fold(HEADING, f64::max);
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" \
         width=\"{WIDTH}\" height=\"{height:.0}\">\n<style>{STYLE}</style>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{body}</svg>\n"
    ))
}

fn write_heading(out: &mut String) -> fmt::Result {
    writeln!(out, r#"<text class="title" x="{MARGIN}" y="50">Nanoseconds a transform</text>"#)?;
    let note = "Bars: least time of all rounds. Line: median. Shorter is better. \
                A number behind: as many times the fastest of dq8. One thread.";
    writeln!(out, r#"<text x="{MARGIN}" y="72">{note}</text>"#)?;
    for (index, (class, meaning)) in LEGEND.iter().enumerate() {
        let x = MARGIN + 130.0 * index as f64;
        writeln!(out, r#"<rect class="{class}" x="{x}" y="84" width="14" height="12"/>"#)?;
        writeln!(out, r#"<text x="{}" y="94">{meaning}</text>"#, x + 20.0)?;
    }
    Ok(())
}

/// Gives back where it ends.
fn write_panel(out: &mut String, left: f64, top: f64, rows: &[&Row]) -> Result<f64, fmt::Error> {
    let (job, size, title) = (rows[0].job, &rows[0].size, &rows[0].title);
    let y = top + LINE;
    writeln!(out, r#"<text class="caption" x="{left}" y="{y}">{job} {size}: {title}</text>"#)?;
    let slowest = rows[rows.len() - 1].min;
    let most = slowest.min(CUT * rows[rows.len() / 2].min);
    let best = crate::results::best_own(rows, |_| true);
    let mut y = top + CAPTION;
    let bars = left + BARS;
    for row in rows {
        let length = |ns: f64| LONGEST * (ns / most).min(1.0);
        let (class, bold) = (class(row), if row.is_own() { "name own" } else { "name" });
        let (base, middle) = (y + LINE - 5.0, y + LINE / 2.0);
        writeln!(
            out,
            r#"<text class="{bold}" x="{}" y="{base}">{}</text>"#,
            bars - 8.0,
            row.contender
        )?;
        let (width, height) = (length(row.min), LINE - 4.0);
        writeln!(
            out,
            r#"<rect class="{class}" x="{bars}" y="{}" width="{width:.1}" height="{height}"/>"#,
            y + 2.0
        )?;
        if row.min > most {
            let (x, from, to) = (bars + 0.9 * LONGEST, y + LINE, y);
            writeln!(out, r#"<path class="cut" d="M{x} {from}L{} {to}"/>"#, x + 6.0)?;
        } else if row.median <= most {
            let x = bars + length(row.median);
            writeln!(
                out,
                r#"<path class="median" d="M{x:.1} {}V{}"/>"#,
                middle - 4.0,
                middle + 4.0
            )?;
        }
        let ratio = match best {
            Some(best) if !row.is_own() => format!("  ({:.1}×)", row.min / best),
            _ => String::new(),
        };
        let x = bars + length(row.min.max(row.median)) + 6.0;
        writeln!(out, r#"<text x="{x:.1}" y="{base}">{:.3}{ratio}</text>"#, row.min)?;
        y += LINE;
    }
    Ok(y)
}

fn class(row: &Row) -> &'static str {
    match row.backend {
        Some(backend) if Some(backend) == Backend::avx512() => "avx512",
        Some(backend) if Some(backend) == Backend::avx2() => "avx2",
        Some(_) => "portable",
        None if row.is_own() => "scalar",
        None => "peer",
    }
}

#[cfg(test)]
mod tests {
    use super::{WIDTH, picture};
    use crate::results::{Results, Row};

    fn row(contender: &str, min: f64, median: f64) -> Row {
        Row {
            job: "J1",
            size: "L1".into(),
            title: "product".into(),
            contender: contender.into(),
            backend: None,
            profile: "release",
            min,
            median,
            limited: None,
        }
    }

    #[test]
    fn bars_are_drawn_inside_the_picture() {
        let rows =
            vec![row("dq8 scalar", 1.0, 1.1), row("slow", 2.0, 9.0), row("slower", 1e4, 1e5)];
        let picture = picture(&Results { rows, ..Results::default() }).unwrap();
        assert!(!picture.contains("NaN") && !picture.contains("inf"));
        assert_eq!(picture.matches(r#"class="peer""#).count(), 3, "two bars and the legend");
        let edges = picture.lines().filter(|line| line.starts_with("<rect class")).map(|line| {
            let number = |name: &str| -> f64 {
                let from = line.find(name).unwrap() + name.len();
                line[from..].split('"').next().unwrap().parse().unwrap()
            };
            number(" x=\"") + number(" width=\"")
        });
        assert!(edges.into_iter().all(|edge| edge < WIDTH));
    }

    #[test]
    fn nothing_measured_is_an_empty_picture() {
        assert!(picture(&Results::default()).unwrap().starts_with("<svg"));
    }
}
