//! [`Quaternion`], the contract that the quaternions of the scalar reference and of the lanes
//! share.

use crate::contract::shared_trait;
use core::fmt::Debug;
use core::ops::{Add, Mul, Neg, Sub};

shared_trait! {
    /// Quaternions q = w + xi + yj + zk, one ([`Quat`](crate::Quat)) or many at a time
    /// ([`batch::Quat`](crate::batch::Quat)): the rotations of [`Motion`](crate::Motion), with its
    /// conventions.
    ///
    /// # Laws
    ///
    /// They hold up to rounding for finite values; `tests/algebra/quaternion.rs` has the bounds:
    ///
    /// | law | for |
    /// |---|---|
    /// | (ab)c = a(bc), a·1 = 1·a = a, a(b + c) = ab + ac | all |
    /// | (ab)* = b*a*, \|ab\| = \|a\| \|b\|, a·b is the scalar part of ab* | all |
    /// | \|normalize(q)\| = 1, q q⁻¹ = 1 | q ≠ 0 |
    /// | (ab)v = a(bv) = the product of the matrices with v; lengths are kept | unit |
    /// | from_matrix3(to_matrix3(q)) = ±q | unit |
    /// | from_scaled_axis(to_scaled_axis(q)) = ±q, the same for axis and angle | unit |
    /// | slerp(a, b, 0) = a, slerp(a, b, 1) = ±b; it is t of the angle away from a | unit |
    /// | angle_to does not see the sign of q | unit |
    /// | from_rotation_arc(v, w) takes the direction of v to that of w | v, w ≠ 0 |
    ///
    /// The documentation of each operation, with formula and source, stands on the scalar type. No
    /// other type can implement the trait.
    trait Quaternion: Copy, Debug, Add<Output = Self>, Sub<Output = Self>, Mul<Output = Self>, Neg<Output = Self>;

    delegate by delegate_quaternion;

    types {
        /// The value from which constants are made: `()` for scalars, and for lanes the proof that
        /// the CPU has their instructions.
        type Level: Copy;
        /// A real number, or one per lane.
        type Real: Copy + Debug;
        /// A truth value, or one per lane.
        type Mask: Copy + Debug;
    }

    by_hand {
        /// 1, no turn.
        fn identity(level: Self::Level) -> Self;
        /// q/|q|, and where that failed: q zero, or a component not finite. There the result is
        /// NaN.
        fn normalize_checked(self) -> (Self, Self::Mask);
    }

    inherent {
        /// From `[x, y, z, w]`.
        fn from_array(xyzw: [Self::Real; 4]) -> Self;
        /// `[x, y, z, w]`
        fn to_array(self) -> [Self::Real; 4];
        /// From the vector part and the scalar part.
        fn from_parts(xyz: [Self::Real; 3], w: Self::Real) -> Self;
        /// The vector part.
        fn xyz(self) -> [Self::Real; 3];
        /// The scalar part.
        fn w(self) -> Self::Real;

        /// cos(θ/2) + n sin(θ/2)
        fn from_axis_angle(axis: [Self::Real; 3], angle: Self::Real) -> Self;
        /// n and θ of the canonical one of ±q.
        fn to_axis_angle(self) -> ([Self::Real; 3], Self::Real);
        /// The turn by |v| about v.
        fn from_scaled_axis(v: [Self::Real; 3]) -> Self;
        /// θn
        fn to_scaled_axis(self) -> [Self::Real; 3];
        /// cos(θ/2) + i sin(θ/2)
        fn from_rotation_x(angle: Self::Real) -> Self;
        /// cos(θ/2) + j sin(θ/2)
        fn from_rotation_y(angle: Self::Real) -> Self;
        /// cos(θ/2) + k sin(θ/2)
        fn from_rotation_z(angle: Self::Real) -> Self;
        /// The least turn from one direction to another.
        fn from_rotation_arc(from: [Self::Real; 3], to: [Self::Real; 3]) -> Self;
        /// The rotation of a matrix, w ≥ 0.
        fn from_matrix3(rows: [[Self::Real; 3]; 3]) -> Self;
        /// The rows of the rotation matrix.
        fn to_matrix3(self) -> [[Self::Real; 3]; 3];

        /// w − xi − yj − zk
        fn conjugate(self) -> Self;
        /// sq
        fn scale(self, factor: Self::Real) -> Self;
        /// The scalar product of the two as 4-vectors.
        fn dot(self, other: Self) -> Self::Real;
        /// |q|
        fn norm(self) -> Self::Real;
        /// q/|q|, or NaN.
        fn normalize(self) -> Self;
        /// q*/|q|², or NaN or infinite.
        fn inverse(self) -> Self;
        /// ||q| − 1| ≤ tolerance
        fn is_unit(self, tolerance: Self::Real) -> Self::Mask;
        /// Every component differs by at most `tolerance`.
        fn abs_diff_eq(self, other: Self, tolerance: Self::Real) -> Self::Mask;

        /// r v r*
        fn rotate(self, v: [Self::Real; 3]) -> [Self::Real; 3];
        /// The angle of a*b, radians in [0, π].
        fn angle_to(self, other: Self) -> Self::Real;
        /// normalize((1−t)a ± tb)
        fn nlerp(self, other: Self, t: Self::Real) -> Self;
        /// a(a*b)ᵗ by the shorter way.
        fn slerp(self, other: Self, t: Self::Real) -> Self;
    }
}
