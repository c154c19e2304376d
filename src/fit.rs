//! The map with the least squares between moved points and given points: rigid, about one axis, or
//! with a scale.
//!
//! ```
//! use dq8::fit::PointPairs;
//! // Three marks of a plan, and where a survey found them: turned by a quarter, and shifted.
//! let plan = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
//! let survey = [[10.0, 5.0, 1.0], [10.0, 9.0, 1.0], [7.0, 5.0, 1.0_f64]];
//! let pairs = PointPairs::new(&plan, &survey)?;
//! let fit = pairs.rigid()?;
//! let [x, y, z] = fit.motion.transform_point([4.0, 3.0, 0.0]);
//! assert!((x - 7.0).abs() + (y - 9.0).abs() + (z - 1.0).abs() < 1e-14);
//! // How well it fits, and how well the points tell it: marks in a plane have the rank 2.
//! let quality = pairs.quality(&fit);
//! assert!(quality.rms < 1e-14 && quality.rank == 2 && quality.condition < 5.0);
//! # Ok::<(), dq8::fit::FitError>(())
//! ```

use crate::macros::errors;
use crate::number::Real;
use crate::representation::polar::Spectrum;
use crate::scalar::{DualQuat, Quat, vector};
use core::ops::Range;

/// Pairs of a point x and the moved point y, each with a weight w ≥ 0. All coordinates are in one
/// unit of length.
///
/// The sums that every fit needs are computed once, from differences to the weighted means. Points
/// far from the origin therefore lose no digits of their coordinates.
#[derive(Clone, Copy, Debug)]
pub struct PointPairs<'a, R> {
    pairs: Weighted<'a, R>,
    sums: Sums<R>,
}

/// The sums over pairs that a fit needs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sums<R> {
    /// The weighted means of the points x and of the moved points y.
    pub(crate) centers: [[R; 3]; 2],
    /// Σ w y xᵀ, with x and y relative to their means.
    pub(crate) products: [[R; 3]; 3],
    /// Σ w|x|², with x relative to its mean.
    pub(crate) squares: R,
    /// A bound of the rounding error of a sum of elements of `products`. It is NaN or infinite if
    /// nothing can be fitted.
    pub(crate) rounding: R,
}

/// The map p ↦ s·r (p − c) r* + d with the least squares. The scale s is 1, except for maps
/// from [`PointPairs::similarity`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fit<R> {
    /// The rotation r, then the translation t = d − s·r c r*. The map is p ↦ s·r p r* + t, so
    /// a point is first multiplied by the scale and then moved. r has w ≥ 0, except for maps from
    /// [`PointPairs::about`].
    pub motion: DualQuat<R>,
    /// The scale s > 0.
    pub scale: R,
    /// The weighted mean c of the points.
    pub from: [R; 3],
    /// The weighted mean d of the moved points.
    pub to: [R; 3],
}

impl<R: Real> Fit<R> {
    /// Returns the image s·r (p − c) r* + d of a point p. Far from the origin it keeps digits
    /// that [`motion`](Self::motion) loses, because the translation of `motion` may be long.
    #[must_use]
    pub fn transform_point(&self, point: [R; 3]) -> [R; 3] {
        vector::add(self.to, self.turned(point))
    }

    /// Returns s·r (p − c) r*, the point turned and scaled about the mean c of the points.
    #[inline]
    fn turned(&self, point: [R; 3]) -> [R; 3] {
        let point = vector::scale(vector::sub(point, self.from), self.scale);
        self.motion.rotation().rotate(point)
    }
}

