//! The computation of models from locals, model(j) = model(parent(j)) · local(j), for plain
//! motions, which are transposed in registers.
//!
//! # The algorithm
//!
//! The loop takes as many instances at a time as there are lanes. For each joint, parents first, it
//! loads the local poses of all these instances (a transpose), multiplies them onto the models of
//! the joint's parent, and stores the products (another transpose). Instances that do not fill the
//! lanes, and single instances, are computed one by one, with the eight components of a motion in
//! one register.
//!
//! # Reasons
//!
//! - *A ring of recent models.* A product needs the parent's model with a register for each
//!   component, and transposing it a second time would cost as much as the product. Most parents
//!   are a few joints back, so the last [`RECENT`] models are also kept in a ring buffer, in the
//!   layout of the registers. Only a parent that lies farther back is transposed again, in a
//!   function that is not inlined.
//! - *One source* (`docs/measured.md`, *What keeps loops in registers*). The model of a far parent
//!   is transposed into an element of the ring, too. So every product reads its left factor from
//!   the ring, whether the parent is near or far.
//! - *The same operations in the same order* for instances in lanes and for single instances. So
//!   the bits of a model do not depend on the number of instances in the call.
//! - *A prefetch before a strided store* if the models exceed the second-level cache. Each instance
//!   is a stream of its own, and the hardware prefetcher does not follow that many streams.

use super::chain::{product, product_in_lanes};
use super::locals::{BATCH, LocalBatch, Locals, Pass, Registers, Stored, load, store};
use super::run::{Epilogue, Forward, JointSlot, PaletteOnly};
use crate::backend::Kernel;
use crate::batch;
use crate::number::Scalar;
use crate::storage::{Element, Layout, Motions, Register, Source, Tile, identity, motions};
use bytemuck::Zeroable;
use dq8_simd::{Lanes, Level, MAX_LANES, Portable};

/// The number of recent models that are kept for their children in the layout of registers, so that
/// they need no transpose. Parents farther back are transposed again. More models would fill the
/// first-level cache, which also holds the locals and models of the instances.
const RECENT: usize = 16;

/// `true` if the loop over many plain instances is compiled. Firmware has few instances and little
/// memory for code and stack.
pub(super) const MANY: bool = cfg!(not(target_os = "none"));

/// The size of the second-level cache in bytes. Models that exceed it are prefetched before they
/// are written. That saves a tenth of the time of models, and a sixth of the time of palettes with
/// models. With fewer models, prefetching costs a twentieth. If models are written in place of
/// their locals, prefetching saves nothing.
const NEAR: usize = 1 << 20;

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Forward<'_, '_, E, L, X> {
    /// Computes models of plain motions.
    #[inline]
    pub(super) fn plain(mut self) {
        let backend = self.run.backend;
        // On targets without SIMD a register holds a single value, and this loop computes one
        // instance at a time.
        let mut done = 0;
        if const { Register::<E, Portable, 8>::LANES == 1 }
            || (const { MANY } && self.models.len() > self.run.parents.len())
        {
            done = backend.run(Instances(&mut self));
        }
        if const { Register::<E, Portable, 8>::LANES > 1 } && done < self.models.len() {
            backend.run(OneByOne { of: self, done });
        }
    }
}

/// The loop whose lanes are instances, which lie at a stride in memory. It computes groups of as
/// many instances as there are lanes, and returns the number of elements in these groups.
struct Instances<'f, 'r, 's, E: Element<8>, L, X>(&'f mut Forward<'r, 's, E, L, X>);

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Kernel for Instances<'_, '_, '_, E, L, X> {
    type Output = usize;
    const WIDE: bool = E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) -> usize {
        let Forward { run, locals, models, epilogue } = self.0;
        let pass = Pass { level, run: *run, locals: *locals };
        let group = E::Layout::records::<V>().saturating_mul(run.parents.len());
        let (mut done, mut instance) = (0, 0);
        let in_place = matches!(locals.motions(), Some(Source::Output));
        let mut wait = Waiting {
            ring: Ring::new(level),
            batch: pass.batch(),
            prefetch: size_of_val(*models) > NEAR && !in_place,
        };
        if group > 0 {
            for models in models.chunks_exact_mut(group) {
                if E::Layout::records::<V>() > 1 {
                    pass.instances(models, instance, &mut wait, epilogue);
                } else {
                    pass.one_instance(models, instance, &mut wait.batch, epilogue);
                }
                done += group;
                instance += E::Layout::records::<V>();
            }
        }
        done
    }
}

/// The recent models, which the products of their children will read, and the batch of computed
/// locals.
struct Waiting<E: Element<8>, V: Level> {
    ring: Ring<E, V>,
    batch: LocalBatch<E, V>,
    /// `true` if all models together exceed [`NEAR`].
    prefetch: bool,
}

