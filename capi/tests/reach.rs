//! Inverse kinematics through C: the same as the library's, and what is refused.

#[path = "support/answers.rs"]
mod answers;
#[path = "support/joint.rs"]
mod joint;

use answers::answers;
use dq8_capi::Status;
use dq8_capi::joint::{Joint, JointKind};
use dq8_capi::mechanism::{Mechanism, Step, double as m};
use dq8_capi::reach::{Goal, Outcome, ReachOptions, ReachReport, double as c};
use dq8_capi::targets::double as t;
use joint::joint;
use std::mem::MaybeUninit;
use std::ptr;

const LINKS: usize = 4;
const VALUES: usize = 3;

/// Three hinges in a plane, with limits, and a tool.
fn joints() -> [Joint<f64>; LINKS] {
    std::array::from_fn(|index| {
        let hinge = index < VALUES;
        let kind = if hinge { JointKind::Revolute } else { JointKind::Fixed };
        let mut joint = joint(index as i32 - 1, kind);
        joint.placement[4] = if index == 0 { 0.0 } else { 0.5 };
        Joint { limited: i32::from(hinge), limits: [-2.5, 2.5], ..joint }
    })
}

/// A mechanism, its steps, and everything that a call needs.
struct Arm {
    _steps: Box<[MaybeUninit<Step<f64>>; LINKS]>,
    made: Mechanism<f64>,
    goals: [Goal<f64>; 1],
    target: [f64; 8],
    values: [f64; VALUES],
    scratch: Vec<f64>,
    report: ReachReport<f64>,
}

fn arm() -> Arm {
    arm_of(&joints(), [0.4, 0.9, -0.7])
}

/// With a target where these values take the tool.
fn arm_of(joints: &[Joint<f64>; LINKS], goal: [f64; VALUES]) -> Arm {
    let mut steps = Box::new([const { MaybeUninit::uninit() }; LINKS]);
    let mut made = MaybeUninit::zeroed();
    // SAFETY: arrays have the length that is said.
    let made = unsafe {
        let room = steps.as_mut_ptr().cast();
        let status = m::make(joints.as_ptr(), LINKS, room, made.as_mut_ptr(), ptr::null_mut());
        assert_eq!(status, Status::Ok);
        made.assume_init()
    };
    let (mut target, mut needed) = ([0.0; 8], 0);
    // SAFETY: as above.
    unsafe {
        let status = m::link_pose(&made, goal.as_ptr(), VALUES, 3, target.as_mut_ptr());
        assert_eq!(status, Status::Ok);
        assert_eq!(c::reach_scratch(&made, 1, &mut needed), Status::Ok);
    }
    Arm {
        _steps: steps,
        made,
        goals: [Goal { link: 3, angular: [1.0; 3], linear: [1.0; 3], point: [0.0; 3] }],
        target,
        values: [0.1, 0.2, 0.3],
        scratch: vec![f64::NAN; needed],
        report: ReachReport {
            outcome: -7,
            iterations: 0,
            restarts: 0,
            angular_error: 0.0,
            linear_error: 0.0,
        },
    }
}

impl Arm {
    fn reach(&mut self, posture: *const f64, options: *const ReachOptions<f64>) -> Status {
        let (scratch, count) = (self.scratch.as_mut_ptr(), self.scratch.len());
        let (goals, target) = (self.goals.as_ptr(), self.target.as_ptr());
        let values = self.values.as_mut_ptr();
        // SAFETY: arrays have the length that is said.
        unsafe {
            c::reach(
                &self.made,
                goals,
                target,
                1,
                posture,
                options,
                values,
                VALUES,
                scratch,
                count,
                &mut self.report,
            )
        }
    }
}

