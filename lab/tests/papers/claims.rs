//! `docs/claims.md` against the tests: every section of every source has a row, every row a verdict
//! and a name of its own, every test it names exists, and `lab/mutations.toml` says what falsifies
//! it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The sections of each source, under its heading in `docs/claims.md`. Tarini's slides and Arends'
/// chapters without sections stand by themselves; Fabisch's headings have no numbers.
const SECTIONS: [(&str, &str); 5] = [
    (
        "Kenwright",
        "abstract; §1; §2; §2.1; §2.2; §3; §3.1; §3.2; §3.3; §3.3.1; §3.3.2; §3.3.3; §3.3.4; §3.4; §3.4.1; \
         §3.4.2; §3.5; §3.5.1; §3.5.2; §3.6; §4; §5; §5.1; §5.2; §6; §6.1; §6.2; §7; §7.1; §8; §9; §10; \
         §10.1; §10.2; §11; §12; §13; §13.1; §13.2; §14",
    ),
    (
        "Fabisch",
        "opening; Background; Quaternion Product; Quaternion Conjugate; Quaternion Product with Conjugate; \
         Dual Quaternion Product; Dual Quaternion Conjugate; Norm of a Dual Quaternion; Example (norm); \
         Normalization Procedure (Direct Solution); Inverse Square Root of a Dual Number; Normalization; \
         Side Note: Two Solutions; Example (normalization); Edge Case; Normalization in Two Steps; \
         Geometrical Interpretation; Mistakes",
    ),
    (
        "Arends",
        "ch. 1; ch. 2; ch. 2 §1; ch. 2 §2; ch. 2 §3; ch. 2 §4; ch. 2 §5; ch. 2 §6; ch. 2 §7; ch. 2 §7.1; \
         ch. 2 §7.2; ch. 2 §7.3; ch. 3; ch. 3 §1; ch. 3 §2; ch. 3 §3; ch. 3 §4; ch. 4; ch. 4 §1; ch. 4 §2; \
         ch. 4 §3; ch. 4 §4; ch. 4 §5; ch. 5; ch. 5 §1; ch. 5 §2; ch. 5 §3; ch. 5 §4; ch. 5 §5; ch. 5 §6; \
         ch. 5 §6.1; ch. 5 §6.2; ch. 5 §6.3; ch. 6; conclusion; appendix A",
    ),
    ("Jia", "§1; §2; §3; §4; §5; §6; §7; §8; §8.1; §8.2; §9; §10; §11; references"),
    (
        "Tarini",
        "slide 110; slide 111; slide 112; slide 113; slide 114; slide 115; slide 116; slide 117; slide 118; \
         slide 119; slide 120; slide 121; slide 122; slide 123; slide 124; slide 125; slide 126; slide 127",
    ),
];

/// What every row begins with behind the source: no other word opens a verdict.
const VERDICTS: [&str; 7] =
    ["holds", "misprint", "no claim", "not checkable", "opinion", "silent", "wrong"];

