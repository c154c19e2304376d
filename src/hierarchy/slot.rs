//! [`JointSlot`]: the joints and instances in the lanes of a register, and their place in memory.

use crate::batch::vector;
use crate::number::Scalar;
use crate::storage::{Tile, aos, identity};
use dq8_simd::{Lanes, Level, Records};

/// The number of joints that are prefetched ahead. For 1,000 skeletons whose palettes exceed the
/// second cache it saves a seventh of the time, in that cache next to nothing; 4 is as good.
const PREFETCH_DISTANCE: usize = 2;

/// The joints and instances in the lanes of a register: one joint of several instances, or several
/// joints of one instance.
#[derive(Clone, Copy, Debug)]
pub struct JointSlot {
    /// The joint, or the first one.
    joint: usize,
    /// The first joint of the instance (of the block, of the first lane) among all elements.
    first: usize,
    register: usize,
    /// The instance of the first lane.
    instance: usize,
    /// The distance of two lanes in elements, where lanes are instances.
    stride: Option<usize>,
    /// The end of the range of joints, where lanes are joints of one instance.
    end: Option<usize>,
}

impl JointSlot {
    /// The slot of a joint of the instances in one register of a block; `first` is the block of
    /// joint 0, `instance` the first in the register.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn in_block(joint: usize, first: usize, register: usize, instance: usize) -> Self {
        Self { joint, first, register, instance, stride: None, end: None }
    }

    /// The slot of a joint of as many instances as there are lanes, `joints` elements apart.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn of_instances(joint: usize, instance: usize, joints: usize) -> Self {
        let first = instance * joints;
        Self { joint, first, register: 0, instance, stride: Some(joints), end: None }
    }

    /// A slot of as many joints of one instance as there are lanes, up to the joint `end`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn of_joints(joint: usize, instance: usize, joints: usize, end: usize) -> Self {
        let first = instance * joints;
        Self { joint, first, register: 0, instance, stride: None, end: Some(end) }
    }

    /// The slot of the same instances that comes `slots` slots later, of so many lanes.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn after(self, slots: usize, lanes: usize) -> Self {
        let joints = if self.lanes_are_joints() { slots * lanes } else { slots };
        Self { joint: self.joint + joints, ..self }
    }

    /// The joint of the first lane.
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

    /// The slot's place among all elements.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn tile(self) -> Tile {
        Tile { element: self.first + self.joint, register: self.register, stride: self.stride }
    }

    /// The slot's place among the elements of its own instances.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn own_tile(self) -> Tile {
        Tile { element: self.joint, register: self.register, stride: self.stride }
    }

    /// The part of `to` up to where this slot may be written.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn within<E>(self, to: &mut [E]) -> &mut [E] {
        match self.end {
            Some(end) => to.get_mut(..self.first + end).unwrap_or_default(),
            None => to,
        }
    }

    /// Prefetches the place of a later joint among all elements of `memory`, where lanes are
    /// strided instances. A CPU reads a cache line before it writes a part of it, and foresees only
    /// a few streams at once.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn prefetch<E, V: Level>(self, level: V, memory: &[E], lanes: usize) {
        if let Some(stride) = self.stride
            && let Some(soon) = memory.get(self.first + self.joint + PREFETCH_DISTANCE..)
        {
            level.prefetch_every(soon, stride, lanes);
        }
    }

    /// [`prefetch`](Self::prefetch) among the elements of its own instances.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn prefetch_own<E, V: Level>(self, level: V, memory: &[E], lanes: usize) {
        Self { first: 0, ..self }.prefetch(level, memory, lanes);
    }

    /// A record for each joint, the same for all instances.
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

    /// A number of each instance; that of the last one in lanes without an instance.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn of_instance<L: Lanes<Real: Scalar>>(
        self,
        level: L::Level,
        numbers: &[L::Real],
    ) -> Option<L> {
        let last = *numbers.last()?;
        // A register of a block may lie beyond the last instance.
        let numbers = numbers.get(self.instance..).unwrap_or_default();
        if self.end.is_some() {
            return Some(L::splat(level, *numbers.first()?));
        }
        let [numbers] = L::load_records(level, bytemuck::must_cast_slice(numbers), [last]);
        Some(numbers)
    }
}
