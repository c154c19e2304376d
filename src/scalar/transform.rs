//! Transformation of points, directions, lines and planes by a unit dual quaternion.

use super::{DualQuat, vector};
use crate::geometry::{Line, Plane};
use crate::number::Real;
use crate::quick;

impl<R: Real> DualQuat<R> {
    /// Returns the point Rv + t, which is σ(1 + εv)σ⋄ (Jia eq. 25). σ must be unit.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("transform_point3", "apply", "act"))]
    pub fn transform_point(self, point: [R; 3]) -> [R; 3] {
        crate::scalar::must_be_unit::motions("DualQuat::transform_point", [self]);
        if let Some(moved) = R::quick(quick::Point(self.to_array(), point)) {
            return moved;
        }
        vector::add(self.real().rotate(point), self.translation())
    }

    /// Returns the direction Rv: a motion turns directions (Tarini, slide 122) and does not
    /// translate them (slide 121). σ must be unit.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("transform_vector3", "rotate_vector"))]
    pub fn transform_vector(self, vector: [R; 3]) -> [R; 3] {
        crate::scalar::must_be_unit::motions("DualQuat::transform_vector", [self]);
        self.real().rotate(vector)
    }

    /// Returns the line l′ + εm′ = σ(l + εm)σ*, with l′ = Rl and m′ = Rm + t × l′
    /// (Jia eqs. 29 and 31). σ must be unit.
    ///
    /// ```
    /// use dq8::{DualQuat, Line};
    /// let x_axis = Line { direction: [1.0_f32, 0.0, 0.0], moment: [0.0; 3] };
    /// let raised = DualQuat::from_translation([0.0, 0.0, 2.0]).transform_line(x_axis);
    /// assert_eq!(raised.moment, [0.0, 2.0, 0.0]); // (0,0,2) × (1,0,0)
    /// ```
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn transform_line(self, line: Line<R>) -> Line<R> {
        crate::scalar::must_be_unit::motions("DualQuat::transform_line", [self]);
        let (direction, moment) = self.carry(line.direction, line.moment);
        Line { direction, moment }
    }

    /// Returns the plane n′·x′ = d′ with n′ = Rn and d′ = d + n′·t, which follows
    /// from n·x = d with x = R⁻¹(x′ − t). σ must be unit. None of the sources of dq8 has a
    /// formula for planes.
    ///
    /// ```
    /// use dq8::{DualQuat, Plane};
    /// let floor = Plane { normal: [0.0_f32, 0.0, 1.0], offset: 0.0 };
    /// let raised = DualQuat::from_translation([5.0, 5.0, 2.0]).transform_plane(floor);
    /// assert_eq!(raised.offset, 2.0);
    /// ```
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn transform_plane(self, plane: Plane<R>) -> Plane<R> {
        crate::scalar::must_be_unit::motions("DualQuat::transform_plane", [self]);
        let normal = self.real().rotate(plane.normal);
        let offset = plane.offset + vector::dot(normal, self.translation());
        Plane { normal, offset }
    }

    /// Returns Ra and Rb + t × Ra: the images of a vector a and of its moment b.
    #[inline]
    pub(super) fn carry(self, a: [R; 3], b: [R; 3]) -> ([R; 3], [R; 3]) {
        let (a, b) = (self.real().rotate(a), self.real().rotate(b));
        (a, vector::add(b, vector::cross(self.translation(), a)))
    }
}
