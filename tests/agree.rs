//! Lanes against the scalar reference of the same precision: every operation of the contract on
//! every lane type, and what the types have beside it in `agree_inherent.rs`.

use dq8::{DualQuat, Motion};
use dq8_contract::agreement::{LANES, bound, distance};
use dq8_contract::inputs::{self, Arguments, Case, NUMBERS};
use dq8_contract::repertoire::{self, ALGEBRA, Answer, NAMES, answer};
use dq8_contract::tolerance::unit_roundoff;
use dq8_contract::{for_every_implementation, sample::Sample};
use proptest::prelude::*;
use proptest::test_runner::{TestCaseError, TestRunner};

/// The answer of the scalar reference in the precision of `M`.
fn reference<M: Sample>(name: &str, case: &Case) -> Answer {
    if M::SINGLE {
        answer(name, &Arguments::<DualQuat<f32>>::new(&[*case]))
    } else {
        answer(name, &Arguments::<DualQuat<f64>>::new(&[*case]))
    }
}

/// Where both ways between two motions are equally long up to rounding, either is right.
fn is_a_tie<M: Sample>(name: &str, case: &Case) -> bool {
    let apart = |other: &[f64; 8]| {
        let dot: f64 = case.a.iter().zip(other).take(4).map(|(a, b)| a * b).sum();
        dot.abs() < 16.0 * unit_roundoff(M::SINGLE)
    };
    match name {
        "nlerp" | "sclerp" | "sclerp_long" => apart(&case.b),
        "dlb" => apart(&case.b) || apart(&case.c),
        _ => false,
    }
}

/// Compares every operation in `names` on all `cases`, as many at a time as there are lanes.
fn agree<M: Sample>(implementation: &str, names: &[&str], cases: &[Case]) -> Result<(), String> {
    for chunk in cases.chunks(M::LANES) {
        let lanes = Arguments::<M>::new(chunk);
        for &name in names {
            let answers = answer(name, &lanes);
            for (lane, case) in chunk.iter().enumerate() {
                if is_a_tie::<M>(name, case) {
                    continue;
                }
                let (numbers, masks) = answers.lane(lane);
                let (wanted, truths) = reference::<M>(name, case).lane(0);
                let scale = repertoire::scale(name, case);
                for ((kind, got), (_, wanted)) in numbers.into_iter().zip(wanted) {
                    // The reference overflowed on the way, as with the moment of a tiny screw.
                    let none = !wanted.is_finite();
                    let units = distance(got, wanted, scale.of(kind), M::SINGLE);
                    if !none && units > bound(LANES, name) {
                        return Err(format!(
                            "{implementation}, lane {lane}: {name} gives {got:e} for a {kind:?}, scalar \
                             {wanted:e}: {units:.2} units apart for {case:?}"
                        ));
                    }
                }
                if masks != truths {
                    return Err(format!(
                        "{implementation}, lane {lane}: {name} says {masks:?}, scalar {truths:?} \
                         for {case:?}"
                    ));
                }
            }
        }
    }
    Ok(())
}

/// Runs a property of some cases of a strategy: from one to all lanes twice and one more.
fn check<M: Sample>(
    case: impl Strategy<Value = Case>,
    times: u32,
    property: impl Fn(&[Case]) -> Result<(), String>,
) {
    let cases = prop::collection::vec(case, 1..=2 * M::LANES + 1);
    let mut runner = TestRunner::new(inputs::proptest_config(times));
    runner
        .run(&cases, |cases| property(&cases).map_err(TestCaseError::fail))
        .unwrap_or_else(|failure| panic!("{failure}"));
}

#[test]
fn every_operation_agrees_on_edge_cases() {
    let cases = inputs::unit_cases();
    for_every_implementation!(|name, M| {
        agree::<M>(name, &NAMES, &cases).unwrap_or_else(|failure| panic!("{failure}"));
    });
}

#[test]
fn every_operation_agrees_on_random_unit_motions() {
    for_every_implementation!(|name, M| {
        let case = inputs::case(inputs::unit_motion());
        check::<M>(case, 16, |cases| agree::<M>(name, &NAMES, cases));
    });
}

#[test]
fn the_algebra_agrees_on_any_dual_quaternions() {
    for_every_implementation!(|name, M| {
        let case = inputs::case(inputs::general_motion());
        check::<M>(case, 24, |cases| agree::<M>(name, &ALGEBRA, cases));
    });
}

/// Operations that are held against the scalar path in tests of their own, with the file.
const ELSEWHERE: &[(&str, &str, &[&str])] = &[
    ("blending", include_str!("blending/main.rs"), &["dlb_running", "dib", "slerp_lerp"]),
    ("squad", include_str!("squad.rs"), &["squad", "squad_control"]),
    (
        "metric",
        include_str!("metric.rs"),
        &[
            "angle_to",
            "distance_to",
            "distance_weighted",
            "point_error",
            "shell_error",
            "needs_renormalization",
        ],
    ),
    (
        "differential",
        include_str!("differential/operation.rs"),
        &[
            "derivative_spatial",
            "derivative_body",
            "spatial_twist",
            "body_twist",
            "derivative_from_velocity",
            "velocity",
            "from_twist",
            "to_twist",
            "integrate_spatial",
            "integrate_body",
            "adjoint",
            "coadjoint",
            "left_jacobian",
            "right_jacobian",
            "left_jacobian_inverse",
            "right_jacobian_inverse",
        ],
    ),
];

