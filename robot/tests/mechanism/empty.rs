//! A mechanism of nothing: what can be made of nothing can also be computed.

use dq8::DualQuat;
use dq8_robot::ik::ReachError;
use dq8_robot::{Goal, OwnedMechanism, Reach};

type Pose = DualQuat<f32>;

#[test]
fn a_mechanism_without_joints_has_poses_and_nothing_to_reach() {
    let mechanism = OwnedMechanism::<f32>::new(&[]).unwrap();
    mechanism.view().link_poses(&[], &mut []).unwrap();
    mechanism.job().poses(&[0.0_f32; 0], &mut [Pose::IDENTITY; 0]).unwrap();
    assert_eq!(Reach::new(mechanism.view(), &[], &mut []).unwrap_err(), ReachError::NoGoals);
    // Without screws there is the tool alone.
    let arm = OwnedMechanism::<f32>::from_screws(&[], Pose::IDENTITY).unwrap();
    assert_eq!(arm.view().link_pose(&[], 0), Ok(Pose::IDENTITY));
    let unmoved = Reach::new(arm.view(), &[Goal::pose(0)], &mut []).unwrap_err();
    assert_eq!(unmoved, ReachError::Unmoved { goal: 0, link: 0 });
}
