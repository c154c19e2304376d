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
    #[must_use]
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

    /// Cells that begin like numbers stand to the right.
    #[must_use]
    pub fn to_html(&self) -> String {
        let mut html = format!("<table><caption>{}</caption>\n<tr>", escape(&self.caption));
        for heading in &self.headings {
            let _ = write!(html, "<th>{}</th>", escape(heading));
        }
        html.push_str("</tr>\n");
        for row in &self.rows {
            html.push_str("<tr>");
            for cell in row {
                let number = cell.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '−');
                let class = if number { " class=\"number\"" } else { "" };
                let _ = write!(html, "<td{class}>{}</td>", escape(cell));
            }
            html.push_str("</tr>\n");
        }
        html.push_str("</table>\n");
        html
    }
}
