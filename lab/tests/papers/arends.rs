//! B. Arends, thesis (Dutch): rotations, SLERP, reflections, keyframing after Alexa.

use crate::{add, assert_close, assert_far, cross, dot, motions, point, pure, quat};
use core::f64::consts::{FRAC_PI_2, SQRT_2};
use dq8::{DualQuat, Quat, scalar::MatrixError};
use lab::arends::{side_by_side, slerp, slerp_formula};

/// Equations 8 to 10: e v e⁻¹ mirrors v in the line e, so half the sum and half the difference
/// with v are its parts along and across e.
#[test]
fn chapter_3_eqs_8_to_10_the_parts_of_a_vector_along_and_across_an_axis() {
    let (e, v) = ([2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0], [1.0, -2.0, 0.5]);
    let mirrored = (pure(e) * pure(v) * pure(e).conjugate()).xyz();
    let along = e.map(|c| c * dot(e, v));
    let across = add(v, along.map(|c| -c));
    assert_close(add(v, mirrored).map(|c| c / 2.0), along, 1e-15);
    assert_close(add(v, mirrored.map(|c| -c)).map(|c| c / 2.0), across, 1e-15);
    // p′ = qpq⁻¹ turns the part across and leaves the part along.
    let q = Quat::from_axis_angle(e, 1.1);
    let turned = (q * pure(v) * q.conjugate()).xyz();
    assert_close(turned, q.rotate(v), 1e-15);
    assert_close([dot(turned, e)], [dot(v, e)], 1e-15);
    // By θ and not by half or minus that: cosine and sine of the parts across.
    let turned = add(turned, along.map(|c| -c));
    let size = dot(across, across);
    assert_close([dot(turned, across) / size], [1.1_f64.cos()], 1e-15);
    assert_close([dot(e, cross(across, turned)) / size], [1.1_f64.sin()], 1e-15);
}

/// (1,0,0,0) + ε(0, x, y, z) under q_t, step by step as the thesis has it. The daggers' bars are
/// lost in print: his worked q_t† is p* − εq*.
#[test]
fn chapter_4_section_4_translation_step_by_step() {
    let (v, t) = ([3.0, 1.0, -1.0], [2.0, -4.0, 6.0]);
    let q_t = DualQuat::from_wxyz([1.0, 0.0, 0.0, 0.0, 0.0, 1.0, -2.0, 3.0]);
    assert_eq!(q_t, DualQuat::from_translation(t));
    assert_eq!(q_t.conjugate_both(), q_t);
    assert_eq!(q_t * point(v), point([4.0, -1.0, 2.0]));
    assert_eq!(q_t * point(v) * q_t.conjugate_both(), point([5.0, -3.0, 5.0]));
}

/// He writes q = q_r q_t = (cos, n sin) + ε(0, T/2).
#[test]
fn chapter_4_section_4_erratum_rotation_times_translation_is_not_their_parts_side_by_side() {
    let (n, t) = ([0.6, 0.0, 0.8], [2.0, -4.0, 6.0]);
    let q_t = DualQuat::from_translation(t);
    for angle in [0.5, 2.0, 3.0] {
        let r = Quat::from_axis_angle(n, angle);
        let q_r = DualQuat::from_rotation(r);
        let printed = side_by_side(r, t);
        assert_far((q_r * q_t).to_array(), printed.to_array());
        assert_far((q_t * q_r).to_array(), printed.to_array());
        // It is not even a motion.
        assert!(!printed.is_unit(0.1));
        // The product is r + ½ε r t: translate, then rotate. His code has ½ t r, the usual
        // order.
        let translate_first = DualQuat::from_translation_rotation(t, r);
        assert_close((q_r * q_t).to_array(), translate_first.to_array(), 1e-14);
        let rotate_first = DualQuat::new(r, (pure(t) * r).scale(0.5));
        assert_close((q_t * q_r).to_array(), rotate_first.to_array(), 1e-14);
        assert_close(rotate_first.transform_point([0.0; 3]), t, 1e-14);
    }
    // Only where nothing turns are the three the same.
    let still = DualQuat::new(Quat::IDENTITY, pure(t).scale(0.5));
    assert_eq!(DualQuat::from_rotation(Quat::IDENTITY) * q_t, still);
}

