//! One configuration in one lane: what `f32` and `f64` compute instead of the products of the book. Axes of the frame
//! and half angles cost a fraction of that.

use super::frame::Frame;
use super::placed::Placed;
use super::poses::carries;
use super::step::{NONE, Step};
use super::tree::Mechanism;
use super::values::Configuration;
use super::walk::{Joined, moved};
use dq8::Real;
use dq8::geometry::Twist;
use dq8::scalar::{DualQuat, vector};
use dq8::seams::{Number, Quick};
use dq8_simd::Portable;

/// [`Mechanism::link_poses`], with the poses of lanes for any value: NaN where an angle is too far for them.
pub(crate) struct LinkPoses<'s, R> {
    pub(crate) mechanism: Mechanism<'s, R>,
    pub(crate) values: &'s [R],
    pub(crate) poses: &'s mut [DualQuat<R>],
}

impl<R: Real> Quick<R> for LinkPoses<'_, R> {
    type Output = ();

    #[inline]
    fn compute(self) -> Option<()>
    where
        R: Number,
    {
        let mut last = (NONE, Placed::identity(Portable));
        for step in self.mechanism.steps {
            // The children of a link but the first come after what the others carry.
            let parent = if step.parent == NONE {
                None
            } else if step.parent == last.0 {
                Some(last.1)
            } else {
                self.poses.get(step.parent as usize).map(placed)
            };
            let Joined { pose, .. } = joined(step, parent, self.values);
            *self.poses.get_mut(step.link as usize)? = DualQuat::from_array(pose.to_motion());
            last = (step.link, pose);
        }
        Some(())
    }
}

/// [`Mechanism::link_pose`], and with columns to write [`Mechanism::link_jacobian`].
pub(crate) struct LinkPose<'s, R> {
    pub(crate) mechanism: Mechanism<'s, R>,
    pub(crate) values: &'s [R],
    pub(crate) link: usize,
    pub(crate) columns: Option<(Frame, &'s mut [Twist<R>])>,
}

impl<R: Real> Quick<R> for LinkPose<'_, R> {
    type Output = DualQuat<R>;

    #[inline]
    fn compute(mut self) -> Option<DualQuat<R>>
    where
        R: Number,
    {
        let steps = self.mechanism.steps;
        if let Some((_, columns)) = &mut self.columns {
            columns.fill(Twist::from_array([R::ZERO; 6]));
        }
        let (mut last, mut position) = (Placed::identity(Portable), 0);
        while let Some(step) = steps.get(position) {
            if !carries(steps, position, &[self.link]) {
                position += step.size as usize;
                continue;
            }
            let parent = (step.parent != NONE).then_some(last);
            let joined = joined(step, parent, self.values);
            if let Some((_, columns)) = &mut self.columns {
                for index in 0..step.kind.rates() {
                    // What others mimic is moved by all of them.
                    let column = columns.get_mut(step.rate as usize + index)?;
                    *column = *column + joined.screw(step, index);
                }
            }
            last = joined.pose;
            if step.link as usize == self.link {
                break;
            }
            position += 1;
        }
        let pose = DualQuat::from_array(last.to_motion());
        let Some((frame, columns)) = self.columns else { return Some(pose) };
        let (back, origin) = (pose.conjugate(), pose.translation());
        for column in columns {
            // Of a joint that does not carry the link, wherever that is.
            if column.to_array() == [R::ZERO; 6] {
                continue;
            }
            match frame {
                Frame::World => break,
                Frame::Body => *column = back.adjoint(*column),
                Frame::WorldAligned => column.linear = column.velocity_at(origin),
            }
        }
        Some(pose)
    }
}

/// A joint on the pose of its parent.
#[inline(always)]
fn joined<R>(step: &Step<R>, parent: Option<Placed<R>>, values: &[R]) -> Joined<R>
where
    R: Real + Number,
{
    let before = match parent {
        Some(parent) => parent.place(step),
        None => Placed::root(Portable, step),
    };
    let pose = moved(Portable, before, step, &mut Configuration(values));
    Joined { before, pose }
}

fn placed<R: Real>(pose: &DualQuat<R>) -> Placed<R> {
    let half = vector::scale(pose.translation(), R::HALF);
    Placed { rotation: pose.rotation().to_array(), half }
}
