//! Solutions of arms that are of neither family: what searches from many starts find.

use super::problem::Reach;
use super::report::{Options, Report};
use super::solutions::{Solution, Solutions};
use dq8::{DualQuat, Scalar};
use dq8_simd::{Lanes, Portable};

/// How many starts. Of the solutions of random targets, 64 find 99.8 in 100, and 32 find 98.
const STARTS: usize = 64;
/// What of half the turn between two values is another solution, and no other end of a search.
const OTHER: f32 = 1e-3;

/// How many numbers it takes to remember them.
pub(super) fn values<R: Copy>(reach: &Reach<'_, R>) -> usize {
    reach.mechanism.values.saturating_mul(STARTS)
}

/// The solutions that `search` comes to: from those `found` of an arm that is nearly the same; if
/// there are none, from `start` and from values that are spread evenly within the limits.
pub(super) fn search_all<R: Scalar>(
    reach: &Reach<'_, R>,
    target: DualQuat<R>,
    start: &[R; 6],
    found: &mut Solutions<R>,
    values: &mut [R],
    search: impl FnOnce(&[DualQuat<R>], &mut [R], &mut [Report<R>], &Options<R>),
) {
    let fine = R::from(if R::EPSILON > R::from(1e-10) { 1e-5 } else { 1e-10 });
    let options = Options {
        angular_tolerance: fine,
        linear_tolerance: fine,
        max_iterations: 50,
        restarts: false,
        ..Options::default()
    };
    values.fill(R::ZERO);
    let size = reach.mechanism.values.max(1);
    let hinges = || reach.freedoms.iter().zip(start);
    let guesses = *found;
    let count = if guesses.is_empty() { STARTS } else { guesses.len() };
    let values = values.get_mut(..count * size).unwrap_or_default();
    for (number, values) in (0..).zip(values.chunks_exact_mut(size)) {
        let guess = guesses.get(number as usize);
        for (hinge, (freedom, &start)) in hinges().enumerate() {
            let guess = guess.and_then(|guess| guess.values.get(hinge));
            if let Some(slot) = values.get_mut(freedom.value as usize) {
                *slot = match guess {
                    Some(&guess) => guess,
                    None if number == 0 => start,
                    None => freedom.beginning(number),
                };
            }
        }
    }
    let (targets, mut reports) = ([target; STARTS], [Report::default(); STARTS]);
    let reports = reports.get_mut(..count).unwrap_or_default();
    search(targets.get(..count).unwrap_or_default(), values, reports, &options);
    found.clear(false);
    for (values, report) in values.chunks_exact(size).zip(reports) {
        if !report.is_converged() {
            continue;
        }
        let mut solution = Solution::default();
        for ((freedom, &start), slot) in hinges().zip(&mut solution.values) {
            let value = values.get(freedom.value as usize).copied().unwrap_or_default();
            let [value, to] =
                [value, start].map(|value| R::Lanes::<Portable>::splat(Portable, value));
            let near = freedom.range.keep(value, freedom.range.keep(to, freedom.range.clamp(to)));
            *slot = near.to_array().as_ref().first().copied().unwrap_or_default();
            solution.distance += (*slot - start) * (*slot - start);
        }
        solution.distance = solution.distance.sqrt();
        let is_known = found.iter().any(|known| {
            let pairs = known.values.iter().zip(&solution.values);
            pairs.into_iter().all(|(&a, &b)| ((a - b) * R::HALF).sin().abs() < R::from(OTHER))
        });
        if !is_known {
            found.insert(solution);
        }
    }
}
