//! How deep the stack of a debug build gets, as in `tests/stack.rs` of dq8: `dq8::guide::firmware` states the bounds.
#![cfg(not(target_family = "wasm"))]

use dq8_fixtures::stack::{pose, within};

macro_rules! kernels {
    ($($real:ident)*) => {$(mod $real {
        use super::{pose, within};
        use dq8::{DualQuat, Twist};
        use dq8_robot::ik::{Freedom, Goal, Options, Reach, Report, SixAxisArm, Solutions};
        use dq8_robot::{Joint, OwnedMechanism, WorldAligned};

        const INSTANCES: usize = 37;

        #[test]
        fn mechanisms_need_one_mebibyte() {
            within(1024, |backend| {
                let joint = |i: usize| Joint::revolute(i.checked_sub(1), pose::<$real>(), [0.6, 0.0, 0.8]);
                let arm = OwnedMechanism::new(&core::array::from_fn::<_, 7, _>(joint)).unwrap();
                let values = [0.1; 7 * INSTANCES];
                let mut poses = vec![DualQuat::IDENTITY; 7 * INSTANCES];
                let mut twists = vec![Twist::default(); 7 * INSTANCES];
                let mut changes = twists.clone();
                let tools = &mut poses[..INSTANCES];
                arm.job().links(&[6]).backend(backend).jacobians(WorldAligned, &values, tools, &mut twists).unwrap();
                arm.job().backend(backend).poses(&values, &mut poses).unwrap();
                arm.job().backend(backend).accelerations(&values, &values, &values, &mut poses, &mut twists, &mut changes)
                    .unwrap();
            });
        }

        #[test]
        fn a_mechanism_of_seven_joints_that_reaches_needs_one_mebibyte() {
            within(1024, |backend| {
                let joint = |i: usize| Joint::revolute(i.checked_sub(1), pose::<$real>(), [0.6, 0.0, 0.8]);
                let arm = OwnedMechanism::new(&core::array::from_fn::<_, 7, _>(joint)).unwrap();
                let (goals, mut freedoms) = ([Goal::pose(6)], [Freedom::default(); 7]);
                let posture = [0.1; 7];
                let reach = Reach::new(arm.view(), &goals, &mut freedoms).unwrap().with_posture(&posture).unwrap();
                let (targets, mut values) = (vec![pose(); INSTANCES], vec![0.3; 7 * INSTANCES]);
                let mut reports = vec![Report::default(); INSTANCES];
                let options = Options { max_iterations: 5, ..Options::default() };
                reach.job().backend(backend).solve(&targets, &mut values, &mut reports, &options).unwrap();
            });
        }

        #[test]
        fn all_solutions_of_an_arm_need_one_mebibyte() {
            within(1024, |backend| {
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
