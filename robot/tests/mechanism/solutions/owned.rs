//! An arm with memory of its own finds what the borrowed one does, and is kept beside a search.

use super::{Poses, families};
use crate::reach::seven;
use crate::tree::mechanism;
use dq8_robot::ik::{Family, Goal, OwnedReach, OwnedSixAxisArm, SolutionsError};

#[test]
fn an_arm_that_owns_its_memory_has_the_same_solutions() {
    let (_, mut other, _) = families()[1];
    other.axes[4].through = other.axes[4].through.map(|c| c + 0.1);
    let other = ("no family", other, Family::Other);
    for (name, plan, family) in families().into_iter().chain([other]) {
        let poses = Poses::<f64>::random(&plan, 4);
        let reach = poses.arm.0.clone().with_posture([0.25; 6]).expect("six values");
        let owned = OwnedSixAxisArm::new(reach).expect("six hinges");
        let six = poses.six();
        assert_eq!(format!("{:?}", owned.view()), format!("{six:?}"), "{name}");
        assert_eq!((owned.family(), owned.values()), (six.family(), six.values()));
        assert_eq!(owned.family(), family, "{name}");
        for (target, start) in poses.targets.iter().zip(&poses.values) {
            let mut scratch = vec![f64::NAN; six.scratch_len()];
            let wanted = six.solutions(*target, start, &mut scratch).expect("a target");
            assert!(!wanted.is_empty(), "{name}");
            assert_eq!(owned.solutions(*target, start), Ok(wanted), "{name}");
        }
        let mut found = vec![Default::default(); poses.targets.len()];
        owned.job().solutions(&poses.targets, &poses.values, &mut found).expect("lengths fit");
        assert_eq!(found, poses.solve(), "{name}");
    }
}

#[test]
fn an_arm_of_other_goals_is_refused() {
    let reach = OwnedReach::new(mechanism::<f64>(&seven()), Goal::pose(7)).expect("a problem");
    let refused = OwnedSixAxisArm::new(reach).expect_err("seven hinges");
    assert!(matches!(refused, SolutionsError::Hinges { hinges: 7 }), "{refused}");
}
