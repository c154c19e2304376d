//! A mechanism of nothing: what can be made of nothing can also be computed.

use dq8::{Backend, DualQuat};
use dq8_robot::ik::ReachError;
use dq8_robot::{Goal, Joint, OwnedMechanism, Reach};

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

#[test]
fn nothing_is_computed_of_nothing() {
    let owned = OwnedMechanism::<f64>::new(&[]).unwrap();
    let no_poses: &mut [DualQuat<f64>] = &mut [];
    let no_values: &[f64] = &[];
    for backend in Backend::available() {
        owned.job().backend(backend).poses(no_values, no_poses).unwrap();
        let hinge = [Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0])];
        let hinge = OwnedMechanism::new(&hinge).unwrap();
        hinge.job().backend(backend).poses(no_values, no_poses).unwrap();
        hinge.job().links(&[0]).backend(backend).poses(no_values, no_poses).unwrap();
        // No values, but links.
        let up = DualQuat::from_translation([0.0, 0.0, 2.0]);
        let post = OwnedMechanism::new(&[Joint::fixed(None, up)]).unwrap();
        let mut poses = [DualQuat::IDENTITY; 5];
        post.job().backend(backend).poses(no_values, &mut poses).unwrap();
        assert_eq!(poses, [up; 5], "{backend}");
        // No column of values either.
        let no_columns: &[&[f64]] = &[];
        let mut poses = [DualQuat::IDENTITY; 5];
        post.job().backend(backend).poses(no_columns, &mut poses).unwrap();
        assert_eq!(poses, [up; 5], "{backend}");
    }
}