/// The quality of a fitted map, and how well the pairs determine a rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Quality<R> {
    /// The weighted root mean square √(Σ w|y − f(x)|² / Σ w) of the distances left by the
    /// map f, a length.
    pub rms: R,
    /// The count of singular values of Σ w y xᵀ, with x and y relative to their means, that are
    /// more than rounding: 3 for points in space, 2 in a plane, 1 on a line, 0 in a point.
    pub rank: usize,
    /// The ratio (σ₁ + σ₂)/(σ₂ ± σ₃) of these singular values, with a minus if the
    /// determinant is negative. It compares two stiffnesses: the stiffness of the pairs against the
    /// turn that they resist most, over the stiffness against the turn that they resist least. It
    /// is infinite where many rotations fit equally well.
    pub condition: R,
    /// Whether the points are mirrored: a map with a reflection, which is no motion, would leave
    /// less than a hundredth of the squares that the fit leaves. One of the two sets then has
    /// left-handed coordinates. Points that lie nearly in a plane (1000|σ₃| < σ₂) are never
    /// called mirrored, because noise mirrors half of such sets.
    pub mirrored: bool,
}

impl<R: Real> Fit<R> {
    /// The answer where there is no best map: NaN in every component.
    pub const NONE: Self = Self {
        motion: DualQuat::from_array([R::NAN; 8]),
        scale: R::NAN,
        from: [R::NAN; 3],
        to: [R::NAN; 3],
    };
}

impl<R: Real> Quality<R> {
    /// The quality of pairs that no map can be fitted to: NaN, with the rank 0.
    pub const NONE: Self = Self { rms: R::NAN, rank: 0, condition: R::NAN, mirrored: false };
}

impl<'a, R: Real> PointPairs<'a, R> {
    /// Makes pairs that all have the same weight.
    ///
    /// # Errors
    /// If the lengths of the slices differ, there is no pair, a coordinate is not finite, or a
    /// square of a distance overflows.
    pub fn new(points: &'a [[R; 3]], moved: &'a [[R; 3]]) -> Result<Self, FitError> {
        Self::sums(Weighted { points, moved, weights: None, heaviest: R::ONE })
    }

    /// Makes pairs with weights, of which only the ratios matter. A pair with the weight 2 counts
    /// like two equal pairs, and a pair with the weight zero has no influence.
    ///
    /// ```
    /// use dq8::fit::{FitError, PointPairs};
    /// let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0_f32]];
    /// // The last one was measured wrongly.
    /// let moved = [[0.0, 0.0, 2.0], [1.0, 0.0, 2.0], [0.0, 1.0, 2.0], [9.0, 9.0, 9.0]];
    /// let fit = PointPairs::weighted(&points, &moved, &[1.0, 1.0, 1.0, 0.0])?.rigid()?;
    /// let [x, y, z] = fit.motion.translation();
    /// assert!(x.abs() + y.abs() + (z - 2.0).abs() < 1e-6);
    /// let negative = PointPairs::weighted(&points, &moved, &[1.0, -1.0, 1.0, 0.0]);
    /// assert_eq!(negative.unwrap_err(), FitError::Weight { index: 1, value: -1.0 });
    /// # Ok::<(), FitError>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`new`](Self::new), and an error if a weight is negative or not finite, or if
    /// all weights are zero. Points with the weight zero must be finite too.
    pub fn weighted(
        points: &'a [[R; 3]],
        moved: &'a [[R; 3]],
        weights: &'a [R],
    ) -> Result<Self, FitError> {
        same_length("weights", weights.len(), points.len())?;
        let bad = |weight: R| !weight.is_finite() || weight < R::ZERO;
        if let Some((index, &value)) = weights.iter().enumerate().find(|(_, w)| bad(**w)) {
            return Err(FitError::Weight { index, value: value.into() });
        }
        let heaviest = weights.iter().fold(R::ZERO, |most, weight| most.max_or_nan(*weight));
        Self::sums(Weighted { points, moved, weights: Some(weights), heaviest })
    }

