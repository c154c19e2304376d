//! Y.-B. Jia, *Dual Quaternions*, §§2–7: arithmetic, conjugates, displacements.

use crate::{add, assert_close, assert_far, cross, dot, motions, point, pure, quat};
use crate::{third_turn, whole_numbers};
use dq8::geometry::DualVector;
use dq8::{Dual, DualQuat, Quat, Twist};
use nalgebra::SMatrix;

#[test]
fn eq_2_the_product_of_quaternions_in_parts() {
    let (p, q) = (quat(1.0, 2.0, 3.0, 4.0), quat(5.0, 6.0, 7.0, 8.0));
    let ([p0, q0], [pv, qv]) = ([p.w(), q.w()], [p.xyz(), q.xyz()]);
    let vector = add(add(qv.map(|c| p0 * c), pv.map(|c| q0 * c)), cross(pv, qv));
    assert_eq!(p * q, Quat::from_parts(vector, p0 * q0 - dot(pv, qv)));
    assert_eq!(p * q, quat(-60.0, 12.0, 30.0, 24.0));
    assert_eq!((p * q).conjugate(), q.conjugate() * p.conjugate());
    assert_eq!(p * p.conjugate(), quat(30.0, 0.0, 0.0, 0.0));
    assert_eq!(p.conjugate() * p, quat(30.0, 0.0, 0.0, 0.0));
}

#[test]
fn eqs_1_and_13_sums_and_multiples_go_component_by_component() {
    let sum = quat(1.0, 2.0, 3.0, 4.0) + quat(5.0, 6.0, 7.0, 8.0);
    assert_eq!(sum, quat(6.0, 8.0, 10.0, 12.0));
    let [a, b] = whole_numbers();
    let components = core::array::from_fn(|i| a.to_array()[i] + b.to_array()[i]);
    assert_eq!((a + b).to_array(), components);
    assert_eq!((a - b).to_array(), (a + b.scale(-1.0)).to_array());
    assert_eq!(a.scale(3.0).to_array(), a.to_array().map(|c| 3.0 * c));
}

/// "Where θ ∈ [0, π]": with −1 < w < 0 the angle is beyond π. It is so up to sign.
#[test]
fn eq_3_erratum_angles_up_to_pi_reach_the_quaternions_without_negative_real_part() {
    let (q, u) = (quat(-0.6, 0.8, 0.0, 0.0), [1.0, 0.0, 0.0]);
    let theta = 2.0 * 0.8_f64.atan2(-0.6);
    assert!(theta > core::f64::consts::PI);
    assert_close(Quat::from_axis_angle(u, theta).to_array(), q.to_array(), 1e-15);
    // dq8's screws have angles up to π, of the one of ±q with w ≥ 0.
    let screw = DualQuat::from_rotation(q).to_screw();
    assert_close([screw.angle], [core::f64::consts::TAU - theta], 1e-15);
    assert_close(screw.axis.direction, [-1.0, 0.0, 0.0], 1e-15);
}

#[test]
fn eq_4_the_power_of_a_quaternion_turns_by_a_multiple_of_the_angle() {
    let (u, theta) = ([2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0], 0.7_f64);
    let q = Quat::from_parts(u.map(|c| c * theta.sin()), theta.cos());
    for rho in [0.0, 0.25, 1.0, 2.0, -1.5] {
        let (sin, cos) = (rho * theta).sin_cos();
        let power = DualQuat::from_rotation(q).pow(rho);
        let wanted = DualQuat::from_rotation(Quat::from_parts(u.map(|c| c * sin), cos));
        assert_close(power.to_array(), wanted.to_array(), 1e-15);
    }
}

