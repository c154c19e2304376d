//! [`Locals`]: the poses of joints relative to their parents, in any form in memory. Computed
//! locals, such as the poses of a clip, are computed for a batch of joints at a time and stored in
//! a [`LocalBatch`].

use super::run::{JointSlot, Run};
use crate::batch;
use crate::law::{Law, NlerpLerp};
use crate::macros::brief;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Motions, Number, Register, Source};
use bytemuck::Zeroable;
use core::ops::Range;
use dq8_simd::{Lanes, Level};

/// The local poses of all lanes, with a register for each component. A motion has eight components.
/// A rotation with a translation has seven components, and the last register is then not read.
pub(super) type Registers<E, V> = [Register<E, V, 8>; 8];

/// Locals of whole instances, `[instance][joint]`: [`Poses`], [`RotationsTranslations`],
/// [`Tracks`], [`Bones`], [`Sampled`](super::Sampled), [`Layered`](super::Layered) or
/// [`Either`](super::Either). The trait is sealed. `E` is the element type of the models.
#[diagnostic::on_unimplemented(
    message = "`{Self}` are no locals for models of `{E}`",
    note = "see the list of implementors: `Poses(&motions)`, `RotationsTranslations(&seven_numbers)`, \
            `Tracks {{ rotations, translations }}`, `Bones {{ rotations, offsets }}`, `Sampled`, `Layered`, `Either`; all in \
            the layout of the models",
    note = "slices of glam's types become those of dq8 by `dq8::interop::glam_034::quats` and `points`"
)]
pub trait Locals<E: Element<8>>: Copy + Send + Sync + sealed::Sealed {
    /// Returns the name of the locals for error texts, and the number of their elements. The
    /// skeleton has `joints` joints, and the slice of models has `models` elements.
    ///
    /// # Errors
    /// If a slice that all instances share, such as the offsets, does not have one element per
    /// joint.
    #[doc(hidden)]
    fn shape(&self, joints: usize, models: usize) -> Result<(&'static str, usize), ShapeError>;

    /// Loads the locals of a slot. `models` holds the models of the slot's instances, which have
    /// been computed for all earlier joints. If the run is in place, the locals are read from
    /// `models`.
    #[doc(hidden)]
    fn load<V: Level>(self, level: V, models: &[E], slot: JointSlot) -> Option<Registers<E, V>>;

    /// `true` if the locals are computed, such as the poses of a clip. A kernel then calls
    /// [`load_batch`](Self::load_batch) for several joints at once. If the computation were inlined
    /// into the kernel, it would take registers from the kernel, and would repeat for each joint
    /// the work that all joints share.
    #[doc(hidden)]
    const COMPUTED: bool = false;

    /// Computes the locals of a slot and of the slots after it into `to`, one slot for each
    /// element.
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

    /// Converts a local to a motion.
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn motion<V: Level>(self, local: Registers<E, V>) -> Motions<E, V> {
        batch::DualQuat::from_array(local)
    }

    /// Multiplies a local onto the model of its parent: parent · local.
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn onto<V: Level>(self, parent: Motions<E, V>, local: Registers<E, V>) -> Motions<E, V> {
        parent * self.motion(local)
    }

    /// Returns the locals if they are stored motions, and `None` if they have another form or are
    /// computed.
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn motions(&self) -> Option<Source<'_, E>> {
        None
    }
    /// Returns the locals of a range of instances (or blocks); an instance has `joints` elements.
    #[doc(hidden)]
    #[must_use]
    fn part(self, joints: usize, instances: Range<usize>) -> Self;
}

/// Motions, one for each joint of each instance.
#[derive(Clone, Copy)]
pub struct Poses<'s, E>(
    /// One motion for each joint of each instance, `[instance][joint]`.
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

/// Locals that are motions in the memory of the models. Each model overwrites its local.
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

