//! Lanes against the scalar reference of the same precision, and every implementation against the
//! scalar path in `f64`: every operation of the table. What the types have beside it is in
//! `agree_inherent.rs`.

use dq8::{DualQuat, Motion};
use dq8_contract::bound::distance;
use dq8_contract::case::{Case, NUMBERS};
use dq8_contract::fusing::PORTABLE_FUSES;
use dq8_contract::implementation::{On, implementations};
use dq8_contract::inputs;
use dq8_contract::ledger::{Ledger, Line};
use dq8_contract::operation::{Held, Inputs, Operation};
use dq8_contract::operations::{OPERATIONS, operation};
use proptest::prelude::*;
use proptest::test_runner::{TestCaseError, TestRunner};
use std::cell::RefCell;

/// Compares operations on all `cases`, as many at a time as there are lanes.
fn agree(on: On, operations: &[&Operation], cases: &[Case]) -> Result<(), String> {
    for operation in operations {
        let Some(bound) = operation.agreement() else { continue };
        for chunk in cases.chunks(on.lanes) {
            let answers = operation.answer(on, chunk);
            for (lane, case) in chunk.iter().enumerate() {
                if operation.is_a_tie(on, case) {
                    continue;
                }
                let (numbers, masks) = answers.lane(lane);
                let (wanted, truths) = operation.answer(on.scalar(), &[*case]).lane(0);
                let scale = (operation.scale)(case);
                for ((kind, got), (_, wanted)) in numbers.into_iter().zip(wanted) {
                    // The reference overflowed on the way, as with the moment of a tiny screw.
                    let none = !wanted.is_finite();
                    let units = distance(got, wanted, scale.of(kind), on.single);
                    if !none && units > bound.units {
                        return Err(format!(
                            "{on:?}, lane {lane}: {} gives {got:e} for a {kind:?}, scalar {wanted:e}: \
                             {units:.2} units apart, {} allowed ({}), for {case:?}",
                            operation.name, bound.units, bound.reason
                        ));
                    }
                }
                if masks != truths {
                    return Err(format!(
                        "{on:?}, lane {lane}: {} says {masks:?}, scalar {truths:?} for {case:?}",
                        operation.name
                    ));
                }
            }
        }
    }
    Ok(())
}

/// Runs a property of some cases of a strategy: from one to all lanes twice and one more.
fn check(
    on: On,
    case: impl Strategy<Value = Case>,
    times: u32,
    property: impl Fn(&[Case]) -> Result<(), String>,
) {
    let cases = prop::collection::vec(case, 1..=2 * on.lanes + 1);
    let mut runner = TestRunner::new(inputs::proptest_config(times));
    runner
        .run(&cases, |cases| property(&cases).map_err(TestCaseError::fail))
        .unwrap_or_else(|failure| panic!("{failure}"));
}

fn all() -> Vec<&'static Operation> {
    OPERATIONS.iter().collect()
}

#[test]
fn every_operation_agrees_on_edge_cases() {
    let cases = inputs::unit_cases();
    for on in implementations() {
        agree(on, &all(), &cases).unwrap_or_else(|failure| panic!("{failure}"));
    }
}

#[test]
fn every_operation_agrees_on_random_unit_motions() {
    for on in implementations() {
        let case = inputs::case(inputs::unit_motion());
        check(on, case, 16, |cases| agree(on, &all(), cases));
    }
}

#[test]
fn the_algebra_agrees_on_any_dual_quaternions() {
    let algebra: Vec<_> = OPERATIONS.iter().filter(|operation| operation.is_algebra()).collect();
    for on in implementations() {
        let case = inputs::case(inputs::general_motion());
        check(on, case, 24, |cases| agree(on, &algebra, cases));
    }
}

#[test]
fn every_implementation_answers_as_the_scalar_path_in_double_does() {
    let twists = inputs::twist_cases();
    let turns: Vec<_> = twists.iter().filter(|case| case.angle() < 6.25).copied().collect();
    let clusters = RefCell::new(Vec::new());
    inputs::for_all(32, &prop::collection::vec(inputs::cluster(), 16), |drawn| {
        clusters.borrow_mut().extend(drawn);
    });
    let clusters = clusters.into_inner();
    let held: Vec<_> =
        OPERATIONS.iter().filter_map(|operation| Some((operation, operation.double()?))).collect();
    let mut lines = Vec::new();
    for &(operation, (.., bounds)) in &held {
        lines.extend(bounds.iter().map(|&bound| Line { op: operation.name, bound }));
    }
    Ledger::keep("against f64", &lines, |ledger| {
        for on in implementations() {
            for &(operation, (inputs, sign, _)) in &held {
                let cases = match inputs {
                    Inputs::Twists => &twists,
                    Inputs::Turns => &turns,
                    Inputs::Clusters => &clusters,
                };
                let (error, case) = operation.worst_error(on, sign, cases);
                ledger.measure(operation.name, "", error, || format!("{on:?}: {case:?}"));
            }
        }
    });
}

#[test]
fn every_method_of_the_contract_is_held_against_the_scalar_path() {
    let names = |held: &Operation| held.name;
    let mut table: Vec<_> = OPERATIONS.iter().map(names).collect();
    let operators = ["add", "sub", "mul", "neg"];
    let mut wanted = [<DualQuat<f64> as Motion>::METHODS, &operators].concat();
    table.sort_unstable();
    wanted.sort_unstable();
    assert_eq!(wanted, table);
    for operation in OPERATIONS {
        let against_scalar = |held: &&Held| matches!(held, Held::Scalar(_) | Held::Double { .. });
        let times = operation.bounds.iter().filter(against_scalar).count();
        assert_eq!(times, 1, "{}", operation.name);
    }
}

