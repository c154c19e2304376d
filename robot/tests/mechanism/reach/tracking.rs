//! Following targets that move: weights that always act, ends, clips, velocities.

use super::{
    SETTLED, Solved, Z, apart, at, draw, mechanism, near, planar, pose, problem, seven, solve,
    solve_with, turned,
};
use dq8::scalar::vector;
use dq8::{Backend, DualQuat, Twist};
use dq8_fixtures::random::Random;
use dq8_robot::ik::{Goal, Options, Outcome, OwnedReach, RatesError, Report, Tracking};
use dq8_robot::{Joint, WorldAligned};

/// A body that floats, with limbs of hinges with limits, a slide, a screw, and a part that carries
/// nothing.
pub(super) fn body() -> Vec<Joint<f64>> {
    let mut joints = vec![Joint::floating(None, at(0.1, 0.0, 0.0))];
    for side in [-1.0, 1.0] {
        let first = joints.len();
        let hip = turned([0.6, 0.0, 0.8], 0.4 * side, [0.1, 0.2 * side, -0.1]);
        joints.push(Joint::revolute(Some(0), hip, [0.0, 1.0, 0.0]).with_limits([-0.5, 0.6]));
        joints.push(
            Joint::revolute(Some(first), at(0.1, 0.0, -0.3), [0.0, 0.6, 0.8])
                .with_limits([-0.2, 2.0]),
        );
        joints.push(Joint::revolute(Some(first + 1), at(0.0, 0.1, -0.4), Z));
        joints.push(Joint::fixed(Some(first + 2), at(0.05, 0.0, -0.1)));
    }
    joints.push(Joint::prismatic(Some(0), at(0.0, 0.0, 0.5), Z).with_limits([-0.1, 0.1]));
    joints.push(Joint::screw(Some(9), at(0.0, 0.1, 0.1), [1.0, 0.0, 0.0], 0.1));
    joints.push(Joint::revolute(Some(0), at(0.0, 0.0, 0.2), Z));
    joints
}

pub(super) fn goals() -> Vec<Goal<f64>> {
    let feet = [4, 8].map(|link| Goal::pose(link).weighing(0.4, 2.0).at([0.1, 0.02, -0.03]));
    let rest = [Goal::position(10), Goal::pose(0), Goal::orientation(2), Goal::position(6)];
    [&feet[..], &rest].concat()
}

/// Values, with a quaternion first.
pub(super) fn configuration(random: &mut Random) -> Vec<f64> {
    let mut values: Vec<f64> = (0..7).map(|_| random.signed()).collect();
    values[3] += 3.0;
    values.extend(draw(random, &body()[1..]));
    values
}

/// Targets near the poses of a configuration, in every direction, so that no values reach them all.
pub(super) fn targets(
    body: &OwnedReach<f64>,
    random: &mut Random,
    near: &[f64],
) -> Vec<DualQuat<f64>> {
    let mut target = |goal: &Goal<f64>| {
        let pose = pose(body, near, goal.link);
        let [x, y, z] = [0.1; 3].map(|size| size * random.signed());
        pose * at(x, y, z) * turned(random.direction(), 0.2, goal.point)
    };
    goals().iter().map(&mut target).collect()
}

/// On all backends.
pub(super) fn track_everywhere(
    reach: &OwnedReach<f64>,
    targets: &[DualQuat<f64>],
    start: &[f64],
    options: &Tracking<f64>,
) -> Vec<Solved<f64>> {
    let track = |backend| {
        let (mut values, mut reports) = (start.to_vec(), vec![Report::default()]);
        let job = reach.job().backend(backend);
        job.sequence(&[1], targets, &mut values, &mut reports, options).expect("lengths fit");
        (backend, values, reports)
    };
    Backend::available().map(track).collect()
}

