//! [`Quaternion`], the contract that the quaternions of the scalar reference and of the lanes
//! share.

use crate::contract::shared_trait;
use core::fmt::Debug;
use core::ops::{Add, Mul, Neg, Sub};

shared_trait! {
    /// Quaternions q = w + xi + yj + zk: a single quaternion ([`Quat`](crate::Quat)), or many, one
    /// per lane ([`batch::Quat`](crate::batch::Quat)). Unit quaternions are the rotations of
    /// [`Motion`](crate::Motion), whose conventions hold here too.
    ///
    /// # Laws
    ///
    /// The laws hold up to rounding for finite values; `tests/algebra/quaternion.rs` has the
    /// bounds:
    ///
    /// | law | for |
    /// |---|---|
    /// | (ab)c = a(bc), a·1 = 1·a = a, a(b + c) = ab + ac | all |
    /// | (ab)* = b*a*, \|ab\| = \|a\| \|b\|, a·b is the scalar part of ab* | all |
    /// | \|normalize(q)\| = 1, q q⁻¹ = 1 | q ≠ 0 |
    /// | (ab)v = a(bv) = the product of the matrices with v; lengths are kept | unit |
    /// | from_matrix3(to_matrix3(q)) = ±q | unit |
    /// | from_scaled_axis(to_scaled_axis(q)) = ±q, the same for axis and angle | unit |
    /// | slerp(a, b, 0) = a, slerp(a, b, 1) = ±b; its angle to a is t times that of b | unit |
    /// | angle_to does not see the sign of q | unit |
    /// | from_rotation_arc(v, w) takes the direction of v to that of w | v, w ≠ 0 |
    ///
    /// The documentation of [`Quat`](crate::Quat) has the formula and the source of each operation.
    /// No type outside this crate can implement the trait.
    trait Quaternion: Copy, Debug, Add<Output = Self>, Sub<Output = Self>, Mul<Output = Self>, Neg<Output = Self>;

    delegate by delegate_quaternion;

    types {
        /// The type of the value that functions need to make constants. It is `()` for scalars. For
        /// lanes it is a level, the proof that the CPU has their instructions.
        type Level: Copy;
        /// A real number, or a vector with a real number per lane.
        type Real: Copy + Debug;
        /// A `bool`, or a mask with a truth value per lane.
        type Mask: Copy + Debug;
    }

    by_hand {
        /// Returns the identity 1, the rotation by the angle 0.
        fn identity(level: Self::Level) -> Self;
        /// Returns q/|q|, and a mask that is `true` where this quotient does not exist, because q
        /// is zero or a component is not finite. There the first result is NaN.
        fn normalize_checked(self) -> (Self, Self::Mask);
    }

    inherent {
        /// Makes a quaternion from `[x, y, z, w]`.
        fn from_array(xyzw: [Self::Real; 4]) -> Self;
        /// Returns the components `[x, y, z, w]`.
        fn to_array(self) -> [Self::Real; 4];
        /// Makes a quaternion from the vector part and the scalar part.
        fn from_parts(xyz: [Self::Real; 3], w: Self::Real) -> Self;
        /// Returns the vector part.
        fn xyz(self) -> [Self::Real; 3];
        /// Returns the scalar part.
        fn w(self) -> Self::Real;

        /// Returns cos(θ/2) + n sin(θ/2) for the axis n and the angle θ.
        fn from_axis_angle(axis: [Self::Real; 3], angle: Self::Real) -> Self;
        /// Returns the axis n and the angle θ of the canonical choice of ±q.
        fn to_axis_angle(self) -> ([Self::Real; 3], Self::Real);
        /// Returns the turn by |v| radians about v.
        fn from_scaled_axis(v: [Self::Real; 3]) -> Self;
        /// Returns θn, the axis n times the angle θ in radians.
        fn to_scaled_axis(self) -> [Self::Real; 3];
        /// Returns cos(θ/2) + i sin(θ/2), the turn by θ = `angle` about the x axis.
        fn from_rotation_x(angle: Self::Real) -> Self;
        /// Returns cos(θ/2) + j sin(θ/2), the turn by θ = `angle` about the y axis.
        fn from_rotation_y(angle: Self::Real) -> Self;
        /// Returns cos(θ/2) + k sin(θ/2), the turn by θ = `angle` about the z axis.
        fn from_rotation_z(angle: Self::Real) -> Self;
        /// Returns the smallest turn from one direction to another.
        fn from_rotation_arc(from: [Self::Real; 3], to: [Self::Real; 3]) -> Self;
        /// Returns the rotation of a matrix, with w ≥ 0.
        fn from_matrix3(rows: [[Self::Real; 3]; 3]) -> Self;
        /// Returns the rows of the rotation matrix.
        fn to_matrix3(self) -> [[Self::Real; 3]; 3];

        /// Returns the conjugate w − xi − yj − zk.
        fn conjugate(self) -> Self;
        /// Returns sq for the real number s = `factor`.
        fn scale(self, factor: Self::Real) -> Self;
        /// Returns the scalar product of two quaternions as 4-vectors.
        fn dot(self, other: Self) -> Self::Real;
        /// Returns the norm |q|.
        fn norm(self) -> Self::Real;
        /// Returns q/|q|, or NaN where this quotient does not exist.
        fn normalize(self) -> Self;
        /// Returns q*/|q|²; some component is NaN or infinite where q is zero or not finite.
        fn inverse(self) -> Self;
        /// Returns `true` where ||q| − 1| ≤ `tolerance`.
        fn is_unit(self, tolerance: Self::Real) -> Self::Mask;
        /// Returns `true` where every component of `self` differs from that of `other` by at most
        /// `tolerance`.
        fn abs_diff_eq(self, other: Self, tolerance: Self::Real) -> Self::Mask;

        /// Returns r v r*, the vector v turned by unit r.
        fn rotate(self, v: [Self::Real; 3]) -> [Self::Real; 3];
        /// Returns the angle in [0, π] radians of the rotation a*b from a = `self` to b = `other`.
        fn angle_to(self, other: Self) -> Self::Real;
        /// Returns normalize((1−t)a ± tb) with a = `self` and b = `other`, and the sign for
        /// which the way is shorter.
        fn nlerp(self, other: Self, t: Self::Real) -> Self;
        /// Returns a(a*b)ᵗ, from a = `self` to b = `other` by the shorter way.
        fn slerp(self, other: Self, t: Self::Real) -> Self;
    }
}