/// Rotations r with translations t, which stand for the motions r + ½εtr. They take an eighth
/// less memory than motions, and computing models from them takes no more operations.
#[derive(Clone, Copy)]
pub struct RotationsTranslations<'s, T>(
    /// One element for each joint of each instance:
    /// [`RotationTranslation`](crate::representation::RotationTranslation),
    /// `[x, y, z, w, tx, ty, tz]`, or blocks of seven rows.
    pub &'s [T],
);

brief!([T] RotationsTranslations<'_, T>: RotationsTranslations |it| { elements: it.0.len() });

/// Rotations and translations of each joint in two arrays, as animation tracks have them. In
/// [`RotationsTranslations`] they are in one array.
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
    /// One rotation for each joint of each instance.
    pub rotations: &'s [Q],
    /// One translation for each joint of each instance.
    pub translations: &'s [T],
}

brief!([Q, T] Tracks<'_, Q, T>: Tracks |it| {
    rotations: it.rotations.len(), translations: it.translations.len(),
});

/// Rotations of each joint, and the offset of each joint from its parent, which is the same for all
/// instances. Many animation clips have this form, which takes half the memory of motions.
#[derive(Clone, Copy)]
pub struct Bones<'s, Q: Element<4>> {
    /// One rotation for each joint of each instance.
    pub rotations: &'s [Q],
    /// The position of each joint in its parent; one for each joint of the skeleton.
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

/// Returns the elements of a range of instances in a slice with `count` elements for each instance.
/// If the slice ends within the range, the result ends with the slice.
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

/// The poses or motions of all lanes in memory, with a row of lanes for each component, as in
/// registers. Poses of seven components leave the last row unchanged.
pub(super) type Stored<L> = [<L as Lanes>::Array; 8];

/// The number of slots ([`JointSlot`]) in a batch. The batch is so large that the calls of a source
/// take little of the time, and small enough to stay in the first-level cache.
pub(super) const BATCH: usize = 16;

/// `true` if computed locals are computed in batches. Firmware has little memory for code and
/// stack, so it computes the locals of one slot at a time.
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

/// Loads the first `C` rows of `from` into registers.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn load<L: Lanes, const C: usize>(level: L::Level, from: &Stored<L>) -> [L; C] {
    let mut registers = [L::splat(level, L::Real::default()); C];
    for (register, row) in registers.iter_mut().zip(from) {
        *register = L::load(level, row);
    }
    registers
}

/// Stores registers to the first `C` rows of `to`.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn store<L: Lanes, const C: usize>(registers: [L; C], to: &mut Stored<L>) {
    for (register, row) in registers.iter().zip(to) {
        register.store(row);
    }
}

/// Copies an array to an array of another length. Elements beyond the length of `from` are copies
/// of its first element, and are never read.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn resized<L: Lanes, const A: usize, const B: usize>(from: [L; A]) -> [L; B] {
    // This is a loop and not a closure, because a closure that is not inlined would be compiled
    // without the kernel's instructions (AVX2, AVX-512).
    let mut to = [from[0]; B];
    for (to, &from) in to.iter_mut().zip(&from) {
        *to = from;
    }
    to
}

/// Memory for a batch of computed locals. It is `None` if the locals are not computed but stored.
pub(super) struct LocalBatch<E: Element<8>, V: Level>(Option<[Stored<Register<E, V, 8>>; BATCH]>);

/// The data that every loop over joints reads. Each loop is a method, which copies the fields that
/// it reads into variables before the first joint, and takes each slice that it writes as a
/// parameter. Otherwise the compiler must assume that a store may change the fields, and loads them
/// again for every joint.
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
    /// Makes the memory for a batch if the locals are computed.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn batch(self) -> LocalBatch<E, V> {
        LocalBatch(if const { L::COMPUTED } { Some([Zeroable::zeroed(); BATCH]) } else { None })
    }

    /// Returns the local of a slot. At the first slot of a batch it computes the whole batch, so
    /// the caller must pass all slots in the order of joints.
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

    /// Computes the locals of a slot and of the joints after it, at most [`BATCH`] joints, and
    /// stores them in the memory of their models.
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
