//! B. Arends, thesis (Dutch), chapters 3, 5 and 6: what sums of products can do and single ones
//! cannot, and how fast his vectors turn.

use crate::{add, assert_close, assert_far, cross, dot, length, motions, point, pure, quat};
use core::f64::consts::FRAC_PI_2;
use dq8::{DualQuat, Quat};
use lab::arends::{
    ANGLE_STEP, SLERP_ARC, SLERP_STEP, dual_transform, scaled_along, sheared, slerp,
    two_cross_products,
};

/// epe⁻¹ of a unit vector e.
fn sandwiched(e: [f64; 3], p: [f64; 3]) -> [f64; 3] {
    (pure(e) * pure(p) * pure(e).conjugate()).xyz()
}

/// Ch. 5 §6.1: "non-uniform scaling cannot be done with quaternions". His own eq. 8 takes a vector
/// apart into what is across and along e, ½(p ∓ epe⁻¹); with a factor on the one it is scaled
/// along e.
#[test]
fn chapter_5_section_6_1_erratum_equation_8_scales_along_an_axis() {
    assert_eq!(scaled_along([1.0, 0.0, 0.0], [3.0, -2.0, 5.0], 2.5), [7.5, -2.0, 5.0]);
    // Along any axis, as e·p is.
    let (e, p, beta) = ([2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0], [1.0, -2.0, 0.5], 3.0);
    assert_close(scaled_along(e, p, beta), add(p, e.map(|c| (beta - 1.0) * dot(e, p) * c)), 4e-15);
}

/// Ch. 5 §6.3: "no quaternion of any kind shears". p + (a/2)(p + jpj⁻¹)k adds a times the part
/// along j, turned to i: x′ = x + ay.
#[test]
fn chapter_5_section_6_3_erratum_a_sum_of_products_shears() {
    let a = 0.7;
    for p in [[3.0, -2.0, 5.0], [1.0, 0.25, -4.0]] {
        assert_close(sheared(p, a).to_array(), [p[0] + a * p[1], p[1], p[2], 0.0], 1e-15);
    }
}

/// What is true of both: |apb| = |a||p||b|, so a *single* product with whatever factors lengthens
/// all vectors alike.
#[test]
fn chapter_5_section_6_no_single_product_scales_unevenly_or_shears() {
    for (a, b) in [
        (quat(1.0, -2.0, 3.0, 0.5), quat(0.3, 4.0, -1.0, 2.0)),
        (quat(0.0, 1.0, 0.0, 0.0), quat(2.0, 0.0, 0.0, -1.0)),
    ] {
        let factor = a.norm() * b.norm();
        for p in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [3.0, -2.0, 5.0]] {
            assert_close([(a * pure(p) * b).norm() / length(p)], [factor], 1e-14);
        }
    }
    // Uneven scale and shear do not: see the lengths of the axes.
    assert_far([length([2.5, 0.0, 0.0])], [length([0.0, 1.0, 0.0])]);
}

/// Ch. 5 §6.1, the attempt with the dual part: a × b + c × d "cannot be β∘b" because of the
/// missing terms. The sum can be any vector; what cannot be is that b ↦ a × b scales, as a × b
/// is skew in b.
#[test]
fn chapter_5_section_6_1_two_cross_products_can_be_any_vector_but_no_scale() {
    let wanted = [2.0, 3.0, 5.0];
    // Across b, and across d: the two planes meet in a line, together they are all of space.
    let (a, b) = ([0.0, 0.0, 1.0], [3.0, -2.0, 0.0]);
    let (c, d) = ([-5.0, 0.0, 0.0], [0.0, 0.0, 0.0]);
    assert_eq!(two_cross_products([a, b], [c, d]), [2.0, 3.0, 0.0]);
    let d = [0.0, 1.0, 0.0];
    assert_eq!(two_cross_products([a, b], [c, d]), [2.0, 3.0, -5.0]);
    assert_eq!(two_cross_products([a, b], [[5.0, 0.0, 0.0], d]), wanted);
    for b in [[1.0, 0.0, 0.0], [0.3, -1.0, 2.0]] {
        let product = two_cross_products([[0.7, -2.0, 1.5], b], [[0.0; 3]; 2]);
        assert_close([dot(b, product)], [0.0], 1e-15);
    }
}

