//! Tapes as scripts for Gappa: every number twice, rounded and exact, and what the difference of the two stays below.
//!
//! Gappa sees intervals of single numbers. What it cannot see is that they are parts of vectors of a length, so each exact
//! number comes with the bound that follows from that (Cauchy and Schwarz), as a hypothesis; `coq/` has it as a lemma.

use crate::bound::Analysis;
use crate::composed;
use crate::operations::{Form, Operation, functions};
use crate::tape::{Node, Op, Tape};
use crate::{is_twin, tape_of};
use std::fmt::Write;
use std::path::Path;

/// How far the length of a rotation is from 1: |p| ∈ [1 − 2⁻⁹, 1 + 2⁻⁹].
const NEAR: f64 = 1.0 / 512.0;

/// Writes scripts per operation, form, precision and rounding of products, one for each number of the answer: Gappa takes three
/// times as long for all of them at once.
///
/// # Errors
/// Of the file system.
pub fn write(folder: &Path) -> std::io::Result<()> {
    for form in Form::ALL.into_iter().chain([Form::Function]) {
        for operation in form.operations() {
            for is_single in
                [true, false].into_iter().filter(|&is_single| !is_twin(operation, form, is_single))
            {
                let tape = tape_of(operation, form, is_single);
                // Intervals cannot tell how far from 0 a sum is.
                if composed::sum(operation, &tape, form, is_single).is_some() {
                    continue;
                }
                for fused in if tape.fuses() { &[false, true][..] } else { &[false] } {
                    let float = if is_single { "f32" } else { "f64" };
                    let rounding = if *fused { ".fused" } else { "" };
                    let name = format!("{}.{}{rounding}.{float}", form.name(), operation.name);
                    let scripts = scripts(operation, form, &tape, is_single, *fused);
                    for (index, script) in scripts.into_iter().enumerate() {
                        std::fs::write(folder.join(format!("{name}.{index}.g")), script)?;
                    }
                }
            }
        }
    }
    Ok(())
}

/// The lengths of an argument: rotations are nearly unit, all else is at most 1.
fn lengths(operation: &Operation, form: Form) -> Vec<(f64, f64)> {
    let of = |&(name, count): &(&str, usize)| {
        if matches!(form, Form::Function) {
            (0.0, functions::end(operation.name))
        } else if count == 4 && matches!(name, "p" | "r") {
            (1.0 - NEAR, 1.0 + NEAR)
        } else {
            (0.0, 1.0)
        }
    };
    operation.inputs.iter().map(of).collect()
}

/// Those of numbers that are rounded.
fn scripts(
    operation: &Operation,
    form: Form,
    tape: &Tape,
    is_single: bool,
    fused: bool,
) -> Vec<String> {
    let groups = operation.groups();
    let analysis = Analysis::of(tape, &groups, fused);
    let lengths = lengths(operation, form);
    let is_rounded = |&output: &Node| {
        !matches!(tape.ops[output as usize], Op::Input | Op::Const(_))
            && analysis.bound(output).is_none_or(|b| !b.0.is_empty())
    };
    let precision = if is_single { 32 } else { 64 };
    let of = |output| {
        let claim = claim(tape, output, form, fused, &groups, &analysis, &lengths);
        format!("@rnd = float<ieee_{precision},ne>;\n{claim}")
    };
    tape.outputs.iter().copied().filter(is_rounded).map(of).collect()
}

