//! Screws, and dual vectors, for instance the logarithms of motions.

use super::{Line, vector};
use core::ops::{Add, Mul, Neg, Sub};

crate::macros::pod! {
    /// A dual vector a + εb (Jia, *Dual Quaternions*, §3): the vector part of a dual quaternion,
    /// and the logarithm of a unit dual quaternion.
    ///
    /// The logarithm of a screw with axis l + εm, angle θ and slide d is (θ̂/2)(l + εm) with
    /// θ̂ = θ + εd: `real` = l·θ/2 and `dual` = m·θ/2 + l·d/2.
    ///
    /// For dual quaternions without a scalar part, ab = −a·b + a × b (Jia §4). The products of
    /// dual vectors are those of vectors whose components are dual numbers, and obey the same laws.
    ///
    /// ```
    /// use dq8::{Line, geometry::DualVector};
    /// // The x axis, and the parallel of the y axis that crosses z at 3.
    /// let a = Line::from_point_direction([0.0_f32; 3], [1.0, 0.0, 0.0]);
    /// let b = Line::from_point_direction([0.0, 0.0, 3.0], [0.0, 1.0, 0.0]);
    /// let (a, b) = (DualVector::from(a), DualVector::from(b));
    /// // The dual angle is θ̂ = π/2 + 3ε, with cos θ̂ = cos θ − ε d sin θ.
    /// assert_eq!(a.dot(b), [0.0, -3.0]);
    /// assert_eq!(a.cross(b), DualVector { real: [0.0, 0.0, 1.0], dual: [0.0; 3] });
    /// ```
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[must_use]
    pub struct DualVector<T> {
        /// The real part a.
        pub real: [T; 3],
        /// The dual part b.
        pub dual: [T; 3],
    }
}

impl<T: Copy> DualVector<T> {
    /// Returns s(a + εb) for the real number s = `factor`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn scale(self, factor: T) -> Self
    where
        T: Mul<Output = T>,
    {
        Self { real: vector::scale(self.real, factor), dual: vector::scale(self.dual, factor) }
    }

    /// Returns (s + εu)(a + εb) = sa + ε(sb + ua) for a dual number s + εu, which is given as
    /// `[s, u]` (Jia §3).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn scale_dual(self, [real, dual]: [T; 2]) -> Self
    where
        T: Add<Output = T> + Mul<Output = T>,
    {
        let Self { real: a, dual: b } = self;
        Self {
            real: vector::scale(a, real),
            dual: vector::add(vector::scale(b, real), vector::scale(a, dual)),
        }
    }

    /// The inner product (a + εb)·(c + εd) = a·c + ε(a·d + b·c), a dual number that is
    /// returned as `[real, dual]` (Jia eq. 8). For unit lines with the dual angle θ̂ = θ + εd
    /// between them it is cos θ̂ = cos θ − ε d sin θ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn dot(self, other: Self) -> [T; 2]
    where
        T: Add<Output = T> + Mul<Output = T>,
    {
        let ends = vector::dot(self.real, other.dual) + vector::dot(self.dual, other.real);
        [vector::dot(self.real, other.real), ends]
    }

    /// The cross product (a + εb) × (c + εd) = a × c + ε(a × d + b × c) (Jia eq. 9). For
    /// unit lines with the dual angle θ̂ between them it is sin θ̂ times their common
    /// perpendicular.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn cross(self, other: Self) -> Self
    where
        T: Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
    {
        let (first, second) =
            (vector::cross(self.real, other.dual), vector::cross(self.dual, other.real));
        Self { real: vector::cross(self.real, other.real), dual: vector::add(first, second) }
    }
}

sums_of_vectors!(DualVector { real, dual });

/// Converts a line to the dual vector l + εm.
impl<T> From<Line<T>> for DualVector<T> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn from(line: Line<T>) -> Self {
        Self { real: line.direction, dual: line.moment }
    }
}

/// Converts a dual vector to the line l + εm. The result is a line only if l·m = 0. Any other
/// dual vector is a screw: its pitch is l·m/l·l, and [`Line::try_normalize`] gives its axis.
impl<T> From<DualVector<T>> for Line<T> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn from(vector: DualVector<T>) -> Self {
        Self { direction: vector.real, moment: vector.dual }
    }
}

crate::macros::pod! {
    /// A screw: a turn by θ about an axis, and a slide by d along it. Every rigid motion is a
    /// screw (Chasles).
    ///
    /// Its unit dual quaternion is σ = cos(θ̂/2) + sin(θ̂/2)(l + εm), where l + εm is the
    /// axis and θ̂ = θ + εd the dual angle (Jia, *Dual Quaternions*, eq. 43).
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[must_use]
    pub struct Screw<T> {
        /// The screw axis l + εm with |l| = 1.
        pub axis: Line<T>,
        /// The angle θ in radians. In results of dq8 it is in [0, π]; in input it may be any
        /// angle.
        pub angle: T,
        /// The slide d, the translation along the axis, in the user's unit of length.
        pub slide: T,
    }
}

impl<T: Copy + core::ops::Div<Output = T>> Screw<T> {
    /// Returns the pitch d / θ, a length per radian (Jia §8.2). It is infinite for a pure
    /// translation and NaN for the identity.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn pitch(&self) -> T {
        self.slide / self.angle
    }
}
