//! Lines: made from points or planes, points on a line, and relations of two lines.

use super::{IncidenceError, finite, parallel_sine, size, unit};
use crate::geometry::{Line, Plane};
use crate::number::Real;
use crate::scalar::{Dual, vector};

impl<R: Real> Line<R> {
    /// Makes the line from `start` toward `end`.
    ///
    /// # Errors
    /// If the points are equal, or if their distance or the moment is not finite.
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

    /// Returns the line in which two planes n₁·x = d₁ and n₂·x = d₂ intersect: l = n₁
    /// × n₂ and m = d₂n₁ − d₁n₂, divided by |l|.
    ///
    /// For a point x of both planes, x × (n₁ × n₂) = n₁(x·n₂) − n₂(x·n₁). The
    /// error of the moment is the error of the offsets divided by the sine of the angle between the
    /// planes.
    ///
    /// # Errors
    /// If the planes are parallel, a normal is zero, or a component is not finite.
    ///
    /// ```
    /// use dq8::{Line, Plane};
    /// let floor = Plane { normal: [0.0_f32, 0.0, 1.0], offset: 2.0 };
    /// let wall = Plane { normal: [0.0, 1.0, 0.0], offset: 3.0 };
    /// let edge = Line::from_planes(wall, floor)?;
    /// assert_eq!(edge.direction, [1.0, 0.0, 0.0]);
    /// assert_eq!(edge.closest_point_to_origin(), [0.0, 3.0, 2.0]);
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

    /// Returns (l + εm)/√(l̂·l̂), where l̂ = l + εm: l then has length 1, and m is
    /// orthogonal to l. The norm is a dual number, as for dual quaternions, because l + εm is the
    /// vector part of a dual quaternion. Division by |l| alone would keep the part of m along l,
    /// which is the pitch if l + εm is a screw. So the result for a screw is its axis.
    ///
    /// # Errors
    /// If l is zero, or if a component of the line or of the result is not finite.
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

    /// Returns `true` if l + εm is a line, with l of any length: l ≠ 0 and |l·m| ≤
    /// tolerance·|l|·max(|l|, |m|), the Plücker condition. Returns `false` if a component is not
    /// finite.
    #[must_use]
    pub fn is_line(self, tolerance: R) -> bool {
        let Ok((direction, _)) = unit(self.direction, "") else { return false };
        let size = vector::norm(self.moment).max_or_nan(vector::norm(self.direction));
        size.is_finite() && vector::dot(direction, self.moment).abs() <= tolerance * size
    }

    /// Returns |x × l − m| / |l|, the distance of the point x from the line.
    ///
    /// # Errors
    /// If l is zero, or a component is not finite.
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

    /// Returns this unit line l + εm without the part of m along l, which is a rounding error. It
    /// arises because a moment p × l is rounded in proportion to |p|, even if the line passes near
    /// the origin.
    pub(super) fn orthogonal(self) -> Result<Self, IncidenceError> {
        let Self { direction, moment } = self;
        let moment = finite(vector::across(direction, moment), "the moment of a line")?;
        Ok(Self { direction, moment })
    }
}

/// The relation of two lines, which [`Line::common_perpendicular`] returns.
///
/// The screw about `axis`, with θ as its angle and d as its slide (see `angle`), takes the first
/// line to the second, including the sense of the lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CommonPerpendicular<R> {
    /// The line that crosses both lines at right angles. It is unit and has the sense of l₁ ×
    /// l₂.
    pub axis: Line<R>,
    /// The point where the axis crosses the first line, and the point where it crosses the second.
    pub feet: [[R; 3]; 2],
    /// The dual angle θ̂ = θ + εd between the lines; see [`Line::dual_angle`].
    pub angle: Dual<R>,
    /// `true` if the lines are parallel or antiparallel within rounding. Many common perpendiculars
    /// then exist, and `axis` is one of them.
    pub parallel: bool,
}

