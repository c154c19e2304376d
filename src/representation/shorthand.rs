//! Short forms of other operations, under names that users know from other libraries.

use super::euler_angles::{EulerAxes, EulerFrame, EulerOrder};
use crate::geometry::Twist;
use crate::number::Real;
use crate::scalar::{DualQuat, Quat, blend::dib, vector};

impl<R: Real> Quat<R> {
    /// Returns the angles of roll about x, then pitch about y, then yaw about z, all about fixed
    /// axes, of this unit quaternion: the arguments of [`from_rpy`](Self::from_rpy). Pitch is in
    /// [−π/2, π/2], roll and yaw are in [−π, π]. If pitch is at an end of its range (gimbal
    /// lock), yaw is 0 and roll has the whole turn about the common axis;
    /// [`to_euler`](Self::to_euler) reports this case.
    ///
    /// ```
    /// use dq8::Quat;
    /// let [roll, pitch, yaw] = Quat::from_rpy(0.25_f64, -0.5, 2.0).to_rpy();
    /// assert!((roll - 0.25).abs() + (pitch + 0.5).abs() + (yaw - 2.0).abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    #[doc(alias = "to_euler_angles")]
    #[doc(alias = "euler_angles")]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn to_rpy(self) -> [R; 3] {
        crate::scalar::must_be_unit::rotations("Quat::to_rpy", [self]);
        self.to_euler(EulerOrder::XYZ.extrinsic()).angles.angles
    }

    /// Returns the logarithm of a unit quaternion, n θ/2 with ±q = cos(θ/2) + n sin(θ/2) and θ
    /// in [0, π]. It is half of [`to_scaled_axis`](Self::to_scaled_axis), and the real part of
    /// [`DualQuat::log`].
    ///
    /// ```
    /// use dq8::Quat;
    /// let turn = Quat::from_rotation_z(0.5_f64);
    /// assert!((turn.log()[2] - 0.25).abs() < 1e-15);
    /// assert!(Quat::exp(turn.log()).abs_diff_eq(turn, 1e-15));
    /// ```
    #[inline]
    #[must_use]
    #[doc(alias = "ln")]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn log(self) -> [R; 3] {
        crate::scalar::must_be_unit::rotations("Quat::log", [self]);
        vector::scale(self.to_scaled_axis(), R::HALF)
    }

    /// Returns the exponential cos |v| + sin |v| v/|v|, the turn by 2|v| radians about v: it is
    /// [`from_scaled_axis`](Self::from_scaled_axis) of 2v. The vector v may have any length.
    #[inline]
    pub fn exp(log: [R; 3]) -> Self {
        Self::from_scaled_axis(vector::scale(log, R::TWO))
    }

    /// Returns qᵗ = exp(t log q) for any real t: the same axis with t times the angle. If w < 0,
    /// −q is raised to the power in place of q, as in [`DualQuat::pow`]. q must be unit.
    ///
    /// ```
    /// use dq8::Quat;
    /// let third = Quat::from_rotation_x(0.75_f64).pow(1.0 / 3.0);
    /// assert!(third.abs_diff_eq(Quat::from_rotation_x(0.25), 1e-15));
    /// ```
    #[inline]
    #[doc(alias = "powf")]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn pow(self, t: R) -> Self {
        crate::scalar::must_be_unit::rotations("Quat::pow", [self]);
        Self::from_scaled_axis(vector::scale(self.to_scaled_axis(), t))
    }

    /// Returns the intrinsic mean of unit quaternions, all with the same weight. Their signs do not
    /// matter. It is [`DualQuat::mean`] of rotations.
    ///
    /// ```
    /// use dq8::Quat;
    /// let mean = Quat::mean(&[0.1, 0.2, 0.6].map(Quat::<f64>::from_rotation_y)).unwrap();
    /// assert!(mean.abs_diff_eq(Quat::from_rotation_y(0.3), 1e-14));
    /// assert_eq!(Quat::<f64>::mean(&[]), None);
    /// ```
    #[inline]
    #[doc(alias = "average")]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn mean(rotations: &[Self]) -> Option<Self> {
        for &rotation in rotations {
            crate::scalar::must_be_unit::rotations("Quat::mean", [rotation]);
        }
        let poses = rotations.iter().map(|&rotation| DualQuat::from_rotation(rotation));
        mean(poses).map(DualQuat::real)
    }
}