    fn sums(pairs: Weighted<'a, R>) -> Result<Self, FitError> {
        same_length("moved", pairs.moved.len(), pairs.points.len())?;
        finite("points", pairs.points)?;
        finite("moved", pairs.moved)?;
        let (first, _) = pairs.iter().next().ok_or(FitError::Empty)?;
        let away = |[x, y]: [[R; 3]; 2]| [vector::sub(x, first[0]), vector::sub(y, first[1])];
        // The means are computed from differences to one of the points. Sums of the coordinates
        // themselves would lose digits, because points far from the origin have their leading
        // digits in common.
        let (mut count, mut total) = (R::ZERO, R::ZERO);
        let (mut sums, mut furthest) = ([[R::ZERO; 3]; 2], [R::ZERO; 2]);
        for (pair, weight) in pairs.iter() {
            count += R::ONE;
            total += weight;
            for (side, away) in away(pair).into_iter().enumerate() {
                sums[side] = vector::add(sums[side], vector::scale(away, weight));
                furthest[side] = furthest[side].max_or_nan(vector::largest(pair[side]));
            }
        }
        let means = sums.map(|sum| sum.map(|c| c / total));
        let (mut products, mut squares) = ([[R::ZERO; 3]; 3], [R::ZERO; 2]);
        for (pair, weight) in pairs.iter() {
            let [x, y] = away(pair);
            let (x, y) = (vector::sub(x, means[0]), vector::sub(y, means[1]));
            let heavy = [vector::scale(x, weight), vector::scale(y, weight)];
            for (row, y) in products.iter_mut().zip(y) {
                *row = vector::add(*row, vector::scale(heavy[0], y));
            }
            squares =
                [squares[0] + vector::dot(x, heavy[0]), squares[1] + vector::dot(y, heavy[1])];
        }
        // A coordinate is rounded in proportion to its distance from the origin, and a sum is
        // rounded once for each pair. The last term covers squares that are subnormal in `f32`.
        let lengths = squares.map(Real::sqrt);
        let of_points = furthest[0] * lengths[1] + furthest[1] * lengths[0];
        let of_sums = R::from(8.0) * count.sqrt() * lengths[0] * lengths[1];
        let rounding = R::EPSILON * (R::TWO * total.sqrt() * of_points + of_sums);
        let rounding = rounding + R::from(1e-37) * total;
        let centers = [0, 1].map(|side| vector::add(first[side], means[side]));
        if !rounding.is_finite() {
            return Err(FitError::Overflow);
        }
        let sums = Sums { centers, products, squares: squares[0], rounding };
        Ok(Self { pairs, sums })
    }

    /// Finds the motion f with the least Σ w|y − f(x)|² (Horn 1987; Umeyama 1991). The best
    /// orthogonal matrix may mirror, which noise causes for half of all sets in a plane. The
    /// smallest axis is then reversed, so that the result is still a rotation.
    ///
    /// # Errors
    /// If many rotations fit equally well within rounding: one of the sets is on a line or in a
    /// point (fewer than three points always are), or the points mirror and their two smaller
    /// singular values are equal. In `f32`, points closer than about 1e-18 count as one point. Also
    /// if the map overflows.
    pub fn rigid(&self) -> Result<Fit<R>, FitError> {
        self.best_of_all(self.spectrum().as_ref(), false)
    }

    /// Finds the map with the least squares among rigid maps with a scale, s = (σ₁ + σ₂ ±
    /// σ₃)/Σ w|x|² with the singular values of Σ w y xᵀ (Umeyama 1991, equation 42).
    ///
    /// ```
    /// use dq8::fit::PointPairs;
    /// let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0_f64]];
    /// let fit = PointPairs::new(&points, &points.map(|p| p.map(|c| 2.5 * c)))?.similarity()?;
    /// assert!((fit.scale - 2.5).abs() < 1e-14);
    /// # Ok::<(), dq8::fit::FitError>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`rigid`](Self::rigid).
    pub fn similarity(&self) -> Result<Fit<R>, FitError> {
        self.best_of_all(self.spectrum().as_ref(), true)
    }

