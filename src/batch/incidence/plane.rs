//! Planes from points and lines.

use super::{norm, parallel_sine, size, unit, without};
use crate::batch::vector;
use crate::geometry::{Line, Plane};
use dq8_simd::Lanes;

impl<L: Lanes> Plane<L> {
    /// [`from_points`](Self::from_points) on lanes, normal along (b − a) × (c − a), and the lanes without a
    /// plane: the points lie on one line, or a distance of two is not finite. Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_points_checked(a: [L; 3], b: [L; 3], c: [L; 3]) -> (Self, L::Mask) {
        let (to_b, _, no_b) = unit(vector::sub(b, a));
        let (to_c, _, no_c) = unit(vector::sub(c, a));
        let (normal, sine, no_normal) = unit(vector::cross(to_b, to_c));
        let sine = sine.value();
        let collinear = sine.le(parallel_sine(sine));
        Self::through(a, normal).unless(no_b | no_c | no_normal | collinear)
    }

    /// [`from_line_point`](Self::from_line_point) on lanes, normal along m − x × l, and the lanes without a
    /// plane: the point is on the line within rounding, l is zero, or a number is not finite. Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_line_point_checked(line: Line<L>, point: [L; 3]) -> (Self, L::Mask) {
        let (line, no_line) = line.normalize_checked();
        let normal = vector::sub(line.moment, vector::cross(point, line.direction));
        let distance = norm(normal);
        let on_line = distance.le(parallel_sine(distance) * size(line.moment, point));
        let (normal, _, no_normal) = unit(normal);
        Self::through(point, normal).unless(no_line | no_normal | on_line)
    }

    /// [`try_normalize`](Self::try_normalize) on lanes, n and d over |n|, and the lanes without a plane: n is
    /// zero, or a number or the result is not finite. Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn normalize_checked(self) -> (Self, L::Mask) {
        let (normal, length, failed) = unit(self.normal);
        Self { normal, offset: length.divide(self.offset) }.unless(failed)
    }

    /// n·x = n·p
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn through(point: [L; 3], normal: [L; 3]) -> Self {
        Self { normal, offset: vector::dot(normal, point) }
    }

    /// The plane, but where there is none or its offset is not finite.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn unless(self, failed: L::Mask) -> (Self, L::Mask) {
        let failed = failed | !vector::is_finite(self.offset);
        let [offset] = without(failed, [self.offset]);
        (Self { normal: without(failed, self.normal), offset }, failed)
    }
}
