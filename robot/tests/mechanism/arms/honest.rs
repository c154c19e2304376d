//! A report means what it says: inputs as people type them, hinges many turns away, arms of any
//! size. What is called reached is measured in `f64`.

use super::super::reach::apart;
use dq8::geometry::Screw;
use dq8::{Backend, DualQuat, Line, Quat, Real, Scalar};
use dq8_arms::{Arm, Axis, Plan, Random, exact, rounded, six_of_any_kind};
use dq8_fixtures::kinematics;
use dq8_robot::ik::{Options, Outcome};
use std::f64::consts::TAU;

/// What came of some searches: how many converged, and the worst error of those.
struct Tally {
    converged: usize,
    worst: f64,
}

/// A target, where that is, and values to start from.
type Case<R> = (DualQuat<R>, DualQuat<f64>, [R; 6]);

/// Searches of some arms of six hinges, `each` of them for so many targets: the search has the arm
/// that `given` makes of each, and the truth is what `exact_arm` makes of it.
fn tally<R: Scalar>(
    seed: u64,
    [arms, each]: [usize; 2],
    [given, exact_arm]: [&dyn Fn(Plan<6>) -> Plan<6>; 2],
    case: impl Fn(&Plan<6>, &Arm<R, 6>, &Arm<f64, 6>, &mut Random) -> Case<R>,
) -> Tally {
    let (mut random, mut sum) = (Random(seed), Tally { converged: 0, worst: 0.0 });
    for _ in 0..arms {
        let plan = six_of_any_kind(&mut random);
        let (arm, truth) = (given(plan).arm::<R>(), exact_arm(plan).arm::<f64>());
        let cases: Vec<_> = (0..each).map(|_| case(&plan, &arm, &truth, &mut random)).collect();
        let targets: Vec<_> = cases.iter().map(|(target, ..)| *target).collect();
        let mut values: Vec<_> = cases.iter().map(|(.., start)| *start).collect();
        let reports = arm.reach_all(Backend::best(), &targets, &mut values, &Options::default());
        for (((_, there, _), values), report) in cases.iter().zip(&values).zip(&reports) {
            for (&value, axis) in values.iter().zip(&given(plan).axes) {
                let [low, high] = rounded::<R, 2>(axis.limits);
                assert!(low <= value && value <= high, "{value} is not within {:?}", axis.limits);
            }
            if report.is_converged() {
                let [turn, distance] = apart(truth.forward(&exact(*values)), *there);
                sum.converged += 1;
                sum.worst = sum.worst.max(turn).max(distance);
            }
        }
    }
    sum
}

/// Tolerance, and what poses of arms of about a length are rounded by.
fn bound<R: Real>() -> f64 {
    1e-5 + 16.0 * Into::<f64>::into(R::EPSILON)
}

fn to_decimals(number: f64, decimals: i32) -> f64 {
    (number * 10f64.powi(decimals)).round() / 10f64.powi(decimals)
}

fn cast<R: Real>(pose: DualQuat<f64>) -> DualQuat<R> {
    DualQuat::from_array(rounded(pose.to_array()))
}

/// 24 arms of six hinges, 16 targets each; `change` is what becomes of a target before the arm sees
/// it. A target may have lost its unit norm, and is where its normalized form is.
fn with_targets<R: Scalar>(change: impl Fn(DualQuat<R>) -> DualQuat<R>) -> Tally {
    tally::<R>(14, [24, 16], [&|plan| plan; 2], |plan, arm, _, random| {
        let target = change(arm.forward(&rounded(plan.draw(random))));
        let there = DualQuat::from_array(exact(target.to_array())).normalize();
        (target, there, rounded(plan.draw(random)))
    })
}

