//! The kernel of `dq8.hand_eye`, which finds how a camera sits on a hand.

use crate::argument::{Argument, Input};
use crate::call::Answer;
use crate::error::value_error;
use crate::output::Output;
use crate::robust::{OF_MOTIONS, Problems, Rule, median, reweighted};
use crate::shape::{EIGHT, NUMBER};
use crate::threads::Threads;
use dq8::simd::{Mask, Records};
use dq8::{Backend, DualQuat, Kernel, Lanes, Level};
use pyo3::prelude::*;
use std::borrow::Cow;

/// For each problem a motion, the eight singular values from the largest on, and the median of the
/// angles that are left.
const NUMBERS: usize = 17;

/// The number of pairs between two looks at signals.
const PAIRS: usize = 4096;

/// The number of times that a problem is solved at most, each time with other signs.
const TURNS: usize = 4;

/// The motions X with ``A X = X B`` of hands A and eyes B, both (..., n, 8), with `weights` (...,
/// n): seventeen numbers for each problem, and with a `rule` the n numbers by which weights were
/// multiplied.
#[pyfunction]
#[pyo3(signature = (hands, eyes, weights, rule))]
pub fn hand_eye_pairs<'py>(
    hands: &Bound<'py, PyAny>,
    eyes: &Bound<'py, PyAny>,
    weights: Option<&Bound<'py, PyAny>>,
    rule: Option<&str>,
) -> Answer<'py> {
    let hands = Argument::new("hands", EIGHT, hands)?;
    let eyes = Argument::new("eyes", EIGHT, eyes)?;
    let weights = weights.map(|given| Argument::new("weights", NUMBER, given)).transpose()?;
    let hands = Input::<f64>::of(&hands)?.in_full()?;
    let eyes = Input::<f64>::of(&eyes)?.in_full()?;
    let weights = weights.as_ref().map(Input::<f64>::of).transpose()?;
    let weights = weights.map(Input::in_full).transpose()?;
    let rule = rule.and_then(Rule::named);
    let (Some((&pairs, leading)), py) = (hands.full_leading().split_last(), hands.py()) else {
        return Err(value_error("no pairs"));
    };
    let width = NUMBERS + if rule.is_some() { pairs } else { 0 };
    let weights = weights.as_ref().map(Input::numbers).unwrap_or_default();
    let given = Given { hands: hands.records(), eyes: eyes.records(), weights, pairs };
    let threads = Threads::for_elements(given.hands.len());
    let output = Output::<f64>::new(py, None, leading, &[width])?;
    let _held = output.held();
    output.fill_attached(|to| {
        threads.run(py, || {
            threads.split(PAIRS.div_ceil(pairs) * width, to, &|(at, to)| {
                let part = given.part(at / width, to.len() / width);
                match rule {
                    None => part.solve(&threads, to.as_chunks_mut().0, &mut []),
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
struct Given<'s> {
    hands: &'s [[f64; 8]],
    eyes: &'s [[f64; 8]],
    /// The weights of all pairs; empty if all pairs weigh the same.
    weights: &'s [f64],
    pairs: usize,
}

impl Given<'_> {
    /// Returns a range of the problems.
    fn part(&self, first: usize, count: usize) -> Self {
        let own = first * self.pairs..(first + count) * self.pairs;
        let weights = self.weights.get(own.clone()).unwrap_or_default();
        Self { hands: &self.hands[own.clone()], eyes: &self.eyes[own], weights, ..*self }
    }

    /// Writes the numbers of each problem, and the lengths of all residuals if there is room.
    ///
    /// A and B turn by the same angle, so their scalars agree: both are made not negative first. If
    /// both turn by nearly π, noise decides about the sign, and the wrong sign makes an outlier.
    /// So where A X and X B have opposite signs, the sign of B is changed, and the problem is
    /// solved again.
    ///
    /// A single problem may have millions of pairs, so `threads` are asked within problems too. An
    /// interrupted call leaves numbers without a meaning.
    fn solve(&self, threads: &Threads, to: &mut [[f64; NUMBERS]], residuals: &mut [f64]) {
        let signed = |all: &[[f64; 8]]| -> Option<Vec<[f64; 8]>> {
            let sign = |one: &[f64; 8]| if one[3] < 0.0 { -1.0 } else { 1.0 };
            let mut signed = Vec::with_capacity(all.len());
            for piece in all.chunks(PAIRS) {
                if threads.interrupted() {
                    return None;
                }
                signed.extend(piece.iter().map(|one| one.map(|number| sign(one) * number)));
            }
            Some(signed)
        };
        let (Some(hands), Some(mut eyes)) = (signed(self.hands), signed(self.eyes)) else {
            return;
        };
        let pairs = self.pairs;
        let mut angles = vec![0.0; pairs];
        let mut counted = Vec::new();
        let mut left: Vec<usize> = (0..to.len()).collect();
        for _ in 0..TURNS {
            let own = |all: &[[f64; 8]]| -> Vec<[f64; 8]> {
                left.iter().flat_map(|at| &all[at * pairs..(at + 1) * pairs]).copied().collect()
            };
            let mut decomposed = vec![Decomposed::default(); left.len()];
            let backend = Backend::best();
            if left.len() == to.len() {
                let given = Given { hands: &hands, eyes: &eyes, ..*self };
                backend.run(Decompose { given, threads, to: &mut decomposed });
            } else {
                let weigh = |at: &usize| self.weights.get(at * pairs..(at + 1) * pairs);
                let weights: Vec<f64> = left.iter().filter_map(weigh).flatten().copied().collect();
                let (hands, eyes) = (own(&hands), own(&eyes));
                let given = Given { hands: &hands, eyes: &eyes, weights: &weights, pairs };
                backend.run(Decompose { given, threads, to: &mut decomposed });
            }
            let mut solved = decomposed.iter();
            left.retain(|&problem| {
                let Some(decomposed) = solved.next() else { return false };
                let (motion, sizes) = decomposed.solution();
                let mut turned = false;
                for (at, angle) in angles.iter_mut().enumerate() {
                    if is_end(at) && threads.interrupted() {
                        return false;
                    }
                    let pair = problem * pairs + at;
                    let [hand, eye] = [hands[pair], eyes[pair]].map(DualQuat::from_array);
                    let (by_hand, by_eye) = (hand * motion, motion * eye);
                    *angle = by_hand.angle_to(by_eye);
                    if let Some(residual) = residuals.get_mut(pair) {
                        *residual = angle.hypot(by_hand.distance_to(by_eye));
                    }
                    let [a, b] = [by_hand.to_array(), by_eye.to_array()];
                    if a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] < 0.0 {
                        eyes[pair] = eyes[pair].map(|number| -number);
                        turned = true;
                    }
                }
                let to = &mut to[problem];
                to[..8].copy_from_slice(&motion.to_array());
                to[8..16].copy_from_slice(&sizes);
                // Pairs without a weight say nothing about the others.
                let given = self.weights.get(problem * pairs..(problem + 1) * pairs);
                counted.clear();
                let counts = |at: &usize| given.is_none_or(|given| given[*at] > 0.0);
                counted.extend((0..pairs).filter(counts).map(|at| angles[at]));
                to[16] = if motion.is_finite() { median(&mut counted) } else { f64::NAN };
                turned
            });
            if left.is_empty() {
                break;
            }
        }
    }

    fn reweighted(&self, rule: Rule, threads: &Threads, to: &mut [f64]) {
        let (pairs, width) = (self.pairs, NUMBERS + self.pairs);
        let longest = |motions: &[[f64; 8]]| {
            let duals = motions.iter().flat_map(|motion| &motion[4..]);
            duals.fold(1.0_f64, |most, number| most.max(number.abs()))
        };
        let chunks = self.hands.chunks(pairs).zip(self.eyes.chunks(pairs));
        let rounding = 8.0 * f64::EPSILON;
        let least: Vec<f64> = chunks.map(|(a, b)| rounding * longest(a).max(longest(b))).collect();
        let of = Problems {
            rule,
            lengths: &OF_MOTIONS,
            pairs,
            weights: self.weights,
            least: &least,
            settled: 1e-6,
        };
        let mut factors = vec![1.0; self.hands.len()];
        let solve = &mut |active: &[usize], weights: &[f64], residuals: &mut [f64]| {
            let of_active = |of: &[[f64; 8]]| -> Vec<[f64; 8]> {
                active.iter().flat_map(|at| &of[at * pairs..(at + 1) * pairs]).copied().collect()
            };
            // A single problem, which may be large, is not copied.
            let (hands, eyes) = if active.len() == least.len() {
                (Cow::Borrowed(self.hands), Cow::Borrowed(self.eyes))
            } else {
                (Cow::Owned(of_active(self.hands)), Cow::Owned(of_active(self.eyes)))
            };
            let now = Given { hands: &hands, eyes: &eyes, weights, pairs };
            let mut found = vec![[0.0; NUMBERS]; active.len()];
            now.solve(threads, &mut found, residuals);
            for (problem, found) in active.iter().zip(found) {
                to[problem * width..][..NUMBERS].copy_from_slice(&found);
            }
        };
        reweighted(&of, threads, solve, &mut factors);
        for (to, factors) in to.chunks_mut(width).zip(factors.chunks(pairs)) {
            to[NUMBERS..].copy_from_slice(factors);
        }
    }
}

/// Returns `true` if a piece of [`PAIRS`] pairs ends with pair `at` of a problem.
fn is_end(at: usize) -> bool {
    at % PAIRS == PAIRS - 1
}

/// The squares of the singular values of the equations of a problem, and the right singular
/// vectors, each a row, in no order.
#[derive(Clone, Copy, Default)]
struct Decomposed {
    squares: [f64; 8],
    vectors: [[f64; 8]; 8],
}

impl Decomposed {
    /// X, and the singular values from the largest on.
    fn solution(&self) -> (DualQuat<f64>, [f64; 8]) {
        let nan = DualQuat::from_array([f64::NAN; 8]);
        if !self.squares.iter().all(|square| square.is_finite()) {
            return (nan, [f64::NAN; 8]);
        }
        let mut order = [0, 1, 2, 3, 4, 5, 6, 7];
        order.sort_unstable_by(|&a, &b| self.squares[b].total_cmp(&self.squares[a]));
        let sizes = order.map(|at| self.squares[at].sqrt());
        let (first, last) = (&self.vectors[order[6]], &self.vectors[order[7]]);
        // X is that sum of the two vectors that is unit: λ²u₁·v₁ + λ(u₁·v₂ +
        // u₂·v₁) + u₂·v₂ = 0 has two solutions, of which the other one has no real part.
        let across = |a: &[f64; 8], b: &[f64; 8]| -> f64 {
            a[..4].iter().zip(&b[4..]).map(|(u, v)| u * v).sum()
        };
        let (a, c) = (across(first, first), across(last, last));
        let b = across(first, last) + across(last, first);
        let half = -0.5 * (b + (b * b - 4.0 * a * c).max(0.0).sqrt().copysign(b));
        let sum = |x: f64, y: f64| -> [f64; 8] {
            let both = |at: usize| x * first[at] + y * last[at];
            let sum = std::array::from_fn(both);
            let length = sum.iter().map(|number| number * number).sum::<f64>().sqrt();
            sum.map(|number| number / length.max(1e-300))
        };
        let real = |of: &[f64; 8]| of[..4].iter().map(|number| number * number).sum::<f64>();
        let (one, other) = (sum(half, a), sum(c, half));
        let larger = if real(&one) > real(&other) { one } else { other };
        let sign = if larger[3] < 0.0 { -1.0 } else { 1.0 };
        (DualQuat::from_array(larger.map(|number| sign * number)).normalize(), sizes)
    }
}

/// Decomposes the equations of as many problems as `to` has elements, one in each lane.
struct Decompose<'s> {
    given: Given<'s>,
    /// The threads of the call, which end the work early if they are interrupted.
    threads: &'s Threads,
    to: &'s mut [Decomposed],
}

impl Kernel for Decompose<'_> {
    type Output = ();
    // Its rotations fill the registers of AVX2 already.
    const WIDE: bool = false;

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        type L<V> = <V as Level>::Double;
        let Self { given: Given { hands, eyes, weights, pairs }, threads, to } = self;
        let (lanes, zero) = (L::<V>::LANES, L::<V>::splat(level, 0.0));
        for (group, to) in to.chunks_mut(lanes).enumerate() {
            let mut triangle = [[zero; 8]; 8];
            for at in 0..pairs {
                if is_end(at) && threads.interrupted() {
                    return;
                }
                let pair = group * lanes * pairs + at;
                let [a, b] = [hands, eyes].map(
                    #[inline(always)]
                    |all| {
                        let from = all.get(pair..).unwrap_or_default();
                        L::<V>::load_strided(level, from, Some(pairs), &[0.0; 8])
                    },
                );
                let mut rows = equations(a, b);
                if !weights.is_empty() {
                    let from = weights.as_chunks::<1>().0.get(pair..).unwrap_or_default();
                    let [weight] = L::<V>::load_strided(level, from, Some(pairs), &[0.0]);
                    let root = weight.sqrt();
                    for number in rows.as_flattened_mut() {
                        *number = *number * root;
                    }
                }
                fold(zero, &mut triangle, &mut rows);
            }
            let vectors = orthogonal(zero, &mut triangle);
            for (at, vector) in vectors.iter().enumerate() {
                let square = dot(zero, &triangle[at], &triangle[at]).to_array();
                for (to, &square) in to.iter_mut().zip(square.as_ref()) {
                    to.squares[at] = square;
                }
                for (place, number) in vector.iter().enumerate() {
                    for (to, &number) in to.iter_mut().zip(number.to_array().as_ref()) {
                        to.vectors[at][place] = number;
                    }
                }
            }
        }
    }
}

/// The vector parts of ``a x − x b``, linear in x: ``(a + b) × x + (a − b)w`` of the real
/// parts, and the same of the dual parts.
#[inline(always)]
fn equations<L: Lanes>(a: [L; 8], b: [L; 8]) -> [[L; 8]; 6] {
    let zero = a[0].constant(0.0);
    let mut rows = [[zero; 8]; 6];
    for half in 0..2 {
        let at = 4 * half;
        let [x, y, z] = [a[at] + b[at], a[at + 1] + b[at + 1], a[at + 2] + b[at + 2]];
        let [u, v, w] = [a[at] - b[at], a[at + 1] - b[at + 1], a[at + 2] - b[at + 2]];
        let block = [[zero, -z, y, u], [z, zero, -x, v], [-y, x, zero, w]];
        for (row, block) in block.iter().enumerate() {
            if half == 0 {
                rows[row][..4].copy_from_slice(block);
                rows[3 + row][4..].copy_from_slice(block);
            } else {
                rows[3 + row][..4].copy_from_slice(block);
            }
        }
    }
    rows
}

/// Makes `triangle` the upper triangle R of the QR decomposition of itself and more `rows`, by
/// reflections.
#[inline(always)]
fn fold<L: Lanes>(zero: L, triangle: &mut [[L; 8]; 8], rows: &mut [[L; 8]; 6]) {
    for column in 0..8 {
        let own = triangle[column][column];
        let mut square = own * own;
        for row in &*rows {
            square = row[column].mul_add(row[column], square);
        }
        let length = square.sqrt();
        let diagonal = L::select(own.lt(zero), length, -length);
        let first = own - diagonal;
        // Of a column of zeros nothing is reflected.
        let scale = square + length * own.abs();
        let scale = L::select(scale.eq(zero), zero, zero.constant(1.0) / scale);
        for other in column + 1..8 {
            let mut along = first * triangle[column][other];
            for row in &*rows {
                along = row[column].mul_add(row[other], along);
            }
            let along = along * scale;
            triangle[column][other] = triangle[column][other] - along * first;
            for row in &mut *rows {
                row[other] = row[other] - along * row[column];
            }
        }
        triangle[column][column] = diagonal;
    }
}

/// As many sweeps as columns of nearly equal length may take.
const SWEEPS: usize = 20;

/// Turns the columns of a matrix until they are orthogonal: R V = UΣ (Hestenes' form of Jacobi's
/// method). The rows of `matrix` become the columns of UΣ; what is returned are the columns of V.
#[inline(always)]
fn orthogonal<L: Lanes>(zero: L, matrix: &mut [[L; 8]; 8]) -> [[L; 8]; 8] {
    let one = zero.constant(1.0);
    let mut columns = [[zero; 8]; 8];
    let mut vectors = [[zero; 8]; 8];
    for at in 0..8 {
        vectors[at][at] = one;
        for row in 0..8 {
            columns[at][row] = matrix[row][at];
        }
    }
    let least = zero.constant(4.0 * f64::EPSILON);
    for _ in 0..SWEEPS {
        let mut turned = !zero.eq(zero);
        for i in 0..7 {
            for j in i + 1..8 {
                let a = dot(zero, &columns[i], &columns[i]);
                let b = dot(zero, &columns[j], &columns[j]);
                let product = dot(zero, &columns[i], &columns[j]);
                // What one of them has of the other is rounding of the longer one.
                let is_small = product.abs().le(least * L::select(a.lt(b), b, a));
                turned = turned | (!is_small & product.eq(product));
                let half = (b - a) / (product + product);
                let size = one / (half.abs() + (half * half + one).sqrt());
                let tangent = L::select(half.lt(zero), -size, size);
                let tangent = L::select(is_small, zero, tangent);
                let cosine = one / (tangent * tangent + one).sqrt();
                let sine = tangent * cosine;
                for all in [&mut columns, &mut vectors] {
                    let (before, from) = all.split_at_mut(j);
                    for (one, other) in before[i].iter_mut().zip(&mut from[0]) {
                        let (x, y) = (*one, *other);
                        *one = cosine * x - sine * y;
                        *other = sine * x + cosine * y;
                    }
                }
            }
        }
        if !turned.any() {
            break;
        }
    }
    *matrix = columns;
    vectors
}

#[inline(always)]
fn dot<L: Lanes>(zero: L, a: &[L; 8], b: &[L; 8]) -> L {
    let mut sum = zero;
    for (x, y) in a.iter().zip(b) {
        sum = x.mul_add(*y, sum);
    }
    sum
}
