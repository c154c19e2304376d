//! A problem with memory of its own is the borrowed one, field by field.

use super::{mechanism, planar, seven};
use dq8_robot::ik::{Freedom, Goal, OwnedReach, Reach, ReachError};

#[test]
fn a_problem_that_owns_its_memory_asks_the_same() {
    for (joints, goals) in [
        (planar(&[1.0, 0.5, 0.25]), vec![Goal::position(3)]),
        (seven(), vec![Goal::pose(7), Goal::position(3)]),
    ] {
        let arm = mechanism::<f64>(&joints);
        let posture = vec![0.1; arm.view().values()];
        let mut freedoms = vec![Freedom::default(); arm.view().rates()];
        let borrowed = Reach::new(arm.view(), &goals, &mut freedoms).expect("a problem");
        let owned = OwnedReach::new(arm.clone(), goals.clone()).expect("a problem");
        assert_eq!(format!("{:?}", owned.view()), format!("{borrowed:?}"));
        let borrowed = borrowed.with_posture(&posture).expect("as many values");
        let owned = owned.with_posture(posture.clone()).expect("as many values");
        assert_eq!(format!("{:?}", owned.view()), format!("{borrowed:?}"));
        let refused = owned.with_posture([0.0]).expect_err("one value too few, or many");
        assert!(matches!(refused, ReachError::PostureLength { length: 1, .. }));
        let refused = OwnedReach::new(arm, []).expect_err("no goals");
        assert!(matches!(refused, ReachError::NoGoals));
    }
}

#[test]
fn a_problem_that_owns_its_memory_follows_one_goal_as_the_borrowed_one_does() {
    let mut owned = OwnedReach::new(mechanism::<f64>(&seven()), Goal::pose(7)).expect("a problem");
    let target = owned.mechanism().link_pose(&super::THERE, 7).expect("a link");
    let options = dq8_robot::ik::Options { restarts: true, ..Default::default() };
    let (mut values, mut others) = (super::START, super::START);
    let report = owned.follow(&[target], &mut values, &options).expect("lengths fit");
    let mut scratch = vec![f64::NAN; owned.view().scratch_len()];
    let other = owned.view().follow(&[target], &mut others, &mut scratch, &options);
    assert_eq!((Ok(report), values), (other, others));
    assert_eq!(report.restarts, 0);
}

/// Known before there is a mechanism.
#[test]
fn the_scratch_of_a_chain_is_that_of_its_mechanism() {
    const SEVEN: usize = Reach::<f64>::chain_scratch_bound(7, 1);
    let lengths = [0.5; 9];
    for (joints, values) in
        (1..9).map(|count| (planar(&lengths[..count]), count)).chain([(seven(), 7)])
    {
        let arm = mechanism::<f64>(&joints);
        for goals in 1..4 {
            let bound = Reach::<f64>::chain_scratch_bound(values, goals);
            assert_eq!(bound, Reach::scratch_bound(arm.view(), goals), "{values} {goals}");
        }
        let reach = OwnedReach::new(arm, Goal::pose(values)).expect("a problem");
        assert_eq!(reach.view().scratch_len(), Reach::<f64>::chain_scratch_bound(values, 1));
    }
    // The guide says so.
    assert_eq!((SEVEN, Reach::<f32>::chain_scratch_bound(7, 1)), (227, 235));
}
