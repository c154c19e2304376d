//! The report: one page of HTML that needs no other file.

mod chart;
mod table;

pub use chart::{Chart, Series};
pub use table::Table;

use core::fmt::Write;

/// A chapter of the report.
#[derive(Clone, Debug)]
pub struct Section {
    /// What stands in the table of contents; plain text.
    pub title: String,
    /// HTML: paragraphs, tables, charts.
    pub body: String,
}

/// The whole page.
#[must_use]
pub fn page(sections: &[Section]) -> String {
    let mut contents = String::new();
    let mut chapters = String::new();
    for (number, Section { title, body }) in (1..).zip(sections) {
        let title = escape(title);
        let _ = writeln!(contents, "<li><a href=\"#s{number}\">{title}</a></li>");
        let _ = writeln!(chapters, "<h2 id=\"s{number}\">{number}. {title}</h2>\n{body}");
    }
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n\
         <title>dq8: the laboratory</title>\n<style>{STYLE}</style>\n\
         <h1>dq8: the laboratory</h1>\n<ol>\n{contents}</ol>\n{chapters}</html>\n"
    )
}

/// Text as it stands in HTML.
#[must_use]
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

const STYLE: &str = "
body { font: 16px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; color: #222 }
h1, h2 { line-height: 1.2 } h2 { margin-top: 2.5em; border-bottom: 1px solid #ccc }
table { border-collapse: collapse; margin: 1em 0 } caption { text-align: left; font-weight: bold }
th, td { padding: .2em .8em; border-bottom: 1px solid #ddd; text-align: left }
td.number { text-align: right; font-variant-numeric: tabular-nums } svg { max-width: 100%; height: auto }
";
