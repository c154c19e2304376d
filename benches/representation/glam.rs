use super::{Product, Representation, Rows};
use dq8::DualQuat;
use glam::{Affine3A, Mat4, Quat, Vec3};

impl Product for Affine3A {
    #[inline(always)]
    fn product(&self, first: &Self) -> Self {
        *self * *first
    }
}

impl Representation for Affine3A {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        // By way of a matrix with zeros where this one has padding: what else gets there shrinks with
        // every product, and after hundreds in a row is subnormal, six times as slow.
        Self::from_mat4(Mat4::from_motion(motion))
    }
    fn rows(&self) -> Rows {
        Mat4::from(*self).rows()
    }
}

impl Product for Mat4 {
    #[inline(always)]
    fn product(&self, first: &Self) -> Self {
        *self * *first
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
