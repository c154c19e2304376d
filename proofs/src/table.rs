//! `bounds.toml`: every bound, as it is computed from the tapes.

use crate::bound::Analysis;
use crate::composed;
use crate::coq::is_proved;
use crate::gappa::lemmas;
use crate::operations::{Form, Operation};
use crate::polynomial::Lengths;
use crate::range::{Range, range};
use crate::tape::Tape;
use crate::tape_of;
use std::fmt::Write;

/// A bound of one part of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its name.
    pub name: &'static str,
    /// |computed − exact| of each number ≤ u times this; `None` beyond what is analysed.
    pub bound: Option<Lengths>,
}

/// The bounds of an operation in a form, by the lengths of its arguments.
#[must_use]
pub fn bounds(operation: &Operation, form: Form, fused: bool) -> Vec<Part> {
    // Where the two precisions have code of their own, the larger counts.
    let tapes = [true, false].map(|is_single| tape_of(operation, form, is_single));
    let tapes = if tapes[0].is_same_as(&tapes[1]) { &tapes[..1] } else { &tapes };
    let mut parts: Vec<Part> = vec![];
    for name in operation.names() {
        if parts.iter().all(|part| part.name != name) {
            parts.push(Part { name, bound: Some(Lengths::default()) });
        }
    }
    for (tape, is_single) in tapes.iter().zip([true, false]) {
        let analysis = Analysis::of(tape, &operation.groups(), fused);
        let composed = composed::sum(operation, tape, form, is_single)
            .and_then(|sum| composed::of(operation, &analysis, &sum, form, fused));
        for (output, name) in operation.names().enumerate() {
            let one = match &composed {
                Some(bounds) => Some(bounds[output].clone()),
                None => analysis.bound(tape.outputs[output]),
            };
            for part in parts.iter_mut().filter(|part| part.name == name) {
                match (&mut part.bound, &one) {
                    (Some(bound), Some(one)) => bound.worst(one),
                    _ => part.bound = None,
                }
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
    for form in Form::ALL {
        for operation in form.operations() {
            let by_lengths = Form::BY_LENGTHS.contains(&form);
            let tapes = [true, false].map(|is_single| tape_of(operation, form, is_single));
            let fuses = tapes.iter().any(Tape::fuses);
            let [single, double] = tapes.map(|tape| tape.fingerprint());
            for fused in [false, true] {
                if fused && !fuses {
                    continue;
                }
                let rounding = if fused { ".fused" } else { "" };
                let _ = writeln!(text, "\n[{}.{}{rounding}]", form.name(), operation.name);
                for part in by_lengths.then(|| bounds(operation, form, fused)).into_iter().flatten()
                {
                    let formula =
                        part.bound.map_or("none".into(), |bound| formula(operation, &bound));
                    let _ = writeln!(text, "{} = \"{formula}\"", part.name);
                }
                if let Some(Range { powers: [single, double], underflow }) =
                    by_lengths.then(|| range(operation, form, fused)).flatten()
                {
                    let _ = writeln!(text, "lengths = \"2^{single} 2^{double}\"");
                    if let Some(underflow) = underflow {
                        let _ =
                            writeln!(text, "underflow = \"{}\"", formula(operation, &underflow));
                    }
                }
                let _ = writeln!(text, "tapes = \"{single:08x} {double:08x}\"");
                let units = [true, false].map(|is_single| {
                    let bound = lemmas(operation, form, is_single, fused).bound?;
                    Some(ceiling(bound / 2_f64.powi(if is_single { -24 } else { -53 })))
                });
                if let [Some(single), Some(double)] = units {
                    let _ = writeln!(text, "gappa = {:?}", single.max(double));
                }
                if by_lengths && is_proved(operation, form, fused) {
                    text += "by = \"Coq\"\n";
                }
            }
        }
    }
    text
}
