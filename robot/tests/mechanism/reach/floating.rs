//! The weight of floating joints against their start.

use super::tracking::{body, configuration, goals, targets, track_everywhere};
use super::{apart, at, near, pose, problem, turned};
use dq8::DualQuat;
use dq8_fixtures::random::Random;
use dq8_robot::Joint;
use dq8_robot::ik::{Goal, Options, Tracking};

/// The options of a search that goes on until it stands still.
fn thorough() -> Tracking<f64> {
    let options =
        Options { max_iterations: 300, damping: 0.0, least_gain: 0.0, ..Options::track() };
    Options { length_per_radian: Some(0.3), ..options }.into()
}

/// For one goal by the dense equations, and for two by those in the shape of the tree.
#[test]
fn a_floating_joint_divides_its_way_by_the_squares_of_the_weights() {
    let joints =
        [Joint::floating(None, at(0.3, 0.2, 0.1)), Joint::fixed(Some(0), at(0.0, 0.0, 0.0))];
    let start = [0.0, 0.6, 0.0, 0.8, 1.0, -2.0, 0.5];
    for links in [&[0][..], &[0, 1]] {
        let reach =
            problem(&joints, links.iter().map(|&link| Goal::pose(link)).collect::<Vec<_>>());
        let first = pose(&reach, &start, 0);
        let turn = turned([0.6, 0.0, 0.8], 0.4, [0.0; 3]);
        let way = [0.02, -0.3, 0.1];
        for weight in [0.3, 1.0, 2.0] {
            let options = Tracking { floating_weight: weight, ..thorough() };
            let pull = links.len() as f64;
            let part = pull / (pull + weight * weight);
            for (moved, wanted) in [
                (first * turn, first * turned([0.6, 0.0, 0.8], 0.4 * part, [0.0; 3])),
                (
                    DualQuat::from_translation(way) * first,
                    DualQuat::from_translation(way.map(|size| part * size)) * first,
                ),
            ] {
                let targets = vec![moved; links.len()];
                for (backend, values, _) in track_everywhere(&reach, &targets, &start, &options) {
                    let [angle, distance] = apart(pose(&reach, &values, 0), wanted);
                    assert!(
                        angle < 1e-3 && distance < 1e-3,
                        "{backend}: {weight} {angle} {distance} {links:?}"
                    );
                }
            }
        }
    }
}

/// The floating joint stays where it starts, and the other joints move as they did.
#[test]
fn the_weight_of_what_floats_is_a_goal_for_it_at_its_start() {
    let mut random = Random(46);
    let mut slower = 0;
    for _ in 0..12 {
        let start = configuration(&mut random);
        let plain = problem(&body(), goals());
        let mut asked = targets(&plain, &mut random, &start);
        let weighed = Tracking { floating_weight: 0.7, ..thorough() };
        let found = track_everywhere(&plain, &asked, &start, &weighed);
        let free = track_everywhere(&plain, &asked, &start, &thorough());
        let stay = [Goal::position(0), Goal::orientation(0)]
            .map(|goal| goal.weighing(0.7 * goal.angular[0], 0.7 * goal.linear[0]));
        let with = problem(&body(), [&goals()[..], &stay].concat());
        asked.extend([pose(&plain, &start, 0); 2]);
        let wanted = track_everywhere(&with, &asked, &start, &thorough());
        for (((backend, values, _), (_, wanted, _)), (_, free, _)) in
            found.iter().zip(&wanted).zip(&free)
        {
            assert!(near(&values[..7], &wanted[..7], 3e-3), "{backend}: {values:?} {wanted:?}");
            assert!(near(&values[7..], &wanted[7..], 5e-2), "{backend}: {values:?} {wanted:?}");
            let way = |values: &[f64]| apart(pose(&plain, values, 0), asked[6])[1];
            slower += usize::from(way(values) < way(free));
        }
    }
    assert!(slower > 8, "{slower}");
}
