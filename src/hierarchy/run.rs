//! [`Run`]: the data that every loop over a hierarchy reads, after lengths have been checked. The
//! data include the [`Root`], onto which root joints are multiplied, and [`Renormalize`], the
//! joints whose models are normalized. The module also has [`Epilogue`], a computation from each
//! model, for instance of a palette; and [`JointSlot`], the joints and instances in the lanes of a
//! register.

use crate::backend::Backend;
use crate::batch::{self, vector};
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::{
    self, Element, Layout, MatrixOrder, Motions, Number, PaletteEntry, Tile, aos, identity,
};
use core::num::NonZeroU32;
use core::ops::Range;
use dq8_simd::{Lanes, Level, Records};

/// The least number of elements in a task of a thread. Computing these elements takes some
/// microseconds, while starting a task takes a fraction of a microsecond.
const GRAIN: usize = 2048;

/// Returns the least number of instances in a task of a thread, for instances of `joints` joints.
/// `joints` must not be 0.
pub(super) fn grain(joints: usize) -> usize {
    GRAIN.div_ceil(joints)
}

/// The data that all loops read: the hierarchy, the range of joints, the base of root joints, the
/// joints whose models are normalized, and the backend (instructions and threads). Lengths have
/// been checked.
#[derive(Clone, Debug)]
pub(super) struct Run<'a, E: Element<8>> {
    pub(super) backend: Backend,
    pub(super) parents: &'a [u32],
    pub(super) joints: Range<usize>,
    pub(super) root: Root<'a, E>,
    pub(super) renormalize: Renormalize,
}

/// The base of root joints: a root j has the model base · local(j).
#[derive(Clone, Debug)]
pub enum Root<'a, E: Element<8>> {
    /// No base: the local pose of a root is its model pose.
    None,
    /// One motion for all instances.
    Same(DualQuat<Number<E, 8>>),
    /// A motion for each instance; the slice has one element for each instance or block of
    /// instances.
    Each(&'a [E]),
}

impl<E: Element<8>> Root<'_, E> {
    /// Loads the base of root joints for the instances in a register. `instance` is the first of
    /// these instances, or in blocks the index of the block.
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

    /// Returns the bases of a range of instances (or blocks).
    pub(super) fn part(&self, instances: Range<usize>) -> Self {
        match *self {
            Self::Each(roots) => Self::Each(roots.get(instances).unwrap_or_default()),
            _ => self.clone(),
        }
    }
}

impl<E: Element<8>> Run<'_, E> {
    /// Returns the run for a range of instances (or blocks).
    pub(super) fn part(&self, instances: Range<usize>) -> Self {
        Self { root: self.root.part(instances), ..self.clone() }
    }

    /// Returns `true` if there is enough work for several threads.
    #[cfg(feature = "rayon")]
    #[inline]
    pub(super) fn many(&self) -> bool {
        self.backend.many() && !self.parents.is_empty()
    }

    /// Returns the base of root joints for one instance in a plain slice.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn root_of(&self, instance: usize) -> Option<[Number<E, 8>; 8]> {
        match self.root {
            Root::None => None,
            Root::Same(root) => Some(root.to_array()),
            Root::Each(roots) => E::plain(roots)?.get(instance).copied(),
        }
    }
}

/// The absence of a base in a [`Job`](super::Job): the local pose of a root joint is its model
/// pose.
#[derive(Clone, Copy, Debug)]
pub struct NoRoot;

