//! M. Tarini, *3D videogames: additional notes on dual-quaternions*, slides 110–127.

use crate::whole_numbers;
use crate::{add, assert_close, assert_far, cross, dot, motions, point, pure, quat, third_turn};
use dq8::{DualQuat, Quat};
use nalgebra::SMatrix;

const AXIS: [f64; 3] = [2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0];
const ANGLE: f64 = 1.3;
const SHIFT: [f64; 3] = [1.0, -2.0, 0.5];

/// 0 + εv, a direction.
fn direction(vector: [f64; 3]) -> DualQuat<f64> {
    DualQuat::new(Quat::ZERO, pure(vector))
}

fn assert_unit_and_orthogonal(s: DualQuat<f64>) {
    assert_close([s.real().norm(), s.real().dot(s.dual())], [1.0, 0.0], 1e-15);
}

#[test]
fn slide_113_the_dot_product_is_the_real_part_of_the_product_with_a_conjugate() {
    let (p, q) = (quat(1.0, 2.0, 3.0, 4.0), quat(5.0, 6.0, -7.0, 8.0));
    assert_eq!(p.dot(q), 5.0 + 12.0 - 21.0 + 32.0);
    let (p_bar, q_bar) = (p.conjugate(), q.conjugate());
    for product in [p * q_bar, q_bar * p, q * p_bar, p_bar * q] {
        assert_eq!(product.w(), p.dot(q));
    }
}

#[test]
fn slide_113_the_product_with_its_own_conjugate_is_the_squared_norm_and_has_no_imaginary_part() {
    let p = quat(1.0, 2.0, 3.0, 4.0);
    assert_eq!(p * p.conjugate(), quat(p.dot(p), 0.0, 0.0, 0.0));
    assert_close([p.norm() * p.norm()], [30.0], 1e-14);
}

#[test]
fn slide_113_sum_and_difference_with_the_conjugate_are_twice_the_parts() {
    let (p, q) = (quat(1.0, 2.0, 3.0, 4.0), quat(5.0, 6.0, -7.0, 8.0));
    assert_eq!(p + p.conjugate(), quat(2.0, 0.0, 0.0, 0.0));
    assert_eq!(p - p.conjugate(), quat(0.0, 4.0, 6.0, 8.0));
    assert_eq!((p * q).conjugate(), q.conjugate() * p.conjugate());
}

#[test]
fn slide_114_the_product_is_associative_and_neither_commutes_nor_anticommutes() {
    let [a, b] = whole_numbers();
    let c = DualQuat::from_wxyz([0.0, 1.0, -1.0, 2.0, 3.0, 0.0, 1.0, -2.0]);
    assert_eq!((a * b) * c, a * (b * c));
    assert_ne!(a * b, b * a);
    assert_ne!(a * b, -(b * a));
    // ε² q₀q₁ is struck out.
    let (epsilon_a, epsilon_b) =
        (DualQuat::new(Quat::ZERO, a.dual()), DualQuat::new(Quat::ZERO, b.dual()));
    assert_eq!(epsilon_a * epsilon_b, DualQuat::ZERO);
}

