//! Lines and planes.

use super::vector;
use core::ops::{Add, Mul, Sub};

crate::macros::pod! {
    /// A line in Plücker coordinates l + εm: every point x of it has x × l = m.
    ///
    /// The length of l is free; with |l| = 1, |m| is the distance from the origin and l × m the
    /// closest point (Jia, *Dual Quaternions*, §8.1). Lines have a sense: −l − εm is the same
    /// points, passed the other way.
    ///
    /// Here is what needs no division, for floats and lanes alike. What may fail, and what
    /// measures, is for [`Real`](crate::Real) numbers: [`from_points`](Line::from_points),
    /// [`from_planes`](Line::from_planes), [`dual_angle`](Line::dual_angle),
    /// [`common_perpendicular`](Line::common_perpendicular) and others.
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
    /// l + ε(p × l) (Jia §8.1). The direction is taken as it is; a zero one makes no line, which
    /// [`try_normalize`](Line::try_normalize) reports.
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

    /// l × m, the point nearest to the origin (Jia §8.1). l must have length 1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn closest_point_to_origin(self) -> [T; 3] {
        vector::cross(self.direction, self.moment)
    }

    /// l × m + l(l·x), the point nearest to x. l must have length 1.
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

    /// l₁·m₂ + m₁·l₂, the dual part of the inner product: zero if and only if the lines
    /// lie in one plane, so that they meet or are parallel. For unit lines it is −d sin θ.
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
        /// n, the normal.
        pub normal: [T; 3],
        /// d, the distance from the origin along n, in units of |n|.
        pub offset: T,
    }
}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>> Plane<T> {
    /// n·x = n·p. The normal is taken as it is; a zero one makes no plane, which
    /// [`try_normalize`](Plane::try_normalize) reports.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_point_normal(point: [T; 3], normal: [T; 3]) -> Self {
        Self { normal, offset: vector::dot(normal, point) }
    }

    /// n·x − d, the distance of x from the plane, positive on the side of n. n must have length
    /// 1; otherwise it is |n| times that.
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