impl<R: Real> Line<R> {
    /// Returns the dual angle θ + εd between this line and `other`: their angle and their
    /// distance in one dual number (Study 1891). θ is in radians in [0, π]. d is the distance
    /// from this line to `other`, measured along l₁ × l₂, and negative if `other` lies in the
    /// opposite direction. Exchanging the lines does not change the result; reversing the sense of
    /// one line does.
    ///
    /// cos θ̂ = cos θ − ε d sin θ is the inner product of the unit lines, and sin θ̂ times
    /// the common perpendicular is their cross product
    /// ([`DualVector`](crate::geometry::DualVector)). These two formulas lose small angles and the
    /// distance of parallel lines. Here θ is an arctangent, accurate to a few roundings for every
    /// angle, and d is also correct for parallel lines, where it is never negative.
    ///
    /// The error of d is a few rounding errors of the largest distance of the lines and the feet
    /// from the origin. The feet of *almost* parallel lines are often far away, and their errors
    /// are divided by sin² θ.
    ///
    /// # Errors
    /// If a direction is zero, or if a component of a line or of the result is not finite.
    ///
    /// ```
    /// use dq8::{Dual, Line};
    /// let x_axis = Line::from_point_direction([0.0; 3], [1.0_f64, 0.0, 0.0]);
    /// let above = Line::from_point_direction([7.0, 0.0, 3.0], [0.0, 1.0, 0.0]);
    /// assert_eq!(x_axis.dual_angle(above)?, Dual::new(core::f64::consts::FRAC_PI_2, 3.0));
    /// # Ok::<(), dq8::incidence::IncidenceError>(())
    /// ```
    pub fn dual_angle(self, other: Self) -> Result<Dual<R>, IncidenceError> {
        Ok(self.common_perpendicular(other)?.angle)
    }

    /// Returns the shortest distance between two lines, |d| of [`dual_angle`](Self::dual_angle).
    ///
    /// # Errors
    /// The errors of [`dual_angle`](Self::dual_angle).
    pub fn distance_to_line(self, other: Self) -> Result<R, IncidenceError> {
        Ok(self.dual_angle(other)?.dual.abs())
    }

    /// Returns the common perpendicular of two lines, with its feet: the two points where the lines
    /// are nearest to each other.
    ///
    /// | lines | axis | feet | angle |
    /// |---|---|---|---|
    /// | skew | along l₁ × l₂ | apart | θ + εd |
    /// | intersecting | along l₁ × l₂ | one point | θ + ε0 |
    /// | parallel | from the first to the second, d > 0 | nearest to the origin | 0 + εd |
    /// | antiparallel | the same | nearest to the origin | π + εd |
    /// | identical | any perpendicular | nearest to the origin | 0 + ε0 |
    /// | opposite | any perpendicular | nearest to the origin | π + ε0 |
    ///
    /// Every case has a result. Lines count as identical if their distance is within the rounding
    /// of their moments.
    ///
    /// # Errors
    /// The errors of [`dual_angle`](Self::dual_angle).
    ///
    /// ```
    /// use dq8::Line;
    /// let x_axis = Line::from_point_direction([0.0; 3], [1.0_f64, 0.0, 0.0]);
    /// let above = Line::from_point_direction([7.0, -4.0, 3.0], [0.0, 1.0, 0.0]);
    /// let perpendicular = x_axis.common_perpendicular(above)?;
    /// assert_eq!(perpendicular.feet, [[7.0, 0.0, 0.0], [7.0, 0.0, 3.0]]);
    /// # Ok::<(), dq8::incidence::IncidenceError>(())
    /// ```
    pub fn common_perpendicular(
        self,
        other: Self,
    ) -> Result<CommonPerpendicular<R>, IncidenceError> {
        let (a, b) = (self.try_normalize()?, other.try_normalize()?);
        let normal = vector::cross(a.direction, b.direction);
        let sine = vector::norm(normal);
        // An arccosine would lose angles below √u, where u is the rounding unit.
        let theta = sine.atan2(vector::dot(a.direction, b.direction));
        let parallel = sine <= parallel_sine();
        let (direction, feet, distance) =
            if parallel { between_parallel(a, b)? } else { between_skew(a, b, normal, sine) };
        let [first, second] = feet;
        finite(first, "a foot of the perpendicular")?;
        finite(second, "a foot of the perpendicular")?;
        finite([distance], "the distance of two lines")?;
        let axis = Self::from_point_direction(first, direction).orthogonal()?;
        Ok(CommonPerpendicular { axis, feet, angle: Dual::new(theta, distance), parallel })
    }

