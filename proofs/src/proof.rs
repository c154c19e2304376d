//! [`Proof`]: the running error analysis of one number, step by step, in the words of Coq.
//!
//! Where a length is divided by or a root is taken, everything is in units of the lengths: |p| = 1,
//! and each rounded number is its unit times a number. The root of the computed |p|² is `h`, exact
//! while roots and quotients go through the steps, so that their errors cancel; how far it is from
//! 1 enters at the end ([`Proof::in_lengths`]), as in `bound.rs`.

use crate::bound::{Analysis, Bounded};
use crate::fraction::rational;
use crate::operations::Operation;
use crate::polynomial::{Polynomial, Sum, as_root};
use crate::tape::{FIRST_INPUT, Node, Op, Tape};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// How far the root of a computed |p|² = 1 is from 1 at most, as `root` of `coq/rounding.v` has
/// it.
const NEAR: f64 = 1.0 + 1e-6;

/// What is known of a number.
#[derive(Clone)]
pub(crate) struct Known {
    /// As it is computed.
    pub(crate) computed: String,
    /// Without rounding.
    pub(crate) exact: String,
    /// Its size, and its error.
    pub(crate) most: Bounded,
}

impl Known {
    /// Of a number without error.
    fn exactly(text: &str, size: Polynomial) -> Self {
        Self { computed: text.into(), exact: text.into(), most: Bounded::exactly(size) }
    }
}

/// The steps of one proof.
pub(crate) struct Proof<'a> {
    operation: &'a Operation,
    tape: &'a Tape,
    analysis: &'a Analysis,
    fused: bool,
    /// The sum of squares whose root is taken, and its argument.
    pub(crate) root: Option<(Node, usize)>,
    /// Of nodes that are done.
    pub(crate) done: BTreeMap<Node, Known>,
    /// What is rounded, and what is rounded to it.
    pub(crate) roundings: Vec<(Node, String)>,
    pub(crate) steps: String,
}

impl<'a> Proof<'a> {
    /// The steps to one number; `None` of what they have no words for.
    pub(crate) fn of(
        operation: &'a Operation,
        tape: &'a Tape,
        analysis: &'a Analysis,
        fused: bool,
        output: Node,
    ) -> Option<Self> {
        let needed = tape.needed(&[output]);
        let nodes = || (0..tape.ops.len() as Node).filter(|&node| needed[node as usize]);
        let divides = |node: Node| matches!(tape.ops[node as usize], Op::Div(..) | Op::Sqrt(_));
        let root = nodes().any(divides).then(|| analysis.sums().next()).flatten();
        let (done, roundings, steps) = (BTreeMap::new(), vec![], String::new());
        let mut proof = Self { operation, tape, analysis, fused, root, done, roundings, steps };
        for node in nodes() {
            proof.step(node)?;
        }
        Some(proof)
    }

    fn group(&self, input: Node) -> usize {
        self.operation.groups()[input as usize - FIRST_INPUT]
    }

    fn say(&mut self, line: &str) {
        let _ = writeln!(self.steps, "  {line}");
    }

    /// By a lemma about two numbers.
    fn pose(&mut self, node: Node, lemma: &str, operator: char, [a, b]: [Node; 2], most: Bounded) {
        self.say(&format!("pose proof ({lemma} _ _ _ _ _ _ _ _ B{a} B{b}) as B{node}."));
        let (a, b) = (&self.done[&a], &self.done[&b]);
        let text = |a: &str, b: &str| format!("({a} {operator} {b})");
        let (computed, exact) = (text(&a.computed, &b.computed), text(&a.exact, &b.exact));
        self.done.insert(node, Known { computed, exact, most });
    }

