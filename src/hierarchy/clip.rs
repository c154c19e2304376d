//! [`Clip`]: key frames of plain numbers. [`Sampled`] plays it, or any other [`Keys`], for many
//! instances; `pose` and `between` for a single joint, such as the root motion of a character.

use super::layers::{PoseSource, locals_by_law};
use super::locals::sealed::Sealed;
use super::locals::{BATCHES, Locals, Registers, Stored, each, part_of, resized};
use super::slot::JointSlot;
use crate::batch::vector;
use crate::law::Law;
use crate::macros::brief;
use crate::number::{Real, Scalar};
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length, whole_instances};
use crate::storage::{Aos, Element, Layout, Motions, Number, Register, identity};
#[cfg(feature = "alloc")]
use alloc::vec::Vec;
use core::fmt::Debug;
use core::marker::PhantomData;
use core::ops::Range;
use dq8_simd::internal::Gather;
use dq8_simd::{Lanes, Level, Portable, Records, Unfused};

/// Key frames at equal distances in time, `[frame][joint]`: motions, or rotations with translations
/// `[x, y, z, w, tx, ty, tz]`. A clip that loops ends with its first frame once more.
#[derive(Clone, Copy)]
#[must_use]
#[doc(alias("animation"))]
pub struct Clip<'c, K> {
    pub(super) keys: &'c [K],
    pub(super) joints: usize,
    pub(super) timing: Timing<f64>,
}

brief!([K] Clip<'_, K>: Clip |it| {
    joints: it.joints, frames: it.timing.frames, rate: it.timing.rate, loops: it.timing.loops,
});

impl<'c, K> Clip<'c, K> {
    /// A clip of `joints` joints.
    ///
    /// # Errors
    /// If `keys` is empty or holds no whole number of frames.
    pub fn new(joints: usize, keys: &'c [K]) -> Result<Self, ShapeError> {
        if keys.is_empty() {
            return Err(ShapeError::Empty { what: "keys" });
        }
        let frames = whole_instances("keys", joints, keys.len())?;
        Ok(Self { keys, joints, timing: Timing { frames, rate: 1.0, loops: false } })
    }

    /// The clip with times in seconds, at this many frames a second; without a rate, times are
    /// frames.
    pub fn with_rate(self, frames_per_second: f64) -> Self {
        Self { timing: self.timing.with_rate(frames_per_second), ..self }
    }

    /// The clip, which begins again where it ends: a time before or after it lies in another round.
    pub fn looping(self) -> Self {
        Self { timing: self.timing.looping(), ..self }
    }

    /// The time from the first frame to the last.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.timing.duration()
    }

    /// The number of frames.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.timing.frames
    }

    /// The number of frames a second, or 1 if times are frames.
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.timing.rate
    }

    /// `true` if the clip begins again where it ends.
    #[must_use]
    pub fn loops(&self) -> bool {
        self.timing.loops
    }

    /// The frame before the time `at`, in frames from the first or, with a [rate](Self::with_rate),
    /// in seconds, and how far it is to the next one, from 0 to 1 inclusive. What lies outside the
    /// clip is its first or last frame, unless it [loops](Self::looping); NaN stays NaN. A clip of
    /// one frame has no next one ([`Sampled::new`](super::Sampled::new) refuses it): give the frame
    /// twice.
    ///
    /// ```
    /// use dq8::hierarchy::Clip;
    /// let keys = [[0.0_f32; 8]; 6];
    /// let clip = Clip::new(2, &keys)?;
    /// assert_eq!(clip.place(1.25_f32), (1, 0.25));
    /// assert_eq!(clip.place(7.0_f32), (1, 1.0));
    /// // Two steps at 4 frames a second take half a second: 0.6875 s lie in the second round.
    /// assert_eq!(clip.with_rate(4.0).looping().place(0.6875_f32), (0, 0.75));
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[must_use]
    pub fn place<R: Scalar>(&self, at: R) -> (u32, R) {
        self.timing.place(at)
    }
}

/// The number of a clip's frames, the frames a second, and `loops` if the clip begins again where
/// it ends. Times are computed in numbers of `T`: of a [`Clip`] in `f64`, of packed clips in those
/// of the caller, for firmware has no quick `f64`.
#[derive(Clone, Copy)]
pub(super) struct Timing<T> {
    pub(super) frames: usize,
    pub(super) rate: T,
    pub(super) loops: bool,
}

