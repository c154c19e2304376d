//! Transformation of points, directions, lines and planes by unit dual quaternions.

use super::{DualQuat, Quat, vector};
use crate::geometry::{Line, Plane};
use dq8_simd::Lanes;

impl<L: Lanes> DualQuat<L> {
    /// Returns the point Rv + t, with the rotation matrix R and the translation t of a unit σ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_point(self, point: [L; 3]) -> [L; 3] {
        self.transform_point_scaled(point, self.real().w().constant(2.0))
    }

    /// Moves a point by σ = p + εq of any norm; `two` must be 2/|p|². The part of q along p has
    /// no effect.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn transform_point_scaled(self, point: [L; 3], two: L) -> [L; 3] {
        vector::scale_onto(self.half_displacement(point), two, point)
    }

    /// Returns (Rv + t − v)/2, half of the displacement of the point v.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn half_displacement(self, point: [L; 3]) -> [L; 3] {
        let (p, q) = (self.real(), self.dual());
        // With the vector parts r of p and u of q, t = 2(w_p u + r × u − w_q r) and Rv − v =
        // 2(w_p(r × v) + r × (r × v)). The second formula is the first with r × v in place of u
        // and 0 in place of w_q. So half the sum of both is the `half_translation` of a motion with
        // the real part p and a dual part with the vector part u + r × v.
        let q = Quat::from_parts(vector::cross_onto(p.xyz(), point, q.xyz()), q.w());
        Self::new(p, q).half_translation()
    }

    /// Returns the direction Rv, with the rotation matrix R of a unit σ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_vector(self, vector: [L; 3]) -> [L; 3] {
        self.real().rotate(vector)
    }

    /// Returns the line moved by unit σ (with rotation R and translation t), with the direction
    /// l′ = Rl and the moment m′ = Rm + t × l′.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn transform_line(self, line: Line<L>) -> Line<L> {
        let (direction, moment) = self.carry(line.direction, line.moment);
        Line { direction, moment }
    }

    /// Returns the plane moved by unit σ (with rotation R and translation t), with the normal
    /// n′ = Rn and the offset d′ = d + n′·t.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn transform_plane(self, plane: Plane<L>) -> Plane<L> {
        let normal = self.real().rotate(plane.normal);
        let offset = plane.offset + vector::dot(normal, self.translation());
        Plane { normal, offset }
    }

    /// Returns Ra and Rb + t × Ra, the images of a vector a and of its moment b under the motion
    /// with rotation R and translation t.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn carry(self, a: [L; 3], b: [L; 3]) -> ([L; 3], [L; 3]) {
        let (a, b) = (self.real().rotate(a), self.real().rotate(b));
        (a, vector::cross_onto(self.translation(), a, b))
    }
}
