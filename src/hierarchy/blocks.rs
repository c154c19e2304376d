//! The computation of models from locals, model(j) = model(parent(j)) · local(j), for blocks,
//! whose lanes are instances.

use super::locals::{BATCH, InPlace, LocalBatch, Locals, Pass, Registers};
use super::run::{Epilogue, Forward, JointSlot};
use crate::backend::Kernel;
use crate::storage::{Element, Layout, Register, Tile, motions};
use core::sync::atomic::{Ordering, compiler_fence};
use dq8_simd::{Lanes, Level};

/// `true` on CPUs that execute out of order: they run later instructions while an earlier one waits
/// for its operands. Microcontrollers execute in order, and they have little memory for code.
const OVERLAPS: bool =
    cfg!(not(all(target_os = "none", any(target_arch = "arm", target_arch = "riscv32"))));

/// The number of bytes that the models of two blocks may fill if both blocks are computed in turns.
/// It is at most the size of the first-level cache.
const CACHE: usize = 32 << 10;

/// The number of joints that the loop prefetches ahead. With it, 1024 skeletons of 64 joints,
/// computed in place, take a tenth less time with AVX2, and a twentieth less with AVX-512. One
/// block of 16 lanes, which stays in the first-level cache, takes a twentieth more. A greater
/// distance is not faster, and from 8 joints on it is slower.
const PREFETCH_DISTANCE: usize = 2;

/// The loop over blocks, parents first. Three measures keep it at the speed of its multiplications:
///
/// - A child waits for its parent's product. In this time eight independent products could begin.
///   So two instance blocks, or the registers of one block, are computed in turns: while a product
///   of the first waits for a parent, a product of the second is computed. Two blocks that do not
///   fit into the first-level cache together would evict each other's models, so they are computed
///   one after the other.
/// - Compiler fences keep the turns apart. Without them the compiler interleaves the instructions
///   of two products and spills registers.
/// - The loop prefetches the joint that it computes two steps later.
pub(super) struct Blocks<'r, 's, E: Element<8>, L, X>(pub(super) Forward<'r, 's, E, L, X>);

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Kernel for Blocks<'_, '_, E, L, X> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Forward { run, locals, models, mut epilogue } = self.0;
        let joints = run.parents.len();
        let pass = Pass { level, run, locals };
        let mut batch = pass.batch();
        // If a row of a block fills several registers, these registers are computed in turns, and
        // the loop computes one block at a time.
        let one_at_a_time = E::Layout::registers::<V>() > 1 || joints > CACHE / 2 / size_of::<E>();
        let side_by_side = if OVERLAPS && !one_at_a_time { 2 } else { 1 };
        // `models` holds whole instances, so `joints` is not 0 where there is a model. The compiler
        // does not know this. Without `max(1)`, or with `split_at_mut` without a check, the machine
        // code would contain a path to a panic.
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
    /// Computes `K` instance blocks in turns, each given by its index and its models.
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
            // The parent of a root is `ROOT`. This index is beyond all models, so the load returns
            // `None`.
            let Some(&parent) = run.parents.get(joint) else { return };
            let renormalize = run.renormalize.applies_to(joint);
            for (block, models) in &mut blocks {
                if let Some(soon) = models.get(joint.saturating_add(PREFETCH_DISTANCE)) {
                    level.prefetch(soon);
                }
                for register in 0..E::Layout::registers::<V>() {
                    let slot = slot(joint, *block, register);
                    // The bounds check of this load also tells roots from children, so that the
                    // loop makes one comparison only. Both branches store the model, and the code
                    // after them reads it back (*One source*, docs/measured.md).
                    let parent = Tile::at(parent as usize, register);
                    if let Some(parent) = motions(level, models, parent) {
                        let Some(local) = self.local_of_block(models, slot) else { return };
                        E::store(locals.onto(parent, local).to_array(), models, slot.own_tile());
                    } else {
                        self.root_of_block(*block, models, slot);
                    }
                    // The turn of this register ends here. The fence keeps the compiler from moving
                    // instructions of the next turn before this store.
                    compiler_fence(Ordering::SeqCst);
                    if !renormalize && const { !X::ACTIVE } {
                        continue;
                    }
                    // The model is read back from memory, where both branches have stored it (*One
                    // source*, docs/measured.md). Otherwise the compiler would move values between
                    // registers where the branches join.
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

    /// Computes the model of a joint without a parent. The function is not inlined, because inlined
    /// code would take registers from the loop over children (*Kept apart*, docs/measured.md).
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

    /// Loads the local of a slot. Computed locals have been written to the memory of the models,
    /// and are read from there.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn local_of_block(self, models: &[E], slot: JointSlot) -> Option<Registers<E, V>> {
        if const { L::COMPUTED } {
            InPlace.load(self.level, models, slot)
        } else {
            self.locals.load(self.level, models, slot)
        }
    }
}
