//! [`PoseSource`]: local poses of joints, which are stored or computed. Sources can be nested:
//! [`Layered`] blends the poses of two sources, and [`Either`] holds one of two types of sources.

use super::locals::sealed::Sealed;
use super::locals::{
    BATCH, BATCHES, Locals, Poses, Registers, RotationsTranslations, Stored, Tracks, each, load,
    part_of, resized, store,
};
use super::run::JointSlot;
use crate::law::{Law, NlerpLerp};
use crate::macros::brief;
use crate::number::Scalar;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Layout, Motions, Number, Register};
use bytemuck::Zeroable;
use core::fmt::Debug;
use core::ops::Range;
use dq8_simd::{Lanes, Level};

/// Poses of whole instances with `C` components each, which are loaded into registers of the layout
/// `M`. They are stored ([`Poses`], [`RotationsTranslations`], [`Tracks`]), sampled from a clip
/// ([`Sampled`](super::Sampled)), or [`Layered`]. The trait is sealed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` are no poses of {C} numbers each",
    note = "layers have the numbers of their law, and poses of 7 numbers and of 8 do not mix: 7, a rotation and a translation, are \
            `RotationsTranslations`, `Tracks` and samples of packed clips, by the law `NlerpLerp`; 8, a motion, are `Poses` \
            and samples of motions, by `Nlerp` or `Sclerp`",
    note = "all are of one precision, and lie in the layout of the models: plain slices, or blocks"
)]
pub trait PoseSource<M: Layout, const C: usize>: Copy + Send + Sync + Sealed {
    /// Returns the name of the poses for error texts, and the number of elements (plain records or
    /// blocks) that they fill.
    ///
    /// # Errors
    /// If the poses do not fit a skeleton of `joints` joints, or the parts of the source do not fit
    /// each other.
    #[doc(hidden)]
    fn shape(&self, joints: usize) -> Result<(&'static str, usize), ShapeError>;
    /// Returns the number of instances, or `None` if the source does not know it. A slice of
    /// blocks, for example, does not tell how many lanes of its last block hold an instance.
    #[doc(hidden)]
    fn instances(&self) -> Option<usize> {
        None
    }
    /// `true` if the poses are computed; `false` if they are loaded as they are stored.
    #[doc(hidden)]
    const COMPUTED: bool;
    /// Loads or computes the poses of a slot.
    #[doc(hidden)]
    fn load<V: Level>(self, level: V, slot: JointSlot) -> Option<[M::Register<V>; C]>;
    /// Loads or computes the poses of a slot and of the slots after it into `to`, which has an
    /// element for each slot. A pose fills the first `C` rows of its element. The function is not
    /// inlined, so that it can use all registers.
    #[doc(hidden)]
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
                each(
                    slot,
                    to,
                    #[cfg_attr(not(opt_level_0), inline(always))]
                    |slot| self.load(level, slot),
                )
            },
        )
    }
    /// Returns the poses of a range of instances (or blocks); an instance has `joints` elements.
    #[doc(hidden)]
    #[must_use]
    fn part(self, joints: usize, instances: Range<usize>) -> Self;
}