    /// Finds the motion with the least squares among those that turn about the direction `axis`, of
    /// any length but zero, and shift in any direction. The axis [0, 0, 1] fits the yaw of a sensor
    /// that knows the vertical. The angle is atan2(a·Σ w x×y, Σ w x·y across the axis a).
    ///
    /// ```
    /// use dq8::fit::PointPairs;
    /// // Two points are enough.
    /// let pairs = PointPairs::new(
    ///     &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]],
    ///     &[[5.0, 0.0, 0.0], [5.0, 1.0, 0.1_f64]],
    /// )?;
    /// let (_, angle) = pairs.about([0.0, 0.0, 1.0])?.motion.rotation().to_axis_angle();
    /// assert!((angle - core::f64::consts::FRAC_PI_2).abs() < 1e-14);
    /// # Ok::<(), dq8::fit::FitError>(())
    /// ```
    ///
    /// # Errors
    /// If the axis has no direction; if one of the sets, seen along the axis, is in a point within
    /// rounding; or if the map overflows.
    pub fn about(&self, axis: [R; 3]) -> Result<Fit<R>, FitError> {
        let axis = direction(axis)?;
        // For the turn by ψ, the sum of the products of elements is (uMu + vMv) cos ψ + (vMu −
        // uMv) sin ψ, plus a constant, where M is `products`. The coordinates u and v are
        // orthogonal to the axis, so large components along the axis cost no digits.
        let u = vector::any_across(axis);
        let v = vector::cross(axis, u);
        let [to_u, to_v] = [u, v].map(|of| self.sums.products.map(|row| vector::dot(row, of)));
        let cosine = vector::dot(u, to_u) + vector::dot(v, to_v);
        let sine = vector::dot(v, to_u) - vector::dot(u, to_v);
        let gap = vector::norm([cosine, sine]);
        let rotation = Quat::from_axis_angle(axis, sine.atan2(cosine));
        let ambiguous = || self.ambiguous(self.spectrum().as_ref());
        self.fit(rotation, gap, R::ONE, ambiguous)
    }

    /// Returns the root mean square of the distances that a fit of these pairs leaves, and the rank
    /// and the condition of the pairs. Both are those for a free rotation, even if the fit turns
    /// about a given axis.
    #[must_use]
    pub fn quality(&self, fit: &Fit<R>) -> Quality<R> {
        self.quality_of(self.spectrum().as_ref(), fit)
    }

    fn quality_of(&self, spectrum: Option<&Spectrum<R>>, fit: &Fit<R>) -> Quality<R> {
        let (mut total, mut sum) = (R::ZERO, R::ZERO);
        for ([x, y], weight) in self.pairs.iter() {
            let left = vector::sub(vector::sub(y, fit.to), fit.turned(x));
            total += weight;
            sum += weight * vector::dot(left, left);
        }
        let values = self.singular_values(spectrum);
        let [first, second, third] = values;
        let gap = second + third;
        let condition =
            if gap > self.sums.rounding { (first + second) / gap } else { R::ONE / R::ZERO };
        // The best reflection leaves less by 4|σ₃|, and with a scale of its own by
        // 4(σ₁ + σ₂)|σ₃|/Σ w|x|².
        let scale = if fit.scale == R::ONE { R::ONE } else { (first + second) / self.sums.squares };
        let gained = R::from(-4.0) * scale * third;
        let in_space = -third > self.sums.rounding && R::from(-1e3) * third > second;
        let mirrored = in_space && gained > R::from(0.99) * sum;
        Quality { rms: (sum / total).sqrt(), rank: self.rank(values), condition, mirrored }
    }

    /// Returns `None` if the products are zero or not finite.
    fn spectrum(&self) -> Option<Spectrum<R>> {
        Spectrum::of(self.sums.products).ok()
    }

    fn singular_values(&self, spectrum: Option<&Spectrum<R>>) -> [R; 3] {
        let largest = || [vector::largest(self.sums.products.map(vector::largest)); 3];
        spectrum.map_or_else(largest, Spectrum::singular_values)
    }

