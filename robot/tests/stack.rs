//! How deep the stack of a debug build gets, as in `tests/stack.rs` of dq8: `dq8::guide::firmware`
//! states the bounds.
#![cfg(not(target_family = "wasm"))]

use dq8_fixtures::stack::{pose, within};

macro_rules! kernels {
    ($($real:ident)*) => {$(mod $real {
        use super::{pose, within};
        use dq8::{DualQuat, Twist};
        use dq8_robot::ik::{Goal, Options, OwnedReach, Report, SixAxisArm, Solutions};
        use dq8_robot::{Joint, OwnedMechanism, WorldAligned};

        const INSTANCES: usize = 37;

        #[test]
        fn an_arm_and_its_searches_and_solutions_need_one_mebibyte() {
            within(1024, |backend| {
                let joint = |i: usize| Joint::revolute(i.checked_sub(1), pose::<$real>(), [0.6, 0.0, 0.8]);
                let arm = OwnedMechanism::new(&core::array::from_fn::<_, 7, _>(joint)).unwrap();
                let mut values = [0.1; 7 * INSTANCES];
                let mut poses = vec![DualQuat::IDENTITY; 7 * INSTANCES];
                let mut twists = vec![Twist::default(); 7 * INSTANCES];
                let mut changes = twists.clone();
                let (tools, job) = (&mut poses[..INSTANCES], arm.job().backend(backend));
                job.links(&[6]).jacobians(WorldAligned, &values, tools, &mut twists).unwrap();
                job.poses(&values, &mut poses).unwrap();
                job.accelerations(&values, &values, &values, &mut poses, &mut twists, &mut changes).unwrap();
                let reach = OwnedReach::new(arm, [Goal::pose(6)]).unwrap().with_posture([0.1; 7]).unwrap();
                let options = Options { max_iterations: 5, ..Options::default() };
                let mut reports = vec![Report::default(); INSTANCES];
                let job = reach.job().backend(backend);
                job.solve(&[pose(); INSTANCES], &mut values, &mut reports, &options).unwrap();
                let arm = dq8_arms::ur5().arm::<$real>();
                let six = SixAxisArm::new(arm.0.view()).unwrap();
                let mut found = vec![Solutions::default(); INSTANCES];
                let job = six.job().backend(backend);
                job.solutions(&[pose(); INSTANCES], &[[0.1; 6]; INSTANCES], &mut found).unwrap();
            });
        }
    })*};
}
kernels! { f32 f64 }
