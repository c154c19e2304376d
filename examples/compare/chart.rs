//! The results as a picture, 700 pixels wide: a row for each contest, and in it a mark for each
//! kind of contender, at its time over that of glam.

use crate::best::Best;
use dq8_fixtures::legible::wrapped;
use std::fmt::{self, Write};

const WIDTH: f64 = 700.0;
const MARGIN: f64 = 16.0;
/// From one line of a text to the next, and how large its letters are.
const LINE: f64 = 15.0;
const SIZE: f64 = 12.0;
/// Names of contests end before the scale, what dq8 gains stands behind it.
const SCALE: [f64; 2] = [270.0, 620.0];
/// The times of glam that the scale ends at, as powers of two.
const ENDS: [f64; 2] = [-3.0, 2.0];
const TICKS: [&str; 6] = ["⅛", "¼", "½", "1", "2", "4"];
/// What does not fit into the first caches is in the table.
const LARGER: [&str; 4] = ["L2", "L3", "DRAM", "64x1024"];
/// Where glam is among the kinds of [`Best`], and the marks of the others: class, shape, name.
const GLAM: usize = 2;
const MARKS: [(&str, &str, &str); 5] = [
    ("blocks", "m-6 0a6 6 0 1 0 12 0a6 6 0 1 0-12 0z", "dq8, blocks"),
    ("plain", "m-6 0a6 6 0 1 0 12 0a6 6 0 1 0-12 0z", "dq8, plain"),
    ("glam", "m0-9v18", "glam"),
    ("peer", "m0-6l6 6-6 6-6-6z", "nalgebra"),
    ("lanes", "m0-6l6 6-6 6-6-6z", "peer on lanes"),
];

const STYLE: &str = "\
text{font-family:sans-serif;font-size:12px;fill:#222}\
.title{font-size:17px;font-weight:bold}.tick{text-anchor:middle;fill:#555}.gain{text-anchor:end;font-weight:bold}\
.grid{stroke:#ddd}.span{stroke:#999}.glam{stroke:#222;stroke-width:2}\
.blocks{fill:#0072b2}.plain{fill:#56b4e9}.peer{fill:#888}.lanes{fill:#fff;stroke:#666;stroke-width:1.5}";

const TITLE: &str = "Time over that of glam: farther left is quicker";
const NOTE: &str = "f32, on one thread, data in the first caches. At the right: how many times as quick as glam the \
                    quicker layout of dq8 is. ScLERP stands beside glam's slerp and lerp.";

