//! [`Person`], the motion of a person: joints with names, and a pose of each in each frame.

use crate::RetargetError;
use crate::names::{find, plain};
use crate::role::Role;
use dq8::scalar::vector::{norm, sub};
use dq8::{DualQuat, Hierarchy};
use dq8_bvh::{Channel, Clip, ClipError, Joint, Warning};

/// The motion of a person.
#[derive(Clone, Debug)]
pub struct Person {
    title: String,
    names: Vec<String>,
    parents: Vec<Option<usize>>,
    frame_time: f64,
    /// The motion of each joint relative to its parent, `[frame][joint]`.
    locals: Vec<DualQuat<f64>>,
    /// The poses that the file gives to a person who does not move, if it has such a pose.
    neutral: Option<Vec<DualQuat<f64>>>,
    roles: [Option<usize>; Role::COUNT],
}

impl Person {
    /// Reads a person from the bytes of a BVH file. Returns a warning as well if the file has one
    /// frame more than it announces.
    ///
    /// # Errors
    /// If the bytes are not a BVH file, or a pose is not finite.
    pub fn from_bvh(
        title: impl Into<String>,
        bytes: &[u8],
    ) -> Result<(Self, Option<Warning>), RetargetError> {
        let (clip, warning) = dq8_bvh::parse(title.into(), bytes)?;
        Ok((Self::from_clip(&clip)?, warning))
    }

    /// Takes the person from a clip. The joints have the roles that their names say.
    ///
    /// # Errors
    /// If the clip has no frame, its joints do not form a tree, or a pose is not finite.
    pub fn from_clip(clip: &Clip) -> Result<Self, RetargetError> {
        let neutral = Clip { values: zero_channels(clip), ..clip.clone() }.locals();
        let mut person = Self {
            title: clip.title.clone(),
            names: clip.joints.iter().map(|joint| joint.name.clone()).collect(),
            parents: clip.joints.iter().map(|joint| joint.parent).collect(),
            frame_time: clip.frame_time,
            locals: clip.locals(),
            neutral: None,
            roles: [None; Role::COUNT],
        }
        .checked()?;
        person.neutral = Some(person.in_the_world(neutral)?);
        Ok(person)
    }

    /// Makes a person without a neutral pose: the axes of such a pose may be others than those of
    /// the motion, or there is none.
    pub(crate) fn from_locals(
        title: String,
        names: Vec<String>,
        parents: Vec<Option<usize>>,
        locals: Vec<DualQuat<f64>>,
        frame_time: f64,
    ) -> Result<Self, RetargetError> {
        let roles = [None; Role::COUNT];
        Self { title, names, parents, frame_time, locals, neutral: None, roles }.checked()
    }

    /// Returns this person with roles found by names, after a check of the poses.
    fn checked(mut self) -> Result<Self, RetargetError> {
        let joints = self.names.len();
        if joints == 0 || self.locals.is_empty() {
            return Err(RetargetError::Lengths { array: "frames", length: 0, expected: 1 });
        }
        let time = self.frame_time;
        if !(time > 0.0 && time.is_finite()) {
            return Err(RetargetError::Setting { name: "frame_time", value: time });
        }
        if let Some(index) = self.locals.iter().position(|pose| !is_sane(pose)) {
            let joint = self.names[index % joints].clone();
            return Err(RetargetError::NotFinite { frame: index / joints, joint });
        }
        let names: Vec<_> = self.names.iter().map(|name| plain(name)).collect();
        for role in Role::ALL {
            self.roles[role as usize] = find(&names, role.side(), role.names().joints);
        }
        Ok(self)
    }

    /// Returns this person with the roles that a table of TOML gives to joints under `[joints]`,
    /// such as `left_hip = "LeftUpLeg"`. Roles that the table does not name stay as they are.
    ///
    /// # Errors
    /// If the text is not TOML, or names a role or a joint that does not exist.
    pub fn with_table(mut self, text: &str) -> Result<Self, RetargetError> {
        for (role, entry) in crate::table::entries(text, "joints")? {
            self.roles[role as usize] = Some(entry.index(&self.names)?);
        }
        Ok(self)
    }

    /// The title.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The names of the joints.
    #[must_use]
    pub fn joint_names(&self) -> &[String] {
        &self.names
    }

    /// The parent of each joint, which stands before it; `None` for a root.
    #[must_use]
    pub fn parents(&self) -> &[Option<usize>] {
        &self.parents
    }

    /// Returns the joint that has this role.
    #[must_use]
    pub fn joint(&self, role: Role) -> Option<usize> {
        self.roles[role as usize]
    }