    fn step(&mut self, node: Node) -> Option<()> {
        let [rounds_product, rounds] = self.tape.roundings(node, self.fused, 0.0);
        match self.tape.ops[node as usize] {
            Op::Input => {
                let letter = self.operation.inputs[self.group(node)].0;
                let (text, lemma) = match self.root {
                    Some(_) => (format!("x{node}"), format!("given u x{node}")),
                    None => (
                        format!("(l{letter} * x{node})"),
                        format!("component u l{letter} x{node} L{letter}"),
                    ),
                };
                self.say(&format!(
                    "destruct ({lemma}) as (y{node} & Y{node} & P{node} & B{node})."
                ));
                self.done.insert(node, Known::exactly(&text, Polynomial::variable(node)));
            }
            Op::Const(c) => self.constant(node, c),
            Op::Neg(a) => self.opposite(node, a),
            Op::Add(a, b) => self.sum(node, 1.0, a, b),
            Op::Sub(a, b) => self.sum(node, -1.0, a, b),
            Op::Mul(a, b) => self.product(node, a, b),
            Op::Fma(a, b, c) | Op::Nfma(a, b, c) => {
                let inner = 10_000 + node;
                self.product(inner, a, b);
                if rounds_product {
                    self.round(inner)?;
                }
                match self.tape.ops[node as usize] {
                    Op::Fma(..) => self.sum(node, 1.0, inner, c),
                    _ => self.sum(node, -1.0, c, inner),
                }
            }
            Op::Sqrt(a) if self.is_sum(a) => {
                self.say(&format!("pose proof H_ as B{node}."));
                self.done.insert(node, Known::exactly("h", Polynomial::constant(NEAR)));
                return self.near(node, &format!("sqrt r{a}"), &format!("rewrite R_ in O{node}."));
            }
            Op::Div(one, a) if self.tape.ops[one as usize] == Op::Const(1.0) && self.is_sum(a) => {
                self.say(&format!("pose proof (times u U0 U1 _ _ _ _ _ _ _ _ K_ K_) as B{node}."));
                let size = Polynomial::constant(NEAR * NEAR);
                self.done.insert(node, Known::exactly("(/ h * / h)", size));
                let rewritten = format!("rewrite Q_, over_square in O{node}.");
                return self.near(node, &format!("1 / r{a}"), &rewritten);
            }
            Op::Div(one, a)
                if self.tape.ops[one as usize] == Op::Const(1.0) && self.done[&a].exact == "h" =>
            {
                let text = format!("1 / r{a}");
                self.say(&format!("pose proof (over u U0 U1 _ _ _ _ B{a} H1) as B{node}."));
                self.say(&format!("specialize (B{node} ltac:(lra))."));
                let error = self.done[&a].most.error.scaled(1.0 + 1e-5);
                let most = Bounded { value: Polynomial::constant(2.0 * NEAR - 1.0), error };
                let (computed, exact) = (text.clone(), "/ h".into());
                self.done.insert(node, Known { computed, exact, most });
                return self.near(node, &text, "");
            }
            Op::Div(..) | Op::Sqrt(_) | Op::Abs(_) => return None,
        }
        if rounds {
            self.round(node)?;
        }
        if self.is_sum(node) {
            self.take_root(node);
        }
        Some(())
    }

    fn is_sum(&self, node: Node) -> bool {
        self.root.is_some_and(|(sum, _)| sum == node)
    }

    fn constant(&mut self, node: Node, c: f64) {
        let (text, size) = (rational(c), rational(c.abs()));
        self.say(&format!("assert (B{node} := constant u {text} {size} ltac:(lra) ltac:(lra))."));
        self.done.insert(node, Known::exactly(&text, Polynomial::constant(c.abs())));
    }

    fn opposite(&mut self, node: Node, a: Node) {
        self.say(&format!("pose proof (opposite u _ _ _ _ B{a}) as B{node}."));
        let Known { computed, exact, most } = self.done[&a].clone();
        let (computed, exact) = (format!("(- {computed})"), format!("(- {exact})"));
        self.done.insert(node, Known { computed, exact, most });
    }

    fn sum(&mut self, node: Node, sign: f64, a: Node, b: Node) {
        let (lemma, operator) = if sign > 0.0 { ("plus u", '+') } else { ("minus u", '-') };
        let most = self.done[&a].most.plus(1.0, &self.done[&b].most);
        self.pose(node, lemma, operator, [a, b], most);
    }

    fn product(&mut self, node: Node, a: Node, b: Node) {
        let most = self.done[&a].most.times(&self.done[&b].most);
        self.pose(node, "times u U0 U1", '*', [a, b], most);
    }