pub(crate) fn picture(contests: &[Best]) -> Result<String, fmt::Error> {
    let mut body = String::new();
    writeln!(body, r#"<text class="title" x="{MARGIN}" y="28">{TITLE}</text>"#)?;
    let mut y = 32.0;
    for line in wrapped(NOTE, SIZE, false, WIDTH - 2.0 * MARGIN) {
        y += LINE;
        writeln!(body, r#"<text x="{MARGIN}" y="{y}">{line}</text>"#)?;
    }
    y += 24.0;
    write_legend(&mut body, y)?;
    y += 34.0;
    let (top, mut rows) = (y, String::new());
    for best in contests.iter().filter(|best| is_drawn(best)) {
        y = write_row(&mut rows, best, y)?;
    }
    for (tick, name) in TICKS.iter().enumerate() {
        let x = place((ENDS[0] + tick as f64).exp2());
        let class = if *name == "1" { "glam" } else { "grid" };
        writeln!(body, r#"<text class="tick" x="{x:.0}" y="{}">{name}</text>"#, top - 6.0)?;
        writeln!(body, r#"<path class="{class}" d="M{x:.0} {top}V{y}"/>"#)?;
    }
    let height = y + MARGIN;
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" \
         width=\"{WIDTH}\" height=\"{height:.0}\">\n<style>{STYLE}</style>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{body}{rows}</svg>\n"
    ))
}

/// Those that glam takes part in.
fn is_drawn(best: &Best) -> bool {
    best.times[GLAM].is_some() && !best.job.split(' ').any(|word| LARGER.contains(&word))
}

/// The x of a ratio; beyond the scale, its end.
fn place(ratio: f64) -> f64 {
    let part = (ratio.log2() - ENDS[0]) / (ENDS[1] - ENDS[0]);
    SCALE[0] + (SCALE[1] - SCALE[0]) * part.clamp(0.0, 1.0)
}

fn write_legend(out: &mut String, y: f64) -> fmt::Result {
    for (index, (class, shape, name)) in MARKS.iter().enumerate() {
        let x = MARGIN + 8.0 + 130.0 * index as f64;
        writeln!(out, r#"<path class="{class}" d="M{x} {y}{shape}"/>"#)?;
        writeln!(out, r#"<text x="{}" y="{}">{name}</text>"#, x + 11.0, y + 4.0)?;
    }
    Ok(())
}

/// Gives back where it ends.
fn write_row(out: &mut String, best: &Best, top: f64) -> Result<f64, fmt::Error> {
    let lines = wrapped(&best.title, SIZE, false, SCALE[0] - MARGIN - 14.0);
    let height = LINE * lines.len() as f64 + 9.0;
    for (line, text) in lines.iter().enumerate() {
        let y = top + SIZE + 4.0 + LINE * line as f64;
        writeln!(out, r#"<text x="{MARGIN}" y="{y}">{}</text>"#, escaped(text))?;
    }
    let glam = best.times[GLAM].map_or(1.0, |time| time.least);
    let middle = top + height / 2.0;
    let places = best.times.map(|time| time.map(|time| place(time.least / glam)));
    let ends = places.iter().flatten();
    let (low, high) = ends.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(*x), high.max(*x)));
    writeln!(out, r#"<path class="span" d="M{low:.0} {middle}H{high:.0}"/>"#)?;
    // dq8 is drawn last, above what it hides.
    for (index, x) in places.iter().enumerate().rev().filter(|(index, _)| *index != GLAM) {
        if let Some(x) = x {
            let (class, shape, _) = MARKS[index];
            writeln!(out, r#"<path class="{class}" d="M{x:.0} {middle}{shape}"/>"#)?;
        }
    }
    let own = best.times[..GLAM].iter().flatten().map(|time| time.least).min_by(f64::total_cmp);
    if let Some(own) = own {
        let (x, y) = (WIDTH - MARGIN, middle + 4.0);
        writeln!(out, r#"<text class="gain" x="{x}" y="{y}">{:.1} ×</text>"#, glam / own)?;
    }
    Ok(top + height)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

#[cfg(test)]
mod tests {
    use super::{GLAM, is_drawn, picture};
    use crate::best::{Best, KINDS, Time};
    use crate::plan::plan;
    use crate::results::{Results, Row};
    use dq8_contest::caches::Caches;
    use dq8_contest::task::Task;
    use dq8_fixtures::legible::illegible;

    const PAGE: &str = include_str!("../../docs/compare.md");

    /// The first table of the page that `markdown` writes.
    fn table() -> Vec<Best> {
        let rows = PAGE.lines().skip_while(|line| !line.starts_with("|---")).skip(1);
        rows.take_while(|line| line.starts_with('|')).map(read).collect()
    }

    fn read(row: &str) -> Best {
        let cells: Vec<_> = row.trim_matches('|').split('|').map(str::trim).collect();
        let (job, title) = cells[0].split_once(", ").unwrap();
        let number = |word: &str| word.trim_matches(['(', ')']).parse().unwrap();
        let times = std::array::from_fn(|kind| {
            let mut words = cells[kind + 1].split(' ').filter(|word| *word != "–");
            Some(Time { least: number(words.next()?), avx2: words.next().map(number) })
        });
        assert_eq!(cells.len(), KINDS.len() + 1, "{row}");
        Best { job: job.into(), title: title.into(), times }
    }

    #[test]
    fn the_chart_in_the_documentation_is_that_of_the_table_beside_it() {
        let (table, chart) = (table(), include_str!("../../docs/compare.svg"));
        assert_eq!(table.len(), 27);
        assert_eq!(illegible(chart), [""; 0]);
        let picture = picture(&table).unwrap();
        let path = std::env::temp_dir().join("compare.svg");
        if picture != chart {
            std::fs::write(&path, picture).unwrap();
            panic!(
                "docs/compare.svg is of another table; that of compare.md is in {}",
                path.display()
            );
        }
    }

    #[test]
    fn marks_keep_to_the_scale_and_contests_without_glam_are_left_out() {
        let time = |least| Some(Time { least, avx2: None });
        let best = |times| Best { job: "J1 L1".into(), title: "product".into(), times };
        let far = best([time(1e-9), time(1e9), time(1.0), None, None]);
        let picture = picture(&[far]).unwrap();
        assert!(picture.contains("d=\"M270 ") && picture.contains("d=\"M620 "), "{picture}");
        assert!(!picture.contains("NaN") && !picture.contains("inf"));
        assert!(!is_drawn(&best([time(1.0), None, None, time(1.0), None])));
        let larger =
            Best { job: "J1 DRAM".into(), ..best([time(1.0), None, time(1.0), None, None]) };
        assert!(!is_drawn(&larger));
    }

    #[test]
    fn nothing_measured_is_an_empty_picture() {
        assert!(picture(&[]).unwrap().starts_with("<svg"));
    }

    #[test]
    fn no_two_texts_of_any_job_overlap_and_none_leaves_the_page() {
        let caches = Caches::of_this_machine();
        let mut results = Results::default();
        // The bandwidth is no contest.
        for task in plan(true, &[]).iter().filter(|task| !matches!(task, Task::Bandwidth)) {
            task.with_contest(&caches, |contest| {
                for (index, contender) in contest.contenders.iter().enumerate() {
                    let min = 0.123_456 * 4_f64.powi(index as i32 % 9);
                    let mut row = Row::sample(&contender.name, min);
                    (row.job, row.size, row.title) =
                        (contest.job, contest.size.clone(), contest.title.clone());
                    results.rows.push(row);
                }
            });
        }
        let contests = Best::of_all(&results);
        let drawn = contests.iter().filter(|best| best.times[GLAM].is_some()).count();
        assert!(drawn >= 10, "{drawn}");
        assert_eq!(illegible(&picture(&contests).unwrap()), [""; 0]);
    }
}
