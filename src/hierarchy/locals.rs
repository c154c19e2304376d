//! [`Locals`]: the pose of a joint in its parent, and its form in memory. Locals that are computed
//! are computed for a group of joints at a time, into [`Stored`], which a [`LocalBatch`] holds.

use super::run::{JointSlot, Run};
use crate::batch;
use crate::law::{Law, NlerpLerp};
use crate::macros::brief;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Motions, Number, Register, Source};
use bytemuck::Zeroable;
use core::ops::Range;
use dq8_simd::{Lanes, Level};

/// The local pose of each lane. Eight registers hold a motion. If a pose has seven numbers, the
/// last register is not read.
pub(super) type Registers<E, V> = [Register<E, V, 8>; 8];

/// Locals of whole instances, `[instance][joint]`: [`Poses`], [`RotationsTranslations`],
/// [`Tracks`], [`Bones`], [`Sampled`](super::Sampled), [`Layered`](super::Layered) or
/// [`Either`](super::Either). Sealed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` are no locals for models of `{E}`",
    note = "see the list of implementors: `Poses(&motions)`, `RotationsTranslations(&seven_numbers)`, \
            `Tracks {{ rotations, translations }}`, `Bones {{ rotations, offsets }}`, `Sampled`, `Layered`, `Either`; all in \
            the layout of the models",
    note = "slices of glam's types become those of dq8 by `dq8::interop::glam_034::quats` and `points`"
)]
pub trait Locals<E: Element<8>>: Copy + Send + Sync + sealed::Sealed {
    /// The name of the locals in errors, and the number of locals. A skeleton of `joints` joints is
    /// to get `models` models.
    ///
    /// # Errors
    /// If a slice that all instances share, such as the offsets, does not have one element per
    /// joint.
    #[doc(hidden)]
    fn shape(&self, joints: usize, models: usize) -> Result<(&'static str, usize), ShapeError>;

    /// The locals of a slot. `models` are the models of its instances; those of earlier joints are
    /// known.
    #[doc(hidden)]
    fn load<V: Level>(self, level: V, models: &[E], slot: JointSlot) -> Option<Registers<E, V>>;

    /// `true` if the locals are computed. A kernel then calls [`load_batch`](Self::load_batch). If
    /// the computation were part of the kernel, it would take registers of the kernel, and would
    /// repeat for each joint what is the same for all joints.
    #[doc(hidden)]
    const COMPUTED: bool = false;

    /// Computes the locals of a slot and of the slots after it, at most a batch, into `to`.
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_batch<V: Level>(
        &self,
        level: V,
        slot: JointSlot,
        to: &mut [Stored<Register<E, V, 8>>],
    ) -> Option<()> {
        each(
            slot,
            to,
            #[cfg_attr(not(opt_level_0), inline(always))]
            |slot| self.load(level, &[], slot),
        )
    }

    /// A local as a motion.
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn motion<V: Level>(self, local: Registers<E, V>) -> Motions<E, V> {
        batch::DualQuat::from_array(local)
    }

    /// parent · local
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn onto<V: Level>(self, parent: Motions<E, V>, local: Registers<E, V>) -> Motions<E, V> {
        parent * self.motion(local)
    }

    /// The motions in memory. `None` if the locals are not motions in memory.
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn motions(&self) -> Option<Source<'_, E>> {
        None
    }
    /// The locals of some of the instances (blocks).
    #[doc(hidden)]
    #[must_use]
    fn part(self, joints: usize, instances: Range<usize>) -> Self;
}

/// Motions, one for each joint.
#[derive(Clone, Copy)]
pub struct Poses<'s, E>(
    /// One for each joint.
    pub &'s [E],
);

