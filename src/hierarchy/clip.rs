//! [`Clip`]: key frames stored as floats, not packed. [`Sampled`] plays a clip, or any other
//! [`Keys`], for many instances. [`Clip::pose`] and [`Clip::between`] sample a single joint, such
//! as the root of a character for its root motion.

use super::layers::{PoseSource, locals_by_law};
use super::locals::sealed::Sealed;
use super::locals::{BATCHES, Locals, Registers, Stored, each, part_of, resized};
use super::run::JointSlot;
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

/// Key frames at equal distances in time, `[frame][joint]`. A key of type `K` is a motion, or a
/// rotation with a translation `[x, y, z, w, tx, ty, tz]`. In a clip that loops, the last frame is
/// the same moment as the first frame of the next round.
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
    /// Makes a clip of `joints` joints from its keys `[frame][joint]`.
    ///
    /// # Errors
    /// If `keys` is empty, or its length is not a multiple of `joints`.
    pub fn new(joints: usize, keys: &'c [K]) -> Result<Self, ShapeError> {
        if keys.is_empty() {
            return Err(ShapeError::Empty { what: "keys" });
        }
        let frames = whole_instances("keys", joints, keys.len())?;
        Ok(Self { keys, joints, timing: Timing { frames, rate: 1.0, loops: false } })
    }

    /// Sets the rate in frames a second, so that times are in seconds. Without a rate, times are in
    /// frames.
    pub fn with_rate(self, frames_per_second: f64) -> Self {
        Self { timing: self.timing.with_rate(frames_per_second), ..self }
    }

    /// Makes the clip begin again after its end. A time outside of the clip then lies in an earlier
    /// or later round of the clip.
    pub fn looping(self) -> Self {
        Self { timing: self.timing.looping(), ..self }
    }

    /// The time from the first frame to the last, in seconds if the clip has a rate, otherwise in
    /// frames.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.timing.duration()
    }

    /// The number of frames.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.timing.frames
    }

    /// The rate in frames a second, or 1 if times are in frames.
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.timing.rate
    }

    /// `true` if the clip begins again after its end.
    #[must_use]
    pub fn loops(&self) -> bool {
        self.timing.loops
    }

    /// Returns the frame before the time `at`, and the part of the way from it to the next frame,
    /// from 0 to 1 inclusive. Times count from the first frame, in frames or, with a
    /// [rate](Self::with_rate), in seconds. A time outside the clip gives its first or last frame,
    /// unless the clip [loops](Self::looping); for NaN the part is NaN. A clip of one frame has no
    /// next frame, and [`Sampled::new`](super::Sampled::new) refuses it: give the frame twice.
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

/// The timing of a clip: the number of its frames, its rate in frames a second, and `loops`, which
/// is `true` if the clip begins again after its end. Times are computed in the type `T`. For a
/// [`Clip`] this is `f64`; for packed clips it is the caller's type, because `f64` is slow on
/// microcontrollers.
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

    /// Returns the number of steps of the clip; a step leads from one frame to the next.
    fn steps(self) -> T {
        T::from_i32(i32::try_from(self.frames.saturating_sub(1)).unwrap_or(i32::MAX))
    }

    /// Returns the frame before the time `at` and the part of the way to the next frame, as
    /// [`Clip::place`] does.
    #[inline]
    pub(super) fn place<R: Scalar>(self, at: R) -> (u32, R) {
        self.place_in_round(Real::from_f64(self.round(at).1.into()))
    }

    /// Returns the index of the round in which the time `at` lies, and the time in that round, in
    /// frames.
    fn round<R: Scalar>(self, at: R) -> (T, T) {
        // If `R` and `T` are the same type, the conversion by way of `f64` compiles to no
        // instruction.
        let at: T = Real::from_f64(at.into());
        let (time, steps) = (at * self.rate, self.steps());
        if !self.loops || steps == T::ZERO {
            return (T::ZERO, time);
        }
        // An infinite time makes `rest` NaN.
        let round = truncate(time / steps);
        let rest = time - steps * round;
        if rest < T::ZERO { (round - T::ONE, rest + steps) } else { (round, rest) }
    }

    /// Returns the frame before a time in frames, and the part of the way to the next frame.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
    #[inline]
    fn place_in_round<R: Scalar>(self, time: R) -> (u32, R) {
        // No frame follows the last frame, so the frame before a time is at most the last but one.
        let last = self.frames.saturating_sub(2).min(i32::MAX as usize) as u32;
        let before = if R::SINGLE {
            bytemuck::cast::<R, f32>(time) as u32
        } else {
            bytemuck::cast::<R, f64>(time) as u32
        };
        let frame = before.min(last);
        let t = time - R::from_i32(frame.cast_signed());
        // The comparisons are written so that NaN stays NaN.
        let t = if t > R::ONE { R::ONE } else { t };
        (frame, if t < R::ZERO { R::ZERO } else { t })
    }

    /// Returns the motion of a joint from one time to another. `pose` computes its pose from a
    /// frame and the part of the way to the next frame.
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

