//! Whole turns of an arm's hinges: the answer is the nearest to the start.

use super::arms::{Axis, Random, exact, rounded, six_of_any_kind};
use dq8::ik::{Arm, Joint, Options, Outcome, Report};
use dq8::simd::{Lanes, Portable};
use dq8::{Backend, DualQuat, Real, Scalar};
use std::f64::consts::TAU;

const OPEN: f64 = f64::INFINITY;

/// An arm whose hinges stand upright and lie, a length apart.
fn arm<R: Real>(limits: [f64; 2]) -> Arm<R, 2> {
    let axes = [([0.0, 0.0, 1.0], [0.0; 3]), ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0])];
    let joints = axes
        .map(|(axis, at)| Joint::revolute(rounded(axis), rounded(at)).with_limits(rounded(limits)));
    let home = DualQuat::from_translation(rounded([0.0, 0.0, 2.0]));
    Arm::new(joints, home).expect("an arm")
}

/// What a start becomes: alone, and on the lanes of every backend.
fn from<R>(arm: &Arm<R, 2>, there: [f64; 2], start: [f64; 2], restarts: bool) -> Vec<[f64; 2]>
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    let (target, start) = (arm.forward(&rounded(there)), rounded::<R, 2>(start));
    let options = Options { restarts, ..Options::default() };
    let mut values = start;
    let mut all = vec![(arm.reach(target, &mut values, &options), values)];
    for backend in Backend::available() {
        let mut values = [start; 17];
        let mut reports = [Report::default(); 17];
        backend.reach(arm, &[target; 17], &mut values, &mut reports, &options).expect("lengths");
        all.extend(reports.into_iter().zip(values));
    }
    all.into_iter()
        .map(|(report, values)| {
            assert_eq!(report.outcome, Outcome::Converged, "{values:?}");
            exact(values)
        })
        .collect()
}

/// (limits, the first angle of the target, that of the start, that of the answer)
const CASES: [([f64; 2], f64, f64, f64); 8] = [
    ([-OPEN, OPEN], 3.25, 3.2, 3.25),
    ([-OPEN, OPEN], 3.25, 9.0, 3.25 + TAU),
    ([-OPEN, OPEN], -3.25, -9.0, -3.25 - TAU),
    ([-OPEN, 20.0], 0.5, 21.0, 0.5 + 3.0 * TAU),
    ([-4.0, 4.0], 3.8, 3.5, 3.8),
    ([-4.0, 4.0], 3.8, -2.0, 3.8 - TAU),
    ([-30.0, 30.0], 3.8, 28.0, 3.8 + 4.0 * TAU),
    ([-3.1, 3.1], 3.2, 3.0, 3.2 - TAU),
];

fn the_nearest_to_the_start<R>()
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    for (limits, there, start, to) in CASES {
        let arm = arm::<R>(limits);
        for restarts in [false, true] {
            for [first, second] in from(&arm, [there, 0.3], [start, 0.3], restarts) {
                // Tolerance, and floats of thirty radians.
                let bound = 2e-5 + 30.0 * R::EPSILON.into();
                assert!((first - to).abs() < bound, "{first} for {to} from {start}");
                assert!((second - 0.3).abs() < bound, "{second}");
            }
        }
    }
}

#[test]
fn of_whole_turns_within_the_limits_the_answer_is_the_nearest_to_the_start() {
    the_nearest_to_the_start::<f64>();
    the_nearest_to_the_start::<f32>();
}

#[test]
fn a_path_past_half_a_turn_has_no_jump() {
    let arm = arm::<f64>([-OPEN, OPEN]);
    let mut last = [3.0, 0.3];
    for index in 0..18 {
        let all = from(&arm, [3.0 + 0.0226 * f64::from(index), 0.3], last, false);
        for [first, _] in &all {
            assert!((first - last[0]).abs() < 0.03, "{last:?} to {first}");
        }
        last = all[0];
    }
}

/// Random arms without limits from random starts, searches that begin again among them.
#[test]
fn endless_arms_end_within_half_a_turn_of_the_start() {
    let (mut random, mut restarts) = (Random(23), 0);
    for _ in 0..10 {
        let within = six_of_any_kind(&mut random);
        let plan = within.with_axes(|axis| Axis { limits: [-OPEN, OPEN], ..axis });
        let arm = plan.arm::<f64>();
        for _ in 0..40 {
            let target = arm.forward(&within.draw(&mut random));
            let start = within.draw(&mut random).map(|value| value + 7.0 * random.signed());
            let mut values = start;
            restarts += arm.reach(target, &mut values, &Options::default()).restarts;
            for (value, start) in values.iter().zip(start) {
                assert!((value - start).abs() <= 0.5 * TAU + 1e-14, "{value} from {start}");
            }
        }
    }
    assert!(restarts > 20, "{restarts}");
}
