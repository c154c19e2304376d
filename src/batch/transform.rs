//! Points, directions, lines and planes, moved by unit dual quaternions.

use super::{DualQuat, Quat, vector};
use crate::geometry::{Line, Plane};
use dq8_simd::Lanes;

impl<L: Lanes> DualQuat<L> {
    /// Rv + t; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_point(self, point: [L; 3]) -> [L; 3] {
        self.transform_point_scaled(point, self.real().w().constant(2.0))
    }

    /// Moves a point by σ of any norm; `two` is 2/|p|². The part of q along p has no effect.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn transform_point_scaled(self, point: [L; 3], two: L) -> [L; 3] {
        vector::scale_onto(self.half_displacement(point), two, point)
    }

    /// (Rv + t − v)/2, half of how far a point is moved.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn half_displacement(self, point: [L; 3]) -> [L; 3] {
        let (p, q) = (self.real(), self.dual());
        // With r the vector part of p, Rv − v = 2(w_p(r × v) + r × (r × v)) and t = 2(w_p q +
        // r × q − w_q r): the one with r × v in the place of q, and without a scalar part, is
        // the other.
        let q = Quat::from_parts(vector::cross_onto(p.xyz(), point, q.xyz()), q.w());
        Self::new(p, q).half_translation()
    }

    /// Rv; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_vector(self, vector: [L; 3]) -> [L; 3] {
        self.real().rotate(vector)
    }

    /// l′ = Rl, m′ = Rm + t × l′; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn transform_line(self, line: Line<L>) -> Line<L> {
        let (direction, moment) = self.carry(line.direction, line.moment);
        Line { direction, moment }
    }

    /// n′ = Rn, d′ = d + n′·t; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn transform_plane(self, plane: Plane<L>) -> Plane<L> {
        let normal = self.real().rotate(plane.normal);
        let offset = plane.offset + vector::dot(normal, self.translation());
        Plane { normal, offset }
    }

    /// Returns Ra and Rb + t × Ra: the images of a vector a and of its moment b.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn carry(self, a: [L; 3], b: [L; 3]) -> ([L; 3], [L; 3]) {
        let (a, b) = (self.real().rotate(a), self.real().rotate(b));
        (a, vector::cross_onto(self.translation(), a, b))
    }
}
