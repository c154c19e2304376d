use super::escape;
use core::fmt::Write;

/// A table with a caption and a row of headings.
#[derive(Clone, Debug)]
pub struct Table {
    caption: String,
    headings: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// Without rows yet.
    pub fn new(caption: &str, headings: &[&str]) -> Self {
        let headings = headings.iter().map(ToString::to_string).collect();
        Self { caption: caption.to_owned(), headings, rows: Vec::new() }
    }

    /// With one row more, a cell for each heading; plain text.
    pub fn row<C: ToString>(&mut self, cells: impl IntoIterator<Item = C>) {
        let row: Vec<_> = cells.into_iter().map(|cell| cell.to_string()).collect();
        assert_eq!(row.len(), self.headings.len(), "a cell for each heading: {row:?}");
        self.rows.push(row);
    }

    /// Numbers stand to the right, and so do headings of nothing but numbers and blanks.
    pub fn to_html(&self) -> String {
        let mut html = format!("<table><caption>{}</caption>\n<tr>", escape(&self.caption));
        for (column, heading) in self.headings.iter().enumerate() {
            let mut cells =
                self.rows.iter().map(|row| &row[column]).filter(|cell| !cell.is_empty());
            let class = class(cells.all(|cell| is_number(cell)));
            let _ = write!(html, "<th{class}>{}</th>", escape(heading));
        }
        html.push_str("</tr>\n");
        for row in &self.rows {
            html.push_str("<tr>");
            for cell in row {
                let _ = write!(html, "<td{}>{}</td>", class(is_number(cell)), escape(cell));
            }
            html.push_str("</tr>\n");
        }
        html.push_str("</table>\n");
        html
    }
}

fn class(number: bool) -> &'static str {
    if number { " class=\"number\"" } else { "" }
}

/// As [`decimal`](super::decimal) writes them.
fn is_number(cell: &str) -> bool {
    cell.chars().all(|c| c.is_numeric() || ".·⁻−–∞".contains(c))
}
