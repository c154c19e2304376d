//! model(j) = model(parent(j)) · local(j), for blocks: lanes are instances in memory already.

use super::locals::{BATCH, InPlace, LocalBatch, Locals, Pass, Registers};
use super::run::{Epilogue, Forward, JointSlot};
use crate::backend::Kernel;
use crate::storage::{Element, Layout, Register, Tile, motions};
use core::sync::atomic::{Ordering, compiler_fence};
use dq8_simd::{Lanes, Level};

/// `true` if instructions that wait do not keep others from running. Microcontrollers execute one
/// after the other, and have little room for code.
const OVERLAPS: bool =
    cfg!(not(all(target_os = "none", any(target_arch = "arm", target_arch = "riscv32"))));

/// The bytes that instances side by side may fill: the size of the first cache, or less.
const CACHE: usize = 32 << 10;

/// The number of joints that the loop prefetches ahead. It saves 1024 skeletons of 64 joints in
/// place a tenth of the time with AVX2 and a twentieth with AVX-512, and costs one block of 16,
/// which never leaves the first cache, a twentieth. Farther ahead is not faster, and from 8 joints
/// on it is slower.
const PREFETCH_DISTANCE: usize = 2;

/// Parents first. Three things keep this loop at the speed of its multiplications:
///
/// - A child waits for its parent, which takes as long as eight products. So two instances (or the
///   registers of one block) are computed in turns: while one waits, the other multiplies. Two that
///   do not fit the first cache together would push each other's parents out of it: then one at a
///   time.
/// - The turns are kept apart by fences for the compiler: left alone, it mixes two products and
///   runs out of registers.
/// - The next joint but one is fetched from memory meanwhile.
pub(super) struct Blocks<'r, 's, E: Element<8>, L, X>(pub(super) Forward<'r, 's, E, L, X>);

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Kernel for Blocks<'_, '_, E, L, X> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Forward { run, locals, models, mut epilogue } = self.0;
        let joints = run.parents.len();
        let pass = Pass { level, run, locals };
        let mut batch = pass.batch();
        // Registers of one block are side by side already.
        let one_at_a_time = E::Layout::registers::<V>() > 1 || joints > CACHE / 2 / size_of::<E>();
        let side_by_side = if OVERLAPS && !one_at_a_time { 2 } else { 1 };
        // There are joints where there is anything to do, and no part of an instance. The compiler
        // does not know: `chunks_mut(0)` or a plain `split_at_mut` would be a path to a panic in
        // the machine code.
        let sets = models.chunks_mut(joints.saturating_mul(side_by_side).max(1));
        for (first, models) in (0..).step_by(side_by_side).zip(sets) {
            let Some((a, b)) = models.split_at_mut_checked(joints) else { return };
            if side_by_side == 1 || b.is_empty() {
                pass.blocks([(first, a)], &mut batch, &mut epilogue);
            } else {
                pass.blocks([(first, a), (first + 1, b)], &mut batch, &mut epilogue);
            }
        }
    }
}

impl<E: Element<8>, L: Locals<E>, V: Level> Pass<'_, E, L, V> {
    /// `K` blocks of instances, each by its number and with its models, in turns.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn blocks<X: Epilogue<E>, const K: usize>(
        self,
        mut blocks: [(usize, &mut [E]); K],
        batch: &mut LocalBatch<E, V>,
        epilogue: &mut X,
    ) {
        let Self { level, run, locals } = self;
        let lanes = Register::<E, V, 8>::LANES;
        let slot = |joint, block, register| {
            let first = block * E::Layout::THINGS + register * lanes;
            JointSlot::in_block(joint, block * run.parents.len(), register, first)
        };
        for joint in run.joints.clone() {
            if const { L::COMPUTED } && (joint - run.joints.start).is_multiple_of(BATCH) {
                for (block, models) in &mut blocks {
                    for register in 0..E::Layout::registers::<V>() {
                        if self.place(batch, models, slot(joint, *block, register)).is_none() {
                            return;
                        }
                    }
                }
            }
            // ROOT is beyond the last joint: there is no such model.
            let Some(&parent) = run.parents.get(joint) else { return };
            let renormalize = run.renormalize.applies_to(joint);
            for (block, models) in &mut blocks {
                if let Some(soon) = models.get(joint.saturating_add(PREFETCH_DISTANCE)) {
                    level.prefetch(soon);
                }
                for register in 0..E::Layout::registers::<V>() {
                    let slot = slot(joint, *block, register);
                    // One comparison, the bounds check of this load, also tells roots from
                    // children. *One source*: the model goes to memory on both ways.
                    let parent = Tile::at(parent as usize, register);
                    if let Some(parent) = motions(level, models, parent) {
                        let Some(local) = self.local_of_block(models, slot) else { return };
                        E::store(locals.onto(parent, local).to_array(), models, slot.own_tile());
                    } else {
                        self.root_of_block(*block, models, slot);
                    }
                    // The turn of this register ends: nothing of the next one may be begun before
                    // its store.
                    compiler_fence(Ordering::SeqCst);
                    if !renormalize && const { !X::ACTIVE } {
                        continue;
                    }
                    // *One source*: read back, from the first cache.
                    let Some(mut model) = motions(level, models, slot.own_tile()) else { return };
                    if renormalize {
                        model = model.normalize();
                        E::store(model.to_array(), models, slot.own_tile());
                    }
                    if const { X::ACTIVE } {
                        epilogue.run(level, slot, model);
                    }
                }
            }
        }
    }

    /// The model of a joint without a parent. *Kept apart*: inlined, it would take registers from
    /// the children.
    #[cold]
    #[inline(never)]
    fn root_of_block(self, block: usize, models: &mut [E], slot: JointSlot) {
        self.level.run(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || {
                let Some(local) = self.local_of_block(models, slot) else { return };
                let local = self.locals.motion(local);
                let register = slot.own_tile().register;
                let model = match self.run.root.load(self.level, block, register) {
                    Some(root) => root * local,
                    None => local,
                };
                E::store(model.to_array(), models, slot.own_tile());
            },
        );
    }

    /// The local of a slot. Computed locals lie where their models will.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn local_of_block(self, models: &[E], slot: JointSlot) -> Option<Registers<E, V>> {
        if const { L::COMPUTED } {
            InPlace.load(self.level, models, slot)
        } else {
            self.locals.load(self.level, models, slot)
        }
    }
}