fn typed_targets_are_reached_as_computed_ones<R: Scalar>() {
    let computed = with_targets::<R>(|target| target);
    assert!(computed.converged >= 381, "{} of 384", computed.converged);
    let typed = {
        with_targets::<R>(|target| {
            let round = |c: R| <R as Real>::from_f64(to_decimals(c.into(), 4));
            let [x, y, z] = target.translation();
            let rotation = Quat::from_array(target.rotation().to_array().map(round));
            // As `from_rotation_translation` makes of a rotation that is not unit.
            DualQuat::from_rotation_translation(rotation, [x, y, z])
        })
    };
    // The products of a thousand small motions and their inverses, never normalized.
    let mut random = Random(15);
    let there_and_back: Vec<_> = (0..500)
        .flat_map(|_| {
            let turn = Quat::from_axis_angle(rounded(random.direction()), R::from(0.1));
            let step = DualQuat::from_rotation_translation(turn, rounded([0.01, 0.02, -0.01]));
            [step, step.conjugate()]
        })
        .collect();
    let accumulated = with_targets::<R>(|target| kinematics::after(target, &there_and_back));
    let single = R::EPSILON.into() > 1e-10;
    for (what, tally) in [("4 decimals", typed), ("accumulated", accumulated)] {
        assert!(tally.converged >= 381, "{what}: {} of 384", tally.converged);
        // Where a typed target is, is rounded as well.
        let most = bound::<R>() + if single { 2e-6 } else { 0.0 };
        assert!(tally.worst <= most, "{what}: {:e}", tally.worst);
    }
}

#[test]
fn targets_typed_with_four_decimals_are_reached_as_often_as_computed_ones() {
    typed_targets_are_reached_as_computed_ones::<f64>();
    typed_targets_are_reached_as_computed_ones::<f32>();
}

/// Arms whose axes are as long as `change` makes them. What they are turns about the same axes at
/// length 1.
fn with_axes<R: Scalar>(change: impl Fn([f64; 3]) -> [f64; 3]) -> Tally {
    let off =
        |plan: Plan<6>| plan.with_axes(|axis| Axis { direction: change(axis.direction), ..axis });
    let unit = |plan: Plan<6>| {
        off(plan).with_axes(|axis| {
            let length = axis.direction.iter().map(|c| c * c).sum::<f64>().sqrt();
            Axis { direction: axis.direction.map(|c| c / length), ..axis }
        })
    };
    tally::<R>(17, [25, 16], [&off, &unit], |plan, _, truth, random| {
        let there = truth.forward(&plan.draw(random));
        (cast(there), there, rounded(plan.draw(random)))
    })
}

fn axes_nearly_unit_are_unit<R: Scalar>() {
    for (what, tally) in [
        ("exact", with_axes::<R>(|axis| axis)),
        ("4 decimals", with_axes::<R>(|axis| axis.map(|c| to_decimals(c, 4)))),
        ("longer by 9e-6", with_axes::<R>(|axis| axis.map(|c| c * 1.000_009))),
        ("shorter by 9e-4", with_axes::<R>(|axis| axis.map(|c| c * 0.999_1))),
    ] {
        assert!(tally.converged >= 397, "{what}: {} of 400", tally.converged);
        assert!(tally.worst <= bound::<R>(), "{what}: {:e}", tally.worst);
    }
}

#[test]
fn axes_typed_with_four_decimals_are_turned_about_as_unit_ones() {
    axes_nearly_unit_are_unit::<f64>();
    axes_nearly_unit_are_unit::<f32>();
}

/// Hinges with these limits, started this many turns away.
fn turns_away<R: Scalar>(limits: [f64; 2], turns: f64) -> Tally {
    let limited = |plan: Plan<6>| plan.with_axes(|axis| Axis { limits, ..axis });
    tally::<R>(18, [25, 8], [&limited; 2], |within, _, truth, random| {
        let there = truth.forward(&within.draw(random));
        let start = within.draw(random).map(|value| value + turns * TAU);
        (cast(there), there, rounded(start))
    })
}

