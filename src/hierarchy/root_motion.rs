//! Single poses of a [`Clip`], and how a joint moves from one time to another.

use super::Clip;
use crate::law::Law;
use crate::number::{Real, Scalar};
use crate::scalar::DualQuat;
use crate::storage::{Aos, Element, Layout, aos};
use dq8_simd::{Lanes, Portable, Records, Unfused};

impl<K> Clip<'_, K> {
    /// The local pose of a joint at the time `at`, as [`place`](Self::place) has it; `None` if there is no such joint.
    /// For whole skeletons take [`Sampled`](super::Sampled) and [`Job::locals`](super::Job::locals).
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
        // A single pose has the same bits on every target.
        let level = Unfused(Portable);
        let (frame, t) = self.place(at);
        let key = |frame: usize| {
            // Of one frame alone the next one is itself.
            let frame = frame.min(self.frames.saturating_sub(1));
            let keys = K::plain(self.keys)?.get(frame * self.joints..)?.get(..self.joints)?;
            let key: [<Aos<R> as Layout>::Register<Unfused<Portable>>; C] =
                aos::splat(level, *keys.get(joint)?);
            Some(key)
        };
        let (a, b) = (key(frame as usize)?, key(frame as usize + 1)?);
        let pose = law.between(a, b, Lanes::splat(level, t));
        let mut first = [[R::ZERO; 8]];
        Records::store_records(law.motion(pose).to_array(), &mut first);
        let [motion] = first;
        Some(DualQuat::from_array(motion))
    }

    /// The motion of a joint from one time to another, in its frame at the first: pose(from)* · pose(to). Of the root this is
    /// the root motion of a character, which goes on where a [looping](Self::looping) clip begins again: with r rounds between
    /// the times, and the round c = pose(first)* · pose(last), it is pose(from)* · pose(first) · cʳ · pose(first)* · pose(to).
    /// `None` if there is no such joint.
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
        let [a, b] = [self.pose(law, joint, from)?, self.pose(law, joint, to)?];
        let rounds = self.round(to).0 - self.round(from).0;
        if rounds == 0.0 {
            return Some(a.conjugate() * b);
        }
        let whole = Clip { rate: 1.0, loops: false, ..*self };
        let first = whole.pose(law, joint, R::ZERO)?;
        let last = whole.pose(law, joint, <R as Real>::from_f64(self.steps()))?;
        let round = (first.conjugate() * last).pow(<R as Real>::from_f64(rounds));
        Some(a.conjugate() * first * round * (first.conjugate() * b))
    }
}
