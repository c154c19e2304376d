//! Single poses of a [`Clip`] and of [`PackedClips`], and how a joint moves from one time to
//! another.

use super::keys::{Keys, PlacedKeys};
use super::slot::JointSlot;
use super::{Clip, PackedClips};
use crate::law::{Law, NlerpLerp};
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::{Aos, Element, Layout, aos};
use dq8_simd::{Lanes, Portable, Records, Unfused};

impl<K> Clip<'_, K> {
    /// The local pose of a joint at the time `at`, as [`place`](Self::place) has it; `None` if
    /// there is no such joint. For whole skeletons take [`Sampled`](super::Sampled) and
    /// [`Job::locals`](super::Job::locals).
    #[must_use]
    pub fn pose<W, R: Scalar, const C: usize>(
        &self,
        law: W,
        joint: usize,
        at: R,
    ) -> Option<DualQuat<R>>
    where
        W: Law<C>,
        K: Element<C, Layout = Aos<R>>,
    {
        self.pose_at(law, joint, self.place(at))
    }

    /// The motion of a joint from one time to another, in its frame at the first: pose(from)* ·
    /// pose(to). Of the root this is the root motion of a character, which goes on where a
    /// [looping](Self::looping) clip begins again: with r rounds between the times, and the round
    /// c = pose(first)* · pose(last), it is pose(from)* · pose(first) · cʳ · pose(first)* ·
    /// pose(to). `None` if there is no such joint.
    ///
    /// ```
    /// use dq8::{DualQuat, hierarchy::Clip, law::Nlerp};
    /// // A step of one length in two frames, at 30 frames a second.
    /// let keys = [0.0_f32, 0.25, 1.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let walk = Clip::new(1, &keys)?.with_rate(30.0).looping();
    /// let step = walk.between(Nlerp, 0, 0.0, walk.duration() as f32 / 2.0).unwrap();
    /// assert!((step.translation()[0] - 0.25).abs() < 1e-6);
    /// // In a second it takes 15 steps.
    /// let second = walk.between(Nlerp, 0, 0.25_f32, 1.25).unwrap();
    /// assert!((second.translation()[0] - 15.0).abs() < 1e-4);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[must_use]
    pub fn between<W, R: Scalar, const C: usize>(
        &self,
        law: W,
        joint: usize,
        from: R,
        to: R,
    ) -> Option<DualQuat<R>>
    where
        W: Law<C>,
        K: Element<C, Layout = Aos<R>>,
    {
        self.timing.between(from, to, |place| self.pose_at(law, joint, place))
    }

    /// The pose of a joint at a place.
    fn pose_at<W, R: Scalar, const C: usize>(
        &self,
        law: W,
        joint: usize,
        (frame, t): (u32, R),
    ) -> Option<DualQuat<R>>
    where
        W: Law<C>,
        K: Element<C, Layout = Aos<R>>,
    {
        // A single frame is its own next one.
        let last = self.timing.frames.saturating_sub(1);
        let key = |frame: usize| {
            let keys = K::plain(self.keys)?.get(frame.min(last) * self.joints..)?;
            Some(aos::splat(ALONE, *keys.get(..self.joints)?.get(joint)?))
        };
        let [a, b]: [[<Aos<R> as Layout>::Register<Alone>; C]; 2] =
            [key(frame as usize)?, key(frame as usize + 1)?];
        Some(first(law, law.between(a, b, Lanes::splat(ALONE, t))))
    }
}

impl PackedClips<'_> {
    /// The local pose of a joint of a clip at the time `at`, as [`place`](Self::place) has it;
    /// `None` if there is no such clip or joint. As [`Clip::pose`].
    #[must_use]
    pub fn pose<R: Scalar>(&self, clip: usize, joint: usize, at: R) -> Option<DualQuat<R>> {
        self.pose_at(clip, joint, self.timing::<R>(clip)?.place(at))
    }

    /// The motion of a joint of a clip from one time to another, in its frame at the first: as
    /// [`Clip::between`], of a character's root the root motion. `None` if there is no such clip or
    /// joint.
    ///
    /// ```
    /// use dq8::hierarchy::{Clip, PackedClip, Tolerance};
    /// // A step of one length in two frames, at 30 frames a second.
    /// let keys = [0.0_f32, 0.25, 1.0].map(|z| [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, z]);
    /// let walk = Clip::new(1, &keys)?.with_rate(30.0).looping();
    /// let packed = PackedClip::new(walk, Tolerance::default())?;
    /// let second = packed.clips().between(0, 0, 0.25_f32, 1.25).unwrap();
    /// assert!((second.translation()[2] - 15.0).abs() < 1e-3);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[must_use]
    pub fn between<R: Scalar>(
        &self,
        clip: usize,
        joint: usize,
        from: R,
        to: R,
    ) -> Option<DualQuat<R>> {
        self.timing::<R>(clip)?.between(from, to, |place| self.pose_at(clip, joint, place))
    }

    /// The pose of a joint at a place of a clip.
    fn pose_at<R: Scalar>(
        &self,
        clip: usize,
        joint: usize,
        (frame, t): (u32, R),
    ) -> Option<DualQuat<R>> {
        let joints = self.joints();
        (joint < joints).then_some(())?;
        let places = [self.tracks.place(clip, frame)?];
        let playback = Keys::<R, 7>::placed(*self, &places).ok()?;
        let slot = JointSlot::of_joints(joint, 0, joints, joint + 1);
        let t: <Aos<R> as Layout>::Register<Alone> = Lanes::splat(ALONE, t);
        Some(first(NlerpLerp, PlacedKeys::pose(playback, ALONE, NlerpLerp, slot, t)?))
    }
}

/// Lanes of a single pose, which has the same bits on every target.
type Alone = Unfused<Portable>;
const ALONE: Alone = Unfused(Portable);

/// The motion in the first lane.
fn first<L: Lanes<Real: Scalar>, W: Law<C>, const C: usize>(
    law: W,
    pose: [L; C],
) -> DualQuat<L::Real> {
    let mut first = [[L::Real::default(); 8]];
    Records::store_records(law.motion(pose).to_array(), &mut first);
    let [motion] = first;
    DualQuat::from_array(motion)
}