/// What leads to a number, and how far it may be off.
fn claim(
    tape: &Tape,
    output: Node,
    form: Form,
    fused: bool,
    groups: &[usize],
    analysis: &Analysis,
    lengths: &[(f64, f64)],
) -> String {
    let needed = tape.needed(&[output]);
    let steps: Vec<Node> =
        (0..tape.ops.len() as Node).filter(|&node| needed[node as usize]).collect();

    let mut text = String::new();
    for &node in &steps {
        if tape.ops[node as usize] == Op::Input {
            let _ = writeln!(text, "x{node} = rnd(x{node}_);");
        }
    }
    for prefix in ["n", "M"] {
        for &node in &steps {
            if let Some(expression) = expression(tape, node, prefix, fused) {
                let _ = writeln!(text, "{prefix}{node} = {expression};");
            }
        }
    }
    let (mut given, mut hints) = (vec![], vec![]);
    for &node in &steps {
        match tape.ops[node as usize] {
            Op::Input => {
                let (_, longest) = lengths[groups[node as usize - crate::tape::FIRST_INPUT]];
                given.push(match form {
                    Form::Function => format!("x{node} in [0, {}]", number(longest)),
                    _ => format!("|x{node}| <= {}", number(longest)),
                });
            }
            Op::Const(_) | Op::Neg(_) => {}
            _ => {
                // Of one number intervals know more.
                let size = if form == Form::Function { None } else { analysis.size(node) };
                let Some(bound) = size else { continue };
                let most = bound.0.iter().map(|(powers, c)| {
                    let power = |&(group, power): &(usize, i32)| {
                        let (shortest, longest) = lengths[group];
                        if power < 0 { shortest.powi(power) } else { longest.powi(power) }
                    };
                    c * powers.iter().map(power).product::<f64>()
                });
                given.push(format!("|M{node}| <= {}", up(most.sum::<f64>() * (1.0 + 1e-9))));
                hints.push(format!("n{node} -> M{node} + (n{node} - M{node});"));
            }
        }
    }
    for (sum, group) in analysis.sums().filter(|&(sum, _)| needed[sum as usize]) {
        let (shortest, longest) = lengths[group];
        given.push(format!(
            "M{sum} in [{}, {}]",
            number(shortest * shortest),
            number(longest * longest)
        ));
    }
    let goal = format!("|n{output} - M{output}| in ?");
    let _ = writeln!(text, "{{ {}\n  -> {goal} }}", given.join("\n  /\\ "));
    text.extend(hints.into_iter().map(|hint| hint + "\n"));
    text
}

/// What a node is, of rounded or exact numbers; `None` of what has another name.
fn expression(tape: &Tape, node: Node, prefix: &str, fused: bool) -> Option<String> {
    let n = |node: Node| match tape.ops[node as usize] {
        Op::Input => format!("x{node}"),
        Op::Const(c) => number(c),
        _ => format!("{prefix}{node}"),
    };
    let rounded = |text: String| if prefix == "n" { format!("rnd({text})") } else { text };
    let product = |a: Node, b: Node| {
        let product = format!("{} * {}", n(a), n(b));
        if fused || tape.is_power_of_two(a, 0.0) || tape.is_power_of_two(b, 0.0) {
            product
        } else {
            rounded(product)
        }
    };
    Some(match tape.ops[node as usize] {
        Op::Input | Op::Const(_) => return None,
        Op::Add(a, b) if a == b => format!("2 * {}", n(a)),
        Op::Add(a, b) => rounded(format!("{} + {}", n(a), n(b))),
        Op::Sub(a, b) => rounded(format!("{} - {}", n(a), n(b))),
        Op::Mul(a, b) if tape.is_power_of_two(a, 0.0) || tape.is_power_of_two(b, 0.0) => {
            format!("{} * {}", n(a), n(b))
        }
        Op::Mul(a, b) => rounded(format!("{} * {}", n(a), n(b))),
        Op::Fma(a, b, c) => rounded(format!("{} + {}", product(a, b), n(c))),
        Op::Nfma(a, b, c) => rounded(format!("{} - {}", n(c), product(a, b))),
        Op::Div(a, b) => rounded(format!("{} / {}", n(a), n(b))),
        Op::Sqrt(a) => rounded(format!("sqrt({})", n(a))),
        Op::Neg(a) => format!("-{}", n(a)),
        Op::Abs(a) => format!("|{}|", n(a)),
    })
}

/// A number exactly: m·2ᵉ.
fn number(c: f64) -> String {
    if c == c.trunc() && c.abs() < 1e15 {
        return format!("{c:.0}");
    }
    let bits = c.abs().to_bits();
    let (mut exponent, mut digits) = ((bits >> 52) as i64 - 1075, bits & ((1 << 52) - 1) | 1 << 52);
    while digits.is_multiple_of(2) {
        digits /= 2;
        exponent += 1;
    }
    format!("{}{digits}b{exponent}", if c < 0.0 { "-" } else { "" })
}

/// The next number of 20 bits.
fn up(c: f64) -> String {
    if c == 0.0 {
        return "0".into();
    }
    let step = 2_f64.powi(c.log2().floor() as i32 - 20);
    number((c / step).ceil() * step)
}
