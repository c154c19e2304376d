//! Tapes as theorems for Coq: that each number of an answer is off by what `bounds.toml` says.
//!
//! A theorem is about any reals of which each rounded one is within u of its operation, relatively,
//! for any u ≤ 2⁻²⁴: so it holds for `f32` and `f64`, where no product leaves the normal
//! range (`near_f32`, `near_f64` in `coq/rounding.v`). Arguments are vectors of length at most 1,
//! times a length. The proof is the running error analysis step by step, and at its end the
//! inequality of Cauchy and Schwarz, term by term with weights, which are found here and checked
//! there.

use crate::bound::Rounding;
use crate::fraction::{rational, weights};
use crate::operations::Operation;
use crate::polynomial::{Lengths, Matrix, Monomial, norm, unfoldings};
use crate::proof::Proof;
use crate::record::Record;
use crate::table::{self, ceiling};
use crate::tape::{FIRST_INPUT, Node, Tape};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;

/// Forms of more factors than this take Coq too long.
const FACTORS: usize = 3;
/// And these, of two trilinear forms in the same number, and of 55 numbers.
const SLOW: [&str; 2] = ["mul_rotation_translation", "linear_skin"];

/// Writes a file of theorems per operation, form and rounding of products.
///
/// # Errors
/// Of the file system.
pub fn write(folder: &Path) -> std::io::Result<()> {
    for record in Record::by_lengths().filter(|record| !record.is_twin()) {
        for precision in record.precisions() {
            let fused = if record.fused { "_fused" } else { "" };
            let suffix = format!("{fused}{}", ["", "_f64"][precision]);
            if let Some(theorems) = theorems(record, precision) {
                let name = format!("{}_{}{suffix}.v", record.form.name(), record.operation.name);
                std::fs::write(folder.join(name), theorems)?;
            }
        }
    }
    Ok(())
}

/// Whether there are theorems of a record, or of one that is the same.
#[must_use]
pub fn is_proved(record: &Record) -> bool {
    record.precisions().all(|precision| theorems(record, precision).is_some())
}

/// Of all numbers that are rounded; `None` where none is, or where one is not a form of few
/// factors.
fn theorems(record: &Record, precision: usize) -> Option<String> {
    let (operation, tape) = (record.operation, &record.tapes[precision]);
    let mut text = format!(
        "(* {} ({}{}), written by `cargo run -- coq`. *)\nFrom Coq Require Import Reals Psatz.\nRequire Import rounding.\nOpen Scope R_scope.\n",
        operation.name,
        record.form.name(),
        if record.fused { ", fused" } else { "" },
    );
    if SLOW.contains(&operation.name) {
        return None;
    }
    let parts = table::bounds(record);
    let analysis = record.analysis(precision, Rounding::Normal);
    let mut last = None;
    for (index, (&output, name)) in tape.outputs.iter().zip(operation.names()).enumerate() {
        let bound = parts.iter().find(|part| part.name == name)?.bound.as_ref()?;
        let proof = Proof::of(operation, tape, analysis, record.fused, output)?;
        if proof.done[&output].most.error.0.is_empty() {
            continue;
        }
        last = Some(format!("{}_{index}", operation.name));
        text += &Theorem { operation, tape, output, proof }.text(last.as_ref()?, bound)?;
    }
    let _ = writeln!(text, "Print Assumptions {}.", last?);
    Some(text)
}

/// That one number of an answer is off by no more than its bound.
struct Theorem<'a> {
    operation: &'a Operation,
    tape: &'a Tape,
    output: Node,
    proof: Proof<'a>,
}

