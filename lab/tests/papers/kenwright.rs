//! B. Kenwright, *A Beginners Guide to Dual-Quaternions*: dual numbers, the class of its appendix.

use crate::{assert_close, assert_far, motions, point, pure, quat, third_turn, whole_numbers};
use dq8::{Dual, DualQuat, Quat};

#[test]
fn section_5_1_dual_number_arithmetic() {
    let (a, b) = (Dual::new(3.0, 4.0), Dual::new(2.0, 5.0));
    assert_eq!(a + b, Dual::new(5.0, 9.0));
    assert_eq!(a * b, Dual::new(6.0, 3.0 * 5.0 + 2.0 * 4.0));
    // r_A/r_B + ε (r_B d_A − r_A d_B)/r_B²
    assert_eq!(a / b, Dual::new(1.5, (2.0 * 4.0 - 3.0 * 5.0) / 4.0));
    assert_eq!((a / b) * b, a);
}

/// He is silent on r_B = 0, where εd has no inverse: no number times ε gives 1.
#[test]
fn section_5_1_there_is_no_quotient_by_a_number_without_real_part() {
    for divisor in [Dual::new(0.0_f64, 5.0), Dual::ZERO, Dual::new(-0.0, 1.0)] {
        assert_eq!(divisor.inverse().unwrap_err().real_norm, 0.0);
        let quotient = Dual::new(3.0, 4.0) / divisor;
        assert!(!quotient.real.is_finite() && !quotient.dual.is_finite());
    }
    assert!(Dual::new(f64::INFINITY, 1.0).inverse().is_err());
    assert!(Dual::new(f64::NAN, 1.0).inverse().is_err());
}

#[test]
fn section_6_the_products_of_the_units() {
    let one = Quat::IDENTITY;
    let [i, j, k] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(pure);
    assert_eq!([i * i, j * j, k * k], [-one; 3]);
    assert_eq!([i * j, j * k, k * i], [k, i, j]);
    assert_eq!([j * i, k * j, i * k], [-k, -i, -j]);
}

/// §6.1 and §7.1 call qq* itself the magnitude; it is the square of it.
#[test]
fn section_6_1_erratum_the_product_with_the_conjugate_is_the_squared_magnitude() {
    let q = quat(0.0, 3.0, 4.0, 0.0);
    assert_eq!((q * q.conjugate()).w(), 25.0);
    assert_eq!(q.norm(), 5.0);
}

#[test]
fn section_7_1_rotation_then_translation_is_the_product_of_both() {
    let [s, _] = motions();
    let (r, t) = (s.rotation(), s.translation());
    let product = DualQuat::from_translation(t) * DualQuat::from_rotation(r);
    assert_close(product.to_array(), s.to_array(), 1e-15);
    // §8: Q_d = ½ (0, t) r, and t = 2 Q_d Q_r* back.
    assert_close(s.dual().to_array(), (pure(t).scale(0.5) * r).to_array(), 1e-15);
    assert_close((s.dual().scale(2.0) * r.conjugate()).xyz(), t, 1e-15);
    // And of parts that are known.
    let (turn, shift) = (third_turn(), [4.0, -2.0, 6.0]);
    let known = DualQuat::from_rotation_translation(turn, shift);
    assert_eq!(known.dual(), pure([2.0, -1.0, 3.0]) * turn);
    assert_eq!(known.transform_point([1.0, 0.0, 0.0]), [4.0, -1.0, 6.0]);
    // The unit conditions, ‖q‖ = 1 and q_r* q_d + q_d* q_r = 0.
    assert_close([s.norm().real, s.norm().dual], [1.0, 0.0], 1e-15);
    let zero = s.real().conjugate() * s.dual() + s.dual().conjugate() * s.real();
    assert_close(zero.to_array(), [0.0; 4], 1e-15);
}

/// p′ = qpq* with the conjugate of §7.1 leaves a translated point where it was.
#[test]
fn section_7_1_erratum_points_need_the_conjugate_of_both() {
    let v = [3.0, 1.0, -1.0];
    let shift = DualQuat::from_translation([10.0, 30.0, 90.0]);
    assert_eq!(shift * point(v) * shift.conjugate(), point(v));
    assert_eq!(shift * point(v) * shift.conjugate_both(), point([13.0, 31.0, 89.0]));
    assert_eq!(shift.transform_point(v), [13.0, 31.0, 89.0]);
}

