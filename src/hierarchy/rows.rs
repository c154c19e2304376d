//! [`Rows`]: poses and motions of lanes that wait in memory, a group of joints at a time.

use super::slot::JointSlot;
use dq8_simd::Lanes;

/// The numbers of a pose or a motion, as registers hold them. A pose leaves those behind its own as they are.
pub(super) type Rows<L> = [<L as Lanes>::Array; 8];

/// As many slots as are made at once: enough that a call for each source is little, few enough that all of them stay in the
/// first cache.
pub(super) const GROUP: usize = 16;

/// Whether what is computed is made a group at a time. Firmware counts the bytes of its code and stack.
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
    for (register, row) in registers.into_iter().zip(to) {
        register.store(row);
    }
}

/// A pose of `C` numbers as eight, of which the last are not read.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn padded<L: Lanes, const C: usize>(pose: [L; C]) -> [L; 8] {
    // No closures: in an inlined kernel they would be compiled without its instructions.
    let mut numbers = [pose[0]; 8];
    for (number, &of_pose) in numbers.iter_mut().zip(&pose) {
        *number = of_pose;
    }
    numbers
}

/// The pose of [`padded`] numbers.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn unpadded<L: Lanes, const C: usize>(numbers: [L; 8]) -> [L; C] {
    let mut pose = [numbers[0]; C];
    for (of_pose, &number) in pose.iter_mut().zip(&numbers) {
        *of_pose = number;
    }
    pose
}