    fn round(&mut self, node: Node) -> Option<()> {
        let text = self.done[&node].computed.clone();
        self.near(node, &text, "")
    }

    /// One rounding, of what the code computes as `text`; in units of lengths first.
    fn near(&mut self, node: Node, text: &str, rewritten: &str) -> Option<()> {
        if self.root.is_some() {
            let unit = self.unit(node)?;
            self.say(&format!(
                "apply (scaled u {unit} _ ({text}) r{node} ltac:(positive)) in O{node}; [| in_units]. {rewritten}"
            ));
        }
        self.say(&format!(
            "apply (rounded u U0 U1 _ _ _ _ r{node}) in B{node}; [| exact O{node}]."
        ));
        self.roundings.push((node, text.into()));
        let known = self.done.get_mut(&node)?;
        known.computed = format!("r{node}");
        known.most = known.most.clone().rounded();
        self.shorten(node);
        Some(())
    }

    /// Size and error as polynomials, in numbers that are not negative: what is made of them stays
    /// short.
    fn shorten(&mut self, node: Node) {
        let Bounded { value, error } = &self.done[&node].most;
        let (size, error) = (up(value), up(error));
        let monomials = || [&size, &error].into_iter().flat_map(|p| p.0.keys());
        let kept: BTreeSet<_> = monomials().flatten().map(|v| format!(" P{v}")).collect();
        let kept =
            if kept.is_empty() { String::new() } else { format!(" -{}", String::from_iter(kept)) };
        let positive: BTreeSet<_> =
            monomials().filter_map(|m| m.iter().map(|v| format!("P{v}")).reduce(times)).collect();
        let positive = positive.into_iter().map(|fact| format!("pose proof {fact}; "));
        let steps = format!("clear{kept}; {}lra", positive.collect::<String>());
        self.say(&format!(
            "apply (weaker u U0 _ _ _ _ ({}) ({})) in B{node}; [| {steps} | {steps}].",
            text_of(&size),
            text_of(&error),
        ));
        if let Some(known) = self.done.get_mut(&node) {
            known.most = Bounded { value: size, error };
        }
    }

    /// From the computed sum of squares to its root.
    fn take_root(&mut self, sum: Node) {
        let relative =
            self.done[&sum].most.error.0.values().fold(0.0_f64, |worst, c| worst.max(*c));
        let relative = rational((relative * 1e5).ceil() / 1e5);
        let exact = self.done[&sum].exact.clone();
        let group = self.group_of_root();
        let squares = self
            .inputs(group)
            .map(|x| format!("pose proof (same_square x{x}); pose proof (Rle_0_sqr x{x}); "));
        let squares: String = squares.collect();
        let sizes: String = self.inputs(group).map(|x| format!(" Y{x}")).collect();
        let letter = self.operation.inputs[group].0;
        self.say(&format!("assert (S_ : Rabs (r{sum} - 1) <= u * {relative})."));
        self.say(&format!(
            "{{ replace (r{sum} - 1) with (r{sum} - {exact}) by (clear - N{letter}; lra). apply (error u U0 _ _ _ _ _ B{sum}). clear - N{letter}{sizes}; subst; {squares}unfold Rsqr in *; lra. }}"
        ));
        self.say(&format!(
            "destruct (root u U0 U1 r{sum} {relative} ltac:(lra) S_) as (h & P_ & R_ & Q_ & H1 & H_ & K_ & H1_ & K1_)."
        ));
    }

    fn group_of_root(&self) -> usize {
        self.root.map_or(0, |(_, group)| group)
    }

    /// The nodes of an argument.
    pub(crate) fn inputs(&self, group: usize) -> impl Iterator<Item = Node> + use<> {
        let groups = self.operation.groups();
        (0..groups.len()).filter(move |&i| groups[i] == group).map(|i| (i + FIRST_INPUT) as Node)
    }