type Matrix = [[f64; 4]; 4];

fn product(a: Matrix, b: Matrix) -> Matrix {
    let entry = |i: usize, j: usize| (0..4).map(|k| a[i][k] * b[k][j]).sum();
    core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)))
}

/// The matrices X, Y and Z of §3.3, each behind the one before: `CreateFromYawPitchRoll` rolls
/// about z first, then pitches about x, then yaws about y; the translation comes last.
fn xna_matrix([yaw, pitch, roll]: [f64; 3], [tx, ty, tz]: [f64; 3]) -> Matrix {
    let ((sx, cx), (sy, cy), (sz, cz)) = (pitch.sin_cos(), yaw.sin_cos(), roll.sin_cos());
    let last = [0.0, 0.0, 0.0, 1.0];
    let x = [[1.0, 0.0, 0.0, 0.0], [0.0, cx, -sx, 0.0], [0.0, sx, cx, 0.0], last];
    let y = [[cy, 0.0, sy, 0.0], [0.0, 1.0, 0.0, 0.0], [-sy, 0.0, cy, 0.0], last];
    let z = [[cz, -sz, 0.0, 0.0], [sz, cz, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], last];
    let t = [[1.0, 0.0, 0.0, tx], [0.0, 1.0, 0.0, ty], [0.0, 0.0, 1.0, tz], last];
    product(t, product(y, product(x, z)))
}

fn xna_motion([yaw, pitch, roll]: [f64; 3], translation: [f64; 3]) -> DualQuat<f64> {
    let turn = Quat::from_axis_angle([0.0, 1.0, 0.0], yaw)
        * Quat::from_axis_angle([1.0, 0.0, 0.0], pitch)
        * Quat::from_axis_angle([0.0, 0.0, 1.0], roll);
    DualQuat::from_rotation_translation(turn, translation)
}

const SIMPLE_TEST: [([f64; 3], [f64; 3]); 3] = [
    ([1.0, 2.0, 3.0], [10.0, 30.0, 90.0]),
    ([-1.0, 3.0, 2.0], [30.0, 40.0, 190.0]),
    ([2.0, 3.0, 1.5], [5.0, 20.0, 66.0]),
];

/// "Multiplication order - left to right": his `lhs * rhs` lets `lhs` act first.
fn left_to_right(lhs: DualQuat<f64>, rhs: DualQuat<f64>) -> DualQuat<f64> {
    DualQuat::new(rhs.real() * lhs.real(), rhs.dual() * lhs.real() + rhs.real() * lhs.dual())
}

#[test]
fn appendix_simple_test_in_our_order_is_the_product_of_the_matrices() {
    let [dq0, dq1, dq2] = SIMPLE_TEST.map(|(turn, shift)| xna_motion(turn, shift));
    let [m0, m1, m2] = SIMPLE_TEST.map(|(turn, shift)| xna_matrix(turn, shift));
    // His dq0 * dq1 * dq2 lets dq0 act first; ours is written from right to left, like matrices on
    // column vectors.
    let ours = dq2 * (dq1 * dq0);
    let matrix = product(m2, product(m1, m0));
    assert_eq!(left_to_right(left_to_right(dq0, dq1), dq2), ours);
    let rows = ours.to_matrix4();
    (0..4).for_each(|row| assert_close(rows[row], matrix[row], 1e-12));
    let back = DualQuat::try_from_matrix4(matrix, 1e-12).unwrap();
    assert_close(back.to_array(), ours.canonical().to_array(), 1e-12);
    // Left as he writes it, it is another motion.
    assert_far((dq0 * dq1 * dq2).translation(), ours.translation());
}

