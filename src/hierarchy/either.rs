//! [`Either`]: locals of one of two forms.

use super::layers::{PoseSource, locals_by_law};
use super::locals::sealed::Sealed;
use super::locals::{Locals, Motions, Numbers};
use super::rows::{GROUPS, Rows, resized};
use super::slot::JointSlot;
use crate::law::{Law, NlerpLerp};
use crate::storage::shape::ShapeError;
use crate::storage::{Element, Layout, Register};
use core::ops::Range;
use dq8_simd::Level;

/// Rotations and translations of one of two forms, which only the running program knows: a plain
/// clip or a [packed](super::PackedClips) one, one clip or [layers](super::Layered). Forms nest. A
/// kernel is compiled once for all of them, and so is each source of poses; but in firmware both
/// are part of it.
///
/// ```
/// use dq8::hierarchy::{Either, RotationsTranslations, Tracks};
/// use dq8::{DualQuat, Hierarchy, Quat};
/// let parents = [Hierarchy::ROOT, 0];
/// let arm = Hierarchy::new(&parents)?;
/// let turn = Quat::from_rotation_z(core::f32::consts::FRAC_PI_2);
/// let (rotations, translations) = ([turn; 2], [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
/// let together = [[0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0]; 2];
/// let mut models = [DualQuat::IDENTITY; 2];
/// for (apart, x) in [(true, 0.0_f32), (false, 2.0)] {
///     let locals = if apart {
///         Either::One(Tracks { rotations: &rotations, translations: &translations })
///     } else {
///         Either::Other(RotationsTranslations(&together))
///     };
///     arm.job().locals_to_model(locals, &mut models)?;
///     assert!((models[1].translation()[0] - x).abs() < 1e-6);
/// }
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub enum Either<A, B> {
    /// Of one form.
    One(A),
    /// Of the other.
    Other(B),
}

/// What both forms have.
macro_rules! of {
    ($either:ident, $locals:ident => $made:expr) => {
        match $either {
            Self::One($locals) => $made,
            Self::Other($locals) => $made,
        }
    };
}

impl<M, A, B, const C: usize> PoseSource<M, C> for Either<A, B>
where
    M: Layout,
    A: PoseSource<M, C>,
    B: PoseSource<M, C>,
{
    const MADE: bool = true;

    fn shape(&self, joints: usize) -> Result<(&'static str, usize), ShapeError> {
        of!(self, locals => locals.shape(joints))
    }
    fn instances(&self) -> Option<usize> {
        of!(self, locals => locals.instances())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn pose<V: Level>(self, level: V, slot: JointSlot) -> Option<[M::Register<V>; C]> {
        of!(self, locals => locals.pose(level, slot))
    }
    fn poses<V: Level>(
        &self,
        level: V,
        slot: JointSlot,
        to: &mut [Rows<M::Register<V>>],
    ) -> Option<()> {
        of!(self, locals => locals.poses(level, slot, to))
    }
    fn some(self, joints: usize, instances: Range<usize>) -> Self {
        match self {
            Self::One(locals) => Self::One(locals.some(joints, instances)),
            Self::Other(locals) => Self::Other(locals.some(joints, instances)),
        }
    }
}

locals_by_law!([A, B] Either<A, B>, 7, |_poses| NlerpLerp;
    A: PoseSource<E::Layout, 7>, B: PoseSource<E::Layout, 7>);

impl<A, B> Sealed for Either<A, B> {}
