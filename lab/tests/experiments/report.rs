//! The report: one well-formed page with every section, and the program that writes it.

use dq8_fixtures::legible::illegible;
use lab::report::{Chart, Section, Series, Table, decimal, page, power_of_ten, scientific};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

fn lab(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lab"));
    command.args(arguments).output().expect("the program is built with its tests")
}

fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// The page and what was printed, of one run for all tests.
fn run() -> &'static (String, String) {
    static RUN: OnceLock<(String, String)> = OnceLock::new();
    RUN.get_or_init(|| {
        let out = scratch("report/of a run");
        let output = lab(&["--out", out.to_str().expect("a path in UTF-8")]);
        assert!(output.status.success(), "{output:?}");
        let page = std::fs::read_to_string(out.join("index.html")).expect("the page is written");
        (page, String::from_utf8(output.stdout).expect("UTF-8"))
    })
}

/// The names of the tags in order, `/` first where they close; without those that close themselves.
fn tags(page: &str) -> Vec<&str> {
    let tags = page.split('<').skip(1).filter_map(|tag| tag.split_once('>'));
    let tags = tags.map(|(tag, _)| tag).filter(|tag| !tag.starts_with('!') && !tag.ends_with('/'));
    let names = tags.map(|tag| tag.split_whitespace().next().unwrap_or(tag));
    names.filter(|name| *name != "meta").collect()
}

fn assert_balanced(page: &str) {
    let mut open = Vec::new();
    for tag in tags(page) {
        match tag.strip_prefix('/') {
            Some(closed) => assert_eq!(open.pop(), Some(closed), "in {open:?}"),
            None => open.push(tag),
        }
    }
    assert_eq!(open, Vec::<&str>::new());
}

#[test]
fn every_section_is_there_and_opens_with_its_claims() {
    let (page, _) = run();
    let titles = [
        "Drift",
        "Figures",
        "Long products",
        "Operation counts",
        "Times of products",
        "Interpolations",
        "Keyframes",
        "Derivatives of forward kinematics",
        "Dual numbers",
    ];
    for title in titles {
        assert!(page.contains(&format!(". {title}")), "{title}");
    }
    let sections = page.matches("<h2 ").count();
    assert_eq!(sections, titles.len());
    for heading in ["Tried", "Claimed", "Found", "Verdict"] {
        assert_eq!(page.matches(&format!("<h3>{heading}</h3>")).count(), sections, "{heading}");
    }
    assert!(page.matches("<svg").count() >= 6);
    assert!(page.contains("cargo run --release --manifest-path lab/Cargo.toml -- --out DIR"));
}

#[test]
fn no_two_texts_of_a_figure_overlap_and_none_leaves_it() {
    let (page, _) = run();
    assert_eq!(illegible(page), [""; 0]);
}

#[test]
fn the_page_is_well_formed_and_needs_no_other_file() {
    let (page, _) = run();
    assert_balanced(page);
    for nothing in ["NaN", "inf\"", "inf,", "<script", "src=", "@import", "href=\"http"] {
        assert!(!page.contains(nothing), "{nothing}");
    }
}

#[test]
fn headlines_are_printed_as_they_stand_on_the_page() {
    let (page, printed) = run();
    let lines: Vec<_> = printed.lines().filter_map(|line| line.strip_prefix("  ")).collect();
    assert!(lines.len() >= 20, "{printed}");
    for line in lines {
        assert!(page.contains(&lab::report::escape(line)), "{line}");
    }
}

