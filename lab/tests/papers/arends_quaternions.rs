//! B. Arends, thesis (Dutch), chapters 3, 5 and 6, conclusion and code: what quaternions do.

use crate::{add, assert_close, assert_far, cross, dot, length, motions, point, pure, quat};
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};
use dq8::{DualQuat, Quat};
use lab::arends::{by_components, radians};

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

#[test]
fn chapter_3_eqs_5_and_6_products_of_vectors_hold_cosine_and_sine_of_their_angle() {
    let (a, b) = ([1.0, -2.0, 0.5], [2.0, 1.0, 4.0]);
    let (lengths, across) = (length(a) * length(b), cross(a, b));
    let (sin, cos) = (length(across) / lengths, dot(a, b) / lengths);
    let e = across.map(|c| c / length(across));
    let product = Quat::from_parts(e.map(|c| lengths * sin * c), -lengths * cos);
    assert_close((pure(a) * pure(b)).to_array(), product.to_array(), 1e-14);
    let inverse = pure(b).conjugate().scale(1.0 / dot(b, b));
    let ratio = length(a) / length(b);
    let quotient = Quat::from_parts(e.map(|c| -ratio * sin * c), ratio * cos);
    assert_close((pure(a) * inverse).to_array(), quotient.to_array(), 1e-15);
}

/// sin((1−t)Ω)/sin Ω q₁ + sin(tΩ)/sin Ω q₂: in the plane, a vector at tΩ; in four
/// dimensions, what screw interpolation makes of rotations.
#[test]
fn chapter_3_section_3_slerp_goes_along_the_circle_and_is_sclerp_without_translation() {
    let [a, b] = motions().map(DualQuat::rotation);
    let b = if a.dot(b) < 0.0 { b.scale(-1.0) } else { b };
    let omega = a.dot(b).acos();
    for t in [0.0, 0.25, 0.5, 0.9, 1.0] {
        let [first, second] = [1.0 - t, t].map(|t| (t * omega).sin() / omega.sin());
        let slerp = a.scale(first) + b.scale(second);
        let screw = DualQuat::from_rotation(a).sclerp(DualQuat::from_rotation(b), t);
        assert_close(slerp.to_array(), screw.rotation().to_array(), 1e-15);
        let in_plane = [first + second * omega.cos(), second * omega.sin()];
        assert_close(in_plane, [(t * omega).cos(), (t * omega).sin()], 1e-15);
    }
}

/// He normalizes (10, 1, 2, 3) to (0, 1, 2, 3). A rotation is divided by its norm; without its real
/// part it is half a turn.
#[test]
fn chapter_3_section_4_erratum_to_normalize_is_not_to_drop_the_real_part() {
    let q = quat(10.0, 1.0, 2.0, 3.0);
    let unit = q.normalize();
    assert_close([unit.norm(), unit.w() / unit.x()], [1.0, 10.0], 1e-14);
    let dropped = quat(0.0, 1.0, 2.0, 3.0).normalize();
    assert_far(unit.rotate(X), dropped.rotate(X));
    assert_close(dropped.rotate(dropped.rotate(X)), X, 1e-15);
    // Of a vector, qpq* has no real part to drop, but for rounding.
    let rotated = unit * pure([1.0, 2.0, 3.0]) * unit.conjugate();
    assert_close([rotated.w()], [0.0], 1e-15);
}

/// p′ = βqpq⁻¹. For a point 1 + εv it is β + εβv′: scaled in the dual part as he reads
/// it, the same point as before where the real part is divided by.
#[test]
fn chapter_5_section_6_1_a_factor_scales_the_dual_part_of_a_point() {
    let ([s, _], v, beta) = (motions(), [3.0, 1.0, -1.0], 2.5);
    let moved = s.transform_point(v);
    let scaled = (s * point(v) * s.conjugate_both()).scale(beta);
    assert_close(scaled.dual().xyz(), moved.map(|c| beta * c), 1e-14);
    assert_close([scaled.real().w()], [beta], 1e-15);
    assert_close(scaled.dual().xyz().map(|c| c / scaled.real().w()), moved, 1e-14);
    // Quaternions of vectors have no such real part.
    let r = s.rotation();
    let scaled = (r * pure(v) * r.conjugate()).scale(beta);
    assert_close(scaled.to_array(), pure(r.rotate(v).map(|c| beta * c)).to_array(), 1e-14);
}

