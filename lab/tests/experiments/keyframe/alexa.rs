//! s ⊙ A, A ⊕ B and keyframes with the exponential and the logarithm of matrices.

use super::{about_z, assert_differ, assert_same};
use crate::inputs::{assert_close, motion, twist};
use dq8::{Dual, DualQuat, Real, Twist};
use lab::keyframe::{add, interpolate, matrix, orthonormality_error, scale};
use lab::{LogarithmError, logarithm};
use nalgebra::{Matrix4, Vector3};
use proptest::prelude::*;

/// Twists whose turn stays well below half a turn.
fn moderate() -> impl Strategy<Value = Twist<f64>> {
    twist(1.5)
}

/// C(t) by dual quaternions: of rigid motions the sum of logarithms is a sum of twists.
fn by_twists<R: Real>(a: Twist<f64>, b: Twist<f64>, t: R) -> DualQuat<R> {
    let [a, b] = [a, b].map(|twist| Twist::from_array(twist.to_array().map(R::from_f64)));
    DualQuat::from_twist(a.scale(R::ONE - t) + b.scale(t))
}

proptest! {
    // Logarithms are slow without optimisation.
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn a_part_of_a_motion_is_the_power_of_its_screw(x in moderate(), s in -1.0..1.0) {
        let sigma = DualQuat::from_twist(x);
        let part = scale(s, &matrix(sigma)).unwrap();
        assert_same(&part, &matrix(sigma.pow(s)), 2e-14);
    }

    #[test]
    fn the_sum_of_motions_on_one_screw_is_their_product(a in -80.0..80.0, b in -80.0..80.0) {
        let [first, second] = [a, b].map(|degrees| matrix(about_z(degrees)));
        assert_same(&add(&first, &second).unwrap(), &(first * second), 5e-15);
    }

    #[test]
    fn sums_commute(x in moderate(), y in moderate()) {
        let [a, b] = [x, y].map(|x| matrix(DualQuat::from_twist(x)));
        assert_same(&add(&a, &b).unwrap(), &add(&b, &a).unwrap(), 0.0);
    }

    #[test]
    fn keyframes_of_rigid_motions_are_rigid_and_sums_of_twists(
        x in moderate(), y in moderate(), t in 0.0..1.0,
    ) {
        let [a, b] = [x, y].map(|x| matrix(DualQuat::from_twist(x)));
        let between = interpolate(&a, &b, t).unwrap();
        prop_assert!(orthonormality_error(&between) < 4e-14);
        prop_assert_eq!(between.row(3).transpose(), Matrix4::identity().row(3).transpose());
        assert_same(&between, &matrix(by_twists(x, y, t)), 4e-14);
        let apart = add(&scale(1.0 - t, &a).unwrap(), &scale(t, &b).unwrap()).unwrap();
        assert_same(&between, &apart, 1e-13);
        assert_same(&interpolate(&a, &b, 0.0).unwrap(), &a, 4e-14);
        assert_same(&interpolate(&a, &b, 1.0).unwrap(), &b, 4e-14);
    }

    /// Another choice of axes for everything, G A G⁻¹, does not change the way.
    #[test]
    fn keyframes_do_not_depend_on_the_axes_of_the_fixed_frame(
        x in moderate(), y in moderate(), g in motion(), t in 0.0..1.0,
    ) {
        let [a, b] = [x, y].map(|x| matrix(DualQuat::from_twist(x)));
        let (to, back) = (matrix(g), matrix(g.conjugate()));
        let seen = interpolate(&(to * a * back), &(to * b * back), t).unwrap();
        assert_same(&seen, &(to * interpolate(&a, &b, t).unwrap() * back), 1e-13);
    }

    /// Of affine maps too: the volume goes as det A^(1−t) det Bᵗ.
    #[test]
    fn volumes_between_keyframes_are_geometric_means(
        x in proptest::array::uniform12(-0.6..0.6), y in proptest::array::uniform12(-0.6..0.6),
        t in 0.0..1.0,
    ) {
        let affine = |x: [f64; 12]| {
            let mut log = Matrix4::zeros();
            log.rows_mut(0, 3).copy_from_slice(&x);
            log.exp()
        };
        let (a, b) = (affine(x), affine(y));
        let between = interpolate(&a, &b, t).unwrap();
        let volume = a.determinant().powf(1.0 - t) * b.determinant().powf(t);
        assert_close([between.determinant()], [volume], 3e-14 * volume);
    }
}

/// (1.2 about x, then along y) against a turn about z: two motions that do not commute.
fn crossed(size: f64) -> [Twist<f64>; 2] {
    let x = Twist { angular: [1.2, 0.0, 0.0], linear: [0.0, 0.5, 0.0] };
    let z = Twist { angular: [0.0, 0.0, 1.5], linear: [0.3, 0.0, 0.0] };
    [x.scale(size), z.scale(size)]
}

#[test]
fn the_sum_of_motions_on_two_screws_is_neither_product() {
    let [a, b] = crossed(1.0).map(|x| matrix(DualQuat::from_twist(x)));
    let sum = add(&a, &b).unwrap();
    assert_differ(&sum, &(a * b), 0.1);
    assert_differ(&sum, &(b * a), 0.1);
    assert_differ(&(a * b), &(b * a), 0.1);
}

#[test]
fn keyframes_on_one_screw_are_sclerp() {
    for (from, to) in [(0.0, 170.0), (20.0, 80.0), (-100.0, 60.0)] {
        let (a, b) = (about_z(from), about_z(to));
        for t in [0.25, 0.5, 0.9, 1.5] {
            let between = interpolate(&matrix(a), &matrix(b), t);
            // Beyond 180 degrees too: it is a logarithm that is multiplied, not a motion.
            assert_same(&between.unwrap(), &matrix(a.sclerp(b, t)), 1e-14);
        }
    }
}

