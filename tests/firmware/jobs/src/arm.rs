//! Where the tool of a six-axis arm is and how it moves, from the angles of its joints: by a
//! hierarchy, and by a mechanism.

use crate::Board;
use crate::answers::{ARM_ANGLES, ARM_AXES, ARM_JACOBIAN, ARM_OFFSETS, ARM_TIP, ARM_TOOL};
use crate::error::{error, max_or_nan};
use crate::table::Table;
use core::hint::black_box;
use dq8::hierarchy::Bones;
use dq8::{DualQuat, Hierarchy, Quat, Twist};
use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach};
use dq8_robot::{Joint, Mechanism, Step, WorldAligned};

/// Six turns, rounded, and as many products.
const BOUND: f32 = 4.0;

pub(crate) fn run<B: Board>(table: &mut Table<'_, B>) {
    let mut tip = [f32::NAN; 3];
    let instructions = table.count(|| tip = tool(black_box(&ARM_ANGLES)).unwrap_or(tip));
    table.line("6-axis arm, from angles to the tool", instructions, error(&tip, &ARM_TIP), BOUND);
    mechanism(table);
}

/// The tool is a link, behind six hinges.
const TOOL: usize = 6;

fn mechanism<B: Board>(table: &mut Table<'_, B>) {
    let mut joints = [Joint::fixed(Some(TOOL - 1), DualQuat::from_translation(ARM_TOOL)); TOOL + 1];
    for (link, (joint, (&axis, &offset))) in
        joints.iter_mut().zip(ARM_AXES.iter().zip(&ARM_OFFSETS)).enumerate()
    {
        *joint = Joint::revolute(link.checked_sub(1), DualQuat::from_translation(offset), axis);
    }
    let mut steps = [Step::default(); TOOL + 1];
    // A mechanism that is refused leaves the answers as they are: not right.
    let arm = Mechanism::new(&joints, &mut steps);
    let mut pose = DualQuat::IDENTITY;
    let mut columns = [Twist::from_array([f32::NAN; 6]); TOOL];

    let instructions = table.count(|| {
        if let Ok(arm) = &arm {
            pose = arm.link_pose(black_box(&ARM_ANGLES), TOOL).unwrap_or(pose);
        }
    });
    let tip = pose.translation();
    table.line("mechanism of 6 axes, its tool", instructions, error(&tip, &ARM_TIP), BOUND);

    let instructions = table.count(|| {
        if let Ok(arm) = &arm {
            let angles = black_box(&ARM_ANGLES);
            pose = arm.link_jacobian(WorldAligned, angles, TOOL, &mut columns).unwrap_or(pose);
        }
    });
    let mut worst = error(&pose.translation(), &ARM_TIP);
    for (column, expected) in columns.iter().zip(&ARM_JACOBIAN) {
        worst = max_or_nan(error(&column.to_array(), expected), worst);
    }
    table.line("tool and Jacobian", instructions, worst, BOUND);
    if let Ok(arm) = &arm {
        follow(table, arm, pose);
    }
}

/// From angles that are a tenth of a radian off, back to the tool: inverse kinematics of a moving
/// target.
fn follow<B: Board>(table: &mut Table<'_, B>, arm: &Mechanism<'_, f32>, target: DualQuat<f32>) {
    let (goals, mut freedoms) = ([Goal::pose(TOOL)], [Freedom::default(); TOOL]);
    let mut scratch = [0.0; 224];
    let options = Options::default();
    let (mut angles, mut reached) = (ARM_ANGLES, f32::NAN);
    if let Ok(problem) = Reach::new(*arm, &goals, &mut freedoms) {
        let instructions = table.count(|| {
            angles = black_box(ARM_ANGLES.map(|angle| angle + 0.1));
            let report = problem.follow(&[target], &mut angles, &mut scratch, &options);
            if report.is_ok_and(|report| report.outcome == Outcome::Converged) {
                reached = 0.0;
            }
        });
        let apart = arm.link_pose(&angles, TOOL).map_or(f32::NAN, |pose| pose.distance_to(target));
        let off = apart / f32::EPSILON + reached;
        table.line("the same, angles from the tool", instructions, off, REACHED);
    }
}

/// What a search is told to leave, in units of 2⁻²³, and the rounding of the pose that is
/// measured.
const REACHED: f32 = 1e-5 / f32::EPSILON + BOUND;

#[inline(never)]
fn tool(angles: &[f32; 6]) -> Option<[f32; 3]> {
    let parents = [Hierarchy::ROOT, 0, 1, 2, 3, 4];
    let mut rotations = [Quat::IDENTITY; 6];
    for (rotation, (&axis, &angle)) in rotations.iter_mut().zip(ARM_AXES.iter().zip(angles)) {
        *rotation = Quat::from_axis_angle(axis, angle);
    }
    let mut models = [DualQuat::IDENTITY; 6];
    let locals = Bones { rotations: &rotations, offsets: &ARM_OFFSETS };
    Hierarchy::new(&parents).ok()?.job().locals_to_model(locals, &mut models).ok()?;
    let [.., flange] = models;
    Some(flange.transform_point(ARM_TOOL))
}