    /// The unit of a number: a product of powers of lengths.
    pub(crate) fn unit(&self, node: Node) -> Option<String> {
        let mut powers = BTreeMap::<usize, i32>::new();
        let node = if node >= 10_000 { node - 10_000 } else { node };
        for &variable in self.analysis.exact(node)?.0.keys().next()? {
            match as_root(variable) {
                Some((_, power)) => *powers.entry(self.group_of_root()).or_default() += power,
                None => *powers.entry(self.group(variable)).or_default() += 1,
            }
        }
        let factors = powers.into_iter().flat_map(|(group, power)| {
            let one = if power < 0 { "/ l" } else { "l" };
            let factor = format!("{one}{}", self.operation.inputs[group].0);
            std::iter::repeat_n(factor, power.unsigned_abs() as usize)
        });
        let factors: Vec<String> = factors.collect();
        Some(if factors.is_empty() { "1".into() } else { format!("({})", factors.join(" * ")) })
    }

    /// A text in units of lengths as one in lengths: each number times its unit.
    pub(crate) fn in_units(&self, text: &str) -> Option<String> {
        let words = text.split_inclusive([' ', '(', ')']).map(|word| {
            let name = word.trim_end_matches([' ', '(', ')']);
            let Some(node) = name.strip_prefix(['x', 'r']).and_then(|n| n.parse().ok()) else {
                return Some(word.to_string());
            };
            Some(format!("({} * {name}){}", self.unit(node)?, &word[name.len()..]))
        });
        words.collect()
    }

    /// Of a number that roots went into: what it is off from the exact one, beside the rounding of
    /// its steps, and that one.
    pub(crate) fn in_lengths(&mut self, output: Node) -> Option<(Node, Polynomial, String)> {
        let relative =
            self.done[&self.root?.0].most.error.0.values().fold(0.0_f64, |w, c| w.max(*c));
        let off = Polynomial::constant((relative * 1e5).ceil() / 1e5 / 2.0 + 1e-5);
        for (node, computed, lemma) in [(20_000, "h", "H1_"), (20_001, "(/ h)", "K1_")] {
            self.say(&format!("pose proof {lemma} as B{node}."));
            let (computed, exact) = (computed.into(), "1".into());
            let most = Bounded { value: Polynomial::constant(1.0), error: off.clone() };
            self.done.insert(node, Known { computed, exact, most });
        }
        let (mut next, mut sum, mut exact) = (20_002, None, String::new());
        for (monomial, &c) in &self.analysis.exact(output)?.0 {
            let factors = monomial.iter().map(|&v| match as_root(v) {
                Some((_, power)) => 20_000 + Node::from(power != 1),
                None => v,
            });
            self.constant(next, c.abs());
            let mut text = rational(c.abs());
            for factor in factors {
                self.product(next + 1, next, factor);
                self.shorten(next + 1);
                if factor < 20_000 {
                    let _ = write!(text, " * x{factor}");
                }
                next += 1;
            }
            let (term, sign) = (next, if c < 0.0 { "-" } else { "+" });
            next += 1;
            match sum {
                Some(before) => self.sum(next, c, before, term),
                None if c < 0.0 => self.opposite(next, term),
                None => next = term,
            }
            let _ = write!(exact, " {sign} {text}");
            (sum, next) = (Some(next), next + 1);
        }
        Some((sum?, self.done[&sum?].most.error.clone(), format!("(0{exact})")))
    }
}

/// That a product is not negative, from the same of its factors.
fn times(a: String, b: String) -> String {
    format!("(Rmult_le_pos _ _ {a} {b})")
}

/// Coefficients rounded up to few decimals, so that what is written stays short.
fn up(polynomial: &Polynomial) -> Polynomial {
    let up = |c: f64| if (c * 1e6).fract() == 0.0 { c } else { (c * 1e6 + 1e-3).ceil() / 1e6 };
    Sum(polynomial.0.iter().map(|(monomial, &c)| (monomial.clone(), up(c))).collect())
}

fn text_of(polynomial: &Polynomial) -> String {
    let terms = polynomial.0.iter().map(|(monomial, &c)| {
        let factors = monomial.iter().map(|v| format!("y{v}")).reduce(|a, b| format!("{a} * {b}"));
        format!("{} * ({})", rational(c), factors.unwrap_or("1".into()))
    });
    let terms: Vec<String> = terms.collect();
    if terms.is_empty() { "0".into() } else { terms.join(" + ") }
}