#[test]
fn every_method_of_the_contract_is_held_against_the_scalar_path() {
    let methods = <DualQuat<f64> as Motion>::METHODS;
    let elsewhere = ELSEWHERE.iter().flat_map(|(.., names)| names.iter().copied());
    let mut covered: Vec<_> = NAMES.iter().copied().chain(elsewhere).collect();
    let mut wanted = [methods, &["add", "sub", "mul", "neg"]].concat();
    covered.sort_unstable();
    wanted.sort_unstable();
    assert_eq!(wanted, covered);
    for (file, text, names) in ELSEWHERE {
        for name in *names {
            assert!(text.contains(name), "tests of {file} do not name {name}");
        }
    }
    let table: Vec<_> = LANES.iter().map(|line| line.name).collect();
    for name in NAMES {
        assert!(table.contains(&name), "{name} has no line in the table");
    }
}

/// Numbers that hurt, among ordinary ones.
fn any_number(single: bool) -> impl Strategy<Value = f64> {
    let bits = if single {
        any::<u32>().prop_map(|bits| f64::from(f32::from_bits(bits))).boxed()
    } else {
        any::<u64>().prop_map(f64::from_bits).boxed()
    };
    let special = [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e-45, 1e-40, 1e30, 3e38];
    prop_oneof![4 => -2.0..2.0_f64, 1 => bits, 1 => prop::sample::select(special.to_vec())]
}

fn any_case(single: bool) -> impl Strategy<Value = Case> {
    prop::collection::vec(any_number(single), NUMBERS).prop_map(|numbers| {
        Case::of_numbers(numbers.as_slice().try_into().expect("as many as were asked for"))
    })
}

#[test]
fn masks_are_those_of_scalar_for_any_numbers() {
    for_every_implementation!(|name, M| {
        check::<M>(any_case(M::SINGLE), 200, |cases| masks_agree::<M>(name, cases));
    });
}

fn masks_agree<M: Sample>(implementation: &str, cases: &[Case]) -> Result<(), String> {
    for chunk in cases.chunks(M::LANES) {
        let lanes = Arguments::<M>::new(chunk);
        for name in ["normalize_checked", "inverse_checked", "is_unit", "abs_diff_eq"] {
            let answers = answer(name, &lanes);
            for (lane, case) in chunk.iter().enumerate() {
                // |p| itself may be no float though p is one: scalar has nothing to divide by then.
                let largest = if M::SINGLE { f64::from(f32::MAX) } else { f64::MAX };
                if case.a[..4].iter().any(|c| c.abs() > 0.5 * largest) {
                    continue;
                }
                let ((_, got), (_, wanted)) =
                    (answers.lane(lane), reference::<M>(name, case).lane(0));
                if got != wanted {
                    return Err(format!(
                        "{implementation}, lane {lane}: {name} says {got:?}, scalar {wanted:?} for \
                         {case:?}"
                    ));
                }
            }
        }
    }
    Ok(())
}

/// Motions that are not quite unit: |p| off by `off`, and q off by `along` along p.
fn nearly_unit(motion: [f64; 8], off: f64, along: f64) -> [f64; 8] {
    let [px, py, pz, pw, qx, qy, qz, qw] = motion.map(|c| c * (1.0 + off));
    let tilted = [qx + along * px, qy + along * py, qz + along * pz, qw + along * pw];
    let [qx, qy, qz, qw] = tilted;
    [px, py, pz, pw, qx, qy, qz, qw]
}

#[test]
fn is_unit_draws_its_line_where_scalar_does() {
    let motion = inputs::edge_motions()[60];
    let tolerance = 1e-3;
    let mut cases = Vec::new();
    for (off, along) in [(0.0, 0.0), (0.9, 0.0), (1.1, 0.0), (-0.9, 0.0), (-1.1, 0.0)] {
        cases.push((nearly_unit(motion, off * tolerance, along * tolerance), off.abs() < 1.0));
    }
    for_every_implementation!(|name, M| {
        for chunk in cases.chunks(M::LANES) {
            let gathered: Vec<_> = (0..M::LANES).map(|i| chunk[i % chunk.len()].0).collect();
            let bits = M::bits(M::gather(&gathered).is_unit(<M as Sample>::splat(tolerance)));
            for (lane, (motion, unit)) in chunk.iter().enumerate() {
                assert_eq!(bits >> lane & 1 == 1, *unit, "{name}, lane {lane}: {motion:?}");
            }
        }
    });
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
    for_every_implementation!(|implementation, M| {
        for case in &cases {
            let alone = Arguments::<M>::new(&[*case; 1]);
            let alone = NAMES.map(|name| bits(answer(name, &alone).lane(0)));
            for lane in 0..M::LANES {
                for neighbour in &neighbours {
                    let mut crowd = vec![*neighbour; M::LANES];
                    crowd[lane] = *case;
                    let crowd = Arguments::<M>::new(&crowd);
                    for (name, alone) in NAMES.iter().zip(&alone) {
                        assert_eq!(
                            &bits(answer(name, &crowd).lane(lane)),
                            alone,
                            "{implementation}: {name} in lane {lane} beside {:e}, {case:?}",
                            neighbour.s
                        );
                    }
                }
            }
        }
    });
}
