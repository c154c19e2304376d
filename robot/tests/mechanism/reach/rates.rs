//! How often a reachable target is reached, and in how many iterations.

use super::{apart, at, draw, mechanism, seven};
use dq8::{Backend, DualQuat, Real, Scalar};
use dq8_arms::{Random, gantry, puma, ur5};
use dq8_robot::Joint;
use dq8_robot::ik::{Goal, Options, OwnedReach, Report};
use dq8_robot::urdf::Robot;

/// The share that is reached, and the iterations that take there.
struct Rate {
    reached: f64,
    iterations: f64,
}

/// Targets from values within the limits, starts within them; of some backends the worst. What is
/// reported must be so by poses in `f64`.
fn rate<R: Scalar>(
    joints: &[Joint<f64>],
    links: &[usize],
    count: usize,
    options: &Options<f64>,
    backends: impl Iterator<Item = Backend>,
) -> Rate {
    let (exact, mut random) = (mechanism::<f64>(joints), Random(2026));
    let cast = |values: Vec<f64>| values.into_iter().map(<R as Real>::from_f64).collect::<Vec<R>>();
    let goals: Vec<_> = links.iter().map(|&link| Goal::pose(link)).collect();
    let reach = OwnedReach::new(mechanism(joints), goals).expect("goals");
    let robot = reach.view().mechanism();
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..count {
        let goal = cast(draw(&mut random, joints));
        targets.extend(links.iter().map(|&link| robot.link_pose(&goal, link).expect("a link")));
        starts.extend(cast(draw(&mut random, joints)));
    }
    // What the poses themselves are rounded by.
    let rounding = if size_of::<R>() == 4 { 2e-6 } else { 2e-14 };
    let mut worst = Rate { reached: 1.0, iterations: 0.0 };
    for backend in backends {
        let (mut values, mut reports) = (starts.clone(), vec![Report::default(); count]);
        let job = reach.job().backend(backend);
        job.solve(&targets, &mut values, &mut reports, &options.cast()).expect("lengths fit");
        let (mut reached, mut iterations) = (0.0, 0.0);
        let each = values.chunks(robot.values()).zip(targets.chunks(links.len()));
        for ((values, targets), report) in each.zip(&reports) {
            for joint in 0..joints.len() {
                let own = values[robot.values_of(joint).expect("a joint")].first();
                if let (Some([low, high]), Some(&value)) = (robot.limits(joint), own) {
                    assert!(low <= value && value <= high, "{value} of joint {joint}");
                }
            }
            let values: Vec<f64> = values.iter().map(|&value| value.into()).collect();
            let mut found = [0.0_f64; 2];
            for (&link, target) in links.iter().zip(targets) {
                let target = DualQuat::from_array(target.to_array().map(Into::into));
                let apart = apart(exact.link_pose(&values, link).expect("a link"), target);
                found = [found[0].max(apart[0]), found[1].max(apart[1])];
            }
            let told = [report.angular_error, report.linear_error].map(Into::<f64>::into);
            for (told, found) in told.into_iter().zip(found) {
                assert!((told - found).abs() < rounding, "{backend}: {told} is {found}");
            }
            if report.is_converged() {
                assert!(found.iter().all(|&found| found < 1e-5 + rounding), "{found:?}");
                assert!(report.iterations <= options.max_iterations);
                reached += 1.0;
                iterations += f64::from(report.iterations);
            }
        }
        worst.reached = worst.reached.min(reached / count as f64);
        worst.iterations = worst.iterations.max(iterations / reached);
    }
    worst
}

/// In both precisions.
fn reaches(joints: &[Joint<f64>], link: usize, count: usize, max_iterations: u32, asked: Rate) {
    let options = Options { max_iterations, ..Options::default() };
    let best = || [Backend::best()].into_iter();
    for (name, rate) in [
        ("f64", rate::<f64>(joints, &[link], count, &options, best())),
        ("f32", rate::<f32>(joints, &[link], count, &options, best())),
    ] {
        assert!(rate.reached >= asked.reached, "{name}: {}", rate.reached);
        assert!(rate.iterations < asked.iterations, "{name}: {}", rate.iterations);
    }
}

