//! [`Clip`], a tree of joints and, for each frame, one number a channel.

use crate::locals::{LARGEST, Locals};
use dq8::hierarchy::HierarchyError;
use dq8::{Backend, DualQuat, Hierarchy, Quat, ShapeError};
use std::error::Error;
use std::fmt;

/// An axis of a joint's frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The first axis.
    X,
    /// The second axis.
    Y,
    /// The third axis.
    Z,
}

/// One degree of freedom of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// Replaces this component of the joint's offset.
    Position(Axis),
    /// Turns by this many degrees.
    Rotation(Axis),
}

/// A joint of a clip.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The name, which no other joint of the clip has.
    pub name: String,
    /// The index of the parent, which stands earlier in the list; `None` for a root.
    pub parent: Option<usize>,
    /// The way from the parent's origin, in the parent's axes.
    pub offset: [f64; 3],
    /// The channels, in the order in which the file lists them.
    pub channels: Vec<Channel>,
    /// `true` for the tip of a chain, which is a place without a motion of its own.
    pub end_site: bool,
}

/// A motion-capture clip: joints, and a number for each channel in each frame.
#[derive(Clone, Debug)]
pub struct Clip {
    /// The title.
    pub title: String,
    /// The joints; a parent stands before its children.
    pub joints: Vec<Joint>,
    /// The seconds from one frame to the next.
    pub frame_time: f64,
    /// The values, `[frame][channel]`. Channels are in the order of the joints and, within a
    /// joint, as the joint lists them.
    pub values: Vec<f64>,
}

/// The error of a clip whose joints have no poses.
#[derive(Clone, Debug, PartialEq)]
pub enum ClipError {
    /// The parents of the joints do not form a tree.
    Tree(HierarchyError),
    /// The number of values is not a whole number of frames.
    Values(ShapeError),
    /// There are more poses than memory is meant for.
    TooMany {
        /// The number of frames.
        frames: usize,
        /// The number of joints.
        joints: usize,
    },
}

impl fmt::Display for ClipError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Tree(error) => write!(f, "{error}"),
            Self::Values(error) => write!(f, "{error}"),
            Self::TooMany { frames, joints } => {
                write!(f, "{frames} frames of {joints} joints are too many")
            }
        }
    }
}

impl Error for ClipError {}

impl From<HierarchyError> for ClipError {
    fn from(error: HierarchyError) -> Self {
        Self::Tree(error)
    }
}

impl From<ShapeError> for ClipError {
    fn from(error: ShapeError) -> Self {
        Self::Values(error)
    }
}

impl Clip {
    /// Returns the number of channels of all joints together.
    #[must_use]
    pub fn channels(&self) -> usize {
        self.joints.iter().map(|joint| joint.channels.len()).sum()
    }

    /// Returns the number of frames; a clip without channels has none.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.values.len().checked_div(self.channels()).unwrap_or(0)
    }

    /// Returns the number of joints that are tips.
    #[must_use]
    pub fn end_sites(&self) -> usize {
        self.joints.iter().filter(|joint| joint.end_site).count()
    }

    /// Returns the seconds from the first frame to this one.
    #[must_use]
    pub fn time(&self, frame: usize) -> f64 {
        frame as f64 * self.frame_time
    }

    /// Returns the parents as [`Hierarchy`] takes them.
    #[must_use]
    pub fn parents(&self) -> Vec<u32> {
        let index = |parent: usize| u32::try_from(parent).unwrap_or(Hierarchy::ROOT);
        self.joints.iter().map(|joint| joint.parent.map_or(Hierarchy::ROOT, index)).collect()
    }

    /// Returns the root that each joint hangs on; a joint whose parent does not stand before it is
    /// one.
    #[must_use]
    pub fn roots(&self) -> Vec<usize> {
        let mut roots = Vec::with_capacity(self.joints.len());
        for (index, joint) in self.joints.iter().enumerate() {
            let root = joint.parent.and_then(|parent| roots.get(parent).copied());
            roots.push(root.unwrap_or(index));
        }
        roots
    }

    /// Returns every joint's motion relative to its parent, `[frame][joint]`.
    #[must_use]
    pub fn locals(&self) -> Vec<DualQuat<f64>> {
        let (frames, channels) = (self.frames(), self.channels());
        let mut locals = vec![DualQuat::IDENTITY; frames * self.joints.len()];
        let values = &self.values[..frames * channels];
        if values.iter().all(|value| value.abs() < LARGEST) {
            let (joints, to) = (&self.joints, &mut locals);
            Backend::best().run(Locals { joints, channels, values, locals: to });
            return locals;
        }
        // A clip without channels has no frames, and no length to cut its values by.
        let of_frames = locals.chunks_exact_mut(self.joints.len().max(1));
        for (locals, mut rest) in of_frames.zip(values.chunks_exact(channels.max(1))) {
            for (local, joint) in locals.iter_mut().zip(&self.joints) {
                let (values, others) = rest.split_at(joint.channels.len());
                *local = joint.local(values);
                rest = others;
            }
        }
        locals
    }

    /// Returns every joint's motion in the world, `[frame][joint]`.
    ///
    /// # Errors
    /// If the joints do not form a tree, or the values are not a whole number of frames.
    pub fn models(&self) -> Result<Vec<DualQuat<f64>>, ClipError> {
        let (what, length) = ("values", self.values.len());
        let expected = self.frames() * self.channels();
        if length != expected {
            return Err(ShapeError::Length { what, length, expected }.into());
        }
        let mut models = self.locals();
        Hierarchy::new(&self.parents())?.job().local_to_model_in_place(&mut models)?;
        Ok(models)
    }
}

