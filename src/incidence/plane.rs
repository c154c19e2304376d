//! Planes: made from points or lines, points on a plane, and the intersections of lines with
//! planes.

use super::{IncidenceError, finite, parallel_sine, size, unit};
use crate::geometry::{Line, Plane};
use crate::number::Real;
use crate::scalar::vector;

impl<R: Real> Plane<R> {
    /// Makes the plane through three points. Seen from the side to which the normal (b − a) × (c
    /// − a) points, the points a, b, c are in counter-clockwise order.
    ///
    /// # Errors
    /// If the points lie on one line, or if a distance between two of them is not finite.
    ///
    /// ```
    /// use dq8::Plane;
    /// let plane = Plane::from_points([0.0, 0.0, 2.0], [1.0_f32, 0.0, 2.0], [0.0, 5.0, 2.0])?;
    /// assert_eq!(plane, Plane { normal: [0.0, 0.0, 1.0], offset: 2.0 });
    /// # Ok::<(), dq8::incidence::IncidenceError>(())
    /// ```
    pub fn from_points(a: [R; 3], b: [R; 3], c: [R; 3]) -> Result<Self, IncidenceError> {
        let (to_b, _) = unit(vector::sub(b, a), "the way from the first point to the second")?;
        let (to_c, _) = unit(vector::sub(c, a), "the way from the first point to the third")?;
        let normal = vector::cross(to_b, to_c);
        let sine = vector::norm(normal);
        if sine <= parallel_sine() {
            return Err(IncidenceError::Collinear { sine: sine.into() });
        }
        Self::from_point_normal(a, vector::over_norm(normal, sine)).checked()
    }

    /// Makes the plane through a line and a point x off the line. The normal is along m − x × l:
    /// the direction of the line, the direction from the line to the point, and the normal are
    /// right-handed, in this order.
    ///
    /// # Errors
    /// If the point is on the line within rounding, l is zero, or a component is not finite.
    ///
    /// ```
    /// use dq8::{Line, Plane};
    /// let x_axis = Line::from_point_direction([0.0; 3], [1.0_f32, 0.0, 0.0]);
    /// let plane = Plane::from_line_point(x_axis, [3.0, 2.0, 0.0])?;
    /// assert_eq!(plane, Plane { normal: [0.0, 0.0, 1.0], offset: 0.0 });
    /// # Ok::<(), dq8::incidence::IncidenceError>(())
    /// ```
    pub fn from_line_point(line: Line<R>, point: [R; 3]) -> Result<Self, IncidenceError> {
        let line = line.try_normalize()?;
        let normal = vector::sub(line.moment, vector::cross(point, line.direction));
        let distance = vector::norm(normal);
        if distance <= parallel_sine::<R>() * size(line.moment, point) {
            return Err(IncidenceError::PointOnLine { distance: distance.into() });
        }
        let (normal, _) = unit(normal, "the way from a line to a point")?;
        Self::from_point_normal(point, normal).checked()
    }

    /// Returns the plane with n and d divided by |n|.
    ///
    /// # Errors
    /// If n is zero, or if a component of the plane or of the result is not finite.
    pub fn try_normalize(self) -> Result<Self, IncidenceError> {
        let (normal, length) = unit(self.normal, "the normal of a plane")?;
        let [offset] = length.divide([self.offset]);
        Self { normal, offset }.checked()
    }

    /// Returns the plane if its offset is finite.
    fn checked(self) -> Result<Self, IncidenceError> {
        finite([self.offset], "the offset of a plane")?;
        Ok(self)
    }
}

/// The position of a line relative to a plane.
enum Crossing<R> {
    /// The line crosses the plane at this point.
    At([R; 3]),
    /// The line is parallel to the plane at this signed distance. It lies in the plane if the
    /// distance is zero.
    Parallel(R),
}

impl<R: Real> Line<R> {
    /// Returns the point in which the line intersects a plane. Its error is the error of the moment
    /// and of the offset, divided by the sine of the angle between line and plane.
    ///
    /// # Errors
    /// If the line is parallel to the plane or lies in it; the error has the distance. Also if the
    /// direction or the normal is zero, or if a component is not finite.
    ///
    /// ```
    /// use dq8::{Line, Plane};
    /// let floor = Plane { normal: [0.0_f64, 0.0, 1.0], offset: 2.0 };
    /// let ray = Line::from_points([0.0, 0.0, 6.0], [1.0, 0.0, 5.0])?;
    /// let [x, y, z] = ray.intersection_with_plane(floor)?;
    /// assert!((x - 4.0).abs() + y.abs() + (z - 2.0).abs() < 1e-14);
    /// # Ok::<(), dq8::incidence::IncidenceError>(())
    /// ```
    pub fn intersection_with_plane(self, plane: Plane<R>) -> Result<[R; 3], IncidenceError> {
        match self.crossing(plane)? {
            Crossing::At(point) => finite(point, "the intersection of a line and a plane"),
            Crossing::Parallel(distance) => {
                Err(IncidenceError::ParallelToPlane { distance: distance.into() })
            }
        }
    }

    /// Returns the distance of the line from a plane, which is 0 unless they are parallel.
    ///
    /// # Errors
    /// If the direction or the normal is zero, or if a component is not finite.
    pub fn distance_to_plane(self, plane: Plane<R>) -> Result<R, IncidenceError> {
        match self.crossing(plane)? {
            Crossing::At(_) => Ok(R::ZERO),
            Crossing::Parallel(distance) => Ok(distance.abs()),
        }
    }

    fn crossing(self, plane: Plane<R>) -> Result<Crossing<R>, IncidenceError> {
        let (line, plane) = (self.try_normalize()?, plane.try_normalize()?);
        let sine = vector::dot(line.direction, plane.normal);
        let foot = line.closest_point_to_origin();
        let distance = plane.signed_distance(foot);
        if sine.abs() <= parallel_sine() {
            return Ok(Crossing::Parallel(distance));
        }
        let along = vector::scale(line.direction, distance / sine);
        Ok(Crossing::At(vector::sub(foot, along)))
    }
}
