//! [`Bars`]: what has one name in a panel.

use crate::results::Row;

/// A peer, or a form of dq8 with every kind of instructions that it ran with.
#[derive(Debug)]
pub(crate) struct Bars<'a> {
    pub(crate) name: &'a str,
    /// In the order of the instructions.
    pub(crate) rows: Vec<(&'a Row, Kind)>,
}

/// How the bar is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Kind {
    pub(crate) class: &'static str,
    /// Beside the number.
    pub(crate) said: &'static str,
}

const PEER: Kind = Kind { class: "peer", said: "" };
const SCALAR: Kind = Kind { class: "scalar", said: "" };
/// What the names of contenders end with. The names of backends, also of those that this machine
/// lacks.
const INSTRUCTIONS: [Kind; 3] = [
    Kind { class: "avx512", said: "AVX-512" },
    Kind { class: "avx2", said: "AVX2" },
    Kind { class: "portable", said: "portable" },
];

/// dq8 first, then its peers; both the fastest first, as `rows` are.
pub(crate) fn bars<'a>(rows: &[&'a Row]) -> Vec<Bars<'a>> {
    let mut bars: Vec<Bars<'_>> = Vec::new();
    for row in rows {
        let (name, kind) = parts(row);
        match bars.iter_mut().find(|bars| bars.name == name) {
            Some(bars) => bars.rows.push((row, kind)),
            None => bars.push(Bars { name, rows: vec![(row, kind)] }),
        }
    }
    for bars in &mut bars {
        // A constant order is easier to read than the times, which differ little.
        bars.rows.sort_by_key(|(_, kind)| INSTRUCTIONS.iter().position(|other| other == kind));
    }
    bars.sort_by_key(|bars| bars.rows[0].1 == PEER);
    bars
}

/// The name that a row shares with others, and what is its own.
fn parts(row: &Row) -> (&str, Kind) {
    let name = row.contender.as_str();
    if !row.is_own() {
        return (name, PEER);
    }
    let mut with = INSTRUCTIONS.into_iter();
    with.find_map(|kind| Some((name.strip_suffix(kind.said)?.trim_end(), kind)))
        .unwrap_or((name, SCALAR))
}