/// The base of root joints for models of type `E`: none, one motion for all instances, or one
/// motion for each instance. The trait is sealed.
pub trait Roots<E: Element<8>>: sealed::Sealed {
    #[doc(hidden)]
    fn root(&self) -> Root<'_, E>;
    /// The number of bases if each instance has its own, otherwise `None`.
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

/// The joints whose model poses a run over a hierarchy normalizes.
///
/// Products of unit motions are unit up to rounding errors. After n products these errors add up to
/// about 10⁻⁷ √n in the norm (`f32`). No skeleton is deep enough for this to matter.
/// `lab/src/products.rs` measures it, with these results:
///
/// - normalizing does **not** make rotations more accurate, it only keeps the norm;
/// - chains of up to thousands of joints do not need it: [`Never`](Self::Never) is the default;
/// - for very long products (odometry, physics), normalizing after [`Every`](Self::Every) 64
///   factors is as good as after every factor;
/// - dividing by the norm of the real part alone does not normalize: it leaves the dual part with a
///   component that is not a translation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Renormalize {
    /// No model is normalized.
    #[default]
    Never,
    /// The model of every n-th joint is normalized, counted along the parent array: joints n − 1,
    /// 2n − 1, …
    Every(NonZeroU32),
}

impl Renormalize {
    /// Returns `true` if the model of this joint is normalized.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn applies_to(self, joint: usize) -> bool {
        match self {
            Self::Never => false,
            Self::Every(n) => (joint + 1).is_multiple_of(n.get() as usize),
        }
    }
}

/// A computation for each model, made while the model is in registers, such as the computation of a
/// palette entry.
pub(super) trait Epilogue<E: Element<8>>: Sized + Send {
    /// `true` if the epilogue computes something.
    const ACTIVE: bool;
    fn run<V: Level>(&mut self, level: V, slot: JointSlot, model: Motions<E, V>);
    /// Splits the epilogue: the first half is for the models with an index below `at`, the second
    /// half for all later models.
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

/// Computes palette entries, model(j) · inverse bind(j), which take a vertex of the mesh in its
/// rest pose to the posed mesh.
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
        // Each order has a store of its own, so that the compiler need not move values between
        // registers to reach a common store (*Kept apart*, docs/measured.md).
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

/// A run that computes the models of whole instances, and the epilogue of each model.
pub(super) struct Forward<'r, 's, E: Element<8>, L, X> {
    pub(super) run: &'r Run<'r, E>,
    pub(super) locals: L,
    pub(super) models: &'s mut [E],
    pub(super) epilogue: X,
}

/// A run that computes a palette and keeps no models: `scratch` holds the models of some instances
/// at a time.
pub(super) struct PaletteOnly<'r, 's, E: Element<8>, L, X> {
    pub(super) run: &'r Run<'r, E>,
    pub(super) locals: L,
    pub(super) instances: usize,
    pub(super) scratch: &'s mut [E],
    pub(super) epilogue: X,
}

/// The number of joints that the loop prefetches ahead. For 1,000 skeletons whose palettes exceed
/// the second-level cache, prefetching saves a seventh of the time. If the palettes fit into the
/// cache, it saves almost nothing. A distance of 4 is equally good.
const PREFETCH_DISTANCE: usize = 2;

/// The joints and instances in the lanes of a register: one joint of several instances, or several
/// joints of one instance.
#[derive(Clone, Copy, Debug)]
pub struct JointSlot {
    /// The joint in all lanes if lanes are instances, or the joint in the first lane if lanes are
    /// joints.
    joint: usize,
    /// The index, in the slice of all elements, of joint 0 of the first lane's instance, or of
    /// joint 0 of the block.
    first: usize,
    register: usize,
    /// The instance of the first lane.
    instance: usize,
    /// The distance between neighbouring lanes in elements, if lanes are instances in plain slices.
    stride: Option<usize>,
    /// The end of the range of joints, if lanes are joints of one instance.
    end: Option<usize>,
}

impl JointSlot {
    /// Returns the slot of a joint of the instances in one register of a block. `first` is the
    /// index of the block's joint 0 among all elements, and `instance` the first instance in the
    /// register.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn in_block(joint: usize, first: usize, register: usize, instance: usize) -> Self {
        Self { joint, first, register, instance, stride: None, end: None }
    }

