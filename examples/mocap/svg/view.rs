//! Where the spectator stands: beside the way, so that it leads from left to right.

use std::ops::Range;

use super::scene::Scene;
use super::side::Side;

/// A horizontal direction of looking. Height is y, as in most clips.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// x and z of the horizontal direction that points to the right in the picture.
    right: [f64; 2],
}

impl View {
    /// From the side of the way that the root takes in these frames. One who stays in place is seen
    /// with the face to the right, if names tell left from right.
    pub(crate) fn of(scene: &Scene<'_>, frames: &Range<usize>) -> Self {
        let way = |from: [f64; 3], to: [f64; 3]| [to[0] - from[0], to[2] - from[2]];
        let travel = way(scene.root(frames.start), scene.root(frames.end - 1));
        if travel[0].hypot(travel[1]) > 0.3 * scene.size {
            return Self::along(travel);
        }
        let middle_of = |side| {
            let mut sum = [0.0; 3];
            let mut count = 0.0;
            for frame in frames.clone() {
                for (position, _) in
                    scene.frame(frame).iter().zip(&scene.sides).filter(|(_, s)| **s == side)
                {
                    (0..3).for_each(|axis| sum[axis] += position[axis]);
                    count += 1.0;
                }
            }
            sum.map(|coordinate| coordinate / count)
        };
        let [x, z] = way(middle_of(Side::Left), middle_of(Side::Right));
        // Facing is up × (left → right).
        Self::along([z, -x])
    }

    fn along([x, z]: [f64; 2]) -> Self {
        let length = x.hypot(z);
        if length > 0.0 && length.is_finite() {
            Self { right: [x / length, z / length] }
        } else {
            Self { right: [1.0, 0.0] }
        }
    }

    /// How far to the right in the picture.
    pub(crate) fn right(&self, p: [f64; 3]) -> f64 {
        p[0] * self.right[0] + p[2] * self.right[1]
    }

    /// How near to the spectator.
    pub(crate) fn near(&self, p: [f64; 3]) -> f64 {
        p[2] * self.right[0] - p[0] * self.right[1]
    }
}
