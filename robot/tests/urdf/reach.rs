//! Inverse kinematics of the robots of this repository, of many configurations.

use dq8::{Real, simd::Float};
use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach, Report};
use dq8_robot::urdf::Robot;

const ARM: &str = include_str!("../../robots/arm7.urdf");
const HUMANOID: &str = include_str!("../../robots/humanoid.urdf");

/// The same numbers everywhere, in [0, 1).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 31)
    }
}

/// How many of random targets from random starts, both within the limits, are reached with default
/// options; by the poses of the values that are returned.
fn reached<R: Real + Float>(file: &str, links: &[&str], count: usize) -> usize {
    let robot = Robot::from_urdf(file).unwrap();
    let owned = robot.cast::<R>().unwrap();
    let mechanism = owned.view();
    let limits: Vec<[f64; 2]> =
        robot.value_limits().into_iter().map(|limits| limits.unwrap_or([-3.0, 3.0])).collect();
    let mut random = Random(12345);
    let mut draw = || -> Vec<R> {
        let within = |[low, high]: &[f64; 2]| low + (high - low) * random.next();
        limits.iter().map(within).map(<R as Real>::from_f64).collect()
    };
    let links: Vec<usize> = links.iter().map(|link| robot.link(link).unwrap()).collect();
    let (mut targets, mut values) = (Vec::new(), Vec::new());
    for _ in 0..count {
        let goal = draw();
        targets.extend(links.iter().map(|&link| mechanism.link_pose(&goal, link).unwrap()));
        values.extend(draw());
    }
    let goals: Vec<Goal<R>> = links.iter().map(|&link| Goal::pose(link)).collect();
    let mut freedoms = vec![Freedom::default(); mechanism.rates()];
    let reach = Reach::new(mechanism, &goals, &mut freedoms).unwrap();
    let mut reports = vec![Report::default(); count];
    reach.job().solve(&targets, &mut values, &mut reports, &Options::default()).unwrap();
    let size = mechanism.values();
    // 10⁻⁵ in the translation, and as much in the rotation at this distance; poses are rounded too.
    let near = 4e-5;
    for (index, report) in reports.iter().enumerate() {
        let own = &values[index * size..][..size];
        for (value, [low, high]) in own.iter().zip(&limits) {
            let number: f64 = (*value).into();
            assert!((low - 1e-6..=high + 1e-6).contains(&number), "{value}");
        }
        for (&link, &target) in links.iter().zip(&targets[index * links.len()..]) {
            let apart = mechanism.link_pose(own, link).unwrap().distance_to(target).into();
            assert!(report.outcome != Outcome::Converged || apart < near, "{index}: {apart}");
        }
    }
    reports.iter().filter(|report| report.outcome == Outcome::Converged).count()
}

#[test]
fn with_default_options_the_arm_reaches_998_of_1000_random_targets() {
    let (double, single) =
        (reached::<f64>(ARM, &["hand"], 1000), reached::<f32>(ARM, &["hand"], 1000));
    assert!(double >= 998 && single >= 998, "{double} {single}");
}

/// Waist and arm: two legs, the head and the other arm keep still.
#[test]
fn a_hand_of_the_humanoid_reaches_as_many() {
    let (double, single) = (
        reached::<f64>(HUMANOID, &["left_palm"], 300),
        reached::<f32>(HUMANOID, &["left_palm"], 300),
    );
    assert!(double >= 299 && single >= 299, "{double} {single}");
}

/// Twelve components at once, of joints that both arms share.
#[test]
fn both_hands_of_the_humanoid_reach_most_pairs_of_poses() {
    let both = reached::<f64>(HUMANOID, &["left_palm", "right_palm"], 100);
    assert!(both >= 85, "{both}");
}