/// Here and in all that follows the slides' "conjugate" is dq8's `conjugate_both`.
#[test]
fn slide_115_the_conjugate_turns_the_primal_vector_and_the_dual_scalar() {
    let a = DualQuat::from_array([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    let wanted = DualQuat::from_array([-1.0, -2.0, -3.0, 4.0, 5.0, 6.0, 7.0, -8.0]);
    assert_eq!(a.conjugate_both(), wanted);
}

#[test]
fn slide_116_pure_rotations_and_translations_are_unit_and_orthogonal() {
    // Those of the standard library are others on another machine.
    let [sin, cos] = [<f64 as dq8::Real>::sin, <f64 as dq8::Real>::cos].map(|of| of(ANGLE / 2.0));
    let [x, y, z] = AXIS.map(|c| c * sin);
    let rotation = DualQuat::from_rotation(Quat::from_axis_angle(AXIS, ANGLE));
    assert_eq!(rotation, DualQuat::from_array([x, y, z, cos, 0.0, 0.0, 0.0, 0.0]));
    assert_unit_and_orthogonal(rotation);
    let translation = DualQuat::from_translation([2.0, -4.0, 1.0]);
    assert_eq!(translation, DualQuat::from_array([0.0, 0.0, 0.0, 1.0, 1.0, -2.0, 0.5, 0.0]));
    assert_unit_and_orthogonal(translation);
}

#[test]
fn slides_117_and_118_points_translate_and_rotate() {
    let v = [3.0, 1.0, -1.0];
    let translation = DualQuat::from_translation(SHIFT);
    let moved = translation * point(v) * translation.conjugate_both();
    assert_eq!(moved, point(add(v, SHIFT)));
    assert_eq!(translation.transform_point(v), add(v, SHIFT));
    let rotation = DualQuat::from_rotation(third_turn());
    let turned = rotation * point(v) * rotation.conjugate_both();
    assert_eq!(turned, point([-1.0, 3.0, 1.0]));
    assert_eq!(rotation.transform_point(v), [-1.0, 3.0, 1.0]);
}

/// Unit and orthogonal are the motions: r + ½εtr of whichever r and t is, and from what is it
/// comes back.
#[test]
fn slide_112_unit_and_orthogonal_are_the_roto_translations_and_no_others() {
    for s in motions() {
        assert_unit_and_orthogonal(s);
        let again = DualQuat::from_rotation_translation(s.rotation(), s.translation());
        assert_close(again.to_array(), s.to_array(), 1e-15);
    }
    // Without either condition the parts do not make it again, and points are not where parts put
    // them.
    let [s, _] = motions();
    let long = s.scale(1.5);
    let slanted = DualQuat::new(s.real(), s.dual() + s.real().scale(0.5));
    for other in [long, slanted] {
        let again = DualQuat::from_rotation_translation(other.rotation(), other.translation());
        assert_far(again.to_array(), other.to_array());
        assert_far([other.real().norm(), other.real().dot(other.dual())], [1.0, 0.0]);
    }
    let v = [3.0, 1.0, -1.0];
    let real = (long * point(v) * long.conjugate_both()).real();
    assert_close([real.w()], [2.25], 1e-15);
}

#[test]
fn slides_119_and_120_a_roto_translation_is_unit_and_orthogonal() {
    let (sin, cos) = (ANGLE / 2.0).sin_cos();
    let v = SHIFT.map(|c| c / 2.0);
    let imaginary = add(cross(v, AXIS).map(|c| c * sin), v.map(|c| c * cos));
    let table = DualQuat::new(
        Quat::from_parts(AXIS.map(|c| c * sin), cos),
        Quat::from_parts(imaginary, -sin * dot(AXIS, v)),
    );
    assert_unit_and_orthogonal(table);
    let rotation = Quat::from_axis_angle(AXIS, ANGLE);
    let made = DualQuat::from_rotation_translation(rotation, SHIFT);
    assert_close(made.to_array(), table.to_array(), 1e-15);
    // First rotate, then translate.
    let product = DualQuat::from_translation(SHIFT) * DualQuat::from_rotation(rotation);
    assert_close(product.to_array(), table.to_array(), 1e-15);
}

#[test]
fn slides_121_and_122_vectors_do_not_translate_but_rotate() {
    let v = [3.0, 1.0, -1.0];
    let translation = DualQuat::from_translation(SHIFT);
    let still = translation * direction(v) * translation.conjugate_both();
    assert_eq!(still, direction(v));
    assert_eq!(translation.transform_vector(v), v);
    let both = DualQuat::from_rotation_translation(third_turn(), SHIFT);
    let turned = both * direction(v) * both.conjugate_both();
    assert_eq!(turned, direction([-1.0, 3.0, 1.0]));
    assert_eq!(both.transform_vector(v), [-1.0, 3.0, 1.0]);
}

#[test]
fn slide_123_conjugating_both_quaternions_inverts_because_dual_and_primal_are_orthogonal() {
    let [s, _] = motions();
    let (r, t) = (s.real(), s.dual());
    // t r̄ plus its conjugate is twice the real part of t r̄, twice ⟨t, r⟩, and that is 0.
    let sum = t * r.conjugate() + r * t.conjugate();
    assert_close((t * r.conjugate()).conjugate().to_array(), (r * t.conjugate()).to_array(), 1e-15);
    assert_close(sum.to_array(), quat(2.0 * t.dot(r), 0.0, 0.0, 0.0).to_array(), 1e-15);
    assert_close(sum.to_array(), [0.0; 4], 1e-15);
    assert_close((s * s.conjugate()).to_array(), DualQuat::IDENTITY.to_array(), 1e-15);
}

#[test]
fn slides_123_and_124_the_inverse_is_not_the_dual_quaternion_conjugate() {
    let [s, _] = motions();
    assert_far((s * s.conjugate_both()).to_array(), DualQuat::IDENTITY.to_array());
    // They agree where there is no translation, and nowhere else.
    let rotation = DualQuat::from_rotation(s.rotation());
    assert_eq!(rotation.conjugate(), rotation.conjugate_both());
    let translation = DualQuat::from_translation(SHIFT);
    assert_eq!(translation.conjugate_both(), translation);
    assert_eq!(translation.conjugate() * translation, DualQuat::IDENTITY);
}

#[test]
fn slide_124_opposite_dual_quaternions_are_the_same_motion() {
    let [s, _] = motions();
    let v = [3.0, 1.0, -1.0];
    assert_eq!((-s).transform_point(v), s.transform_point(v));
    for identity in [DualQuat::IDENTITY, -DualQuat::IDENTITY] {
        assert_eq!(identity.transform_point(v), v);
        assert_eq!(identity.transform_vector(v), v);
    }
}

/// What moves nothing commutes with i, j and k, and only real numbers do: so σ⁻¹τ is ±1, and
/// τ = ±σ.
#[test]
fn slide_124_there_is_no_third_dual_quaternion_of_a_motion() {
    let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(pure);
    // pv − vp = 0 for v = i, j, k: twelve equations for the four components of p.
    let commutes = SMatrix::<f64, 12, 4>::from_fn(|row, component| {
        let p = Quat::from_array(core::array::from_fn(|i| f64::from(u8::from(i == component))));
        let v = units[row / 4];
        (p * v - v * p).to_array()[row % 4]
    });
    assert_eq!(commutes.rank(1e-12), 3);
    assert_eq!(commutes.column(3).amax(), 0.0, "the real component is free");
    // And 2qp* = 0 with p = ±1 has no q but 0.
    for p in [Quat::IDENTITY, -Quat::IDENTITY] {
        let translation = SMatrix::<f64, 4, 4>::from_fn(|row, component| {
            let q = Quat::from_array(core::array::from_fn(|i| f64::from(u8::from(i == component))));
            (q.scale(2.0) * p.conjugate()).to_array()[row]
        });
        assert_eq!(translation.rank(1e-12), 4);
    }
}

#[test]
fn slide_124_cumulation_is_second_times_first() {
    let [first, second] = motions();
    let v = [3.0, 1.0, -1.0];
    let one_by_one = second.transform_point(first.transform_point(v));
    assert_close((second * first).transform_point(v), one_by_one, 1e-14);
}

#[test]
fn slide_125_the_translation_is_where_the_origin_goes() {
    let [s, _] = motions();
    let (r, t) = (s.real(), s.dual());
    let origin = s * DualQuat::IDENTITY * s.conjugate_both();
    let twice = (t * r.conjugate()).scale(2.0).xyz();
    assert_close(origin.to_array(), point(twice).to_array(), 1e-15);
    assert_close(s.translation(), twice, 1e-15);
    assert_close(s.transform_point([0.0; 3]), s.translation(), 1e-15);
}

/// The slide's table still says "t r" in its margin; it is r t, hence the turned cross product. The
/// real part, left blank there, is −½ s a·t as before.
#[test]
fn slide_126_a_translo_rotation_has_the_cross_product_the_other_way_round() {
    let (sin, cos) = (ANGLE / 2.0).sin_cos();
    let rotation = Quat::from_axis_angle(AXIS, ANGLE);
    let imaginary = add(cross(AXIS, SHIFT).map(|c| c * sin), SHIFT.map(|c| c * cos));
    let dual = Quat::from_parts(imaginary, -sin * dot(AXIS, SHIFT)).scale(0.5);
    let translo_rotation = DualQuat::from_translation_rotation(SHIFT, rotation);
    assert_close(translo_rotation.dual().to_array(), dual.to_array(), 1e-15);
    let product = DualQuat::from_rotation(rotation) * DualQuat::from_translation(SHIFT);
    assert_close(translo_rotation.to_array(), product.to_array(), 1e-15);
    let v = [3.0, 1.0, -1.0];
    let wanted = rotation.rotate(add(v, SHIFT));
    assert_close(translo_rotation.transform_point(v), wanted, 1e-15);
    let roto_translation = DualQuat::from_rotation_translation(rotation, SHIFT);
    assert_far(roto_translation.transform_point(v), wanted);
}

#[test]
fn slide_127_mixing_step_by_step() {
    let [a, near] = motions();
    // Step 1: both p₁ and q₁ are flipped where ⟨p₀, p₁⟩ is negative.
    let far = if a.real().dot(near.real()) < 0.0 { near } else { -near };
    assert!(a.real().dot(far.real()) < 0.0);
    let near = -far;
    for t in [0.0, 0.25, 0.5, 1.0] {
        // Step 2: primal and dual, linearly.
        let mix = |p: Quat<f64>, q: Quat<f64>| p.scale(1.0 - t) + q.scale(t);
        let (p, q) = (mix(a.real(), near.real()), mix(a.dual(), near.dual()));
        // Step 3: both are divided by ‖p‖.
        let norm = p.norm();
        let (p, q) = (p.scale(1.0 / norm), q.scale(1.0 / norm));
        // Step 4: ⟨p, q⟩ p is taken from q.
        let mixed = DualQuat::new(p, q - p.scale(p.dot(q)));
        assert_close(a.nlerp(near, t).to_array(), mixed.to_array(), 1e-14);
        assert_close(a.nlerp(far, t).to_array(), mixed.to_array(), 1e-14);
        let dlb = DualQuat::dlb(&[(a, 1.0 - t), (far, t)]).unwrap();
        assert_close(dlb.to_array(), mixed.to_array(), 1e-14);
        assert_unit_and_orthogonal(mixed);
        // Why step 4: between the ends, what step 3 leaves is no roto-translation.
        let between = t > 0.0 && t < 1.0;
        assert_eq!(p.dot(q).abs() > 0.05, between, "⟨p, q⟩ = {} at {t}", p.dot(q));
    }
}

#[test]
fn slide_127_flipping_the_primal_alone_is_another_motion() {
    let [a, b] = motions();
    let torn = DualQuat::new(-b.real(), b.dual());
    assert_far(torn.translation(), b.translation());
    assert_close((-b).translation(), b.translation(), 1e-15);
    assert_far(a.nlerp(torn, 1.0).translation(), a.nlerp(b, 1.0).translation());
}
