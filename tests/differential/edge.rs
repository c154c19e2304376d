//! Where formulas break: no motion, half and whole turns, numbers that are all but none.

use dq8::Twist;
use dq8_contract::case::{Arguments, Case};
use dq8_contract::implementation::{On, implementations};
use dq8_contract::inputs::twist_case as case;
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::operation::{Inputs, Operation, Sign};
use dq8_contract::operations::{OPERATIONS, operation};
use dq8_contract::random::Random;
use std::f64::consts::PI;

/// The operations on twists.
fn twists() -> impl Iterator<Item = &'static Operation> {
    let of_twists = |operation: &&Operation| {
        matches!(operation.double(), Some((Inputs::Twists | Inputs::Turns, ..)))
    };
    OPERATIONS.iter().filter(of_twists)
}

/// What the first lane answers.
fn numbers(on: On, operation: &Operation, case: &Case) -> Vec<f64> {
    operation.answer(on, &[*case]).lane(0).0.into_iter().map(|(_, number)| number).collect()
}

fn is_finite(numbers: &[f64]) -> bool {
    numbers.iter().all(|number| number.is_finite())
}

#[test]
fn jacobians_of_no_twist_change_nothing() {
    for on in implementations() {
        for tiny in [0.0, -0.0, 5e-324, 1e-45, 1e-300] {
            let mut case = case(&mut Random(1), 1.0, 1.0);
            (case.x, case.y) = ([tiny; 6], [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
            for jacobian in twists().filter(|operation| operation.name.contains("jacobian")) {
                let got = numbers(on, jacobian, &case);
                assert_eq!(got, case.y, "{on:?}, {}, {tiny:e}", jacobian.name);
            }
        }
    }
}

#[test]
fn jacobians_of_a_pure_translation_are_half_a_product() {
    for on in implementations() {
        let mut case = case(&mut Random(1), 1.0, 1.0);
        (case.x, case.y) = ([0.0, 0.0, 0.0, 2.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0, 8.0]);
        // v × η = (0, 0, 2)
        for (jacobian, z) in [
            ("left_jacobian", 9.0),
            ("right_jacobian", 7.0),
            ("left_jacobian_inverse", 7.0),
            ("right_jacobian_inverse", 9.0),
        ] {
            let got = numbers(on, operation(jacobian), &case);
            assert_eq!(got, [0.0, 1.0, 0.0, 0.0, 0.0, z], "{on:?}, {jacobian}");
        }
    }
}

/// A motion that is known to its last place answers to it, however small.
#[test]
fn a_tiny_twist_keeps_its_relative_precision() {
    for on in implementations() {
        let exponents = if on.single { 1..38 } else { 1..300 };
        for exponent in exponents {
            let size = 10.0_f64.powi(-exponent);
            let mut case = case(&mut Random(2), 1.0, 1.0);
            case.x = [3.0, -2.0, 1.0, 1.0, 2.0, 3.0].map(|c| c * size);
            let case = case.rounded(on);
            let a = Arguments::new(on, &[case]);
            let back = on.from_twist(a.x).to_twist().to_array();
            for (got, wanted) in back.into_iter().zip(case.x) {
                let (got, smallest) = (got.first(), if on.single { 1e-44 } else { 1e-322 });
                let unit = if on.single { f64::from(f32::EPSILON) } else { f64::EPSILON };
                let close = (got - wanted).abs() <= 4.0 * unit * wanted.abs() + smallest;
                assert!(close, "{on:?}: {got:e}, not {wanted:e}");
            }
        }
    }
}

/// Beyond a half turn the logarithm takes the other way round; at a half turn either will do.
#[test]
fn the_twist_of_a_motion_goes_the_short_way() {
    for on in implementations() {
        for beyond in [-1e-3, 1e-3] {
            let mut case = case(&mut Random(3), 1.0, 1.0);
            case.x = [0.0, 0.0, PI + beyond, 0.0, 0.0, 1.0];
            let twist = on.from_twist(Arguments::new(on, &[case]).x).to_twist().to_array();
            let wanted = if beyond > 0.0 { beyond - PI } else { PI + beyond };
            let (turn, slide) = (twist[2].first(), twist[5].first());
            assert!((turn - wanted).abs() < 1e-6 && (slide - 1.0).abs() < 1e-5, "{on:?}: {turn}");
        }
    }
}

#[test]
fn the_inverse_jacobians_go_to_infinity_at_whole_turns() {
    for on in implementations() {
        for turns in [1.0, 2.0] {
            let mut case = case(&mut Random(4), 1.0, 1.0);
            case.x = [2.0 * PI * turns, 0.0, 0.0, 0.0, 0.0, 0.0];
            case.y = [0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
            for jacobian in ["left_jacobian_inverse", "right_jacobian_inverse"] {
                let got = numbers(on, operation(jacobian), &case);
                let largest = got[..3].iter().fold(0.0_f64, |most, c| most.max(c.abs()));
                let endless = if on.single { 1e5 } else { 1e13 };
                assert!(!is_finite(&got) || largest > endless, "{on:?}, {jacobian}: {got:?}");
            }
            // The Jacobians themselves are only singular: across ω nothing is left.
            let got = numbers(on, operation("left_jacobian"), &case);
            let small = if on.single { 1e-6 } else { 1e-14 };
            assert!(got[..3].iter().all(|c| c.abs() < small), "{on:?}: {got:?}");
        }
    }
}

#[test]
fn towards_a_whole_turn_only_the_amplification_grows() {
    let mut random = Random(5);
    let near = |distance: f64, random: &mut Random| case(random, 2.0 * PI - distance, 1.0);
    let single: Vec<_> = (0..40).map(|_| near(0.02, &mut random)).collect();
    let double: Vec<_> =
        (1..40).map(|i| near(10.0_f64.powf(-f64::from(i) / 8.0), &mut random)).collect();
    let why = "what grows is in the scale";
    let inverses = ["left_jacobian_inverse", "right_jacobian_inverse"];
    let lines = inverses.map(|op| line(op, &[], 2.0, why));
    Ledger::keep("twists near a whole turn", &lines, |ledger| {
        for on in implementations() {
            for jacobian in inverses {
                let cases = if on.single { &single } else { &double };
                let (error, case) = operation(jacobian).worst_error(on, Sign::Kept, cases);
                ledger.measure(jacobian, "", error, || format!("{on:?}: {case:?}"));
            }
        }
    });
}

/// Twists scaled down to where all is subnormal: every step then rounds to the same last place,
/// however small its operands, and that is all.
#[test]
fn subnormal_numbers_are_numbers() {
    let why = "every step rounds to the same last place, however small its operands";
    Ledger::keep("subnormal twists", &[line("any", &[], 12.5, why)], |ledger| {
        for on in implementations() {
            let size = if on.single { 1e-39 } else { 1e-309 };
            for seed in 0..20 {
                let mut case = case(&mut Random(seed), 1.0, 1.0);
                for twist in [&mut case.x, &mut case.y, &mut case.wrench] {
                    *twist = twist.map(|c| c * size);
                }
                for operation in twists() {
                    let (error, case) = operation.worst_error(on, Sign::Kept, &[case]);
                    let place = || format!("{on:?}, {}: {case:?}", operation.name);
                    ledger.measure("any", "", error, place);
                }
            }
        }
    });
}

#[test]
fn twists_are_vectors() {
    let (a, b) = ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0], [6.0, 5.0, 4.0, 3.0, 2.0, 1.5]);
    let (x, y) = (Twist::from_array(a), Twist::from_array(b));
    assert_eq!((x.angular, x.linear), ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]));
    assert_eq!((x + y).to_array(), [7.0, 7.0, 7.0, 7.0, 7.0, 7.5]);
    assert_eq!((x - y).to_array(), [-5.0, -3.0, -1.0, 1.0, 3.0, 4.5]);
    assert_eq!((-x).to_array(), a.map(|c| -c));
    assert_eq!(x.scale(2.0).to_array(), a.map(|c| 2.0 * c));
}
