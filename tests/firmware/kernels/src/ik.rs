//! Inverse kinematics of a six-axis arm: `ik_follow` without restarts and `ik_solve` with them,
//! from its joints on, and `arm_solve` with them, from its screws on.

use dq8::DualQuat;
use dq8::geometry::Screw;
use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach};
use dq8_robot::{Joint, Mechanism, MechanismError, Step};

/// Six hinges and a tool.
const LINKS: usize = 7;
const AXES: usize = LINKS - 1;
/// As `Reach::scratch_bound` says; the check links nothing that panics, so too little is a wrong
/// answer.
const SCRATCH: usize = 224;

fn reach(
    make: impl for<'s> FnOnce(&'s mut [Step<f32>]) -> Result<Mechanism<'s, f32>, MechanismError>,
    search: impl FnOnce(&Reach<'_, f32>, &mut [f32]) -> Option<Outcome>,
) -> bool {
    let (mut steps, mut freedoms) = ([Step::default(); LINKS], [Freedom::default(); AXES]);
    let (goals, mut scratch) = ([Goal::pose(AXES)], [0.0; SCRATCH]);
    let Ok(arm) = make(&mut steps) else { return false };
    let Ok(problem) = Reach::new(arm, &goals, &mut freedoms) else { return false };
    search(&problem, &mut scratch) == Some(Outcome::Converged)
}

#[unsafe(no_mangle)]
fn ik_solve(
    joints: &[Joint<f32>; LINKS],
    target: &DualQuat<f32>,
    values: &mut [f32; AXES],
) -> bool {
    reach(
        |steps| Mechanism::new(joints, steps),
        |problem, scratch| {
            let report = problem.solve(&[*target], values, scratch, &Options::default());
            report.ok().map(|report| report.outcome)
        },
    )
}

#[unsafe(no_mangle)]
fn ik_follow(
    joints: &[Joint<f32>; LINKS],
    target: &DualQuat<f32>,
    values: &mut [f32; AXES],
) -> bool {
    reach(
        |steps| Mechanism::new(joints, steps),
        |problem, scratch| {
            let report = problem.follow(&[*target], values, scratch, &Options::default());
            report.ok().map(|report| report.outcome)
        },
    )
}

#[unsafe(no_mangle)]
fn arm_solve(
    screws: &[(Screw<f32>, [f32; 2]); AXES],
    tool: &DualQuat<f32>,
    target: &DualQuat<f32>,
    values: &mut [f32; AXES],
) -> bool {
    reach(
        |steps| Mechanism::from_screws(screws, *tool, steps),
        |problem, scratch| {
            let report = problem.solve(&[*target], values, scratch, &Options::default());
            report.ok().map(|report| report.outcome)
        },
    )
}
