//! [`Memory`]: places that tests can fill and read, without the kernels under test.

use dq8::{DualQuat, Place, Real};
use dq8_simd::{Block, Float, Row};

/// A layout that tests can fill and read.
pub(crate) trait Memory<const C: usize>: Place<C> + Clone {
    type Number: Real;
    /// As many elements as `records` need; lanes that are left repeat the first.
    fn pack(records: &[[Self::Number; C]]) -> Vec<Self>;
    /// The first `count` records.
    fn unpack(elements: &[Self], count: usize) -> Vec<[Self::Number; C]>;
}

impl<A: Row<Real: Real>, const C: usize> Memory<C> for Block<A, C> {
    type Number = A::Real;

    fn pack(records: &[[A::Real; C]]) -> Vec<Self> {
        let block = |chunk: &[[A::Real; C]]| {
            let mut block = Self::splat(chunk[0]);
            for (lane, &record) in chunk.iter().enumerate() {
                block.set(lane, record).expect("a lane");
            }
            block
        };
        records.chunks(A::LANES).map(block).collect()
    }
    fn unpack(elements: &[Self], count: usize) -> Vec<[A::Real; C]> {
        let record = |i: usize| elements[i / A::LANES].get(i % A::LANES).expect("a lane");
        (0..count).map(record).collect()
    }
}

/// Records of numbers without gaps.
macro_rules! plain {
    ($($real:ident $(= $any:ident)?, $record:ty, $components:literal;)*) => {$(
        impl$(<$any: Real + Float>)? Memory<$components> for $record {
            type Number = $real;

            fn pack(records: &[[$real; $components]]) -> Vec<Self> {
                bytemuck::cast_slice(records).to_vec()
            }
            fn unpack(elements: &[Self], count: usize) -> Vec<[$real; $components]> {
                bytemuck::cast_slice(&elements[..count]).to_vec()
            }
        }
    )*};
}
plain! {
    f32, f32, 1;
    f64, f64, 1;
    R = R, [R; 3], 3;
    R = R, DualQuat<R>, 8;
    R = R, [R; 12], 12;
    R = R, [[R; 4]; 3], 12;
    R = R, [R; 16], 16;
    R = R, [[R; 4]; 4], 16;
}
