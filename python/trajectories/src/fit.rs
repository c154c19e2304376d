//! Motions that bring points to points.

use crate::argument::{Argument, Input, is_single};
use crate::call::Answer;
use crate::error::value_error;
use crate::number::Number;
use crate::output::Output;
use crate::robust::{OF_POINTS, Problems, Rule, reweighted};
use crate::shape::NUMBER;
use crate::threads::Threads;
use dq8::fit::{Fit, Maps, PairSets, Quality};
use dq8::{Backend, DualQuat, Real};
use pyo3::prelude::*;

/// For each problem a motion, the scale, rms, rank, condition and whether it is mirrored, as
/// `dq8.fit` has them.
const NUMBERS: usize = 13;

/// The number of pairs that are fitted between two looks at signals.
const PAIRS: usize = 4096;

/// The best maps of `points` to `moved`, both (..., n, 3), with `weights` (..., n): thirteen
/// numbers for each problem, and with a `rule` the n numbers by which weights were multiplied. NaN
/// where there is no best one.
#[pyfunction]
#[pyo3(signature = (points, moved, weights, about, scale, rule))]
pub fn fit_pairs<'py>(
    points: &Bound<'py, PyAny>,
    moved: &Bound<'py, PyAny>,
    weights: Option<&Bound<'py, PyAny>>,
    about: Option<[f64; 3]>,
    scale: bool,
    rule: Option<&str>,
) -> Answer<'py> {
    let mut arguments =
        vec![Argument::new("points", &[3], points)?, Argument::new("moved", &[3], moved)?];
    if let Some(weights) = weights {
        arguments.push(Argument::new("weights", NUMBER, weights)?);
    }
    let rule = rule.and_then(Rule::named);
    if is_single(&arguments) {
        typed::<f32>(&arguments, about, scale, rule)
    } else {
        typed::<f64>(&arguments, about, scale, rule)
    }
}

fn typed<'py, R: Number>(
    arguments: &[Argument<'py>],
    about: Option<[f64; 3]>,
    scale: bool,
    rule: Option<Rule>,
) -> Answer<'py> {
    let [points, moved, weights @ ..] = arguments else { return Err(value_error("no points")) };
    let (points, moved) = (Input::<R>::of(points)?.in_full()?, Input::<R>::of(moved)?.in_full()?);
    let weights = weights.first().map(Input::<R>::of).transpose()?;
    let weights = weights.map(Input::in_full).transpose()?;
    let (Some((&pairs, leading)), py) = (points.full_leading().split_last(), points.py()) else {
        return Err(value_error("no pairs"));
    };
    let maps = match about {
        Some(axis) => Maps::About(axis.map(<R as Real>::from_f64)),
        None if scale => Maps::Similarity,
        None => Maps::Rigid,
    };
    let width = NUMBERS + if rule.is_some() { pairs } else { 0 };
    let given = Given {
        points: points.records(),
        moved: moved.records(),
        weights: weights.as_ref().map(Input::numbers),
        pairs,
        maps,
    };
    let threads = Threads::for_elements(given.points.len());
    let output = Output::<R>::new(py, None, leading, &[width])?;
    let _held = output.held();
    output.fill_attached(|to| {
        threads.run(py, || {
            threads.split(PAIRS.div_ceil(pairs) * width, to, &|(at, to)| {
                let part = given.part(at / width, to.len() / width);
                match rule {
                    None => part.fit(to.as_chunks_mut().0),
                    Some(rule) => part.reweighted(rule, &threads, to),
                }
                true
            });
            Ok(())
        })
    })
}

/// Problems that lie one after the other and have the same number of pairs.
#[derive(Clone, Copy)]
struct Given<'s, R> {
    points: &'s [[R; 3]],
    moved: &'s [[R; 3]],
    weights: Option<&'s [R]>,
    pairs: usize,
    maps: Maps<R>,
}

impl<'s, R: Number> Given<'s, R> {
    /// Returns a range of the problems.
    fn part(&self, first: usize, count: usize) -> Self {
        let own = first * self.pairs..(first + count) * self.pairs;
        Self {
            points: &self.points[own.clone()],
            moved: &self.moved[own.clone()],
            weights: self.weights.map(|weights| &weights[own]),
            ..*self
        }
    }