/// Rounds toward zero, in place of the method `trunc`, which needs std. All `f32` from 2²³ on,
/// and all `f64` from 2⁵² on, are integers already.
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

/// A clip, and the index of a frame for each instance. No index is that of the last frame, because
/// the frame after each index is also read.
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
            // If lanes are joints of one instance, their keys adjoin in memory.
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

/// Key frames of a skeleton, with `C` components of type `R` for each joint: a
/// [`Clip`](super::Clip) or [`PackedClips`](super::PackedClips). The trait is sealed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` are no keys of {C} numbers of `{R}` for each joint",
    note = "packed clips have 7 numbers of `f32` for each joint, a rotation and a translation: the law `NlerpLerp` plays them, in \
            `f32`",
    note = "a `Clip` has 7 for `NlerpLerp`, or 8, a motion, for `Nlerp` and `Sclerp`"
)]
pub trait Keys<'s, R, const C: usize>: Copy + Sealed {
    /// The place of an instance in the keys. For a clip it is the index of a frame; for packed
    /// clips it is a clip and one of its frames.
    type Place;
    /// The type of these keys with a checked place for each instance.
    #[doc(hidden)]
    type Placed: KeysAt<R, C>;
    /// Attaches a place for each instance to these keys.
    ///
    /// # Errors
    /// If a place is not in these keys.
    #[doc(hidden)]
    fn placed(self, places: &'s [Self::Place]) -> Result<Self::Placed, ShapeError>;
}

/// Keys with a place for each instance. A pose has `C` components of type `R`.
#[doc(hidden)]
pub trait KeysAt<R, const C: usize>: Copy + Send + Sync {
    /// The number of joints.
    fn joints(self) -> usize;
    /// Interpolates the poses of a slot: each lane is the part `t` of the way from the key at its
    /// place to the next key.
    fn pose<L: Lanes<Real = R>, W: Law<C>>(
        self,
        level: L::Level,
        law: W,
        slot: JointSlot,
        t: L,
    ) -> Option<[L; C]>;
    /// Interpolates the poses of a slot and of the joints after it, into the first `C` rows of each
    /// element of `to`.
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
    /// Returns the keys with the places of a range of instances.
    #[must_use]
    fn part(self, instances: Range<usize>) -> Self;
}