#[test]
fn bad_arguments_give_usage_and_2() {
    for arguments in [&[][..], &["--out"], &["--in", "x"], &["--out", ""], &["--out", "a", "b"]] {
        let output = lab(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert_eq!(output.stderr, b"usage: lab --out DIR\n", "{arguments:?}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }
}

#[test]
fn a_directory_that_cannot_be_made_gives_1() {
    let file = scratch("a file");
    std::fs::write(&file, "no directory").expect("the scratch directory can be written");
    let output = lab(&["--out", file.to_str().expect("a path in UTF-8")]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).starts_with("cannot write "), "{output:?}");
}

fn chart(points: &[(f64, f64)]) -> Chart {
    let line = Series { name: "a < b".to_owned(), points: points.to_vec() };
    Chart {
        title: "x & y".to_owned(),
        x: "x".to_owned(),
        y: "y".to_owned(),
        logarithmic: true,
        series: vec![line],
    }
}

#[test]
fn charts_leave_out_what_is_no_number_and_refuse_to_draw_nothing() {
    let points =
        [(0.0, 1e-3), (1.0, f64::NAN), (2.0, 0.0), (3.0, -1.0), (4.0, 1.0), (f64::INFINITY, 1.0)];
    let svg = chart(&points).to_svg().expect("two points are left");
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    assert!(svg.contains("10⁻³") && svg.contains("10⁰"), "{svg}");
    assert_balanced(&svg);
    assert!(chart(&[]).to_svg().is_err());
    assert!(chart(&[(0.0, f64::NAN)]).to_svg().is_err());
    assert!(chart(&[(1.0, 1.0)]).to_svg().is_ok(), "a point has no width");
}

#[test]
fn text_is_escaped_everywhere() {
    let mut table = Table::new("<caption>", &["<heading>"]);
    table.row(["a < b & c"]);
    let text = "a < b";
    let section = Section {
        title: text,
        tried: text.to_owned(),
        claimed: vec![text],
        found: vec![text.to_owned()],
        verdict: text,
        body: table.to_html(),
    };
    let page = page(&[section]);
    assert_balanced(&page);
    assert_eq!(page.matches("a &lt; b").count(), 7, "{page}");
}

#[test]
fn numbers_stand_to_the_right_and_text_does_not() {
    let mut table = Table::new("", &["text", "number"]);
    table.row(["40° to 50°", "1.2·10⁻⁶"]);
    table.row(["", ""]);
    let html = table.to_html();
    assert!(html.contains("<td>40° to 50°</td>"), "{html}");
    assert!(html.contains("<td class=\"number\">1.2·10⁻⁶</td>"), "{html}");
    assert!(html.contains("<th>text</th><th class=\"number\">number</th>"), "{html}");
}

#[test]
fn numbers_are_written_for_people() {
    assert_eq!(power_of_ten(-16), "10⁻¹⁶");
    for (value, text) in [
        (1.25e-7, "1.2·10⁻⁷"),
        (-3.0, "−3.0·10⁰"),
        (0.0, "0"),
        (f64::INFINITY, "∞"),
        (f64::NEG_INFINITY, "−∞"),
        (f64::NAN, "–"),
    ] {
        assert_eq!(scientific(value), text);
    }
    for (value, text) in [(0.5, "0.500"), (999.0, "999.000"), (1e3, "1.0·10³"), (1e-3, "1.0·10⁻³")]
    {
        assert_eq!(decimal(value), text);
    }
}

/// No two lines of a chart may be taken for each other.
#[test]
fn every_line_of_a_chart_has_a_colour_of_its_own() {
    let line = |number: usize, y: f64| Series {
        name: format!("line {number}"),
        points: vec![(0.0, y), (1.0, 2.0 * y)],
    };
    // The last two lie on the first.
    let heights = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 1.0, 1.0];
    let series = heights.into_iter().enumerate().map(|(number, y)| line(number, y)).collect();
    let svg = Chart { series, ..chart(&[]) }.to_svg().expect("there are points");
    let colours: std::collections::BTreeSet<_> = svg
        .split("stroke=\"")
        .skip(1)
        .filter_map(|rest| rest.split_once('"').map(|(colour, _)| colour))
        .collect();
    // And that of the axes.
    assert!(colours.len() > heights.len(), "{colours:?}");
}
