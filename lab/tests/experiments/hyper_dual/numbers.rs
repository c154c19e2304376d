//! Arends, chapter 5, §1: what he says of hyper-dual numbers, and what he leaves out.

use super::{Number, invertible};
use crate::inputs::{assert_close, reals};
use dq8::Real as _;
use lab::{hyper_dual, hyper_dual_parts as parts};
use proptest::prelude::*;

const EPSILON_1: Number = hyper_dual(0.0, 1.0, 0.0, 0.0);
const EPSILON_2: Number = hyper_dual(0.0, 0.0, 1.0, 0.0);
const EPSILON_12: Number = hyper_dual(0.0, 0.0, 0.0, 1.0);

fn any_number() -> impl Strategy<Value = Number> {
    reals(2.0).prop_map(|[a, b, c, d]| hyper_dual(a, b, c, d))
}

#[test]
fn section_1_the_squares_of_both_units_and_of_their_product_vanish() {
    for unit in [EPSILON_1, EPSILON_2, EPSILON_12] {
        assert_eq!(unit * unit, Number::ZERO);
    }
}

#[test]
fn section_1_the_units_are_not_equal_and_their_product_does_not_vanish() {
    assert_ne!(EPSILON_1, EPSILON_2);
    assert_eq!(EPSILON_1 * EPSILON_2, EPSILON_12);
    assert_eq!(EPSILON_2 * EPSILON_1, EPSILON_12);
    assert_ne!(EPSILON_12, Number::ZERO);
}

#[test]
fn section_1_zero_divisors_are_the_numbers_without_real_part() {
    let [x, y] = [hyper_dual(0.0, 2.0, 3.0, 5.0), hyper_dual(0.0, 2.0, -3.0, 7.0)];
    // (2ε₁ + 3ε₂)(2ε₁ − 3ε₂) = 0, and all of them with ε₁ε₂.
    assert_eq!(x * y, Number::ZERO);
    assert_eq!(x * EPSILON_12, Number::ZERO);
}

#[test]
fn section_1_the_inverse_does_not_exist_without_a_finite_real_part() {
    for real in [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let x = hyper_dual(real, 1.0, 1.0, 1.0);
        assert_ne!(x * x.recip(), Number::ONE, "{real}");
    }
    let small = Number::from_f64(f64::MIN_POSITIVE);
    assert_eq!(small * small.recip(), Number::ONE);
}

proptest! {
    #[test]
    fn section_1_addition_and_multiplication_commute(x in any_number(), y in any_number()) {
        prop_assert_eq!(x + y, y + x);
        assert_close(parts(x * y), parts(y * x), 4e-15);
    }

    #[test]
    fn section_1_multiplication_is_associative_and_distributes(
        x in any_number(), y in any_number(), z in any_number(),
    ) {
        assert_close(parts((x * y) * z), parts(x * (y * z)), 3e-14);
        assert_close(parts(x * (y + z)), parts(x * y + x * z), 1e-14);
    }

    #[test]
    fn section_1_the_printed_product_is_the_product(x in any_number(), y in any_number()) {
        let ([a, b, c, d], [e, f, g, h]) = (parts(x), parts(y));
        let printed = [a * e, a * f + b * e, a * g + c * e, a * h + b * g + c * f + d * e];
        assert_close(parts(x * y), printed, 4e-15);
    }

    #[test]
    fn section_1_the_printed_inverse_is_the_inverse(x in invertible()) {
        let [a, b, c, d] = parts(x);
        let squared = a * a;
        let mixed = 2.0 * b * c / (squared * a) - d / squared;
        let printed = hyper_dual(1.0 / a, -b / squared, -c / squared, mixed);
        // Of the largest part: a seed with b/a² = 12 was off by more than 10⁻¹⁵ of the
        // others.
        let singles = (b / squared).abs().max((c / squared).abs());
        let size = 1.0 + singles + mixed.abs() + (b * c / (squared * a)).abs();
        assert_close(parts(x.recip()), parts(printed), 1e-15 * size);
        assert_close(parts(x * printed), [1.0, 0.0, 0.0, 0.0], 4e-15 * size);
    }

    #[test]
    fn a_quotient_times_its_divisor_is_the_dividend(x in any_number(), y in invertible()) {
        let quotient = x / y;
        let size = parts(quotient).into_iter().fold(1.0, |size: f64, c| size.max(c.abs()));
        assert_close(parts(quotient * y), parts(x), 4e-15 * size);
    }
}
