//! Lines and planes.

use super::vector;
use core::ops::{Add, Mul, Sub};

crate::macros::pod! {
    /// A line in Plücker coordinates l + εm: every point x on the line satisfies x × l = m.
    ///
    /// The vector l may have any length. With |l| = 1, |m| is the distance from the origin, and l
    /// × m is the point closest to the origin (Jia, *Dual Quaternions*, §8.1). A line has a sense
    /// (one of its two directions): −l − εm has the same points and the opposite sense.
    ///
    /// The methods here need no division and serve floats and lanes alike. Methods that may fail,
    /// and methods that measure angles or distances, are for [`Real`](crate::Real) numbers only:
    /// [`from_points`](Line::from_points), [`from_planes`](Line::from_planes),
    /// [`dual_angle`](Line::dual_angle), [`common_perpendicular`](Line::common_perpendicular) and
    /// others.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[must_use]
    pub struct Line<T> {
        /// l, the direction.
        pub direction: [T; 3],
        /// m = x × l for any point x of the line, the moment about the origin.
        pub moment: [T; 3],
    }
}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>> Line<T> {
    /// Makes the line l + ε(p × l) (Jia §8.1). The direction l is not normalized. If the
    /// direction is zero, the result is not a line, and [`try_normalize`](Line::try_normalize)
    /// returns an error.
    ///
    /// ```
    /// use dq8::Line;
    /// let line = Line::from_point_direction([0.0, 0.0, 2.0], [1.0_f32, 0.0, 0.0]);
    /// assert_eq!(line.moment, [0.0, 2.0, 0.0]);
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_point_direction(point: [T; 3], direction: [T; 3]) -> Self {
        Self { direction, moment: vector::cross(point, direction) }
    }

    /// Returns l × m, the point nearest to the origin (Jia §8.1). l must have length 1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn closest_point_to_origin(self) -> [T; 3] {
        vector::cross(self.direction, self.moment)
    }

    /// Returns l × m + l(l·x), the point of the line nearest to x. l must have length 1.
    ///
    /// ```
    /// use dq8::Line;
    /// let line = Line::from_point_direction([0.0, 0.0, 2.0], [1.0_f32, 0.0, 0.0]);
    /// assert_eq!(line.closest_point([3.0, 4.0, 5.0]), [3.0, 0.0, 2.0]);
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn closest_point(self, point: [T; 3]) -> [T; 3] {
        let along = vector::scale(self.direction, vector::dot(self.direction, point));
        vector::add(self.closest_point_to_origin(), along)
    }

    /// Returns l₁·m₂ + m₁·l₂, the dual part of the inner product of two lines. It is zero
    /// if and only if the lines lie in one plane, so that they intersect or are parallel. For unit
    /// lines with the angle θ and the distance d between them it is −d sin θ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn reciprocal_product(self, other: Self) -> T {
        vector::dot(self.direction, other.moment) + vector::dot(self.moment, other.direction)
    }
}

crate::macros::pod! {
    /// A plane n·x = d.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[must_use]
    pub struct Plane<T> {
        /// The normal n.
        pub normal: [T; 3],
        /// The offset d. It is |n| times the signed distance from the origin along n.
        pub offset: T,
    }
}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>> Plane<T> {
    /// Makes the plane n·x = n·p. The normal n is not normalized. If the normal is zero, the
    /// result is not a plane, and [`try_normalize`](Plane::try_normalize) returns an error.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_point_normal(point: [T; 3], normal: [T; 3]) -> Self {
        Self { normal, offset: vector::dot(normal, point) }
    }

    /// Returns n·x − d, the distance of x from the plane, positive on the side of n. The normal
    /// n must have length 1; otherwise the result is |n| times the distance.
    ///
    /// ```
    /// use dq8::Plane;
    /// let table = Plane::from_point_normal([5.0_f32, 5.0, 2.0], [0.0, 0.0, 1.0]);
    /// assert_eq!(table.signed_distance([1.0, 1.0, 0.0]), -2.0);
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn signed_distance(self, point: [T; 3]) -> T {
        vector::dot(self.normal, point) - self.offset
    }
}
