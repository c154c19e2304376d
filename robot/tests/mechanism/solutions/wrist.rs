//! A singular wrist behind a nearly stretched elbow, and joints that have more than a turn.

use dq8::{DualQuat, Real};
use dq8_arms::Random;
use dq8_robot::ik::{Goal, OwnedReach, SixAxisArm, Solutions};
use dq8_robot::{Dh, DhConvention, OwnedMechanism};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Rows θ d a α of Denavit and Hartenberg, of a KUKA KR 6 and a PUMA 560.
const KR6: [[f64; 4]; 6] = [
    [0.0, 0.4, 0.025, -FRAC_PI_2],
    [0.0, 0.0, 0.455, 0.0],
    [-FRAC_PI_2, 0.0, 0.035, -FRAC_PI_2],
    [0.0, 0.42, 0.0, FRAC_PI_2],
    [0.0, 0.0, 0.0, -FRAC_PI_2],
    [0.0, 0.08, 0.0, 0.0],
];
const PUMA: [[f64; 4]; 6] = [
    [0.0, 0.6718, 0.0, FRAC_PI_2],
    [0.0, 0.0, 0.4318, 0.0],
    [0.0, 0.15005, 0.0203, -FRAC_PI_2],
    [0.0, 0.4318, 0.0, FRAC_PI_2],
    [0.0, 0.0, 0.0, -FRAC_PI_2],
    [0.0, 0.05625, 0.0, 0.0],
];

/// The third value at which the elbow is stretched: where the centre of the wrist is farthest from
/// the second axis.
fn stretched(rows: &[[f64; 4]; 6]) -> f64 {
    // From the third axis, the wrist is at (a, d) in the plane of the arm, and the upper arm is
    // along x.
    let [theta, _, a, alpha] = rows[2];
    (rows[3][1] * alpha.sin()).atan2(a) - theta
}

fn arm<R: Real>(rows: &[[f64; 4]; 6], limits: [f64; 2]) -> OwnedReach<R> {
    let row = |[theta, d, a, alpha]: [f64; 4]| {
        let [theta, d, a, alpha] = [theta, d, a, alpha].map(R::from_f64);
        Dh::hinge(theta, d, a, alpha).with_limits(limits.map(R::from_f64))
    };
    let arm = OwnedMechanism::from_dh(&rows.map(row), DhConvention::Standard, DualQuat::IDENTITY);
    OwnedReach::new(arm.unwrap(), [Goal::pose(6)]).unwrap()
}

macro_rules! solutions {
    ($reach:expr, $values:expr, $start:expr) => {{
        let view = $reach.view();
        let target = view.mechanism().link_pose(&$values, 6).unwrap();
        let six = SixAxisArm::new(view).unwrap();
        let mut scratch = vec![Default::default(); six.scratch_len()];
        let found: Solutions<_> = six.solutions(target, &$start, &mut scratch).unwrap();
        (found, target)
    }};
}

#[test]
fn the_first_solution_at_a_singular_wrist_is_the_start_however_far_the_elbow_is_stretched() {
    for (name, rows) in [("KR6", &KR6), ("PUMA", &PUMA)] {
        let reach = arm::<f64>(rows, [-PI, PI]);
        let mut random = Random(3);
        let mut worst = 0.0_f64;
        for bend in [0.0_f64, 1e-9, 1e-6, 1e-4, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0] {
            for _ in 0..100 {
                let mut start: [f64; 6] = random.vector();
                (start[2], start[4]) = (stretched(rows) + bend * random.signed().signum(), 0.0);
                if start[2] > PI {
                    start[2] -= TAU;
                }
                let (found, target) = solutions!(reach, start, start);
                let first = found.first().expect("the start is one");
                assert!(first.singular.wrist, "{name} {bend}: {first:?}");
                assert!(first.distance < 1e-6, "{name} {bend} {start:?}: {first:?}");
                let pose = reach.view().mechanism().link_pose(&first.values, 6).unwrap();
                worst = worst.max(pose.distance_to(target));
            }
        }
        assert!(worst < 1e-7, "{name}: {worst:e}");
    }
}

/// In single floats the start is told as long as the roundoff of a target, which the elbow
/// amplifies, is less than what values may miss it by, 1.6e-4 rad.
#[test]
fn the_same_in_single_floats() {
    for rows in [&KR6, &PUMA] {
        let reach = arm::<f32>(rows, [-PI, PI]);
        let mut random = Random(3);
        let mut off = 0;
        for bend in [0.03, 0.1, 0.3, 1.0] {
            for _ in 0..100 {
                let mut start: [f64; 6] = random.vector();
                (start[2], start[4]) = (stretched(rows) + bend * random.signed().signum(), 0.0);
                let start = start.map(|x| x as f32);
                let (found, _) = solutions!(reach, start, start);
                off += usize::from(found.first().is_none_or(|first| first.distance > 0.01));
            }
        }
        assert!(off == 0, "{off} of 400");
    }
}

#[test]
fn a_path_through_a_singular_wrist_jumps_nowhere() {
    for rows in [&KR6, &PUMA] {
        let reach = arm::<f64>(rows, [-PI, PI]);
        let mut random = Random(5);
        for round in 0..50 {
            let mut values: [f64; 6] = random.vector();
            let way: [f64; 6] = random.direction();
            (values[2], values[4]) = (stretched(rows) + 0.1 * random.signed(), 0.0);
            // Along the axes before the wrist, which stays singular.
            let way = [way[0], way[1], way[2], 0.0, 0.0, 0.0];
            let mut start = values;
            for _ in 0..200 {
                for (value, way) in values.iter_mut().zip(way) {
                    *value += 0.001 * way;
                }
                let (found, _) = solutions!(reach, values, start);
                let first = found.first().expect("one").values;
                let step = first.iter().zip(start).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(step < 0.01, "{round}: {step} {values:?} {first:?}");
                start = first;
            }
        }
    }
}

#[test]
fn exactly_at_a_limit_of_a_joint_with_more_than_a_turn_no_turn_is_added() {
    let limit = 185_f64.to_radians();
    let reach = arm::<f64>(&KR6, [-limit, limit]);
    let wide = arm::<f64>(&KR6, [-350_f64.to_radians(), 350_f64.to_radians()]);
    let mut random = Random(7);
    for round in 0..200 {
        for (reach, at, joint) in [
            (&reach, limit, 3),
            (&reach, -limit, 3),
            (&wide, 350_f64.to_radians(), 5),
            (&wide, -350_f64.to_radians(), 5),
        ] {
            let mut start: [f64; 6] = random.vector();
            start[4] += 0.2 * start[4].signum();
            start[joint] = at;
            let (found, _) = solutions!(reach, start, start);
            let first = found.first().expect("the start is one");
            assert!(first.distance < 1e-7, "{round}, joint {joint} at {at}: {start:?} {first:?}");
        }
    }
}