#[test]
fn a_pose_is_reached_within_the_limits() {
    let mut arm = arm();
    assert_eq!(arm.reach(ptr::null(), ptr::null()), Status::Ok);
    assert_eq!(arm.report.outcome, Outcome::Converged as i32, "{:?}", arm.report);
    assert!(arm.report.iterations > 0 && arm.report.linear_error < 1e-5);
    let mut pose = [0.0; 8];
    // SAFETY: arrays have the length that is said.
    let status =
        unsafe { m::link_pose(&arm.made, arm.values.as_ptr(), VALUES, 3, pose.as_mut_ptr()) };
    assert_eq!(status, Status::Ok);
    for (found, wanted) in pose.iter().zip(arm.target) {
        assert!((found - wanted).abs() < 1e-5, "{pose:?}");
    }
}

#[test]
fn options_and_limits_are_read() {
    let mut options = MaybeUninit::<ReachOptions<f64>>::uninit();
    // SAFETY: there is room for them.
    let mut options = unsafe {
        assert_eq!(c::reach_options(options.as_mut_ptr()), Status::Ok);
        options.assume_init()
    };
    assert_eq!((options.max_iterations, options.restarts), (100, 1));
    options.max_iterations = 1;
    let mut unfinished = arm();
    assert_eq!(unfinished.reach(ptr::null(), &options), Status::Ok);
    assert_eq!(unfinished.report.outcome, Outcome::Unfinished as i32);
    assert_eq!(unfinished.report.iterations, 1);
    options.restarts = 2;
    assert_eq!(unfinished.reach(ptr::null(), &options), Status::UnknownValue);

    for bad in [f64::NAN, -1.0] {
        options = ReachOptions { restarts: 1, length_per_radian: bad, ..options };
        let mut refused = arm();
        assert_eq!(refused.reach(ptr::null(), &options), Status::Ok);
        assert_eq!(refused.report.outcome, Outcome::Invalid as i32, "{bad}");
        assert_eq!(refused.values, [0.1, 0.2, 0.3]);
    }

    let mut bent = arm();
    bent.goals[0] = Goal { link: 1, angular: [0.0; 3], linear: [1.0; 3], point: [0.0; 3] };
    bent.target = [0.0, 0.0, 0.0, 1.0, -0.25, 0.0, 0.0, 0.0];
    assert_eq!(bent.reach(ptr::null(), ptr::null()), Status::Ok);
    assert_eq!(bent.report.outcome, Outcome::AtLimits as i32, "{:?}", bent.report);
    assert!((bent.values[0].abs() - 2.5).abs() < 1e-12, "{:?}", bent.values);
}

/// Hinges without limits, and their tool.
#[test]
fn of_whole_turns_the_nearest_to_the_start_is_returned() {
    let endless = joints().map(|joint| Joint { limited: 0, ..joint });
    for (start, there) in [(3.2, 3.25), (9.0, 3.25 + std::f64::consts::TAU), (-3.2, -3.25)] {
        let mut arm = arm_of(&endless, [there, 0.9, -0.7]);
        arm.values = [start, 0.9, -0.7];
        assert_eq!(arm.reach(ptr::null(), ptr::null()), Status::Ok);
        assert_eq!(arm.report.outcome, Outcome::Converged as i32);
        assert!((arm.values[0] - there).abs() < 1e-4, "{:?}", arm.values);
    }
}

#[test]
fn a_goal_for_a_link_that_no_joint_moves_is_refused() {
    let mut joints = joints();
    // The tool hangs on the base.
    joints[3].parent = -1;
    let mut arm = arm_of(&joints, [0.4, 0.9, -0.7]);
    assert_eq!(arm.reach(ptr::null(), ptr::null()), Status::Unmoved);
    assert_eq!((arm.values, arm.report.outcome), ([0.1, 0.2, 0.3], -7));
}

#[test]
fn a_posture_is_read() {
    let mut arm = arm();
    arm.goals[0] = Goal { link: 3, angular: [0.0; 3], linear: [1.0; 3], point: [0.0; 3] };
    let posture = [0.4, 0.9, -0.7];
    assert_eq!(arm.reach(posture.as_ptr(), ptr::null()), Status::Ok);
    assert_eq!(arm.report.outcome, Outcome::Converged as i32);
    for (value, wanted) in arm.values.iter().zip(posture) {
        assert!((value - wanted).abs() < 1e-2, "{:?}", arm.values);
    }
    let mut other = self::arm();
    assert_eq!(other.reach([f64::NAN; 3].as_ptr(), ptr::null()), Status::NotFinite);
}

