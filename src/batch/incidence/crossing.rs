//! Lines and planes.

use super::{parallel_sine, without};
use crate::batch::vector;
use crate::geometry::{Line, Plane};
use dq8_simd::Lanes;

/// The place of a line, as a plane sees it.
struct Crossing<L: Lanes> {
    /// The line goes through the plane here, unless it is parallel.
    point: [L; 3],
    /// It runs at this signed distance if it is.
    distance: L,
    parallel: L::Mask,
    failed: L::Mask,
}

impl<L: Lanes> Line<L> {
    /// [`intersection_with_plane`](Self::intersection_with_plane) on lanes, and the lanes without one: the line
    /// is parallel to the plane or lies in it, the direction or the normal is zero, or a number is not finite.
    /// Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn intersection_with_plane_checked(self, plane: Plane<L>) -> ([L; 3], L::Mask) {
        let Crossing { point, parallel, failed, .. } = Crossing::of(self, plane);
        let failed = failed | parallel | !vector::are_finite(point);
        (without(failed, point), failed)
    }

    /// [`distance_to_plane`](Self::distance_to_plane) on lanes, 0 unless they are parallel, and the lanes
    /// without one: the direction or the normal is zero, or a number is not finite. Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn distance_to_plane_checked(self, plane: Plane<L>) -> (L, L::Mask) {
        let Crossing { distance, parallel, failed, .. } = Crossing::of(self, plane);
        let distance = L::select(parallel, distance.abs(), distance.constant(0.0));
        let [distance] = without(failed, [distance]);
        (distance, failed)
    }
}

impl<L: Lanes> Crossing<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn of(line: Line<L>, plane: Plane<L>) -> Self {
        let ((line, no_line), (plane, no_plane)) =
            (line.normalize_checked(), plane.normalize_checked());
        let sine = vector::dot(line.direction, plane.normal);
        let foot = vector::cross(line.direction, line.moment);
        let distance = vector::dot(plane.normal, foot) - plane.offset;
        Self {
            point: vector::scale_onto(line.direction, -(distance / sine), foot),
            distance,
            parallel: sine.abs().le(parallel_sine(sine)),
            failed: no_line | no_plane,
        }
    }
}
