//! [`Clip`] and [`Sampled`]: animation that is sampled on its way into a register.

use super::layers::PoseSource;
use super::locals::sealed::Sealed;
use super::locals::{Locals, Motions, part_of};
use super::slot::JointSlot;
use crate::law::Law;
use crate::real::{Real, Scalar};
use crate::shape::{ShapeError, same_length, whole_instances};
use crate::storage::{Aos, Element, Layout, Number, identity};
use core::ops::Range;
use dq8_simd::{Gather, Level, Records};

/// Key frames at equal distances in time, `[frame][joint]`: motions, or rotations with translations
/// `[x, y, z, w, tx, ty, tz]`. A clip that loops ends with its first frame once more.
#[derive(Clone, Copy, Debug)]
pub struct Clip<'c, K> {
    pub(super) keys: &'c [K],
    pub(super) joints: usize,
    pub(super) frames: usize,
    pub(super) rate: f64,
    pub(super) loops: bool,
}

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
        Ok(Self { keys, joints, frames, rate: 1.0, loops: false })
    }

    /// The same clip with times in seconds, of so many frames a second; without, times are frames.
    #[must_use]
    pub fn with_rate(self, frames_per_second: f64) -> Self {
        Self { rate: frames_per_second, ..self }
    }

    /// The same clip, which begins again where it ends: times before and after it are those of other rounds.
    #[must_use]
    pub fn looping(self) -> Self {
        Self { loops: true, ..self }
    }

    /// The time from the first frame to the last.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.steps() / self.rate
    }

    /// How many frames follow another one.
    #[allow(clippy::cast_precision_loss, reason = "exact up to 2⁵³ frames")]
    pub(super) fn steps(&self) -> f64 {
        self.frames.saturating_sub(1) as f64
    }

    /// How many frames there are.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.frames
    }

    /// The frame before the time `at`, in frames from the first or, with a [rate](Self::with_rate), in seconds, and how
    /// far it is to the next one, from 0 to 1 inclusive. What lies outside the clip is its first or last frame, unless it
    /// [loops](Self::looping); NaN stays NaN. A clip of one frame has no next one ([`Sampled::new`] refuses it): give the
    /// frame twice.
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
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the clip")]
    pub fn place<R: Scalar>(&self, at: R) -> (u32, R) {
        let mut at: f64 = at.into() * self.rate;
        if self.loops && self.frames > 1 {
            at %= self.steps();
            at += if at < 0.0 { self.steps() } else { 0.0 };
        }
        // The last frame of all has no next one.
        let last = self.frames.saturating_sub(2).min(u32::MAX as usize) as u32;
        let frame = (at as u32).min(last);
        let t = at - f64::from(frame);
        (frame, Real::from_f64(if t.is_nan() { t } else { t.clamp(0.0, 1.0) }))
    }
}

/// Many instances, each at its own place in the same clip: instance i lies `t[i]` of the way from frame
/// `frames[i]` to the next one, with all of its joints. [Locals](super::Locals) like any other: the keys go
/// from the clip into registers, are interpolated there, and multiplied on, all in one pass.
///
/// Instances that play different clips share one call if the keys of all clips lie in one array, one clip after the
/// other: add the number of frames before a clip to the frame that [`Clip::place`] of that clip gives.
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
#[derive(Clone, Copy, Debug)]
pub struct Sampled<'s, W, K, R, const C: usize> {
    law: W,
    clip: Clip<'s, K>,
    frames: Gather<'s>,
    t: &'s [R],
}

impl<'s, W, K, R: Scalar, const C: usize> Sampled<'s, W, K, R, C>
where
    W: Law<C>,
    K: Element<C, Layout = Aos<R>>,
{
    /// One frame and one `t` for each instance. Values of `t` outside [0, 1] go on beyond the two frames.
    ///
    /// # Errors
    /// If `frames` and `t` differ in length, or a frame is not one of the clip, or the last one, which no
    /// frame follows.
    pub fn new(
        law: W,
        clip: Clip<'s, K>,
        frames: &'s [u32],
        t: &'s [R],
    ) -> Result<Self, ShapeError> {
        same_length("t", t.len(), frames.len())?;
        let missing = |frame: &u32| clip.frames.saturating_sub(1) <= *frame as usize;
        if let Some(instance) = frames.iter().position(missing) {
            let frame = frames.get(instance).map_or(0, |&frame| frame as usize);
            return Err(ShapeError::NoFrame { instance, frame, frames: clip.frames });
        }
        Ok(Self { law, clip, frames: Gather::new(frames, clip.joints), t })
    }
}

impl<M, W, K, const C: usize> PoseSource<M, C> for Sampled<'_, W, K, M::Real, C>
where
    M: Layout,
    W: Law<C>,
    K: Element<C, Layout = Aos<M::Real>>,
{
    fn shape(&self, joints: usize) -> Result<(&'static str, usize), ShapeError> {
        same_length("each frame of the clip", self.clip.joints, joints)?;
        Ok(("frames", joints.saturating_mul(self.t.len().div_ceil(M::THINGS))))
    }
    fn instances(&self) -> Option<usize> {
        Some(self.t.len())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn pose<V: Level>(self, level: V, slot: JointSlot) -> Option<[M::Register<V>; C]> {
        let keys = K::plain(self.clip.keys)?;
        let t = slot.of_instance(level, self.t)?;
        let (joint, next) = (slot.joint(), slot.joint() + self.clip.joints);
        let [a, b] = if slot.is_of_joints() {
            // One instance: its keys are already side by side.
            let frame = *self.frames.frames().get(slot.instance())? as usize * self.clip.joints;
            let keys = keys.get(frame..)?;
            [
                <M::Register<V>>::load_records(level, keys.get(joint..)?, identity()),
                <M::Register<V>>::load_records(level, keys.get(next..)?, identity()),
            ]
        } else {
            [
                <M::Register<V>>::load_gathered(level, keys, self.frames, slot.instance(), joint)?,
                <M::Register<V>>::load_gathered(level, keys, self.frames, slot.instance(), next)?,
            ]
        };
        Some(self.law.between(a, b, t))
    }
    fn some(self, _: usize, instances: Range<usize>) -> Self {
        let t = part_of(self.t, M::THINGS, instances.clone());
        let first = instances.start.saturating_mul(M::THINGS);
        Self { frames: self.frames.part(first..first.saturating_add(t.len())), t, ..self }
    }
}

impl<E, W, K, const C: usize> Locals<E> for Sampled<'_, W, K, Number<E, 8>, C>
where
    E: Element<8>,
    W: Law<C>,
    K: Element<C, Layout = Aos<Number<E, 8>>>,
{
    fn shape(&self, joints: usize, _: usize) -> Result<(&'static str, usize), ShapeError> {
        PoseSource::<E::Layout, C>::shape(self, joints)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(self, level: V, _: &[E], slot: JointSlot) -> Option<Motions<E, V>> {
        Some(self.law.motion(PoseSource::<E::Layout, C>::pose(self, level, slot)?))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn onto<V: Level>(
        self,
        level: V,
        parent: Motions<E, V>,
        _: &[E],
        slot: JointSlot,
    ) -> Option<Motions<E, V>> {
        Some(self.law.onto(parent, PoseSource::<E::Layout, C>::pose(self, level, slot)?))
    }
    fn part(self, joints: usize, instances: Range<usize>) -> Self {
        PoseSource::<E::Layout, C>::some(self, joints, instances)
    }
}

impl<W, K, R, const C: usize> Sealed for Sampled<'_, W, K, R, C> {}
