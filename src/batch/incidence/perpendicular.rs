//! Two lines: their dual angle, common perpendicular and intersection.

use super::{norm, parallel_sine, size, unit, without};
use crate::batch::trigonometry::atan2;
use crate::batch::{Dual, vector};
use crate::geometry::Line;
use dq8_simd::Lanes;

/// The relation of two lines: [`CommonPerpendicular`](crate::incidence::CommonPerpendicular) on lanes.
#[derive(Clone, Copy, Debug)]
pub struct CommonPerpendicular<L: Lanes> {
    /// The line that crosses both at right angles, unit, with the sense of l₁ × l₂.
    pub axis: Line<L>,
    /// The points where it crosses the first line, and the second.
    pub feet: [[L; 3]; 2],
    /// θ̂ = θ + εd
    pub angle: Dual<L>,
    /// `true` if the lines are parallel or antiparallel within rounding: then `axis` is one
    /// perpendicular of many.
    pub parallel: L::Mask,
}

impl<L: Lanes> Line<L> {
    /// [`dual_angle`](Self::dual_angle) on lanes, θ + εd, and the lanes without one: a direction is zero, or a
    /// number or the result is not finite. Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn dual_angle_checked(self, other: Self) -> (Dual<L>, L::Mask) {
        let (CommonPerpendicular { angle, .. }, failed) = self.common_perpendicular_checked(other);
        (angle, failed)
    }

    /// [`distance_to_line`](Self::distance_to_line) on lanes, and the lanes without one, as
    /// [`dual_angle_checked`](Self::dual_angle_checked).
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn distance_to_line_checked(self, other: Self) -> (L, L::Mask) {
        let (angle, failed) = self.dual_angle_checked(other);
        (angle.dual.abs(), failed)
    }

    /// [`common_perpendicular`](Self::common_perpendicular) on lanes, with all its cases, and the lanes without
    /// one, as [`dual_angle_checked`](Self::dual_angle_checked).
    ///
    /// ```
    /// use dq8::{Line, simd::{Mask, f64x2}};
    /// let at = |x, y, z| [x, y, z].map(f64x2::splat);
    /// let x_axis = Line::from_point_direction(at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0));
    /// // One line above across it, one along it.
    /// let along = [f64x2::new([0.0, 1.0]), f64x2::new([1.0, 0.0]), f64x2::splat(0.0)];
    /// let above = Line::from_point_direction(at(7.0, -4.0, 3.0), along);
    /// let (found, failed) = x_axis.common_perpendicular_checked(above);
    /// assert_eq!((failed.any(), found.parallel.to_bitmask()), (false, 0b10));
    /// assert_eq!(found.angle.dual.to_array(), [3.0, 5.0]);
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn common_perpendicular_checked(self, other: Self) -> (CommonPerpendicular<L>, L::Mask) {
        let ((a, no_first), (b, no_second)) = (self.normalize_checked(), other.normalize_checked());
        let normal = vector::cross(a.direction, b.direction);
        let sine = norm(normal);
        // An arccosine would lose angles below √u.
        let theta = atan2(sine, vector::dot(a.direction, b.direction));
        let parallel = sine.le(parallel_sine(sine));
        let (beside, skew) = (between_parallel(a, b), between_skew(a, b, normal));
        let direction = vector::select(parallel, beside.0, skew.0);
        let first = vector::select(parallel, beside.1[0], skew.1[0]);
        let second = vector::select(parallel, beside.1[1], skew.1[1]);
        let distance = L::select(parallel, beside.2, skew.2);
        let finite = vector::are_finite(first)
            & vector::are_finite(second)
            & vector::is_finite(distance)
            & vector::are_finite(direction);
        let failed = no_first | no_second | !finite;
        let axis = Self { direction, moment: vector::cross(first, direction) };
        let (axis, failed) = axis.without_pitch(failed);
        let [theta, distance] = without(failed, [theta, distance]);
        let feet = [without(failed, first), without(failed, second)];
        (CommonPerpendicular { axis, feet, angle: Dual::new(theta, distance), parallel }, failed)
    }

    /// [`intersection`](Self::intersection) on lanes, the middle of a common perpendicular not longer than
    /// `tolerance`, and the lanes without one: the lines are skew or parallel, or as
    /// [`dual_angle_checked`](Self::dual_angle_checked). Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn intersection_checked(self, other: Self, tolerance: L) -> ([L; 3], L::Mask) {
        let (found, failed) = self.common_perpendicular_checked(other);
        let meet = found.angle.dual.abs().le(tolerance) & !found.parallel;
        let [first, second] = found.feet;
        let way = vector::sub(second, first);
        let middle = vector::scale_onto(way, tolerance.constant(0.5), first);
        let failed = failed | !meet;
        (without(failed, middle), failed)
    }
}

/// Direction, feet and length of a perpendicular.
type Perpendicular<L> = ([L; 3], [[L; 3]; 2], L);

/// The one between unit lines, given l₁ × l₂.
#[cfg_attr(not(opt_level_0), inline(always))]
fn between_skew<L: Lanes>(a: Line<L>, b: Line<L>, normal: [L; 3]) -> Perpendicular<L> {
    let (n, sine, _) = unit(normal);
    // From the way between two points: the other formula, −(l₁·m₂ + m₁·l₂)/sin θ, would multiply the
    // roundings of both moments by 1/sin θ.
    let (on_a, on_b) = (foot(a), foot(b));
    let way = vector::sub(on_b, on_a);
    // on_a + s l₁ + d n = on_b + t l₂, multiplied by l₂ × n and by l₁ × n.
    let s = sine.divide(vector::dot(vector::cross(way, b.direction), n));
    let t = sine.divide(vector::dot(vector::cross(way, a.direction), n));
    let first = vector::scale_onto(a.direction, s, on_a);
    let second = vector::scale_onto(b.direction, t, on_b);
    (n, [first, second], vector::dot(way, n))
}

/// Of all between parallel unit lines, the one in the plane through the origin.
#[cfg_attr(not(opt_level_0), inline(always))]
fn between_parallel<L: Lanes>(a: Line<L>, b: Line<L>) -> Perpendicular<L> {
    let feet = [foot(a), foot(b)];
    let across = vector::across(a.direction, vector::sub(feet[1], feet[0]));
    let (direction, distance, _) = unit(across);
    let distance = distance.value();
    let same = distance.le(parallel_sine(distance) * size(a.moment, b.moment));
    let direction = vector::select(same, vector::any_across(a.direction), direction);
    (direction, feet, L::select(same, distance.constant(0.0), distance))
}

/// l × m, the point of a unit line nearest to the origin.
#[cfg_attr(not(opt_level_0), inline(always))]
fn foot<L: Lanes>(line: Line<L>) -> [L; 3] {
    vector::cross(line.direction, line.moment)
}
