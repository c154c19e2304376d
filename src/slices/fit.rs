//! The kernel that fits maps to many sets of pairs of points.

use crate::backend::{Backend, Kernel, Rows};
use crate::batch::{polar, vector as lanes};
use crate::fit::{Fit, FitError, Maps, PairSets, Quality, SetNumbers, Sums, same_length};
use crate::geometry::vector;
use crate::number::Scalar;
use crate::storage::{Element, Tile};
use dq8_simd::{Lanes, Level, MAX_LANES};

/// The fewest sets in a task: some dozens of microseconds of work.
const GRAIN: usize = 64;

impl Backend {
    /// Finds the best map of each set of pairs, and its quality: `fits[i]` and `qualities[i]` have
    /// the bits that [`PointPairs`](crate::fit::PointPairs) gives for the pairs of set `i` alone.
    /// A set occupies one lane, so sets of about as many pairs should lie side by side.
    ///
    /// A set that has no best map does not disturb the other sets. It is answered with
    /// [`Fit::NONE`]. If many rotations fit equally well, its quality has the rank of the pairs and
    /// an infinite condition; if the set has no pair with a weight, a bad weight, or a number that
    /// is not finite or overflows, its quality is [`Quality::NONE`].
    ///
    /// ```
    /// use dq8::Backend;
    /// use dq8::fit::{Fit, Maps, PairSets, Quality};
    /// // A triangle that is shifted, and two points, which do not determine a rotation.
    /// let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0; 3], [1.0; 3]];
    /// let moved = points.map(|[x, y, z]| [x + 1.0, y, z]);
    /// let sets = PairSets::<f64>::new(&points, &moved, &[3, 2])?;
    /// let (mut fits, mut qualities) = ([Fit::NONE; 2], [Quality::NONE; 2]);
    /// Backend::best().fit_each(sets, Maps::Rigid, &mut fits, &mut qualities)?;
    /// assert!((fits[0].motion.translation()[0] - 1.0).abs() < 1e-14 && qualities[0].rank == 2);
    /// assert!(fits[1].motion.translation()[0].is_nan() && qualities[1].rank == 1);
    /// # Ok::<(), dq8::fit::FitError>(())
    /// ```
    ///
    /// # Errors
    /// If `fits` or `qualities` has another length than the number of sets, or the axis of
    /// [`Maps::About`] has no direction. Then nothing is written.
    pub fn fit_each<R: Scalar>(
        self,
        sets: PairSets<'_, R>,
        maps: Maps<R>,
        fits: &mut [Fit<R>],
        qualities: &mut [Quality<R>],
    ) -> Result<(), FitError> {
        same_length("fits", fits.len(), sets.len())?;
        same_length("qualities", qualities.len(), sets.len())?;
        maps.check()?;
        let outputs = ((fits, 1), (qualities, 1));
        // Each task sums the counts before it, so there are at most 256 tasks.
        let grain = GRAIN.max(sets.len().div_ceil(256).next_multiple_of(MAX_LANES));
        self.share(grain, outputs, &|first, outputs: (Rows<'_, Fit<R>>, Rows<'_, Quality<R>>)| {
            let ((fits, _), (qualities, _)) = outputs;
            let (before, counts) = sets.counts.split_at(first);
            let start = before.iter().sum();
            self.run(FitEach { sets, counts, start, maps, fits, qualities });
        });
        Ok(())
    }
}

/// The fits of as many sets as `fits` has elements.
struct FitEach<'s, R> {
    sets: PairSets<'s, R>,
    /// The number of pairs of each of these sets, and perhaps of further sets.
    counts: &'s [usize],
    /// The index of the first pair of the first set.
    start: usize,
    maps: Maps<R>,
    fits: &'s mut [Fit<R>],
    qualities: &'s mut [Quality<R>],
}

impl<R: Scalar> Kernel for FitEach<'_, R> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { sets, counts, mut start, maps, fits, qualities } = self;
        let together = R::Lanes::<V>::LANES;
        let outputs = fits.chunks_mut(together).zip(qualities.chunks_mut(together));
        for ((fits, qualities), counts) in outputs.zip(counts.chunks(together)) {
            let mut group = Group { sets, starts: [0; MAX_LANES], counts: [0; MAX_LANES], most: 0 };
            let slots = group.starts.iter_mut().zip(&mut group.counts);
            for ((slot, to), &count) in slots.zip(counts).take(fits.len()) {
                (*slot, *to) = (start, count);
                group.most = group.most.max(count);
                start += count;
            }
            let numbers = group.numbers::<V>(level);
            let mut rows = [[R::ZERO; 39]; MAX_LANES];
            Element::store::<V>(numbers.into_array(), &mut rows, Tile::at(0, 0));
            let places = group.starts.into_iter().zip(group.counts);
            let outputs = fits.iter_mut().zip(qualities);
            for ((place, row), (fit, quality)) in places.zip(rows).zip(outputs) {
                let (start, count) = place;
                let numbers = SetNumbers::from_array(row);
                (*fit, *quality) = sets.best(start..start + count, &numbers, maps);
            }
        }
    }
}

/// The sets in the lanes of one register. Lanes without a set have no pair.
struct Group<'s, R> {
    sets: PairSets<'s, R>,
    /// The index of the first pair of each set.
    starts: [usize; MAX_LANES],
    counts: [usize; MAX_LANES],
    /// The largest of the counts.
    most: usize,
}

/// A pair of each set. In the lanes of sets that have fewer pairs, all numbers are zero.
struct Pairs<L> {
    pair: [[L; 3]; 2],
    weight: L,
}

