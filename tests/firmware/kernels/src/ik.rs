//! Inverse kinematics of a six-axis arm, from its joints on: `ik_follow` without restarts, `ik_solve` with them.

use dq8::DualQuat;
use dq8::mechanism::{Freedom, Goal, Joint, Mechanism, Options, Outcome, Reach, Step};

/// Six hinges and a tool.
const LINKS: usize = 7;
const AXES: usize = LINKS - 1;
/// As `Reach::scratch_bound` says; the check links nothing that panics, so too little is a wrong answer.
const SCRATCH: usize = 224;

fn reach(
    joints: &[Joint<f32>; LINKS],
    search: impl FnOnce(&Reach<'_, f32>, &mut [f32]) -> Option<Outcome>,
) -> bool {
    let (mut steps, mut freedoms) = ([Step::default(); LINKS], [Freedom::default(); AXES]);
    let (goals, mut scratch) = ([Goal::pose(AXES)], [0.0; SCRATCH]);
    let Ok(arm) = Mechanism::new(joints, &mut steps) else { return false };
    let Ok(problem) = Reach::new(arm, &goals, &mut freedoms) else { return false };
    search(&problem, &mut scratch) == Some(Outcome::Converged)
}

#[unsafe(no_mangle)]
fn ik_solve(
    joints: &[Joint<f32>; LINKS],
    target: &DualQuat<f32>,
    values: &mut [f32; AXES],
) -> bool {
    reach(joints, |problem, scratch| {
        let report = problem.solve(&[*target], values, scratch, &Options::default());
        report.ok().map(|report| report.outcome)
    })
}

#[unsafe(no_mangle)]
fn ik_follow(
    joints: &[Joint<f32>; LINKS],
    target: &DualQuat<f32>,
    values: &mut [f32; AXES],
) -> bool {
    reach(joints, |problem, scratch| {
        let report = problem.follow(&[*target], values, scratch, &Options::default());
        report.ok().map(|report| report.outcome)
    })
}