impl<T: Scalar> Timing<T> {
    pub(super) fn with_rate(self, rate: T) -> Self {
        Self { rate, ..self }
    }

    pub(super) fn looping(self) -> Self {
        Self { loops: true, ..self }
    }

    pub(super) fn duration(self) -> T {
        self.steps() / self.rate
    }

    /// The number of frames that follow another one.
    fn steps(self) -> T {
        T::from_i32(i32::try_from(self.frames.saturating_sub(1)).unwrap_or(i32::MAX))
    }

    /// [`Clip::place`].
    pub(super) fn place<R: Scalar>(self, at: R) -> (u32, R) {
        self.place_in_round(Real::from_f64(self.round(at).1.into()))
    }

    /// The round of the clip at the time `at`, from 0, and the time in it, in frames.
    fn round<R: Scalar>(self, at: R) -> (T, T) {
        // From a number to the same number by way of `f64` is no instruction.
        let at: T = Real::from_f64(at.into());
        let (time, steps) = (at * self.rate, self.steps());
        if !self.loops || steps == T::ZERO {
            return (T::ZERO, time);
        }
        // NaN from what is infinite.
        let round = truncate(time / steps);
        let rest = time - steps * round;
        if rest < T::ZERO { (round - T::ONE, rest + steps) } else { (round, rest) }
    }

    /// The frame before a time in frames, and the part of the way to the next one.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
    fn place_in_round<R: Scalar>(self, time: R) -> (u32, R) {
        // The last frame of all has no next one.
        let last = self.frames.saturating_sub(2).min(i32::MAX as usize) as u32;
        let before = if R::SINGLE {
            bytemuck::cast::<R, f32>(time) as u32
        } else {
            bytemuck::cast::<R, f64>(time) as u32
        };
        let frame = before.min(last);
        let t = time - R::from_i32(frame.cast_signed());
        // NaN stays NaN.
        let t = if t > R::ONE { R::ONE } else { t };
        (frame, if t < R::ZERO { R::ZERO } else { t })
    }

    /// The motion of a joint from one time to another, of its `pose` a part of the way from a frame
    /// to the next one.
    pub(super) fn between<R: Scalar>(
        self,
        from: R,
        to: R,
        pose: impl Fn((u32, R)) -> Option<DualQuat<R>>,
    ) -> Option<DualQuat<R>> {
        let [a, b] = [pose(self.place(from))?, pose(self.place(to))?];
        let rounds = self.round(to).0 - self.round(from).0;
        if rounds == T::ZERO {
            return Some(a.conjugate() * b);
        }
        let first = pose((0, R::ZERO))?;
        let last = pose(self.place_in_round(Real::from_f64(self.steps().into())))?;
        let round = (first.conjugate() * last).pow(Real::from_f64(rounds.into()));
        Some(a.conjugate() * first * round * (first.conjugate() * b))
    }
}

/// The integer toward zero: without std there is no `trunc`. From 2²³, in `f64` from 2⁵² on,
/// all numbers are integers.
#[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "in range")]
fn truncate<R: Scalar>(number: R) -> R {
    if R::SINGLE {
        let x: f32 = bytemuck::cast(number);
        bytemuck::cast(if -8_388_608.0 < x && x < 8_388_608.0 { x as i32 as f32 } else { x })
    } else {
        let most = 4_503_599_627_370_496.0;
        let x: f64 = bytemuck::cast(number);
        bytemuck::cast(if -most < x && x < most { x as i64 as f64 } else { x })
    }
}

impl<K> Sealed for Clip<'_, K> {}
impl<'s, K, R: Scalar, const C: usize> Keys<'s, R, C> for Clip<'s, K>
where
    K: Element<C, Layout = Aos<R>>,
{
    type Place = u32;
    type Placed = Frames<'s, K, R>;
    fn placed(self, frames: &'s [u32]) -> Result<Self::Placed, ShapeError> {
        let missing = |frame: &u32| self.timing.frames.saturating_sub(1) <= *frame as usize;
        if let Some(instance) = frames.iter().position(missing) {
            let frame = frames.get(instance).map_or(0, |&frame| frame as usize);
            return Err(ShapeError::NoFrame { instance, frame, frames: self.timing.frames });
        }
        Ok(Frames { clip: self, frames: Gather::new(frames, self.joints), number: PhantomData })
    }
}