/// Implements [`Locals`] for a source of poses. Its [`Law`] converts each pose to a motion, or
/// multiplies the pose onto the model of the parent.
macro_rules! locals_by_law {
    ([$($generics:tt)*] $Poses:ty, $C:tt, |$poses:ident| $law:expr; $($bounds:tt)*) => {
        impl<E: Element<8>, $($generics)*> Locals<E> for $Poses
        where
            $($bounds)*
        {
            const COMPUTED: bool = BATCHES && <Self as PoseSource<E::Layout, $C>>::COMPUTED;

            fn shape(&self, joints: usize, _: usize) -> Result<(&'static str, usize), ShapeError> {
                PoseSource::<E::Layout, $C>::shape(self, joints)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn load<V: Level>(self, level: V, _: &[E], slot: JointSlot) -> Option<Registers<E, V>> {
                Some(resized(PoseSource::<E::Layout, $C>::load(self, level, slot)?))
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn load_batch<V: Level>(
                &self,
                level: V,
                slot: JointSlot,
                to: &mut [Stored<Register<E, V, 8>>],
            ) -> Option<()> {
                PoseSource::<E::Layout, $C>::load_batch(self, level, slot, to)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn motion<V: Level>(self, local: Registers<E, V>) -> Motions<E, V> {
                let $poses = self;
                $law.motion(resized(local))
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn onto<V: Level>(self, parent: Motions<E, V>, local: Registers<E, V>) -> Motions<E, V> {
                let $poses = self;
                $law.onto(parent, resized(local))
            }
            fn part(self, joints: usize, instances: Range<usize>) -> Self {
                PoseSource::<E::Layout, $C>::part(self, joints, instances)
            }
        }
    };
}
pub(super) use locals_by_law;

locals_by_law!([T] RotationsTranslations<'_, T>, 7, |_poses| NlerpLerp; T: Element<7, Layout = E::Layout>);
locals_by_law!([Q, T] Tracks<'_, Q, T>, 7, |_poses| NlerpLerp;
    Q: Element<4, Layout = E::Layout>, T: Element<3, Layout = E::Layout>);

impl<E: Element<8>> PoseSource<E::Layout, 8> for Poses<'_, E> {
    const COMPUTED: bool = false;

    fn shape(&self, _: usize) -> Result<(&'static str, usize), ShapeError> {
        Ok(("locals", self.0.len()))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(self, level: V, slot: JointSlot) -> Option<[Register<E, V, 8>; 8]> {
        E::load(level, self.0, slot.tile(), &storage::identity())
    }
    fn part(self, joints: usize, instances: Range<usize>) -> Self {
        Self(part_of(self.0, joints, instances))
    }
}

impl<E: Element<7>> PoseSource<E::Layout, 7> for RotationsTranslations<'_, E> {
    const COMPUTED: bool = false;

    fn shape(&self, _: usize) -> Result<(&'static str, usize), ShapeError> {
        Ok(("locals", self.0.len()))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(self, level: V, slot: JointSlot) -> Option<[Register<E, V, 7>; 7]> {
        E::load(level, self.0, slot.tile(), &storage::identity())
    }
    fn part(self, joints: usize, instances: Range<usize>) -> Self {
        Self(part_of(self.0, joints, instances))
    }
}

impl<Q: Element<4>, T: Element<3, Layout = Q::Layout>> PoseSource<Q::Layout, 7>
    for Tracks<'_, Q, T>
{
    const COMPUTED: bool = false;

    fn shape(&self, _: usize) -> Result<(&'static str, usize), ShapeError> {
        same_length("translations", self.translations.len(), self.rotations.len())?;
        Ok(("rotations", self.rotations.len()))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(self, level: V, slot: JointSlot) -> Option<[Register<Q, V, 4>; 7]> {
        let [x, y, z, w] = Q::load(level, self.rotations, slot.tile(), &storage::identity())?;
        let [a, b, c] = T::load(level, self.translations, slot.tile(), &storage::identity())?;
        Some([x, y, z, w, a, b, c])
    }
    fn part(self, joints: usize, instances: Range<usize>) -> Self {
        Self {
            rotations: part_of(self.rotations, joints, instances.clone()),
            translations: part_of(self.translations, joints, instances),
        }
    }
}

/// Poses of a source `base`, over which the poses of a second source `layer` are blended, or to
/// which they are added. Each instance has a weight, and an optional mask multiplies it by a factor
/// for each joint. `W` is the [`Law`], `A` and `B` are the types of the two sources, and `ADDS` is
/// `true` if the layer is added.
///
/// In debug builds each nested layer needs [stack](crate::guide::firmware#stack).
///
/// ```
/// use dq8::hierarchy::Layered;
/// use dq8::{DualQuat, Hierarchy, hierarchy::Poses, law::Nlerp};
/// let parents = [Hierarchy::ROOT, 0];
/// let arm = Hierarchy::new(&parents)?;
/// let at = |x| DualQuat::from_translation([x, 0.0_f32, 0.0]);
/// let (rest, reach) = ([at(1.0), at(1.0)], [at(5.0), at(3.0)]);
/// // Half of the way to `reach`, but for joint 0, which the mask leaves alone.
/// let layer = Layered::blend(Nlerp, Poses(&rest), Poses(&reach), &[0.5]).mask(&[0.0, 1.0]);
/// let mut models = rest;
/// arm.job().locals_to_model(layer, &mut models)?;
/// assert_eq!(models[1].translation(), [3.0, 0.0, 0.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
#[must_use]
#[doc(alias("BlendingJob", "additive"))]
pub struct Layered<'w, W, A, B, R, const C: usize, const ADDS: bool> {
    law: W,
    base: A,
    layer: B,
    weights: &'w [R],
    mask: Option<&'w [R]>,
}

brief!([W: Debug, A: Debug, B: Debug, R, const C: usize, const ADDS: bool] Layered<'_, W, A, B, R, C, ADDS>: Layered |it| {
    law: it.law, base: it.base, layer: it.layer, adds: ADDS, instances: it.weights.len(), masked: it.mask.is_some(),
});

impl<'w, W: Law<C>, A, B, R: Scalar, const C: usize> Layered<'w, W, A, B, R, C, false> {
    /// Makes a blend from the poses of `base` (weight 0) to the poses of `layer` (weight 1);
    /// `weights` has one weight for each instance.
    pub fn blend(law: W, base: A, layer: B, weights: &'w [R]) -> Self {
        Self { law, base, layer, weights, mask: None }
    }
}

impl<'w, W: Law<C>, A, B, R: Scalar, const C: usize> Layered<'w, W, A, B, R, C, true> {
    /// Adds `layer`, a source of differences of poses, to `base` by the [`Law`]. The difference is
    /// scaled by the weight of the instance; `weights` has one weight for each instance.
    pub fn add(law: W, base: A, layer: B, weights: &'w [R]) -> Self {
        Self { law, base, layer, weights, mask: None }
    }
}

impl<'w, W, A, B, R, const C: usize, const ADDS: bool> Layered<'w, W, A, B, R, C, ADDS> {
    /// Sets a mask: one factor for each joint, which multiplies the weights.
    pub fn mask(self, mask: &'w [R]) -> Self {
        Self { mask: Some(mask), ..self }
    }

    /// Computes the weight of each lane of a slot: the weight of the lane's instance times the mask
    /// of its joint.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn weight<L: Lanes<Real = R>>(&self, level: L::Level, slot: JointSlot) -> Option<L>
    where
        R: Scalar,
    {
        let weight: L = slot.of_instance(level, self.weights)?;
        let Some(mask) = self.mask else { return Some(weight) };
        let [factor] = slot.of_joint(level, bytemuck::must_cast_slice(mask))?;
        Some(weight * factor)
    }

    /// Blends the poses of the layer over the poses of the base, or adds them.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn over<L: Lanes>(&self, base: [L; C], layer: [L; C], weight: L) -> [L; C]
    where
        W: Law<C>,
    {
        if const { ADDS } {
            self.law.add(base, layer, weight)
        } else {
            self.law.between(base, layer, weight)
        }
    }
}

impl<M, W, A, B, const C: usize, const ADDS: bool> PoseSource<M, C>
    for Layered<'_, W, A, B, M::Real, C, ADDS>
where
    M: Layout,
    W: Law<C>,
    A: PoseSource<M, C>,
    B: PoseSource<M, C>,
{
    const COMPUTED: bool = true;

    fn shape(&self, joints: usize) -> Result<(&'static str, usize), ShapeError> {
        let (what, length) = self.base.shape(joints)?;
        same_length("layer", self.layer.shape(joints)?.1, length)?;
        if let Some(mask) = self.mask {
            same_length("mask", mask.len(), joints)?;
        }
        // There may be fewer weights than all blocks together have lanes, because some lanes of the
        // last block may hold no instance.
        let blocks = length.checked_div(joints).unwrap_or(0);
        if self.weights.len().div_ceil(M::THINGS) != blocks {
            same_length("weights", self.weights.len(), blocks.saturating_mul(M::THINGS))?;
        }
        for instances in [self.base.instances(), self.layer.instances()].into_iter().flatten() {
            same_length("weights", self.weights.len(), instances)?;
        }
        Ok((what, length))
    }
    fn instances(&self) -> Option<usize> {
        Some(self.weights.len())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(self, level: V, slot: JointSlot) -> Option<[M::Register<V>; C]> {
        let weight = self.weight(level, slot)?;
        Some(self.over(self.base.load(level, slot)?, self.layer.load(level, slot)?, weight))
    }
    #[inline(never)]
    fn load_batch<V: Level>(
        &self,
        level: V,
        slot: JointSlot,
        to: &mut [Stored<M::Register<V>>],
    ) -> Option<()> {
        let mut layers = [Stored::<M::Register<V>>::zeroed(); BATCH];
        let layers = layers.get_mut(..to.len())?;
        self.base.load_batch(level, slot, to)?;
        self.layer.load_batch(level, slot, layers)?;
        level.run(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || {
                let lanes = M::Register::<V>::LANES;
                for (number, (base, layer)) in to.iter_mut().zip(layers).enumerate() {
                    let weight: M::Register<V> = self.weight(level, slot.after(number, lanes))?;
                    store(self.over(load(level, base), load(level, layer), weight), base);
                }
                Some(())
            },
        )
    }
    fn part(self, joints: usize, instances: Range<usize>) -> Self {
        Self {
            base: self.base.part(joints, instances.clone()),
            layer: self.layer.part(joints, instances.clone()),
            weights: part_of(self.weights, M::THINGS, instances),
            ..self
        }
    }
}

locals_by_law!([W, A, B, const C: usize, const ADDS: bool] Layered<'_, W, A, B, Number<E, 8>, C, ADDS>, C, |poses| poses.law;
    W: Law<C>, A: PoseSource<E::Layout, C>, B: PoseSource<E::Layout, C>);

impl<W, A, B, R, const C: usize, const ADDS: bool> Sealed for Layered<'_, W, A, B, R, C, ADDS> {}

/// Rotations and translations from a source of one of two types, chosen at run time: for instance a
/// plain clip or a [packed](super::PackedClips) clip, or a clip or [layers](super::Layered). The
/// types may be `Either` again. The kernel is compiled once for both types, and calls a function
/// that computes the poses of the chosen source. In firmware the code of both sources is inlined
/// into the kernel.
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
    /// Locals of the first type.
    One(A),
    /// Locals of the second type.
    Other(B),
}

/// Evaluates the expression `$made` with `$locals` bound to the locals that `$either` holds.
macro_rules! match_either {
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
    const COMPUTED: bool = true;

    fn shape(&self, joints: usize) -> Result<(&'static str, usize), ShapeError> {
        match_either!(self, locals => locals.shape(joints))
    }
    fn instances(&self) -> Option<usize> {
        match_either!(self, locals => locals.instances())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(self, level: V, slot: JointSlot) -> Option<[M::Register<V>; C]> {
        match_either!(self, locals => locals.load(level, slot))
    }
    fn load_batch<V: Level>(
        &self,
        level: V,
        slot: JointSlot,
        to: &mut [Stored<M::Register<V>>],
    ) -> Option<()> {
        match_either!(self, locals => locals.load_batch(level, slot, to))
    }
    fn part(self, joints: usize, instances: Range<usize>) -> Self {
        match self {
            Self::One(locals) => Self::One(locals.part(joints, instances)),
            Self::Other(locals) => Self::Other(locals.part(joints, instances)),
        }
    }
}

locals_by_law!([A, B] Either<A, B>, 7, |_poses| NlerpLerp;
    A: PoseSource<E::Layout, 7>, B: PoseSource<E::Layout, 7>);

impl<A, B> Sealed for Either<A, B> {}
