//! [`Analysis`]: running error analysis of a tape (Wilkinson 1963; Higham 2002, §3.3), in closed
//! form.
//!
//! Of each node, the exact polynomial in the inputs, and one with coefficients ≥ 0 that its error
//! stays below, in units of the roundoff u; products of errors are kept, so nothing is of first
//! order only. The root of a sum of squares |x|² is a variable: the computed sum ŝ counts as
//! exact while √ŝ and 1/ŝ go through the tape, so that their errors cancel, and what ŝ itself
//! is off enters once, at the end.

use crate::polynomial::{Lengths, Monomial, Polynomial, Sum, as_root, root};
use crate::tape::{FIRST_INPUT, Node, Op, Tape};
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// u of `f32`. Bounds in units of u rise with u, so these hold for `f64` too.
pub const U: f64 = 1.0 / (1 << 24) as f64;

/// The most factors of a term that is analysed.
const DEGREE: usize = 6;

/// A number without rounding, and what it is off by at most: in units of u, with coefficients
/// ≥ 0.
#[derive(Clone, Debug)]
pub(crate) struct Bounded {
    pub(crate) value: Polynomial,
    pub(crate) error: Polynomial,
}

impl Bounded {
    pub(crate) fn exactly(value: Polynomial) -> Self {
        Self { value, error: Polynomial::default() }
    }
    /// self + c other
    pub(crate) fn plus(&self, c: f64, other: &Self) -> Self {
        let error = self.error.plus(c.abs(), &other.error);
        Self { value: self.value.plus(c, &other.value), error }
    }
    /// self · other
    pub(crate) fn times(&self, other: &Self) -> Self {
        let of_other = self.value.magnitude().times(&other.error);
        let first = of_other.plus(1.0, &other.value.magnitude().times(&self.error));
        let error = first.plus(U, &self.error.times(&other.error));
        Self { value: self.value.times(&other.value), error }
    }
    /// The same after one rounding, relatively by u.
    pub(crate) fn rounded(self) -> Self {
        let more = self.value.magnitude().plus(U, &self.error);
        Self { error: self.error.plus(1.0, &more), ..self }
    }
}

/// What roundings do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rounding {
    /// In the normal range: relatively, by u.
    Normal,
    /// Below it, what products add to that: no more than the half of the least number, the unit of
    /// these errors.
    Below,
}

/// What is known of every node.
#[derive(Debug)]
pub struct Analysis {
    rounding: Rounding,
    /// Of each node; `None` beyond what is analysed.
    known: Vec<Option<Bounded>>,
    sizes: Vec<OnceLock<Option<Lengths>>>,
    roots: Vec<Root>,
    groups: Vec<usize>,
}

/// A sum of squares whose root is taken.
#[derive(Debug)]
struct Root {
    /// The node of the sum.
    sum: Node,
    /// The group whose length the root is.
    group: usize,
    /// The relative error of the computed sum, in units of u.
    relative: f64,
}

impl Analysis {
    /// Of a tape whose inputs belong to these groups.
    pub(crate) fn of(tape: &Tape, groups: Vec<usize>, fused: bool, rounding: Rounding) -> Self {
        let (known, sizes, roots) = (vec![], vec![OnceLock::new(); tape.ops.len()], vec![]);
        let mut analysis = Self { rounding, known, sizes, roots, groups };
        for node in 0..tape.ops.len() {
            // Of polynomials in polynomials, which have too many terms.
            let few = |of: &Bounded| {
                let factors = |m: &Monomial| m.iter().filter(|v| as_root(**v).is_none()).count();
                of.value.0.keys().all(|monomial| factors(monomial) <= DEGREE)
            };
            let known = analysis.node(tape, node as Node, fused).filter(few);
            analysis.known.push(known);
        }
        analysis
    }

