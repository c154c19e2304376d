//! Infinities and NaN in one number of an argument, and finite numbers in all others.

use dq8_contract::case::Case;
use dq8_contract::implementation::{On, implementations};
use dq8_contract::inputs::{turn_and_move, twist_case};
use dq8_contract::operation::{Domain, Operation};
use dq8_contract::operations::OPERATIONS;
use dq8_contract::random::{Random, bits};

/// What each lane answers: the bits of its numbers, whether all of them are finite, and its truth
/// values.
fn said(
    operation: &Operation,
    on: On,
    lanes: &[&Vec<Vec<f64>>],
) -> Vec<(Vec<u64>, bool, Vec<bool>)> {
    let answer = operation.answer_given(on, lanes);
    let lane = |lane| {
        let (numbers, truths) = answer.lane(lane);
        let numbers = numbers.into_iter().map(|(_, number)| number);
        (numbers.clone().map(bits).collect(), numbers.clone().all(f64::is_finite), truths)
    };
    (0..on.lanes).map(lane).collect()
}

/// Every number of every argument of every operation, spoilt in lane 0 where the others hold the
/// case as it was.
#[test]
fn no_operation_answers_what_is_no_number_with_finite_numbers_or_in_another_lane() {
    let ordinary = twist_case(&mut Random(6), 2.0, 1.0);
    // A turn, a half turn, a translation, and nothing at all.
    let half_turn = turn_and_move([0.0, 0.0, 1.0], std::f64::consts::PI, [1.0, 0.0, 2.0]);
    let translation = [0.0, 0.0, 0.0, 1.0, 1.0, -2.0, 0.5, 0.0];
    let identity = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    let cases = [ordinary.a, half_turn, translation, identity].map(|a| Case { a, ..ordinary });
    for on in implementations() {
        for (operation, case) in OPERATIONS.iter().flat_map(|each| cases.map(|case| (each, case))) {
            let given = operation.given(on, &case);
            let untouched = said(operation, on, &vec![&given; on.lanes]);
            let places = given.iter().enumerate();
            for (place, number) in places.flat_map(|(i, all)| (0..all.len()).map(move |n| (i, n))) {
                let of_motion = operation.arguments[place].domain != Domain::Other;
                if operation.name == "dib" && !of_motion {
                    // How long to try is one number for all lanes.
                    continue;
                }
                for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                    let mut spoilt = given.clone();
                    spoilt[place][number] = value;
                    let mut lanes = vec![&given; on.lanes];
                    lanes[0] = &spoilt;
                    let got = said(operation, on, &lanes);
                    let name = operation.name;
                    let what = || format!("{on:?}, {name}: {value} in {place}, {number}, {case:?}");
                    assert_eq!(got[1..], untouched[1..], "{}", what());
                    let (numbers, finite, truths) = &got[0];
                    if numbers.is_empty() && !of_motion {
                        // How near is near: no truth is promised.
                        continue;
                    }
                    match name {
                        // A turn has nothing of a dual part.
                        "rotation" | "angle_to" | "transform_vector" if of_motion && number > 3 => {
                            assert_eq!(*numbers, untouched[0].0, "{}", what());
                        }
                        _ => assert!(!finite || numbers.is_empty(), "{}", what()),
                    }
                    let fails = name.ends_with("_checked") || name == "needs_renormalization";
                    assert!(truths.iter().all(|&truth| truth == fails), "{}", what());
                }
            }
        }
    }
}