/// His matrix has rows where ours has columns: it acts on row vectors.
#[test]
fn appendix_dual_quaternion_to_matrix_is_the_transpose_of_ours() {
    let s = xna_motion([1.0, 2.0, 3.0], [10.0, 30.0, 90.0]);
    let [w, x, y, z] = s.real().to_wxyz();
    let [tx, ty, tz] = s.translation();
    let his = [
        [w * w + x * x - y * y - z * z, 2.0 * (x * y + w * z), 2.0 * (x * z - w * y), 0.0],
        [2.0 * (x * y - w * z), w * w + y * y - x * x - z * z, 2.0 * (y * z + w * x), 0.0],
        [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), w * w + z * z - x * x - y * y, 0.0],
        [tx, ty, tz, 1.0],
    ];
    let ours = s.to_matrix4();
    (0..4).for_each(|row| assert_close(his.map(|his| his[row]), ours[row], 1e-15));
}

/// `Normalize` divides by Dot(real, real), which is the square of the norm, and leaves p·q alone.
#[test]
fn appendix_erratum_normalize_is_wrong_by_a_square_root() {
    let his = |q: DualQuat<f64>| q.scale(1.0 / q.real().dot(q.real()));
    let [unit, _] = motions();
    for factor in [2.0, 0.5, 10.0] {
        let long = unit.scale(factor);
        assert_close([his(long).real().norm()], [1.0 / factor], 1e-15);
        assert!(!his(long).is_unit(0.1));
        assert_close(long.normalize().to_array(), unit.to_array(), 1e-15);
    }
    // A real part of norm 1 he leaves alone, whatever the dual part.
    let slanted = unit.scale_dual(Dual::new(1.0, 0.3));
    assert_close([his(slanted).real().dot(his(slanted).dual())], [0.3], 1e-15);
    assert_close(slanted.normalize().to_array(), unit.to_array(), 1e-15);
}

/// `DualQuaternion_c(r, d)` normalizes r and keeps d.
#[test]
fn appendix_erratum_the_constructor_must_divide_the_dual_part_too() {
    let [unit, _] = motions();
    let (r, d) = (unit.real().scale(2.0), unit.dual().scale(2.0));
    let his = lab::kenwright::constructor(r, d);
    assert_close(his.translation(), unit.translation().map(|c| 2.0 * c), 1e-15);
    assert_close(DualQuat::new(r, d).normalize().translation(), unit.translation(), 1e-15);
}

#[test]
fn appendix_dot_is_the_real_part_of_the_dual_dot() {
    let [a, b] = whole_numbers();
    assert_eq!(a.dot(b).real, a.real().dot(b.real()));
}

/// §11 counts 42 multiplications and 38 additions. Three quaternion products of 16 and 12, and a
/// sum:
#[test]
fn section_11_erratum_a_product_takes_48_multiplications_and_40_additions() {
    /// e_i e_j = ±e_k over 1, i, j, k: k and the sign.
    const UNITS: [[(usize, f64); 4]; 4] = [
        [(0, 1.0), (1, 1.0), (2, 1.0), (3, 1.0)],
        [(1, 1.0), (0, -1.0), (3, 1.0), (2, -1.0)],
        [(2, 1.0), (3, -1.0), (0, -1.0), (1, 1.0)],
        [(3, 1.0), (2, 1.0), (1, -1.0), (0, -1.0)],
    ];
    let (mut multiplications, mut additions) = (0, 0);
    // Adds the product of two quaternions to `sum`, where a component starts as nothing.
    let mut multiply_add = |a: [f64; 4], b: [f64; 4], sum: &mut [Option<f64>; 4]| {
        for (a, units) in a.into_iter().zip(UNITS) {
            for (b, (k, sign)) in b.into_iter().zip(units) {
                multiplications += 1;
                additions += u32::from(sum[k].is_some());
                sum[k] = Some(sum[k].unwrap_or(0.0) + sign * a * b);
            }
        }
    };
    let [a, b] = whole_numbers();
    let (mut real, mut dual) = ([None; 4], [None; 4]);
    multiply_add(a.real().to_wxyz(), b.real().to_wxyz(), &mut real);
    multiply_add(a.real().to_wxyz(), b.dual().to_wxyz(), &mut dual);
    multiply_add(a.dual().to_wxyz(), b.real().to_wxyz(), &mut dual);
    assert_eq!((multiplications, additions), (48, 40));
    assert_eq!((a * b).real().to_wxyz().map(Some), real);
    assert_eq!((a * b).dual().to_wxyz().map(Some), dual);
}