    fn node(&mut self, tape: &Tape, node: Node, fused: bool) -> Option<Bounded> {
        // Below the normal numbers a half is rounded.
        let least = if self.rounding == Rounding::Normal { 0.0 } else { 1.0 };
        let [rounds_product, rounds] = tape.roundings(node, fused, least);
        let (is_product, exact) = match tape.ops[node as usize] {
            Op::Input => (false, Bounded::exactly(Polynomial::variable(node))),
            Op::Const(c) if c.is_finite() => (false, Bounded::exactly(Polynomial::constant(c))),
            Op::Const(_) | Op::Abs(_) => return None,
            Op::Neg(a) => {
                (false, Bounded::exactly(Polynomial::default()).plus(-1.0, self.known(a)?))
            }
            Op::Add(a, b) => (false, self.known(a)?.plus(1.0, self.known(b)?)),
            Op::Sub(a, b) => (false, self.known(a)?.plus(-1.0, self.known(b)?)),
            Op::Mul(a, b) => (true, self.known(a)?.times(self.known(b)?)),
            Op::Fma(a, b, c) | Op::Nfma(a, b, c) => {
                let sign = if matches!(tape.ops[node as usize], Op::Fma(..)) { 1.0 } else { -1.0 };
                let product = self.known(a)?.times(self.known(b)?);
                let product = if rounds_product { self.rounded(true, product) } else { product };
                (fused, self.known(c)?.plus(sign, &product))
            }
            Op::Sqrt(a) => {
                let k = self.root_of(a)?;
                (false, Bounded::exactly(Polynomial::variable(root(k))))
            }
            Op::Div(a, b) => {
                let over = self.reciprocal(b)?;
                (true, self.known(a)?.times(&over))
            }
        };
        Some(if rounds { self.rounded(is_product, exact) } else { exact })
    }

    fn known(&self, node: Node) -> Option<&Bounded> {
        self.known[node as usize].as_ref()
    }
    pub(crate) fn exact(&self, node: Node) -> Option<&Polynomial> {
        self.known(node).map(|known| &known.value)
    }

    /// One rounding, of a product or not: sums are never below, but whole multiples of the least
    /// number.
    fn rounded(&self, is_product: bool, of: Bounded) -> Bounded {
        match self.rounding {
            Rounding::Normal => of.rounded(),
            Rounding::Below if is_product => {
                Bounded { error: of.error.plus(1.0, &Polynomial::constant(1.0)), ..of }
            }
            Rounding::Below => of,
        }
    }

    /// Which root the node is the square of: new, or known.
    fn root_of(&mut self, sum: Node) -> Option<usize> {
        if let Some(k) = self.roots.iter().position(|root| root.sum == sum) {
            return Some(k);
        }
        let Bounded { value: exact, error } = self.known(sum)?;
        let first = exact.0.keys().next()?.first()?.checked_sub(FIRST_INPUT as u32)?;
        let group = *self.groups.get(first as usize)?;
        let squares = self.groups.iter().enumerate().filter(|(_, g)| **g == group).map(|(i, _)| {
            let input = (FIRST_INPUT + i) as Node;
            (vec![input, input], 1.0)
        });
        if exact.0 != squares.collect() {
            return None;
        }
        // All terms positive: the error is relative.
        if !error.0.keys().all(|monomial| exact.0.contains_key(monomial)) {
            return None;
        }
        let relative = error.0.values().fold(0.0_f64, |worst, c| worst.max(*c));
        self.roots.push(Root { sum, group, relative });
        Some(self.roots.len() - 1)
    }

