//! The report: one page of HTML that needs no other file.

mod chart;
mod number;
mod table;

pub use chart::{Chart, Series};
pub use number::{decimal, power_of_ten, scientific};
pub use table::Table;

use core::fmt::Write;

/// A chapter of the report. All but `body` is plain text.
#[derive(Clone, Debug)]
pub struct Section {
    /// What stands in the table of contents.
    pub title: &'static str,
    /// What is tried.
    pub tried: String,
    /// What the sources claim, each with its section.
    pub claimed: Vec<&'static str>,
    /// What was found, with numbers; also printed while the laboratory runs.
    pub found: Vec<String>,
    /// Whether the claims hold.
    pub verdict: &'static str,
    /// HTML: paragraphs, tables, charts.
    pub body: String,
}

impl Section {
    fn opening(&self) -> String {
        fn list(entries: &[impl AsRef<str>]) -> String {
            let items =
                entries.iter().map(|entry| format!("<li>{}</li>\n", escape(entry.as_ref())));
            format!("<ul>\n{}</ul>\n", items.collect::<String>())
        }
        format!(
            "<h3>Tried</h3>\n{}<h3>Claimed</h3>\n{}<h3>Found</h3>\n{}<h3>Verdict</h3>\n{}",
            paragraph(&self.tried),
            list(&self.claimed),
            list(&self.found),
            paragraph(self.verdict),
        )
    }
}

/// Plain text as a paragraph.
pub fn paragraph(text: &str) -> String {
    format!("<p>{}</p>\n", escape(text))
}

/// The whole page.
pub fn page(sections: &[Section]) -> String {
    let mut contents = String::new();
    let mut chapters = String::new();
    for (number, section) in (1..).zip(sections) {
        let title = escape(section.title);
        let _ = writeln!(contents, "<li><a href=\"#s{number}\">{title}</a></li>");
        let _ = writeln!(
            chapters,
            "<h2 id=\"s{number}\">{number}. {title}</h2>\n{}{}",
            section.opening(),
            section.body
        );
    }
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <title>dq8: the laboratory</title>\n<style>{STYLE}</style>\n</head>\n<body>\n\
         <h1>dq8: the laboratory</h1>\n{INTRODUCTION}<ol>\n{contents}</ol>\n{chapters}</body>\n</html>\n"
    )
}

/// Text as it stands in HTML.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

const INTRODUCTION: &str = "
<p>dq8 computes with rigid motions as dual quaternions: eight numbers σ = p + εq, ε² = 0, that turn by
the quaternion p and translate by 2qp*. Its sources compare this with matrices, quaternions and Euler
angles, and claim things. Here the claims are tried out.</p>
<p>Every number and curve below is computed when this page is written, by</p>
<pre>cargo run --release --manifest-path lab/Cargo.toml -- --out DIR</pre>
<p>and does not depend on chance, nor, but for the times of products, on the machine. The sources are: Kenwright, <cite>A Beginners Guide to
Dual-Quaternions</cite> (2012); Arends, a thesis on quaternions, dual quaternions and hyper-dual
quaternions (in Dutch; §4.5 is chapter 4, section 5); Jia, <cite>Dual Quaternions</cite>; Tarini, course
slides; Fabisch, <cite>Normalizing Dual Quaternions</cite>.</p>
";

const STYLE: &str = "
body { font: 16px/1.5 sans-serif; max-width: 70em; margin: 2em auto; padding: 0 1em; color: #222 }
h1, h2 { line-height: 1.2 } h2 { margin-top: 2.5em; border-bottom: 1px solid #ccc }
h3 { margin: 1em 0 .2em; font-size: 1em } h3 + p, h3 + ul { margin-top: 0 }
pre { background: #f4f4f4; padding: .5em 1em }
table { border-collapse: collapse; margin: 1.5em 0; font-size: .85em; line-height: 1.35 }
caption { text-align: left; white-space: nowrap; font-weight: bold; padding-bottom: .3em }
th, td { padding: .25em .6em; border-bottom: 1px solid #ddd; text-align: left; vertical-align: top }
th { vertical-align: bottom } tr:hover { background: #f8f8f8 }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums }
td.number { white-space: nowrap }
svg { max-width: 100%; height: auto; margin: .5em 0 }
";