struct Row {
    source: String,
    /// What it is called in `lab/mutations.toml`: the source and the first cell.
    name: String,
    /// The section, without what stands behind a comma.
    section: String,
    place: String,
    verdict: String,
    line: usize,
}

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// A file of the repository.
fn read(name: &str) -> String {
    let path = root().join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn rows() -> Vec<Row> {
    rows_of(&read("docs/claims.md"))
}

/// The rows of the tables below each heading `## Source`.
fn rows_of(text: &str) -> Vec<Row> {
    let (mut rows, mut source) = (Vec::new(), String::new());
    for (line, text) in text.lines().enumerate().map(|(index, text)| (index + 1, text)) {
        if let Some(heading) = text.strip_prefix("## ") {
            source = heading.split(',').next().unwrap_or(heading).to_owned();
        }
        if source.is_empty() {
            // The table of verdicts stands before the sources.
            continue;
        }
        let Some(cells) = text.strip_prefix('|').and_then(|text| text.strip_suffix('|')) else {
            continue;
        };
        let cells: Vec<_> = cells.split('|').map(str::trim).collect();
        assert_eq!(cells.len(), 4, "line {line} has not four cells: {text}");
        if cells[0] == "section" || cells[0].starts_with("---") {
            continue;
        }
        rows.push(Row {
            source: source.clone(),
            name: format!("{source} {}", cells[0]),
            section: cells[0].split(',').next().unwrap_or("").to_owned(),
            place: cells[2].to_owned(),
            verdict: cells[3].to_owned(),
            line,
        });
    }
    assert!(rows.len() > 100, "{} rows only", rows.len());
    rows
}

/// What stands between backticks.
fn quoted(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

/// The functions below a `#[test]`, whatever attributes and comments stand between.
fn tests_of(path: &Path) -> Option<BTreeSet<String>> {
    let text = std::fs::read_to_string(path).ok()?;
    let (mut names, mut marked) = (BTreeSet::new(), false);
    for line in text.lines().map(str::trim) {
        if line == "#[test]" {
            marked = true;
        } else if let Some(signature) = line.strip_prefix("fn ") {
            let name = signature.split(['(', '<']).next().unwrap_or("");
            if std::mem::take(&mut marked) {
                names.insert(name.to_owned());
            }
        }
    }
    Some(names)
}

#[test]
fn every_section_of_the_sources_has_a_row_and_every_row_a_section() {
    let rows = rows();
    let mut wrong = Vec::new();
    for (source, sections) in SECTIONS {
        let sections: BTreeSet<_> = sections.split(';').map(str::trim).collect();
        let written: Vec<_> = rows.iter().filter(|row| row.source == source).collect();
        let named: BTreeSet<_> = written.iter().map(|row| row.section.as_str()).collect();
        wrong.extend(
            sections.difference(&named).map(|section| format!("{source} {section}: no row")),
        );
        let unknown = written.iter().filter(|row| !sections.contains(row.section.as_str()));
        wrong
            .extend(unknown.map(|row| {
                format!("line {}: {source} has no section {:?}", row.line, row.section)
            }));
    }
    let sources = SECTIONS.map(|(source, _)| source);
    let elsewhere = rows.iter().filter(|row| !sources.contains(&row.source.as_str()));
    wrong.extend(elsewhere.map(|row| format!("line {}: no source {:?}", row.line, row.source)));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_row_has_a_verdict() {
    let without = rows()
        .into_iter()
        .filter(|row| !VERDICTS.iter().any(|verdict| row.verdict.starts_with(verdict)));
    let lines: Vec<_> =
        without.map(|row| format!("line {}: {:?}", row.line, row.verdict)).collect();
    assert!(lines.is_empty(), "{}", lines.join("\n"));
}

/// A claim that holds or is wrong was checked somewhere.
#[test]
fn every_verdict_on_the_matter_names_a_place() {
    let unchecked = rows().into_iter().filter(|row| {
        let on_the_matter = row.verdict.starts_with("holds") || row.verdict.starts_with("wrong");
        on_the_matter && quoted(&row.place).next().is_none()
    });
    let lines: Vec<_> = unchecked.map(|row| format!("line {}", row.line)).collect();
    assert!(lines.is_empty(), "{}", lines.join("\n"));
}

/// The rows that a change of the library or of the laboratory falsifies, or that say why there is
/// none. `scripts/falsify.py --check` looks closer, at the tests, and without `--check` makes the
/// changes.
fn accounted_for() -> BTreeSet<String> {
    let table = read("lab/mutations.toml");
    let mut names = BTreeSet::new();
    for entry in table.split("\n[[") {
        let formula = entry.contains("\nfile = \"src/") || entry.contains("\nfile = \"lab/src/");
        let list = entry.split_once("\nrows = [").and_then(|(_, rest)| rest.split_once("\n]"));
        let reason = entry.split_once("\nrow = ").and_then(|(_, rest)| rest.split_once("\n"));
        let (rows, reason) = (list.filter(|_| formula), reason.filter(|(_, why)| !why.is_empty()));
        for (text, _) in rows.into_iter().chain(reason) {
            names.extend(text.split('"').skip(1).step_by(2).map(str::to_owned));
        }
    }
    names
}

/// Names of rows on the matter that are not accounted for, or that another row has.
fn unfalsified(rows: &[Row]) -> Vec<&str> {
    let (known, mut seen) = (accounted_for(), BTreeSet::new());
    let wrong = rows.iter().filter(|row| {
        let on_the_matter = row.verdict.starts_with("holds") || row.verdict.starts_with("wrong");
        !seen.insert(&row.name) || (on_the_matter && !known.contains(&row.name))
    });
    wrong.map(|row| row.name.as_str()).collect()
}

#[test]
fn every_row_on_the_matter_has_a_name_of_its_own_and_a_change_that_falsifies_it() {
    assert_eq!(unfalsified(&rows()), [""; 0]);
}

#[test]
fn a_row_about_the_moon_is_refused_whatever_test_it_names() {
    let text = read("docs/claims.md");
    let (inverse, cells) = (
        "| §4, inverse |",
        "the moon is made of cheese | `lab/tests/papers/jia.rs::eq_14_the_product_in_whole_numbers` | holds |",
    );
    for (name, wanted) in [("§4, moon", "Jia §4, moon"), ("§4, inverse", "Jia §4, inverse")] {
        let longer = text.replacen(inverse, &format!("| {name} | {cells}\n{inverse}"), 1);
        assert_eq!(unfalsified(&rows_of(&longer)), [wanted]);
    }
}

#[test]
fn every_test_that_is_named_exists() {
    let mut known: BTreeMap<PathBuf, Option<BTreeSet<String>>> = BTreeMap::new();
    let mut missing = Vec::new();
    for row in rows() {
        for place in quoted(&row.place) {
            let (file, test) = place.split_once("::").unzip();
            let path = root().join(file.unwrap_or(place));
            let tests = known.entry(path).or_insert_with_key(|path| tests_of(path));
            let why = match (tests, test) {
                (None, _) => "no such file",
                (Some(tests), Some(test)) if !tests.contains(test) => "no such test",
                _ => continue,
            };
            missing.push(format!("line {}: {place}: {why}", row.line));
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

/// A claim that is checked has a row: no test of a paper stands for none.
#[test]
fn every_test_of_a_paper_is_named_by_a_row() {
    let named: BTreeSet<String> = rows()
        .iter()
        .flat_map(|row| quoted(&row.place).map(str::to_owned).collect::<Vec<_>>())
        .collect();
    let folder = root().join("lab/tests/papers");
    let mut orphans = Vec::new();
    for entry in std::fs::read_dir(&folder).expect("the folder of this file").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name == "claims.rs" || name == "main.rs" {
            continue;
        }
        let tests = tests_of(&entry.path()).unwrap_or_default();
        let places = tests.into_iter().map(|test| format!("lab/tests/papers/{name}::{test}"));
        orphans.extend(places.filter(|place| !named.contains(place)));
    }
    assert!(orphans.is_empty(), "{}", orphans.join("\n"));
}
