//! Tapes as lemmas for Gappa, one per operation of a tape: from what is known of its operands, how
//! far the rounded result is off from the exact one. Many are the same for many tapes, and are
//! proved once.
//!
//! Gappa sees intervals of single numbers. What it cannot see is that they are parts of vectors of
//! a length, so each exact number comes with the bound that follows from that (Cauchy and Schwarz),
//! as a hypothesis; `coq/` has it as a lemma. So do the comparisons that chose the path.

use crate::bound::{Analysis, Rounding};
use crate::interval::{Range, number, up, up_to};
use crate::operations::{Operation, end};
use crate::polynomial::Lengths;
use crate::record::Record;
use crate::tape::{FIRST_INPUT, Node, Op, Order, Tape};
use std::collections::BTreeSet;

/// How far the length of a rotation is from 1: |p| ∈ [1 − 2⁻⁹, 1 + 2⁻⁹].
const NEAR: f64 = 1.0 / 512.0;

/// What Gappa is to prove of a tape.
#[derive(Debug)]
pub struct Lemmas {
    /// The largest error of a number of the answer; `None` where one is divided by what may be 0.
    pub bound: Option<f64>,
    /// What follows one from the other.
    pub scripts: BTreeSet<String>,
}

/// Writes those of every operation, form, precision and rounding of products.
///
/// # Errors
/// Of the file system.
pub fn write(folder: &str) -> std::io::Result<()> {
    let each = Record::all().iter().flat_map(|record| [lemmas(record, 0), lemmas(record, 1)]);
    let scripts: BTreeSet<String> = each.flat_map(|lemmas| lemmas.scripts).collect();
    let mut numbered = scripts.iter().enumerate();
    numbered.try_for_each(|(i, lemma)| std::fs::write(format!("{folder}/{i}.g"), lemma))
}

/// Those of one tape.
#[must_use]
pub fn lemmas(record: &Record, precision: usize) -> Lemmas {
    let tape = &record.tapes[precision];
    let (known, scripts) = (vec![None; tape.ops.len()], BTreeSet::new());
    // Intervals cannot tell how far from 0 a sum is, nor that the turns of an angle are whole.
    if record.last(precision).is_some() || record.operation.name.ends_with("_turn") {
        return Lemmas { bound: None, scripts };
    }
    let analysis = record.analysis(precision, Rounding::Normal);
    let (operation, fused, is_single) = (record.operation, record.fused, precision == 0);
    let mut steps = Steps { operation, tape, analysis, is_single, fused, known, scripts };
    // Of constants alone nothing is asked.
    let of_inputs = tape.branches.iter().filter(|branch| !tape.inputs(&branch.sides).is_empty());
    let chosen_by = of_inputs.flat_map(|branch| branch.sides);
    let needed = tape.needed(&tape.outputs.iter().copied().chain(chosen_by).collect::<Vec<_>>());
    for node in (0..tape.ops.len() as Node).filter(|&node| needed[node as usize]) {
        steps.known[node as usize] = steps.step(node);
    }
    let errors = tape.outputs.iter().map(|&output| Some(steps.known[output as usize]?.error));
    let bound = errors.collect::<Option<Vec<f64>>>().map(|e| e.into_iter().fold(0.0, f64::max));
    // What leads nowhere is not asked for.
    Lemmas { scripts: if bound.is_some() { steps.scripts } else { BTreeSet::new() }, bound }
}

/// What is known of a number.
#[derive(Clone, Copy, Debug)]
struct Known {
    exact: Range,
    /// How far the computed one is off.
    error: f64,
    /// Where that is: rounding is monotone, and does not leave an interval whose ends are floats.
    computed: Range,
}

impl Known {
    /// Whether the range of the computed number says more than that of the exact one.
    fn is_nearer(&self) -> bool {
        let near = self.exact.wider(self.error);
        self.error > 0.0 && self.computed.both(near.short()) != near.short()
    }
    /// In a script: itself, or computed (n) and exact (M) where the two differ.
    fn name(&self, name: &str, prefix: &str) -> String {
        match self.exact {
            Range(c, same) if c == same => number(c),
            _ if self.error == 0.0 => format!("x{name}"),
            _ => format!("{prefix}{name}"),
        }
    }
}

struct Steps<'a> {
    operation: &'a Operation,
    tape: &'a Tape,
    analysis: &'a Analysis,
    is_single: bool,
    fused: bool,
    known: Vec<Option<Known>>,
    scripts: BTreeSet<String>,
}

