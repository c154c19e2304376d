//! model(j) = model(parent(j)) · local(j), for plain motions, which are transposed in registers.
//!
//! # The algorithm
//!
//! Take as many instances as there are lanes. For each joint, parents first: load its local pose of
//! all these instances, a transpose; take the models of its parent, multiply; store the product,
//! another transpose. Instances that are left over, and single ones, go one by one, with a motion
//! of eight numbers in one register.
//!
//! # Why it is as it is
//!
//! - *A ring of recent models.* A parent is needed as it was in registers, and transposing it a
//!   second time would cost as much as the product. Most parents are a few joints back, so the last
//!   [`RECENT`] models stay in memory as the registers held them; only a parent that lies farther
//!   back is transposed again, out of line.
//! - *One source for every product.* Roots, near parents and far ones all end as a place in the
//!   ring. Where two ways lead to a value, the compiler moves eight registers on both.
//! - *Same operations in the same order, together and one by one*: the model of an instance is the
//!   same to the last bit, however many others are in the call.
//! - *Prefetch before a strided store*, once models exceed the second cache: the CPU does not
//!   foresee so many places.

use super::chain::{product, product_in_lanes};
use super::locals::{Ahead, GROUP, Locals, Rows, load, store};
use super::run::{Epilogue, Run};
use super::slot::JointSlot;
use crate::backend::{Backend, Kernel};
use crate::batch;
use crate::number::Scalar;
use crate::storage::{Element, Layout, Number, Register, Source, Tile, identity};
use crate::storage::{Motions, motions};
use bytemuck::Zeroable;
use dq8_simd::{Lanes, Level, MAX_LANES, Portable};

/// So many models are kept as they are in registers, for their children. What lies farther back is
/// transposed again. More would fill the first cache, which the instances share.
const RECENT: usize = 16;

/// The recent models, and a place behind them.
type Recent<E, V> = [[Register<E, V, 8>; 8]; RECENT + 1];

/// Whether many instances in plain slices are worth a loop of their own. Firmware has few, and
/// counts the bytes of code and stack.
pub(super) const MANY: bool = cfg!(not(target_os = "none"));

/// More bytes of models than the second cache holds are asked for before they are written, which
/// saves a tenth of the time of models and a sixth of that of palettes with models. Fewer would
/// take a twentieth longer, and models over their locals gain nothing.
const NEAR: usize = 1 << 20;

/// Writes the models of all instances.
#[inline]
pub(super) fn forward<E: Element<8>, L: Locals<E>, X: Epilogue<E>>(
    backend: Backend,
    run: &Run<'_, E>,
    locals: L,
    models: &mut [E],
    epilogue: &mut X,
) {
    // Where a register holds one number, one instance fills it.
    let mut done = 0;
    if const { Register::<E, Portable, 8>::LANES == 1 }
        || (const { MANY } && models.len() > run.parents.len())
    {
        done = backend.run(Instances { run, locals, models, epilogue });
    }
    if const { Register::<E, Portable, 8>::LANES > 1 } && done < models.len() {
        backend.run(Walk { run, locals, models, epilogue, done });
    }
}

/// Lanes are instances, strided in memory. Gives back how many elements are done: whole groups.
struct Instances<'r, 's, E: Element<8>, L, X> {
    run: &'r Run<'r, E>,
    locals: L,
    models: &'s mut [E],
    epilogue: &'s mut X,
}

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Kernel for Instances<'_, '_, E, L, X> {
    type Output = usize;
    const WIDE: bool = E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) -> usize {
        let Self { run, locals, models, epilogue } = self;
        let joints = run.parents.len();
        let group = E::Layout::records::<V>().saturating_mul(joints);
        let (mut done, mut instance) = (0, 0);
        // Models as registers hold them; the last one is for parents that are not among them.
        let mut recent = [Motions::<E, V>::identity(level).to_array(); RECENT + 1];
        let mut ahead = Ahead::of(&locals);
        let beyond =
            size_of_val(models) > NEAR && !matches!(locals.motions(), Some(Source::Output));
        if group > 0 {
            for models in models.chunks_exact_mut(group) {
                if E::Layout::records::<V>() > 1 {
                    let group = Group { instance, beyond };
                    together(
                        level,
                        run,
                        locals,
                        models,
                        epilogue,
                        group,
                        (&mut recent, &mut ahead),
                    );
                } else {
                    alone(level, run, locals, models, epilogue, instance, &mut ahead);
                }
                done += group;
                instance += E::Layout::records::<V>();
            }
        }
        done
    }
}

/// So many instances as there are lanes.
#[derive(Clone, Copy)]
struct Group {
    /// The first.
    instance: usize,
    /// Whether all models are more than [`NEAR`].
    beyond: bool,
}

