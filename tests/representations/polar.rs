//! The nearest rotation, and the stretch before it.

use super::gram_schmidt::matrices;
use super::{between, exact_rows, for_random_motions, opinion, round_rows, worst};
use dq8::{
    DualQuat, Quat, Real,
    representation::{OrthonormalError, Polar, gram_schmidt},
};
use dq8_contract::bound::roundoff;
use dq8_contract::inputs::{for_all, unit_motion};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

/// Some products of elements of about 1.
const ROUNDING: f64 = 2e-15;
/// Two decompositions of matrices as thin as a tenth, each rounded by itself.
const TWICE: f64 = 2e-14;

fn polar<R: Real>(matrix: Matrix3<f64>) -> Polar<R> {
    Polar::try_from_matrix3(round_rows(matrix)).expect("its nearest rotation is the only one")
}

fn rotation<R: Real>(matrix: Matrix3<f64>) -> Matrix3<f64> {
    opinion(polar::<R>(matrix).rotation).to_rotation_matrix().into_inner()
}

#[test]
fn the_rotation_is_that_of_the_singular_value_decomposition() {
    fn check<R: Real>() {
        let rotations = worst(
            "nearest rotation",
            16.0,
            "an iteration's last step, of nine elements; relative to how far rounding turns it",
        );
        let products = worst("R S", 20.0, "sums of three products with the error of R");
        for_all(1000, &matrices(), |matrix| {
            let matrix = exact_rows(round_rows::<R>(matrix));
            let svd = matrix.svd(true, true);
            let by_svd = svd.u.expect("asked for") * svd.v_t.expect("asked for");
            let Polar { rotation, stretch, mirrors } = polar::<R>(matrix);
            let turned = opinion(rotation).to_rotation_matrix().into_inner();
            let mut singular = svd.singular_values;
            singular.as_mut_slice().sort_by(f64::total_cmp);
            let condition = singular[2] / (singular[0] + singular[1]);
            rotations.see((turned - by_svd).amax(), roundoff::<R>() * condition, &matrix);
            let stretch = exact_rows(stretch);
            products.see((turned * stretch - matrix).amax(), roundoff::<R>(), &matrix);
            assert!(!mirrors && stretch == stretch.transpose());
            assert!(stretch.symmetric_eigenvalues().min() > 0.0, "{stretch}");
        });
    }
    check::<f32>();
    check::<f64>();
}

/// Neighbours all around, the rotation by Gram–Schmidt, and rotations far away.
#[test]
fn no_other_rotation_is_nearer_and_that_of_gram_schmidt_is_not_as_near() {
    for_all(100, &matrices(), |matrix| {
        let nearest = rotation::<f64>(matrix);
        let distance = |other: Matrix3<f64>| (other - matrix).norm();
        let ours = distance(nearest);
        for axis in [Vector3::x(), Vector3::y(), Vector3::z(), Vector3::new(1.0, -2.0, 0.5)] {
            for angle in [1e-6, -1e-6, 1e-2, -1e-2, 0.5, -0.5, 3.0] {
                let turn = UnitQuaternion::from_scaled_axis(axis * angle).to_rotation_matrix();
                assert!(distance(nearest * turn) > ours - 1e-15, "{axis:?} {angle} {matrix}");
            }
        }
        let by_columns =
            gram_schmidt(round_rows::<f64>(matrix)).map(exact_rows).expect("no mirror");
        assert!(distance(by_columns) > ours + 1e-6, "{matrix}");
    });
}

#[test]
fn the_order_of_axes_changes_the_rotation_of_gram_schmidt_and_not_the_nearest() {
    let cycle = Matrix3::new(0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0);
    for_all(100, &matrices(), |matrix| {
        let relabelled = cycle.transpose() * matrix * cycle;
        let there_and_back = cycle * rotation::<f64>(relabelled) * cycle.transpose();
        let condition = 1.0 / matrix.singular_values().min();
        let off = (there_and_back - rotation::<f64>(matrix)).amax();
        assert!(off < ROUNDING * condition, "{off:e} {matrix}");
        let columns =
            |matrix| gram_schmidt(round_rows::<f64>(matrix)).map(exact_rows).expect("no mirror");
        let there_and_back = cycle * columns(relabelled) * cycle.transpose();
        assert!((there_and_back - columns(matrix)).amax() > 1e-3, "{matrix}");
    });
}

/// Thin in two directions, where an inverse has lost all digits in f32.
#[test]
fn rounding_moves_the_rotation_no_more_than_the_elements_rounding_does() {
    fn check<R: Real>(smallest: i32) {
        let why =
            "the elements are rounded, and an iteration's last step is; by the two least stretches";
        let worst = worst("rotation of a thin matrix", 24.0, why);
        for_all(250, &unit_motion(), |motion| {
            let turn = opinion(DualQuat::from_array(motion).rotation());
            let tilt = UnitQuaternion::from_euler_angles(0.3, -0.8, 1.9).to_rotation_matrix();
            for decade in 0..=smallest {
                let thin = 10_f64.powi(-decade);
                for stretch in [[1.0, 1.0, thin], [1.0, thin, thin], [1.0, thin, 0.3 * thin]] {
                    let along = Matrix3::from_diagonal(&Vector3::from(stretch));
                    let stretch_matrix = tilt * along * tilt.transpose();
                    let matrix = turn.to_rotation_matrix() * stretch_matrix;
                    let got = polar::<R>(matrix);
                    let off = between(opinion(got.rotation), turn);
                    worst.see(off, roundoff::<R>() / (stretch[1] + stretch[2]), &(matrix, decade));
                }
            }
        });
    }
    check::<f32>(4);
    check::<f64>(13);
}

