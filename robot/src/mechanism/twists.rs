//! How joints move links, on lanes.

use super::joint::JointKind;
use super::placed::Placed;
use super::step::Step;
use super::walk::Joined;
use dq8::Scalar;
use dq8::batch::vector;
use dq8::geometry::Twist;
use dq8_simd::Lanes;

impl<L: Lanes<Real: Scalar>> Joined<L> {
    /// The spatial twist of the link for a rate of one of its joint: column `index` of those that
    /// the joint adds to a Jacobian.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn screw(&self, step: &Step<L::Real>, index: usize) -> Twist<L> {
        let level = self.pose.half[0].level();
        let before = self.before;
        let screw = match step.kind {
            JointKind::Planar { .. } if index < 2 => {
                let direction = step.plane.get(index).copied().unwrap_or_default();
                slide(before.rotated(vector::splat(level, direction)))
            }
            JointKind::Floating => {
                let mut axis = [L::splat(level, L::Real::default()); 3];
                axis[index % 3] = axis[0].constant(1.0);
                let axis = self.pose.rotated(axis);
                if index < 3 { hinge(axis, self.pose) } else { slide(axis) }
            }
            kind => {
                let axis = before.direction(step);
                match kind {
                    JointKind::Prismatic { .. } => slide(axis),
                    JointKind::Screw { pitch, .. } => {
                        let hinge = hinge(axis, before);
                        let linear = vector::scale_onto(axis, L::splat(level, pitch), hinge.linear);
                        Twist { linear, ..hinge }
                    }
                    JointKind::Planar { .. } => hinge(axis, self.pose),
                    _ => hinge(axis, before),
                }
            }
        };
        // Others go as their values do.
        if step.mimics { screw.scale(L::splat(level, step.multiplier)) } else { screw }
    }

    /// A rate, or NaN where the pose of the link is: a link that is nowhere does not move, although
    /// the screw of its joint may be known.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn told(&self, rate: L) -> L {
        let [.., w] = self.pose.rotation;
        w.mul_add(w.constant(0.0), rate)
    }
}

/// Turning about a line through the origin of a frame.
#[cfg_attr(not(opt_level_0), inline(always))]
fn hinge<L: Lanes>(axis: [L; 3], frame: Placed<L>) -> Twist<L> {
    let moment = vector::cross(frame.half, axis);
    Twist { angular: axis, linear: vector::add(moment, moment) }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn slide<L: Lanes>(direction: [L; 3]) -> Twist<L> {
    Twist { angular: [direction[0].constant(0.0); 3], linear: direction }
}
