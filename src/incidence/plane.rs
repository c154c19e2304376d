//! Planes from points and lines.

use super::error::IncidenceError;
use super::{finite, parallel_sine, size, unit};
use crate::geometry::{Line, Plane};
use crate::number::Real;
use crate::scalar::vector;

impl<R: Real> Plane<R> {
    /// The plane through three points, which turn counter-clockwise as seen from the side that the
    /// normal (b − a) × (c − a) points to.
    ///
    /// # Errors
    /// If the points lie on one line, or a distance of two of them is not finite.
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

    /// The plane through a line and a point off the line; its normal is along m − x × l:
    /// direction of the line, way from the line to the point, and normal are right-handed.
    ///
    /// # Errors
    /// If the point is on the line within rounding, l is zero, or a number is not finite.
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

    /// n and d over |n|.
    ///
    /// # Errors
    /// If n is zero, or a number or the result is not finite.
    pub fn try_normalize(self) -> Result<Self, IncidenceError> {
        let (normal, length) = unit(self.normal, "the normal of a plane")?;
        let [offset] = length.divide([self.offset]);
        Self { normal, offset }.checked()
    }

    /// The plane, if its offset is finite.
    fn checked(self) -> Result<Self, IncidenceError> {
        finite([self.offset], "the offset of a plane")?;
        Ok(self)
    }
}