#[test]
fn eqs_5_to_7_dual_numbers_form_a_ring_without_inverses_of_epsilon() {
    let (a, b) = (Dual::new(2.0, 3.0), Dual::new(4.0, -5.0));
    assert_eq!(a + b, Dual::new(6.0, -2.0));
    assert_eq!(a * b, Dual::new(8.0, 2.0));
    assert_eq!(b.inverse(), Ok(Dual::new(0.25, 5.0 / 16.0)));
    assert_eq!(Dual::<f64>::EPSILON * Dual::EPSILON, Dual::ZERO);
    assert_ne!(Dual::<f64>::EPSILON, Dual::ZERO);
    assert_eq!(Dual::EPSILON * a, Dual::new(0.0, 2.0));
    assert_eq!(Dual::new(0.0, 3.0).inverse().unwrap_err().real_norm, 0.0);
}

/// Dual numbers stand in the real components, vectors and dual vectors in the others.
#[test]
fn section_4_numbers_vectors_and_quaternions_are_special_dual_quaternions() {
    let number = |d: Dual<f64>| DualQuat::IDENTITY.scale_dual(d);
    let (a, b) = (Dual::new(2.0, 3.0), Dual::new(4.0, -5.0));
    assert_eq!(number(a), DualQuat::from_wxyz([2.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0]));
    assert_eq!(number(a) * number(b), number(a * b));
    assert_eq!(number(a) + number(b), number(a + b));
    let (p, q) = (quat(1.0, 2.0, 3.0, 4.0), quat(5.0, 6.0, 7.0, 8.0));
    assert_eq!(
        DualQuat::from_rotation(p) * DualQuat::from_rotation(q),
        DualQuat::from_rotation(p * q)
    );
    // Of vectors and dual vectors the product holds the inner and the cross product.
    let vector = |v: DualVector<f64>| DualQuat::from_dual_parts(Dual::ZERO, v);
    let (v, w) = (
        DualVector { real: [1.0, 2.0, 3.0], dual: [0.0; 3] },
        DualVector { real: [-2.0, 1.0, 4.0], dual: [3.0, 0.0, -1.0] },
    );
    for (v, w) in [(v, v), (v, w), (w, v), (w, w)] {
        let [real, dual] = v.dot(w);
        let inner = -Dual::new(real, dual);
        assert_eq!(vector(v) * vector(w), DualQuat::from_dual_parts(inner, v.cross(w)));
    }
    // Dual numbers commute with all; a dual quaternion is one of them and a dual vector.
    let [s, _] = whole_numbers();
    assert_eq!(number(a) * s, s * number(a));
    assert_eq!(number(a) * s, s.scale_dual(a));
    assert_eq!(DualQuat::from_dual_parts(s.dual_scalar(), s.dual_vector()), s);
}

#[test]
fn eq_14_the_product_in_whole_numbers() {
    let [a, b] = whole_numbers();
    let [p1, p2] = [a.real(), b.real()];
    let [q1, q2] = [a.dual(), b.dual()];
    assert_eq!(a * b, DualQuat::new(p1 * p2, p1 * q2 + q1 * p2));
    assert_eq!((a * b).real(), quat(-9.0, -6.0, 3.0, 18.0));
}

#[test]
fn eqs_16_17_and_19_the_three_conjugates_as_eight_tuples() {
    let [s, _] = whole_numbers();
    let dual = [1.0, 2.0, 3.0, 4.0, -5.0, -6.0, -7.0, -8.0];
    let quaternion = [1.0, -2.0, -3.0, -4.0, 5.0, -6.0, -7.0, -8.0];
    let both = [1.0, -2.0, -3.0, -4.0, -5.0, 6.0, 7.0, 8.0];
    assert_eq!(s.conjugate_dual().to_wxyz(), dual);
    assert_eq!(s.conjugate().to_wxyz(), quaternion);
    assert_eq!(s.conjugate_both().to_wxyz(), both);
    assert_eq!(s.conjugate_both(), s.conjugate().conjugate_dual());
}

#[test]
fn eq_16_the_product_with_the_dual_conjugate_is_no_scalar() {
    let [s, _] = whole_numbers();
    let (p, q) = (s.real(), s.dual());
    assert_eq!(s * s.conjugate_dual(), DualQuat::new(p * p, q * p - p * q));
    let wanted = [-28.0, 4.0, 6.0, 8.0, 0.0, 8.0, -16.0, 8.0];
    assert_eq!((s * s.conjugate_dual()).to_wxyz(), wanted);
}