/// The recent models, with a register for each component. The model of joint j is at index j %
/// [`RECENT`] until that of joint j + [`RECENT`] replaces it. The last element is for a parent that
/// is not among the recent models.
struct Ring<E: Element<8>, V: Level>([Registers<E, V>; RECENT + 1]);

impl<E: Element<8>, V: Level> Ring<E, V> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn new(level: V) -> Self {
        Self([Motions::<E, V>::identity(level).to_array(); RECENT + 1])
    }

    /// Loads the model of a joint from `models` into the last element of the ring, because the ring
    /// no longer holds it. The model was written both to the ring and to `models`, so it has the
    /// same bits.
    #[cold]
    #[inline(never)]
    fn fetch(&mut self, level: V, models: &[E], slot: JointSlot) {
        level.run(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || {
                if let Some(far) = motions(level, models, slot.own_tile()) {
                    self.0[RECENT] = far.to_array();
                }
            },
        );
    }

    /// Normalizes the model of a joint, both in the ring and in `models`.
    #[cold]
    #[inline(never)]
    fn normalize(&mut self, level: V, models: &mut [E], slot: JointSlot) {
        level.run(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || {
                let model = &mut self.0[slot.joint() % RECENT];
                *model = Motions::<E, V>::from_array(*model).normalize().to_array();
                E::store(*model, models, slot.own_tile());
            },
        );
    }
}

impl<E: Element<8>, L: Locals<E>, V: Level> Pass<'_, E, L, V> {
    /// Computes the models of a group of as many instances as there are lanes, of which `instance`
    /// is the first. Every product reads the parent's model from the ring, which is memory in the
    /// first-level cache, so that the branches for recent and for far parents join without moves
    /// between registers (*One source*, docs/measured.md).
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn instances<X: Epilogue<E>>(
        self,
        models: &mut [E],
        instance: usize,
        wait: &mut Waiting<E, V>,
        epilogue: &mut X,
    ) {
        let Self { level, run, locals } = self;
        let (parents, joints, prefetch) = (run.parents, run.parents.len(), wait.prefetch);
        let Waiting { ring, batch, .. } = wait;
        for joint in run.joints.clone() {
            let Some(&parent) = parents.get(joint) else { return };
            let slot = JointSlot::of_instances(joint, instance, joints);
            let parent = parent as usize;
            if prefetch {
                slot.prefetch_own(level, models, E::Layout::records::<V>());
            }
            if parent < joint {
                // A parent that the ring no longer holds, or never held because it lies before the
                // range of joints, is loaded into the last element. So on both paths the product
                // reads an element of the ring.
                let mut from = parent % RECENT;
                if joint - parent >= RECENT || parent < run.joints.start {
                    from = RECENT;
                    ring.fetch(level, models, JointSlot::of_instances(parent, instance, joints));
                }
                let Some(local) = self.local(batch, models, slot) else { return };
                let model = product_in_lanes(ring.0[from], locals.motion(local).to_array());
                ring.0[joint % RECENT] = model;
                E::store(model, models, slot.own_tile());
            } else {
                self.root(batch, models, slot, &mut ring.0[joint % RECENT]);
            }
            if run.renormalize.applies_to(joint) {
                ring.normalize(level, models, slot);
            }
            if const { X::ACTIVE } {
                epilogue.run(level, slot, batch::DualQuat::from_array(ring.0[joint % RECENT]));
            }
        }
    }

    /// Computes the models of a joint without a parent.
    #[cold]
    #[inline(never)]
    fn root(
        self,
        batch: &mut LocalBatch<E, V>,
        models: &mut [E],
        slot: JointSlot,
        to: &mut Registers<E, V>,
    ) {
        let Self { level, run, locals } = self;
        level.run(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || {
                let Some(local) = self.local(batch, models, slot) else { return };
                let local = locals.motion(local).to_array();
                *to = match run.root.load(level, slot.instance(), 0) {
                    Some(root) => product_in_lanes(root.to_array(), local),
                    None => local,
                };
                E::store(*to, models, slot.own_tile());
            },
        );
    }

    /// Computes the models of one instance on targets without SIMD, where a register holds a single
    /// value. Models go through memory, because the eight components of a model, one in each
    /// register, would not stay in registers anyway. The product is the same as in all other loops
    /// and on targets with wider registers, so results have the same bits.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn one_instance<X: Epilogue<E>>(
        self,
        models: &mut [E],
        instance: usize,
        batch: &mut LocalBatch<E, V>,
        epilogue: &mut X,
    ) {
        let Self { level, run, locals } = self;
        let joints = run.parents.len();
        for joint in run.joints.clone() {
            let Some(&parent) = run.parents.get(joint) else { return };
            let slot = JointSlot::of_instances(joint, instance, joints);
            // The parent of a root is `ROOT`. This index is beyond all models, so the load returns
            // `None`. Any other parent comes before its joint, so its model has been written
            // already, also if the run is in place.
            let parent = match models.get(parent as usize) {
                Some(parent) => motions(level, core::slice::from_ref(parent), Tile::at(0, 0)),
                None => run.root.load(level, instance, 0),
            };
            let Some(local) = self.local(batch, models, slot) else { return };
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
}

/// The loop that computes one instance after the other; one register holds the eight components of
/// a motion.
struct OneByOne<'r, 's, E: Element<8>, L, X> {
    of: Forward<'r, 's, E, L, X>,
    /// The number of elements that [`Instances`] has computed already.
    done: usize,
}

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Kernel for OneByOne<'_, '_, E, L, X> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { of: Forward { run, locals, models, mut epilogue }, done } = self;
        let joints = run.parents.len().max(1);
        let pass = Pass { level, run, locals };
        let mut batch = pass.batch();
        let instances = models.get_mut(done..).unwrap_or_default().chunks_exact_mut(joints);
        for (instance, models) in (done / joints..).zip(instances) {
            pass.one_by_one(models, instance, &mut batch, &mut epilogue);
        }
    }
}