#[test]
fn a_mirror_is_told_and_its_stretch_mirrors_in_the_origin() {
    for_all(100, &matrices(), |matrix| {
        let upright = polar::<f64>(matrix);
        let mirrored = polar::<f64>(-matrix);
        assert!(mirrored.mirrors && !upright.mirrors);
        assert!((mirrored.rotation - upright.rotation).norm() < TWICE, "{matrix}");
        assert!((exact_rows(mirrored.stretch) + exact_rows(upright.stretch)).amax() < TWICE);
    });
    let floor = polar::<f64>(Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -1.0)));
    assert_eq!((floor.rotation, floor.mirrors), (Quat::from_xyzw(0.0, 0.0, 1.0, 0.0), true));
}

#[test]
fn a_flat_matrix_has_a_nearest_rotation_and_does_not_mirror() {
    for_random_motions(|motion| {
        let turn = opinion(motion.rotation());
        let flat = turn.to_rotation_matrix() * Matrix3::from_diagonal(&Vector3::new(2.0, 0.0, 1.0));
        let got = polar::<f64>(flat);
        let off = between(opinion(got.rotation), turn);
        assert!(!got.mirrors && off < TWICE, "{off:e} {got:?}");
    });
}

#[test]
fn whole_turns_of_the_axes_are_exact_whatever_the_scale() {
    for scale in [1.0_f32, 1e-45, 1e-20, 1e30, 1e38] {
        let identity = polar::<f32>(Matrix3::identity() * f64::from(scale));
        assert_eq!(identity.rotation, Quat::IDENTITY);
        assert_eq!(identity.stretch, [[scale, 0.0, 0.0], [0.0, scale, 0.0], [0.0, 0.0, scale]]);
        let half = Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, -1.0)) * f64::from(scale);
        assert_eq!(polar::<f32>(half).rotation, Quat::from_xyzw(0.0, 1.0, 0.0, 0.0));
    }
}

#[test]
fn every_matrix_without_a_nearest_rotation_says_why() {
    let error = |rows: [[f64; 3]; 3]| Polar::try_from_matrix3(rows).expect_err("it is bad");
    assert_eq!(error([[0.0; 3]; 3]), OrthonormalError::Ambiguous { gap: 0.0 });
    let line = error([[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [-1.0, -2.0, -3.0]]);
    assert!(
        matches!(line, OrthonormalError::Ambiguous { gap } if gap.abs() < 0.5 * ROUNDING),
        "{line}"
    );
    assert!(line.to_string().contains("no nearest rotation"));
    for bad in [f64::NAN, f64::INFINITY] {
        let infinite = error([[1.0, 0.0, 0.0], [0.0, 1.0, bad], [0.0, 0.0, 1.0]]);
        assert!(matches!(infinite, OrthonormalError::NotFinite { row: 1, column: 2, .. }));
    }
}

/// Near the top of the range sums overflow on the way; the answer is finite or an error.
#[test]
fn the_stretch_of_the_largest_matrices_is_finite_or_refused() {
    // One that overflowed on the way.
    let rows = [
        [6.316_404e-8, -f32::MAX, 2.148_485_7],
        [-1.187_991_6e-18, 2.131_663_3, 0.159_077_27],
        [5.755_230_3e34, -0.205_956_25, 3.867_092_3e18],
    ];
    let mut random = dq8_contract::random::Random(3);
    let largest = (0..2000).map(|_| {
        core::array::from_fn(|_| core::array::from_fn(|_| random.signed() as f32 * f32::MAX))
    });
    let (mut finite, mut refused) = (0, 0);
    for rows in largest.chain([rows]) {
        match Polar::try_from_matrix3(rows) {
            Ok(polar) => {
                assert!(polar.stretch.iter().flatten().all(|c| c.is_finite()), "{rows:?}");
                assert!(polar.rotation.to_array().iter().all(|c| c.is_finite()), "{rows:?}");
                finite += 1;
            }
            Err(OrthonormalError::NotFinite { value, .. }) => {
                assert!(value.is_infinite(), "{rows:?}");
                refused += 1;
            }
            Err(OrthonormalError::Ambiguous { .. }) => {}
            Err(other) => panic!("{other} of {rows:?}"),
        }
    }
    assert!(finite > 100 && refused > 100, "{finite} finite, {refused} refused");
}

/// A matrix that squeezes space onto a line is one column times one row, and rounding leaves a
/// little more.
fn squeezed<R: Real>() {
    for i in 0..100 {
        let at = |k: f64| (f64::from(i) + 1.0) * k;
        let (column, row_of) = ([at(1.1), at(1.7), at(2.3)], [at(0.7), at(2.9), at(3.7)]);
        let rows = column.map(|a| row_of.map(|b| R::from_f64(a.sin() * b.cos())));
        assert!(Polar::try_from_matrix3(rows).is_err(), "{rows:?}");
    }
}

#[test]
fn a_matrix_that_squeezes_space_onto_a_line_has_no_polar_decomposition() {
    squeezed::<f32>();
    squeezed::<f64>();
}
