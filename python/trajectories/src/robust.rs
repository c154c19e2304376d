//! [`reweighted`]: weights by which outliers do not count, found by least squares again and again.

use std::cmp::Ordering;

/// How much a pair counts whose residual is so many standard deviations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rule {
    /// min(1, k/u).
    Huber,
    /// (1 − (u/c)²)², from c on 0.
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

/// The lengths of residuals whose components are normal with the standard deviation one.
pub(crate) struct Lengths {
    /// Their median.
    median: f64,
    /// The k of [`Rule::Huber`] and the c of [`Rule::Tukey`], with which 95 percent of what is
    /// known of a mean stays known. A test of Python computes all three.
    huber: f64,
    tukey: f64,
}

/// Of three components, as points have them.
pub(crate) const OF_POINTS: Lengths = Lengths { median: 1.5382, huber: 1.6280, tukey: 5.4902 };
/// Of six components, as motions have them.
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

/// More rounds than are needed where the weights settle.
const ROUNDS: usize = 100;

/// Some problems of equally many pairs, to be solved again and again.
pub(crate) struct Problems<'p> {
    pub(crate) rule: Rule,
    pub(crate) lengths: &'static Lengths,
    /// How many pairs each has.
    pub(crate) pairs: usize,
    /// The weights of all pairs; none if all are the same.
    pub(crate) weights: &'p [f64],
    /// The standard deviation that rounding leaves, of each problem.
    pub(crate) least: &'p [f64],
    /// The change of weights that is none.
    pub(crate) settled: f64,
}

/// Solves the problems with these numbers, with the weights of their pairs, and writes the lengths
/// of the residuals.
pub(crate) type Solve<'f> = dyn FnMut(&[usize], &[f64], &mut [f64]) + 'f;

/// Solves problems until their weights settle, and writes by what each weight was multiplied. The
/// standard deviation is that of which the median of the residuals tells. Tukey's rule begins where
/// Huber's, which has one solution, ended, and keeps that standard deviation.
pub(crate) fn reweighted(of: &Problems<'_>, solve: &mut Solve<'_>, factors: &mut [f64]) {
    factors.fill(1.0);
    let pairs = of.pairs;
    let mut active: Vec<usize> = (0..of.least.len()).collect();
    let mut known = vec![None; active.len()];
    let (mut weights, mut residuals, mut sorted) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
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