impl Theorem<'_> {
    fn text(mut self, name: &str, bound: &Lengths) -> Option<String> {
        let of_inputs = self.operation.groups();
        let group = |input: u32| of_inputs[input as usize - FIRST_INPUT];
        let letter = |g: usize| self.operation.inputs[g].0;
        let known = self.proof.done[&self.output].clone();
        let unit = self.proof.root.map(|_| self.proof.unit(self.output));
        let (mut error, mut exact) = (known.most.error, known.exact.clone());
        let mut last = format!("apply (error u U0 _ _ _ _ _ B{}).", self.output);
        if unit.is_some() {
            let (node, more, plain) = self.proof.in_lengths(self.output)?;
            error = error.plus(1.0, &more);
            exact = plain;
            let near = &self.proof.done[&node];
            last = format!(
                "apply (scaled_back u); [positive |].\n  eapply (joined u U0 _ _ _ _ _ {exact} _ _ _ B{}); [| replace {exact} with {} by ring; exact B{node} |]; [field; nonzero |].",
                self.output, near.exact,
            );
        }
        if error.0.keys().any(|monomial| monomial.len() > FACTORS) {
            return None;
        }
        // Where terms cancel, the analysis of `bound.rs` sees it and this one does not.
        let found = error.by_lengths(&group, &|_| unreachable!("no roots here"));
        let stated = if let Some(unit) = &unit {
            let (sum, stated) = (found.0.values().sum::<f64>(), ceiling(bound.0.values().sum()));
            (bound.0.len() == 1 && sum <= stated)
                .then(|| Some(format!("{} * {}", rational(stated), unit.as_ref()?)))??
        } else {
            let terms = found.0.iter().map(|(powers, &c)| {
                let stated = ceiling(*bound.0.get(powers)?);
                let each = powers.iter().flat_map(|&(g, n)| std::iter::repeat_n(g, n as usize));
                let lengths = self.lengths(&each.collect::<Vec<_>>());
                (c <= stated).then(|| format!("{} * {lengths}", rational(stated)))
            });
            terms.collect::<Option<Vec<_>>>()?.join(" + ")
        };

        let used: BTreeSet<usize> =
            self.tape.inputs(&[self.output]).into_iter().map(group).collect();
        let mut text = format!("\nTheorem {name} (u");
        for &g in &used {
            let _ = write!(text, " l{}", letter(g));
            self.proof.inputs(g).for_each(|i| text += &format!(" x{i}"));
        }
        self.proof.roundings.iter().for_each(|(node, _)| text += &format!(" r{node}"));
        text += " : R)\n  (U0 : 0 <= u) (U1 : u <= / 16777216)";
        let squares = |g: usize, of: &dyn Fn(Node) -> String| {
            self.proof.inputs(g).map(of).collect::<Vec<_>>().join(" + ")
        };
        for &g in &used {
            let is_root = self.proof.root.is_some_and(|(_, group)| group == g);
            let _ = write!(
                text,
                "\n  (L{0} : 0 {1} l{0}) (N{0} : {2} {3} 1)",
                letter(g),
                if unit.is_some() { "<" } else { "<=" },
                squares(g, &|i| format!("x{i} * x{i}")),
                if is_root { "=" } else { "<=" },
            );
        }
        for (node, rounded) in &self.proof.roundings {
            let (rounded, result) = match unit {
                None => (rounded.clone(), format!("r{node}")),
                Some(_) => (
                    self.proof.in_units(rounded)?,
                    format!("({} * r{node})", self.proof.unit(*node)?),
                ),
            };
            let _ = write!(text, "\n  (O{node} : near u ({rounded}) {result})");
        }
        let difference = match &unit {
            None => format!("{} - {exact}", known.computed),
            Some(unit) => format!("{0} * {1} - {0} * {exact}", unit.as_ref()?, known.computed),
        };
        let _ = write!(
            text,
            " :\n  Rabs ({difference}) <= u * ({stated}).\nProof.\n{}  {last}\n  clear - U0 {}.\n  subst.\n",
            self.proof.steps,
            used.iter()
                .flat_map(|&g| {
                    let sizes = self.proof.inputs(g).filter(|i| self.proof.done.contains_key(i));
                    sizes.map(|i| format!(" Y{i}")).chain([format!(" L{0} N{0}", letter(g))])
                })
                .collect::<String>()
        );
        for &g in &used {
            let sum = squares(g, &|i| format!("Rabs x{i} * Rabs x{i}"));
            let _ = writeln!(text, "  assert (M{} : 0 <= {sum} <= 1).", letter(g));
            let same = self
                .proof
                .inputs(g)
                .map(|i| format!("pose proof (same_square x{i}); pose proof (Rle_0_sqr x{i}); "));
            let _ = writeln!(text, "  {{ {}unfold Rsqr in *; lra. }}", same.collect::<String>());
        }
        for (kind, ((groups, _), terms)) in error.kinds(&group).iter().enumerate() {
            let best = unfoldings(groups, terms, &group).min_by(|a, b| norm(a).total_cmp(&norm(b)));
            let Some(matrix) = best.filter(|_| !groups.is_empty()) else { continue };
            text += &self.inequality(kind, groups, &matrix, &group);
        }
        text += "  lra.\nQed.\n";
        Some(text)
    }

    /// A product of lengths.
    fn lengths(&self, groups: &[usize]) -> String {
        let letters: Vec<String> =
            groups.iter().map(|&g| format!("l{}", self.operation.inputs[g].0)).collect();
        if self.proof.root.is_some() || letters.is_empty() {
            "1".into()
        } else {
            format!("({})", letters.join(" * "))
        }
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
            "  assert (F{kind} : 0 <= {lengths}) by (repeat apply Rmult_le_pos; lra)."
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
