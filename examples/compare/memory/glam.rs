use super::Packed;
use crate::representation::{Product, Representation, Rows};
use dq8::DualQuat;
use glam::{Affine3A, Quat, Vec3A};

/// What users of glam write who need no matrix.
#[derive(Clone, Copy)]
pub(crate) struct QuatVec3A {
    pub(crate) rotation: Quat,
    pub(crate) translation: Vec3A,
}

impl Product for QuatVec3A {
    #[inline(always)]
    fn product(&self, first: &Self) -> Self {
        Self {
            rotation: self.rotation * first.rotation,
            translation: self.translation + self.rotation * first.translation,
        }
    }
}

impl Representation for QuatVec3A {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        Self {
            rotation: Quat::from_array(motion.rotation().to_array()),
            translation: Vec3A::from_array(motion.translation()),
        }
    }
    fn rows(&self) -> Rows {
        Affine3A::from_rotation_translation(self.rotation, self.translation.into()).rows()
    }
}

impl Packed<[f32; 3]> for Vec3A {
    const LANES: usize = 1;

    fn gather(lanes: &[[f32; 3]]) -> Self {
        Self::from_array(lanes[0])
    }
    fn numbers(&self, _: usize) -> Vec<f64> {
        self.to_array().map(f64::from).to_vec()
    }
}