/// Frames of a clip, one for each instance, that another one follows.
#[derive(Clone, Copy)]
pub struct Frames<'s, K, R> {
    clip: Clip<'s, K>,
    frames: Gather<'s>,
    number: PhantomData<R>,
}

brief!([K, R] Frames<'_, K, R>: Frames |it| {
    clip: it.clip, instances: it.frames.frames().len(),
});

impl<K, R: Scalar, const C: usize> KeysAt<R, C> for Frames<'_, K, R>
where
    K: Element<C, Layout = Aos<R>>,
{
    fn joints(self) -> usize {
        self.clip.joints
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn pose<L: Lanes<Real = R>, W: Law<C>>(
        self,
        level: L::Level,
        law: W,
        slot: JointSlot,
        t: L,
    ) -> Option<[L; C]> {
        let keys = K::plain(self.clip.keys)?;
        let (joint, next) = (slot.joint(), slot.joint() + self.clip.joints);
        let [a, b] = if slot.lanes_are_joints() {
            // One instance: its keys are already side by side.
            let frame = *self.frames.frames().get(slot.instance())? as usize * self.clip.joints;
            let keys = keys.get(frame..)?;
            [
                L::load_records(level, keys.get(joint..)?, identity()),
                L::load_records(level, keys.get(next..)?, identity()),
            ]
        } else {
            let rows = self.frames.rows::<L, C>(slot.instance())?;
            [
                L::load_gathered(level, keys, &rows, joint)?,
                L::load_gathered(level, keys, &rows, next)?,
            ]
        };
        Some(law.between(a, b, t))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_batch<L: Lanes<Real = R>, W: Law<C>>(
        self,
        law: W,
        slot: JointSlot,
        t: L,
        to: &mut [Stored<L>],
    ) -> Option<()> {
        let level = t.level();
        if slot.lanes_are_joints() {
            return each(
                slot,
                to,
                #[cfg_attr(not(opt_level_0), inline(always))]
                |slot| KeysAt::pose(self, level, law, slot, t),
            );
        }
        let (keys, rows) = (K::plain(self.clip.keys)?, self.frames.rows::<L, C>(slot.instance())?);
        each(
            slot,
            to,
            #[cfg_attr(not(opt_level_0), inline(always))]
            |slot| {
                let (joint, next) = (slot.joint(), slot.joint() + self.clip.joints);
                let a = L::load_gathered(level, keys, &rows, joint)?;
                Some(law.between(a, L::load_gathered(level, keys, &rows, next)?, t))
            },
        )
    }
    fn part(self, instances: Range<usize>) -> Self {
        Self { frames: self.frames.part(instances), ..self }
    }
}

/// Key frames of a skeleton, in numbers of `R`, `C` for each joint: a [`Clip`](super::Clip) or
/// [`PackedClips`](super::PackedClips). Sealed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` are no keys of {C} numbers of `{R}` for each joint",
    note = "packed clips have 7 numbers of `f32` for each joint, a rotation and a translation: the law `NlerpLerp` plays them, in \
            `f32`",
    note = "a `Clip` has 7 for `NlerpLerp`, or 8, a motion, for `Nlerp` and `Sclerp`"
)]
pub trait Keys<'s, R, const C: usize>: Copy + Sealed {
    /// The place of an instance: the number of a frame, or a clip and a frame.
    type Place;
    /// The keys, and places that have been checked.
    #[doc(hidden)]
    type Placed: KeysAt<R, C>;
    /// These keys at the place of each instance.
    ///
    /// # Errors
    /// If one of the places is not in these keys.
    #[doc(hidden)]
    fn placed(self, places: &'s [Self::Place]) -> Result<Self::Placed, ShapeError>;
}

/// Keys with a place for each instance.
#[doc(hidden)]
pub trait KeysAt<R, const C: usize>: Copy + Send + Sync {
    /// The number of joints.
    fn joints(self) -> usize;
    /// The poses of a slot.
    fn pose<L: Lanes<Real = R>, W: Law<C>>(
        self,
        level: L::Level,
        law: W,
        slot: JointSlot,
        t: L,
    ) -> Option<[L; C]>;
    /// The poses of a slot and of those after it, into the first `C` rows of each element of `to`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_batch<L: Lanes<Real = R>, W: Law<C>>(
        self,
        law: W,
        slot: JointSlot,
        t: L,
        to: &mut [Stored<L>],
    ) -> Option<()> {
        let level = t.level();
        each(
            slot,
            to,
            #[cfg_attr(not(opt_level_0), inline(always))]
            |slot| self.pose(level, law, slot, t),
        )
    }
    /// The keys of some of the instances.
    #[must_use]
    fn part(self, instances: Range<usize>) -> Self;
}

