//! Lines and planes.

use super::error::IncidenceError;
use super::{finite, parallel_sine};
use crate::geometry::{Line, Plane};
use crate::number::Real;
use crate::scalar::vector;

/// The place of a line, as a plane sees it.
enum Crossing<R> {
    /// The line goes through the plane here.
    At([R; 3]),
    /// It runs at this signed distance; in the plane, if that is zero.
    Parallel(R),
}

impl<R: Real> Line<R> {
    /// The point in which the line meets a plane. Its error is that of the moment and the offset
    /// over the sine between them.
    ///
    /// # Errors
    /// If the line is parallel to the plane or lies in it: the error has the distance. If the
    /// direction or the normal is zero, or a number is not finite.
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

    /// The distance of a line from a plane: 0 unless they are parallel.
    ///
    /// # Errors
    /// If the direction or the normal is zero, or a number is not finite.
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