/// One group.
///
/// All models go through memory that the first cache holds, not from register to register: where
/// two ways lead to a value (a parent that is recent or not, a joint that is a root or not), the
/// compiler would move eight registers.
#[cfg_attr(not(opt_level_0), inline(always))]
fn together<E: Element<8>, L: Locals<E>, X: Epilogue<E>, V: Level>(
    level: V,
    run: &Run<'_, E>,
    locals: L,
    models: &mut [E],
    epilogue: &mut X,
    Group { instance, beyond }: Group,
    (recent, ahead): (&mut Recent<E, V>, &mut Ahead<E, V>),
) {
    // In registers: what is stored might be what `run` refers to, for all that the compiler knows.
    let (parents, joints) = (run.parents, run.parents.len());
    for joint in run.joints.clone() {
        let Some(&parent) = parents.get(joint) else { return };
        let (slot, parent) = (JointSlot::of_instances(joint, instance, joints), parent as usize);
        if beyond {
            slot.prefetch_own(level, models, E::Layout::records::<V>());
        }
        if parent < joint {
            // The ring: the model of joint j is at j % RECENT until joint j + RECENT takes its
            // place. A parent that is gone, or lies before the range and never was there, is loaded
            // into the slot behind the ring. So the product has one source, memory at an index,
            // whatever happened before it.
            let mut from = parent % RECENT;
            if joint - parent >= RECENT || parent < run.joints.start {
                from = RECENT;
                far(level, models, JointSlot::of_instances(parent, instance, joints), recent);
            }
            let Some(local) = ahead.local(level, run, &locals, models, slot) else { return };
            let model = product_in_lanes(recent[from], locals.motion(local).to_array());
            recent[joint % RECENT] = model;
            E::store(model, models, slot.own_tile());
        } else {
            root(level, run, locals, models, slot, &mut recent[joint % RECENT], ahead);
        }
        if run.renormalize.applies_to(joint) {
            normalize_lanes::<E, V>(level, models, slot, &mut recent[joint % RECENT]);
        }
        if const { X::ACTIVE } {
            epilogue.run(level, slot, batch::DualQuat::from_array(recent[joint % RECENT]));
        }
    }
}

/// A parent that is not among the recent models.
#[cold]
#[inline(never)]
fn far<E: Element<8>, V: Level>(
    level: V,
    models: &[E],
    slot: JointSlot,
    recent: &mut Recent<E, V>,
) {
    level.run(
        #[cfg_attr(not(opt_level_0), inline(always))]
        || {
            // From memory, where it was stored as it was in the ring: the same bits.
            if let Some(far) = motions(level, models, slot.own_tile()) {
                recent[RECENT] = far.to_array();
            }
        },
    );
}

/// The models of a joint without a parent.
#[cold]
#[inline(never)]
fn root<E: Element<8>, L: Locals<E>, V: Level>(
    level: V,
    run: &Run<'_, E>,
    locals: L,
    models: &mut [E],
    slot: JointSlot,
    to: &mut [Register<E, V, 8>; 8],
    ahead: &mut Ahead<E, V>,
) {
    level.run(
        #[cfg_attr(not(opt_level_0), inline(always))]
        || {
            let Some(local) = ahead.local(level, run, &locals, models, slot) else { return };
            let local = locals.motion(local).to_array();
            *to = match run.root.load(level, slot.instance(), 0) {
                Some(root) => product_in_lanes(root.to_array(), local),
                None => local,
            };
            E::store(*to, models, slot.own_tile());
        },
    );
}

#[cold]
#[inline(never)]
fn normalize_lanes<E: Element<8>, V: Level>(
    level: V,
    models: &mut [E],
    slot: JointSlot,
    model: &mut [Register<E, V, 8>; 8],
) {
    level.run(
        #[cfg_attr(not(opt_level_0), inline(always))]
        || {
            *model = Motions::<E, V>::from_array(*model).normalize().to_array();
            E::store(*model, models, slot.own_tile());
        },
    );
}

/// One instance where a register holds one number. Models go through memory, since eight numbers
/// would not stay in registers anyway. The product is the one of all other loops, on targets with
/// wider registers too.
#[cfg_attr(not(opt_level_0), inline(always))]
fn alone<E: Element<8>, L: Locals<E>, X: Epilogue<E>, V: Level>(
    level: V,
    run: &Run<'_, E>,
    locals: L,
    models: &mut [E],
    epilogue: &mut X,
    instance: usize,
    ahead: &mut Ahead<E, V>,
) {
    let joints = run.parents.len();
    for joint in run.joints.clone() {
        let Some(&parent) = run.parents.get(joint) else { return };
        let slot = JointSlot::of_instances(joint, instance, joints);
        // ROOT is beyond the last joint: there is no such model.
        // A parent comes before its joint: its model is there already, in place too.
        let parent = match models.get(parent as usize) {
            Some(parent) => motions(level, core::slice::from_ref(parent), Tile::at(0, 0)),
            None => run.root.load(level, instance, 0),
        };
        let Some(local) = ahead.local(level, run, &locals, models, slot) else { return };
        let mut model = locals.motion(local);
        if let Some(parent) = parent {
            let product = product_in_lanes(parent.to_array(), model.to_array());
            model = batch::DualQuat::from_array(product);
        }
        if run.renormalize.applies_to(joint) {
            model = model.normalize();
        }
        E::store(model.to_array(), models, slot.own_tile());
        if const { X::ACTIVE } {
            epilogue.run(level, slot, model);
        }
    }
}

