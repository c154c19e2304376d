use super::Twist;
use core::ops::{Add, Mul};

crate::pod::pod! {
    /// A wrench f + ετ: force and torque on a rigid body, dual to a [`Twist`].
    ///
    /// `torque` is taken about the origin of the frame; both vectors are in its axes. As with
    /// twists, the frame is *spatial* (fixed) or *body* (moving), and
    /// [`DualQuat::coadjoint`](crate::DualQuat::coadjoint) takes the one to the other.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[must_use]
    #[doc(alias("force", "spatial_force"))]
    pub struct Wrench<T> {
        /// f
        pub force: [T; 3],
        /// τ, about the frame's origin.
        pub torque: [T; 3],
    }
}

impl<T: Copy + Add<Output = T> + Mul<Output = T>> Wrench<T> {
    /// The product f·v + τ·ω, the power of this wrench on a body that moves with `twist`: the
    /// same number in every frame, as long as both are in the same one.
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
