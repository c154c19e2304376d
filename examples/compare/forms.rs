//! [`Form`]: what has one name in a contest.

use crate::results::Row;

/// The columns of its times. All but the last are what names of contenders end with: the names of
/// backends, also of those that this machine lacks.
pub(crate) const COLUMNS: [&str; 3] = ["AVX-512", "AVX2", "default build"];

/// A peer, or a form of dq8 with all instructions that it ran with.
#[derive(Debug)]
pub(crate) struct Form<'a> {
    pub(crate) name: &'a str,
    pub(crate) is_own: bool,
    /// Nanoseconds, one for each of [`COLUMNS`].
    pub(crate) least: [Option<f64>; COLUMNS.len()],
}

/// dq8 first, then its peers; both the fastest first, as `rows` are.
pub(crate) fn forms<'a>(rows: &[&'a Row]) -> Vec<Form<'a>> {
    let mut forms: Vec<Form<'_>> = Vec::new();
    for row in rows {
        let (name, column) = parts(row);
        let place = forms.iter().position(|form| form.name == name).unwrap_or_else(|| {
            forms.push(Form { name, is_own: row.is_own(), least: [None; COLUMNS.len()] });
            forms.len() - 1
        });
        forms[place].least[column] = Some(row.min);
    }
    forms.sort_by_key(|form| !form.is_own);
    forms
}

/// The name that a row shares with others, and its column.
fn parts(row: &Row) -> (&str, usize) {
    let name = row.contender.as_str();
    let last = COLUMNS.len() - 1;
    if !row.is_own() {
        return (name, last);
    }
    let instructions = COLUMNS[..last].iter().chain(&["portable"]);
    let mut with = instructions.enumerate();
    with.find_map(|(column, said)| Some((name.strip_suffix(said)?.trim_end(), column)))
        .unwrap_or((name, last))
}