#[test]
fn every_implementation_runs_that_the_machine_can_run() {
    let names: Vec<_> = implementations().into_iter().map(|on| on.name).collect();
    let mut wanted: Vec<_> = ["textbook f32", "textbook f64", "scalar f32", "scalar f64"].to_vec();
    wanted.extend(["lanes f32x1", "lanes f32x4", "lanes f32x8", "lanes f32x16"]);
    wanted.extend(["lanes f64x1", "lanes f64x2", "lanes f64x4", "lanes f64x8"]);
    // Asked of the standard library, not of the detection that chooses the lanes.
    #[cfg(target_arch = "x86_64")]
    {
        if std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma") {
            wanted.extend(["lanes AVX2 f32x8", "lanes AVX2 f32x16", "lanes AVX2 f64x4"]);
        }
        if std::is_x86_feature_detected!("avx512f") {
            let lanes = ["lanes AVX-512 f32x8", "lanes AVX-512 f32x16", "lanes AVX-512 f64x8"];
            wanted.extend(lanes);
        }
    }
    if PORTABLE_FUSES {
        wanted.extend(["lanes unfused f32x8", "lanes unfused f64x4"]);
    }
    #[cfg(target_arch = "x86_64")]
    {
        if std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma") {
            wanted.extend(["lanes unfused AVX2 f32x8", "lanes unfused AVX2 f64x4"]);
        }
        if std::is_x86_feature_detected!("avx512f") {
            wanted.extend(["lanes unfused AVX-512 f32x16", "lanes unfused AVX-512 f64x8"]);
        }
    }
    assert_eq!(names, wanted);
}

/// What operations with a mask take: to draw all numbers of a case takes several times as long.
fn any_case(single: bool) -> impl Strategy<Value = Case> {
    let motion = || prop::array::uniform8(inputs::any_number(single, 8));
    // None that a number of a motion is too: where a norm is as large as the tolerance, either is
    // right.
    let no_tolerance = [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY].to_vec();
    let tolerance = prop_oneof![-2.0..2.0_f64, prop::sample::select(no_tolerance)];
    (motion(), motion(), tolerance).prop_map(|(a, b, tolerance)| Case {
        a,
        b,
        tolerance,
        ..Case::of_numbers(&[0.0; NUMBERS])
    })
}

#[test]
fn masks_are_those_of_scalar_for_any_numbers() {
    for on in implementations() {
        check(on, any_case(on.single), 200, |cases| masks_agree(on, cases));
    }
}

fn masks_agree(on: On, cases: &[Case]) -> Result<(), String> {
    for chunk in cases.chunks(on.lanes) {
        for name in ["normalize_checked", "inverse_checked", "is_unit", "abs_diff_eq"] {
            let operation = operation(name);
            let answers = operation.answer(on, chunk);
            for (lane, case) in chunk.iter().enumerate() {
                if case.is_at_the_end(on.single) {
                    continue;
                }
                let wanted = operation.answer(on.scalar(), &[*case]);
                let ((_, got), (_, wanted)) = (answers.lane(lane), wanted.lane(0));
                if got != wanted {
                    return Err(format!(
                        "{on:?}, lane {lane}: {name} says {got:?}, scalar {wanted:?} for \
                         {case:?}"
                    ));
                }
            }
        }
    }
    Ok(())
}

#[test]
fn a_lane_does_not_know_its_place_or_its_neighbours() {
    let edges = inputs::unit_cases();
    let cases: Vec<_> = edges.iter().step_by(edges.len() / 12).copied().collect();
    let neighbours = [0.0, 1e-40, 2.0, 1e2, 1e30, f64::INFINITY, f64::NAN];
    let neighbours: Vec<_> = neighbours.map(|n| Case::of_numbers(&[n; NUMBERS])).to_vec();
    // NaN has many bit patterns, which mean the same.
    let bits = |number: f64| if number.is_nan() { f64::NAN.to_bits() } else { number.to_bits() };
    let bits = |answer: (Vec<(_, f64)>, Vec<bool>)| {
        (answer.0.iter().map(|(_, number)| bits(*number)).collect::<Vec<_>>(), answer.1)
    };
    for on in implementations() {
        for operation in OPERATIONS {
            let neighbours: Vec<_> = neighbours.iter().map(|x| operation.given(on, x)).collect();
            for case in &cases {
                let given = operation.given(on, case);
                let alone = bits(operation.answer_given(on, &vec![&given; on.lanes]).lane(0));
                for (neighbour, own) in neighbours.iter().flat_map(|n| [(n, 0), (n, 1)]) {
                    // Every other lane, so that each has a neighbour on either side.
                    let is_own = |lane: &usize| lane % 2 == own;
                    let pick = |lane| if is_own(&lane) { &given } else { neighbour };
                    let crowd: Vec<_> = (0..on.lanes).map(pick).collect();
                    let answer = operation.answer_given(on, &crowd);
                    for lane in (0..on.lanes).filter(is_own) {
                        assert_eq!(
                            bits(answer.lane(lane)),
                            alone,
                            "{on:?}: {} in lane {lane} beside {neighbour:?}, {case:?}",
                            operation.name
                        );
                    }
                }
            }
        }
    }
}