impl<E: Element<8>, L: Locals<E>, V: Level> Pass<'_, E, L, V> {
    /// Computes the models of one instance, joint by joint. Locals that are not motions in memory
    /// are first converted to motions, for as many joints as there are lanes. After the products
    /// the epilogue runs, again with a joint in each lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn one_by_one<X: Epilogue<E>>(
        self,
        models: &mut [E],
        instance: usize,
        batch: &mut LocalBatch<E, V>,
        epilogue: &mut X,
    ) {
        let Self { level, run, locals } = self;
        let joints = run.parents.len();
        let first = instance * joints;
        let lanes = E::Layout::records::<V>();
        let root = run.root_of(instance);
        // The loop has three stages, each for as many joints as there are lanes. First their locals
        // are made, with a joint in each lane. Then each joint is multiplied onto its parent, with
        // the components of one product in the lanes. At the end the epilogue runs, again with a
        // joint in each lane. For locals that are stored motions there is no first stage: the
        // products read them where they are.
        let in_memory = locals.motions();
        let mut made = [identity(); MAX_LANES];
        for start in run.joints.clone().step_by(lanes) {
            let slot = JointSlot::of_joints(start, instance, joints, run.joints.end);
            if in_memory.is_none() {
                let Some(local) = self.local(batch, models, slot) else { return };
                locals.motion(local).store_records(&mut made);
            }
            let Some(plain) = E::plain_mut(models) else { return };
            for joint in start..run.joints.end.min(start + lanes) {
                let local = match in_memory {
                    Some(Source::Slice(all)) => {
                        E::plain(all).and_then(|all| all.get(first + joint))
                    }
                    Some(Source::Output) => plain.get(joint),
                    None => made.get(joint - start),
                };
                let (Some(local), Some(&parent)) = (local, run.parents.get(joint)) else { return };
                // The parent of a root is `ROOT`. This index is beyond all models, so the load
                // returns `None`.
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
}

/// Normalizes one model with the operations of lanes, so that it has the same bits as with
/// [`Ring::normalize`].
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

/// The models of one joint in as many instances as there are lanes, with a row of lanes for each
/// component.
type Models<E, V> = Stored<Register<E, V, 8>>;

/// The size of a cache line in bytes, which is at least the size of a register. A row that begins
/// at a multiple of this size lies in one cache line.
const LINE: usize = 64;

/// The loop for palettes without models: the caller wants the palette alone, so the models stay in
/// the caller's scratch memory in the layout of registers, without a transpose. Transposing and
/// storing them would take two fifths of all shuffles and stores of a palette. No parent is
/// transposed again either.
///
/// Lanes are instances, which lie at a stride in memory. The loop computes groups of as many
/// instances as there are lanes, and returns the number of instances in these groups. It returns 0
/// if the scratch memory does not hold one group.
pub(super) struct PaletteInstances<'f, 'r, 's, E: Element<8>, L, X>(
    pub(super) &'f mut PaletteOnly<'r, 's, E, L, X>,
);

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Kernel for PaletteInstances<'_, '_, '_, E, L, X> {
    type Output = usize;
    // On CPUs that shuffle 512 bits as quickly as 256 bits, AVX-512 takes a quarter less time than
    // AVX2.
    const SHUFFLES: bool = !E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) -> usize {
        let PaletteOnly { run, locals, instances, scratch, epilogue } = self.0;
        let lanes = E::Layout::records::<V>();
        let joints = run.parents.len();
        let rows =
            E::plain_mut(scratch).and_then(|plain| aligned(plain.as_flattened_mut(), joints));
        // On targets without SIMD there is nothing to transpose, so this loop would save no time.
        let (Some(rows), 2..) = (rows, lanes) else { return 0 };
        let pass = Pass { level, run: *run, locals: *locals };
        let mut done = 0;
        while *instances - done >= lanes {
            pass.palette(rows, done, epilogue);
            done += lanes;
        }
        done
    }
}

