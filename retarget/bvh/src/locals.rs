//! The motions of joints relative to their parents, in all frames: a frame in each lane.

use crate::clip::{Channel, Joint};
use dq8::batch::{self, cos_sin};
use dq8::simd::Float;
use dq8::storage::{Element, Tile};
use dq8::{DualQuat, Kernel, Lanes, Level};
use std::f64::consts::PI;

/// The largest angle in degrees that lanes turn by. Rotations by angles much larger than
/// [`farthest`](batch::farthest) would not be unit.
pub(crate) const LARGEST: f64 = 1e12;

/// `locals[frame][joint]` ← the motion of the joint for `values[frame][channel]`.
pub(crate) struct Locals<'s> {
    pub(crate) joints: &'s [Joint],
    /// The number of channels of all joints.
    pub(crate) channels: usize,
    pub(crate) values: &'s [f64],
    pub(crate) locals: &'s mut [DualQuat<f64>],
}

impl Kernel for Locals<'_> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let count = self.joints.len();
        let zero = <f64 as Float>::Lanes::<V>::splat(level, 0.0);
        let one = zero.constant(1.0);
        let mut frame = 0;
        while frame * count < self.locals.len() {
            let mut channel = frame * self.channels;
            for (index, joint) in self.joints.iter().enumerate() {
                let mut rotation = [zero, zero, zero, one];
                let mut translation = batch::vector::splat(level, joint.offset);
                for &kind in &joint.channels {
                    let (mut row, mut at) = (zero.to_array(), channel);
                    for slot in row.as_mut() {
                        *slot = self.values.get(at).copied().unwrap_or_default();
                        at += self.channels;
                    }
                    let value = <f64 as Float>::Lanes::<V>::load(level, &row);
                    channel += 1;
                    match kind {
                        Channel::Position(axis) => {
                            let Some(part) = translation.get_mut(axis as usize) else { return };
                            *part = value;
                        }
                        Channel::Rotation(axis) => {
                            let (cos, sin) = cos_sin(value * value.constant(PI / 360.0));
                            rotation = turned(rotation, axis as usize, cos, sin);
                        }
                    }
                }
                let rotation = batch::Quat::from_array(rotation);
                let local = batch::DualQuat::from_rotation_translation(rotation, translation);
                let tile = Tile::at(frame * count + index, 0).strided(count);
                DualQuat::store::<V>(local.to_array(), self.locals, tile);
            }
            frame += <f64 as Float>::Lanes::<V>::LANES;
        }
    }
}

/// Returns the product of a quaternion with that of a turn about an axis of its frame.
#[inline(always)]
fn turned<L: Lanes>([x, y, z, w]: [L; 4], axis: usize, cos: L, sin: L) -> [L; 4] {
    // The axis, and the two that follow it.
    let [a, b, c] = match axis {
        0 => [x, y, z],
        1 => [y, z, x],
        _ => [z, x, y],
    };
    let along = w.mul_add(sin, a * cos);
    let [b, c] = [c.mul_add(sin, b * cos), b.neg_mul_add(sin, c * cos)];
    let w = a.neg_mul_add(sin, w * cos);
    match axis {
        0 => [along, b, c, w],
        1 => [c, along, b, w],
        _ => [b, c, along, w],
    }
}
