//! Lines from points and planes, and points near them.

use super::error::IncidenceError;
use super::{finite, parallel_sine, unit};
use crate::geometry::{Line, Plane};
use crate::number::Real;
use crate::scalar::vector;

impl<R: Real> Line<R> {
    /// The line from `start` toward `end`.
    ///
    /// # Errors
    /// If the points are equal, or their distance or the moment is not finite.
    ///
    /// ```
    /// use dq8::Line;
    /// let line = Line::from_points([1.0, 2.0, 0.0], [1.0_f32, 2.0, 7.0])?;
    /// assert_eq!((line.direction, line.moment), ([0.0, 0.0, 1.0], [2.0, -1.0, 0.0]));
    /// assert!(Line::from_points([1.0_f32; 3], [1.0; 3]).is_err());
    /// # Ok::<(), dq8::incidence::IncidenceError>(())
    /// ```
    pub fn from_points(start: [R; 3], end: [R; 3]) -> Result<Self, IncidenceError> {
        let way = vector::sub(end, start);
        let (direction, _) = unit(way, "the way between two points of a line")?;
        Self::from_point_direction(start, direction).orthogonal()
    }

    /// The line in which two planes meet: l = n₁ × n₂, m = d₂n₁ − d₁n₂, made unit.
    ///
    /// For a point x of both, x × (n₁ × n₂) = n₁(x·n₂) − n₂(x·n₁). The error of
    /// the moment is that of the offsets over the sine between the planes.
    ///
    /// # Errors
    /// If the planes are parallel, a normal is zero, or a number is not finite.
    ///
    /// ```
    /// use dq8::{Line, Plane};
    /// let floor = Plane { normal: [0.0_f32, 0.0, 1.0], offset: 2.0 };
    /// let wall = Plane { normal: [0.0, 1.0, 0.0], offset: 3.0 };
    /// let edge = Line::from_planes(wall, floor)?;
    /// assert_eq!((edge.direction, edge.closest_point_to_origin()), ([1.0, 0.0, 0.0], [0.0, 3.0, 2.0]));
    /// # Ok::<(), dq8::incidence::IncidenceError>(())
    /// ```
    pub fn from_planes(first: Plane<R>, second: Plane<R>) -> Result<Self, IncidenceError> {
        let (a, b) = (first.try_normalize()?, second.try_normalize()?);
        let direction = vector::cross(a.normal, b.normal);
        let sine = vector::norm(direction);
        if sine <= parallel_sine() {
            return Err(IncidenceError::ParallelPlanes { sine: sine.into() });
        }
        let moment =
            vector::sub(vector::scale(a.normal, b.offset), vector::scale(b.normal, a.offset));
        Self { direction, moment }.try_normalize()
    }

    /// (l + εm)/√(l̂·l̂): l has length 1, and m is orthogonal to it. As with dual
    /// quaternions, of which this is the vector part, the norm is a dual number: m/|l| alone would
    /// keep a part along l. That part is the pitch of a screw, whose axis is what remains.
    ///
    /// # Errors
    /// If l is zero, or a number or the result is not finite.
    ///
    /// ```
    /// use dq8::Line;
    /// let screw = Line { direction: [2.0_f32, 0.0, 0.0], moment: [6.0, 0.0, 8.0] };
    /// let axis = screw.try_normalize()?;
    /// assert_eq!(axis, Line { direction: [1.0, 0.0, 0.0], moment: [0.0, 0.0, 4.0] });
    /// # Ok::<(), dq8::incidence::IncidenceError>(())
    /// ```
    pub fn try_normalize(self) -> Result<Self, IncidenceError> {
        let (direction, length) = unit(self.direction, "the direction of a line")?;
        let moment = length.divide(self.moment);
        Self { direction, moment }.orthogonal()
    }

    /// `true` if l + εm is a line, of any length: l ≠ 0 and |l·m| ≤
    /// tolerance·|l|·max(|l|, |m|), the Plücker condition. False where a component is not
    /// finite.
    #[must_use]
    pub fn is_line(self, tolerance: R) -> bool {
        let Ok((direction, _)) = unit(self.direction, "") else { return false };
        let size = vector::norm(self.moment).max_or_nan(vector::norm(self.direction));
        size.is_finite() && vector::dot(direction, self.moment).abs() <= tolerance * size
    }

    /// |x × l − m| over |l|, the distance of a point from the line.
    ///
    /// # Errors
    /// If l is zero, or a number is not finite.
    ///
    /// ```
    /// use dq8::Line;
    /// let line = Line::from_point_direction([0.0, 0.0, 2.0], [5.0_f32, 0.0, 0.0]);
    /// assert_eq!(line.distance_to_point([7.0, 3.0, 6.0])?, 5.0);
    /// # Ok::<(), dq8::incidence::IncidenceError>(())
    /// ```
    pub fn distance_to_point(self, point: [R; 3]) -> Result<R, IncidenceError> {
        let line = self.try_normalize()?;
        let off = vector::sub(vector::cross(point, line.direction), line.moment);
        let [distance] = finite([vector::norm(off)], "the distance of a point from a line")?;
        Ok(distance)
    }

    /// The unit line without the part of m along l, which may be one of rounding: p × l is wrong
    /// by a rounding of |p|, however near to the origin the line passes.
    pub(super) fn orthogonal(self) -> Result<Self, IncidenceError> {
        let Self { direction, moment } = self;
        let moment = finite(vector::across(direction, moment), "the moment of a line")?;
        Ok(Self { direction, moment })
    }
}
