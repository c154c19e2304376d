//! The third opinion on Jacobians: an integral, and Barfoot's closed form in 3×3 matrices. Neither
//! knows dual numbers.

use dq8::{DualQuat, Twist};
use dq8_contract::bound::unit_roundoff;
use dq8_contract::inputs::twist_case as case;
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::random::Random;
use dq8_contract::scale::jacobian;

type Matrix = [[f64; 3]; 3];

const UNIT: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// J_l(x) y = ∫₀¹ Ad_{exp ½sx} y ds (Gauss and Legendre, five points on each of 64 panels).
fn integral(x: Twist<f64>, y: Twist<f64>) -> [f64; 6] {
    const NODES: [(f64, f64); 5] = [
        (0.0, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.906_179_845_938_664, 0.236_926_885_056_189_1),
        (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    ];
    let mut sum = [0.0; 6];
    for panel in 0..64 {
        for (node, weight) in NODES {
            let s = (f64::from(panel) + 0.5 + 0.5 * node) / 64.0;
            let moved = DualQuat::from_twist(x.scale(s)).adjoint(y).to_array();
            for (sum, c) in sum.iter_mut().zip(moved) {
                *sum += c * weight / 128.0;
            }
        }
    }
    sum
}

#[test]
fn the_left_jacobian_is_the_mean_of_the_adjoints_on_the_way() {
    let mut random = Random(1);
    let spread = (1..=90).map(|i| 0.1 * f64::from(i));
    let at_series = [0.0, 1e-9, 1e-4, 0.999_999, 1.0, 1.000_001];
    let lines = &[line(
        "left_jacobian",
        &[],
        13.0,
        "as among the twists, and the sum that the integral is",
    )];
    Ledger::keep("jacobians by an integral", lines, |ledger| {
        for angle in spread.chain(at_series) {
            let case = case(&mut random, angle, 10.0);
            let (x, y) = (Twist::from_array(case.x), Twist::from_array(case.y));
            let scale = jacobian(&case);
            let got = DualQuat::left_jacobian(x, y).to_array();
            for (i, (got, wanted)) in got.into_iter().zip(integral(x, y)).enumerate() {
                let scale = if i < 3 { scale.plain } else { scale.length };
                let units = (got - wanted).abs() / scale / unit_roundoff(false);
                ledger.measure("left_jacobian", "", units, || format!("|ω| = {angle}"));
            }
        }
    });
}

/// Barfoot 2017, eqs. 7.77 and 7.86, in his order of terms but ω before v: [J, 0; Q, J].
fn barfoot(x: Twist<f64>) -> [[f64; 6]; 6] {
    let phi = x.angular.iter().map(|c| c * c).sum::<f64>().sqrt();
    let (sin, cos) = phi.sin_cos();
    let (f, r) = (hat(x.angular), hat(x.linear));
    let turn = sum(&[
        (1.0, UNIT),
        ((1.0 - cos) / phi.powi(2), f),
        ((phi - sin) / phi.powi(3), product(&[f, f])),
    ]);
    let second = (phi - sin) / phi.powi(3);
    let third = (phi * phi + 2.0 * cos - 2.0) / (2.0 * phi.powi(4));
    let fourth = (2.0 * phi - 3.0 * sin + phi * cos) / (2.0 * phi.powi(5));
    let q = sum(&[
        (0.5, r),
        (second, product(&[f, r])),
        (second, product(&[r, f])),
        (second, product(&[f, r, f])),
        (third, product(&[f, f, r])),
        (third, product(&[r, f, f])),
        (-3.0 * third, product(&[f, r, f])),
        (fourth, product(&[f, r, f, f])),
        (fourth, product(&[f, f, r, f])),
    ]);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| match (i / 3, j / 3) {
            (0, 1) => 0.0,
            (1, 0) => q[i % 3][j % 3],
            _ => turn[i % 3][j % 3],
        })
    })
}

fn hat([x, y, z]: [f64; 3]) -> Matrix {
    [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
}

fn product(factors: &[Matrix]) -> Matrix {
    factors.iter().fold(UNIT, |a, b| {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
    })
}

fn sum(terms: &[(f64, Matrix)]) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| terms.iter().map(|(c, m)| c * m[i][j]).sum()))
}

#[test]
fn the_matrix_of_the_left_jacobian_is_that_of_barfoot() {
    let mut random = Random(2);
    let lines = &[line(
        "left_jacobian_matrix",
        &[],
        42.0,
        "his own: coefficients divide small differences by up to φ⁵",
    )];
    Ledger::keep("jacobians by Barfoot", lines, |ledger| {
        for i in 5..=90 {
            let x = Twist::from_array(case(&mut random, 0.1 * f64::from(i), 10.0).x);
            let (got, wanted) = (DualQuat::left_jacobian_matrix(x), barfoot(x));
            for (got, wanted) in got.as_flattened().iter().zip(wanted.as_flattened()) {
                let units = (got - wanted).abs() / unit_roundoff(false);
                ledger.measure("left_jacobian_matrix", "", units, || format!("{x:?}"));
            }
        }
    });
}

#[test]
fn the_matrices_are_inverse_to_each_other() {
    let mut random = Random(3);
    for i in 0..=60 {
        let x = Twist::from_array(case(&mut random, 0.1 * f64::from(i), 10.0).x);
        let (a, b) = (DualQuat::left_jacobian_matrix(x), DualQuat::left_jacobian_inverse_matrix(x));
        for (row, a) in a.iter().enumerate() {
            for column in 0..6 {
                let got: f64 = a.iter().zip(&b).map(|(a, b)| a * b[column]).sum();
                let wanted = if row == column { 1.0 } else { 0.0 };
                // Translations of ten units, and angles up to 6, where the inverse is large.
                assert!((got - wanted).abs() < 1e-11, "{got:e}, not {wanted}, at {x:?}");
            }
        }
    }
}
