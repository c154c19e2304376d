//! `From` and `Into` for arrays and for the parts of a motion, where the order of the numbers is that of memory.
//! Matrices have named functions instead, because a conversion could not say rows or columns.

use crate::geometry::{Twist, Wrench};
use crate::number::Real;
use crate::representation::RotationTranslation;
use crate::scalar::{DualQuat, Quat};

macro_rules! arrays {
    ($($thing:ident: $count:literal, $order:literal;)*) => {$(
        #[doc = $order]
        impl<R: Real> From<[R; $count]> for $thing<R> {
            #[inline]
            fn from(components: [R; $count]) -> Self {
                Self::from_array(components)
            }
        }
        #[doc = $order]
        impl<R: Real> From<$thing<R>> for [R; $count] {
            #[inline]
            fn from(thing: $thing<R>) -> Self {
                thing.to_array()
            }
        }
    )*};
}
arrays! {
    Quat: 4, "`[x, y, z, w]`";
    DualQuat: 8, "`[px, py, pz, pw, qx, qy, qz, qw]`";
    RotationTranslation: 7, "`[x, y, z, w, tx, ty, tz]`";
    Twist: 6, "`[ωx, ωy, ωz, vx, vy, vz]`";
}

/// Force and torque.
impl<R: Real> From<([R; 3], [R; 3])> for Wrench<R> {
    #[inline]
    fn from((force, torque): ([R; 3], [R; 3])) -> Self {
        Self { force, torque }
    }
}

/// [`DualQuat::from_rotation`]
impl<R: Real> From<Quat<R>> for DualQuat<R> {
    #[inline]
    fn from(rotation: Quat<R>) -> Self {
        Self::from_rotation(rotation)
    }
}

/// [`DualQuat::from_rotation_translation`]
impl<R: Real> From<(Quat<R>, [R; 3])> for DualQuat<R> {
    #[inline]
    fn from((rotation, translation): (Quat<R>, [R; 3])) -> Self {
        Self::from_rotation_translation(rotation, translation)
    }
}

/// The rotation and the translation of a unit σ.
impl<R: Real> From<DualQuat<R>> for (Quat<R>, [R; 3]) {
    #[inline]
    fn from(motion: DualQuat<R>) -> Self {
        (motion.rotation(), motion.translation())
    }
}

/// Rotation and translation, side by side.
impl<R: Real> From<(Quat<R>, [R; 3])> for RotationTranslation<R> {
    #[inline]
    fn from((rotation, translation): (Quat<R>, [R; 3])) -> Self {
        Self { rotation, translation }
    }
}

/// p + εq of its two quaternions.
impl<R: Real> From<[Quat<R>; 2]> for DualQuat<R> {
    #[inline]
    fn from([real, dual]: [Quat<R>; 2]) -> Self {
        Self::new(real, dual)
    }
}
