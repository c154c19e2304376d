//! The results as a picture, 800 pixels wide: a panel a contest, a bar a contender.

mod bars;
mod panel;

use crate::results::Results;
use dq8_fixtures::legible::wrapped;
use panel::Panel;
use std::fmt::{self, Write};

const WIDTH: f64 = 800.0;
const COLUMNS: usize = 2;
const MARGIN: f64 = 16.0;
const GAP: f64 = 28.0;
/// How wide a panel is.
const PANEL: f64 = (WIDTH - 2.0 * MARGIN - (COLUMNS - 1) as f64 * GAP) / COLUMNS as f64;
/// From one line of a text to the next, and how large its letters are.
const LINE: f64 = 14.0;
const SIZE: f64 = 11.0;

const STYLE: &str = "\
text{font-family:sans-serif;font-size:11px;fill:#222}\
.title{font-size:20px;font-weight:bold}.caption{font-size:13px;font-weight:bold}\
.name{text-anchor:end}.own{font-weight:bold}\
.avx512{fill:#0072b2}.avx2{fill:#56b4e9}.portable{fill:#009e73}.scalar{fill:#a3d9c5}\
.peer{fill:#bbb}.median{stroke:#222;stroke-width:1.5}.cut{stroke:#fff;stroke-width:3}";

const NOTE: &str = "Shorter is better. A bar is the least time of all rounds, the line at its end the median. dq8 in \
                    colours, by the instructions that it ran with; its peers in grey, with how many times the least time \
                    of dq8 they take. Numbers are f32, on one thread. J1 and the like are the jobs of the example compare.";

pub(crate) fn picture(results: &Results) -> Result<String, fmt::Error> {
    let mut body = String::new();
    let top = write_heading(&mut body)?;
    let mut bottoms = [top; COLUMNS];
    let mut contests: Vec<_> = results.contests().collect();
    contests.sort_by_key(|rows| rows[0].job);
    for rows in &contests {
        // Into the column that ends first.
        let column = (0..COLUMNS).min_by(|&a, &b| bottoms[a].total_cmp(&bottoms[b])).unwrap_or(0);
        let left = MARGIN + column as f64 * (PANEL + GAP);
        bottoms[column] = Panel::of(rows).write(&mut body, left, bottoms[column])? + GAP;
    }
    let height = bottoms.into_iter().fold(top, f64::max);
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" \
         width=\"{WIDTH}\" height=\"{height:.0}\">\n<style>{STYLE}</style>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{body}</svg>\n"
    ))
}

/// Gives back where it ends.
fn write_heading(out: &mut String) -> Result<f64, fmt::Error> {
    writeln!(out, r#"<text class="title" x="{MARGIN}" y="36">Nanoseconds a transform</text>"#)?;
    let mut y = 40.0;
    for line in wrapped(NOTE, SIZE, false, WIDTH - 2.0 * MARGIN) {
        y += LINE;
        writeln!(out, r#"<text x="{MARGIN}" y="{y}">{line}</text>"#)?;
    }
    Ok(y + GAP)
}

#[cfg(test)]
mod tests {
    use super::{WIDTH, picture};
    use crate::plan::plan;
    use crate::results::{Results, Row};
    use dq8_contest::caches::Caches;
    use dq8_contest::task::Task;
    use dq8_fixtures::legible::illegible;

    fn row(contender: &str, min: f64, median: f64) -> Row {
        Row { median, ..Row::sample(contender, min) }
    }

    fn drawn(rows: Vec<Row>) -> String {
        picture(&Results { rows, ..Results::default() }).unwrap()
    }

    #[test]
    fn bars_are_drawn_inside_the_picture() {
        let picture = drawn(vec![
            row("dq8 scalar", 1.0, 1.1),
            row("slow", 2.0, 9.0),
            row("slower", 1e4, 1e5),
        ]);
        assert!(!picture.contains("NaN") && !picture.contains("inf"));
        assert_eq!(picture.matches(r#"class="peer""#).count(), 2);
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

    #[test]
    fn no_two_texts_of_any_job_overlap_and_none_leaves_the_page() {
        let caches = Caches::of_this_machine();
        let tasks = plan(true, &[]);
        let mut rows = Vec::new();
        // The bandwidth is no contest of bars.
        for task in tasks.iter().filter(|task| !matches!(task, Task::Bandwidth)) {
            task.with_contest(&caches, |contest| {
                for (index, contender) in contest.contenders.iter().enumerate() {
                    let min = 0.123_456 * 4_f64.powi(index as i32 % 9);
                    let mut row = row(&contender.name, min, 1.1 * min);
                    (row.job, row.size, row.title) =
                        (contest.job, contest.size.clone(), contest.title.clone());
                    rows.push(row);
                }
            });
        }
        assert!(rows.len() > 80, "{}", rows.len());
        assert_eq!(illegible(&drawn(rows)), [""; 0]);
    }

    #[test]
    fn the_picture_in_the_documentation_is_legible() {
        assert_eq!(illegible(include_str!("../../docs/compare.svg")), [""; 0]);
    }

    #[test]
    fn names_and_numbers_of_any_length_keep_to_their_places() {
        for name in
            ["W", "a name of very many words, more of them than a line has", &"W".repeat(80)]
        {
            for own in [format!("dq8 {name} AVX-512"), format!("dq8 {name}"), name.to_owned()] {
                for min in [1e-9, 0.123_456, 9.9999, 12_345.678, 1e12] {
                    let mut first = row(&own, min, 3.0 * min);
                    (first.size, first.title) = (name.to_owned(), name.to_owned());
                    let mut second = row("dq8 scalar", 1.0, 1.0);
                    (second.size, second.title) = (first.size.clone(), first.title.clone());
                    assert_eq!(illegible(&drawn(vec![first, second])), [""; 0], "{own} {min}");
                }
            }
        }
    }
}