/// (p₀q₀, p₁q₁, p₂q₂, p₃q₃) scales along the axes; turned along with its factors it
/// is another map.
#[test]
fn chapter_5_section_6_1_the_product_by_components_depends_on_the_axes() {
    let (beta, v) = ([2.0, 3.0, 5.0], [1.0, -1.0, 0.5]);
    assert_eq!(by_components(beta, v), [2.0, -3.0, 2.5]);
    let r = motions()[0].rotation();
    assert_far(by_components(r.rotate(beta), r.rotate(v)), r.rotate(by_components(beta, v)));
    // Products of the algebra turn along.
    assert_close(cross(r.rotate(beta), r.rotate(v)), r.rotate(cross(beta, v)), 1e-14);
}

/// "With dual quaternions this can be done too." n(1 + εv)n = −1 + ε nvn has the mirror image
/// in its dual part; as a point, divided by −1, it is half a turn about n, and no mirror.
#[test]
fn chapter_5_section_6_2_a_reflected_point_is_one_by_its_dual_part_only() {
    let (n, v) = ([2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0], [1.0, -2.0, 0.5]);
    let normal = DualQuat::from_rotation(pure(n));
    let reflected = normal * point(v) * normal;
    let mirror = add(v, n.map(|c| -2.0 * c * dot(n, v)));
    let negative = Quat::IDENTITY.scale(-1.0);
    assert_close(reflected.real().to_array(), negative.to_array(), 1e-15);
    assert_close(reflected.dual().to_array(), pure(mirror).to_array(), 1e-15);
    assert_close(mirror.map(|c| -c), normal.transform_point(v), 1e-15);
    // His example mirrors in the plane of x and z; in the x-axis itself (1,1,1) goes to
    // (1,−1,−1).
    let half_turn = quat(0.0, 1.0, 0.0, 0.0);
    assert_eq!(half_turn.rotate([1.0; 3]), [1.0, -1.0, -1.0]);
}

/// glRotatef(90, z), glRotatef(45, y), line to (0,1,0): the second turn "is not carried out, by
/// gimbal lock". OpenGL multiplies from the right, so it acts first, about the axis on which the
/// vector lies.
#[test]
fn chapter_6_erratum_the_turn_that_opengl_ignores_is_about_the_vector_itself() {
    let [about_z, about_y] = [(Z, FRAC_PI_2), (Y, FRAC_PI_4)]
        .map(|(axis, angle)| DualQuat::from_rotation(Quat::from_axis_angle(axis, angle)));
    let drawn = (about_z * about_y).transform_vector(Y);
    assert_close(drawn, about_z.transform_vector(Y), 1e-15);
    // Nothing is locked: any other vector moves, and so does this one in the other order.
    assert_far((about_z * about_y).transform_vector(X), about_z.transform_vector(X));
    assert_far((about_y * about_z).transform_vector(Y), about_z.transform_vector(Y));
}

/// "(1,0,0) gets to (0,1,0) by 90° about z, or by 90° about y and then x. Quaternions do not have
/// this problem": they have, because the two are different rotations.
#[test]
fn conclusion_erratum_quaternions_have_many_rotations_between_two_vectors_too() {
    let quarter = |axis| Quat::from_axis_angle(axis, FRAC_PI_2);
    let (one, two) = (quarter(Z), quarter(X) * quarter(Y));
    for rotation in [one, two] {
        assert_close(rotation.rotate(X), Y, 1e-15);
    }
    assert_far(one.rotate(Z), two.rotate(Z));
    assert_far(one.to_array(), two.to_array());
    assert_far(one.to_array(), two.scale(-1.0).to_array());
}

/// `dqtransform` of the appendix: ½ t r for the dual part and a conjugate that turns both signs.
#[test]
fn appendix_a_dqtransform_rotates_and_then_translates() {
    let (axis, angle, t, v) = ([0.6, 0.0, 0.8], 1.2, [1.0, -2.0, 0.5], [0.0, 0.9, 0.0]);
    let rotation = Quat::from_axis_angle(axis, angle);
    let both = DualQuat::new(rotation, pure(t.map(|c| c / 2.0)) * rotation);
    let conjugate = DualQuat::new(rotation.conjugate(), both.dual().conjugate().scale(-1.0));
    assert_eq!(conjugate, both.conjugate_both());
    let result = both * point(v) * conjugate;
    assert_close(result.dual().xyz(), add(rotation.rotate(v), t), 1e-15);
    let motion = DualQuat::from_rotation_translation(rotation, t);
    assert_close(both.to_array(), motion.to_array(), 1e-15);
}

/// DEG2RAD is 3.14159/180: over a turn 5·10⁻⁶ are missing, ten times what a float loses by
/// rounding.
#[test]
fn appendix_a_erratum_degrees_are_short_by_eight_ten_millionths() {
    let turn = radians(360.0);
    assert_close([(TAU - turn) / TAU], [8.446e-7], 1e-10);
    assert!(TAU - turn > 10.0 * (f64::from(core::f32::consts::TAU) - TAU).abs());
}
