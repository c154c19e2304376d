//! Lines from points and planes, and points near them.

use super::{norm, parallel_sine, unit, without};
use crate::batch::vector;
use crate::geometry::{Line, Plane};
use dq8_simd::Lanes;

impl<L: Lanes> Line<L> {
    /// [`from_points`](Self::from_points) on lanes, and the lanes without a line: the points are equal, or
    /// their distance or the moment is not finite. Those are NaN.
    ///
    /// ```
    /// use dq8::{Line, simd::{Mask, f32x4}};
    /// let (zero, z) = (f32x4::splat(0.0), f32x4::new([7.0, 1.0, 0.0, -2.0]));
    /// let (line, failed) = Line::from_points_checked([zero; 3], [zero, zero, z]);
    /// assert_eq!(line.direction[2].to_array()[3], -1.0);
    /// assert_eq!(failed.to_bitmask(), 0b0100);
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_points_checked(start: [L; 3], end: [L; 3]) -> (Self, L::Mask) {
        let (direction, _, failed) = unit(vector::sub(end, start));
        Self { direction, moment: vector::cross(start, direction) }.without_pitch(failed)
    }

    /// [`from_planes`](Self::from_planes) on lanes, l = n₁ × n₂ and m = d₂n₁ − d₁n₂, and the lanes without a
    /// line: the planes are parallel, a normal is zero, or a number is not finite. Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_planes_checked(first: Plane<L>, second: Plane<L>) -> (Self, L::Mask) {
        let ((a, no_first), (b, no_second)) =
            (first.normalize_checked(), second.normalize_checked());
        let direction = vector::cross(a.normal, b.normal);
        let sine = norm(direction);
        let onto = vector::scale(b.normal, -a.offset);
        let moment = vector::scale_onto(a.normal, b.offset, onto);
        let (line, failed) = Self { direction, moment }.normalize_checked();
        line.unless(failed | no_first | no_second | sine.le(parallel_sine(sine)))
    }

    /// [`try_normalize`](Self::try_normalize) on lanes, (l + εm)/√(l̂·l̂), and the lanes without a line: l is
    /// zero, or a number or the result is not finite. Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn normalize_checked(self) -> (Self, L::Mask) {
        let (direction, length, failed) = unit(self.direction);
        Self { direction, moment: length.divide_all(self.moment) }.without_pitch(failed)
    }

    /// [`is_line`](Self::is_line) on lanes: l ≠ 0 and |l·m| ≤ tolerance·|l|·max(|l|, |m|).
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn is_line_mask(self, tolerance: L) -> L::Mask {
        let (direction, length, failed) = unit(self.direction);
        let (length, moment) = (length.value(), norm(self.moment));
        let size = L::select(length.lt(moment), moment, length);
        let along = vector::dot(direction, self.moment).abs();
        !failed & vector::is_finite(moment) & along.le(tolerance * size)
    }

    /// [`distance_to_point`](Self::distance_to_point) on lanes, |x × l − m| over |l|, and the lanes without
    /// one: l is zero, or a number is not finite. Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn distance_to_point_checked(self, point: [L; 3]) -> (L, L::Mask) {
        let (line, failed) = self.normalize_checked();
        let distance = norm(vector::sub(vector::cross(point, line.direction), line.moment));
        let failed = failed | !vector::is_finite(distance);
        let [distance] = without(failed, [distance]);
        (distance, failed)
    }

    /// The unit line without the part of m along l, which may be one of rounding.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn without_pitch(self, failed: L::Mask) -> (Self, L::Mask) {
        let Self { direction, moment } = self;
        let moment = vector::across(direction, moment);
        let line = Self { direction, moment };
        line.unless(failed | !vector::are_finite(moment))
    }

    /// The line, but where there is none.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn unless(self, failed: L::Mask) -> (Self, L::Mask) {
        let Self { direction, moment } = self;
        let direction = without(failed, direction);
        (Self { direction, moment: without(failed, moment) }, failed)
    }
}
