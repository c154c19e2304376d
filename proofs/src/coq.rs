//! Tapes as theorems for Coq: that each number of an answer is off by what `bounds.toml` says.
//!
//! A theorem is about any reals of which each rounded one is within u of its operation, relatively, for any u ≤ 2⁻²⁴: so it
//! holds for `f32` and `f64`, where no product leaves the normal range (`near_f32`, `near_f64` in `coq/rounding.v`). Arguments
//! are vectors of length at most 1, times a length. The proof is the running error analysis step by step, and at its end
//! the inequality of Cauchy and Schwarz, term by term with weights, which are found here and checked there.

use crate::fraction::{rational, weights};
use crate::operations::{Form, Operation};
use crate::polynomial::{Matrix, Monomial, Polynomial, norm, unfoldings};
use crate::table::{self, ceiling};
use crate::tape::{FIRST_INPUT, Node, Op, Tape};
use crate::{is_twin, tape_of};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;

/// Forms of more factors than this take Coq too long.
const FACTORS: usize = 3;
/// And this, of two trilinear forms in the same number.
const SLOW: &str = "mul_rotation_translation";

/// Writes a file of theorems per operation, form and rounding of products.
///
/// # Errors
/// Of the file system.
pub fn write(folder: &Path) -> std::io::Result<()> {
    for form in Form::ALL {
        for operation in
            form.operations().iter().filter(|operation| !is_twin(operation, form, true))
        {
            let [tape, other] = [true, false].map(|is_single| tape_of(operation, form, is_single));
            // `f64` with code of its own.
            if !other.is_same_as(&tape) {
                save(folder, operation, form, &other, false, "_f64")?;
            }
            for fused in if tape.fuses() { &[false, true][..] } else { &[false] } {
                save(folder, operation, form, &tape, *fused, if *fused { "_fused" } else { "" })?;
            }
        }
    }
    Ok(())
}

fn save(
    folder: &Path,
    operation: &Operation,
    form: Form,
    tape: &Tape,
    fused: bool,
    suffix: &str,
) -> std::io::Result<()> {
    let path = folder.join(format!("{}_{}{suffix}.v", form.name(), operation.name));
    theorems(operation, form, tape, fused).map_or(Ok(()), |theorems| std::fs::write(path, theorems))
}

/// Whether there are theorems of an operation, or of one that does the same, for single motions and for lanes.
#[must_use]
pub fn is_proved(operation: &Operation, form: Form, fused: bool) -> bool {
    let [single, double] = [true, false].map(|is_single| tape_of(operation, form, is_single));
    theorems(operation, form, &single, fused).is_some()
        && (double.is_same_as(&single) || theorems(operation, form, &double, false).is_some())
}

/// Of all numbers that are rounded; `None` where none is, or where one is not a form of few factors.
fn theorems(operation: &Operation, form: Form, tape: &Tape, fused: bool) -> Option<String> {
    let mut text = format!(
        "(* {} ({}{}), written by `cargo run -- coq`. *)\nFrom Coq Require Import Reals Psatz.\nRequire Import rounding.\nOpen Scope R_scope.\n",
        operation.name,
        form.name(),
        if fused { ", fused" } else { "" },
    );
    if operation.name == SLOW {
        return None;
    }
    let parts = table::bounds(operation, form, fused);
    let names = operation.parts.iter().flat_map(|&(name, count)| std::iter::repeat_n(name, count));
    let mut last = None;
    for (index, (&output, name)) in tape.outputs.iter().zip(names).enumerate() {
        let bound = parts.iter().find(|part| part.name == name)?.bound.as_ref()?;
        let (error, steps) = Proof::of(operation, tape, fused, output)?;
        if error.0.is_empty() {
            continue;
        }
        let group = |input: u32| operation.groups()[input as usize - FIRST_INPUT];
        let found = error.by_lengths(&group, &|_| unreachable!("no roots here"));
        if error.0.keys().any(|monomial| monomial.len() > FACTORS) {
            return None;
        }
        // Where terms cancel, the analysis of `bound.rs` sees it and this one does not.
        if found
            .0
            .iter()
            .any(|(powers, &c)| bound.0.get(powers).is_none_or(|&known| c > ceiling(known)))
        {
            return None;
        }
        // What this number depends on.
        let stated = found.0.keys().map(|powers| (powers.clone(), bound.0[powers])).collect();
        let stated = crate::polynomial::Lengths(stated);
        last = Some(format!("{}_{index}", operation.name));
        text += &steps.theorem(last.as_ref()?, &stated, &error, output);
    }
    let _ = writeln!(text, "Print Assumptions {}.", last?);
    Some(text)
}