/// Many instances, each at its own place in the same clip: instance i lies `t[i]` of the way from
/// frame `frames[i]` to the next one, with all of its joints. [Locals](super::Locals) like any
/// other, in one pass: keys are loaded and interpolated for sixteen joints of as many instances as
/// there are lanes, then multiplied on.
///
/// Instances that play different clips share one call if they are
/// [`PackedClips`](super::PackedClips), or if the keys of all clips lie in one array, one clip
/// after the other: add the number of frames before a clip to the frame that
/// [`Clip::place`](super::Clip::place) of that clip gives.
///
/// ```
/// use dq8::hierarchy::{Clip, Sampled};
/// use dq8::{DualQuat, Hierarchy, law::Nlerp};
/// let parents = [Hierarchy::ROOT, 0];
/// let arm = Hierarchy::new(&parents)?;
/// // Three frames of two joints.
/// let keys = [1.0_f32, 1.0, 2.0, 2.0, 4.0, 4.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
/// let clip = Clip::new(2, &keys)?;
/// // Two instances: a quarter after frame 0, and half way between the last two frames.
/// let locals = Sampled::new(Nlerp, clip, &[0, 1], &[0.25, 0.5])?;
/// let mut models = [DualQuat::IDENTITY; 2 * 2];
/// arm.job().locals_to_model(locals, &mut models)?;
/// assert_eq!(models[1].translation(), [2.5, 0.0, 0.0]);
/// assert_eq!(models[3].translation(), [6.0, 0.0, 0.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
#[doc(alias("SamplingJob"))]
pub struct Sampled<'s, W, P, R, const C: usize> {
    law: W,
    keys: P,
    t: &'s [R],
}

brief!([W: Debug, P: Debug, R, const C: usize] Sampled<'_, W, P, R, C>: Sampled |it| {
    law: it.law, keys: it.keys, instances: it.t.len(),
});

impl<'s, W: Law<C>, P: KeysAt<R, C>, R: Scalar, const C: usize> Sampled<'s, W, P, R, C> {
    /// Many instances, by a place and a `t` for each. A place is the number of a frame in a
    /// [`Clip`](super::Clip), and what [`PackedClips::place`](super::PackedClips::place) gives in
    /// those. Values of `t` outside [0, 1] go on beyond the two frames of a `Clip`; in packed clips
    /// they are cut to that. NaN makes poses of NaN.
    ///
    /// # Errors
    /// If `places` and `t` differ in length, or a frame is not one of the clip, or the last one,
    /// which no frame follows, or a place is one of other packed clips.
    pub fn new<K: Keys<'s, R, C, Placed = P>>(
        law: W,
        clip: K,
        places: &'s [K::Place],
        t: &'s [R],
    ) -> Result<Self, ShapeError> {
        same_length("t", t.len(), places.len())?;
        Ok(Self { law, keys: clip.placed(places)?, t })
    }
}

impl<M, W, P, const C: usize> PoseSource<M, C> for Sampled<'_, W, P, M::Real, C>
where
    M: Layout,
    W: Law<C>,
    P: KeysAt<M::Real, C>,
{
    const COMPUTED: bool = true;

    fn shape(&self, joints: usize) -> Result<(&'static str, usize), ShapeError> {
        same_length("each frame of the clip", self.keys.joints(), joints)?;
        Ok(("frames", joints.saturating_mul(self.t.len().div_ceil(M::THINGS))))
    }
    fn instances(&self) -> Option<usize> {
        Some(self.t.len())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(self, level: V, slot: JointSlot) -> Option<[M::Register<V>; C]> {
        let t = slot.of_instance(level, self.t)?;
        self.keys.pose(level, self.law, slot, t)
    }
    #[inline(never)]
    fn load_batch<V: Level>(
        &self,
        level: V,
        slot: JointSlot,
        to: &mut [Stored<M::Register<V>>],
    ) -> Option<()> {
        level.run(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || {
                let t: M::Register<V> = slot.of_instance(level, self.t)?;
                self.keys.load_batch(self.law, slot, t, to)
            },
        )
    }
    fn part(self, _: usize, instances: Range<usize>) -> Self {
        let t = part_of(self.t, M::THINGS, instances.clone());
        let first = instances.start.saturating_mul(M::THINGS);
        Self { keys: self.keys.part(first..first.saturating_add(t.len())), t, ..self }
    }
}

locals_by_law!([W, P, const C: usize] Sampled<'_, W, P, Number<E, 8>, C>, C, |poses| poses.law;
    W: Law<C>, P: KeysAt<Number<E, 8>, C>);

impl<W, P, R, const C: usize> Sealed for Sampled<'_, W, P, R, C> {}

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
            Some(vector::splat(SINGLE, *keys.get(..self.joints)?.get(joint)?))
        };
        let [a, b]: [[<Aos<R> as Layout>::Register<Single>; C]; 2] =
            [key(frame as usize)?, key(frame as usize + 1)?];
        Some(first(law, law.between(a, b, Lanes::splat(SINGLE, t))))
    }
}