/// Casts `numbers`, the floats of the caller's scratch memory, to one `M` for each joint. Returns
/// `None` if there are too few. If there is room to spare, the result begins at a cache line.
#[cfg_attr(not(opt_level_0), inline(always))]
fn aligned<R: Scalar, M: bytemuck::Pod>(numbers: &mut [R], joints: usize) -> Option<&mut [M]> {
    let needed = joints.checked_mul(size_of::<M>() / size_of::<R>())?;
    let spare = numbers.len().checked_sub(needed)?;
    // A row across two cache lines takes two accesses. The caller's memory is aligned to one float
    // only, so the result begins at the next cache line if there is room. The place where it begins
    // does not change any result.
    let aligned = numbers.as_ptr().align_offset(LINE);
    let start = if aligned <= spare { aligned } else { 0 };
    bytemuck::try_cast_slice_mut(numbers.get_mut(start..start + needed)?).ok()
}

impl<E: Element<8>, L: Locals<E>, V: Level> Pass<'_, E, L, V> {
    /// Computes the palette of a group of as many instances as there are lanes, of which `instance`
    /// is the first. All models go through memory in the layout of registers, as in
    /// [`instances`](Self::instances). Computed locals are first written to the memory of their
    /// models.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn palette<X: Epilogue<E>>(
        self,
        models: &mut [Models<E, V>],
        instance: usize,
        epilogue: &mut X,
    ) {
        let Self { level, run, locals } = self;
        let joints = run.joints.clone();
        let slot = |joint| JointSlot::of_instances(joint, instance, run.parents.len());
        // The base of roots is stored to memory, so that products read it in the same way as the
        // models of parents, and no values are moved between registers where two branches join
        // (*One source*, docs/measured.md).
        let mut base = Models::<E, V>::zeroed();
        let base = if let Some(root) = run.root.load(level, instance, 0) {
            store(root.to_array(), &mut base);
            Some(&base)
        } else {
            None
        };
        if const { L::COMPUTED } {
            let rows = models.get_mut(joints.clone()).unwrap_or_default();
            for (first, rows) in joints.clone().step_by(BATCH).zip(rows.chunks_mut(BATCH)) {
                if locals.load_batch(level, slot(first), rows).is_none() {
                    return;
                }
            }
        }
        for joint in joints {
            let Some(rows) = models.get(joint) else { return };
            let local = if const { L::COMPUTED } {
                Some(load(level, rows))
            } else {
                locals.load(level, &[], slot(joint))
            };
            let Some(local) = local else { return };
            let local = locals.motion(local).to_array();
            let Some(&parent) = run.parents.get(joint) else { return };
            // The parent of a root is `ROOT`. This index is beyond all models, so the load returns
            // `None`. Each branch has its own store, so that the compiler moves no values between
            // registers where the branches join (*Kept apart*, docs/measured.md).
            if let Some(parent) = models.get(parent as usize).or(base) {
                let model = product_in_lanes(load(level, parent), local);
                let Some(place) = models.get_mut(joint) else { return };
                store(model, place);
            } else {
                let Some(place) = models.get_mut(joint) else { return };
                store(local, place);
            }
            let Some(place) = models.get_mut(joint) else { return };
            // The epilogue reads the model from memory, in the first-level cache, whether the model
            // was normalized or not (*One source*, docs/measured.md).
            if run.renormalize.applies_to(joint) {
                normalize_rows::<Register<E, V, 8>>(level, place);
            }
            epilogue.run(level, slot(joint), batch::DualQuat::from_array(load(level, place)));
        }
    }
}

#[cold]
#[inline(never)]
fn normalize_rows<L: Lanes>(level: L::Level, model: &mut Stored<L>) {
    level.run(
        #[cfg_attr(not(opt_level_0), inline(always))]
        || {
            let unit = batch::DualQuat::<L>::from_array(load(level, model)).normalize();
            store(unit.to_array(), model);
        },
    );
}
