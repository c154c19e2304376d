//! The clip as the drawing needs it: world positions and the sides of the body.

use super::side::{Side, sides};
use dq8_bvh::Clip;

pub(crate) struct Scene<'a> {
    pub(crate) clip: &'a Clip,
    /// World positions, `[frame][joint]`.
    pub(crate) positions: &'a [[f64; 3]],
    /// One for each joint.
    pub(crate) sides: Vec<Side>,
    /// The largest distance of a joint from its root.
    pub(crate) size: f64,
    /// The height of the lowest joint in the clip.
    pub(crate) ground: f64,
}

impl<'a> Scene<'a> {
    pub(crate) fn new(clip: &'a Clip, positions: &'a [[f64; 3]], size: f64) -> Self {
        let ground = positions.iter().map(|position| position[1]).fold(f64::INFINITY, f64::min);
        Self { clip, positions, sides: sides(clip), size, ground }
    }

    pub(crate) fn frame(&self, frame: usize) -> &'a [[f64; 3]] {
        let joints = self.clip.joints.len();
        &self.positions[frame * joints..][..joints]
    }

    pub(crate) fn root(&self, frame: usize) -> [f64; 3] {
        self.frame(frame)[0]
    }

    /// The joint of this side that is lowest on the whole: the foot or its toes.
    pub(crate) fn foot(&self, side: Side) -> Option<usize> {
        let joints = self.clip.joints.len();
        let height = |joint: usize| -> f64 {
            self.positions.iter().skip(joint).step_by(joints).map(|position| position[1]).sum()
        };
        let of_side = (0..joints).filter(|&joint| self.sides[joint] == side);
        of_side.min_by(|&a, &b| height(a).total_cmp(&height(b)))
    }
}
