//! Palettes of plain instances whose models nobody asks for: the models stay in the caller's
//! scratch as registers hold them. To transpose and store them would be two fifths of what a
//! palette shuffles and stores, and all parents are where they were put, so nothing is loaded
//! again.

use super::locals::{Locals, Motions};
use super::palette::Epilogue;
use super::product::product_in_lanes;
use super::rows::{GROUP, Rows, load, store};
use super::run::Run;
use super::slot::JointSlot;
use crate::backend::Kernel;
use crate::batch;
use crate::storage::{Element, Layout, Number, Register};
use bytemuck::Zeroable;
use dq8_simd::{Lanes, Level};

/// The models of one joint.
type Models<E, V> = Rows<Register<E, V, 8>>;

/// Bytes of a cache line, or more than a register has: rows that begin at a multiple of it lie in
/// one line each.
const LINE: usize = 64;

/// Lanes are instances, strided in memory. Gives back how many instances are done: whole groups,
/// none if the scratch does not hold one.
pub(super) struct Unkept<'r, 's, E: Element<8>, L, X> {
    pub(super) run: &'r Run<'r, E>,
    pub(super) locals: L,
    pub(super) instances: usize,
    pub(super) scratch: &'s mut [E],
    pub(super) epilogue: X,
}

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Kernel for Unkept<'_, '_, E, L, X> {
    type Output = usize;
    // A quarter less time where 512 bits are shuffled as quickly as 256.
    const SHUFFLES: bool = !E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) -> usize {
        let Self { run, locals, instances, scratch, mut epilogue } = self;
        let lanes = E::Layout::records::<V>();
        let rows = E::plain_mut(scratch).and_then(|plain| rows::<E, V>(plain, run.parents.len()));
        // A register of one number has nothing to transpose, and gains nothing.
        let (Some(rows), 2..) = (rows, lanes) else { return 0 };
        let mut done = 0;
        while instances - done >= lanes {
            together(level, run, locals, &mut epilogue, done, rows);
            done += lanes;
        }
        done
    }
}

/// Rows for each joint, if `scratch` holds as many instances as there are lanes; at a cache line if
/// it holds more.
#[cfg_attr(not(opt_level_0), inline(always))]
fn rows<E: Element<8>, V: Level>(
    scratch: &mut [[Number<E, 8>; 8]],
    joints: usize,
) -> Option<&mut [Models<E, V>]> {
    let numbers = scratch.as_flattened_mut();
    let needed = joints.checked_mul(8 * Register::<E, V, 8>::LANES)?;
    let spare = numbers.len().checked_sub(needed)?;
    // A row across two lines costs two accesses. The callers' memory is aligned to a number, so the
    // start is moved, where there is room for that; the results are the same.
    let aligned = numbers.as_ptr().align_offset(LINE);
    let start = if aligned <= spare { aligned } else { 0 };
    bytemuck::try_cast_slice_mut(numbers.get_mut(start..start + needed)?).ok()
}

/// One group; `instance` is its first one. All models go through memory, as in
/// [`super::transposed`]. Locals that are made wait where the models go.
#[cfg_attr(not(opt_level_0), inline(always))]
fn together<E: Element<8>, L: Locals<E>, X: Epilogue<E>, V: Level>(
    level: V,
    run: &Run<'_, E>,
    locals: L,
    epilogue: &mut X,
    instance: usize,
    models: &mut [Models<E, V>],
) {
    let joints = run.joints.clone();
    let slot = |joint| JointSlot::of_instances(joint, instance, run.parents.len());
    // What roots stand on: in memory, as the parents of all others are, so that products have one
    // source.
    let mut base = Models::<E, V>::zeroed();
    let base = if let Some(root) = run.root.load(level, instance, 0) {
        store(root.to_array(), &mut base);
        Some(&base)
    } else {
        None
    };
    if const { L::MADE } {
        let rows = models.get_mut(joints.clone()).unwrap_or_default();
        for (first, rows) in joints.clone().step_by(GROUP).zip(rows.chunks_mut(GROUP)) {
            if locals.ahead(level, slot(first), rows).is_none() {
                return;
            }
        }
    }
    for joint in joints {
        let Some(rows) = models.get(joint) else { return };
        let local = if const { L::MADE } {
            Some(load(level, rows))
        } else {
            locals.load(level, &[], slot(joint))
        };
        let Some(local) = local else { return };
        let local = locals.motion(local).to_array();
        if place(level, run, epilogue, slot(joint), local, base, models).is_none() {
            return;
        }
    }
}

/// The model of a joint, and what follows from it.
#[cfg_attr(not(opt_level_0), inline(always))]
fn place<E: Element<8>, X: Epilogue<E>, V: Level>(
    level: V,
    run: &Run<'_, E>,
    epilogue: &mut X,
    slot: JointSlot,
    local: [Register<E, V, 8>; 8],
    base: Option<&Models<E, V>>,
    models: &mut [Models<E, V>],
) -> Option<()> {
    let joint = slot.joint();
    // ROOT is beyond the last joint: there is no such model.
    let parent = models.get(*run.parents.get(joint)? as usize).or(base);
    // Two stores: where two ways lead to one, registers move.
    if let Some(parent) = parent {
        let model = product_in_lanes(load(level, parent), local);
        store(model, models.get_mut(joint)?);
    } else {
        store(local, models.get_mut(joint)?);
    }
    let place = models.get_mut(joint)?;
    // Loaded again: whether it was normalized or not, the epilogue has one source. It is in the
    // first cache.
    if run.renormalize.applies_to(joint) {
        normalize::<E, V>(level, place);
    }
    epilogue.run(level, slot, batch::DualQuat::from_array(load(level, place)));
    Some(())
}

#[cold]
#[inline(never)]
fn normalize<E: Element<8>, V: Level>(level: V, model: &mut Models<E, V>) {
    level.run(
        #[cfg_attr(not(opt_level_0), inline(always))]
        || {
            let unit = Motions::<E, V>::from_array(load(level, model)).normalize();
            store(unit.to_array(), model);
        },
    );
}
