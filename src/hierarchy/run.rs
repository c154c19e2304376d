//! [`Run`]: the data that every loop over a hierarchy reads, after lengths have been checked: the
//! [`Root`], when to [`Renormalize`], and the [`Epilogue`] of each model, such as a palette.

use super::slot::JointSlot;
use crate::backend::Backend;
use crate::batch;
use crate::scalar::DualQuat;
use crate::storage::{self, Element, Layout, MatrixOrder, Motions, Number, PaletteEntry, Tile};
use core::num::NonZeroU32;
use core::ops::Range;
use dq8_simd::Level;

/// The fewest elements in a task of a thread: some microseconds of work, where starting a task
/// takes a fraction of one.
const GRAIN: usize = 2048;

/// The instances of a task; there are joints.
pub(super) fn grain(joints: usize) -> usize {
    GRAIN.div_ceil(joints)
}

/// The facts that all loops read: the hierarchy, the range of joints, the base of roots, when
/// models are normalized, and the instructions and threads. Lengths have been checked.
#[derive(Clone, Debug)]
pub(super) struct Run<'a, E: Element<8>> {
    pub(super) backend: Backend,
    pub(super) parents: &'a [u32],
    pub(super) joints: Range<usize>,
    pub(super) root: Root<'a, E>,
    pub(super) renormalize: Renormalize,
}

/// The base that root joints stand on.
#[derive(Clone, Debug)]
pub enum Root<'a, E: Element<8>> {
    /// No base: the local pose of a root is its model pose.
    None,
    /// One motion for all instances.
    Same(DualQuat<Number<E, 8>>),
    /// A motion for each instance, one element for each instance (block).
    Each(&'a [E]),
}

impl<E: Element<8>> Root<'_, E> {
    /// The base of the root of `instance` (block); of as many instances as there are lanes where
    /// elements are single things.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn load<V: Level>(
        &self,
        level: V,
        instance: usize,
        register: usize,
    ) -> Option<Motions<E, V>> {
        match *self {
            Self::None => None,
            Self::Same(root) => Some(batch::DualQuat::splat(level, root)),
            Self::Each(roots) => {
                let tile = Tile::at(instance, register);
                let roots = E::load(level, roots, tile, &storage::identity())?;
                Some(batch::DualQuat::from_array(roots))
            }
        }
    }

    /// The roots of some of the instances (blocks).
    pub(super) fn part(&self, instances: Range<usize>) -> Self {
        match *self {
            Self::Each(roots) => Self::Each(roots.get(instances).unwrap_or_default()),
            _ => self.clone(),
        }
    }
}

impl<E: Element<8>> Run<'_, E> {
    /// The run for some of the instances (blocks).
    pub(super) fn part(&self, instances: Range<usize>) -> Self {
        Self { root: self.root.part(instances), ..self.clone() }
    }

    /// `true` if there is work for more threads than the one that calls.
    #[cfg(feature = "rayon")]
    #[inline]
    pub(super) fn many(&self) -> bool {
        self.backend.many() && !self.parents.is_empty()
    }

    /// The base of the root of one instance, where records are single things.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn root_of(&self, instance: usize) -> Option<[Number<E, 8>; 8]> {
        match self.root {
            Root::None => None,
            Root::Same(root) => Some(root.to_array()),
            Root::Each(roots) => E::plain(roots)?.get(instance).copied(),
        }
    }
}

/// A [`Job`](super::Job) without a base for roots: their local pose is their model pose.
#[derive(Clone, Copy, Debug)]
pub struct NoRoot;

/// The base that root joints stand on, for models of `E`: nothing, one motion for all, or one each.
/// Sealed.
pub trait Roots<E: Element<8>>: sealed::Sealed {
    #[doc(hidden)]
    fn root(&self) -> Root<'_, E>;
    /// The number of roots, where each instance has its own.
    #[doc(hidden)]
    fn count(&self) -> Option<usize> {
        None
    }
}

impl<E: Element<8>> Roots<E> for NoRoot {
    fn root(&self) -> Root<'_, E> {
        Root::None
    }
}

impl<R, E: Element<8, Layout: Layout<Real = R>>> Roots<E> for DualQuat<R>
where
    DualQuat<R>: Copy,
{
    fn root(&self) -> Root<'_, E> {
        Root::Same(*self)
    }
}

impl<E: Element<8>> Roots<E> for &[E] {
    fn root(&self) -> Root<'_, E> {
        Root::Each(self)
    }
    fn count(&self) -> Option<usize> {
        Some(self.len())
    }
}

impl<E: Element<8>> Roots<E> for Root<'_, E> {
    fn root(&self) -> Root<'_, E> {
        self.clone()
    }
    fn count(&self) -> Option<usize> {
        if let Self::Each(roots) = self { Some(roots.len()) } else { None }
    }
}