#[test]
fn what_is_wrong_has_its_number_and_nothing_is_written() {
    let wrong = |change: fn(&mut Arm), wanted: Status| {
        let mut arm = arm();
        change(&mut arm);
        let before = arm.values;
        assert_eq!(arm.reach(ptr::null(), ptr::null()), wanted);
        assert_eq!((arm.values, arm.report.outcome), (before, -7), "written: {wanted:?}");
    };
    wrong(|arm| arm.goals[0].link = 4, Status::NoLink);
    wrong(|arm| arm.goals[0].linear[1] = -1.0, Status::Weight);
    wrong(|arm| arm.goals[0].angular[1] = f64::NAN, Status::Weight);
    wrong(
        |arm| arm.goals[0] = Goal { link: 3, angular: [0.0; 3], linear: [0.0; 3], point: [0.0; 3] },
        Status::Weight,
    );
    wrong(|arm| _ = arm.scratch.pop(), Status::Length);
    // A target that is none is told in the report.
    let mut none = arm();
    none.target[3] = f64::NAN;
    assert_eq!(none.reach(ptr::null(), ptr::null()), Status::Ok);
    assert_eq!((none.report.outcome, none.values), (Outcome::Invalid as i32, [0.1, 0.2, 0.3]));
}

#[test]
fn pointers_that_are_null_or_overlap_are_refused() {
    let mut arm = arm();
    let (of, goals, target) = (&raw const arm.made, arm.goals.as_ptr(), arm.target.as_ptr());
    let (values, count) = (arm.values.as_mut_ptr(), arm.scratch.len());
    let (scratch, report) = (arm.scratch.as_mut_ptr(), &raw mut arm.report);
    let (null, none) = (ptr::null_mut::<f64>(), ptr::null());
    // SAFETY: what is dereferenced is as long as it is said to be; what is not, is refused.
    let call = |goals, target, values, scratch, report| unsafe {
        c::reach(of, goals, target, 1, none, ptr::null(), values, VALUES, scratch, count, report)
    };
    let inside = target.cast_mut();
    answers([
        (call(ptr::null(), target, values, scratch, report), Status::NullPointer),
        (call(goals, null, values, scratch, report), Status::NullPointer),
        (call(goals, target, null, scratch, report), Status::NullPointer),
        (call(goals, target, values, null, report), Status::NullPointer),
        (call(goals, target, values, scratch, ptr::null_mut()), Status::NullPointer),
        (call(goals, target, inside, scratch, report), Status::Overlap),
        (call(goals, target, scratch, scratch, report), Status::Overlap),
        (call(goals, target, values, scratch, scratch.cast()), Status::Overlap),
        (call(goals, target, goals.cast_mut().cast(), scratch, report), Status::Overlap),
        (call(scratch.cast(), target, values, scratch, report), Status::Overlap),
        (call(goals, scratch, values, scratch, report), Status::Overlap),
        (call(goals, target, values, scratch, inside.cast()), Status::Overlap),
        (call(goals, target, values, scratch, of.cast_mut().cast()), Status::Overlap),
    ]);
    let mut unmade = MaybeUninit::<Mechanism<f64>>::zeroed();
    let mut needed = 5;
    // SAFETY: as above; the mechanism is zero.
    unsafe {
        assert_eq!(c::reach_scratch(unmade.as_mut_ptr(), 1, &mut needed), Status::NoMechanism);
        assert_eq!(c::reach_scratch(of, usize::MAX, &mut needed), Status::TooLarge);
    }
    assert_eq!(needed, 5);
}