    fn each(&self) -> (Vec<Fit<R>>, Vec<Quality<R>>) {
        let counts = vec![self.pairs; self.points.len() / self.pairs];
        let mut found = (vec![Fit::NONE; counts.len()], vec![Quality::NONE; counts.len()]);
        let sets = match self.weights {
            Some(weights) => PairSets::weighted(self.points, self.moved, weights, &counts),
            None => PairSets::new(self.points, self.moved, &counts),
        };
        // All lengths are those of `points`, and the axis was checked; otherwise all is NaN.
        let _ = sets
            .and_then(|sets| Backend::best().fit_each(sets, self.maps, &mut found.0, &mut found.1));
        found
    }

    fn fit(&self, to: &mut [[R; NUMBERS]]) {
        let (fits, qualities) = self.each();
        for ((to, fit), quality) in to.iter_mut().zip(&fits).zip(&qualities) {
            to.copy_from_slice(&numbers(fit, quality));
        }
    }

    fn reweighted(&self, rule: Rule, threads: &Threads, to: &mut [R]) {
        let (pairs, width) = (self.pairs, NUMBERS + self.pairs);
        let weights: Vec<f64> =
            self.weights.unwrap_or_default().iter().map(|&weight| weight.into()).collect();
        let epsilon: f64 = <R as Real>::EPSILON.into();
        let largest = |points: &[[R; 3]]| {
            let sizes = points.as_flattened().iter().map(|&c| Into::<f64>::into(c).abs());
            sizes.fold(0.0_f64, f64::max)
        };
        let chunks = self.points.chunks(pairs).zip(self.moved.chunks(pairs));
        let least: Vec<f64> =
            chunks.map(|(x, y)| 4.0 * epsilon * largest(x).max(largest(y))).collect();
        let of = Problems {
            rule,
            lengths: &OF_POINTS,
            pairs,
            weights: &weights,
            least: &least,
            settled: epsilon.sqrt().max(1e-6),
        };
        let mut factors = vec![1.0; self.points.len()];
        let solve = &mut |active: &[usize], weights: &[f64], residuals: &mut [f64]| {
            let all = |of: &[[R; 3]]| -> Vec<[R; 3]> {
                active.iter().flat_map(|at| &of[at * pairs..(at + 1) * pairs]).copied().collect()
            };
            let weights: Vec<R> =
                weights.iter().map(|&weight| <R as Real>::from_f64(weight)).collect();
            let (points, moved) = (all(self.points), all(self.moved));
            let now = Given { points: &points, moved: &moved, weights: Some(&weights), ..*self };
            // A single problem may have millions of pairs, and each part of a round takes its time.
            if threads.interrupted() {
                return;
            }
            let (fits, qualities) = now.each();
            if threads.interrupted() {
                return;
            }
            for (index, (fit, quality)) in fits.iter().zip(&qualities).enumerate() {
                let at = active[index] * width;
                to[at..at + NUMBERS].copy_from_slice(&numbers(fit, quality));
                for pair in index * pairs..(index + 1) * pairs {
                    let [x, y] = [fit.transform_point(points[pair]), moved[pair]];
                    let squares = [0, 1, 2].map(|i| Into::<f64>::into(x[i] - y[i]).powi(2));
                    residuals[pair] = squares.iter().sum::<f64>().sqrt();
                }
            }
        };
        reweighted(&of, threads, solve, &mut factors);
        for (to, factors) in to.chunks_mut(width).zip(factors.chunks(pairs)) {
            for (to, &factor) in to[NUMBERS..].iter_mut().zip(factors) {
                *to = <R as Real>::from_f64(factor);
            }
        }
    }
}

fn numbers<R: Number>(fit: &Fit<R>, quality: &Quality<R>) -> [R; NUMBERS] {
    let mut numbers = [R::default(); NUMBERS];
    numbers[..8].copy_from_slice(&DualQuat::to_array(fit.motion));
    let [rank, mirrored] =
        [quality.rank, usize::from(quality.mirrored)].map(|it| <R as Real>::from_f64(it as f64));
    numbers[8..].copy_from_slice(&[fit.scale, quality.rms, rank, quality.condition, mirrored]);
    numbers
}
