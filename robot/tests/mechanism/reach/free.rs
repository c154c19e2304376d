//! Goals that leave something free, several goals, and weights.

use super::{
    REACHED, X, Y, Z, apart, at, draw, pose, problem, seven, solve, solve_with, solved, turned,
};
use dq8::DualQuat;
use dq8_fixtures::random::Random;
use dq8_robot::Joint;
use dq8_robot::ik::{Goal, Options, Outcome};

/// Targets of random configurations, and starts; what the goal leaves free is changed in the
/// targets. What is left, in the frame of the target.
fn left(goal: Goal<f64>, free: impl Fn(&mut Random) -> DualQuat<f64>) -> Vec<DualQuat<f64>> {
    let (joints, mut random) = (seven(), Random(5));
    let arm = problem(&joints, [goal]);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..200 {
        targets.push(pose(&arm, &draw(&mut random, &joints), 7) * free(&mut random));
        starts.extend(draw(&mut random, &joints));
    }
    let mut left = Vec::new();
    for (_, values, reports) in solved(&arm, &targets, &starts, &Options::default()) {
        let (mut converged, mut iterations) = (0, 0.0);
        for ((values, target), report) in values.chunks(7).zip(&targets).zip(&reports) {
            if report.is_converged() {
                left.push(target.conjugate() * pose(&arm, values, 7));
                converged += 1;
                iterations += f64::from(report.iterations);
            }
        }
        assert!(converged >= 198, "{converged} of 200");
        assert!(iterations < 12.0 * f64::from(converged), "{iterations} for {converged}");
    }
    left
}

#[test]
fn what_a_goal_does_not_ask_for_is_free() {
    let (none, norm) = (DualQuat::IDENTITY, |x: f64, y: f64, z: f64| x.hypot(y).hypot(z));
    let any = |random: &mut Random| {
        turned(Z, 3.0 * random.signed(), [0.0; 3]) * turned([0.6, 0.8, 0.0], 2.0, [0.0; 3])
    };
    for left in left(Goal::position(7), any) {
        assert!(apart(left, none)[1] < REACHED);
    }
    for left in left(Goal::orientation(7), |_| at(9.0, -7.0, 5.0)) {
        assert!(apart(left, none)[0] < REACHED);
    }
    // A goal of little weight is asked for all the same.
    for left in left(Goal::pose(7).weighing(0.3, 0.3), |_| none) {
        let [turn, distance] = apart(left, none);
        assert!(turn < REACHED && distance < REACHED, "{left}");
    }
    // A drill: any turn about the z axis of the target will do, half a turn too.
    let spin = |random: &mut Random| turned(Z, 3.1 * random.signed(), [0.0; 3]);
    for left in left(Goal::pose(7).with_angular([1.0, 1.0, 0.0]), spin) {
        let [x, y, z] = left.rotation().rotate(Z);
        assert!(apart(left, none)[1] < REACHED && norm(x, y, z - 1.0) < REACHED, "{left}");
    }
    let roll = |random: &mut Random| turned(X, 3.1 * random.signed(), [0.0; 3]);
    for left in left(Goal::pose(7).with_angular([0.0, 1.0, 1.0]), roll) {
        let [x, y, z] = left.rotation().rotate(X);
        assert!(apart(left, none)[1] < REACHED && norm(x - 1.0, y, z) < REACHED, "{left}");
    }
    // A cup on a table: anywhere along the x axis of the target.
    let slide = |random: &mut Random| at(4.0 * random.signed(), 0.0, 0.0);
    for left in left(Goal::pose(7).with_linear([0.0, 1.0, 1.0]), slide) {
        let [_, y, z] = left.translation();
        assert!(apart(left, none)[0] < REACHED && y.hypot(z) < REACHED, "{left}");
    }
    let rise = |random: &mut Random| at(0.0, 0.0, 4.0 * random.signed());
    for left in left(Goal::pose(7).with_linear([1.0, 1.0, 0.0]), rise) {
        let [x, y, _] = left.translation();
        assert!(apart(left, none)[0] < REACHED && x.hypot(y) < REACHED, "{left}");
    }
}

/// Two arms on a trunk that turns.
fn two_arms() -> Vec<Joint<f64>> {
    let mut joints = vec![Joint::revolute(None, at(0.0, 0.0, 1.0), Z).with_limits([-1.0, 1.0])];
    for side in [-1.0, 1.0] {
        let first = joints.len();
        joints.push(Joint::revolute(Some(0), at(0.0, 0.2 * side, 0.0), Y));
        joints.push(Joint::revolute(Some(first), DualQuat::IDENTITY, Z));
        joints.push(Joint::revolute(Some(first + 1), at(0.3, 0.0, 0.0), Y));
        joints.push(Joint::fixed(Some(first + 2), at(0.3, 0.0, 0.0)));
    }
    joints
}

#[test]
fn two_hands_come_to_two_targets_at_once() {
    let body = problem(&two_arms(), [Goal::position(4), Goal::position(8)]);
    let mut random = Random(3);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..100 {
        let goal: Vec<f64> = (0..7).map(|_| random.signed()).collect();
        targets.extend([4, 8].map(|link| pose(&body, &goal, link)));
        starts.extend((0..7).map(|_| random.signed()));
    }
    for (_, values, reports) in solved(&body, &targets, &starts, &Options::default()) {
        for (index, report) in reports.iter().enumerate() {
            assert!(report.is_converged(), "{index}: {report:?}");
            for (link, target) in [4, 8].into_iter().zip(&targets[2 * index..]) {
                let found = pose(&body, &values[7 * index..][..7], link);
                assert!(apart(found, *target)[1] < REACHED);
            }
        }
    }
}

/// A search stalls where a step gains nothing that `f64` sees: on the root of its roundoff.
const AT_REST: f64 = 2e-8;

/// One slide between two targets that it cannot both reach divides its way by the squares of the
/// weights.
#[test]
fn the_heavier_of_two_goals_is_the_nearer() {
    let here = DualQuat::IDENTITY;
    let slide = Joint::prismatic(None, here, [1.0, 0.0, 0.0]).with_limits([-5.0, 5.0]);
    let goals = [Goal::position(0).with_linear([2.0; 3]), Goal::position(1)];
    let slide = problem(&[slide, Joint::fixed(Some(0), here)], goals);
    let targets = [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0)];
    let (values, report) = solve_with(&slide, &targets, [0.3], &Options::default());
    assert_eq!(report.outcome, Outcome::Stalled);
    assert!((values[0] - 0.2).abs() < AT_REST, "{values:?}");
    assert!((report.linear_error - 0.8).abs() < AT_REST, "{report:?}");
}

#[test]
fn joints_that_carry_no_goal_keep_their_values_whatever_they_are() {
    let body = problem(&two_arms(), [Goal::position(4)]);
    let target = pose(&body, &[0.2, 0.3, 0.4, 0.5, 0.0, 0.0, 0.0], 4);
    let start = [0.0, 0.1, 0.1, 0.1, f64::NAN, 1e300, -0.0];
    let (values, report) = solve(&body, target, start);
    assert!(report.is_converged(), "{report:?}");
    let bits = [values, start].map(|all| [all[4], all[5], all[6]].map(f64::to_bits));
    assert_eq!(bits[0], bits[1]);
}
