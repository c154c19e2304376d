//! All cores give what one gives.

use super::*;
use dq8_robot::ik::Outcome;

/// Poses of the hand and the elbow that the arm reaches, with some that it does not and some that are none, and
/// random starts.
fn drawn(
    joints: &[Joint<f64>],
    robot: Mechanism<'_, f64>,
    count: usize,
) -> (Vec<DualQuat<f64>>, Vec<f64>) {
    let mut random = Random(11);
    let targets = (0..count).flat_map(|index| {
        let values = draw(&mut random, joints);
        let hand = match index % 97 {
            5 => at(3.0, 0.0, 0.0),
            6 => at(f64::NAN, 0.0, 0.0),
            _ => robot.link_pose(&values, 7).unwrap(),
        };
        [hand, robot.link_pose(&values, 3).unwrap()]
    });
    let targets = targets.collect();
    (targets, (0..count).flat_map(|_| draw(&mut random, joints)).collect())
}

fn goals() -> [Goal<f64>; 2] {
    [Goal::pose(7), Goal::position(3)]
}

/// NaN is not equal to itself.
fn bits(reports: &[Report<f64>]) -> Vec<([u32; 2], [u64; 2], Outcome)> {
    let each = |report: &Report<f64>| {
        let Report { iterations, restarts, angular_error, linear_error, outcome } = *report;
        ([iterations, restarts], [angular_error, linear_error].map(f64::to_bits), outcome)
    };
    reports.iter().map(each).collect()
}

#[test]
fn all_cores_give_every_bit_of_what_one_gives() {
    let joints = seven();
    let robot = mechanism::<f64>(&joints);
    let (goals, mut freedoms) = (goals(), vec![Freedom::default(); 7]);
    let reach = Reach::new(robot.view(), &goals, &mut freedoms).unwrap();
    let options = Options { max_iterations: 12, ..Options::default() };
    for count in [0, 1, 150] {
        let (targets, starts) = drawn(&joints, robot.view(), count);
        let mut outcomes = Vec::new();
        for (backend, values, reports) in solve_everywhere(&reach, &targets, &starts, &options) {
            let (mut all, mut of_all) = (starts.clone(), vec![Report::default(); count]);
            let job = reach.job().backend(backend).threads(usize::MAX);
            job.solve(&targets, &mut all, &mut of_all, &options).unwrap();
            assert!(all == values && bits(&of_all) == bits(&reports), "{backend}, {count}");
            outcomes.extend(reports.into_iter().map(|report| report.outcome));
        }
        let has = |outcome| outcomes.contains(&outcome);
        assert!(
            count < 1000
                || has(Outcome::Converged) && has(Outcome::Invalid) && has(Outcome::OutOfReach)
        );
    }
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    let joints = seven();
    let robot = mechanism::<f64>(&joints);
    let (goals, mut freedoms) = (goals(), vec![Freedom::default(); 7]);
    let reach = Reach::new(robot.view(), &goals, &mut freedoms).unwrap();
    let (targets, starts) = drawn(&joints, robot.view(), 201);
    for (of_targets, of_values) in [(399, 1400), (402, 1400), (400, 1399), (400, 1407)] {
        let (targets, starts) = (&targets[..of_targets], &starts[..of_values]);
        let (mut values, mut reports) = (starts.to_vec(), vec![Report::default(); 200]);
        let job = reach.job().threads(usize::MAX);
        let refused = job.solve(targets, &mut values, &mut reports, &Options::default());
        assert!(refused.is_err(), "{of_targets}, {of_values}");
        assert!(values == starts && reports.iter().all(|report| *report == Report::default()));
    }
}