    fn rank(&self, values: [R; 3]) -> usize {
        values.into_iter().filter(|value| value.abs() > self.sums.rounding).count()
    }

    fn best_of_all(
        &self,
        spectrum: Option<&Spectrum<R>>,
        scaled: bool,
    ) -> Result<Fit<R>, FitError> {
        // Only the mixed term of Σ w|y − s·r x r*|² depends on the rotation. It is the sum of
        // the products of the rotation's elements and the elements of `products`, which must become
        // as large as possible.
        let best = spectrum.and_then(|spectrum| spectrum.best_rotation().ok());
        let (rotation, [sum, gap]) = best.ok_or_else(|| self.ambiguous(spectrum))?;
        let scale = if scaled { sum / self.sums.squares } else { R::ONE };
        self.fit(rotation, gap, scale, || self.ambiguous(spectrum))
    }

    /// Returns the map with this rotation if every other rotation fits worse by more than
    /// rounding. `gap` measures how much worse the others fit.
    fn fit(
        &self,
        rotation: Quat<R>,
        gap: R,
        scale: R,
        ambiguous: impl FnOnce() -> FitError,
    ) -> Result<Fit<R>, FitError> {
        // The comparison is false if the gap is NaN.
        let clear = gap > self.sums.rounding;
        if !clear {
            return Err(ambiguous());
        }
        let [from, to] = self.sums.centers;
        let shift = rotation.rotate(vector::scale(from, scale));
        let motion = DualQuat::from_rotation_translation(rotation, vector::sub(to, shift));
        if !(motion.is_finite() && scale.is_finite()) {
            return Err(FitError::Overflow);
        }
        Ok(Fit { motion, scale, from, to })
    }

    fn ambiguous(&self, spectrum: Option<&Spectrum<R>>) -> FitError {
        let rank = self.rank(self.singular_values(spectrum));
        FitError::Ambiguous { pairs: self.pairs.iter().count(), rank }
    }
}

/// The maps among which [`Backend::fit_each`](crate::Backend::fit_each) finds the best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Maps<R> {
    /// Motions, as for [`PointPairs::rigid`].
    Rigid,
    /// Motions with a scale, as for [`PointPairs::similarity`].
    Similarity,
    /// Motions that turn about this direction, as for [`PointPairs::about`].
    About([R; 3]),
}

impl<R: Real> Maps<R> {
    /// # Errors
    /// If the axis has no direction.
    pub(crate) fn check(self) -> Result<(), FitError> {
        let Self::About(axis) = self else { return Ok(()) };
        direction(axis).map(|_| ())
    }
}

/// Many sets of pairs of points, each of them for a map of its own. The pairs of a set follow the
/// pairs of the set before it in the same slices.
///
/// [`Backend::fit_each`](crate::Backend::fit_each) fits them on lanes.
#[derive(Clone, Copy, Debug)]
pub struct PairSets<'a, R> {
    pub(crate) points: &'a [[R; 3]],
    pub(crate) moved: &'a [[R; 3]],
    pub(crate) weights: Option<&'a [R]>,
    pub(crate) counts: &'a [usize],
}

impl<'a, R: Real> PairSets<'a, R> {
    /// Makes sets whose pairs have the same weight. Set `i` has `counts[i]` pairs, which may be
    /// none.
    ///
    /// # Errors
    /// If `points` does not have as many points as the counts say together, or `moved` has another
    /// length than `points`.
    pub fn new(
        points: &'a [[R; 3]],
        moved: &'a [[R; 3]],
        counts: &'a [usize],
    ) -> Result<Self, FitError> {
        let all = counts.iter().fold(0_usize, |all, &count| all.saturating_add(count));
        same_length("points", points.len(), all)?;
        same_length("moved", moved.len(), all)?;
        Ok(Self { points, moved, weights: None, counts })
    }

