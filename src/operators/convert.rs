//! `From` and `Into` for arrays and for the parts of a motion. Arrays have the order of memory.
//! Matrices have named functions instead, because a conversion could not say whether an array holds
//! rows or columns.

use crate::geometry::{Twist, Wrench};
use crate::macros::conversions;
use crate::number::Real;
use crate::representation::RotationTranslation;
use crate::scalar::{DualQuat, Quat};

conversions! {
    /// Makes a quaternion from `[x, y, z, w]`.
    [R: Real] [R; 4] => Quat<R>: |components| Self::from_array(components);
    /// Returns `[x, y, z, w]`.
    [R: Real] Quat<R> => [R; 4]: |rotation| rotation.to_array();
    /// Makes a dual quaternion from `[px, py, pz, pw, qx, qy, qz, qw]`.
    [R: Real] [R; 8] => DualQuat<R>: |components| Self::from_array(components);
    /// Returns `[px, py, pz, pw, qx, qy, qz, qw]`.
    [R: Real] DualQuat<R> => [R; 8]: |motion| motion.to_array();
    /// Makes a pose from `[x, y, z, w, tx, ty, tz]`, the rotation and then the translation.
    [R: Real] [R; 7] => RotationTranslation<R>: |components| Self::from_array(components);
    /// Returns `[x, y, z, w, tx, ty, tz]`, the rotation and then the translation.
    [R: Real] RotationTranslation<R> => [R; 7]: |pose| pose.to_array();
    /// Makes a twist from `[ωx, ωy, ωz, vx, vy, vz]`.
    [R: Real] [R; 6] => Twist<R>: |components| Self::from_array(components);
    /// Returns `[ωx, ωy, ωz, vx, vy, vz]`.
    [R: Real] Twist<R> => [R; 6]: |twist| twist.to_array();
    /// Makes a twist from the angular and the linear velocity.
    [R: Real] ([R; 3], [R; 3]) => Twist<R>: |(angular, linear)| Self { angular, linear };
    /// Makes a wrench from the force and the torque.
    [R: Real] ([R; 3], [R; 3]) => Wrench<R>: |(force, torque)| Self { force, torque };
    /// Calls [`DualQuat::from_rotation`].
    [R: Real] Quat<R> => DualQuat<R>: |rotation| Self::from_rotation(rotation);
    /// Calls [`DualQuat::from_rotation_translation`].
    [R: Real] (Quat<R>, [R; 3]) => DualQuat<R>: |(r, t)| Self::from_rotation_translation(r, t);
    /// Returns the rotation and the translation of a unit σ.
    [R: Real] DualQuat<R> => (Quat<R>, [R; 3]): |motion| (motion.rotation(), motion.translation());
    /// Makes a pose from a rotation and a translation.
    [R: Real] (Quat<R>, [R; 3]) => RotationTranslation<R>: |(rotation, translation)| Self { rotation, translation };
    /// Returns the motion r + ½εtr of the rotation r and the translation t.
    [R: Real] RotationTranslation<R> => DualQuat<R>: |pose| (pose.rotation, pose.translation).into();
    /// Returns r = p and t = 2qp* of a unit σ = p + εq.
    [R: Real] DualQuat<R> => RotationTranslation<R>: |motion| <(Quat<R>, [R; 3])>::from(motion).into();
    /// Makes p + εq from its two quaternions, the real part first.
    [R: Real] [Quat<R>; 2] => DualQuat<R>: |[real, dual]| Self::new(real, dual);
}