brief!([E] Poses<'_, E>: Poses |it| { elements: it.0.len() });

impl<E: Element<8>> Locals<E> for Poses<'_, E> {
    fn shape(&self, _: usize, _: usize) -> Result<(&'static str, usize), ShapeError> {
        Ok(("locals", self.0.len()))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(self, level: V, _: &[E], slot: JointSlot) -> Option<Registers<E, V>> {
        E::load(level, self.0, slot.tile(), &storage::identity())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn motions(&self) -> Option<Source<'_, E>> {
        Some(Source::Slice(self.0))
    }
    fn part(self, joints: usize, instances: Range<usize>) -> Self {
        Self(part_of(self.0, joints, instances))
    }
}

/// Motions that lie in the memory of the models, which replace them.
#[derive(Clone, Copy, Debug)]
pub(super) struct InPlace;

impl<E: Element<8>> Locals<E> for InPlace {
    fn shape(&self, _: usize, models: usize) -> Result<(&'static str, usize), ShapeError> {
        Ok(("poses", models))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(self, level: V, models: &[E], slot: JointSlot) -> Option<Registers<E, V>> {
        E::load(level, models, slot.own_tile(), &storage::identity())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn motions(&self) -> Option<Source<'_, E>> {
        Some(Source::Output)
    }
    fn part(self, _: usize, _: Range<usize>) -> Self {
        self
    }
}

/// Rotations and translations, r + ½εtr. They take an eighth less memory than motions, and no
/// more operations.
#[derive(Clone, Copy)]
pub struct RotationsTranslations<'s, T>(
    /// One for each joint: [`RotationTranslation`](crate::representation::RotationTranslation),
    /// `[x, y, z, w, tx, ty, tz]`, or blocks of seven rows.
    pub &'s [T],
);

brief!([T] RotationsTranslations<'_, T>: RotationsTranslations |it| { elements: it.0.len() });

/// Rotations and translations of each joint in two arrays, the form of animation tracks.
/// [`RotationsTranslations`] have both in one array.
///
/// ```
/// use dq8::{DualQuat, Hierarchy, Quat, hierarchy::Tracks};
/// let parents = [Hierarchy::ROOT, 0];
/// let arm = Hierarchy::new(&parents)?;
/// let half_turn = Quat::from_xyzw(0.0_f32, 0.0, 1.0, 0.0);
/// let locals =
///     Tracks { rotations: &[half_turn; 2], translations: &[[0.0; 3], [2.0, 0.0, 0.0]] };
/// let mut models = [DualQuat::IDENTITY; 2];
/// arm.job().locals_to_model(locals, &mut models)?;
/// assert_eq!(models[1].translation(), [-2.0, 0.0, 0.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Tracks<'s, Q, T> {
    /// One for each joint.
    pub rotations: &'s [Q],
    /// One for each joint.
    pub translations: &'s [T],
}

brief!([Q, T] Tracks<'_, Q, T>: Tracks |it| {
    rotations: it.rotations.len(), translations: it.translations.len(),
});

/// Rotations of each joint, and the offset of each joint from its parent, which is the same for all
/// instances. It is the form of many animation clips, and takes half the memory of motions.
#[derive(Clone, Copy)]
pub struct Bones<'s, Q: Element<4>> {
    /// One for each joint.
    pub rotations: &'s [Q],
    /// The position of each joint of the skeleton in its parent.
    pub offsets: &'s [[Number<Q, 4>; 3]],
}

brief!([Q: Element<4>] Bones<'_, Q>: Bones |it| {
    rotations: it.rotations.len(), offsets: it.offsets.len(),
});

impl<E: Element<8>, Q: Element<4, Layout = E::Layout>> Locals<E> for Bones<'_, Q> {
    fn shape(&self, joints: usize, _: usize) -> Result<(&'static str, usize), ShapeError> {
        same_length("offsets", self.offsets.len(), joints)?;
        Ok(("rotations", self.rotations.len()))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(self, level: V, _: &[E], slot: JointSlot) -> Option<Registers<E, V>> {
        let [x, y, z, w] = Q::load(level, self.rotations, slot.tile(), &storage::identity())?;
        let [a, b, c] = slot.of_joint(level, self.offsets)?;
        Some(resized([x, y, z, w, a, b, c]))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn motion<V: Level>(self, local: Registers<E, V>) -> Motions<E, V> {
        NlerpLerp.motion(resized(local))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn onto<V: Level>(self, parent: Motions<E, V>, local: Registers<E, V>) -> Motions<E, V> {
        NlerpLerp.onto(parent, resized(local))
    }
    fn part(self, joints: usize, instances: Range<usize>) -> Self {
        Self { rotations: part_of(self.rotations, joints, instances), ..self }
    }
}

/// The elements of some instances in a slice with `count` elements for each instance; fewer at the
/// end of the slice.
pub(super) fn part_of<T>(slice: &[T], count: usize, instances: Range<usize>) -> &[T] {
    let place = |instance: usize| instance.saturating_mul(count).min(slice.len());
    slice.get(place(instances.start)..place(instances.end)).unwrap_or_default()
}

pub(super) mod sealed {
    use super::{Bones, Element, InPlace, Poses, RotationsTranslations, Tracks};
    pub trait Sealed {}
    impl Sealed for InPlace {}
    impl<E> Sealed for Poses<'_, E> {}
    impl<T> Sealed for RotationsTranslations<'_, T> {}
    impl<Q, T> Sealed for Tracks<'_, Q, T> {}
    impl<Q: Element<4>> Sealed for Bones<'_, Q> {}
}

/// The pose or motion of each lane in memory, in the order of registers: a row for each component.
/// A pose of seven numbers does not change the last row.
pub(super) type Stored<L> = [<L as Lanes>::Array; 8];

/// The number of slots in a batch. It is so large that a call of each source costs little, and so
/// small that the batch stays in the first cache.
pub(super) const BATCH: usize = 16;

/// `true` if computed locals are computed in batches. Firmware, which counts the bytes of its code
/// and stack, computes them one by one.
pub(super) const BATCHES: bool = cfg!(not(target_os = "none"));

/// Fills `to` with the poses of a slot and of the slots after it, by a call of `pose` for each.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn each<L: Lanes, const C: usize>(
    slot: JointSlot,
    to: &mut [Stored<L>],
    mut pose: impl FnMut(JointSlot) -> Option<[L; C]>,
) -> Option<()> {
    for (number, rows) in to.iter_mut().enumerate() {
        store(pose(slot.after(number, L::LANES))?, rows);
    }
    Some(())
}

/// Loads the first `C` rows.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn load<L: Lanes, const C: usize>(level: L::Level, from: &Stored<L>) -> [L; C] {
    let mut registers = [L::splat(level, L::Real::default()); C];
    for (register, row) in registers.iter_mut().zip(from) {
        *register = L::load(level, row);
    }
    registers
}

