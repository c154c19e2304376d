//! A. Fabisch, *Normalizing Dual Quaternions*: his vector, his numbers, his four mistakes.

use crate::{assert_close, assert_far, length};
use dq8::{Dual, DualQuat, Quat};
use lab::fabisch::{
    by_the_real_norm_alone, only_the_real_part, squared_norm, with_the_updated_real_part,
    without_the_root,
};

/// The article prints eight digits after the point.
const PRINTED: f64 = 1e-8;

/// In [3]: eight random numbers.
fn sigma() -> DualQuat<f64> {
    DualQuat::from_wxyz([
        0.30471708,
        -1.03998411,
        0.7504512,
        0.94056472,
        -1.95103519,
        -1.30217951,
        0.1278404,
        -0.31624259,
    ])
}

/// Out [8], [10] and [14].
const UNIT: [f64; 8] = [
    0.18817376,
    -0.64222759,
    0.4634306,
    0.58083254,
    -1.24489263,
    -0.66742595,
    -0.01970857,
    -0.31893819,
];

#[test]
fn out_4_and_5_the_squared_norm_is_a_dual_number() {
    let product = sigma() * sigma().conjugate();
    let [s, _, _, _, t, ..] = product.to_wxyz();
    assert_close([s, t], [2.62225842, 1.11644721], 3.0 * PRINTED);
    // The vector parts cancel.
    assert_close(product.real().xyz(), [0.0; 3], 1e-15);
    assert_close(product.dual().xyz(), [0.0; 3], 1e-15);
    let simplified = squared_norm(sigma());
    assert_close([s, t], [simplified.real, simplified.dual], 1e-15);
    // dq8's norm is its root.
    let norm = sigma().norm() * sigma().norm();
    assert_close([norm.real, norm.dual], [s, t], 1e-15);
}

#[test]
fn the_inverse_root_of_a_dual_number_has_the_dual_part_minus_t_over_2_s_to_the_three_halves() {
    let squared = squared_norm(sigma());
    let u = 1.0 / squared.real.sqrt();
    let inverse_root = Dual::ONE / squared.sqrt();
    assert_close(
        [inverse_root.real, inverse_root.dual],
        [u, -0.5 * squared.dual * u.powi(3)],
        1e-15,
    );
    let one = inverse_root * inverse_root * squared;
    assert_close([one.real, one.dual], [1.0, 0.0], 1e-15);
}

/// u = ±1/√s and v = −½ t/(±√s)³.
#[test]
fn the_other_inverse_root_of_a_dual_number_is_its_negative() {
    let squared = squared_norm(sigma());
    for root in [squared.real.sqrt(), -squared.real.sqrt()] {
        let inverse = Dual::new(1.0 / root, -0.5 * squared.dual / root.powi(3));
        let one = inverse * inverse * squared;
        assert_close([one.real, one.dual], [1.0, 0.0], 1e-15);
    }
}

/// He prints p₁q₂ + p₂q₁. Quaternions do not commute: it is p₁q₂ + q₁p₂, as his
/// norm has it.
#[test]
fn dual_quaternion_product_erratum_the_dual_part_keeps_the_order_of_its_factors() {
    let other = DualQuat::from_wxyz([0.5, -1.0, 2.0, 0.25, 1.5, 0.75, -0.5, 1.0]);
    let ([p1, p2], [q1, q2]) =
        ([sigma(), other].map(DualQuat::real), [sigma(), other].map(DualQuat::dual));
    let product = (sigma() * other).dual();
    assert_close(product.to_array(), (p1 * q2 + q1 * p2).to_array(), 1e-15);
    assert_far(product.to_array(), (p1 * q2 + p2 * q1).to_array());
}

/// Step two takes from q its projection on p. It changes the real part of 2qp* alone, so the
/// translation was right before.
#[test]
fn geometrical_interpretation_step_two_removes_a_projection_and_keeps_the_translation() {
    let one_step = sigma().scale(1.0 / sigma().real().norm());
    let (p, q) = (one_step.real(), one_step.dual());
    let removed = q - sigma().normalize().dual();
    assert_close(removed.to_array(), p.scale(p.dot(q)).to_array(), 1e-15);
    assert_close([sigma().normalize().dual().dot(p)], [0.0], 1e-15);
    let twice = [q, q - removed].map(|q| (q * p.conjugate()).scale(2.0));
    assert_close(twice[0].xyz(), twice[1].xyz(), 1e-15);
    assert_close(twice[0].xyz(), sigma().normalize().transform_point([0.0; 3]), 1e-14);
    assert_close([twice[0].w(), twice[1].w()], [2.0 * p.dot(q), 0.0], 1e-15);
}

