//! What matrices hold and dual quaternions cannot.

use super::{between, exact_rows, for_random_motions, opinion};
use dq8::{
    DualQuat, Plane, Quat,
    representation::{Affine, OrthonormalError},
};
use nalgebra::{Matrix3, Vector3};

const POINTS: [[f64; 3]; 4] =
    [[1.0, 0.0, 0.0], [0.3, -2.0, 0.7], [-5.0, 4.0, 3.0], [0.0, 0.25, -8.0]];

/// A few products of coordinates up to 8: a unit of roundoff of these is 10⁻¹⁵.
const ROUNDING: f64 = 1e-14;

fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    (Vector3::from(a) - Vector3::from(b)).norm()
}

/// Any unit normals, with planes through the origin and others.
fn planes() -> impl Iterator<Item = Plane<f64>> {
    let normals = [[1.0, 0.0, 0.0], [0.0, 0.6, -0.8], [0.48, 0.64, 0.6]];
    normals.into_iter().flat_map(|normal| [0.0, 1.0, -2.5].map(|offset| Plane { normal, offset }))
}

#[test]
fn a_reflection_is_the_product_nvn_of_quaternions_and_twice_the_offset() {
    for plane in planes() {
        let normal = Quat::from_parts(plane.normal, 0.0);
        for v in POINTS {
            let product = normal * Quat::from_parts(v, 0.0) * normal;
            let by_quaternions = product + normal.scale(2.0 * plane.offset);
            let got = Affine::reflection(plane).transform_point(v);
            assert!(
                apart(got, by_quaternions.xyz()) < ROUNDING && by_quaternions.w().abs() < 1e-15
            );
        }
    }
}

#[test]
fn a_reflection_undoes_itself_and_leaves_its_plane_alone() {
    for plane in planes() {
        let mirror = Affine::reflection(plane);
        for v in POINTS {
            assert!(apart(mirror.transform_point(mirror.transform_point(v)), v) < ROUNDING);
            let foot = (Vector3::from(v) + Vector3::from(mirror.transform_point(v))) / 2.0;
            let off = foot.dot(&Vector3::from(plane.normal)) - plane.offset;
            assert!(off.abs() < ROUNDING, "the middle is {off} off {plane:?}");
            assert!(apart(mirror.transform_point(foot.into()), foot.into()) < ROUNDING);
        }
    }
}

/// Planes that meet at half the angle, or are half the distance apart: why a motion is two mirrors.
#[test]
fn two_reflections_are_a_motion_that_turns_by_the_product_of_the_normals() {
    for (first, second) in planes().flat_map(|first| planes().map(move |second| (first, second))) {
        let both = Affine::reflection(second) * Affine::reflection(first);
        let [a, b] = [first, second].map(|plane| Quat::from_parts(plane.normal, 0.0));
        let (motion, stretch) = both.try_decompose().expect("it is rigid");
        assert!(
            between(opinion(motion.rotation()), opinion(b * a)) < 2e-15,
            "{first:?} {second:?}"
        );
        assert!((exact_rows(stretch) - Matrix3::identity()).amax() < 2e-15);
        for v in POINTS {
            let one_by_one = [first, second]
                .into_iter()
                .fold(v, |v, plane| Affine::reflection(plane).transform_point(v));
            assert!(apart(motion.transform_point(v), one_by_one) < 2e-14, "{first:?} {second:?}");
        }
    }
}

#[test]
fn no_dual_quaternion_stretches_a_distance_or_mirrors() {
    for_random_motions(|motion| {
        // Of any norm, and with a dual part that is not orthogonal.
        let sigma = motion.scale(3.0) + DualQuat::new(Quat::ZERO, motion.rotation().scale(0.7));
        let place = |v: [f64; 3]| {
            let point = DualQuat::new(Quat::IDENTITY, Quat::from_parts(v, 0.0));
            let moved = sigma * point * sigma.conjugate_both();
            Vector3::from(moved.dual().xyz()) / moved.real().w()
        };
        let size = 1.0 + place([0.0; 3]).norm();
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let columns = axes.map(|axis| place(axis) - place([0.0; 3]));
        let linear = Matrix3::from_columns(&columns);
        let off = (linear.transpose() * linear - Matrix3::identity()).amax();
        assert!(off < ROUNDING * size && linear.determinant() > 0.0, "{off:e}: {sigma:?}");
    });
}

#[test]
fn arends_scales_and_shears_are_his_matrices() {
    let v = [2.0, 3.0, 5.0_f32];
    assert_eq!(Affine::uniform_scale(2.0).transform_point(v), [4.0, 6.0, 10.0]);
    assert_eq!(Affine::scale([-1.0, 0.5, 2.0]).transform_point(v), [-2.0, 1.5, 10.0]);
    let along_z = Affine::shear([0.5, 4.0, 0.0], [0.0, 0.0, 1.0]);
    assert_eq!(along_z.to_matrix3x4()[0], [1.0, 0.0, 0.5, 0.0]);
    assert_eq!(along_z.transform_point(v), [2.0 + 0.5 * 5.0, 3.0 + 4.0 * 5.0, 5.0]);
}

#[test]
fn maps_compose_as_they_act_and_rows_come_back() {
    for_random_motions(|motion| {
        let stretched = Affine::from_motion(motion) * Affine::scale([2.0, 0.5, -3.0]);
        let all = stretched * Affine::shear([0.0, 1.0, -2.0], [0.5, 0.0, 0.0]);
        assert_eq!(Affine::from_matrix3x4(all.to_matrix3x4()), all);
        assert_eq!(all * Affine::IDENTITY, all);
        assert_eq!(Affine::from_motion(motion).to_matrix3x4(), motion.to_matrix3x4());
        let size = 1.0 + Vector3::from(motion.translation()).norm();
        for [x, y, z] in POINTS {
            let sheared = [x, y + 0.5 * x, z - x];
            let [x, y, z] = sheared;
            let by_hand = motion.transform_point([2.0 * x, 0.5 * y, -3.0 * z]);
            assert!(apart(all.transform_point([x, y - 0.5 * x, z + x]), by_hand) < 1e-13 * size);
        }
    });
}

#[test]
fn a_motion_and_a_stretch_come_apart_and_together() {
    let tilt = Matrix3::new(2.0, 0.5, 0.0, 0.5, 1.0, -0.25, 0.0, -0.25, 0.5);
    for_random_motions(|motion| {
        for stretch in [tilt, -tilt, Matrix3::identity(), -Matrix3::identity()] {
            let linear = std::array::from_fn(|i| std::array::from_fn(|j| stretch[(i, j)]));
            let before = Affine { linear, translation: [0.0; 3] };
            let whole = Affine::from_motion(motion) * before;
            let (rigid, found) = whole.try_decompose().expect("it is no line");
            assert!(between(opinion(rigid.rotation()), opinion(motion.rotation())) < 3e-15);
            assert!((exact_rows(found) - stretch).amax() < 3e-15, "{found:?}");
            let size = 1.0 + Vector3::from(motion.translation()).norm();
            assert!(apart(rigid.translation(), motion.translation()) < 2e-15 * size);
        }
    });
}

#[test]
fn a_map_without_a_motion_says_why() {
    let line = Affine::scale([1.0_f32, 0.0, 0.0]).try_decompose();
    assert!(matches!(line, Err(OrthonormalError::Ambiguous { .. })), "{line:?}");
    let nowhere = Affine { translation: [0.0, f32::NAN, 0.0], ..Affine::IDENTITY }.try_decompose();
    assert!(matches!(nowhere, Err(OrthonormalError::NotFinite { row: 1, column: 3, .. })));
}