/// The level of a single pose, which has the same bits on every target.
pub(super) type Single = Unfused<Portable>;
pub(super) const SINGLE: Single = Unfused(Portable);

/// The motion in the first lane.
pub(super) fn first<L: Lanes<Real: Scalar>, W: Law<C>, const C: usize>(
    law: W,
    pose: [L; C],
) -> DualQuat<L::Real> {
    let mut first = [[L::Real::default(); 8]];
    Records::store_records(law.motion(pose).to_array(), &mut first);
    let [motion] = first;
    DualQuat::from_array(motion)
}

/// A [`Clip`] with memory of its own: what a loader gives.
///
/// ```
/// use dq8::hierarchy::OwnedClip;
/// use dq8::{DualQuat, law::Sclerp};
/// let keys = [0.0_f64, 1.0, 3.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
/// let walk = OwnedClip::new(1, keys)?.with_rate(10.0);
/// assert_eq!(walk.place(0.125), (1, 0.25));
/// let hip = walk.pose(Sclerp, 0, 0.15).unwrap();
/// assert!((hip.translation()[0] - 2.0).abs() < 1e-12);
/// # Ok::<(), dq8::ShapeError>(())
/// ```
#[cfg(feature = "alloc")]
#[derive(Clone)]
#[must_use]
pub struct OwnedClip<K> {
    keys: Vec<K>,
    joints: usize,
    timing: Timing<f64>,
}

#[cfg(feature = "alloc")]
brief!([K] OwnedClip<K>: OwnedClip |it| {
    joints: it.joints, frames: it.timing.frames, rate: it.timing.rate, loops: it.timing.loops,
});

#[cfg(feature = "alloc")]
impl<K> OwnedClip<K> {
    /// See [`Clip::new`].
    ///
    /// # Errors
    /// As [`Clip::new`].
    pub fn new(joints: usize, keys: impl Into<Vec<K>>) -> Result<Self, ShapeError> {
        let keys = keys.into();
        let timing = Clip::new(joints, &keys)?.timing;
        Ok(Self { keys, joints, timing })
    }

    /// See [`Clip::with_rate`].
    pub fn with_rate(self, frames_per_second: f64) -> Self {
        Self { timing: self.timing.with_rate(frames_per_second), ..self }
    }

    /// See [`Clip::looping`].
    pub fn looping(self) -> Self {
        Self { timing: self.timing.looping(), ..self }
    }

    /// See [`Clip::duration`].
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.timing.duration()
    }

    /// See [`Clip::frames`].
    #[must_use]
    pub fn frames(&self) -> usize {
        self.timing.frames
    }

    /// See [`Clip::rate`].
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.timing.rate
    }

    /// See [`Clip::loops`].
    #[must_use]
    pub fn loops(&self) -> bool {
        self.timing.loops
    }

    /// See [`Clip::place`].
    #[must_use]
    pub fn place<R: Scalar>(&self, at: R) -> (u32, R) {
        self.timing.place(at)
    }

    /// See [`Clip::pose`].
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
        self.view().pose(law, joint, at)
    }

    /// See [`Clip::between`].
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
        self.view().between(law, joint, from, to)
    }

    /// The clip, borrowed: what [`Sampled`](super::Sampled) takes.
    pub fn view(&self) -> Clip<'_, K> {
        Clip { keys: &self.keys, joints: self.joints, timing: self.timing }
    }
}
