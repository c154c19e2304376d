//! [`reweighted`]: weights by which outliers do not count, found by least squares again and again.

use crate::threads::Threads;
use std::cmp::Ordering;

/// The rule by which a pair counts less, the more standard deviations u its residual has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rule {
    /// The factor min(1, k/u).
    Huber,
    /// The factor (1 − (u/c)²)², which is zero from c on.
    Tukey,
}

impl Rule {
    pub(crate) fn named(name: &str) -> Option<Self> {
        match name {
            "huber" => Some(Self::Huber),
            "tukey" => Some(Self::Tukey),
            _ => None,
        }
    }
}

/// Numbers of the lengths of residuals whose components are normally distributed, with the standard
/// deviation one.
pub(crate) struct Lengths {
    /// The median of the lengths.
    median: f64,
    /// The k of [`Rule::Huber`] with which a mean has 95 % of the efficiency that it has without
    /// the rule, and below it the c of [`Rule::Tukey`] that does the same. A test in Python
    /// computes all three numbers.
    huber: f64,
    tukey: f64,
}

/// The lengths of residuals of points, which have three components.
pub(crate) const OF_POINTS: Lengths = Lengths { median: 1.5382, huber: 1.6280, tukey: 5.4902 };
/// The lengths of residuals of motions, which have six components.
pub(crate) const OF_MOTIONS: Lengths = Lengths { median: 2.3126, huber: 1.8693, tukey: 6.3562 };

impl Lengths {
    fn factor(&self, rule: Rule, deviations: f64) -> f64 {
        match rule {
            Rule::Huber if deviations > self.huber => self.huber / deviations,
            Rule::Huber => 1.0,
            Rule::Tukey => {
                let part = deviations / self.tukey;
                (1.0 - part * part).max(0.0).powi(2)
            }
        }
    }
}

/// The number of rounds after which weights that have not settled are taken as they are.
const ROUNDS: usize = 100;

/// Some problems of equally many pairs, to be solved again and again.
pub(crate) struct Problems<'p> {
    pub(crate) rule: Rule,
    pub(crate) lengths: &'static Lengths,
    /// The number of pairs of each problem.
    pub(crate) pairs: usize,
    /// The weights of all pairs; empty if all pairs weigh the same.
    pub(crate) weights: &'p [f64],
    /// The standard deviation that rounding leaves in each problem.
    pub(crate) least: &'p [f64],
    /// The largest change of a weight with which the weights count as settled.
    pub(crate) settled: f64,
}

/// Solves the problems with these numbers, with the weights of their pairs, and writes the lengths
/// of the residuals, unless it is interrupted.
pub(crate) type Solve<'f> = dyn FnMut(&[usize], &[f64], &mut [f64]) + 'f;

/// Solves problems until their weights settle, or until `threads` are interrupted, and writes the
/// factor by which each weight was multiplied. The standard deviation is computed from the median
/// of the residuals. Tukey's rule begins where Huber's, which has one solution, ended, and keeps
/// that standard deviation.
pub(crate) fn reweighted(
    of: &Problems<'_>,
    threads: &Threads,
    solve: &mut Solve<'_>,
    factors: &mut [f64],
) {
    factors.fill(1.0);
    let pairs = of.pairs;
    let mut active: Vec<usize> = (0..of.least.len()).collect();
    let mut known = vec![None; active.len()];
    let (mut weights, mut residuals, mut sorted) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        // A single problem may have millions of pairs.
        if threads.interrupted() {
            return;
        }
        weights.clear();
        for &problem in &active {
            let own = problem * pairs..(problem + 1) * pairs;
            let given = of.weights.get(own.clone());
            let each = |at: usize| given.map_or(1.0, |given| given[at]);
            weights.extend(factors[own].iter().enumerate().map(|(at, factor)| factor * each(at)));
        }
        residuals.clear();
        residuals.resize(weights.len(), 0.0);
        solve(&active, &weights, &mut residuals);
        if threads.interrupted() {
            return;
        }
        let mut solved = residuals.chunks(pairs);
        active.retain(|&problem| {
            let own = problem * pairs..(problem + 1) * pairs;
            let Some(residuals) = solved.next().filter(|all| all.iter().all(|r| r.is_finite()))
            else {
                return false;
            };
            let given = of.weights.get(own.clone());
            let deviation = known[problem].unwrap_or_else(|| {
                let counts = |at: &usize| given.is_none_or(|given| given[*at] > 0.0);
                sorted.clear();
                sorted.extend((0..pairs).filter(counts).map(|at| residuals[at]));
                (median(&mut sorted) / of.lengths.median).max(of.least[problem])
            });
            let first = known[problem].is_none();
            let rule = if first { Rule::Huber } else { of.rule };
            let mut change: f64 = 0.0;
            for (factor, residual) in factors[own.clone()].iter_mut().zip(residuals) {
                let new = of.lengths.factor(rule, residual / deviation);
                change = change.max((new - *factor).abs());
                *factor = new;
            }
            if change > of.settled || of.rule == Rule::Huber || !first {
                return change > of.settled;
            }
            known[problem] = Some(deviation);
            for (factor, residual) in factors[own].iter_mut().zip(residuals) {
                *factor = of.lengths.factor(of.rule, residual / deviation);
            }
            true
        });
        if active.is_empty() {
            break;
        }
    }
}

/// The median, the mean of the two in the middle of an even number; sorts a part.
pub(crate) fn median(numbers: &mut [f64]) -> f64 {
    let order = |a: &f64, b: &f64| a.partial_cmp(b).unwrap_or(Ordering::Equal);
    let half = numbers.len() / 2;
    let even = numbers.len().is_multiple_of(2);
    if numbers.is_empty() {
        return 0.0;
    }
    let (below, &mut upper, _) = numbers.select_nth_unstable_by(half, order);
    if !even {
        return upper;
    }
    let lower = below.iter().fold(0.0_f64, |most, &number| most.max(number));
    0.5 * (lower + upper)
}
