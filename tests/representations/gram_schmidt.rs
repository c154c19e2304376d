//! Ortho-normalization one axis after the other.

use super::{exact_rows, round_rows, worst};
use dq8::{
    Real,
    representation::{OrthonormalError, gram_schmidt},
};
use dq8_contract::bound::roundoff;
use dq8_contract::inputs::for_all;
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;

/// A length, a quotient and a product of numbers of about 1; and in `f32`.
const ROUNDING: f64 = 1e-15;
const IN_SINGLE: f64 = 3e-7;

pub(super) fn matrices() -> impl Strategy<Value = Matrix3<f64>> {
    prop::array::uniform9(-1.0..1.0_f64)
        .prop_map(|elements| Matrix3::from_row_slice(&elements))
        .prop_filter("mirrors are another matter", |matrix| matrix.determinant() > 1e-3)
}

/// The rotation of nalgebra's QR decomposition, by Householder's reflections, with the diagonal of
/// R made positive.
fn by_reflections(matrix: Matrix3<f64>) -> Matrix3<f64> {
    let (q, r) = matrix.qr().unpack();
    q * Matrix3::from_diagonal(&r.diagonal().map(f64::signum))
}

#[test]
fn the_rotation_is_that_of_the_qr_decomposition() {
    fn check<R: Real>(allowed: f64) {
        let why =
            "a column less its parts along the others, by the least stretch; nalgebra's own too";
        let rotations = worst("rotation by Gram–Schmidt", allowed, why);
        let right_angles = worst("angles of columns", 10.0, "a column is made right-angled twice");
        for_all(1000, &matrices(), |matrix| {
            let rows = round_rows::<R>(matrix);
            let got = exact_rows(gram_schmidt(rows).expect("it is a rotation's"));
            let condition = 1.0 / matrix.singular_values().min();
            let off = got - by_reflections(exact_rows(rows));
            rotations.see(off.amax(), roundoff::<R>() * condition, &matrix);
            let off = got.transpose() * got - Matrix3::identity();
            right_angles.see(off.amax(), roundoff::<R>(), &matrix);
        });
    }
    check::<f32>(4.0);
    check::<f64>(10.0);
}

#[test]
fn the_first_column_keeps_its_direction_and_the_second_its_plane() {
    for_all(100, &matrices(), |matrix| {
        let got = exact_rows(gram_schmidt(round_rows::<f64>(matrix)).expect("it is a rotation's"));
        assert!((got.column(0) * matrix.column(0).norm() - matrix.column(0)).amax() < ROUNDING);
        let normal: Vector3<f64> = matrix.column(0).cross(&matrix.column(1));
        assert!(got.column(1).dot(&normal).abs() < ROUNDING && got.determinant() > 0.0);
    });
}

#[test]
fn a_thin_wedge_still_gives_right_angles() {
    for thin in [1e-1_f32, 1e-3, 1e-6] {
        let rows = [[0.6, 0.6, 0.3], [0.64, 0.64 + thin, 0.2], [0.48, 0.48 - thin, -2.0]];
        let got = gram_schmidt(rows).map(exact_rows);
        let got = got.or_else(|_| gram_schmidt(rows.map(|[x, y, z]| [x, y, -z])).map(exact_rows));
        let got = got.expect("one of them does not mirror");
        assert!((got.transpose() * got - Matrix3::identity()).amax() < IN_SINGLE, "{thin}: {got}");
    }
}

#[test]
fn rotations_of_whole_numbers_stay_as_they_are() {
    let rows = [[0.0_f32, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    assert_eq!(gram_schmidt(rows), Ok(rows));
    for scale in [1e-45, 1e-20, 3e38] {
        assert_eq!(gram_schmidt(rows.map(|row| row.map(|c| c * scale))), Ok(rows), "times {scale}");
    }
}

#[test]
fn every_matrix_without_a_rotation_says_why() {
    let error = |rows: [[f64; 3]; 3]| gram_schmidt(rows).expect_err("it is bad");
    let flat = error([[1.0, 2.0, 0.0], [1.0, 2.0, 0.0], [1.0, 2.0, 1.0]]);
    assert!(matches!(flat, OrthonormalError::Dependent { column: 1, sine } if sine < ROUNDING));
    let flat = error([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]);
    assert!(matches!(flat, OrthonormalError::Dependent { column: 2, .. }));
    let none = error([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]);
    assert_eq!(none, OrthonormalError::Dependent { column: 0, sine: 0.0 });
    let mirror = error([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -2.0]]);
    assert_eq!(mirror, OrthonormalError::Mirrors { determinant: -1.0 });
    assert!(mirror.to_string().contains("-1"));
    let infinite = error([[1.0, 0.0, 0.0], [0.0, f64::INFINITY, 0.0], [0.0, 0.0, 1.0]]);
    let wanted = OrthonormalError::NotFinite { row: 1, column: 1, value: f64::INFINITY };
    assert_eq!(infinite, wanted);
    assert!(matches!(
        error([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [f64::NAN, 0.0, 1.0]]),
        OrthonormalError::NotFinite { row: 2, column: 0, .. }
    ));
}
