//! Where formulas break: no motion, half and whole turns, numbers that are none, and neighbours.

use crate::case::{Arguments, Case, NUMBERS, Random, case, cases};
use crate::operation::answer;
use crate::{names, worst_error};
use dq8::{DualQuat, Twist};
use dq8_contract::for_every_implementation;
use dq8_contract::ledger::Ledger;
use dq8_contract::sample::Sample;
use std::f64::consts::PI;

#[test]
fn jacobians_of_no_twist_change_nothing() {
    for_every_implementation!(|name, M| {
        for tiny in [0.0, -0.0, 5e-324, 1e-45, 1e-300] {
            let mut case = case(&mut Random(1), 1.0, 1.0);
            (case.x, case.y) = ([tiny; 6], [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
            let a = Arguments::<M>::new(&[case]);
            for jacobian in names().filter(|name| name.contains("jacobian")) {
                let got = answer(jacobian, &a).lanes::<M>()[0].clone();
                let got = [got.plain, got.length].concat();
                assert_eq!(got, case.y, "{name}, {jacobian}, {tiny:e}");
            }
        }
    });
}

#[test]
fn jacobians_of_a_pure_translation_are_half_a_product() {
    for_every_implementation!(|name, M| {
        let mut case = case(&mut Random(1), 1.0, 1.0);
        (case.x, case.y) = ([0.0, 0.0, 0.0, 2.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0, 8.0]);
        let a = Arguments::<M>::new(&[case]);
        // v × η = (0, 0, 2)
        for (jacobian, z) in [
            ("left_jacobian", 9.0),
            ("right_jacobian", 7.0),
            ("left_jacobian_inverse", 7.0),
            ("right_jacobian_inverse", 9.0),
        ] {
            let got = answer(jacobian, &a).lanes::<M>()[0].clone();
            assert_eq!(got.plain, [0.0, 1.0, 0.0], "{name}, {jacobian}");
            assert_eq!(got.length, [0.0, 0.0, z], "{name}, {jacobian}");
        }
    });
}

/// A motion that is known to its last place answers to it, however small.
#[test]
fn a_tiny_twist_keeps_its_relative_precision() {
    for_every_implementation!(|name, M| {
        let exponents = if M::SINGLE { 1..38 } else { 1..300 };
        for exponent in exponents {
            let size = 10.0_f64.powi(-exponent);
            let mut case = case(&mut Random(2), 1.0, 1.0);
            case.x = [3.0, -2.0, 1.0, 1.0, 2.0, 3.0].map(|c| c * size);
            let case = case.rounded::<M>();
            let a = Arguments::<M>::new(&[case]);
            let back = M::from_twist(a.x).to_twist().to_array();
            for (got, wanted) in back.into_iter().zip(case.x) {
                let (got, smallest) = (M::lanes(got)[0], if M::SINGLE { 1e-44 } else { 1e-322 });
                let unit = if M::SINGLE { f64::from(f32::EPSILON) } else { f64::EPSILON };
                let close = (got - wanted).abs() <= 4.0 * unit * wanted.abs() + smallest;
                assert!(close, "{name}: {got:e}, not {wanted:e}");
            }
        }
    });
}

/// Beyond a half turn the logarithm takes the other way round; at a half turn either will do.
#[test]
fn the_twist_of_a_motion_goes_the_short_way() {
    for_every_implementation!(|name, M| {
        for beyond in [-1e-3, 1e-3] {
            let mut case = case(&mut Random(3), 1.0, 1.0);
            case.x = [0.0, 0.0, PI + beyond, 0.0, 0.0, 1.0];
            let twist = M::from_twist(Arguments::<M>::new(&[case]).x).to_twist().to_array();
            let wanted = if beyond > 0.0 { beyond - PI } else { PI + beyond };
            let (turn, slide) = (M::lanes(twist[2])[0], M::lanes(twist[5])[0]);
            assert!((turn - wanted).abs() < 1e-6 && (slide - 1.0).abs() < 1e-5, "{name}: {turn}");
        }
    });
}

#[test]
fn the_inverse_jacobians_go_to_infinity_at_whole_turns() {
    for_every_implementation!(|name, M| {
        for turns in [1.0, 2.0] {
            let mut case = case(&mut Random(4), 1.0, 1.0);
            case.x = [2.0 * PI * turns, 0.0, 0.0, 0.0, 0.0, 0.0];
            case.y = [0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
            let a = Arguments::<M>::new(&[case]);
            for jacobian in ["left_jacobian_inverse", "right_jacobian_inverse"] {
                let got = answer(jacobian, &a).lanes::<M>()[0].clone();
                let largest = got.plain.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
                let endless = if M::SINGLE { 1e5 } else { 1e13 };
                assert!(!got.is_finite() || largest > endless, "{name}, {jacobian}: {got:?}");
            }
            // The Jacobians themselves are only singular: across ω nothing is left.
            let got = answer("left_jacobian", &a).lanes::<M>()[0].clone();
            let small = if M::SINGLE { 1e-6 } else { 1e-14 };
            assert!(got.plain.iter().all(|c| c.abs() < small), "{name}: {got:?}");
        }
    });
}

#[test]
fn towards_a_whole_turn_only_the_amplification_grows() {
    let mut random = Random(5);
    let near = |distance: f64, random: &mut Random| case(random, 2.0 * PI - distance, 1.0);
    let single: Vec<_> = (0..40).map(|_| near(0.02, &mut random)).collect();
    let double: Vec<_> =
        (1..40).map(|i| near(10.0_f64.powf(-f64::from(i) / 8.0), &mut random)).collect();
    Ledger::keep("twists near a whole turn", |ledger| {
        for_every_implementation!(|name, M| {
            for jacobian in ["left_jacobian_inverse", "right_jacobian_inverse"] {
                let cases = if M::SINGLE { &single } else { &double };
                let (error, case) = worst_error::<M>(jacobian, cases);
                ledger.measure(jacobian, "", error, || format!("{name}: {case:?}"));
            }
        });
    });
}

/// NaN or an infinity in any place: lanes answer with finite numbers where the scalar path does.
#[test]
fn what_is_no_number_is_passed_on() {
    let ordinary = case(&mut Random(6), 2.0, 1.0);
    for_every_implementation!(|name, M| {
        for place in 0..NUMBERS {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut numbers = ordinary.to_numbers();
                numbers[place] = bad;
                let case = Case::of_numbers(numbers);
                let a = Arguments::<M>::new(&[case]);
                let scalar = Arguments::<DualQuat<f64>>::new(&[case]);
                for operation in names() {
                    let got = answer(operation, &a).lanes::<M>()[0].clone();
                    let wanted = answer(operation, &scalar).lanes::<DualQuat<f64>>()[0].clone();
                    assert_eq!(
                        got.is_finite(),
                        wanted.is_finite(),
                        "{name}, {operation}, {bad} at {place}: {got:?}, scalar {wanted:?}"
                    );
                }
            }
        }
    });
}

/// Twists scaled down to where all is subnormal: every step then rounds to the same last place,
/// however small its operands, and that is all.
#[test]
fn subnormal_numbers_are_numbers() {
    Ledger::keep("subnormal twists", |ledger| {
        for_every_implementation!(|name, M| {
            let size = if M::SINGLE { 1e-39 } else { 1e-309 };
            for seed in 0..20 {
                let mut case = case(&mut Random(seed), 1.0, 1.0);
                for twist in [&mut case.x, &mut case.y, &mut case.wrench] {
                    *twist = twist.map(|c| c * size);
                }
                for operation in names() {
                    let (error, case) = worst_error::<M>(operation, &[case]);
                    let place = || format!("{name}, {operation}: {case:?}");
                    ledger.measure("any", "", error, place);
                }
            }
        });
    });
}

/// The value of a lane does not depend on its neighbours, be they far, infinite or NaN.
#[test]
fn lanes_do_not_see_their_neighbours() {
    let cases = cases();
    let mut strangers = vec![case(&mut Random(7), 50.0, 1e3), case(&mut Random(8), 0.0, 0.0)];
    for bad in [f64::NAN, f64::INFINITY] {
        strangers.push(Case::of_numbers([bad; NUMBERS]));
    }
    for_every_implementation!(|name, M| {
        for (i, &case) in cases.iter().enumerate() {
            let alone = Arguments::<M>::new(&[case]);
            let mut crowd: Vec<_> = strangers.iter().cycle().take(M::LANES).copied().collect();
            // Every lane has its turn.
            let lane = i.checked_rem(crowd.len()).unwrap_or(0);
            crowd[lane] = case;
            let among = Arguments::<M>::new(&crowd);
            for operation in names() {
                let wanted = answer(operation, &alone).lanes::<M>()[0].clone();
                let got = answer(operation, &among).lanes::<M>()[lane].clone();
                let bits =
                    |numbers: &[f64]| numbers.iter().map(|n| n.to_bits()).collect::<Vec<_>>();
                assert_eq!(
                    (bits(&got.plain), bits(&got.length)),
                    (bits(&wanted.plain), bits(&wanted.length)),
                    "{name}, {operation}, lane {lane}, {case:?}"
                );
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
