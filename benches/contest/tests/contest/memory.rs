//! How contenders keep motions.

use dq8::{Block, DualQuat};
use dq8_contest::memory::{Many, Packed, QuatVec3A};
use glam::Affine3A;
use simba::simd::WideF32x8;
use ultraviolet::{Isometry3x8, Mat4x8};

fn comes_back<E: Packed<DualQuat<f32>>>() {
    let different: Vec<_> =
        (0..32_u16).map(|i| DualQuat::from_translation([f32::from(i), 1.0, -2.0])).collect();
    let many = Many::new(2, different, 64);
    let packed = many.pack::<E>();
    assert_eq!(packed.len() * E::LANES, 128);
    for index in 0..128 {
        let x = (index % 32) as f64;
        let expected = [1., 0., 0., x, 0., 1., 0., 1., 0., 0., 1., -2.];
        assert_eq!(many.numbers(&packed, index), expected, "{index}");
    }
}

#[test]
fn every_layout_gives_back_what_it_was_given() {
    comes_back::<DualQuat<f32>>();
    comes_back::<Block<f32, 8>>();
    comes_back::<Block<f32, 16>>();
    comes_back::<Affine3A>();
    comes_back::<QuatVec3A>();
    comes_back::<Isometry3x8>();
    comes_back::<Mat4x8>();
    comes_back::<nalgebra::Isometry3<WideF32x8>>();
    comes_back::<nalgebra::UnitDualQuaternion<WideF32x8>>();
    comes_back::<nalgebra::DualQuaternion<f32>>();
}
