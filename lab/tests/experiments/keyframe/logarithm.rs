//! The principal logarithm against nalgebra's exponential, its eigenvectors, and dq8's screws.

use super::{about_z, assert_same, of_twist};
use crate::inputs::{motion, reals};
use dq8::{DualQuat, Quat};
use lab::keyframe::matrix;
use lab::{LogarithmError, logarithm};
use nalgebra::{Matrix4, Vector3};
use proptest::prelude::*;

fn any_matrix(limit: f64) -> impl Strategy<Value = Matrix4<f64>> {
    reals::<16>(limit).prop_map(|elements| Matrix4::from_row_slice(&elements))
}

proptest! {
    // Logarithms are slow without optimisation.
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Norms below π keep the eigenvalues of X in the strip of the principal logarithm.
    #[test]
    fn the_logarithm_undoes_the_exponential(x in any_matrix(0.75)) {
        assert_same(&logarithm(&x.exp()).unwrap(), &x, 4e-14);
    }

    #[test]
    fn the_exponential_undoes_the_logarithm(x in any_matrix(1.5)) {
        let a = x.exp();
        match logarithm(&a) {
            Ok(log) => assert_same(&log.exp(), &a, 1e-12 * a.amax().max(1.0)),
            Err(error) => prop_assert!(false, "{error}"),
        }
    }

    /// Where eigenvectors are orthogonal the logarithm is that of the eigenvalues.
    #[test]
    fn the_logarithm_of_a_symmetric_matrix_is_that_of_its_eigenvalues(x in any_matrix(1.0)) {
        let a = x * x.transpose() + Matrix4::identity() * 0.1;
        let mut eigen = a.symmetric_eigen();
        eigen.eigenvalues.apply(|e| *e = e.ln());
        assert_same(&logarithm(&a).unwrap(), &eigen.recompose(), 1e-13);
    }

    #[test]
    fn the_logarithm_of_a_motion_is_its_twist(sigma in motion()) {
        let twist = sigma.to_twist();
        let [x, y, z] = twist.angular;
        let from_half_turn = core::f64::consts::PI - (x * x + y * y + z * z).sqrt();
        prop_assume!(from_half_turn > 1e-3);
        let log = logarithm(&matrix(sigma)).unwrap();
        assert_same(&log, &of_twist(twist), 4e-14 / from_half_turn.min(1.0));
    }
}

#[test]
fn the_logarithm_ends_at_half_a_turn_and_loses_digits_before() {
    for digits in 1..=7 {
        let before = 10_f64.powi(-digits);
        let sigma = about_z(180.0 - before);
        let log = logarithm(&matrix(sigma)).unwrap();
        assert_same(&log, &of_twist(sigma.to_twist()), 1e-14 / before);
    }
    let error = logarithm(&matrix(about_z(180.0))).unwrap_err();
    let LogarithmError::Eigenvalue { real, imaginary } = error else { panic!("{error}") };
    assert!((real + 1.0).abs() < 1e-15 && imaginary.abs() < 1e-15, "{error}");
    assert!(error.to_string().starts_with("no principal logarithm: the eigenvalue -"));
}

#[test]
fn translations_and_the_identity_have_exact_logarithms() {
    let zero = Matrix4::zeros();
    assert_eq!(logarithm(&Matrix4::identity()), Ok(zero));
    for size in [1e-300, 1e-12, 1.0, 1e6, 1e300] {
        let shift = Matrix4::new_translation(&Vector3::new(size, -2.0 * size, 0.0));
        assert_same(&logarithm(&shift).unwrap(), &(shift - Matrix4::identity()), 1e-15 * size);
    }
    // Small turns keep their digits but for those that cos θ − 1 has lost.
    let small = about_z(1e-9);
    assert_same(&logarithm(&matrix(small)).unwrap(), &of_twist(small.to_twist()), 4e-22);
}

/// A body a long way from the origin: the digits are those of the distance.
#[test]
fn motions_far_away_have_logarithms() {
    for distance in [1e3, 1e6, 1e10] {
        let turn = about_z(100.0).rotation();
        let far = DualQuat::from_rotation_translation(turn, [distance, -distance, 0.5]);
        let log = logarithm(&matrix(far)).unwrap();
        assert_same(&log, &of_twist(far.to_twist()), 4e-15 * distance);
    }
}

#[test]
fn very_large_and_very_small_scales_have_logarithms() {
    for exponent in [-300, -100, 100, 300] {
        let size = 10_f64.powi(exponent);
        let scale = Matrix4::from_diagonal(&[size, 2.0 * size, 1.0, 1.0].into());
        let wanted = Matrix4::from_diagonal(&[size.ln(), (2.0 * size).ln(), 0.0, 0.0].into());
        assert_same(&logarithm(&scale).unwrap(), &wanted, 1e-12);
    }
}

/// Rounding moves the eigenvalues of most half turns off the axis.
#[test]
fn half_turns_about_any_axis_have_no_logarithm() {
    for number in 1..=200 {
        let [x, y, z] = [2.0_f64, 3.0, 5.0].map(|p| (f64::from(number) * p.sqrt()).fract() - 0.5);
        let axis = Quat::from_xyzw(x, y, z, 0.0).normalize();
        let sigma = DualQuat::from_rotation_translation(axis, [x, -y, z]);
        let error = logarithm(&matrix(sigma)).unwrap_err();
        let LogarithmError::Eigenvalue { real, .. } = error else { panic!("{number}: {error}") };
        assert!((real + 1.0).abs() < 1e-14, "{number}: {error}");
    }
}

#[test]
fn mirrors_and_singular_matrices_have_no_logarithm() {
    let mirror = Matrix4::from_diagonal(&[1.0, -2.0, 1.0, 1.0].into());
    let wanted = LogarithmError::Eigenvalue { real: -2.0, imaginary: 0.0 };
    assert_eq!(logarithm(&mirror), Err(wanted));
    let flat = Matrix4::from_diagonal(&[1.0, 0.0, 1.0, 1.0].into());
    let wanted = LogarithmError::Eigenvalue { real: 0.0, imaginary: 0.0 };
    assert_eq!(logarithm(&flat), Err(wanted));
    assert!(logarithm(&Matrix4::zeros()).is_err());
}

#[test]
fn an_element_that_is_not_finite_is_named() {
    for value in [f64::NAN, f64::INFINITY] {
        let mut a = Matrix4::identity();
        a[(1, 3)] = value;
        let error = logarithm(&a).unwrap_err();
        assert_eq!(
            error.to_string(),
            format!("no principal logarithm: the element in row 1, column 3 is {value}")
        );
    }
}
