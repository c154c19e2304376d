//! What unit dual quaternions do to points, directions, lines and planes.

use super::{DualQuat, vector};
use crate::geometry::{Line, Plane};
use dq8_simd::Lanes;

impl<L: Lanes> DualQuat<L> {
    /// Rv + t; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_point(self, point: [L; 3]) -> [L; 3] {
        self.transform_point_scaled(point, self.real().w().constant(2.0))
    }

    /// The same for σ of any norm; `two` is 2/|p|². What q has along p moves nothing.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn transform_point_scaled(self, point: [L; 3], two: L) -> [L; 3] {
        vector::add(point, self.displacement(point, two))
    }

    /// Rv + t − v, how far a point is moved.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn displacement(self, point: [L; 3], two: L) -> [L; 3] {
        let (r, w) = (self.real().xyz(), self.real().w());
        // Rv = v + 2 r × (r × v + w v), and t = 2(…): both in one sum.
        let inner = vector::cross_onto(r, point, vector::scale(point, w));
        self.translation_onto_half(vector::cross(r, inner), two)
    }

    /// Rv; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_vector(self, vector: [L; 3]) -> [L; 3] {
        self.real().rotate(vector)
    }

    /// l′ = Rl, m′ = Rm + t × l′; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_line(self, line: Line<L>) -> Line<L> {
        let direction = self.real().rotate(line.direction);
        let turned = self.real().rotate(line.moment);
        Line { direction, moment: vector::cross_onto(self.translation(), direction, turned) }
    }

    /// n′ = Rn, d′ = d + n′·t; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_plane(self, plane: Plane<L>) -> Plane<L> {
        let normal = self.real().rotate(plane.normal);
        let offset = plane.offset + vector::dot(normal, self.translation());
        Plane { normal, offset }
    }
}