/// A slide between a target, a posture and its start divides its way by the squares of their
/// weights.
#[test]
fn posture_and_start_always_weigh_what_they_are_said_to() {
    let slide = Joint::prismatic(None, DualQuat::IDENTITY, [1.0, 0.0, 0.0]);
    let reach = problem(&[slide], [Goal::position(0)]).with_posture([5.0]).expect("a posture");
    // The less they weigh, the flatter it is where steps gain too little.
    for [posture_weight, start_weight, bound] in
        [[0.5, 0.7, 1e-6], [0.5, 0.0, 1e-4], [0.0, 0.7, 1e-3]]
    {
        let options =
            Options { max_iterations: 60, damping: 0.0, least_gain: 0.0, ..Options::track() };
        let options = Tracking { posture_weight, start_weight, ..options.into() };
        let [to_posture, to_start] = [posture_weight, start_weight].map(|weight| weight * weight);
        // From the target itself too, which it leaves for the posture.
        for start in [-1.0, 2.0] {
            let targets = [at(2.0, 0.0, 0.0)];
            for (backend, values, _) in track_everywhere(&reach, &targets, &[start], &options) {
                let wishes = to_posture * 5.0 + to_start * start;
                let least = (2.0 + wishes) / (1.0 + to_posture + to_start);
                assert!((values[0] - least).abs() < bound, "{backend}: {values:?} {least}");
            }
        }
    }
}

/// A posture without a weight takes what the goals leave free, also of what tracks. Its own tip is
/// the target here, so that the posture itself is the only answer that is right.
#[test]
fn a_posture_without_a_weight_takes_what_is_free_while_tracking() {
    let posture = [0.3, 0.5, -0.4, 0.8];
    let reach = problem(&planar(&[0.5; 4]), [Goal::position(4)]);
    let reach = reach.with_posture(posture).expect("a posture");
    let (target, options) = (pose(&reach, &posture, 4), Tracking::default());
    let mut values = [0.6, 0.1, -0.2, 0.9];
    for _ in 0..50 {
        let mut scratch = vec![f64::NAN; reach.view().scratch_len()];
        reach.view().track(&[target], &mut values, &mut scratch, &options).expect("lengths fit");
    }
    assert!(near(&values, &posture, SETTLED), "{values:?}");
}

/// The options cannot make it begin again, which would leave the values where the last frame had
/// them. A clip of one frame takes restarts out by itself, so that it has the right answer; many of
/// these searches get stuck.
#[test]
fn tracking_never_begins_again_whatever_the_options_say() {
    let reach = problem(&seven(), [Goal::pose(7)]);
    let (mut random, mut converged) = (Random(74), 0);
    let mut scratch = vec![f64::NAN; reach.view().scratch_len()];
    for _ in 0..60 {
        let [there, start] = [(); 2].map(|()| draw(&mut random, &seven()));
        let target = [pose(&reach, &there, 7)];
        let options = Options { max_iterations: 60, restarts: true, ..Options::track() }.into();
        let mut values = start.clone();
        let report = reach.view().track(&target, &mut values, &mut scratch, &options);
        let report = report.expect("lengths fit");
        for (backend, expected, wanted) in track_everywhere(&reach, &target, &start, &options) {
            assert!(near(&values, &expected, 1e-6), "{backend}: {values:?} {expected:?}");
            let [found, wanted] = [report, wanted[0]].map(|of| (of.outcome, of.iterations));
            assert_eq!(found, wanted, "{backend}");
        }
        converged += usize::from(report.is_converged());
    }
    assert!((10..60).contains(&converged), "{converged}");
}

#[test]
fn a_step_that_gains_too_little_is_the_last() {
    let here = DualQuat::IDENTITY;
    let slide = [Joint::prismatic(None, here, [1.0, 0.0, 0.0]), Joint::fixed(Some(0), here)];
    let slide = problem(&slide, [Goal::position(0), Goal::position(1)]);
    let iterations = [0.0, 0.05].map(|least_gain| {
        let options = Options { least_gain, restarts: false, ..Options::default() };
        let targets = [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0)];
        let (values, report) = solve_with(&slide, &targets, [0.3], &options);
        assert_eq!(report.outcome, Outcome::Stalled);
        assert!((values[0] - 0.5).abs() < 2e-2, "{values:?}");
        report.iterations
    });
    assert!(iterations[1] <= 3 && iterations[0] >= 6, "{iterations:?}");
}