impl Steps<'_> {
    /// The lengths of an argument: rotations are nearly unit, all else is at most 1.
    fn length(&self, group: usize) -> Range {
        match self.operation.inputs[group] {
            ("v", 1) => Range(0.0, end(self.operation.name)),
            ("p" | "r", 4) => Range(1.0 - NEAR, 1.0 + NEAR),
            _ => Range(0.0, 1.0),
        }
    }

    /// Where an exact number is, from the lengths of the arguments.
    fn by_lengths(&self, node: Node) -> Option<Range> {
        if let Some((_, group)) = self.analysis.sums().find(|sum| sum.0 == node) {
            return Some(self.length(group).times(self.length(group)).short());
        }
        let most = |lengths: &Lengths| {
            let terms = lengths.0.iter().map(|(powers, c)| {
                let power = |&(group, power): &(usize, i32)| {
                    let Range(shortest, longest) = self.length(group);
                    if power < 0 { shortest.powi(power) } else { longest.powi(power) }
                };
                c * powers.iter().map(power).product::<f64>()
            });
            terms.sum::<f64>() * (1.0 + 1e-9)
        };
        let size = most(self.analysis.size(node)?);
        // Polarization: |a − b|² ≤ |a|² + |b|² where a·b ≥ 0.
        let not_below = self.tape.branches.iter().filter_map(|branch| {
            let [dot, zero] = branch.sides.map(|side| self.known[side as usize]);
            let is_met = !branch.holds && zero?.exact == Range(0.0, 0.0);
            let sum = self.analysis.size_of_sum(node, 2.0, branch.sides[0]).filter(|_| is_met)?;
            Some(most(&sum) + 2.0 * dot?.error)
        });
        Some(Range(-size, not_below.fold(size, f64::min)).short())
    }

    /// What a comparison of a number with a constant says of the exact one.
    fn on_path(&self, node: Node, Known { mut exact, error, mut computed }: Known) -> Known {
        for branch in self.tape.branches.iter().filter(|branch| branch.order != Order::Equal) {
            let [left, right] = branch.sides;
            for (of, with, is_below) in [(left, right, branch.holds), (right, left, !branch.holds)]
            {
                match self.tape.ops[with as usize] {
                    Op::Const(c) if of == node && is_below => {
                        (exact.1, computed.1) = (exact.1.min(c + error), computed.1.min(c));
                    }
                    Op::Const(c) if of == node => {
                        (exact.0, computed.0) = (exact.0.max(c - error), computed.0.max(c));
                    }
                    _ => {}
                }
            }
        }
        Known { exact: exact.short(), error, computed: computed.short() }
    }

    fn step(&mut self, node: Node) -> Option<Known> {
        let exactly = |exact| Known { exact, error: 0.0, computed: exact };
        let known = match self.tape.ops[node as usize] {
            Op::Const(c) => return Some(exactly(Range(c, c))),
            Op::Input => {
                let group = self.operation.groups()[node as usize - FIRST_INPUT];
                let Range(_, longest) = self.length(group);
                let is_alone = self.operation.inputs[group] == ("v", 1);
                exactly(Range(if is_alone { 0.0 } else { -longest }, longest))
            }
            op => self.lemma(node, op)?,
        };
        Some(self.on_path(node, known))
    }

    /// The lemma of one operation, and what it says: the same in numbers, which Gappa is to
    /// confirm.
    fn lemma(&mut self, node: Node, op: Op) -> Option<Known> {
        let operands = op.operands();
        let [rounds_product, rounds] = self.tape.roundings(node, self.fused, 0.0);
        let known: Vec<Known> =
            operands.iter().map(|&operand| self.known[operand as usize]).collect::<Option<_>>()?;
        let exact: Vec<Range> = known.iter().map(|known| known.exact).collect();
        let computed: Vec<Range> = known.iter().map(|known| known.computed).collect();
        let most = |i: usize| exact[i].size();
        let error = |i: usize| known[i].error;
        let of_product = || {
            let both = error(0) * error(1);
            let sum = most(0) * error(1) + most(1) * error(0) + both;
            if both == 0.0 { sum } else { sum.next_up() }
        };

        let mut slack = 0.0;
        let mut off = match op {
            Op::Add(..) | Op::Sub(..) => error(0) + error(1),
            Op::Mul(..) => of_product(),
            Op::Fma(..) | Op::Nfma(..) => {
                if rounds_product {
                    slack = self.half_unit(computed[0].times(computed[1]).size());
                }
                of_product() + slack + error(2)
            }
            Op::Div(..) => {
                let quotient = Range::of(op, &exact, 0.0)?.size();
                ((error(0) + quotient * error(1)) / computed[1].0).next_up()
            }
            Op::Sqrt(_) => (error(0) / (computed[0].0.sqrt() + exact[0].0.sqrt())).next_up(),
            _ => error(0),
        };
        let (range, given) = (Range::of(op, &exact, 0.0)?, self.by_lengths(node));
        let given = given.filter(|given| given.both(range) != range);
        let range = given.map_or(range, |given| given.both(range)).short();
        let direct = Range::of(op, &computed, slack)?;
        if rounds {
            // A little more than a power of two has the next unit.
            let by_exact = if off == 0.0 { range.size() } else { (range.size() + off).next_up() };
            off += self.half_unit(by_exact.min(direct.size()));
        }
        let error = up(off);
        let near = range.wider(error).short();
        let direct =
            if error == 0.0 { range } else { Range(-up_to(20, -direct.0), up_to(20, direct.1)) };
        let result = Known { exact: range, error, computed: near.both(direct) };
        if !error.is_finite() {
            return None;
        }
        if matches!(op, Op::Abs(_)) {
            // Gappa has no rule that an absolute value is off by no more than its operand:
            // `absolute` in `rounding.v`.
            return Some(result);
        }

        let names: Vec<&str> = operands
            .iter()
            .map(|operand| {
                ["a", "b", "c"][operands.iter().position(|other| other == operand).unwrap_or(0)]
            })
            .collect();
        let named = |prefix: &str| -> Vec<String> {
            names.iter().zip(&known).map(|(name, known)| known.name(name, prefix)).collect()
        };
        let (exact, plain) =
            (expression(op, &named("M"), false), expression(op, &named("n"), rounds_product));
        let (mut hypotheses, mut hints) = (BTreeSet::new(), BTreeSet::new());
        for (name, known) in
            names.iter().zip(&known).filter(|(_, known)| known.exact.0 != known.exact.1)
        {
            hypotheses.insert(format!("{} in {}", known.name(name, "M"), known.exact));
            if known.error > 0.0 {
                hypotheses.insert(format!("|n{name} - M{name}| <= {}", number(known.error)));
                hints.insert(format!("n{name} -> M{name} + (n{name} - M{name});"));
            }
            if known.is_nearer() {
                hypotheses.insert(format!("n{name} in {}", known.computed));
            }
        }
        let computed = if rounds { format!("rnd({plain})") } else { plain.clone() };
        let mut goal = format!("|{computed} - ({exact})| <= {}", number(error));
        if result.is_nearer() {
            goal += &format!(" /\\ {computed} in {}", result.computed);
        }
        if let (Op::Div(..), [over, under]) = (op, &known[..])
            && over.error.min(under.error) > 0.0
        {
            // As `off` has it; by itself Gappa cuts the range into thousands.
            let [a, b] = [names[0], names[1]];
            hints.insert(format!("n{a} / n{b} -> M{a} / M{b} + (n{a} / n{b} - M{a} / M{b});"));
            hints.insert(format!(
                "n{a} / n{b} - M{a} / M{b} -> ((n{a} - M{a}) - (M{a} / M{b}) * (n{b} - M{b})) / n{b} {{ n{b} <> 0, M{b} <> 0 }};"
            ));
        }
        if given.is_none() {
            goal += &format!(" /\\ {exact} in {range}");
        } else {
            hypotheses.insert(format!("{exact} in {range}"));
            if plain != exact {
                hints.insert(format!("{plain} -> {exact} + ({plain} - ({exact}));"));
            }
        }
        let joined = |set: BTreeSet<String>, by| set.into_iter().collect::<Vec<_>>().join(by);
        let arrow = if hypotheses.is_empty() { "" } else { "\n  -> " };
        self.scripts.insert(format!(
            "#@ -Echange-threshold=0\n@rnd = float<ieee_{},ne>;\n{{ {}{goal} }}\n{}\n",
            if self.is_single { 32 } else { 64 },
            // Of constants nothing is supposed.
            joined(hypotheses, " /\\ ") + arrow,
            joined(hints, "\n")
        ));
        Some(result)
    }

    /// Half a unit in the last place of numbers up to this.
    fn half_unit(&self, most: f64) -> f64 {
        let (bits, least) = if self.is_single { (25, -150) } else { (54, -1075) };
        2_f64.powi((most.log2().ceil() as i32).saturating_sub(bits).max(least))
    }
}

/// An operation in Gappa's words, before it is rounded.
fn expression(op: Op, n: &[String], rounds_product: bool) -> String {
    let product = || {
        let product = format!("{} * {}", n[0], n[1]);
        if rounds_product { format!("rnd({product})") } else { product }
    };
    match op {
        Op::Input | Op::Const(_) => unreachable!("computed from nothing"),
        Op::Add(..) => format!("{} + {}", n[0], n[1]),
        Op::Sub(..) => format!("{} - {}", n[0], n[1]),
        Op::Mul(..) => product(),
        Op::Fma(..) => format!("{} + {}", product(), n[2]),
        Op::Nfma(..) => format!("{} - {}", n[2], product()),
        Op::Div(..) => format!("{} / {}", n[0], n[1]),
        Op::Sqrt(_) => format!("sqrt({})", n[0]),
        Op::Neg(_) => format!("-{}", n[0]),
        Op::Abs(_) => format!("|{}|", n[0]),
    }
}