    /// Makes sets with weights, of which only the ratios within a set matter.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new), and an error if `weights` has another length than
    /// `points`.
    pub fn weighted(
        points: &'a [[R; 3]],
        moved: &'a [[R; 3]],
        weights: &'a [R],
        counts: &'a [usize],
    ) -> Result<Self, FitError> {
        same_length("weights", weights.len(), points.len())?;
        Ok(Self { weights: Some(weights), ..Self::new(points, moved, counts)? })
    }

    /// Returns the number of sets.
    #[must_use]
    pub fn len(&self) -> usize {
        self.counts.len()
    }

    /// Returns `true` if there is no set.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.counts.is_empty()
    }

    /// Returns the best map of the set whose pairs have these indices, and its quality, from the
    /// numbers that lanes have computed of the set.
    pub(crate) fn best(
        &self,
        pairs: Range<usize>,
        of: &SetNumbers<R>,
        maps: Maps<R>,
    ) -> (Fit<R>, Quality<R>) {
        let none = (Fit::NONE, Quality::NONE);
        let (Some(points), Some(moved)) =
            (self.points.get(pairs.clone()), self.moved.get(pairs.clone()))
        else {
            return none;
        };
        if !of.sums.rounding.is_finite() {
            return none;
        }
        let weights = self.weights.and_then(|weights| weights.get(pairs));
        let weighted = Weighted { points, moved, weights, heaviest: of.heaviest };
        let pairs = PointPairs { pairs: weighted, sums: of.sums };
        let known = of.largest.is_finite() && of.largest > R::ZERO;
        let spectrum = known.then(|| Spectrum::new(of.largest, of.values, of.vectors));
        let spectrum = spectrum.as_ref();
        let fit = match maps {
            Maps::Rigid => pairs.best_of_all(spectrum, false),
            Maps::Similarity => pairs.best_of_all(spectrum, true),
            Maps::About(axis) => pairs.about(axis),
        };
        match fit {
            Ok(fit) => (fit, pairs.quality_of(spectrum, &fit)),
            Err(FitError::Ambiguous { rank, .. }) => {
                (Fit::NONE, Quality { rank, condition: R::ONE / R::ZERO, ..Quality::NONE })
            }
            Err(_) => none,
        }
    }
}

/// The numbers of a set that its fit needs, of one set or of a set in each lane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SetNumbers<T> {
    pub(crate) sums: Sums<T>,
    /// The largest weight.
    pub(crate) heaviest: T,
    /// The largest element of the products.
    pub(crate) largest: T,
    /// The eigenvalues of the matrix that is made of the products over their largest element.
    pub(crate) values: [T; 4],
    /// The eigenvectors, as columns.
    pub(crate) vectors: [[T; 4]; 4],
}

impl<T> SetNumbers<T> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[rustfmt::skip]
    pub(crate) fn into_array(self) -> [T; 39] {
        let Self { sums, heaviest, largest, values: [k, l, m, n], vectors: [q, r, s, t] } = self;
        let Sums { centers: [from, to], products: [x, y, z], squares, rounding } = sums;
        let ([a, b, c], [d, e, f]) = (from, to);
        let ([xx, xy, xz], [yx, yy, yz], [zx, zy, zz]) = (x, y, z);
        let ([qx, qy, qz, qw], [rx, ry, rz, rw]) = (q, r);
        let ([sx, sy, sz, sw], [tx, ty, tz, tw]) = (s, t);
        [
            a, b, c, d, e, f, xx, xy, xz, yx, yy, yz, zx, zy, zz, squares, rounding, heaviest,
            largest, k, l, m, n, qx, qy, qz, qw, rx, ry, rz, rw, sx, sy, sz, sw, tx, ty, tz, tw,
        ]
    }

    #[rustfmt::skip]
    pub(crate) fn from_array(numbers: [T; 39]) -> Self {
        let [
            a, b, c, d, e, f, xx, xy, xz, yx, yy, yz, zx, zy, zz, squares, rounding, heaviest,
            largest, k, l, m, n, qx, qy, qz, qw, rx, ry, rz, rw, sx, sy, sz, sw, tx, ty, tz, tw,
        ] = numbers;
        let products = [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]];
        let vectors = [[qx, qy, qz, qw], [rx, ry, rz, rw], [sx, sy, sz, sw], [tx, ty, tz, tw]];
        let sums = Sums { centers: [[a, b, c], [d, e, f]], products, squares, rounding };
        Self { sums, heaviest, largest, values: [k, l, m, n], vectors }
    }
}

