//! [`Ahead`]: locals that are made for a group of joints at a time.

use super::locals::{Locals, Numbers};
use super::rows::{GROUP, Rows, load};
use super::run::Run;
use super::slot::JointSlot;
use crate::storage::{Element, Register};
use bytemuck::Zeroable;
use dq8_simd::{Lanes, Level};

/// A group of locals, if they are made.
pub(super) struct Ahead<E: Element<8>, V: Level>(Option<[Rows<Register<E, V, 8>>; GROUP]>);

impl<E: Element<8>, V: Level> Ahead<E, V> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn of<L: Locals<E>>(_: &L) -> Self {
        Self(if const { L::MADE } { Some([Zeroable::zeroed(); GROUP]) } else { None })
    }

    /// The local of a slot; the slots of all joints of `run` are asked for one after the other.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn local<L: Locals<E>>(
        &mut self,
        level: V,
        run: &Run<'_, E>,
        locals: &L,
        models: &[E],
        slot: JointSlot,
    ) -> Option<Numbers<E, V>> {
        if const { !L::MADE } {
            return locals.load(level, models, slot);
        }
        let rows = self.0.as_mut()?;
        let step = if slot.is_of_joints() { Register::<E, V, 8>::LANES } else { 1 };
        let at = (slot.joint() - run.joints.start) / step;
        if at.is_multiple_of(GROUP) {
            let all = run.joints.len().div_ceil(step);
            locals.ahead(level, slot, rows.get_mut(..GROUP.min(all - at))?)?;
        }
        Some(load(level, rows.get(at % GROUP)?))
    }

    /// The locals of a slot of a block and of so many joints from it on go where their models will
    /// be.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn place<L: Locals<E>>(
        &mut self,
        level: V,
        locals: &L,
        models: &mut [E],
        slot: JointSlot,
        joints: usize,
    ) -> Option<()> {
        let rows = self.0.as_mut()?.get_mut(..joints)?;
        locals.ahead(level, slot, rows)?;
        for (number, rows) in rows.iter().enumerate() {
            E::copy(level, rows, models, slot.after(number, 1).own_tile());
        }
        Some(())
    }
}