#[test]
fn eq_18_the_product_with_the_quaternion_conjugate_is_a_dual_number() {
    let [s, _] = whole_numbers();
    // 30 = 1 + 4 + 9 + 16, 70 = 5 + 12 + 21 + 32
    let wanted = [30.0, 0.0, 0.0, 0.0, 2.0 * 70.0, 0.0, 0.0, 0.0];
    assert_eq!((s * s.conjugate()).to_wxyz(), wanted);
    let root = 30.0_f64.sqrt();
    assert_close([s.norm().real, s.norm().dual], [root, 70.0 / root], 1e-14);
}

#[test]
fn eq_19_the_product_with_both_conjugates_is_a_scalar_and_a_dual_vector() {
    let [s, _] = whole_numbers();
    let wanted = [30.0, 0.0, 0.0, 0.0, 0.0, -16.0, 0.0, -32.0];
    assert_eq!((s * s.conjugate_both()).to_wxyz(), wanted);
}

#[test]
fn section_5_conjugates_of_a_product_and_of_a_conjugate() {
    let [a, b] = whole_numbers();
    assert_eq!((a * b).conjugate_dual(), a.conjugate_dual() * b.conjugate_dual());
    assert_eq!((a * b).conjugate(), b.conjugate() * a.conjugate());
    assert_eq!((a * b).conjugate_both(), b.conjugate_both() * a.conjugate_both());
    assert_eq!(a.conjugate_dual().conjugate_dual(), a);
    assert_eq!(a.conjugate().conjugate(), a);
    assert_eq!(a.conjugate_both().conjugate_both(), a);
    // "The product of the individual conjugates in the reverse order" is not so for the first one.
    assert_ne!((a * b).conjugate_dual(), b.conjugate_dual() * a.conjugate_dual());
}

#[test]
fn eqs_20_and_21_a_displacement_is_unit_and_its_inverse_the_conjugate() {
    for s in motions() {
        assert_close([s.real().norm(), s.real().dot(s.dual())], [1.0, 0.0], 1e-15);
        assert_close((s * s.conjugate()).to_array(), DualQuat::IDENTITY.to_array(), 1e-15);
        assert_close(s.inverse().to_array(), s.conjugate().to_array(), 1e-15);
    }
}

/// Both conditions' gradients, (2p, 0) and (q, p), are independent wherever p is not 0:
/// 8 − 2 = 6. The six twists span what they leave.
#[test]
fn section_6_unit_dual_quaternions_have_six_degrees_of_freedom() {
    for s in motions() {
        let conditions = [(s.real().scale(2.0), Quat::ZERO), (s.dual(), s.real())];
        let gradients = SMatrix::<f64, 8, 2>::from_fn(|component, i| {
            let (p, q) = conditions[i];
            DualQuat::new(p, q).to_array()[component]
        });
        assert_eq!(gradients.rank(0.1), 2);
        let tangents = SMatrix::<f64, 8, 6>::from_fn(|component, i| {
            let twist = Twist::from_array(core::array::from_fn(|j| f64::from(u8::from(i == j))));
            s.derivative_spatial(twist).to_array()[component]
        });
        assert_eq!(tangents.rank(0.1), 6);
        assert!((gradients.transpose() * tangents).amax() < 1e-15);
    }
}

#[test]
fn section_4_the_inverse_of_what_is_not_unit() {
    let [s, _] = whole_numbers();
    let p_inverse = s.real().conjugate().scale(1.0 / 30.0);
    let formula = DualQuat::new(p_inverse, -(p_inverse * s.dual() * p_inverse));
    assert_close(s.inverse().to_array(), formula.to_array(), 1e-16);
    assert_close((s * s.inverse()).to_array(), DualQuat::IDENTITY.to_array(), 1e-15);
}