/// What floats may be anywhere.
#[test]
fn far_from_the_base_tracking_weighs_as_it_does_near_it() {
    let mut reach = problem(&body(), goals());
    let mut random = Random(43);
    let near = configuration(&mut random);
    let targets = targets(&reach, &mut random, &near);
    let [tracked, solved] = [true, false].map(|tracks| {
        [0.0, 1000.0].map(|far| {
            let (mut values, away) = (near.clone(), at(far, 0.0, 0.0));
            values[4] += far;
            let targets: Vec<_> = targets.iter().map(|&target| away * target).collect();
            let reached = match tracks {
                true => reach.track(&targets, &mut values, &Tracking::default()),
                false => reach.solve(&targets, &mut values, &Options::track()),
            };
            reached.expect("lengths fit");
            values[7..].to_vec()
        })
    });
    let apart =
        |[a, b]: &[Vec<f64>; 2]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let (tracked, solved) = (apart(&tracked), apart(&solved));
    assert!(tracked < 1e-8 && solved > 1e-4, "{tracked} {solved}");
}

/// A point of a link is what a fixed link there would be.
#[test]
fn a_goal_at_a_point_is_that_of_a_link_fixed_there() {
    for point in [[0.1, -0.2, 0.3], [1.0; 3]] {
        let mut joints = seven();
        joints.push(Joint::fixed(Some(7), DualQuat::from_translation(point)));
        let mut random = Random(45);
        let [at_point, at_link] =
            [Goal::pose(7).at(point), Goal::pose(8)].map(|goal| problem(&joints, [goal]));
        for _ in 0..20 {
            let [there, start] = [(); 2].map(|()| draw(&mut random, &joints));
            let target = pose(&at_link, &there, 8);
            let start: [f64; 7] = start.try_into().expect("seven");
            let (own, report) = solve(&at_point, target, start);
            let (link, _) = solve(&at_link, target, start);
            assert!(report.is_converged() && near(&own, &link, 1e-9), "{own:?} {link:?}");
            assert!(apart(pose(&at_point, &own, 8), target)[1] < super::REACHED);
        }
    }
}

/// Whatever the lengths of the clips, and however many there are; frames without targets stand
/// still.
#[test]
fn a_clip_is_its_frames_one_after_the_other() {
    let reach = problem(&body(), goals());
    let (count, options) = (reach.view().mechanism().values(), Tracking::default());
    let mut random = Random(47);
    let clips: Vec<usize> = (0..70).map(|clip| [3, 0, 7, 1, 12][clip % 5]).collect();
    let frames: usize = clips.iter().sum();
    let near = configuration(&mut random);
    let mut all: Vec<_> = (0..frames).flat_map(|_| targets(&reach, &mut random, &near)).collect();
    all[5 * goals().len()] = DualQuat::from_array([f64::NAN; 8]);
    let start: Vec<f64> = near.repeat(frames);
    for backend in Backend::available() {
        let job = reach.job().backend(backend);
        let (mut values, mut reports) = (start.clone(), vec![Report::default(); frames]);
        job.sequence(&clips, &all, &mut values, &mut reports, &options).expect("lengths fit");
        let mut frame = 0;
        for &length in &clips {
            let mut own = near.clone();
            for _ in 0..length {
                let (mut report, here) =
                    ([Report::default()], &all[frame * goals().len()..][..goals().len()]);
                job.sequence(&[1], here, &mut own, &mut report, &options).expect("lengths fit");
                assert_eq!(values[frame * count..][..count], own, "{backend}: {frame}");
                assert_eq!(reports[frame].outcome, report[0].outcome, "{backend}: {frame}");
                frame += 1;
            }
        }
        assert_eq!(reports[5].outcome, Outcome::Invalid);
        // Each task has whole clips, with their frames.
        #[cfg(feature = "rayon")]
        {
            let (mut parted, mut said) = (start.clone(), vec![Report::default(); frames]);
            let many = job.threads(usize::MAX);
            many.sequence(&clips, &all, &mut parted, &mut said, &options).expect("lengths fit");
            assert_eq!(parted, values, "{backend}");
            let [said, alone] =
                [&said, &reports].map(|all| all.iter().map(|of| of.outcome).collect::<Vec<_>>());
            assert_eq!(said, alone, "{backend}");
        }
        let wrong = job.sequence(&[frames + 1], &all, &mut values, &mut reports, &options);
        assert!(wrong.is_err());
    }
}