fn endless_hinges_are_honest<R: Scalar>() {
    let inf = f64::INFINITY;
    for turns in [0.0, -10.0, 100.0, -1e9, 1e30] {
        let tally = turns_away::<R>([-inf, inf], turns);
        assert!(tally.converged >= 198, "{turns} turns: {} of 200", tally.converged);
        assert!(tally.worst <= bound::<R>(), "{turns} turns: {:e}", tally.worst);
    }
    for (limits, turns) in [
        ([-3.0, inf], 0.0),
        ([-inf, 2.0], 5.0),
        ([-inf, -20.0], 0.0),
        ([-1e6, 1e6], -1e4),
        ([-4.0, 5.0], 1.0),
    ] {
        let tally = turns_away::<R>(limits, turns);
        assert!(tally.converged >= 198, "{limits:?}: {} of 200", tally.converged);
        assert!(tally.worst <= bound::<R>(), "{limits:?}: {:e}", tally.worst);
    }
}

#[test]
fn hinges_any_number_of_turns_away_reach_as_much() {
    endless_hinges_are_honest::<f64>();
    endless_hinges_are_honest::<f32>();
}

/// Limits far from zero leave coarse floats; what is called reached is reached with them.
#[test]
fn limits_far_from_zero_keep_their_values_and_the_report_its_word() {
    for turns in [30.0, 1000.0] {
        let far = [turns * TAU - 3.5, turns * TAU + 3.5];
        let (single, double) = (turns_away::<f32>(far, 0.0), turns_away::<f64>(far, 0.0));
        assert!(double.converged >= 198, "{turns}: {}", double.converged);
        assert!(double.worst <= bound::<f64>(), "{turns}: {:e}", double.worst);
        assert!(single.worst <= bound::<f32>(), "{turns}: {:e}", single.worst);
    }
}

/// Neither turns nor pose change, and no bit of a value.
#[test]
fn a_start_many_turns_from_the_target_is_at_it() {
    let plan = six_of_any_kind(&mut Random(19))
        .with_axes(|axis| Axis { limits: [f64::NEG_INFINITY, f64::INFINITY], ..axis });
    let arm = plan.arm::<f64>();
    let goal = [0.3, -1.2, 3.0, -3.0, 0.0, 2.0];
    for turns in [1.0, -7.0, 100.0, 1e4] {
        let start = goal.map(|value| value + turns * TAU);
        let mut values = start;
        let report = arm.reach(arm.forward(&goal), &mut values, &Options::default());
        assert_eq!((report.outcome, report.iterations), (Outcome::Converged, 0));
        assert_eq!(values, start, "{turns}");
    }
}

/// In millimetres, far from the base, about axes in any direction: the moment of an axis is rounded
/// by tenths of a millimetre, and what of that lies along the axis is no pitch.
#[test]
fn a_hinge_far_from_the_origin_is_a_hinge() {
    let (mut random, endless) = (Random(20), [f32::NEG_INFINITY, f32::INFINITY]);
    for round in 0..1000 {
        let axis = random.direction();
        // Every other near the axis through the origin, but far along it.
        let along = if round % 2 == 0 { axis } else { random.direction() };
        let far = along.map(|c| 3000.0 * c + random.signed());
        let axis = Line::from_point_direction(rounded(far), rounded(axis));
        let hinge = (Screw { axis, angle: 1.0, slide: 0.0 }, endless);
        let arm = Arm::new(&[hinge], DualQuat::IDENTITY).expect("a hinge may be endless");
        let mut values = [3.0_f32];
        let options = Options { linear_tolerance: 1e-2, ..Options::default() };
        let report = arm.reach(arm.forward(&[-3.0]), &mut values, &options);
        assert_eq!(report.outcome, Outcome::Converged);
        // The shorter way there, which is on beyond half a turn.
        let there = std::f32::consts::TAU - 3.0;
        assert!((values[0] - there).abs() < 1e-4 && report.iterations <= 3, "{report:?}");
    }
}
