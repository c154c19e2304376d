//! [`Ahead`]: locals that are made for a group of joints at a time.

use super::locals::{Locals, Motions};
use super::rows::{GROUP, Rows, load};
use super::run::Run;
use super::slot::JointSlot;
use crate::batch;
use crate::storage::{Element, Register};
use bytemuck::Zeroable;
use dq8_simd::{Lanes, Level};

/// A group of locals, if they are made ahead.
pub(super) struct Ahead<E: Element<8>, V: Level>(Option<[Rows<Register<E, V, 8>>; GROUP]>);

impl<E: Element<8>, V: Level> Ahead<E, V> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn of<L: Locals<E>>(_: &L) -> Self {
        Self(if L::AHEAD { Some([Zeroable::zeroed(); GROUP]) } else { None })
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
    ) -> Option<Motions<E, V>> {
        let Some(rows) = self.0.as_mut().filter(|_| L::AHEAD) else {
            return locals.load(level, models, slot);
        };
        let step = if slot.is_of_joints() { Register::<E, V, 8>::LANES } else { 1 };
        let at = (slot.joint() - run.joints.start) / step;
        if at.is_multiple_of(GROUP) {
            let all = run.joints.len().div_ceil(step);
            locals.ahead(level, slot, rows.get_mut(..GROUP.min(all - at))?)?;
        }
        Some(batch::DualQuat::from_array(load(level, rows.get(at % GROUP)?)))
    }
}
