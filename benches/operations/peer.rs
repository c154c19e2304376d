//! What operations are applied to, as peers hold it.

use crate::case::Case;
use crate::representation::Representation;
use dq8::DualQuat;
use glam::{Affine3A, Quat, Vec3, Vec3A};
use nalgebra::{DualQuaternion, Point3, Quaternion, Translation3, UnitDualQuaternion};
use nalgebra::{UnitQuaternion, Vector3};

pub(crate) struct Glam {
    pub(crate) a: Affine3A,
    pub(crate) b: Affine3A,
    pub(crate) rotation: Quat,
    pub(crate) translation: Vec3,
    pub(crate) vector: Vec3A,
}

impl From<&Case<DualQuat<f32>>> for Glam {
    fn from(case: &Case<DualQuat<f32>>) -> Self {
        Self {
            a: Affine3A::from_motion(&case.a),
            b: Affine3A::from_motion(&case.b),
            rotation: Quat::from_array(case.rotation.to_array()),
            translation: case.translation.into(),
            vector: case.vector.into(),
        }
    }
}

pub(crate) struct Nalgebra {
    pub(crate) a: UnitDualQuaternion<f32>,
    pub(crate) b: UnitDualQuaternion<f32>,
    pub(crate) scaled: DualQuaternion<f32>,
    pub(crate) rotation: UnitQuaternion<f32>,
    pub(crate) translation: Translation3<f32>,
    pub(crate) point: Point3<f32>,
    pub(crate) vector: Vector3<f32>,
    pub(crate) t: f32,
}

impl From<&Case<DualQuat<f32>>> for Nalgebra {
    fn from(case: &Case<DualQuat<f32>>) -> Self {
        let quaternion = |quat: dq8::Quat<f32>| Quaternion::from(quat.to_array());
        Self {
            a: UnitDualQuaternion::from_motion(&case.a),
            b: UnitDualQuaternion::from_motion(&case.b),
            scaled: DualQuaternion::from_real_and_dual(
                quaternion(case.scaled.real()),
                quaternion(case.scaled.dual()),
            ),
            rotation: UnitQuaternion::new_unchecked(quaternion(case.rotation)),
            translation: case.translation.into(),
            point: case.vector.into(),
            vector: case.vector.into(),
            t: case.t,
        }
    }
}
