//! What is no arm of six hinges, no target and no start.

use super::Poses;
use dq8::{DualQuat, ShapeError};
use dq8_arms::{Random, gantry, seven, six_of_any_kind, ur5};
use dq8_robot::ik::{Goal, OwnedReach, ReachError, SixAxisArm, Solutions, SolutionsError};
use dq8_robot::{Joint, OwnedMechanism};

fn refused(joints: &[Joint<f64>], goals: &[Goal<f64>]) -> SolutionsError {
    let mechanism = OwnedMechanism::new(joints).expect("a mechanism");
    let reach: Result<_, ReachError> = OwnedReach::new(mechanism, goals);
    SixAxisArm::new(reach.expect("goals").view()).map(|_| ()).expect_err("no arm of six hinges")
}

#[test]
fn what_is_no_arm_of_six_hinges_is_named() {
    let (six, seven, eight) = (ur5().links(), seven().links(), gantry().links());
    assert_eq!(refused(&seven, &[Goal::pose(7)]), SolutionsError::Hinges { hinges: 7 });
    assert_eq!(refused(&six, &[Goal::pose(3)]), SolutionsError::Hinges { hinges: 4 });
    assert_eq!(refused(&eight, &[Goal::pose(8)]), SolutionsError::Joint { joint: 0 });
    assert_eq!(refused(&six, &[Goal::position(6)]), SolutionsError::NoPose);
    let two = [Goal::pose(6), Goal::pose(5)];
    assert_eq!(refused(&six, &two), SolutionsError::Goals { goals: 2 });
    let mut mimics = six.clone();
    mimics[4] = mimics[4].mimicking(1, 1.0, 0.0);
    assert_eq!(refused(&mimics, &[Goal::pose(6)]), SolutionsError::Joint { joint: 4 });
}

#[test]
fn bad_targets_starts_and_lengths_are_named_and_nothing_is_written() {
    let poses = Poses::<f64>::random(&ur5(), 5);
    let (six, starts) = (poses.six(), vec![[0.1; 6]; 5]);
    let before = vec![six.solutions(poses.targets[0], &[0.1; 6], &mut []).expect("a target"); 5];
    let mut found = before.clone();
    let job = six.job();
    let with = |factor: f64, number: Option<f64>| {
        let mut targets = poses.targets.clone();
        let mut array = targets[3].to_array().map(|c| c * factor);
        array[6] = number.unwrap_or(array[6]);
        targets[3] = DualQuat::from_array(array);
        targets
    };
    let error = job.solutions(&with(1.0, Some(f64::INFINITY)), &starts, &mut found);
    assert_eq!(error, Err(SolutionsError::Target { index: 3, value: f64::INFINITY }));
    let error = job.solutions(&with(1.0, Some(f64::NAN)), &starts, &mut found);
    assert!(matches!(error, Err(SolutionsError::Target { index: 3, value }) if value.is_nan()));
    let error = job.solutions(&with(1.01, None), &starts, &mut found);
    let Err(SolutionsError::NotUnit { index: 3, norm }) = error else { panic!("{error:?}") };
    assert!((norm - 1.01).abs() < 1e-12);
    let mut bad = starts.clone();
    bad[2][4] = f64::NEG_INFINITY;
    let error = job.solutions(&poses.targets, &bad, &mut found);
    let start = SolutionsError::Start { index: 2, hinge: 4, value: f64::NEG_INFINITY };
    assert_eq!(error, Err(start));
    for (targets, starts, what) in [(5, 4, "starts"), (4, 4, "found")] {
        let error = job.solutions(&poses.targets[..targets], &vec![[0.0; 6]; starts], &mut found);
        let Err(SolutionsError::Shape(ShapeError::Length { what: of, .. })) = error else {
            panic!("{error:?}")
        };
        assert_eq!(of, what);
    }
    assert_eq!(found, before);
    // What is nearly unit is made so.
    job.solutions(&with(1.0005, None), &starts, &mut found).expect("targets");
    assert_eq!(found[3].len(), before.len().max(found[3].len()));
}

#[test]
fn too_little_scratch_is_named() {
    let poses = Poses::<f64>::random(&six_of_any_kind(&mut Random(4)), 1);
    let (six, mut found) = (poses.six(), [Solutions::default()]);
    let short = |length: usize| vec![0.0; length - 1];
    let (one, many) = (six.scratch_len(), six.batch_scratch_len());
    let length = |length, expected| {
        SolutionsError::Shape(ShapeError::Length { what: "scratch", length, expected })
    };
    let alone = six.solutions(poses.targets[0], &[0.0; 6], &mut short(one));
    assert_eq!(alone.map(|_| ()), Err(length(one - 1, one)));
    let job = six.job();
    let error = job.solutions_in(&mut short(many), &poses.targets, &[[0.0; 6]], &mut found);
    assert_eq!(error, Err(length(many - 1, many)));
}