#[test]
fn chapter_5_section_6_2_reflection_is_q_p_q_with_the_normal_of_the_plane() {
    // (0,1,1,1) in the plane of x and z, whose normal is j.
    let (p, j) = (quat(0.0, 1.0, 1.0, 1.0), quat(0.0, 0.0, 1.0, 0.0));
    assert_eq!(j * p * j, quat(0.0, 1.0, -1.0, 1.0));
    let (n, v) = ([2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0], [1.0, -2.0, 0.5]);
    let mirror = |v: [f64; 3]| add(v, n.map(|c| -2.0 * c * dot(n, v)));
    assert_close((pure(n) * pure(v) * pure(n)).to_array(), pure(mirror(v)).to_array(), 1e-15);
    // Twice is nothing, and β scales.
    assert_close(mirror(mirror(v)), v, 1e-15);
    assert_eq!((j * p * j).scale(3.0), quat(0.0, 3.0, -3.0, 3.0));
}

/// Reflections, non-uniform scale and shear are no motions, so no dual quaternion holds them (§6
/// of chapter 5): the conversion from a matrix says so and names the rows.
#[test]
fn chapter_5_section_6_mirrors_scale_and_shear_are_no_dual_quaternions() {
    let rows = |x: [f64; 3], y: [f64; 3], z: [f64; 3]| [x, y, z].map(|[a, b, c]| [a, b, c, 0.0]);
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let refused = |rows| DualQuat::try_from_matrix3x4(rows, 1e-6).unwrap_err();
    let mirror = refused(rows(x, [0.0, -1.0, 0.0], z));
    assert_eq!(mirror, MatrixError::Mirrors { determinant: -1.0 });
    let scale = refused(rows(x, [0.0, 3.0, 0.0], z));
    assert_eq!(scale, MatrixError::NotOrthonormal { row: 1, column: 1, value: 9.0 });
    let shear = refused(rows(x, y, [0.0, 1e-3, 1.0]));
    assert_eq!(shear, MatrixError::NotOrthonormal { row: 1, column: 2, value: 1e-3 });
}

/// slerp(q, q, ½) with the angle 90° given beside them: he prints 2√2, it is √2, and must
/// be 1.
#[test]
fn chapter_6_erratum_slerp_between_equal_quaternions_with_a_foreign_angle_gives_root_two() {
    let q = quat(0.0, 1.0, 0.0, 0.0);
    let his = slerp_formula(q, q, 0.5, FRAC_PI_2);
    assert_close(his.to_wxyz(), [0.0, SQRT_2, 0.0, 0.0], 1e-15);
}

#[test]
fn chapter_6_interpolation_between_equal_motions_stays_there() {
    let half_turn = DualQuat::from_rotation(quat(0.0, 1.0, 0.0, 0.0));
    let [a, b] = motions();
    for motion in [DualQuat::IDENTITY, half_turn, a, b] {
        for t in [0.0, 0.25, 0.5, 1.0, 3.0] {
            assert_close(motion.sclerp(motion, t).to_array(), motion.to_array(), 1e-14);
            assert_close(motion.nlerp(motion, t).to_array(), motion.to_array(), 1e-14);
            // Ω = π: the opposite is the same motion, and sin Ω = 0 must not be divided by.
            assert_close(motion.sclerp(-motion, t).to_array(), motion.to_array(), 1e-14);
            assert_close(motion.nlerp(-motion, t).to_array(), motion.to_array(), 1e-14);
        }
        // Taken the long way on purpose, a whole turn about no axis in particular: NaN, not large.
        assert!(motion.sclerp_long(-motion, 0.5).to_array().iter().all(|c| c.is_nan()));
    }
}

/// His test for equality looks at x, y and z; w alone may differ, in sign. Then he stays at the
/// beginning.
#[test]
fn chapter_6_erratum_quaternions_with_equal_vector_parts_need_not_be_equal() {
    let [a, b] = [0.6, -0.6].map(|w| DualQuat::from_rotation(quat(w, 0.8, 0.0, 0.0)));
    assert_eq!(a.real().xyz(), b.real().xyz());
    assert_eq!(slerp(a.real(), b.real(), 1.0, 1.2), a.real());
    assert_close(a.sclerp(b, 1.0).canonical().to_array(), b.canonical().to_array(), 1e-15);
    assert_far(a.sclerp(b, 0.5).to_array(), a.to_array());
    let y = [0.0, 1.0, 0.0];
    assert_far(a.transform_vector(y), b.transform_vector(y));
}
