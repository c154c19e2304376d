use super::{Product, Representation, Rows};
use dq8::DualQuat;
use nalgebra::{Isometry3, Quaternion, Translation3, UnitDualQuaternion, UnitQuaternion};

impl Product for UnitDualQuaternion<f32> {
    #[inline(always)]
    fn product(&self, first: &Self) -> Self {
        self * first
    }
}

impl Representation for UnitDualQuaternion<f32> {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        Self::from_isometry(&Isometry3::from_motion(motion))
    }
    fn rows(&self) -> Rows {
        self.to_isometry().rows()
    }
}

impl Product for Isometry3<f32> {
    #[inline(always)]
    fn product(&self, first: &Self) -> Self {
        self * first
    }
}

impl Representation for Isometry3<f32> {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        // The motion is unit, and normalizing again would give nalgebra another input than the rest.
        let rotation =
            UnitQuaternion::new_unchecked(Quaternion::from(motion.rotation().to_array()));
        Self::from_parts(Translation3::from(motion.translation()), rotation)
    }
    fn rows(&self) -> Rows {
        let matrix = self.to_homogeneous();
        [0, 1, 2].map(|row| [0, 1, 2, 3].map(|column| f64::from(matrix[(row, column)])))
    }
}
