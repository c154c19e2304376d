//! Palettes of matrices, and what they are taken apart into.

use super::scene::motion;
use dq8::skinning::{SkinningError, matrix_palette, split_palette};
use dq8::{DualQuat, hierarchy::MatrixOrder, representation::Affine};
use dq8_contract::random::Random;

/// Two products of matrices with elements of some units.
const ROUNDING: f64 = 1e-14;

#[test]
fn rows_and_columns_make_the_same_palette() {
    let mut random = Random(4);
    let motions: [DualQuat<f64>; 6] = core::array::from_fn(|_| motion(&mut random));
    let rows = motions.map(|motion| motion.to_matrix4());
    let columns = rows.map(|m| core::array::from_fn(|i| core::array::from_fn(|j| m[j][i])));
    let mut palettes = [[[[0.0; 4]; 3]; 3]; 2];
    let [a, b] = &mut palettes;
    matrix_palette(&rows[..3], &rows[3..], MatrixOrder::Rows, a).unwrap();
    matrix_palette(&columns[..3], &columns[3..], MatrixOrder::Columns, b).unwrap();
    assert_eq!(palettes[0], palettes[1]);
    for joint in 0..3 {
        let wanted = (motions[joint] * motions[joint + 3]).to_matrix3x4();
        for (a, b) in palettes[0][joint].as_flattened().iter().zip(wanted.as_flattened()) {
            assert!((a - b).abs() < ROUNDING);
        }
    }
    let mut palette = [[[9.0; 4]; 3]; 3];
    let error = matrix_palette(&columns[..3], &rows[3..], MatrixOrder::Rows, &mut palette);
    assert!(matches!(error, Err(SkinningError::NotAffine { joint: 0, .. })), "{error:?}");
    let mut broken = rows;
    broken[2][1][3] = f64::INFINITY;
    let error = matrix_palette(&broken[..3], &rows[3..], MatrixOrder::Rows, &mut palette);
    assert_eq!(error, Err(SkinningError::NotFinite { joint: 2, value: f64::INFINITY }));
    assert_eq!(palette, [[[9.0; 4]; 3]; 3]);
}

#[test]
fn what_is_taken_apart_is_the_matrix_together_again() {
    let mut random = Random(6);
    let rigid = Affine::from_motion(motion::<f64>(&mut random));
    let maps = [
        rigid,
        rigid * Affine::uniform_scale(2.0),
        rigid * Affine::scale([1.0, 3.0, 0.5]),
        rigid * Affine::shear([0.5, 0.0, 0.0], [0.0, 1.0, 0.0]),
        rigid * Affine::scale([1.0, -1.0, 1.0]),
        rigid * Affine::scale([0.0, 0.0, 2.0]),
        rigid * Affine::scale([0.0; 3]),
    ];
    let matrices = maps.map(Affine::to_matrix3x4);
    let mut motions = [DualQuat::IDENTITY; 7];
    let mut stretches = [[[9.0; 4]; 3]; 7];
    let split = split_palette(&matrices, &mut motions, &mut stretches).unwrap();
    assert_eq!((split.mirroring, split.squeezing), (1, 2));
    for joint in 0..7 {
        assert!(motions[joint].is_normalized(), "{joint}");
        let together =
            Affine::from_motion(motions[joint]) * Affine::from_matrix3x4(stretches[joint]);
        for (a, b) in
            together.to_matrix3x4().as_flattened().iter().zip(matrices[joint].as_flattened())
        {
            assert!((a - b).abs() < ROUNDING, "{joint}");
        }
    }
    let split = split_palette(&matrices[..1], &mut motions[..1], &mut stretches[..1]).unwrap();
    assert!(split.is_rigid(ROUNDING), "{split:?}");
    let split = split_palette(&matrices[..2], &mut motions[..2], &mut stretches[..2]).unwrap();
    assert!(split.joint == 1 && (split.stretch - 1.0).abs() < ROUNDING, "{split:?}");
}

/// A product of maps mirrors if an odd number of its factors does; here those that scale one axis
/// by less than nothing.
#[test]
fn what_mirrors_is_counted_however_it_lies() {
    let mut random = Random(7);
    let (mut matrices, mut mirroring) = (Vec::new(), 0);
    for _ in 0..200 {
        let mut map = Affine::from_motion(motion::<f64>(&mut random));
        let mut sign = 1.0;
        for _ in 0..2 {
            let scale = core::array::from_fn(|_| 1.25 + random.signed());
            let side = if random.signed() < 0.0 { -1.0 } else { 1.0 };
            sign *= side;
            map = map * Affine::scale(scale) * Affine::scale([1.0, side, 1.0]);
            map = map * Affine::from_motion(motion(&mut random));
        }
        matrices.push(map.to_matrix3x4());
        mirroring += usize::from(sign < 0.0);
    }
    let mut motions = vec![DualQuat::IDENTITY; matrices.len()];
    let mut stretches = vec![[[0.0; 4]; 3]; matrices.len()];
    let split = split_palette(&matrices, &mut motions, &mut stretches).unwrap();
    assert_eq!((split.mirroring, split.squeezing), (mirroring, 0));
}

#[test]
fn a_product_that_overflows_is_refused() {
    let mut large = DualQuat::<f32>::IDENTITY.to_matrix4();
    large[0][0] = f32::MAX;
    let mut palette = [[[7.0; 4]; 3]];
    let error = matrix_palette(&[large], &[large], MatrixOrder::Rows, &mut palette);
    assert_eq!(error, Err(SkinningError::NotFinite { joint: 0, value: f64::INFINITY }));
    assert_eq!(palette, [[[7.0; 4]; 3]]);
}
