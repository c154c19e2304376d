//! `bounds.toml`: every bound, as it is computed from the tapes.

use crate::bound::Rounding;
use crate::composed::{self, FAR};
use crate::coq::is_proved;
use crate::gappa::lemmas;
use crate::operations::Operation;
use crate::polynomial::Lengths;
use crate::range::{Range, range};
use crate::record::Record;

/// A bound of one part of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its name.
    pub name: &'static str,
    /// |computed − exact| of each number ≤ u times this; `None` beyond what is analysed.
    pub bound: Option<Lengths>,
}

/// The bounds of a record, by the lengths of its arguments; the larger where the two precisions
/// have code of their own.
#[must_use]
pub fn bounds(record: &Record) -> Vec<Part> {
    let mut parts: Vec<Part> = vec![];
    for precision in record.precisions() {
        let analysis = record.analysis(precision, Rounding::Normal);
        let composed = composed::of(record, precision, analysis);
        for (output, name) in record.operation.names().enumerate() {
            let one = match &composed {
                Some(bounds) => Some(bounds[output].clone()),
                None => analysis.bound(record.tapes[precision].outputs[output]),
            };
            match (parts.iter_mut().find(|part| part.name == name), one) {
                (None, bound) => parts.push(Part { name, bound }),
                (Some(Part { bound: Some(bound), .. }), Some(one)) => bound.worst(&one),
                (Some(part), _) => part.bound = None,
            }
        }
    }
    parts
}

/// The next thousandth: terms of second order show.
pub(crate) fn ceiling(c: f64) -> f64 {
    (c * 1000.0).ceil() / 1000.0
}

/// A bound as text: 4.01|p||s| + 4.01|q||r|.
#[must_use]
pub fn formula(operation: &Operation, bound: &Lengths) -> String {
    let length = |&(group, power): &(usize, i32)| {
        let name = format!("|{}|", operation.inputs.get(group).map_or("z", |input| input.0));
        match power {
            1 => name,
            _ => format!("{name}^{power}"),
        }
    };
    let terms: Vec<String> = bound
        .0
        .iter()
        .map(|(powers, &c)| {
            format!("{}{}", ceiling(c), powers.iter().map(length).collect::<String>())
        })
        .collect();
    if terms.is_empty() { "0".into() } else { terms.join(" + ") }
}

/// The whole file.
#[must_use]
pub fn text() -> String {
    let mut text = String::from(
        "# Bounds of rounding errors, computed from the code by `cargo run -- bounds`; tests/bounds.rs compares.\n\
         # |computed - exact| of every number of a part <= u times its bound, u = 2^-24 (f32) or 2^-53 (f64), where exact is\n\
         # the formula on the given floats; |p| is the length of the argument, and |z| that of the real part of a weighted sum that is\n\
         # normalized, or moves a point (bounds above 16000 are none). On the ordinary path (README.md);\n\
         # lengths: nothing overflows if no argument is longer (f32 f64), and none that is divided by is shorter than one over\n\
         # that; underflow: what is added where products are below the normal numbers, in units of 2^-150 (f32) or 2^-1075 (f64).\n\
         # by = \"Coq\" where run.sh has theorems of it, for all numbers that are rounded; tapes: prints of the operations of f32\n\
         # and f64, which change with any. gappa: the largest error of any number of the answer in units of u, as Gappa proves it\n\
         # step by step, where rotations have lengths within 2^-9 of 1, all other arguments are no longer than 1, and functions\n\
         # are of one number in the range of their polynomials.\n",
    );
    for record in Record::all() {
        text += &section(record);
    }
    text
}

fn section(record: &Record) -> String {
    let mut text = format!("\n[{}]\n", record.name());
    let mut line = |name: &str, is: String| text += &format!("{name} = {is}\n");
    if record.is_by_lengths() {
        let formula = |bound: &Lengths| format!("\"{}\"", formula(record.operation, bound));
        for part in bounds(record) {
            line(part.name, part.bound.map_or("\"none\"".into(), |bound| formula(&bound)));
        }
        if let Some(Range { powers: [single, double], underflow }) = range(record) {
            line("lengths", format!("\"2^{single} 2^{double}\""));
            underflow.iter().for_each(|underflow| line("underflow", formula(underflow)));
        }
    }
    let [single, double] = [0, 1].map(|precision: usize| record.tapes[precision].fingerprint());
    line("tapes", format!("\"{single:08x} {double:08x}\""));
    let units = [24, 53].into_iter().enumerate();
    let units = units.map(|(i, bits)| Some(ceiling(lemmas(record, i).bound? * 2_f64.powi(bits))));
    if let Some(units) = units.collect::<Option<Vec<_>>>()
        && units[0].max(units[1]) <= FAR
    {
        line("gappa", format!("{:?}", units[0].max(units[1])));
    }
    if record.is_by_lengths() && is_proved(record) {
        line("by", "\"Coq\"".into());
    }
    text
}
