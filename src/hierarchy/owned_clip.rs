use super::clip::{Clip, Timing};
use crate::brief::brief;
use crate::law::Law;
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::shape::ShapeError;
use crate::storage::{Aos, Element};
use alloc::vec::Vec;

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
#[derive(Clone)]
#[must_use]
pub struct OwnedClip<K> {
    keys: Vec<K>,
    joints: usize,
    timing: Timing<f64>,
}

brief!([K] OwnedClip<K>: OwnedClip |it| {
    joints: it.joints, frames: it.timing.frames, rate: it.timing.rate, loops: it.timing.loops,
});

impl<K> OwnedClip<K> {
    /// See [`Clip::new`].
    ///
    /// # Errors
    /// As there.
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

    /// The same, borrowed: what [`Sampled`](super::Sampled) takes.
    pub fn view(&self) -> Clip<'_, K> {
        Clip { keys: &self.keys, joints: self.joints, timing: self.timing }
    }
}