impl<R: Scalar> Group<'_, R> {
    /// Computes the sums in the order in which one set alone is summed, without fusing a product
    /// with a sum, so that the bits are the same. A pair without a weight is replaced by the first
    /// pair with a weight: it then adds a zero to sums that are never −0.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn numbers<V: Level>(&self, level: V) -> SetNumbers<R::Lanes<V>> {
        let [zero, one] = [R::ZERO, R::ONE].map(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |number| R::Lanes::<V>::splat(level, number),
        );
        let mut good = zero.eq(zero);
        let mut heaviest = if self.sets.weights.is_some() { zero } else { one };
        for index in 0..self.most {
            let Pairs { pair: [[a, b, c], [d, e, f]], weight } = self.load::<V>(level, index);
            let finite = lanes::are_finite([a, b, c, d, e, f, weight]);
            good = good & finite & zero.le(weight);
            heaviest = larger(heaviest, weight);
        }

        let mut first = [[zero; 3]; 2];
        let mut seen = one.lt(zero);
        let (mut count, mut total) = (zero, zero);
        let (mut sums, mut furthest) = ([[zero; 3]; 2], [zero; 2]);
        for index in 0..self.most {
            let Pairs { pair, weight } = self.load::<V>(level, index);
            let weight = weight / heaviest;
            let counts = zero.lt(weight);
            let weight = R::Lanes::<V>::select(counts, weight, zero);
            count = count + R::Lanes::<V>::select(counts, one, zero);
            total = total + weight;
            for side in 0..2 {
                first[side] = lanes::select(counts & !seen, pair[side], first[side]);
                let point = lanes::select(counts, pair[side], first[side]);
                let away = vector::sub(point, first[side]);
                sums[side] = vector::add(sums[side], vector::scale(away, weight));
                let [x, y, z] = [point[0].abs(), point[1].abs(), point[2].abs()];
                furthest[side] = larger(furthest[side], larger(larger(x, y), z));
            }
            seen = seen | counts;
        }
        let mut means = sums;
        for component in means.as_flattened_mut() {
            *component = *component / total;
        }

        let (mut products, mut squares) = ([[zero; 3]; 3], [zero; 2]);
        for index in 0..self.most {
            let Pairs { pair, weight } = self.load::<V>(level, index);
            let weight = weight / heaviest;
            let counts = zero.lt(weight);
            let weight = R::Lanes::<V>::select(counts, weight, zero);
            let mut relative = [[zero; 3]; 2];
            let mut heavy = relative;
            for side in 0..2 {
                let point = lanes::select(counts, pair[side], first[side]);
                relative[side] = vector::sub(vector::sub(point, first[side]), means[side]);
                heavy[side] = vector::scale(relative[side], weight);
                squares[side] = squares[side] + vector::dot(relative[side], heavy[side]);
            }
            for row in 0..3 {
                products[row] =
                    vector::add(products[row], vector::scale(heavy[0], relative[1][row]));
            }
        }

        let lengths = [squares[0].sqrt(), squares[1].sqrt()];
        let of_points = furthest[0] * lengths[1] + furthest[1] * lengths[0];
        let of_sums = zero.constant(8.0) * count.sqrt() * lengths[0] * lengths[1];
        let of_both = zero.constant(2.0) * total.sqrt() * of_points + of_sums;
        let rounding = zero.constant(lanes::epsilon::<R::Lanes<V>>()) * of_both;
        let rounding = rounding + zero.constant(1e-37_f32.into()) * total;
        let good = good & zero.lt(count);
        let rounding = R::Lanes::<V>::select(good, rounding, zero.constant(f64::NAN));
        let mut centers = first;
        for side in 0..2 {
            centers[side] = vector::add(first[side], means[side]);
        }

        let mut largest = zero;
        for element in products.as_flattened() {
            largest = larger(largest, element.abs());
        }
        // A matrix of zeros settles at once, so a bad set does not make its neighbours wait.
        let known = lanes::is_finite(rounding) & zero.lt(largest);
        let mut matrix = products;
        for element in matrix.as_flattened_mut() {
            *element = R::Lanes::<V>::select(known, *element / largest, zero);
        }
        let (values, vectors) = polar::eigen(polar::horn(matrix));
        let sums = Sums { centers, products, squares: squares[0], rounding };
        SetNumbers { sums, heaviest, largest, values, vectors }
    }

    /// Loads the pair with this index of each set.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(&self, level: V, index: usize) -> Pairs<R::Lanes<V>> {
        let zero = R::Lanes::<V>::splat(level, R::ZERO).to_array();
        let mut pair = [[zero; 3]; 2];
        let mut weights = zero;
        let sides = [self.sets.points, self.sets.moved];
        for (lane, slot) in weights.as_mut().iter_mut().enumerate() {
            if index >= self.counts[lane] {
                continue;
            }
            let at = self.starts[lane] + index;
            // The constructors of the sets have checked the lengths, so no number is missing.
            let weight = |weights: &[R]| weights.get(at).copied().unwrap_or_default();
            *slot = self.sets.weights.map_or(R::ONE, weight);
            for (rows, points) in pair.iter_mut().zip(sides) {
                let point = points.get(at).copied().unwrap_or_default();
                for (row, number) in rows.iter_mut().zip(point) {
                    row.as_mut()[lane] = number;
                }
            }
        }
        let [[a, b, c], [d, e, f]] = &pair;
        let load = R::Lanes::<V>::load;
        Pairs {
            pair: [
                [load(level, a), load(level, b), load(level, c)],
                [load(level, d), load(level, e), load(level, f)],
            ],
            weight: load(level, &weights),
        }
    }
}

/// Returns the larger of two numbers that are not NaN.
#[cfg_attr(not(opt_level_0), inline(always))]
fn larger<L: Lanes>(a: L, b: L) -> L {
    L::select(a.lt(b), b, a)
}