#[test]
fn out_8_the_direct_normalization() {
    let direct = sigma().scale_dual(Dual::ONE / squared_norm(sigma()).sqrt());
    assert_close(direct.to_wxyz(), UNIT, 3.0 * PRINTED);
    assert_close(direct.to_array(), sigma().normalize().to_array(), 1e-15);
    assert!(direct.is_normalized());
}

#[test]
fn out_14_the_normalization_in_two_steps() {
    let mut p = sigma().real();
    let mut q = sigma().dual();
    let norm = p.norm();
    p = p.scale(1.0 / norm);
    q = q.scale(1.0 / norm);
    q = q - p.scale(p.dot(q));
    assert_close(DualQuat::new(p, q).to_wxyz(), UNIT, 3.0 * PRINTED);
    assert_close(DualQuat::new(p, q).to_array(), sigma().normalize().to_array(), 1e-15);
}

#[test]
fn side_note_two_solutions_the_other_sign_is_the_same_motion() {
    let (plus, minus) = (sigma().normalize(), (-sigma()).normalize());
    assert_eq!(minus, -plus);
    let v = [1.0, 2.0, 3.0];
    assert_close(plus.transform_point(v), minus.transform_point(v), 1e-15);
}

/// He proposes p = 1 and omits it. A motion made up from nothing would hide the fault, so here it
/// is an error from the checked call and NaN, as in his Out [12], from the other.
#[test]
fn out_12_the_edge_case_p_is_zero_is_an_error() {
    let only_dual = DualQuat::new(Quat::ZERO, sigma().dual());
    for degenerate in [DualQuat::ZERO, only_dual] {
        let error = degenerate.try_normalize().unwrap_err();
        assert_eq!(error.real_norm, 0.0);
        assert!(error.to_string().ends_with("is 0"), "{error}");
        assert!(degenerate.normalize().to_array().iter().all(|c| c.is_nan()));
    }
}

#[test]
fn mistake_1_dividing_by_the_real_norm_alone_leaves_the_dual_part_of_the_norm() {
    let wrong = by_the_real_norm_alone(sigma());
    let squared = squared_norm(wrong);
    assert_close([squared.real, squared.dual], [1.0, 1.11644721 / 2.62225842], 3.0 * PRINTED);
    assert!(!wrong.is_unit(0.1));
    assert_far(wrong.to_wxyz(), UNIT);
}

#[test]
fn mistake_2_dividing_only_the_real_part_makes_the_translation_too_long() {
    let norm = sigma().real().norm();
    let wrong = only_the_real_part(sigma());
    assert!(!wrong.is_unit(0.1));
    // Orthogonal or not, the translation is too long by the norm that was forgotten.
    let right = sigma().normalize().translation();
    assert_close([length(wrong.translation())], [norm * length(right)], 1e-14);
    assert_far(wrong.translation(), right);
}

#[test]
fn mistake_3_without_the_square_root_the_norm_becomes_its_own_inverse() {
    let squared = squared_norm(sigma());
    let wrong = without_the_root(sigma());
    assert_close([wrong.real().norm()], [1.0 / squared.real.sqrt()], 1e-15);
    assert!(!wrong.is_unit(0.1));
}

#[test]
fn mistake_4_the_updated_real_part_in_the_direct_solution_is_not_orthogonal() {
    let (p, q) = (sigma().real(), sigma().dual());
    let u = 1.0 / p.norm();
    let v = -p.dot(q) * u.powi(3);
    let updated = p.scale(u);
    let right = DualQuat::new(updated, q.scale(u) + p.scale(v));
    let wrong = with_the_updated_real_part(sigma());
    assert_close(right.to_wxyz(), UNIT, 3.0 * PRINTED);
    assert_close([updated.dot(wrong.dual())], [u * u * p.dot(q) * (1.0 - u)], 1e-15);
    assert!(!wrong.is_unit(0.03));
}
