//! [`Rows`]: poses and motions of lanes that wait in memory, a group of joints at a time.

use super::slot::JointSlot;
use dq8_simd::Lanes;

/// The numbers of a pose or a motion, as registers hold them. A pose leaves those behind its own as
/// they are.
pub(super) type Rows<L> = [<L as Lanes>::Array; 8];

/// As many slots as are made at once: enough that a call for each source is little, few enough that
/// all of them stay in the first cache.
pub(super) const GROUP: usize = 16;

/// Whether what is computed is made a group at a time. Firmware counts the bytes of its code and
/// stack.
pub(super) const GROUPS: bool = cfg!(not(target_os = "none"));

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
    for (register, row) in registers.iter().zip(to) {
        register.store(row);
    }
}

/// The first numbers of an array as one of another length; where there are more, they are the first
/// one, and nobody reads them.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn resized<L: Lanes, const A: usize, const B: usize>(from: [L; A]) -> [L; B] {
    // No closure: in an inlined kernel it would be compiled without its instructions.
    let mut to = [from[0]; B];
    for (to, &from) in to.iter_mut().zip(&from) {
        *to = from;
    }
    to
}
