//! [`Ahead`]: locals that are made for a group of joints at a time, and the memory they wait in.

use super::locals::{Locals, Motions};
use super::run::Run;
use super::slot::JointSlot;
use crate::batch;
use crate::storage::{Element, Register};
use bytemuck::Zeroable;
use dq8_simd::{Lanes, Level};

/// The numbers of a pose or a motion, as registers hold them. A pose leaves those behind its own as they are.
pub(super) type Rows<L> = [<L as Lanes>::Array; 8];

/// As many slots as are made at once: enough that a call for each source is little, few enough that all of them stay in the
/// first cache.
pub(super) const GROUP: usize = 16;

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

/// What is made of a slot and of those after it, into rows one after the other.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn each<L: Lanes, const C: usize>(
    slot: JointSlot,
    to: &mut [Rows<L>],
    mut pose: impl FnMut(JointSlot) -> Option<[L; C]>,
) -> Option<()> {
    for (number, rows) in to.iter_mut().enumerate() {
        store(pose(slot.after(number, L::LANES))?, rows);
    }
    Some(())
}

/// The first rows.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn load<L: Lanes, const C: usize>(level: L::Level, from: &Rows<L>) -> [L; C] {
    let mut registers = [L::splat(level, L::Real::default()); C];
    for (register, row) in registers.iter_mut().zip(from) {
        *register = L::load(level, row);
    }
    registers
}

/// To the first rows.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn store<L: Lanes, const C: usize>(registers: [L; C], to: &mut Rows<L>) {
    for (register, row) in registers.into_iter().zip(to) {
        register.store(row);
    }
}