/// Goals whose weights differ from axis to axis, if only by a rounding.
fn by_rows(goals: &[Goal<f64>]) -> Vec<Goal<f64>> {
    let bent = |weights: [f64; 3]| [weights[0], weights[1] * (1.0 + 1e-15), weights[2]];
    goals.iter().map(|g| g.with_angular(bent(g.angular)).with_linear(bent(g.linear))).collect()
}

/// Where the gradient of |W(Jq̇ − v)|² + λ²|q̇|² vanishes, by the Jacobians of the links.
#[test]
fn rates_are_the_damped_least_squares_of_the_velocities() {
    let machine = mechanism::<f64>(&body());
    let (mut random, damping) = (Random(49), 0.1);
    let count = 11;
    // About the second axis of its link each may turn as it likes.
    let free = |goal: &Goal<f64>| {
        let [x, _, z] = goal.angular;
        goal.with_angular([x, 0.0, 0.7 * z])
    };
    let free: Vec<_> = goals().iter().map(free).collect();
    for goals in [goals(), by_rows(&goals()), free] {
        let reach = problem(&body(), goals.clone());
        let view = reach.view();
        let values: Vec<f64> = (0..count).flat_map(|_| configuration(&mut random)).collect();
        let twists: Vec<_> = (0..count * goals.len())
            .map(|_| Twist::from_array([(); 6].map(|()| random.signed())))
            .collect();
        let (size, number) = (machine.view().rates(), machine.view().values());
        for backend in Backend::available() {
            let mut rates = vec![f64::NAN; count * size];
            let mut scratch = vec![f64::NAN; view.batch_scratch_len()];
            let job = reach.job().backend(backend);
            job.rates_in(&mut scratch, &values, &twists, damping, &mut rates).expect("lengths fit");
            for (index, rates) in rates.chunks_exact(size).enumerate() {
                let values = &values[index * number..][..number];
                let length = 0.125 * longest();
                let mut gradient = vec![0.0; size];
                for (goal, twist) in goals.iter().zip(&twists[index * goals.len()..]) {
                    let mut columns = vec![Twist::ZERO; size];
                    let pose =
                        machine.view().link_jacobian(WorldAligned, values, goal.link, &mut columns);
                    let turn = pose.expect("a link").rotation();
                    let arm = turn.rotate(goal.point);
                    // Weights are along the axes of the link.
                    let of_link = |of: [f64; 3]| turn.conjugate().rotate(of);
                    for of in &mut columns {
                        of.linear = of.velocity_at(arm);
                    }
                    let done = columns.iter().zip(rates).map(|(of, &rate)| of.scale(rate));
                    let left = done.fold(Twist::ZERO, |sum, of| sum + of) - *twist;
                    let weighed = |of: [f64; 3], weights: [f64; 3]| -> [f64; 3] {
                        let of = of_link(of);
                        core::array::from_fn(|i| weights[i] * weights[i] * of[i])
                    };
                    let turned = weighed(left.angular, goal.angular);
                    let moved = weighed(left.linear, goal.linear.map(|weight| weight / length));
                    for (sum, of) in gradient.iter_mut().zip(&columns) {
                        *sum += vector::dot(turned, of_link(of.angular))
                            + vector::dot(moved, of_link(of.linear));
                    }
                }
                for (rate, (sum, speed)) in gradient.iter().zip(rates).enumerate() {
                    // A slide's rate is in lengths: what floats, and the one on it.
                    let unit = if matches!(rate, 3..=5 | 12) { length } else { 1.0 };
                    let slope = sum * unit + damping * damping * speed / unit;
                    assert!(slope.abs() < 1e-8, "{backend}: rate {rate}: {slope}");
                }
                assert_eq!(rates[14], 0.0, "it carries no goal");
            }
        }
    }
}