    /// Returns the number of frames.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.locals.len() / self.names.len()
    }

    /// The seconds from one frame to the next.
    #[must_use]
    pub fn frame_time(&self) -> f64 {
        self.frame_time
    }

    pub(crate) fn neutral(&self) -> Option<&[DualQuat<f64>]> {
        self.neutral.as_deref()
    }

    /// Returns the poses of all joints in a run of frames, `[frame][joint]`.
    pub(crate) fn poses(
        &self,
        frames: std::ops::Range<usize>,
    ) -> Result<Vec<DualQuat<f64>>, RetargetError> {
        let joints = self.names.len();
        let poses = self.locals.get(frames.start * joints..frames.end * joints);
        self.in_the_world(poses.unwrap_or_default().to_vec())
    }

    /// Returns the poses of all joints at `first`, `first + step` and so on seconds after the first
    /// frame, up to the last frame, `[time][joint]`. Between two frames, the joints' motions
    /// relative to their parents are interpolated, so bones keep their lengths.
    pub(crate) fn poses_every(
        &self,
        first: f64,
        step: f64,
    ) -> Result<Vec<DualQuat<f64>>, RetargetError> {
        let joints = self.names.len();
        let frame = |index: usize| &self.locals[index * joints..][..joints];
        let last = self.frames() - 1;
        // A time within a billionth of the last frame is that frame.
        let times = ((last as f64 * self.frame_time - first) / step + 1e-9).floor().max(0.0);
        let times = (times as usize).saturating_add(1);
        let length = times.checked_mul(joints).filter(|&length| length < 1 << 26);
        let length = length.ok_or(ClipError::TooMany { frames: times, joints })?;
        let mut poses = Vec::with_capacity(length);
        for index in 0..times {
            let at = ((first + index as f64 * step) / self.frame_time).min(last as f64);
            let nearest = at.round();
            // A rate that the clip's own divides by takes its frames as they are.
            let at = if (at - nearest).abs() < 1e-6 { nearest } else { at };
            let (now, t) = (at as usize, at.fract());
            if t > 0.0 {
                let pairs = frame(now).iter().zip(frame((now + 1).min(last)));
                poses.extend(pairs.map(|(&a, &b)| a.nlerp(b, t)));
            } else {
                poses.extend(frame(now));
            }
        }
        self.in_the_world(poses)
    }

    fn in_the_world(
        &self,
        mut poses: Vec<DualQuat<f64>>,
    ) -> Result<Vec<DualQuat<f64>>, RetargetError> {
        let index = |parent: usize| u32::try_from(parent).unwrap_or(Hierarchy::ROOT);
        let parents = self.parents.iter().map(|parent| parent.map_or(Hierarchy::ROOT, index));
        let parents: Vec<_> = parents.collect();
        let hierarchy = Hierarchy::new(&parents).map_err(ClipError::from)?;
        hierarchy.job().local_to_model_in_place(&mut poses)?;
        Ok(poses)
    }

    /// Returns `true` if the second frame is ten times as far from the first as from the third.
    /// Many files begin with the skeleton at rest, and then jump into the motion.
    pub(crate) fn jumps(&self) -> Result<bool, RetargetError> {
        if self.frames() < 3 {
            return Ok(false);
        }
        let poses = self.poses(0..3)?;
        let frame = |index: usize| poses[index * self.names.len()..][..self.names.len()].iter();
        let way = |a: usize, b: usize| -> f64 {
            let pairs = frame(a).zip(frame(b));
            pairs.map(|(a, b)| norm(sub(a.translation(), b.translation()))).sum()
        };
        Ok(way(0, 1) > 10.0 * way(1, 2))
    }
}

/// Returns `true` if all numbers are finite and no place is farther away than a light second, from
/// where on rounding errors are larger than feet.
fn is_sane(pose: &DualQuat<f64>) -> bool {
    pose.to_array().iter().all(|number| number.abs() < 3e8)
}

/// Returns the values of the first frame with no turns, the root at the origin, and every other
/// joint that has position channels where the first frame has it. Files that give all joints
/// positions repeat the offsets there, which zeros would drop.
fn zero_channels(clip: &Clip) -> Vec<f64> {
    let channels =
        clip.joints.iter().flat_map(|joint| joint.channels.iter().map(move |c| (joint, c)));
    let keeps = |(joint, channel): (&Joint, &Channel)| {
        joint.parent.is_some() && matches!(channel, Channel::Position(_))
    };
    clip.values
        .iter()
        .zip(channels)
        .map(|(&value, of)| if keeps(of) { value } else { 0.0 })
        .collect()
}