    /// Returns the point in which two lines intersect: the midpoint of their common perpendicular,
    /// if the perpendicular is not longer than `tolerance`.
    ///
    /// # Errors
    /// If the lines are skew, parallel or identical; the error has their distance. Also the errors
    /// of [`dual_angle`](Self::dual_angle).
    ///
    /// ```
    /// use dq8::{Line, incidence::IncidenceError};
    /// let x_axis = Line::from_point_direction([0.0; 3], [1.0_f64, 0.0, 0.0]);
    /// let through = Line::from_points([2.0, 1.0, 0.0], [2.0, 3.0, 0.0])?;
    /// assert_eq!(x_axis.intersection(through, 1e-12)?, [2.0, 0.0, 0.0]);
    /// let same = x_axis.intersection(x_axis, 1e-12);
    /// assert_eq!(same, Err(IncidenceError::ParallelLines { distance: 0.0 }));
    /// # Ok::<(), dq8::incidence::IncidenceError>(())
    /// ```
    pub fn intersection(self, other: Self, tolerance: R) -> Result<[R; 3], IncidenceError> {
        let CommonPerpendicular { feet: [first, second], angle, parallel, .. } =
            self.common_perpendicular(other)?;
        let distance = angle.dual.abs();
        if parallel {
            Err(IncidenceError::ParallelLines { distance: distance.into() })
        } else if distance <= tolerance {
            let way = vector::sub(second, first);
            Ok(vector::add(first, vector::scale(way, R::HALF)))
        } else {
            Err(IncidenceError::SkewLines { distance: distance.into() })
        }
    }
}

/// The direction, the two feet and the length of a common perpendicular.
type Perpendicular<R> = ([R; 3], [[R; 3]; 2], R);

/// Returns the common perpendicular of two skew unit lines. `normal` is l₁ × l₂, and `sine` is
/// its length.
fn between_skew<R: Real>(a: Line<R>, b: Line<R>, normal: [R; 3], sine: R) -> Perpendicular<R> {
    let n = vector::over_norm(normal, sine);
    // The distance is computed from the way between two points. The formula −(l₁·m₂ +
    // m₁·l₂)/sin θ would multiply the rounding errors of both moments by 1/sin θ.
    let [on_a, on_b] = [a, b].map(Line::closest_point_to_origin);
    let way = vector::sub(on_b, on_a);
    // The feet satisfy on_a + s l₁ + d n = on_b + t l₂. Products with l₂ × n and with l₁
    // × n give s and t.
    let s = vector::dot(vector::cross(way, b.direction), n) / sine;
    let t = vector::dot(vector::cross(way, a.direction), n) / sine;
    let first = vector::add(on_a, vector::scale(a.direction, s));
    let second = vector::add(on_b, vector::scale(b.direction, t));
    (n, [first, second], vector::dot(way, n))
}

/// Returns the common perpendicular of two parallel unit lines that lies in the plane through the
/// origin at right angles to them.
fn between_parallel<R: Real>(a: Line<R>, b: Line<R>) -> Result<Perpendicular<R>, IncidenceError> {
    let feet = [a, b].map(Line::closest_point_to_origin);
    let way = vector::sub(feet[1], feet[0]);
    let across = vector::across(a.direction, way);
    let distance = vector::norm(across);
    if distance <= parallel_sine::<R>() * size(a.moment, b.moment) {
        return Ok((vector::any_across(a.direction), feet, R::ZERO));
    }
    let (direction, _) = unit(across, "the way between parallel lines")?;
    Ok((direction, feet, distance))
}