/// Ch. 3 §2, the steps before eq. 8: |q| = x² + y² + z² is called absolute value there and is
/// its square; eq. 7; and the mirror image.
#[test]
fn chapter_3_erratum_the_absolute_value_is_the_root_and_equation_7_needs_the_norm_of_q2() {
    let q2 = [1.0, -2.0, 0.5];
    assert_close([pure(q2).norm()], [5.25_f64.sqrt()], 1e-15);
    // e q₂⁻¹ = (cos α + f sin α)/‖q₂‖ with e·q₂ = ‖q₂‖ cos α and f along
    // q₂ × e.
    let e = [2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0];
    let inverse = pure(q2).conjugate().scale(1.0 / dot(q2, q2));
    let across = cross(q2, e);
    let (cos, sin) = (dot(e, q2) / length(q2), length(across) / length(q2));
    let f = across.map(|c| c / length(across));
    let wanted = Quat::from_parts(f.map(|c| c * sin), cos).scale(1.0 / length(q2));
    assert_close((pure(e) * inverse).to_array(), wanted.to_array(), 1e-15);
    // "e q₂ e⁻¹ is the mirror image of q₂ in the line e": half a turn about it.
    let mirrored = sandwiched(e, q2);
    let half_turn = DualQuat::from_rotation(pure(e));
    assert_close(mirrored, half_turn.transform_vector(q2), 1e-15);
    assert_close(add(q2, mirrored), e.map(|c| 2.0 * dot(e, q2) * c), 1e-15);
}

/// Eqs. 6 and 9: q₁q₂⁻¹ has −e sin α with e along q₁ × q₂; eq. 9 has + e sin θ, for
/// the turn from 2 to 1.
#[test]
fn chapter_3_eq_6_and_eq_9_have_the_sign_of_the_turn_from_the_second_to_the_first() {
    let (q2, e, angle) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 0.7_f64);
    let q1 = [angle.cos(), angle.sin(), 0.0];
    let quotient = pure(q1) * pure(q2).conjugate();
    assert_close(quotient.to_array(), [0.0, 0.0, angle.sin(), angle.cos()], 1e-15);
    // e of eq. 6 is q₁ × q₂, the other way round.
    assert_close(cross(q1, q2), e.map(|c| -angle.sin() * c), 1e-15);
}

/// Ch. 3 §4: "quaternions cannot translate": qpq⁻¹ leaves the origin where it is, whichever q.
#[test]
fn chapter_3_section_4_quaternions_leave_the_origin_where_it_is() {
    for q in [quat(1.0, -2.0, 3.0, 0.5), motions()[0].rotation()] {
        assert_eq!((q * pure([0.0; 3]) * q.conjugate()).xyz(), [0.0; 3]);
        assert_eq!(q.rotate([0.0; 3]), [0.0; 3]);
    }
    let [s, _] = motions();
    assert_far(s.transform_point([0.0; 3]), [0.0; 3]);
}

/// Ch. 6: "the vector that turns by SLERP turns much faster than all others". It is told to:
/// `t += 0.0175` of a quarter turn is 1.575° a frame, `rotate_angle += 1.0` is 1°.
#[test]
fn chapter_6_erratum_the_vector_of_slerp_is_faster_because_it_is_told_to_be() {
    assert_close([SLERP_STEP * SLERP_ARC], [1.575], 1e-12);
    let angle_of = |[x, y, _]: [f64; 3]| (-x).atan2(y).to_degrees();
    let (begin, end) = (quat(0.0, 0.0, 0.9, 0.0), quat(0.0, -0.9, 0.0, 0.0));
    let by_slerp =
        |frame: f64, step: f64| angle_of(slerp(begin, end, step * frame, FRAC_PI_2).xyz());
    let by_dual_quaternion = |frame: f64| {
        let turn = Quat::from_axis_angle([0.0, 0.0, 1.0], (ANGLE_STEP * frame).to_radians());
        let start = point([0.0, 0.9, 0.0]);
        angle_of(dual_transform(DualQuat::from_rotation(turn), start).dual().xyz())
    };
    for frame in [1.0, 10.0, 50.0] {
        assert_close([by_slerp(frame, SLERP_STEP)], [1.575 * frame], 1e-12);
        assert_close([by_dual_quaternion(frame)], [frame], 1e-12);
        // Told the same, they are equally fast.
        let same = ANGLE_STEP / SLERP_ARC;
        assert_close([by_slerp(frame, same)], [by_dual_quaternion(frame)], 1e-12);
    }
}

/// Appendix A, `quaternionRotation`: cos ½θ and n sin ½θ of an axis that it normalizes, and
/// qpq*.
#[test]
fn appendix_a_quaternion_rotation_turns_by_the_angle_about_the_axis() {
    let (axis, angle, p) = ([3.0, 0.0, 4.0], 1.2_f64, [0.0, 0.9, 0.0]);
    let (b, a) = (0.5 * angle).sin_cos();
    let q = Quat::from_parts(axis.map(|c| b * c / length(axis)), a);
    let turned = q * pure(p) * q.conjugate();
    let wanted = Quat::from_axis_angle([0.6, 0.0, 0.8], angle).rotate(p);
    assert_close(turned.to_array(), pure(wanted).to_array(), 1e-15);
    assert_close([dot(p, turned.xyz()) / 0.81], [angle.cos()], 1e-15);
}

/// Appendix A, `multiply`: of two quaternions without real part, −p·q and p × q.
#[test]
fn appendix_a_the_shortcut_of_pure_quaternions_is_the_whole_product() {
    let (p, q) = ([1.0, -2.0, 0.5], [2.0, 1.0, 4.0]);
    assert_eq!(pure(p) * pure(q), Quat::from_parts(cross(p, q), -dot(p, q)));
}
