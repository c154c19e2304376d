//! Many goals in the shape of the tree: the same least squares as those of all rows, also where
//! joints share a freedom, and where weights differ from axis to axis.

use super::super::tree::{tree, values};
use super::tracking::{body, configuration, goals, targets, track_everywhere};
use super::{at, pose, problem, turned};
use dq8::DualQuat;
use dq8_fixtures::random::Random;
use dq8_robot::ik::{Goal, Options, Outcome, OwnedReach, Tracking};

/// A posture that has no weight changes nothing before the targets are reached, and makes every
/// search solve the dense equations.
fn dense(reach: OwnedReach<f64>) -> OwnedReach<f64> {
    let values = reach.view().mechanism().values();
    reach.with_posture(vec![0.3; values]).expect("a posture")
}

/// Weights that differ from axis to axis, some of them zero.
fn uneven(random: &mut Random, goal: Goal<f64>) -> Goal<f64> {
    let mut weights =
        || [(); 3].map(|()| if random.below(4) == 0 { 0.0 } else { random.between(0.2, 2.0) });
    let goal = goal.with_angular(weights()).with_linear(weights());
    if goal.angular == [0.0; 3] { goal.with_linear([1.0, 0.5, 0.0]) } else { goal }
}

/// Searches by the tree and by all rows end at the same values. Returns the largest difference, and
/// the number of searches that limits stopped.
fn differ(
    reach: &OwnedReach<f64>,
    targets: &[DualQuat<f64>],
    start: &[f64],
    options: &Tracking<f64>,
    bound: f64,
) -> (f64, usize) {
    let (mut most, mut limited) = (0.0_f64, 0);
    let rows = track_everywhere(&dense(reach.clone()), targets, start, options);
    for ((backend, values, reports), (_, wanted, others)) in
        track_everywhere(reach, targets, start, options).iter().zip(&rows)
    {
        assert_eq!(reports[0].iterations, others[0].iterations, "{backend}");
        for (value, wanted) in values.iter().zip(wanted) {
            let apart = (value - wanted).abs();
            assert!(apart < bound, "{backend}: {values:?} {wanted:?}");
            most = most.max(apart);
        }
        limited += usize::from(others[0].outcome == Outcome::AtLimits);
    }
    (most, limited)
}

fn options() -> [Tracking<f64>; 4] {
    let short = Options { max_iterations: 1, damping: 0.2, ..Options::track() };
    let long = Options { max_iterations: 4, ..Options::track() };
    let start = Tracking { start_weight: 0.3, ..Tracking::default() };
    let floating = Tracking { floating_weight: 0.5, ..Tracking::default() };
    [short.into(), long.into(), start, floating]
}

#[test]
fn many_goals_in_the_shape_of_the_tree_are_the_least_squares_of_all_rows() {
    let mut random = Random(41);
    let (mut limited, mut moved) = (0, 0.0_f64);
    for round in 0..60 {
        let near = configuration(&mut random);
        let even = problem(&body(), goals());
        let targets = targets(&even, &mut random, &near);
        let start: Vec<f64> = near.iter().map(|value| value + 0.1 * random.signed()).collect();
        let own = goals().iter().map(|&goal| uneven(&mut random, goal)).collect::<Vec<_>>();
        for reach in [even, problem(&body(), own)] {
            let (apart, stops) = differ(&reach, &targets, &start, &options()[round % 4], 1e-9);
            (moved, limited) = (moved.max(apart), limited + stops);
        }
    }
    // Another way of computing, and limits in its way.
    assert!(moved > 0.0 && limited > 20, "{moved} {limited}");
}

/// A posture at the start and the start itself weigh as much as the start alone with both weights.
#[test]
fn a_posture_weighs_in_the_shape_of_the_tree_too() {
    let mut random = Random(42);
    for _ in 0..20 {
        let near = configuration(&mut random);
        let reach = problem(&body(), goals());
        let targets = targets(&reach, &mut random, &near);
        let both = Tracking { posture_weight: 0.2, start_weight: 0.3, ..Tracking::default() };
        let alone = Tracking { start_weight: 0.13_f64.sqrt(), ..Tracking::default() };
        let rows = track_everywhere(&dense(reach.clone()), &targets, &near, &alone);
        let posed = reach.with_posture(near.clone()).expect("a posture");
        for ((backend, values, _), (_, wanted, _)) in
            track_everywhere(&posed, &targets, &near, &both).iter().zip(&rows)
        {
            assert!(super::near(values, wanted, 1e-9), "{backend}: {values:?} {wanted:?}");
        }
    }
}

/// Trees of joints of every kind, a third of which mimic others in any branch.
#[test]
fn joints_that_mimic_share_a_column_in_the_shape_of_the_tree() {
    let mut random = Random(43);
    let (mut shared, mut moved) = (0, 0.0_f64);
    for round in 0..150 {
        let joints = tree(&mut random, 14);
        let moves = |link: usize| {
            let mut link = Some(link);
            while let Some(index) = link.filter(|&link| joints[link].kind.values() == 0) {
                link = joints[index].parent;
            }
            link.is_some()
        };
        let mut asked: Vec<_> =
            (0..joints.len()).filter(|&link| moves(link)).map(Goal::pose).collect();
        asked.retain(|_| random.below(3) > 0);
        for goal in &mut asked {
            *goal = if round % 3 > 0 { uneven(&mut random, *goal) } else { *goal };
            *goal = goal.at(random.vector());
        }
        if asked.len() < 3 {
            continue;
        }
        let reach = problem(&joints, asked.clone());
        let near = values(&mut random, &joints);
        let targets: Vec<_> = asked
            .iter()
            .map(|goal| {
                let [x, y, z] = [0.1; 3].map(|size| size * random.signed());
                let there = pose(&reach, &near, goal.link) * at(x, y, z);
                there * turned(random.direction(), 0.2, goal.point)
            })
            .collect();
        let start: Vec<f64> = near.iter().map(|value| value + 0.05 * random.signed()).collect();
        let (apart, _) = differ(&reach, &targets, &start, &options()[round % 4], 1e-8);
        moved = moved.max(apart);
        shared += usize::from(joints.iter().any(|joint| joint.mimic.is_some()));
    }
    assert!(moved > 0.0 && shared > 50, "{moved} {shared}");
}
