//! [`Clip`]: key frames of plain numbers, and [`Frames`] of it.

use super::keys::{Keys, PlacedKeys};
use super::locals::sealed::Sealed;
use super::rows::{Rows, each};
use super::slot::JointSlot;
use crate::brief::brief;
use crate::law::Law;
use crate::number::{Real, Scalar};
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, whole_instances};
use crate::storage::{Aos, Element, identity};
use core::marker::PhantomData;
use core::ops::Range;
use dq8_simd::internal::Gather;
use dq8_simd::{Lanes, Records};

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

    /// The same clip with times in seconds, of so many frames a second; without, times are frames.
    pub fn with_rate(self, frames_per_second: f64) -> Self {
        Self { timing: self.timing.with_rate(frames_per_second), ..self }
    }

    /// The same clip, which begins again where it ends: times before and after it are those of
    /// other rounds.
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

impl<K, R: Scalar, const C: usize> PlacedKeys<R, C> for Frames<'_, K, R>
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
        let [a, b] = if slot.is_of_joints() {
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
    fn poses<L: Lanes<Real = R>, W: Law<C>>(
        self,
        level: L::Level,
        law: W,
        slot: JointSlot,
        t: L,
        to: &mut [Rows<L>],
    ) -> Option<()> {
        if slot.is_of_joints() {
            return each(
                slot,
                to,
                #[cfg_attr(not(opt_level_0), inline(always))]
                |slot| PlacedKeys::pose(self, level, law, slot, t),
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