/// Stores to the first `C` rows.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn store<L: Lanes, const C: usize>(registers: [L; C], to: &mut Stored<L>) {
    for (register, row) in registers.iter().zip(to) {
        register.store(row);
    }
}

/// An array of another length with the same first elements. Further elements are copies of the
/// first one, and nobody reads them.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn resized<L: Lanes, const A: usize, const B: usize>(from: [L; A]) -> [L; B] {
    // This is a loop and not a closure, because a closure in an inlined kernel would be compiled
    // without the kernel's instructions (AVX2, AVX-512).
    let mut to = [from[0]; B];
    for (to, &from) in to.iter_mut().zip(&from) {
        *to = from;
    }
    to
}

/// Memory for a batch of computed locals; `None` if locals are loaded.
pub(super) struct LocalBatch<E: Element<8>, V: Level>(Option<[Stored<Register<E, V, 8>>; BATCH]>);

/// The data that every loop over joints reads; each loop is a method. Loops copy the fields that
/// they read into variables before the first joint, and get each slice that they write as a
/// parameter. The compiler must assume that a store changes whatever a reference or a field points
/// to, so it would load fields again for every joint.
pub(super) struct Pass<'r, E: Element<8>, L, V> {
    pub(super) level: V,
    pub(super) run: &'r Run<'r, E>,
    pub(super) locals: L,
}

impl<E: Element<8>, L: Copy, V: Copy> Clone for Pass<'_, E, L, V> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn clone(&self) -> Self {
        *self
    }
}
impl<E: Element<8>, L: Copy, V: Copy> Copy for Pass<'_, E, L, V> {}

impl<E: Element<8>, L: Locals<E>, V: Level> Pass<'_, E, L, V> {
    /// Memory for a batch, if the locals are computed.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn batch(self) -> LocalBatch<E, V> {
        LocalBatch(if const { L::COMPUTED } { Some([Zeroable::zeroed(); BATCH]) } else { None })
    }

    /// The local of a slot. Slots must come in the order of joints, and none may be left out.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn local(
        &self,
        batch: &mut LocalBatch<E, V>,
        models: &[E],
        slot: JointSlot,
    ) -> Option<Registers<E, V>> {
        let Self { level, run, locals } = *self;
        if const { !L::COMPUTED } {
            return locals.load(level, models, slot);
        }
        let rows = batch.0.as_mut()?;
        let step = if slot.lanes_are_joints() { Register::<E, V, 8>::LANES } else { 1 };
        let at = (slot.joint() - run.joints.start) / step;
        if at.is_multiple_of(BATCH) {
            let all = run.joints.len().div_ceil(step);
            self.locals.load_batch(level, slot, rows.get_mut(..BATCH.min(all - at))?)?;
        }
        Some(load(level, rows.get(at % BATCH)?))
    }

    /// Computes the locals of a slot and of the joints after it, no more than a batch, and stores
    /// them where their models will be.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn place(
        &self,
        batch: &mut LocalBatch<E, V>,
        models: &mut [E],
        slot: JointSlot,
    ) -> Option<()> {
        let joints = BATCH.min(self.run.joints.end - slot.joint());
        let rows = batch.0.as_mut()?.get_mut(..joints)?;
        self.locals.load_batch(self.level, slot, rows)?;
        for (number, rows) in rows.iter().enumerate() {
            E::copy(self.level, rows, models, slot.after(number, 1).own_tile());
        }
        Some(())
    }

    /// Stores the local pose of a slot in `poses`, as a motion.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn write(
        &self,
        batch: &mut LocalBatch<E, V>,
        poses: &mut [E],
        slot: JointSlot,
    ) -> Option<()> {
        let local = self.local(batch, &[], slot)?;
        E::store(self.locals.motion(local).to_array(), slot.within(poses), slot.tile());
        Some(())
    }
}