/// Returns the unit vector along an axis.
fn direction<R: Real>(axis: [R; 3]) -> Result<[R; 3], FitError> {
    let length = vector::norm(axis);
    if !length.is_finite() || length == R::ZERO {
        return Err(FitError::Axis { length: length.into() });
    }
    Ok(vector::direction(axis, length))
}

/// The pairs of points and their weights, as the caller gave them.
#[derive(Clone, Copy, Debug)]
struct Weighted<'a, R> {
    points: &'a [[R; 3]],
    moved: &'a [[R; 3]],
    weights: Option<&'a [R]>,
    heaviest: R,
}

impl<R: Real> Weighted<'_, R> {
    /// Returns the pairs whose weight is not zero, each with its weight divided by the largest
    /// weight, so that no sum of weights overflows or becomes zero.
    fn iter(&self) -> impl Iterator<Item = ([[R; 3]; 2], R)> {
        let pairs = self.points.iter().zip(self.moved).enumerate();
        let weight = |index| match self.weights {
            Some(weights) => weights.get(index).map_or(R::ZERO, |weight| *weight / self.heaviest),
            None => R::ONE,
        };
        let weighed = pairs.map(move |(index, (x, y))| ([*x, *y], weight(index)));
        weighed.filter(|(_, weight)| *weight > R::ZERO)
    }
}

pub(crate) fn same_length(
    what: &'static str,
    found: usize,
    expected: usize,
) -> Result<(), FitError> {
    if found == expected { Ok(()) } else { Err(FitError::Length { what, found, expected }) }
}

fn finite<R: Real>(what: &'static str, points: &[[R; 3]]) -> Result<(), FitError> {
    let coordinates = points.iter().enumerate().flat_map(|(i, p)| p.iter().map(move |c| (i, *c)));
    match { coordinates }.find(|(_, c)| !c.is_finite()) {
        Some((index, value)) => Err(FitError::NotFinite { what, index, value: value.into() }),
        None => Ok(()),
    }
}

errors! {
    /// Points for which no best map exists, or many.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    FitError {
        /// A slice has the wrong length.
        Length {
            /// The name of the slice.
            what: &'static str,
            /// The length of the slice.
            found: usize,
            /// The length that it must have.
            expected: usize,
        } => "{what} has the length {found}, but needs the length {expected}";
        /// A coordinate is not finite.
        NotFinite {
            /// The name of the slice, `points` or `moved`.
            what: &'static str,
            /// The index of the point.
            index: usize,
            /// The coordinate.
            value: f64,
        } => "point {index} of {what} is not finite: a coordinate is {value}";
        /// A weight is negative or not finite.
        Weight {
            /// The index of the pair.
            index: usize,
            /// The weight.
            value: f64,
        } => "the weight of pair {index} is {value}: it must be finite and not negative";
        /// There is no pair, or all weights are zero.
        Empty => "no pair of points has a weight";
        /// An axis has no direction.
        Axis {
            /// The length of the axis.
            length: f64,
        } => "the axis has no direction: its length is {length}";
        /// Many rotations fit equally well within rounding.
        Ambiguous {
            /// The count of pairs whose weight is not zero.
            pairs: usize,
            /// The rank of Σ w y xᵀ: 0 if all points of one set coincide, 1 if they are on a
            /// line.
            rank: usize,
        } => "many rotations fit the {pairs} pairs equally well: their rank is {rank}";
        /// A square of a distance, or the map itself, overflows.
        Overflow => "the points are too far apart: a square of a distance overflows";
    }
}
