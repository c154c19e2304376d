use super::vector;
use core::ops::{Add, Mul, Sub};

crate::pod::pod! {
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
