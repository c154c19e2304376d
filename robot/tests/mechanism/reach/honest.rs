//! Lanes against each other, and cores; `arms/lanes.rs` holds them to one configuration.

use super::{draw, pose, problem, seven, solved};
use dq8::{DualQuat, Real, Scalar};
use dq8_fixtures::random::Random;
use dq8_robot::Joint;
use dq8_robot::ik::{Goal, Options, Outcome, OwnedReach};

/// Of random targets, some of them moved aside and one none at all, and random starts: solved in
/// this order and in the other, and on all cores, to the bit the same.
fn in_any_order<R: Scalar>(reach: &OwnedReach<R>, joints: &[Joint<f64>], far: fn(usize) -> f64) {
    let (goals, count) = (reach.view().goals(), 101);
    let mut random = Random(21);
    let mut drawn = |first: f64| -> Vec<R> {
        let mut values = draw(&mut random, joints);
        values[0] *= first;
        values.into_iter().map(<R as Real>::from_f64).collect()
    };
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for index in 0..count {
        let aside = R::from(if index % 9 == 4 { 0.4 } else { 0.0 });
        let aside = if index == 60 { R::NAN } else { aside };
        let aside = DualQuat::from_translation([aside, R::ZERO, R::ZERO]);
        let values = drawn(far(index));
        targets.extend(goals.iter().map(|goal| aside * pose(reach, &values, goal.link)));
        starts.extend(drawn(1.0));
    }
    let (each, options) = (starts.len() / count, Options::default());
    let there = solved(reach, &targets, &starts, &options);
    for (backend, values, reports) in &there {
        assert_eq!(values.len(), starts.len());
        let has = |outcome| reports.iter().any(|report| report.outcome == outcome);
        assert!(has(Outcome::Converged) && has(Outcome::Invalid), "{backend}");
        #[cfg(feature = "rayon")]
        {
            for some in [0, 1, count] {
                let mut all = starts[..some * each].to_vec();
                let mut of_all = vec![Default::default(); some];
                let job = reach.job().backend(*backend).threads(usize::MAX);
                let targets = &targets[..some * goals.len()];
                job.solve(targets, &mut all, &mut of_all, &options).expect("lengths fit");
                assert_eq!(all, values[..all.len()], "{backend}, {some}");
                // NaN is not equal to itself.
                assert_eq!(format!("{of_all:?}"), format!("{:?}", &reports[..some]), "{backend}");
            }
        }
    }
    let targets: Vec<_> = targets.rchunks(goals.len()).flatten().copied().collect();
    let starts: Vec<_> = starts.rchunks(each).flatten().copied().collect();
    let back = solved(reach, &targets, &starts, &options);
    for ((backend, values, reports), (_, reversed, mut last)) in there.iter().zip(back) {
        last.reverse();
        assert!(values.chunks(each).eq(reversed.rchunks(each)), "{backend}");
        assert_eq!(format!("{reports:?}"), format!("{last:?}"), "{backend}");
    }
}

/// With a posture too: where other lanes are stopped by limits, all are solved once more. And on a
/// slide without end, where lengths weigh by how far a target is, in each lane otherwise; and for
/// two goals.
#[test]
fn a_result_does_not_depend_on_other_configurations() {
    let arm = problem::<f32>(&seven(), [Goal::pose(7)]);
    in_any_order(&arm, &seven(), |_| 1.0);
    let posture = [0.1, 0.3, -0.2, -1.5, 0.4, 1.8, 0.3];
    in_any_order(&arm.with_posture(posture).expect("a posture"), &seven(), |_| 1.0);
    let mut joints = vec![Joint::prismatic(None, DualQuat::IDENTITY, [0.0, 1.0, 0.0])];
    for joint in seven() {
        let parent = Some(joint.parent.map_or(0, |parent| parent + 1));
        joints.push(Joint { parent, ..joint });
    }
    let gantry = problem::<f64>(&joints, [Goal::pose(8)]);
    in_any_order(&gantry, &joints, |index| f64::from(1 << (index % 8)));
    in_any_order(&problem::<f64>(&seven(), [Goal::pose(7), Goal::position(3)]), &seven(), |_| 1.0);
}
