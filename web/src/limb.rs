//! Limbs of two bones in models that are already there: what stands on a foot follows it, as it was
//! turned.

use crate::Motion;
use crate::error::status;
use crate::memory::exports;
use crate::skeleton::Rig;
use dq8::batch::vector::{add, sub};
use dq8::ik::TwoBone;
use dq8::{Quat, ShapeError};
use std::ops::Range;

type Point = [f32; 3];

fn length([x, y, z]: Point) -> f32 {
    (x * x + y * y + z * z).sqrt()
}

/// The turn about `from` that takes the way to `end` to `way`, and then what lies at `from` to
/// `to`. A bone without length does not turn.
fn swing(from: Point, end: Point, way: Point, to: Point) -> Motion {
    let bone = sub(end, from);
    let turn = if length(bone) > 0.0 && length(way) > 0.0 {
        Quat::from_rotation_arc(bone, way)
    } else {
        Quat::IDENTITY
    };
    Motion::from_rotation_translation(turn, sub(to, turn.rotate(from)))
}

/// A limb, and the joints that hang from each of its three.
struct Limb {
    joints: [usize; 3],
    all: [Range<usize>; 3],
}

impl Limb {
    fn new(rig: &Rig, joints: [usize; 3]) -> Result<Self, String> {
        let subtree = |joint| rig.skeleton.subtree(joint).map_err(|error| error.to_string());
        let all = [subtree(joints[0])?, subtree(joints[1])?, subtree(joints[2])?];
        for (inner, outer, name) in [(1, 0, "the second"), (2, 1, "the third")] {
            if !all[outer].contains(&joints[inner]) || joints[inner] == joints[outer] {
                let (inner, outer) = (joints[inner], joints[outer]);
                return Err(format!(
                    "{name} joint of the limb, {inner}, does not hang from {outer}"
                ));
            }
        }
        Ok(Self { joints, all })
    }

    /// How the three parts move.
    fn reach(&self, models: &[Motion], target: Point, pole: Point) -> Result<[Motion; 3], String> {
        let [hip, knee, foot] = self
            .joints
            .map(|joint| models.get(joint).map_or([f32::NAN; 3], |model| model.translation()));
        let lengths = [length(sub(knee, hip)), length(sub(foot, knee))];
        let found =
            TwoBone::reach(hip, lengths, target, pole).map_err(|error| error.to_string())?;
        let way = |turn: Quat<f32>, length| turn.rotate([length, 0.0, 0.0]);
        let (upper, lower) = (way(found.upper, lengths[0]), way(found.lower, lengths[1]));
        let new_knee = add(hip, upper);
        Ok([
            swing(hip, knee, upper, hip),
            swing(knee, foot, lower, new_knee),
            Motion::from_translation(sub(add(new_knee, lower), foot)),
        ])
    }

    fn apply(&self, parts: [Motion; 3], models: &mut [Motion]) {
        let [upper, lower, end] = parts;
        for joint in self.all[0].clone() {
            let part = if self.all[2].contains(&joint) {
                end
            } else if self.all[1].contains(&joint) {
                lower
            } else {
                upper
            };
            if let Some(model) = models.get_mut(joint) {
                *model = part * *model;
            }
        }
    }
}

fn two_bone(
    rig: &Rig,
    joints: [usize; 3],
    models: &mut [Motion],
    targets: &[Point],
    poles: &[Point],
) -> Result<(), String> {
    let (limb, count) = (Limb::new(rig, joints)?, rig.skeleton.joints());
    for (what, length, expected) in
        [("models", models.len(), count * targets.len()), ("poles", poles.len(), targets.len())]
    {
        if length != expected {
            return Err(ShapeError::Length { what, length, expected }.to_string());
        }
    }
    // All of them first, so that an error leaves the models as they were.
    let mut parts = Vec::with_capacity(targets.len());
    for (instance, ((models, &target), &pole)) in
        models.chunks_exact(count).zip(targets).zip(poles).enumerate()
    {
        let found = limb.reach(models, target, pole);
        parts.push(found.map_err(|error| format!("instance {instance}: {error}"))?);
    }
    for (models, parts) in models.chunks_exact_mut(count).zip(parts) {
        limb.apply(parts, models);
    }
    Ok(())
}

exports! {
    /// Moves the third joint of a limb to the target of its instance, the second one toward the
    /// pole.
    fn dq8_skeleton_two_bone(
        rig: &Rig, root: usize, hinge: usize, end: usize;
        targets[target_count]: Point, poles[pole_count]: Point; models[model_count]: Motion
    ) -> u32 {
        status(two_bone(rig, [root, hinge, end], models, targets, poles))
    }
}
