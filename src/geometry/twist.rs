//! Velocities and forces of rigid bodies.

use super::vector;
use core::ops::{Add, Mul, Neg, Sub};

crate::macros::pod! {
    /// A twist ω + εv: the velocity of a rigid body as a dual vector, an element of se(3).
    ///
    /// `angular` is ω in radians per unit of time. `linear` is v in lengths per unit of time, the
    /// velocity of *the point of the body that is at the origin of the frame*. There are two
    /// choices of the frame:
    ///
    /// - *spatial*: ω and v are in the axes and about the origin of the fixed frame, σ̇ =
    ///   ½ξσ;
    /// - *body*: ω and v are in the axes and about the origin of the moving frame, σ̇ = ½σξ.
    ///
    /// A motion σ converts the body twist to the spatial twist: spatial = σ body σ*, which is
    /// [`DualQuat::adjoint`](crate::DualQuat::adjoint).
    ///
    /// The logarithm of a motion is half the twist that makes the motion in unit time, because a
    /// quaternion carries half the angle; see [`DualQuat::to_twist`](crate::DualQuat::to_twist).
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// // A wheel of radius 2 on the ground: its lowest point, at the origin, stands still.
    /// let rolling = Twist { angular: [0.0_f32, 1.0, 0.0], linear: [0.0, 0.0, 0.0] };
    /// assert_eq!(rolling.velocity_at([0.0, 0.0, 2.0]), [2.0, 0.0, 0.0]);
    /// // Seen from the hub, the ground's frame is 2 below.
    /// let hub = DualQuat::from_translation([0.0, 0.0, 2.0]);
    /// assert_eq!(hub.conjugate().adjoint(rolling).linear, [2.0, 0.0, 0.0]);
    /// ```
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "rkyv_08", derive(rkyv::Archive, rkyv::Serialize, rkyv::Deserialize))]
    #[must_use]
    #[doc(alias("motion", "spatial_velocity", "se3"))]
    pub struct Twist<T> {
        /// The angular velocity ω in radians per unit of time.
        pub angular: [T; 3],
        /// The velocity v of the point at the frame's origin, in lengths per unit of time.
        pub linear: [T; 3],
    }
}

impl<T: Copy> Twist<T> {
    /// Makes a twist from `[ωx, ωy, ωz, vx, vy, vz]`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub const fn from_array([wx, wy, wz, vx, vy, vz]: [T; 6]) -> Self {
        Self { angular: [wx, wy, wz], linear: [vx, vy, vz] }
    }

    /// Returns `[ωx, ωy, ωz, vx, vy, vz]`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub const fn to_array(self) -> [T; 6] {
        let ([wx, wy, wz], [vx, vy, vz]) = (self.angular, self.linear);
        [wx, wy, wz, vx, vy, vz]
    }

    /// Returns the twist times `factor`, for example the unit twist of a joint times the joint's
    /// rate.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn scale(self, factor: T) -> Self
    where
        T: Mul<Output = T>,
    {
        let [wx, wy, wz, vx, vy, vz] = self.to_array();
        let angular = [wx * factor, wy * factor, wz * factor];
        Self { angular, linear: [vx * factor, vy * factor, vz * factor] }
    }

    /// Returns v + ω × x, the velocity of the point of the body that is at x, in the frame of the
    /// twist.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn velocity_at(self, [x, y, z]: [T; 3]) -> [T; 3]
    where
        T: Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
    {
        let [wx, wy, wz, vx, vy, vz] = self.to_array();
        [vx + (wy * z - wz * y), vy + (wz * x - wx * z), vz + (wx * y - wy * x)]
    }
}

sums_of_vectors!(Twist { angular, linear });

crate::macros::pod! {
    /// A wrench f + ετ: force and torque on a rigid body, dual to a [`Twist`].
    ///
    /// `torque` is taken about the origin of the frame, and both vectors are in its axes. As with
    /// twists, the frame is *spatial* (fixed) or *body* (moving).
    /// [`DualQuat::coadjoint`](crate::DualQuat::coadjoint) converts a body wrench to the spatial
    /// wrench.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[must_use]
    #[doc(alias("force", "spatial_force"))]
    pub struct Wrench<T> {
        /// The force f.
        pub force: [T; 3],
        /// The torque τ about the frame's origin.
        pub torque: [T; 3],
    }
}

impl<T: Copy + Add<Output = T> + Mul<Output = T>> Wrench<T> {
    /// Returns f·v + τ·ω, the power of this wrench on a body that moves with `twist`. Both must
    /// be given in the same frame; the power does not depend on which frame it is.
    ///
    /// ```
    /// use dq8::{Twist, geometry::Wrench};
    /// let wrench = Wrench { force: [0.0, 0.0, 9.0], torque: [2.0_f64, 0.0, 0.0] };
    /// let twist = Twist { angular: [3.0, 0.0, 0.0], linear: [0.0, 0.0, 1.0] };
    /// assert_eq!(wrench.dot(twist), 15.0);
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn dot(self, twist: Twist<T>) -> T {
        let ([fx, fy, fz], [vx, vy, vz]) = (self.force, twist.linear);
        let ([tx, ty, tz], [wx, wy, wz]) = (self.torque, twist.angular);
        (fx * vx + fy * vy + fz * vz) + (tx * wx + ty * wy + tz * wz)
    }
}