/// The statement and the steps of one proof.
struct Proof<'a> {
    operation: &'a Operation,
    tape: &'a Tape,
    fused: bool,
    /// Of nodes that are done: computed and exact number as text, magnitude and error.
    done: BTreeMap<Node, (String, String, Polynomial, Polynomial)>,
    roundings: Vec<(String, String)>,
    steps: String,
}

impl<'a> Proof<'a> {
    fn of(
        operation: &'a Operation,
        tape: &'a Tape,
        fused: bool,
        output: Node,
    ) -> Option<(Polynomial, Self)> {
        let mut proof = Self {
            operation,
            tape,
            fused,
            done: BTreeMap::new(),
            roundings: vec![],
            steps: String::new(),
        };
        let needed = tape.needed(&[output]);
        for node in (0..tape.ops.len() as Node).filter(|&node| needed[node as usize]) {
            proof.step(node)?;
        }
        Some((proof.done[&output].3.clone(), proof))
    }

    fn letter(&self, input: Node) -> &'static str {
        self.operation.inputs[self.operation.groups()[input as usize - FIRST_INPUT]].0
    }

    fn step(&mut self, node: Node) -> Option<()> {
        let power = |node| self.tape.is_power_of_two(node);
        let name = format!("B{node}");
        match self.tape.ops[node as usize] {
            Op::Input => {
                let letter = self.letter(node);
                let text = format!("l{letter} * x{node}");
                let _ = writeln!(
                    self.steps,
                    "  pose proof (component u l{letter} x{node} L{letter}) as {name}."
                );
                let x = Polynomial::variable(node);
                self.done.insert(
                    node,
                    (format!("({text})"), format!("({text})"), x, Polynomial::default()),
                );
            }
            Op::Const(c) => {
                let (text, size) = (rational(c), rational(c.abs()));
                let _ = writeln!(
                    self.steps,
                    "  assert ({name} := constant u {text} {size} ltac:(lra) ltac:(lra))."
                );
                let size = Polynomial::constant(c.abs());
                self.done.insert(node, (text.clone(), text, size, Polynomial::default()));
            }
            Op::Neg(a) => {
                let (n, m, size, error) = self.done[&a].clone();
                let _ = writeln!(self.steps, "  pose proof (opposite u _ _ _ _ B{a}) as {name}.");
                self.done.insert(node, (format!("(- {n})"), format!("(- {m})"), size, error));
            }
            Op::Add(a, b) => {
                let sum = self.sum("plus", '+', a, b, &name);
                self.round(node, sum, name, a != b);
            }
            Op::Sub(a, b) => {
                let sum = self.sum("minus", '-', a, b, &name);
                self.round(node, sum, name, true);
            }
            Op::Mul(a, b) => {
                let rounds = !power(a) && !power(b);
                let product = self.product(a, b, &name);
                self.round(node, product, name, rounds);
            }
            Op::Fma(a, b, c) | Op::Nfma(a, b, c) => {
                let (inner, rounds) = (10_000 + node, !self.fused && !power(a) && !power(b));
                let product = self.product(a, b, &format!("B{inner}"));
                self.round(inner, product, format!("B{inner}"), rounds);
                let sum = if matches!(self.tape.ops[node as usize], Op::Fma(..)) {
                    self.sum("plus", '+', inner, c, &name)
                } else {
                    self.sum("minus", '-', c, inner, &name)
                };
                self.round(node, sum, name, true);
            }
            Op::Div(..) | Op::Sqrt(_) | Op::Abs(_) => return None,
        }
        Some(())
    }

    fn sum(
        &mut self,
        lemma: &str,
        sign: char,
        a: Node,
        b: Node,
        name: &str,
    ) -> (String, String, Polynomial, Polynomial) {
        let ((n, m, size, error), (n_, m_, size_, error_)) = (&self.done[&a], &self.done[&b]);
        let _ =
            writeln!(self.steps, "  pose proof ({lemma} u _ _ _ _ _ _ _ _ B{a} B{b}) as {name}.");
        let text = |a: &str, b: &str| format!("({a} {sign} {b})");
        (text(n, n_), text(m, m_), size.plus(1.0, size_), error.plus(1.0, error_))
    }

    fn product(
        &mut self,
        a: Node,
        b: Node,
        name: &str,
    ) -> (String, String, Polynomial, Polynomial) {
        let ((n, m, size, error), (n_, m_, size_, error_)) = (&self.done[&a], &self.done[&b]);
        let _ = writeln!(
            self.steps,
            "  pose proof (times u U0 U1 _ _ _ _ _ _ _ _ B{a} B{b}) as {name}."
        );
        let text = |a: &str, b: &str| format!("({a} * {b})");
        let first = size.times(error_).plus(1.0, &size_.times(error));
        (
            text(n, n_),
            text(m, m_),
            size.times(size_),
            first.plus(crate::bound::U, &error.times(error_)),
        )
    }

    fn round(
        &mut self,
        node: Node,
        (n, m, size, error): (String, String, Polynomial, Polynomial),
        name: String,
        rounds: bool,
    ) {
        if !rounds {
            self.done.insert(node, (n, m, size, error));
            return;
        }
        let _ = writeln!(
            self.steps,
            "  apply (rounded u U0 U1 _ _ _ _ r{node}) in {name}; [| exact O{node}]."
        );
        self.roundings.push((format!("r{node}"), format!("O{node} : near u {n} r{node}")));
        let error = error.plus(1.0, &size.plus(crate::bound::U, &error));
        self.done.insert(node, (format!("r{node}"), m, size, error));
    }

    fn theorem(
        &self,
        name: &str,
        bound: &crate::polynomial::Lengths,
        error: &Polynomial,
        output: Node,
    ) -> String {
        let of_inputs = self.operation.groups();
        let groups = &of_inputs[..];
        let group = |input: u32| groups[input as usize - FIRST_INPUT];
        let used: BTreeSet<usize> = self
            .done
            .keys()
            .filter(|&&node| self.tape.ops.get(node as usize) == Some(&Op::Input))
            .map(|&n| group(n))
            .collect();
        let inputs =
            |g: usize| (0..groups.len()).filter(move |&i| groups[i] == g).map(|i| i + FIRST_INPUT);
        let letter = |g: usize| self.operation.inputs[g].0;

        let mut text = format!("\nTheorem {name} (u");
        for &g in &used {
            let _ = write!(text, " l{}", letter(g));
            inputs(g).for_each(|i| {
                let _ = write!(text, " x{i}");
            });
        }
        self.roundings.iter().for_each(|(rounded, _)| {
            let _ = write!(text, " {rounded}");
        });
        text += " : R)\n  (U0 : 0 <= u) (U1 : u <= / 16777216)";
        for &g in &used {
            let squares: Vec<String> = inputs(g).map(|i| format!("x{i} * x{i}")).collect();
            let _ = write!(
                text,
                "\n  (L{0} : 0 <= l{0}) (N{0} : {1} <= 1)",
                letter(g),
                squares.join(" + ")
            );
        }
        self.roundings.iter().for_each(|(_, near)| {
            let _ = write!(text, "\n  ({near})");
        });
        let terms: Vec<String> = bound
            .0
            .iter()
            .map(|(powers, &c)| {
                let lengths = powers
                    .iter()
                    .flat_map(|&(g, power)| std::iter::repeat_n(g, power as usize))
                    .collect::<Vec<_>>();
                format!("{} * {}", rational(ceiling(c)), self.lengths(&lengths))
            })
            .collect();
        let (n, m, ..) = &self.done[&output];
        let _ = write!(
            text,
            " :\n  Rabs ({n} - {m}) <= u * ({}).\nProof.\n{}",
            terms.join(" + "),
            self.steps
        );
        let _ = writeln!(
            text,
            "  apply (error u U0 _ _ _ _ _ B{output}). clear -U0 {}.",
            used.iter().map(|&g| format!("L{0} N{0}", letter(g))).collect::<Vec<_>>().join(" ")
        );
        for &g in &used {
            let squares: Vec<String> =
                inputs(g).map(|i| format!("Rabs x{i} * Rabs x{i}")).collect();
            let _ =
                writeln!(text, "  assert (M{} : 0 <= {} <= 1).", letter(g), squares.join(" + "));
            let same: Vec<String> = inputs(g)
                .map(|i| format!("pose proof (same_square x{i}); pose proof (Rle_0_sqr x{i})"))
                .collect();
            let _ = writeln!(text, "  {{ {}; unfold Rsqr in *; lra. }}", same.join("; "));
        }
        for (kind, ((groups, _), terms)) in error.kinds(&group).iter().enumerate() {
            let best = unfoldings(groups, terms, &group).min_by(|a, b| norm(a).total_cmp(&norm(b)));
            let Some(matrix) = best.filter(|_| !groups.is_empty()) else { continue };
            text += &self.inequality(kind, groups, &matrix, &group);
        }
        text += "  lra.\nQed.\n";
        text
    }

    /// A product of lengths.
    fn lengths(&self, groups: &[usize]) -> String {
        let letters: Vec<String> =
            groups.iter().map(|&g| format!("l{}", self.operation.inputs[g].0)).collect();
        if letters.is_empty() { "1".into() } else { format!("({})", letters.join(" * ")) }
    }

    /// That the terms of one kind stay below the norm of their matrix, times the lengths.
    fn inequality(
        &self,
        kind: usize,
        groups: &[usize],
        matrix: &Matrix,
        group: &dyn Fn(u32) -> usize,
    ) -> String {
        let (lengths, mut text) = (self.lengths(groups), String::new());
        let _ = writeln!(
            text,
            "  assert (F{kind} : 0 <= {lengths}) by (repeat apply Rmult_le_pos; assumption)."
        );
        let product = |m: &Monomial| -> String {
            let factors: Vec<String> = m.iter().map(|v| format!("Rabs x{v}")).collect();
            if factors.is_empty() { "1".into() } else { format!("({})", factors.join(" * ")) }
        };
        for ((row, column), weight) in weights(matrix) {
            let weighted =
                format!("weighted {weight} {} {} ltac:(lra)", product(&row), product(&column));
            let _ = writeln!(text, "  pose proof (Rmult_le_compat_l _ _ _ F{kind} ({weighted})).");
        }
        let Some(((row, column), _)) = matrix.first_key_value() else { return text };
        for side in [row, column].map(|side| side.iter().map(|&v| group(v)).collect::<Vec<_>>()) {
            let balls = side.iter().map(|&g| format!("M{}", self.operation.inputs[g].0));
            if let Some(ball) = balls.reduce(|a, b| format!("(in_ball _ _ {a} {b})")) {
                let _ = writeln!(
                    text,
                    "  pose proof (Rmult_le_compat_l _ _ _ F{kind} (proj2 {ball}))."
                );
            }
            // Squares in the ball that the matrix has no row or column of.
            let mut products = vec![vec![]];
            for &g in &side {
                let of = &self.operation.groups();
                let inputs =
                    (0..of.len()).filter(|&i| of[i] == g).map(|i| (i + FIRST_INPUT) as Node);
                products = inputs
                    .flat_map(|v| products.iter().map(move |m: &Monomial| [&m[..], &[v]].concat()))
                    .collect();
            }
            for square in products.iter().filter(|square| !square.is_empty()) {
                let _ = writeln!(text, "  pose proof (square _ {} F{kind}).", product(square));
            }
        }
        text
    }
}