#[test]
fn many_are_reached_as_in_rust_whatever_part_of_them_is_asked_for() {
    const MANY: usize = 21;
    let arm = arm();
    let mut targets = [[0.0; 8]; MANY];
    for (at, target) in targets.iter_mut().enumerate() {
        let values = [0.1 * at as f64 - 1.0, 0.9, -0.05 * at as f64];
        // SAFETY: arrays have the length that is said.
        let status =
            unsafe { m::link_pose(&arm.made, values.as_ptr(), VALUES, 3, target.as_mut_ptr()) };
        assert_eq!(status, Status::Ok);
    }
    // One beyond the arm, and one that is none.
    (targets[3][4], targets[7][3]) = (9.0, f64::NAN);
    let reach = |targets: &[[f64; 8]], wrong: usize| {
        let (mut values, mut needed) = (vec![[0.1, 0.2, 0.3]; targets.len()], 0);
        let mut reports = vec![arm.report; targets.len()];
        // SAFETY: arrays have the length that is said, or the call is refused.
        let status = unsafe {
            assert_eq!(t::scratch(&arm.made, 1, &raw mut needed), Status::Ok);
            let mut scratch = vec![f64::NAN; needed];
            t::reach(
                &arm.made,
                arm.goals.as_ptr(),
                1,
                targets.as_ptr().cast(),
                ptr::null(),
                ptr::null(),
                values.as_mut_ptr().cast(),
                VALUES * targets.len() + usize::from(wrong == 1),
                scratch.as_mut_ptr(),
                needed - usize::from(wrong == 2),
                reports.as_mut_ptr(),
                targets.len() - usize::from(wrong == 3),
            )
        };
        (status, values, reports)
    };
    let (status, values, reports) = reach(&targets, 0);
    assert_eq!(status, Status::Ok);

    let described = [0_usize, 1, 2, 3].map(|link| {
        let out = [if link == 0 { 0.0 } else { 1.0 }, 0.0, 0.0];
        let (on, at) = (link.checked_sub(1), dq8::DualQuat::from_translation(out));
        let hinge = dq8_robot::Joint::revolute(on, at, [0.0, 0.0, 1.0]);
        if link < VALUES { hinge.with_limits([-2.5, 2.5]) } else { dq8_robot::Joint::fixed(on, at) }
    });
    let mechanism = dq8_robot::OwnedMechanism::new(&described).unwrap();
    let rust = dq8_robot::ik::OwnedReach::new(mechanism, [dq8_robot::ik::Goal::pose(3)]).unwrap();
    let (mut same, mut told) = (vec![[0.1, 0.2, 0.3]; MANY], vec![Default::default(); MANY]);
    let wanted = targets.map(dq8::DualQuat::from_array);
    rust.job().solve(&wanted, same.as_flattened_mut(), &mut told, &Default::default()).unwrap();
    assert_eq!(values, same);
    for (report, told) in reports.iter().zip(&told) {
        let [errors, others] =
            [[report.angular_error, report.linear_error], [told.angular_error, told.linear_error]];
        assert_eq!(errors.map(f64::to_bits), others.map(f64::to_bits));
        assert_eq!((report.outcome, report.iterations), (told.outcome as i32, told.iterations));
    }
    let outcomes: Vec<_> = reports.iter().map(|report| report.outcome).collect();
    assert!(
        outcomes.iter().enumerate().all(|(at, &outcome)| match at {
            3 => outcome == Outcome::OutOfReach as i32,
            7 => outcome == Outcome::Invalid as i32,
            _ => outcome == Outcome::Converged as i32,
        }),
        "{outcomes:?}"
    );
    for part in [0..1, 0..5, 5..6, 9..21] {
        assert_eq!(reach(&targets[part.clone()], 0).1, values[part.clone()], "{part:?}");
    }
    for wrong in 1..=3 {
        let (status, values, reports) = reach(&targets, wrong);
        assert_eq!(status, Status::Length, "{wrong}");
        assert!(values.iter().all(|values| *values == [0.1, 0.2, 0.3]));
        assert!(reports.iter().all(|report| report.outcome == -7));
    }
    assert_eq!(reach(&[], 0).0, Status::Ok);
}