#[test]
fn eq_22_the_dual_part_written_out() {
    let (u, theta, t) = ([2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0], 1.1_f64, [1.0, -2.0, 0.5]);
    let (sin, cos) = (theta / 2.0).sin_cos();
    let vector = add(t.map(|c| cos * c), cross(t, u).map(|c| sin * c));
    let dual = Quat::from_parts(vector, -sin * dot(t, u)).scale(0.5);
    let s = DualQuat::from_rotation_translation(Quat::from_axis_angle(u, theta), t);
    assert_close(s.dual().to_array(), dual.to_array(), 1e-15);
    // Eqs. 23 and 24 give both back.
    assert_eq!(s.rotation(), Quat::from_axis_angle(u, theta));
    assert_close(s.translation(), t, 1e-15);
}

#[test]
fn example_1_a_third_of_a_turn_about_111_then_up_by_b() {
    let r = third_turn();
    let computed = Quat::from_axis_angle([1.0 / 3.0_f64.sqrt(); 3], core::f64::consts::TAU / 3.0);
    assert_close(computed.to_array(), r.to_array(), 1e-15);
    for (a, b) in [(2.0, 5.0), (-3.0, 0.25), (4.0, -7.0), (0.0, 1.0)] {
        let v = [a, 0.0, 0.0];
        // a/4 (−1 + i + j − k)(1 − i − j − k) = aj
        assert_eq!(r * pure(v), quat(-1.0, 1.0, 1.0, -1.0).scale(a / 2.0));
        assert_eq!(r * pure(v) * r.conjugate(), pure([0.0, a, 0.0]));
        let s = DualQuat::from_rotation_translation(r, [0.0, 0.0, b]);
        // Eq. 25, both as the product and as the method.
        assert_eq!(s * point(v) * s.conjugate_both(), point([0.0, a, b]));
        assert_eq!(s.transform_point(v), [0.0, a, b]);
    }
}

#[test]
fn eqs_26_and_27_translating_first_and_rotating_then_gives_r_of_v_plus_t() {
    let (r, t, v) = (third_turn(), [0.0, 0.0, 5.0], [2.0, 0.0, 0.0]);
    let zeta = DualQuat::from_translation_rotation(t, r);
    assert_eq!(zeta, DualQuat::new(r, (r * pure(t)).scale(0.5)));
    // (2,0,5) turned: x to y, z to x.
    assert_eq!(zeta.transform_point(v), [5.0, 2.0, 0.0]);
    assert_eq!(zeta * point(v) * zeta.conjugate_both(), point([5.0, 2.0, 0.0]));
    assert_eq!(zeta.translation(), r.rotate(t));
    let sigma = DualQuat::from_rotation_translation(r, t);
    assert_far(zeta.transform_point(v), sigma.transform_point(v));
}

#[test]
fn eq_28_the_inverse_undoes_in_the_other_order() {
    let (r, t) = (third_turn(), [1.0, -2.0, 4.0]);
    let back = t.map(|c: f64| -c);
    let sigma = DualQuat::from_rotation_translation(r, t);
    let zeta = DualQuat::from_translation_rotation(t, r);
    assert_eq!(sigma.conjugate(), DualQuat::from_translation_rotation(back, r.conjugate()));
    assert_eq!(zeta.conjugate(), DualQuat::from_rotation_translation(r.conjugate(), back));
}

#[test]
fn section_7_a_sequence_of_motions_is_their_product_the_first_on_the_right() {
    let [a, b] = motions();
    let v = [0.3, -0.4, 1.5];
    assert_close((b * a).transform_point(v), b.transform_point(a.transform_point(v)), 1e-15);
    assert_far((a * b).transform_point(v), (b * a).transform_point(v));
    // σ = (1 + ½εt) r
    let split = DualQuat::from_translation(a.translation()) * DualQuat::from_rotation(a.rotation());
    assert_close(split.to_array(), a.to_array(), 1e-15);
}
