//! All solutions of an arm of six axes.

use dq8::{Backend, DualQuat, Scalar};
use dq8_fixtures::turns::Job;
use dq8_robot::ik::{Goal, OwnedReach, SixAxisArm, Solutions};
use dq8_robot::{Joint, OwnedMechanism};

/// The arm as the only goal's.
pub fn reach<R: Scalar>(joints: &[Joint<f64>]) -> OwnedReach<R> {
    let joints: Vec<Joint<R>> = joints.iter().map(Joint::cast).collect();
    let mechanism = OwnedMechanism::new(&joints).expect("a robot");
    OwnedReach::new(mechanism, [Goal::pose(joints.len() - 1)]).expect("a goal")
}

/// Of the poses at all values, each from values of zero.
pub fn job<'a, R: Scalar>(backend: Backend, reach: &'a OwnedReach<R>, values: &[f64]) -> Job<'a> {
    let arm = SixAxisArm::new(reach.view()).expect("six hinges");
    let values: Vec<R> = values.iter().map(|&value| <R as dq8::Real>::from_f64(value)).collect();
    let mut targets = vec![DualQuat::IDENTITY; values.len() / 6];
    let robot = reach.view().mechanism();
    for (target, values) in targets.iter_mut().zip(values.chunks_exact(6)) {
        *target = robot.link_pose(values, robot.links() - 1).expect("a link");
    }
    let starts = vec![[<R as dq8::Real>::ZERO; 6]; targets.len()];
    let mut found = vec![Solutions::default(); targets.len()];
    Job::new("all solutions", move || {
        arm.job().backend(backend).solutions(&targets, &starts, &mut found).expect("lengths fit");
        assert!(found.iter().all(|found| !found.is_empty()));
    })
}