impl Joint {
    /// Makes a joint that is no tip.
    #[must_use]
    pub fn new(
        name: impl Into<String>,
        parent: Option<usize>,
        offset: [f64; 3],
        channels: Vec<Channel>,
    ) -> Self {
        Self { name: name.into(), parent, offset, channels, end_site: false }
    }

    /// Returns the motion relative to the parent for these values of the joint's channels.
    ///
    /// Rotations compose from left to right as listed: `Zrotation Xrotation` is Rz · Rx on column
    /// vectors, so the last one listed acts first.
    #[must_use]
    pub fn local(&self, values: &[f64]) -> DualQuat<f64> {
        let mut rotation = Quat::<f64>::IDENTITY;
        let mut translation = self.offset;
        for (channel, &value) in self.channels.iter().zip(values) {
            match *channel {
                Channel::Position(axis) => translation[axis as usize] = value,
                Channel::Rotation(axis) => {
                    let mut unit = [0.0; 3];
                    unit[axis as usize] = 1.0;
                    rotation = rotation * Quat::from_axis_angle(unit, value.to_radians());
                }
            }
        }
        DualQuat::from_rotation_translation(rotation, translation)
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Channel, Clip, ClipError, Joint};
    use Channel::{Position, Rotation};

    fn joint(parent: Option<usize>, offset: [f64; 3], channels: &[Channel]) -> Joint {
        Joint::new(format!("under {parent:?}"), parent, offset, channels.to_vec())
    }

    fn close(a: [f64; 3], b: [f64; 3]) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12)
    }

    #[test]
    fn clips_made_by_hand_are_refused_and_never_panic() {
        let clip = |parent, channels: &[Channel], values: &[f64]| Clip {
            title: String::new(),
            joints: vec![joint(parent, [0.0; 3], channels)],
            frame_time: 0.1,
            values: values.to_vec(),
        };
        let still = clip(None, &[], &[]);
        assert_eq!((still.frames(), still.models()), (0, Ok(Vec::new())));
        assert!(matches!(clip(None, &[], &[1.0]).models(), Err(ClipError::Values(_))));
        let odd = clip(None, &[Rotation(Axis::X), Rotation(Axis::Y)], &[1.0, 2.0, 3.0]);
        assert!(matches!(odd.models(), Err(ClipError::Values(_))));
        let own = clip(Some(0), &[Rotation(Axis::X)], &[1.0]);
        assert_eq!(own.roots(), [0]);
        assert!(matches!(own.models(), Err(ClipError::Tree(_))));
    }

    #[test]
    fn lanes_of_frames_are_the_motions_of_single_joints() {
        let (x, y, z) = (Axis::X, Axis::Y, Axis::Z);
        let all = [Position(z), Rotation(z), Rotation(x), Rotation(y), Position(x), Rotation(z)];
        let joints = vec![
            joint(None, [1.0, 2.0, 3.0], &all),
            joint(Some(0), [4.0, 5.0, 6.0], &[]),
            joint(Some(0), [7.0, 8.0, 9.0], &[Rotation(y), Rotation(x)]),
        ];
        for (frames, size) in [(0, 1.0), (1, 1.0), (7, 1.0), (21, 1e5), (3, 1e14)] {
            let value = |i: usize| size * (i as f64 * 7.3).sin() * 400.0;
            let values: Vec<_> = (0..8 * frames).map(value).collect();
            let (title, joints) = (String::new(), joints.clone());
            let clip = Clip { title, joints, frame_time: 0.1, values };
            let locals = clip.locals();
            assert_eq!(locals.len(), 3 * frames);
            for (frame, locals) in locals.chunks_exact(3).enumerate() {
                let values = &clip.values[8 * frame..];
                let wanted = [&values[..6], &[], &values[6..8]];
                for ((local, joint), values) in locals.iter().zip(&clip.joints).zip(wanted) {
                    let apart = local.distance_to(joint.local(values));
                    assert!(apart < 1e-12 * size, "frame {frame}: {apart}");
                    assert!(local.angle_to(joint.local(values)) < 1e-12 * size.min(1e6));
                }
            }
        }
    }

    #[test]
    fn rotations_compose_from_left_to_right() {
        let zx = joint(None, [0.0; 3], &[Rotation(Axis::Z), Rotation(Axis::X)]);
        let xz = joint(None, [0.0; 3], &[Rotation(Axis::X), Rotation(Axis::Z)]);
        // Rz · Rx: x turns y into z, z leaves it there. Rx · Rz: z turns y into −x, x leaves
        // that.
        let turned = |joint: Joint| joint.local(&[90.0, 90.0]).transform_point([0.0, 1.0, 0.0]);
        assert!(close(turned(zx), [0.0, 0.0, 1.0]));
        assert!(close(turned(xz), [-1.0, 0.0, 0.0]));
    }

    #[test]
    fn each_axis_turns_the_way_of_the_right_hand() {
        let about = |axis| joint(None, [0.0; 3], &[Rotation(axis)]).local(&[90.0]);
        assert!(close(about(Axis::X).transform_point([0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]));
        assert!(close(about(Axis::Y).transform_point([0.0, 0.0, 1.0]), [1.0, 0.0, 0.0]));
        assert!(close(about(Axis::Z).transform_point([1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]));
    }

    #[test]
    fn positions_replace_only_the_axes_they_name() {
        let channels = [Rotation(Axis::Y), Position(Axis::Z), Position(Axis::X)];
        let local = joint(Some(0), [1.0, 2.0, 3.0], &channels).local(&[30.0, -7.0, 5.0]);
        assert!(close(local.translation(), [5.0, 2.0, -7.0]));
    }
}
