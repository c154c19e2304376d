use super::{Element, Packed, Product, Representation, Rows};
use dq8::DualQuat;
use glam::{Affine3A, Mat4, Quat, Vec3, Vec3A};

impl Representation for Affine3A {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        // By way of a matrix with zeros where this one has padding: what else gets there shrinks
        // with every product, and after hundreds in a row is subnormal, six times as slow.
        Self::from_mat4(Mat4::from_motion(motion))
    }
    fn rows(&self) -> Rows {
        Mat4::from(*self).rows()
    }
}

impl Representation for Mat4 {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        let rotation = Quat::from_array(motion.rotation().to_array());
        Self::from_rotation_translation(rotation, Vec3::from_array(motion.translation()))
    }
    fn rows(&self) -> Rows {
        [0, 1, 2].map(|row| self.row(row).to_array().map(f64::from))
    }
}

/// What users of glam write who need no matrix.
#[derive(Clone, Copy)]
pub struct QuatVec3A {
    pub rotation: Quat,
    pub translation: Vec3A,
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

impl Element for Vec3A {
    fn numbers(&self, _: usize) -> Vec<f64> {
        self.to_array().map(f64::from).to_vec()
    }
}

impl Packed<[f32; 3]> for Vec3A {
    fn gather(lanes: &[[f32; 3]]) -> Self {
        Self::from_array(lanes[0])
    }
}