/// Locals of many instances, each at its own place in the same clip: all joints of instance i are
/// `t[i]` of the way from frame `frames[i]` to the next frame. These [locals](super::Locals) are
/// computed during the run, for sixteen joints at a time and as many instances as there are lanes:
/// keys are loaded and interpolated, then multiplied onto the models of the parents. `W` is the law
/// of interpolation, `P` the type of the keys with their places, `R` the element type, and `C` the
/// number of components of a pose.
///
/// Instances that play different clips can share one call in two ways. One way is
/// [`PackedClips`](super::PackedClips). In the other way, the keys of all clips lie in one array,
/// one clip after the other; then add the number of frames before a clip to each frame that the
/// clip's [`Clip::place`](super::Clip::place) returns.
///
/// ```
/// use dq8::hierarchy::{Clip, Sampled};
/// use dq8::{DualQuat, Hierarchy, law::Nlerp};
/// let parents = [Hierarchy::ROOT, 0];
/// let arm = Hierarchy::new(&parents)?;
/// // Three frames of two joints.
/// let along_x = |x| DualQuat::from_translation([x, 0.0, 0.0]);
/// let keys = [1.0_f32, 1.0, 2.0, 2.0, 4.0, 4.0].map(along_x);
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
    /// Makes locals of many instances from a place and a parameter `t` for each instance. In a
    /// [`Clip`](super::Clip), a place is the index of a frame; in packed clips it is the result of
    /// [`PackedClips::place`](super::PackedClips::place). Values of `t` outside [0, 1] extrapolate
    /// beyond the two frames of a `Clip`; packed clips clamp them to [0, 1]. A `t` of NaN gives
    /// poses of NaN.
    ///
    /// # Errors
    /// If `places` and `t` differ in length, if a frame is not in the clip or is its last frame
    /// (after which there is none), or if a place was made by other packed clips.
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
    /// Returns the local pose of a joint at the time `at` (in the unit of [`place`](Self::place))
    /// by the law `law`, or `None` if there is no such joint. For whole skeletons use
    /// [`Sampled`](super::Sampled) and [`Job::locals`](super::Job::locals).
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

    /// Returns the motion of a joint from one time to another, in the joint's frame at the first
    /// time: pose(from)* · pose(to). For the root this is the root motion of a character. It stays
    /// continuous where a [looping](Self::looping) clip begins again: if r rounds lie between the
    /// times, and a round moves the joint by c = pose(first)* · pose(last), then the motion is
    /// pose(from)* · pose(first) · cʳ · pose(first)* · pose(to). `None` if there is no such
    /// joint.
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

    /// Returns the pose of a joint at a place.
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
        // In a clip of one frame, the only frame is also the next frame.
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

/// The level for single poses. Its lanes fuse no multiplication with an addition, so poses have the
/// same bits on every target.
pub(super) type Single = Unfused<Portable>;
pub(super) const SINGLE: Single = Unfused(Portable);

/// Converts the pose in the first lane to a motion.
pub(super) fn first<L: Lanes<Real: Scalar>, W: Law<C>, const C: usize>(
    law: W,
    pose: [L; C],
) -> DualQuat<L::Real> {
    let mut first = [[L::Real::default(); 8]];
    Records::store_records(law.motion(pose).to_array(), &mut first);
    let [motion] = first;
    DualQuat::from_array(motion)
}

/// A [`Clip`] that owns its keys, as a loader returns it.
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
    /// Makes a clip of `joints` joints; see [`Clip::new`].
    ///
    /// # Errors
    /// The errors of [`Clip::new`].
    pub fn new(joints: usize, keys: impl Into<Vec<K>>) -> Result<Self, ShapeError> {
        let keys = keys.into();
        let timing = Clip::new(joints, &keys)?.timing;
        Ok(Self { keys, joints, timing })
    }

    /// Sets the rate in frames a second; see [`Clip::with_rate`].
    pub fn with_rate(self, frames_per_second: f64) -> Self {
        Self { timing: self.timing.with_rate(frames_per_second), ..self }
    }

    /// Makes the clip begin again where it ends; see [`Clip::looping`].
    pub fn looping(self) -> Self {
        Self { timing: self.timing.looping(), ..self }
    }

    /// The time from the first frame to the last; see [`Clip::duration`].
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.timing.duration()
    }

    /// The number of frames; see [`Clip::frames`].
    #[must_use]
    pub fn frames(&self) -> usize {
        self.timing.frames
    }

    /// The rate in frames a second; see [`Clip::rate`].
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.timing.rate
    }

    /// `true` if the clip begins again where it ends; see [`Clip::loops`].
    #[must_use]
    pub fn loops(&self) -> bool {
        self.timing.loops
    }

    /// Returns the frame before the time `at` and the part of the way to the next; see
    /// [`Clip::place`].
    #[must_use]
    pub fn place<R: Scalar>(&self, at: R) -> (u32, R) {
        self.timing.place(at)
    }

    /// Returns the local pose of a joint at the time `at`; see [`Clip::pose`].
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

    /// Returns the motion of a joint from one time to another; see [`Clip::between`].
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

    /// Borrows the clip, for [`Sampled`](super::Sampled).
    pub fn view(&self) -> Clip<'_, K> {
        Clip { keys: &self.keys, joints: self.joints, timing: self.timing }
    }
}