/// One instance after the other: the eight numbers of one motion in the lanes of one register.
struct Walk<'r, 's, E: Element<8>, L, X> {
    run: &'r Run<'r, E>,
    locals: L,
    models: &'s mut [E],
    epilogue: &'s mut X,
    /// How many elements are done already.
    done: usize,
}

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Kernel for Walk<'_, '_, E, L, X> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { run, locals, models, epilogue, done } = self;
        let joints = run.parents.len().max(1);
        let mut ahead = Ahead::of(&locals);
        let instances = models.get_mut(done..).unwrap_or_default().chunks_exact_mut(joints);
        for (instance, models) in (done / joints..).zip(instances) {
            walk(level, run, locals, models, epilogue, (instance, &mut ahead));
        }
    }
}

/// Each joint is multiplied onto its parent. Locals that are not motions in memory are made before,
/// for as many joints as there are lanes; the epilogue comes after, in lanes again.
#[cfg_attr(not(opt_level_0), inline(always))]
fn walk<E: Element<8>, L: Locals<E>, X: Epilogue<E>, V: Level>(
    level: V,
    run: &Run<'_, E>,
    locals: L,
    models: &mut [E],
    epilogue: &mut X,
    (instance, ahead): (usize, &mut Ahead<E, V>),
) {
    let joints = run.parents.len();
    let first = instance * joints;
    let lanes = E::Layout::records::<V>();
    let root = run.root_of(instance);
    // Three stages over as many joints as there are lanes: make their locals, a joint per lane;
    // multiply them onto their parents one after the other, each product using all lanes for its
    // eight numbers; then the epilogue, a joint per lane again. Motions that lie in memory skip the
    // first stage and are multiplied from where they are.
    let in_memory = locals.motions();
    let mut made = [identity(); MAX_LANES];
    for start in run.joints.clone().step_by(lanes) {
        let slot = JointSlot::of_joints(start, instance, joints, run.joints.end);
        if in_memory.is_none() {
            let Some(local) = ahead.local(level, run, &locals, models, slot) else { return };
            locals.motion(local).store_records(&mut made);
        }
        let Some(plain) = E::plain_mut(models) else { return };
        for joint in start..run.joints.end.min(start + lanes) {
            let local = match in_memory {
                Some(Source::Slice(all)) => E::plain(all).and_then(|all| all.get(first + joint)),
                Some(Source::Output) => plain.get(joint),
                None => made.get(joint - start),
            };
            let (Some(local), Some(&parent)) = (local, run.parents.get(joint)) else { return };
            // ROOT is beyond the last joint: there is no such model.
            let model = match (plain.get(parent as usize), &root) {
                (Some(parent), _) | (None, Some(parent)) => product(level, parent, local),
                (None, None) => *local,
            };
            let Some(slot) = plain.get_mut(joint) else { return };
            *slot = model;
            if run.renormalize.applies_to(joint) {
                normalize::<_, V>(level, slot);
            }
        }
        if const { X::ACTIVE } {
            let Some(models) = motions(level, models, slot.own_tile()) else { return };
            epilogue.run(level, slot, models);
        }
    }
}

/// On lanes, so that every bit is that of `normalize_lanes`.
#[cold]
#[inline(never)]
fn normalize<R: Scalar, V: Level>(level: V, model: &mut [R; 8]) {
    level.run(
        #[cfg_attr(not(opt_level_0), inline(always))]
        || {
            let records = core::slice::from_mut(model);
            let lanes = batch::DualQuat::<R::Lanes<V>>::load_records(level, records);
            lanes.normalize().store_records(records);
        },
    );
}

/// The models of one joint.
type Models<E, V> = Rows<Register<E, V, 8>>;

/// Bytes of a cache line, or more than a register has: rows that begin at a multiple of it lie in
/// one line each.
const LINE: usize = 64;

/// Palettes of plain instances whose models nobody asks for: the models stay in the caller's
/// scratch as registers hold them. To transpose and store them would be two fifths of what a
/// palette shuffles and stores, and all parents are where they were put, so nothing is loaded
/// again.
///
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
            palette_group(level, run, locals, &mut epilogue, done, rows);
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
/// [`together`]. Locals that are made wait where the models go.
#[cfg_attr(not(opt_level_0), inline(always))]
fn palette_group<E: Element<8>, L: Locals<E>, X: Epilogue<E>, V: Level>(
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
        normalize_rows::<E, V>(level, place);
    }
    epilogue.run(level, slot, batch::DualQuat::from_array(load(level, place)));
    Some(())
}

#[cold]
#[inline(never)]
fn normalize_rows<E: Element<8>, V: Level>(level: V, model: &mut Models<E, V>) {
    level.run(
        #[cfg_attr(not(opt_level_0), inline(always))]
        || {
            let unit = Motions::<E, V>::from_array(load(level, model)).normalize();
            store(unit.to_array(), model);
        },
    );
}
