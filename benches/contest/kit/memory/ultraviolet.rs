use super::{Element, Packed};
use dq8::DualQuat;
use ultraviolet::{Isometry3x8, Mat4x8, Rotor3x8, Vec3x8, f32x8};

const LANES: usize = 8;

fn vector(lanes: &[[f32; 3]]) -> Vec3x8 {
    Vec3x8::from([0, 1, 2].map(|c| f32x8::new(std::array::from_fn(|lane| lanes[lane][c]))))
}

impl Element for Isometry3x8 {
    const LANES: usize = LANES;

    fn numbers(&self, lane: usize) -> Vec<f64> {
        self.into_homogeneous_matrix().numbers(lane)
    }
}

impl Packed<DualQuat<f32>> for Isometry3x8 {
    fn gather(lanes: &[DualQuat<f32>]) -> Self {
        let rotation = [0, 1, 2, 3]
            .map(|c| f32x8::new(std::array::from_fn(|lane| lanes[lane].rotation().to_array()[c])));
        let translations: Vec<_> = lanes.iter().map(|motion| motion.translation()).collect();
        Self::new(vector(&translations), Rotor3x8::from_quaternion_array(rotation))
    }
}

impl Element for Mat4x8 {
    const LANES: usize = LANES;

    fn numbers(&self, lane: usize) -> Vec<f64> {
        let columns = self.cols.map(|column| [column.x, column.y, column.z]);
        let number = |row: usize, column: usize| columns[column][row].to_array()[lane].into();
        (0..3).flat_map(|row| (0..4).map(move |column| number(row, column))).collect()
    }
}

impl Packed<DualQuat<f32>> for Mat4x8 {
    fn gather(lanes: &[DualQuat<f32>]) -> Self {
        Isometry3x8::gather(lanes).into_homogeneous_matrix()
    }
}

impl Element for Vec3x8 {
    const LANES: usize = LANES;

    fn numbers(&self, lane: usize) -> Vec<f64> {
        [self.x, self.y, self.z].map(|number| number.to_array()[lane].into()).to_vec()
    }
}

impl Packed<[f32; 3]> for Vec3x8 {
    fn gather(lanes: &[[f32; 3]]) -> Self {
        vector(lanes)
    }
}