#[test]
fn an_arm_of_six_axes_reaches_99_of_100_random_targets_in_fewer_than_30_iterations() {
    reaches(&ur5().links(), 6, 500, 29, Rate { reached: 0.99, iterations: 7.0 });
}

/// With half of the space of its joints forbidden, an arm has fewer solutions for a target.
#[test]
fn narrow_limits_leave_97_of_100_and_998_of_1000_in_100_iterations() {
    reaches(&puma().links(), 6, 500, 29, Rate { reached: 0.97, iterations: 9.0 });
    reaches(&puma().links(), 6, 500, 100, Rate { reached: 0.998, iterations: 9.0 });
}

/// A UR5 on a slide and a thread; two slides, a thread, and a wrist of three hinges without limits.
#[test]
fn slides_and_threads_and_endless_hinges_are_no_harder() {
    reaches(&gantry().links(), 8, 400, 29, Rate { reached: 0.99, iterations: 7.0 });
    let (here, down) = (DualQuat::IDENTITY, [0.0, 0.0, -1.0]);
    let mut joints = vec![
        Joint::prismatic(None, here, [1.0, 0.0, 0.0]).with_limits([-1.0, 1.0]),
        Joint::prismatic(Some(0), here, [0.0, 1.0, 0.0]).with_limits([-1.0, 1.0]),
        Joint::screw(Some(1), here, down, 0.05).with_limits([-12.0, 12.0]),
    ];
    for (on, axis) in (2..).zip([super::Z, [0.0, 0.6, 0.8], [1.0, 0.0, 0.0]]) {
        joints.push(Joint::revolute(Some(on), at(0.0, 0.0, 0.1), axis));
    }
    let rate = rate::<f64>(&joints, &[5], 300, &Options::default(), Backend::available());
    assert!(rate.reached >= 0.99, "{}", rate.reached);
}

#[test]
fn with_default_options_arms_of_seven_axes_reach_998_of_1000_random_targets() {
    let asked = || Rate { reached: 0.998, iterations: 9.0 };
    reaches(&dq8_arms::seven().links(), 7, 1000, 100, asked());
    let robot = Robot::from_urdf(include_str!("../../../robots/arm7.urdf")).expect("a robot");
    reaches(robot.joints(), robot.link("hand").expect("a hand"), 1000, 100, asked());
    // On every backend.
    for rate in [
        rate::<f64>(&seven(), &[7], 500, &Options::default(), Backend::available()),
        rate::<f32>(&seven(), &[7], 500, &Options::default(), Backend::available()),
    ] {
        assert!(rate.reached >= 0.994 && rate.iterations < 10.0, "{}", rate.reached);
    }
}

/// Waist and arm: two legs, the head and the other arm keep still. And twelve components at once,
/// of joints that both arms share.
#[test]
fn a_hand_of_the_humanoid_reaches_as_many_and_both_hands_most_pairs_of_poses() {
    let text = include_str!("../../../robots/humanoid.urdf");
    let robot = Robot::from_urdf(text).expect("a robot");
    let [left, right] = ["left_palm", "right_palm"].map(|name| robot.link(name).expect("a palm"));
    reaches(robot.joints(), left, 300, 100, Rate { reached: 299.0 / 300.0, iterations: 20.0 });
    let (both, best) = ([left, right], [Backend::best()].into_iter());
    let both = rate::<f64>(robot.joints(), &both, 100, &Options::default(), best);
    assert!(both.reached >= 0.85, "{}", both.reached);
}

/// What restarts and steps of second order are worth is in the numbers.
#[test]
fn without_restarts_nine_of_ten_starts_lead_there() {
    let once = Options { max_iterations: 29, restarts: false, ..Options::default() };
    let best = [Backend::best()].into_iter();
    let rate = rate::<f64>(&ur5().links(), &[6], 500, &once, best);
    assert!((0.86..0.95).contains(&rate.reached), "{}", rate.reached);
}
