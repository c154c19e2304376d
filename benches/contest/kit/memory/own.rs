//! dq8's own. Everything that knows how it lays motions out in memory is here.

use super::{Element, Packed, Representation, Rows, flat};
use dq8::simd::Row;
use dq8::storage::{self, Layout};
use dq8::{Block, DualQuat, Lanes, Quat, geometry::DualVector, simd::Portable};
use dq8::{
    batch,
    simd::{f32x8, f32x16},
};

/// Motions as dq8's kernels take them: one after the other, or in blocks.
pub trait Own: storage::Element<8, Layout: Layout<Real = f32>> + Packed<DualQuat<f32>> {
    /// Points that lie in the same way.
    type Point: storage::Element<3, Layout = Self::Layout> + Packed<[f32; 3]>;
    /// Rotations that lie in the same way.
    type Rotation: storage::Element<4, Layout = Self::Layout> + Packed<[f32; 4]>;

    /// A chain, with a segment in each lane.
    fn links(chain: &[DualQuat<f32>]) -> Vec<Self>;
    /// Where a link of a chain is among `elements`, and in which lane.
    fn link(elements: usize, index: usize) -> (usize, usize) {
        (index % elements, index / elements)
    }
}

impl Own for DualQuat<f32> {
    type Point = [f32; 3];
    type Rotation = Quat<f32>;

    fn links(chain: &[Self]) -> Vec<Self> {
        chain.to_vec()
    }
}

impl<const N: usize> Own for Block<f32, N>
where
    [f32; N]: Row<Real = f32>,
{
    type Point = Block<f32, N, 3>;
    type Rotation = storage::Block<f32, N, 4>;

    fn links(chain: &[DualQuat<f32>]) -> Vec<Self> {
        let mut blocks = vec![Self::splat([0.0; 8]); chain.len().div_ceil(N)];
        storage::pack_chain(chain, &mut blocks).expect("as many blocks as the links fill");
        blocks
    }
}

impl Representation for DualQuat<f32> {
    fn from_motion(motion: &Self) -> Self {
        *motion
    }
    fn rows(&self) -> Rows {
        self.cast::<f64>().to_matrix3x4()
    }
}

impl Element for DualQuat<f64> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        flat(&self.to_matrix3x4())
    }
}

/// Motions, points, rotations in blocks.
impl<const N: usize, const C: usize> Element for dq8::simd::Block<[f32; N], C>
where
    [f32; N]: Row<Real = f32>,
{
    const LANES: usize = N;

    fn numbers(&self, lane: usize) -> Vec<f64> {
        let record = self.get(lane).expect("lanes of the block").map(f64::from).to_vec();
        match <[f64; 8]>::try_from(record) {
            Ok(motion) => DualQuat::from_array(motion).numbers(0),
            Err(record) => record,
        }
    }
}

impl<const N: usize> Packed<DualQuat<f32>> for Block<f32, N>
where
    [f32; N]: Row<Real = f32>,
{
    fn gather(lanes: &[DualQuat<f32>]) -> Self {
        let lanes: Vec<_> = lanes.iter().map(|motion| motion.to_array()).collect();
        Packed::gather(&lanes)
    }
}

impl<const N: usize, const C: usize> Packed<[f32; C]> for dq8::simd::Block<[f32; N], C>
where
    [f32; N]: Row<Real = f32>,
{
    fn gather(lanes: &[[f32; C]]) -> Self {
        let mut block = Self::splat([0.0; C]);
        for (lane, record) in lanes.iter().enumerate() {
            block.set(lane, *record).expect("as many records as lanes");
        }
        block
    }
}

impl Element for Quat<f32> {
    fn numbers(&self, _: usize) -> Vec<f64> {
        self.to_array().numbers(0)
    }
}

impl Packed<[f32; 4]> for Quat<f32> {
    fn gather(lanes: &[[f32; 4]]) -> Self {
        Self::from_array(lanes[0])
    }
}

impl Packed<Self> for [f32; 3] {
    fn gather(lanes: &[Self]) -> Self {
        lanes[0]
    }
}

/// A number, or one per lane.
pub trait Number: Copy + 'static {
    const LANES: usize = 1;

    fn lane(self, lane: usize) -> f64;
}

impl Number for f32 {
    fn lane(self, _: usize) -> f64 {
        self.into()
    }
}

impl Number for f64 {
    fn lane(self, _: usize) -> f64 {
        self
    }
}

impl Number for f32x8 {
    const LANES: usize = 8;

    fn lane(self, lane: usize) -> f64 {
        self.to_array()[lane].into()
    }
}

impl Number for f32x16 {
    const LANES: usize = 16;

    fn lane(self, lane: usize) -> f64 {
        self.to_array()[lane].into()
    }
}

impl<T: Number, const C: usize> Element for [T; C] {
    const LANES: usize = T::LANES;

    fn numbers(&self, lane: usize) -> Vec<f64> {
        self.iter().map(|number| number.lane(lane)).collect()
    }
}

impl<T: Number> Element for DualVector<T> {
    const LANES: usize = T::LANES;

    fn numbers(&self, lane: usize) -> Vec<f64> {
        [self.real.numbers(lane), self.dual.numbers(lane)].concat()
    }
}

impl<L: Number + Lanes<Real = f32, Level = Portable>> Element for batch::DualQuat<L> {
    const LANES: usize = <L as Number>::LANES;

    fn numbers(&self, lane: usize) -> Vec<f64> {
        DualQuat::from_array(self.to_array().map(|number| number.lane(lane))).numbers(0)
    }
}

impl<L: Number + Lanes<Real = f32, Level = Portable>> Packed<DualQuat<f32>> for batch::DualQuat<L> {
    fn gather(lanes: &[DualQuat<f32>]) -> Self {
        let row = |c: usize| lanes.iter().map(|motion| motion.to_array()[c]).collect::<Vec<_>>();
        Self::from_array(std::array::from_fn(|c| L::load_partial(Portable, &row(c), 0.0)))
    }
}
