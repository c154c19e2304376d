//! Where the tool of a six-axis arm is, from the angles of its joints.

use crate::Board;
use crate::answers::{ARM_ANGLES, ARM_AXES, ARM_OFFSETS, ARM_TIP, ARM_TOOL};
use crate::error::error;
use crate::table::Table;
use core::hint::black_box;
use dq8::{DualQuat, Hierarchy, Quat, hierarchy::Rotations};

/// Six turns, rounded, and as many products.
const BOUND: f32 = 4.0;

pub(crate) fn run<B: Board>(table: &mut Table<'_, B>) {
    let mut tip = [f32::NAN; 3];
    let instructions = table.count(|| tip = tool(black_box(&ARM_ANGLES)).unwrap_or(tip));
    table.line("6-axis arm, from angles to the tool", instructions, error(&tip, &ARM_TIP), BOUND);
}

#[inline(never)]
fn tool(angles: &[f32; 6]) -> Option<[f32; 3]> {
    let parents = [Hierarchy::ROOT, 0, 1, 2, 3, 4];
    let mut rotations = [Quat::IDENTITY; 6];
    for (rotation, (&axis, &angle)) in rotations.iter_mut().zip(ARM_AXES.iter().zip(angles)) {
        *rotation = Quat::from_axis_angle(axis, angle);
    }
    let mut models = [DualQuat::IDENTITY; 6];
    let locals = Rotations { rotations: &rotations, offsets: &ARM_OFFSETS };
    Hierarchy::new(&parents).ok()?.job().locals_to_model(locals, &mut models).ok()?;
    let [.., flange] = models;
    Some(flange.transform_point(ARM_TOOL))
}