mod sealed {
    use super::{DualQuat, Element, NoRoot, Root};
    pub trait Sealed {}
    impl Sealed for NoRoot {}
    impl<R> Sealed for DualQuat<R> {}
    impl<E> Sealed for &[E] {}
    impl<E: Element<8>> Sealed for Root<'_, E> {}
}

/// The joints at which a run over a hierarchy normalizes model poses exactly.
///
/// Products of unit motions are unit up to rounding, and rounding adds up: about 10⁻⁷ √n
/// (`f32`) in the norm after n products, less than a skeleton can show. `lab/src/products.rs`
/// measures it; in short:
///
/// - normalizing does **not** make rotations more accurate, it only keeps the norm;
/// - chains of up to thousands of joints do not need it: [`Never`](Self::Never) is the default;
/// - where a product goes on for long (odometry, physics), normalize exactly and rarely:
///   [`Every`](Self::Every) 64 joints is as good as every one;
/// - dividing by the norm of the real part alone does not normalize: it leaves the dual part with a
///   component that is not a translation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Renormalize {
    /// Products only.
    #[default]
    Never,
    /// The model of every n-th joint, counted along the parent array: joints n − 1, 2n − 1, …
    Every(NonZeroU32),
}

impl Renormalize {
    /// `true` if the model of this joint is normalized.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn applies_to(self, joint: usize) -> bool {
        match self {
            Self::Never => false,
            Self::Every(n) => (joint + 1).is_multiple_of(n.get() as usize),
        }
    }
}

/// A computation from a model once it is known, as in the epilogue of a matrix product.
pub(super) trait Epilogue<E: Element<8>>: Sized + Send {
    /// `true` if there is anything to do.
    const ACTIVE: bool;
    fn run<V: Level>(&mut self, level: V, slot: JointSlot, model: Motions<E, V>);
    /// The epilogue of the models before number `at`, and that of the others.
    fn split(self, at: usize) -> (Self, Self);
}

/// The epilogue that computes nothing.
pub(super) struct NoEpilogue;

impl<E: Element<8>> Epilogue<E> for NoEpilogue {
    const ACTIVE: bool = false;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(&mut self, _: V, _: JointSlot, _: Motions<E, V>) {}
    fn split(self, _: usize) -> (Self, Self) {
        (Self, Self)
    }
}

/// model(j) · inverse bind(j), from the mesh in its rest pose to the posed mesh.
pub(super) struct Palette<'s, R, M, const C: usize> {
    pub(super) inverse_binds: &'s [DualQuat<R>],
    pub(super) order: MatrixOrder,
    pub(super) entries: &'s mut [M],
}

impl<E, M, const C: usize> Epilogue<E> for Palette<'_, Number<E, 8>, M, C>
where
    E: Element<8>,
    M: PaletteEntry<C, Layout = E::Layout>,
{
    const ACTIVE: bool = true;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(&mut self, level: V, slot: JointSlot, model: Motions<E, V>) {
        let Some(bind) = slot.of_joint(level, bytemuck::must_cast_slice(self.inverse_binds)) else {
            return;
        };
        slot.prefetch(level, self.entries, E::Layout::records::<V>());
        let (entry, entries) = (model * batch::DualQuat::from_array(bind), &mut *self.entries);
        // *Kept apart* (docs/measured.md): a store of each order, not one for both.
        match self.order {
            MatrixOrder::Rows => {
                M::store(M::of(entry, MatrixOrder::Rows), slot.within(entries), slot.tile());
            }
            MatrixOrder::Columns => {
                M::store(M::of(entry, MatrixOrder::Columns), slot.within(entries), slot.tile());
            }
        }
    }
    fn split(self, at: usize) -> (Self, Self) {
        let (begin, end) = self.entries.split_at_mut(at.min(self.entries.len()));
        let of = |entries| Self { entries, ..self };
        (of(begin), of(end))
    }
}

/// Models to compute, of whole instances, and what the epilogue makes of each.
pub(super) struct Forward<'r, 's, E: Element<8>, L, X> {
    pub(super) run: &'r Run<'r, E>,
    pub(super) locals: L,
    pub(super) models: &'s mut [E],
    pub(super) epilogue: X,
}

/// A palette to compute without its models, which go through `scratch`.
pub(super) struct PaletteOnly<'r, 's, E: Element<8>, L, X> {
    pub(super) run: &'r Run<'r, E>,
    pub(super) locals: L,
    pub(super) instances: usize,
    pub(super) scratch: &'s mut [E],
    pub(super) epilogue: X,
}