/// The longest way to a goal of the body.
fn longest() -> f64 {
    let joints = body();
    let way = |goal: &Goal<f64>| {
        let (mut sum, mut link) = (vector::norm(goal.point), Some(goal.link));
        while let Some(at) = link {
            let slide = if at == 9 { 0.1 } else { 0.0 };
            sum += vector::norm(joints[at].placement.translation()) + slide;
            link = joints[at].parent;
        }
        sum
    };
    goals().iter().map(way).fold(0.0, f64::max)
}

#[test]
fn rates_lead_no_joint_beyond_its_limit_and_the_others_make_up_for_it() {
    let mut joints = planar(&[1.0, 1.0, 1.0]);
    joints[1] = joints[1].with_limits([-2.0, 0.5]);
    let reach = problem(&joints, [Goal::position(3)]);
    let (view, mut scratch) = (reach.view(), vec![f64::NAN; reach.view().scratch_len()]);
    let mut speed = |angle: f64, rates: &mut [f64; 3]| {
        let up = Twist { angular: [0.0; 3], linear: [-0.4, 0.3, 0.0] };
        view.rates(&[0.0, angle, 0.4], &[up], 0.0, rates, &mut scratch).expect("lengths fit");
        let h = 1e-6;
        let place = |by: f64| {
            let values = [by * rates[0], angle + by * rates[1], 0.4 + by * rates[2]];
            pose(&reach, &values, 3).translation()
        };
        let (a, b) = (place(h), place(-h));
        assert!(((a[0] - b[0]) / (2.0 * h) + 0.4).abs() < 1e-6, "{angle}: {rates:?}");
        assert!(((a[1] - b[1]) / (2.0 * h) - 0.3).abs() < 1e-6, "{angle}: {rates:?}");
    };
    let [mut free, mut held] = [[0.0; 3]; 2];
    speed(0.49, &mut free);
    speed(0.5, &mut held);
    assert!(free[1] > 0.01 && held[1] == 0.0, "{free:?} {held:?}");
}

#[test]
fn rates_of_what_is_no_number_are_refused_and_not_written() {
    let reach = problem(&planar(&[1.0]), [Goal::position(1)]);
    let (view, mut scratch) = (reach.view(), vec![0.0; reach.view().scratch_len()]);
    let (fine, mut rates) = (Twist::default(), [7.0]);
    let nan = Twist { angular: [0.0, f64::NAN, 0.0], linear: [0.0; 3] };
    for (values, twist, damping, wanted) in [
        (f64::INFINITY, fine, 0.0, "value 0"),
        (0.0, nan, 0.0, "twist 0"),
        (0.0, fine, -1.0, "damping"),
    ] {
        let error =
            view.rates(&[values], &[twist], damping, &mut rates, &mut scratch).expect_err(wanted);
        assert!(
            error.to_string().contains(wanted) && !matches!(error, RatesError::Shape(_)),
            "{error}"
        );
    }
    let short = view.rates(&[0.0], &[], 0.0, &mut rates, &mut scratch);
    assert!(matches!(short, Err(RatesError::Shape(_))));
    assert_eq!(rates, [7.0]);
}