#[test]
fn keyframes_from_the_identity_are_sclerp() {
    for twist in crossed(1.0) {
        let b = DualQuat::from_twist(twist);
        for t in [0.25, 0.5, 0.75] {
            let between = interpolate(&Matrix4::identity(), &matrix(b), t).unwrap();
            assert_same(&between, &matrix(DualQuat::IDENTITY.sclerp(b, t)), 1e-15);
        }
    }
}

/// The two agree to second order in the logarithms, so half the size leaves an eighth.
#[test]
fn keyframes_on_two_screws_differ_from_sclerp_in_third_order() {
    let apart = |size: f64| {
        let [x, y] = crossed(size);
        let [a, b] = [x, y].map(DualQuat::from_twist);
        let alexa = interpolate(&matrix(a), &matrix(b), 0.25).unwrap();
        (alexa - matrix(a.sclerp(b, 0.25))).amax()
    };
    assert!(apart(1.0) > 0.02, "{}", apart(1.0));
    for size in [0.1, 0.05, 0.025] {
        let ratio = apart(size) / apart(size / 2.0);
        assert!((ratio - 8.0).abs() < 0.2, "{size}: {ratio}");
    }
}

/// The same pair of keys with another pose for "no motion": ScLERP goes the same way, Alexa does
/// not.
#[test]
fn keyframes_depend_on_what_pose_counts_as_no_motion() {
    let [a, b] = crossed(1.0).map(DualQuat::from_twist);
    let other = DualQuat::from_twist(Twist { angular: [0.0, 0.9, 0.0], linear: [0.0; 3] });
    let t = 0.25;
    assert_same(&matrix((other * a).sclerp(other * b, t)), &matrix(other * a.sclerp(b, t)), 1e-15);
    let moved = interpolate(&matrix(other * a), &matrix(other * b), t).unwrap();
    let wanted = matrix(other) * interpolate(&matrix(a), &matrix(b), t).unwrap();
    assert_differ(&moved, &wanted, 0.01);
}

#[test]
fn the_speed_of_sclerp_is_constant_and_that_of_keyframes_on_two_screws_is_not() {
    let [x, y] = crossed(2.0);
    let [a, b] = [x, y].map(|x| {
        DualQuat::from_array(DualQuat::from_twist(x).to_array().map(|c| Dual::new(c, 0.0)))
    });
    let speed = |path: DualQuat<Dual<f64>>| {
        let at = DualQuat::from_array(path.to_array().map(|c| c.real));
        let rate = DualQuat::from_array(path.to_array().map(|c| c.dual));
        Vector3::from(at.body_twist(rate).angular).norm()
    };
    let times = || (0..=20).map(|step| Dual::new(0.02 + 0.048 * f64::from(step), 1.0));
    let span = |speeds: Vec<f64>| {
        let most = speeds.iter().copied().fold(0.0, f64::max);
        speeds.iter().copied().fold(f64::INFINITY, f64::min) / most
    };
    let sclerp = span(times().map(|t| speed(a.sclerp(b, t))).collect());
    let alexa = span(times().map(|t| speed(by_twists(x, y, t))).collect());
    assert!(1.0 - sclerp < 1e-15, "{sclerp}");
    assert!((0.5..0.98).contains(&alexa), "{alexa}");
}

/// 170° and 190°: ScLERP passes 180°, Alexa goes back the long way, through no turn at all.
#[test]
fn keys_on_both_sides_of_half_a_turn_go_the_long_way() {
    let (a, b) = (about_z(170.0), about_z(190.0));
    let middle = interpolate(&matrix(a), &matrix(b), 0.5).unwrap();
    let slide = Vector3::new(0.0, 0.0, 0.25 * core::f64::consts::PI);
    assert_same(&middle, &Matrix4::new_translation(&slide), 1e-14);
    assert_same(&matrix(a.sclerp(b, 0.5)), &matrix(about_z(180.0)), 1e-15);
    let half_turn = matrix(about_z(180.0));
    for pair in [(&half_turn, &matrix(b)), (&matrix(a), &half_turn)] {
        let error = interpolate(pair.0, pair.1, 0.5).unwrap_err();
        assert!(matches!(error, LogarithmError::Eigenvalue { .. }), "{error}");
        assert!(add(pair.0, pair.1).is_err());
    }
    assert!(scale(0.5, &half_turn).is_err());
}

/// What no dual quaternion can do: scale and shear, each in a geometric progression of its own.
#[test]
fn scales_and_shears_have_keyframes() {
    let a = Matrix4::new_nonuniform_scaling(&Vector3::new(2.0, 1.0, 9.0));
    let b = Matrix4::new_nonuniform_scaling(&Vector3::new(8.0, 1.0, 1.0));
    let wanted = Matrix4::new_nonuniform_scaling(&Vector3::new(4.0, 1.0, 3.0));
    assert_same(&interpolate(&a, &b, 0.5).unwrap(), &wanted, 1e-14);
    let mut shear = Matrix4::identity();
    shear[(0, 1)] = 3.0;
    let part = interpolate(&Matrix4::identity(), &shear, 0.25).unwrap();
    shear[(0, 1)] = 0.75;
    assert_same(&part, &shear, 1e-14);
    assert!(logarithm(&shear).is_ok());
    let mirror = Matrix4::new_nonuniform_scaling(&Vector3::new(1.0, -1.0, 1.0));
    assert!(interpolate(&Matrix4::identity(), &mirror, 0.5).is_err());
}