    /// Returns the slot of one joint in as many instances as there are lanes, of which `instance`
    /// is the first. Each instance has `joints` elements.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn of_instances(joint: usize, instance: usize, joints: usize) -> Self {
        let first = instance * joints;
        Self { joint, first, register: 0, instance, stride: Some(joints), end: None }
    }

    /// Returns the slot of several joints of one instance, as many as there are lanes, beginning
    /// with `joint` and ending before `end`. Each instance has `joints` elements.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn of_joints(joint: usize, instance: usize, joints: usize, end: usize) -> Self {
        let first = instance * joints;
        Self { joint, first, register: 0, instance, stride: None, end: Some(end) }
    }

    /// Returns the slot of the same instances that is `slots` slots further on among the joints. A
    /// slot is one joint, or `lanes` joints if the lanes of a register are joints.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn after(self, slots: usize, lanes: usize) -> Self {
        let joints = if self.lanes_are_joints() { slots * lanes } else { slots };
        Self { joint: self.joint + joints, ..self }
    }

    /// Returns the joint of the first lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn joint(self) -> usize {
        self.joint
    }

    /// The instance of the first lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn instance(self) -> usize {
        self.instance
    }

    /// `true` if lanes are joints of one instance.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn lanes_are_joints(self) -> bool {
        self.end.is_some()
    }

    /// Returns the tile of this slot in a slice of the elements of all instances.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn tile(self) -> Tile {
        Tile { element: self.first + self.joint, register: self.register, stride: self.stride }
    }

    /// Returns the tile of this slot in a slice that begins with the slot's first instance or
    /// block.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn own_tile(self) -> Tile {
        Tile { element: self.joint, register: self.register, stride: self.stride }
    }

    /// If lanes are joints, returns the part of `to` before the end of the range of joints.
    /// Otherwise returns all of `to`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn within<E>(self, to: &mut [E]) -> &mut [E] {
        match self.end {
            Some(end) => to.get_mut(..self.first + end).unwrap_or_default(),
            None => to,
        }
    }

    /// If lanes are instances at a stride, prefetches the elements of a later joint in `memory`,
    /// which has the elements of all instances. This is needed because a CPU reads a cache line
    /// before it writes a part of it, and its hardware prefetcher follows only a few streams at
    /// once.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn prefetch<E, V: Level>(self, level: V, memory: &[E], lanes: usize) {
        if let Some(stride) = self.stride
            && let Some(soon) = memory.get(self.first + self.joint + PREFETCH_DISTANCE..)
        {
            level.prefetch_every(soon, stride, lanes);
        }
    }

    /// Prefetches like [`prefetch`](Self::prefetch), in a slice `memory` that begins with this
    /// slot's first instance.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn prefetch_own<E, V: Level>(self, level: V, memory: &[E], lanes: usize) {
        Self { first: 0, ..self }.prefetch(level, memory, lanes);
    }

    /// Loads the record of the joint in each lane from `records`, which has one record for each
    /// joint. All instances share these records.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn of_joint<L: Lanes<Real: Scalar>, const C: usize>(
        self,
        level: L::Level,
        records: &[[L::Real; C]],
    ) -> Option<[L; C]> {
        if self.lanes_are_joints() {
            aos::load(level, records, Tile::at(self.joint, 0), &identity())
        } else {
            Some(vector::splat(level, *records.get(self.joint)?))
        }
    }

    /// Loads the value of the instance in each lane from `numbers`, which has one value for each
    /// instance. Lanes without an instance get the value of the last instance.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn of_instance<L: Lanes<Real: Scalar>>(
        self,
        level: L::Level,
        numbers: &[L::Real],
    ) -> Option<L> {
        let last = *numbers.last()?;
        // All lanes of a register in the last block may lie beyond the last instance. Then `get`
        // returns `None`.
        let numbers = numbers.get(self.instance..).unwrap_or_default();
        if self.end.is_some() {
            return Some(L::splat(level, *numbers.first()?));
        }
        let [numbers] = L::load_records(level, bytemuck::must_cast_slice(numbers), [last]);
        Some(numbers)
    }
}
