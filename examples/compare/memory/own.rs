use super::{Packed, flat};
use crate::representation::{Product, Representation};
use crate::rows::Rows3x4;
use dq8::{Block, DualQuat, Quat};
use dq8_simd::Row;

/// A reference as the numbers that contenders are compared with.
pub(crate) trait Numbers {
    fn numbers(&self) -> Vec<f64>;
}

impl Numbers for DualQuat<f64> {
    fn numbers(&self) -> Vec<f64> {
        flat(&self.to_matrix3x4())
    }
}

impl Numbers for Rows3x4<f64> {
    fn numbers(&self) -> Vec<f64> {
        flat(&self.rows())
    }
}

impl Product for DualQuat<f32> {
    #[inline(always)]
    fn product(&self, first: &Self) -> Self {
        *self * *first
    }
}

impl Packed<DualQuat<f32>> for DualQuat<f32> {
    const LANES: usize = 1;

    fn gather(lanes: &[DualQuat<f32>]) -> Self {
        lanes[0]
    }
    fn numbers(&self, _: usize) -> Vec<f64> {
        double(*self).numbers()
    }
}

impl<const N: usize> Packed<DualQuat<f32>> for Block<f32, N>
where
    [f32; N]: Row<Real = f32>,
{
    const LANES: usize = N;

    fn gather(lanes: &[DualQuat<f32>]) -> Self {
        let mut block = [Self::splat([0.0; 8])];
        dq8::pack(1, lanes, &mut block).expect("as many motions as lanes");
        block[0]
    }
    fn numbers(&self, lane: usize) -> Vec<f64> {
        let motion = self.get(lane).expect("lanes of the block");
        double(DualQuat::from_array(motion)).numbers()
    }
}

impl Packed<[f32; 4]> for Quat<f32> {
    const LANES: usize = 1;

    fn gather(lanes: &[[f32; 4]]) -> Self {
        Self::from_array(lanes[0])
    }
    fn numbers(&self, _: usize) -> Vec<f64> {
        self.to_array().map(f64::from).to_vec()
    }
}

/// Points, rotations: whatever has no type of its own.
impl<const N: usize, const C: usize> Packed<[f32; C]> for dq8_simd::Block<[f32; N], C>
where
    [f32; N]: Row<Real = f32>,
{
    const LANES: usize = N;

    fn gather(lanes: &[[f32; C]]) -> Self {
        let mut block = Self::splat([0.0; C]);
        for (lane, record) in lanes.iter().enumerate() {
            block.set(lane, *record).expect("as many records as lanes");
        }
        block
    }
    fn numbers(&self, lane: usize) -> Vec<f64> {
        self.get(lane).expect("lanes of the block").map(f64::from).to_vec()
    }
}

pub(crate) fn double(motion: DualQuat<f32>) -> DualQuat<f64> {
    DualQuat::from_array(motion.to_array().map(f64::from))
}
