use super::{Element, Packed, Representation, Rows};
use dq8::DualQuat;
use nalgebra::{DualQuaternion, Isometry3, Matrix4, Point3, Quaternion, Translation3, Unit};
use nalgebra::{UnitDualQuaternion, UnitQuaternion};
use simba::simd::{SimdValue, WideF32x8};

impl Representation for UnitDualQuaternion<f32> {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        Self::from_isometry(&Isometry3::from_motion(motion))
    }
    fn rows(&self) -> Rows {
        self.to_isometry().rows()
    }
}

impl Representation for Isometry3<f32> {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        // The motion is unit, and normalizing again would give nalgebra another input than the
        // rest.
        let rotation =
            UnitQuaternion::new_unchecked(Quaternion::from(motion.rotation().to_array()));
        Self::from_parts(Translation3::from(motion.translation()), rotation)
    }
    fn rows(&self) -> Rows {
        let matrix = self.to_homogeneous();
        [0, 1, 2].map(|row| [0, 1, 2, 3].map(|column| f64::from(matrix[(row, column)])))
    }
}

const LANES: usize = 8;

/// A component of each.
fn row<T, const N: usize>(lanes: &[T], of: impl Fn(&T) -> [f32; N], component: usize) -> WideF32x8 {
    WideF32x8::from(std::array::from_fn::<_, LANES, _>(|lane| of(&lanes[lane])[component]))
}

impl Element for Isometry3<WideF32x8> {
    const LANES: usize = LANES;

    fn numbers(&self, lane: usize) -> Vec<f64> {
        let rotation = self.rotation.coords.map(|number| number.extract(lane));
        let rotation = UnitQuaternion::new_unchecked(Quaternion::from(rotation));
        let translation = self.translation.vector.map(|number| number.extract(lane));
        let motion = Isometry3::from_parts(Translation3::from(translation), rotation);
        super::flat(&motion.rows())
    }
}

impl Packed<DualQuat<f32>> for Isometry3<WideF32x8> {
    fn gather(lanes: &[DualQuat<f32>]) -> Self {
        let rotation = [0, 1, 2, 3].map(|c| row(lanes, |m| m.rotation().to_array(), c));
        let translation = [0, 1, 2].map(|c| row(lanes, |m| m.translation(), c));
        let rotation = UnitQuaternion::new_unchecked(Quaternion::from(rotation));
        Self::from_parts(Translation3::from(translation), rotation)
    }
}

impl Element for UnitDualQuaternion<WideF32x8> {
    const LANES: usize = LANES;

    fn numbers(&self, lane: usize) -> Vec<f64> {
        self.as_ref().numbers(lane)
    }
}

impl Packed<DualQuat<f32>> for UnitDualQuaternion<WideF32x8> {
    fn gather(lanes: &[DualQuat<f32>]) -> Self {
        Unit::new_unchecked(DualQuaternion::gather(lanes))
    }
}

impl Element for DualQuaternion<WideF32x8> {
    const LANES: usize = LANES;

    fn numbers(&self, lane: usize) -> Vec<f64> {
        let part = |part: &Quaternion<WideF32x8>| {
            Quaternion::from(part.coords.map(|number| number.extract(lane)))
        };
        DualQuaternion::from_real_and_dual(part(&self.real), part(&self.dual)).numbers(0)
    }
}

impl Packed<DualQuat<f32>> for DualQuaternion<WideF32x8> {
    fn gather(lanes: &[DualQuat<f32>]) -> Self {
        let [x, y, z, w, dx, dy, dz, dw] =
            [0, 1, 2, 3, 4, 5, 6, 7].map(|c| row(lanes, |m| m.to_array(), c));
        Self::from_real_and_dual([x, y, z, w].into(), [dx, dy, dz, dw].into())
    }
}

impl Element for Matrix4<f32> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        // nalgebra iterates by columns.
        self.fixed_rows::<3>(0).transpose().iter().map(|&number| number.into()).collect()
    }
}

/// For what is not unit; the same eight numbers as this crate's.
impl Element for DualQuaternion<f32> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        let [x, y, z, w] = self.real.coords.into();
        let [dx, dy, dz, dw] = self.dual.coords.into();
        DualQuat::from_array([x, y, z, w, dx, dy, dz, dw].map(f64::from)).numbers(0)
    }
}

impl Packed<DualQuat<f32>> for DualQuaternion<f32> {
    fn gather(lanes: &[DualQuat<f32>]) -> Self {
        let [real, dual] = [lanes[0].real(), lanes[0].dual()].map(|part| part.to_array());
        Self::from_real_and_dual(real.into(), dual.into())
    }
}

impl Element for Point3<f32> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        self.iter().copied().map(f64::from).collect()
    }
}

impl Packed<[f32; 3]> for Point3<f32> {
    fn gather(lanes: &[[f32; 3]]) -> Self {
        lanes[0].into()
    }
}

impl Element for Point3<WideF32x8> {
    const LANES: usize = LANES;

    fn numbers(&self, lane: usize) -> Vec<f64> {
        self.iter().map(|number| number.extract(lane).into()).collect()
    }
}

impl Packed<[f32; 3]> for Point3<WideF32x8> {
    fn gather(lanes: &[[f32; 3]]) -> Self {
        [0, 1, 2].map(|c| row(lanes, |point| *point, c)).into()
    }
}
