//! [`Keys`]: where [`Sampled`](super::Sampled) takes its keys from, and [`PlacedKeys`].

use super::locals::sealed::Sealed;
use super::rows::{Rows, each};
use super::slot::JointSlot;
use crate::law::Law;
use crate::storage::shape::ShapeError;
use core::ops::Range;
use dq8_simd::Lanes;

/// Key frames of a skeleton, in numbers of `R`, `C` for each joint: a [`Clip`](super::Clip) or
/// [`PackedClips`](super::PackedClips). Sealed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` are no keys of {C} numbers of `{R}` for each joint",
    note = "packed clips have 7 numbers of `f32` for each joint, a rotation and a translation: the law `NlerpLerp` plays them, in \
            `f32`",
    note = "a `Clip` has 7 for `NlerpLerp`, or 8, a motion, for `Nlerp` and `Sclerp`"
)]
pub trait Keys<'s, R, const C: usize>: Copy + Sealed {
    /// Where an instance is: the number of a frame, or a clip and a frame.
    type Place;
    /// The keys, and places that have been checked.
    #[doc(hidden)]
    type Placed: PlacedKeys<R, C>;
    /// Many places.
    ///
    /// # Errors
    /// If one of them is none of these keys.
    #[doc(hidden)]
    fn placed(self, places: &'s [Self::Place]) -> Result<Self::Placed, ShapeError>;
}

/// Keys with a place for each instance.
#[doc(hidden)]
pub trait PlacedKeys<R, const C: usize>: Copy + Send + Sync {
    /// How many joints there are.
    fn joints(self) -> usize;
    /// The poses of a slot.
    fn pose<L: Lanes<Real = R>, W: Law<C>>(
        self,
        level: L::Level,
        law: W,
        slot: JointSlot,
        t: L,
    ) -> Option<[L; C]>;
    /// The poses of a slot and of those after it, in the first `C` of each rows.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn poses<L: Lanes<Real = R>, W: Law<C>>(
        self,
        level: L::Level,
        law: W,
        slot: JointSlot,
        t: L,
        to: &mut [Rows<L>],
    ) -> Option<()> {
        each(
            slot,
            to,
            #[cfg_attr(not(opt_level_0), inline(always))]
            |slot| self.pose(level, law, slot, t),
        )
    }
    /// Those of some instances.
    #[must_use]
    fn part(self, instances: Range<usize>) -> Self;
}