    /// One over a sum of squares or a multiple of a root, and its error.
    fn reciprocal(&mut self, node: Node) -> Option<Bounded> {
        if let Some(k) = self.root_of(node) {
            let over = Polynomial::variable(root(k) + 1);
            return Some(Bounded::exactly(over.times(&over)));
        }
        let Bounded { value: exact, error } = self.known(node)?;
        let (monomial, &c) = exact.0.first_key_value()?;
        if exact.0.len() != 1 || monomial.iter().any(|&v| as_root(v).is_none()) {
            return None;
        }
        if !error.0.keys().all(|other| other == monomial) {
            return None;
        }
        let relative = error.0.get(monomial).copied().unwrap_or(0.0) / c.abs();
        let mut value = Polynomial::constant(1.0 / c);
        for &v in monomial {
            let (k, power) = as_root(v)?;
            let over = root(k) + u32::from(power == 1);
            value = value.times(&Polynomial::variable(over));
        }
        let error = value.magnitude().scaled(relative / (1.0 - relative * U));
        Some(Bounded { value, error })
    }

    /// What the error of a node stays below, by the lengths of the arguments; `None` beyond what is
    /// analysed.
    #[must_use]
    pub fn bound(&self, node: Node) -> Option<Lengths> {
        let Bounded { value: exact, error } = self.known(node)?;
        // √ŝ = √s (1 + η)
        let off = |k: usize| {
            self.roots[k].relative / 2.0 / (1.0 - self.roots[k].relative * U).powf(1.5) * U
        };
        let grown = |powers: &BTreeMap<usize, i32>| -> f64 {
            let of = |(&k, &power): (&usize, &i32)| {
                let power = power.abs();
                (1.0 + off(k)).powi(power).max((1.0 - off(k)).powi(-power))
            };
            powers.iter().map(of).product()
        };
        let moved = exact.magnitude().weighted(|powers| (grown(powers) - 1.0) / U);
        let total = error.weighted(grown).plus(1.0, &moved);
        Some(self.by_lengths(&total))
    }

    fn by_lengths(&self, polynomial: &Polynomial) -> Lengths {
        let group = |input: u32| self.groups[input as usize - FIRST_INPUT];
        polynomial.by_lengths(&group, &|k| self.roots[k].group)
    }
}

impl Analysis {
    /// How long the vector of some numbers is, and that of their errors: the largest sum of each
    /// times a number of a unit vector, which is one more argument.
    pub(crate) fn vector(&self, nodes: &[Node]) -> Option<(Lengths, Lengths)> {
        let first = (FIRST_INPUT + self.groups.len()) as u32;
        let last = self.groups.last().map_or(0, |last| last + 1);
        let group = |v: u32| if v < first { self.groups[v as usize - FIRST_INPUT] } else { last };
        let length = |of: fn(&Bounded) -> &Polynomial| {
            let mut sum = Polynomial::default();
            for (&node, along) in nodes.iter().zip(first..) {
                sum = sum.plus(1.0, &of(self.known(node)?).times(&Polynomial::variable(along)));
            }
            let Sum(by) = sum.by_lengths(&group, &|k| self.roots[k].group);
            let without = by.into_iter().map(|(mut powers, c)| {
                powers.retain(|&(g, _)| g != last);
                (powers, c)
            });
            Some(Sum(without.collect()))
        };
        Some((length(|known| &known.value)?, length(|known| &known.error)?))
    }
}

// What scripts need beside the bounds.
impl Analysis {
    /// How large the exact number of a node is at most, by the lengths of the arguments.
    pub(crate) fn size(&self, node: Node) -> Option<&Lengths> {
        let size = || Some(self.by_lengths(self.exact(node)?));
        self.sizes[node as usize].get_or_init(size).as_ref()
    }
    /// That of a node and c times another, where terms of one and the other have as many factors.
    pub(crate) fn size_of_sum(&self, node: Node, c: f64, other: Node) -> Option<Lengths> {
        let (one, other) = (self.exact(node)?, self.exact(other)?);
        let factors = |of: &Polynomial| of.0.keys().next().map(Vec::len);
        (factors(one) == factors(other)).then(|| self.by_lengths(&one.plus(c, other)))
    }
    /// The sums of squares of a whole argument: node and argument.
    pub(crate) fn sums(&self) -> impl Iterator<Item = (Node, usize)> {
        self.roots.iter().map(|root| (root.sum, root.group))
    }
}