impl<R: Real> DualQuat<R> {
    /// Returns the motion of URDF's `<origin xyz rpy>`: roll, pitch and yaw about fixed axes
    /// ([`Quat::from_rpy`]), then the translation.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// let origin = DualQuat::from_xyz_rpy([1.0_f64, 2.0, 3.0], [0.1, 0.2, 0.3]);
    /// assert_eq!(origin.rotation(), Quat::from_rpy(0.1, 0.2, 0.3));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_xyz_rpy(xyz: [R; 3], [roll, pitch, yaw]: [R; 3]) -> Self {
        Self::from_rotation_translation(Quat::from_rpy(roll, pitch, yaw), xyz)
    }

    /// Returns the turn by `angle` radians about `axis` through the origin:
    /// [`Quat::from_axis_angle`]. The axis must have length 1.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn from_axis_angle(axis: [R; 3], angle: R) -> Self {
        crate::scalar::must_be_unit::axis("DualQuat::from_axis_angle", axis);
        Self::from_rotation(Quat::from_axis_angle(axis, angle))
    }

    /// Returns the turn by `angle` radians about the x axis: [`Quat::from_rotation_x`].
    #[inline]
    #[must_use]
    pub fn from_rotation_x(angle: R) -> Self {
        Self::from_rotation(Quat::from_rotation_x(angle))
    }

    /// Returns the turn by `angle` radians about the y axis: [`Quat::from_rotation_y`].
    #[inline]
    #[must_use]
    pub fn from_rotation_y(angle: R) -> Self {
        Self::from_rotation(Quat::from_rotation_y(angle))
    }

    /// Returns the turn by `angle` radians about the z axis: [`Quat::from_rotation_z`].
    #[inline]
    #[must_use]
    pub fn from_rotation_z(angle: R) -> Self {
        Self::from_rotation(Quat::from_rotation_z(angle))
    }

    /// Returns this motion's rotation with another translation. σ must be unit.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let turn = DualQuat::from_rotation_z(1.0_f64);
    /// let moved = turn.with_translation([2.0, 0.0, 0.0]);
    /// assert_eq!(moved.transform_point([0.0; 3]), [2.0, 0.0, 0.0]);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn with_translation(self, translation: [R; 3]) -> Self {
        crate::scalar::must_be_unit::motions("DualQuat::with_translation", [self]);
        Self::from_rotation_translation(self.rotation(), translation)
    }

    /// Returns this motion's translation with another rotation. The motion and the rotation must be
    /// unit.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn with_rotation(self, rotation: Quat<R>) -> Self {
        crate::scalar::must_be_unit::motions("DualQuat::with_rotation", [self]);
        Self::from_rotation_translation(rotation, self.translation())
    }

    /// Returns the intrinsic mean of unit motions, all with the same weight. Their signs do not
    /// matter. The iteration [`dib`](Self::dib) runs until its steps are within rounding errors.
    ///
    /// Returns `None` if there are no poses, if a component is not finite, or if the steps are
    /// still larger than rounding errors after 64 iterations. Poses more than a quarter of a turn
    /// from their mean may have several means; this returns one of them.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let poses = [1.0, 2.0, 6.0].map(|x| DualQuat::from_translation([x, 0.0_f64, 0.0]));
    /// assert!((DualQuat::mean(&poses).unwrap().translation()[0] - 3.0).abs() < 1e-14);
    /// ```
    #[inline]
    #[must_use]
    #[doc(alias = "average")]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn mean(poses: &[Self]) -> Option<Self> {
        for &pose in poses {
            crate::scalar::must_be_unit::motions("DualQuat::mean", [pose]);
        }
        mean(poses.iter().copied())
    }
}

/// Computes the mean of motions with equal weights. The tolerance grows with the number n of
/// motions, because a sum of n logarithms has n rounding errors, and no step can become shorter
/// than these.
fn mean<R: Real>(poses: impl ExactSizeIterator<Item = DualQuat<R>> + Clone) -> Option<DualQuat<R>> {
    let roundings = i32::try_from(poses.len()).unwrap_or(i32::MAX).saturating_add(64);
    let influences = poses.map(|pose| (pose, R::ONE));
    let mean = dib(influences, R::EPSILON * R::from_f64(roundings.into()), 64)?;
    mean.converged.then_some(mean.motion)
}

impl<R: Real> Twist<R> {
    /// Returns √(|ω|² + |v|²), the length of the vector of all six components. It adds radians
    /// to lengths, so it depends on the unit of length. It serves as a simple test whether anything
    /// moves.
    ///
    /// ```
    /// use dq8::Twist;
    /// assert_eq!(Twist::from(([0.0, 0.0, 3.0], [4.0, 0.0, 0.0])).norm(), 5.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn norm(self) -> R {
        vector::norm(self.to_array())
    }

    /// `true` if every component is finite.
    #[inline]
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.to_array().into_iter().all(Real::is_finite)
    }
}

/// Defines constants for the orders with intrinsic axes. Their names are the axes, as in `EulerRot`
/// of glam and in the capital letters of SciPy.
macro_rules! intrinsic {
    ($($name:ident)*) => {
        impl EulerOrder {
            $(
                #[doc = concat!("[`EulerAxes::", stringify!($name), "`], intrinsic.")]
                pub const $name: Self = Self { axes: EulerAxes::$name, frame: EulerFrame::Intrinsic };
            )*

            /// Returns the extrinsic order with the same axes, which then stay fixed. glam calls
            /// such orders `…Ex`, and SciPy writes them in small letters.
            ///
            /// ```
            /// use dq8::{Quat, representation::EulerOrder};
            /// let urdf = Quat::from_euler(EulerOrder::XYZ.extrinsic(), 0.1, 0.2, 0.3);
            /// assert_eq!(urdf, Quat::from_rpy(0.1, 0.2, 0.3));
            /// ```
            #[must_use]
            pub const fn extrinsic(self) -> Self {
                Self { frame: EulerFrame::Extrinsic, ..self }
            }
        }
    };
}
intrinsic! { XYZ XZY YXZ YZX ZXY ZYX XYX XZX YXY YZY ZXZ ZYZ }
