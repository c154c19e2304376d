//! [`Sampled`]: animation that is sampled in the pass that uses it.

use super::keys::{Keys, PlacedKeys};
use super::layers::{PoseSource, locals_by_law};
use super::locals::sealed::Sealed;
use super::locals::{Locals, Motions, Numbers, part_of};
use super::rows::{GROUPS, Rows, resized};
use super::slot::JointSlot;
use crate::brief::brief;
use crate::law::Law;
use crate::number::Scalar;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{Element, Layout, Number, Register};
use core::fmt::Debug;
use core::ops::Range;
use dq8_simd::Level;

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

impl<'s, W: Law<C>, P: PlacedKeys<R, C>, R: Scalar, const C: usize> Sampled<'s, W, P, R, C> {
    /// One place and one `t` for each instance. A place is the number of a frame in a
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
    P: PlacedKeys<M::Real, C>,
{
    const MADE: bool = true;

    fn shape(&self, joints: usize) -> Result<(&'static str, usize), ShapeError> {
        same_length("each frame of the clip", self.keys.joints(), joints)?;
        Ok(("frames", joints.saturating_mul(self.t.len().div_ceil(M::THINGS))))
    }
    fn instances(&self) -> Option<usize> {
        Some(self.t.len())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn pose<V: Level>(self, level: V, slot: JointSlot) -> Option<[M::Register<V>; C]> {
        let t = slot.of_instance(level, self.t)?;
        self.keys.pose(level, self.law, slot, t)
    }
    #[inline(never)]
    fn poses<V: Level>(
        &self,
        level: V,
        slot: JointSlot,
        to: &mut [Rows<M::Register<V>>],
    ) -> Option<()> {
        level.run(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || {
                let t: M::Register<V> = slot.of_instance(level, self.t)?;
                self.keys.poses(level, self.law, slot, t, to)
            },
        )
    }
    fn some(self, _: usize, instances: Range<usize>) -> Self {
        let t = part_of(self.t, M::THINGS, instances.clone());
        let first = instances.start.saturating_mul(M::THINGS);
        Self { keys: self.keys.part(first..first.saturating_add(t.len())), t, ..self }
    }
}

locals_by_law!([W, P, const C: usize] Sampled<'_, W, P, Number<E, 8>, C>, C, |poses| poses.law;
    W: Law<C>, P: PlacedKeys<Number<E, 8>, C>);

impl<W, P, R, const C: usize> Sealed for Sampled<'_, W, P, R, C> {}
