//! Mistakes that are easy to make have an answer that says so, or none at all to make.

use dq8::{
    DualQuat, Quat, Twist,
    representation::{Affine, RotationTranslation},
    scalar::MatrixError,
};

const TOLERANCE: f64 = 1e-9;

/// A few units of roundoff, of numbers up to 3.
const ROUNDING: f64 = 1e-15;

fn turned() -> DualQuat<f64> {
    let turn = Quat::from_axis_angle([0.36, 0.48, 0.8], 0.7);
    DualQuat::from_rotation_translation(turn, [1.0, -2.0, 3.0])
}

#[test]
fn every_default_moves_nothing() {
    assert_eq!(Quat::<f32>::default(), Quat::IDENTITY);
    assert_eq!(DualQuat::<f32>::default(), DualQuat::IDENTITY);
    assert_eq!(RotationTranslation::<f32>::default(), RotationTranslation::IDENTITY);
    assert_eq!(Affine::<f32>::default(), Affine::IDENTITY);
    assert_eq!(DualQuat::from_twist(Twist::<f32>::default()), DualQuat::IDENTITY);
}

#[test]
fn columns_of_glam_are_read_and_written_as_columns() {
    let motion = turned();
    let turn = glam::DQuat::from_array(motion.rotation().to_array());
    let theirs = glam::DMat4::from_rotation_translation(turn, motion.translation().into());
    let ours = motion.to_cols_array_2d();
    assert!(theirs.abs_diff_eq(glam::DMat4::from_cols_array_2d(&ours), ROUNDING));
    let back = DualQuat::try_from_cols_array_2d(theirs.to_cols_array_2d(), TOLERANCE);
    assert!(back.unwrap().abs_diff_eq(motion, ROUNDING));
    let rotation = glam::DMat3::from_quat(turn).to_cols_array_2d();
    let back = Quat::try_from_cols_array_2d(rotation, TOLERANCE).unwrap();
    assert!((back - motion.rotation()).norm() < ROUNDING);
    let columns = motion.rotation().to_cols_array_2d();
    assert!(
        columns
            .as_flattened()
            .iter()
            .zip(rotation.as_flattened())
            .all(|(a, b)| (a - b).abs() < ROUNDING)
    );
    assert_eq!(motion.to_rows_array_2d(), motion.to_matrix4());
    let rows = DualQuat::try_from_rows_array_2d(motion.to_matrix4(), TOLERANCE).unwrap();
    assert!(rows.abs_diff_eq(motion, ROUNDING));
}

#[test]
fn columns_given_as_rows_are_told_of_columns() {
    let error = DualQuat::try_from_matrix4(turned().to_cols_array_2d(), TOLERANCE).unwrap_err();
    let [value, ..] = turned().translation();
    assert_eq!(error, MatrixError::NotAffine { column: 0, value });
    assert!(error.to_string().contains("try_from_cols_array_2d"), "{error}");
}

#[test]
fn a_uniform_scale_is_reported_as_the_factor_and_points_to_affine() {
    for factor in [0.01, 100.0, -3.0, 1e-30, 1e30] {
        let scaled = (Affine::from_motion(turned()) * Affine::uniform_scale(factor)).to_matrix3x4();
        let error = DualQuat::try_from_matrix3x4(scaled, TOLERANCE).unwrap_err();
        let MatrixError::Scales { factor: found } = error else { panic!("{error}") };
        assert!((found / factor - 1.0).abs() < 4.0 * f64::EPSILON, "{found}");
        assert!(error.to_string().contains("Affine::try_decompose"), "{error}");
    }
    let thin = Affine::<f64>::scale([1.0, 2.0, 2.0]).to_matrix3x4();
    let error = DualQuat::try_from_matrix3x4(thin, TOLERANCE).unwrap_err();
    assert_eq!(error, MatrixError::NotOrthonormal { row: 1, column: 1, value: 4.0 });
}
