//! The computation of locals from models, local(j) = model(parent(j))* · model(j), and the loop
//! that writes locals of any form to memory as motions.

use super::locals::{Locals, Pass};
use super::plain::MANY;
#[cfg(feature = "rayon")]
use super::run::grain;
use super::run::{JointSlot, Run};
use crate::backend::Kernel;
#[cfg(feature = "rayon")]
use crate::backend::Rows;
use crate::batch;
use crate::storage::{Element, Layout, Register, Source, Tile, identity, motions};
use dq8_simd::{Lanes, Level, MAX_LANES, Records};

pub(super) struct Backward<'r, 's, E: Element<8>> {
    pub(super) run: &'r Run<'r, E>,
    pub(super) models: Source<'s, E>,
    pub(super) locals: &'s mut [E],
}

impl<E: Element<8>> Kernel for Backward<'_, '_, E> {
    type Output = ();
    const WIDE: bool = E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { run, models, locals } = self;
        let joints = run.parents.len().max(1);
        for (instance, locals) in locals.chunks_exact_mut(joints).enumerate() {
            let first = instance * joints;
            let Some(models) = models.part(first..first + joints) else { return };
            if E::Layout::transposes::<V>() {
                run.locals_of_plain(level, models, locals, instance);
            } else {
                run.locals_of_block(level, models, locals, instance);
            }
        }
    }
}

impl<E: Element<8>> Backward<'_, '_, E> {
    /// Computes the locals on the threads of the backend.
    #[inline]
    pub(super) fn on_threads(self) {
        #[cfg(feature = "rayon")]
        if self.run.many() {
            let Self { run, models, locals } = self;
            let joints = run.parents.len();
            let all = (locals, joints);
            return run.backend.share(grain(joints), all, &|first, (locals, _): Rows<'_, E>| {
                let range = first..first + locals.len() / joints;
                let joints_of = range.start * joints..range.end * joints;
                let Some(models) = models.part(joints_of) else { return };
                run.backend.run(Backward { run: &run.part(range), models, locals });
            });
        }
        self.run.backend.run(self);
    }
}

impl<E: Element<8>> Run<'_, E> {
    /// Computes the locals of one block, whose lanes are instances. On targets without SIMD it
    /// computes the locals of one instance in a plain slice.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn locals_of_block<V: Level>(
        &self,
        level: V,
        models: Source<'_, E>,
        locals: &mut [E],
        instance: usize,
    ) {
        for joint in self.joints.clone().rev() {
            for register in 0..E::Layout::registers::<V>() {
                let tile = Tile::at(joint, register);
                let models = models.or(locals);
                let Some(&parent) = self.parents.get(joint) else { return };
                let Some(mut local) = motions(level, models, tile) else { return };
                // The parent of a root is `ROOT`. This index is beyond all models, so the load
                // returns `None`.
                let parent = motions(level, models, Tile::at(parent as usize, register));
                let parent = match parent {
                    Some(parent) => Some(parent),
                    None => self.root.load(level, instance, register),
                };
                if let Some(parent) = parent {
                    local = parent.conjugate() * local;
                }
                E::store(local.to_array(), locals, tile);
            }
        }
    }

    /// Computes the locals of one instance in a plain slice. Lanes are joints; the models of their
    /// parents are gathered one by one.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn locals_of_plain<V: Level>(
        &self,
        level: V,
        models: Source<'_, E>,
        locals: &mut [E],
        instance: usize,
    ) {
        let root = self.root_of(instance);
        let lanes = E::Layout::records::<V>();
        let nothing = root.unwrap_or(identity());
        // The models of the joints and of their parents are copied to the two halves of one array.
        // If they were two arrays with the same initial values, the compiler would call `memcpy` to
        // initialise the second from the first.
        let mut both = [nothing; 2 * MAX_LANES];
        let (own, parents) = both.split_at_mut(MAX_LANES);
        let mut end = self.joints.end;
        while end > self.joints.start {
            let start = end.saturating_sub(lanes).max(self.joints.start);
            // The models of the joints and of their parents are copied before any local is written,
            // because in place each local overwrites the model of its joint, which may be the
            // parent of another of these joints.
            let Some(from) = E::plain(models.or(locals)) else { return };
            for (joint, (own, parent)) in (start..end).zip(own.iter_mut().zip(&mut *parents)) {
                let (Some(model), Some(&of)) = (from.get(joint), self.parents.get(joint)) else {
                    return;
                };
                *own = *model;
                *parent = *from.get(of as usize).unwrap_or(&nothing);
            }
            let model = batch::DualQuat::<Register<E, V, 8>>::load_records(level, own);
            let parent = batch::DualQuat::load_records(level, parents);
            let local = (parent.conjugate() * model).to_array();
            Register::<E, V, 8>::store_records(local, own);
            let Some(locals) = E::plain_mut(locals) else { return };
            for (local, own) in locals.get_mut(start..end).unwrap_or_default().iter_mut().zip(&*own)
            {
                *local = *own;
            }
            end = start;
        }
    }
}

/// The loop that writes locals as motions: poses(j) = local(j). In blocks, and in plain slices if
/// the locals are computed, lanes are instances. There are two reasons: clips and layers compute a
/// batch of joints at a time, and the joints of a small skeleton would fill few registers, the last
/// of them only partly. For locals in memory, and for the last instances, which do not fill all
/// lanes, lanes are joints of one instance. This is possible because no joint waits for another
/// here, and quick because the joints of one instance adjoin in memory. Both ways give the same
/// bits.
pub(super) struct Write<'r, 's, E: Element<8>, L> {
    pub(super) run: &'r Run<'r, E>,
    pub(super) locals: L,
    pub(super) poses: &'s mut [E],
}

impl<E: Element<8>, L: Locals<E>> Kernel for Write<'_, '_, E, L> {
    type Output = ();
    const WIDE: bool = E::Layout::WIDE || L::COMPUTED;
    // If the locals are computed and the motions are plain, the loop transposes. On CPUs that
    // shuffle 512 bits as quickly as 256 bits, AVX-512 then takes a fifth to a quarter less time
    // than AVX2.
    const SHUFFLES: bool = !E::Layout::WIDE && L::COMPUTED;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { run, locals, poses } = self;
        let joints = run.parents.len();
        let lanes = Register::<E, V, 8>::LANES;
        let instances = poses.len().checked_div(joints).unwrap_or(0);
        let pass = Pass { level, run, locals };
        let mut batch = pass.batch();
        let mut instance = 0;
        if const { MANY && L::COMPUTED && E::Layout::THINGS == 1 } {
            while instances - instance >= lanes {
                for joint in run.joints.clone() {
                    let slot = JointSlot::of_instances(joint, instance, joints);
                    if pass.write(&mut batch, poses, slot).is_none() {
                        return;
                    }
                }
                instance += lanes;
            }
        }
        for instance in instance..instances {
            for register in 0..E::Layout::registers::<V>() {
                for joint in run.joints.clone().step_by(E::Layout::records::<V>()) {
                    let slot = if const { E::Layout::THINGS > 1 } {
                        let first = instance * E::Layout::THINGS + register * lanes;
                        JointSlot::in_block(joint, instance * joints, register, first)
                    } else {
                        JointSlot::of_joints(joint, instance, joints, run.joints.end)
                    };
                    if pass.write(&mut batch, poses, slot).is_none() {
                        return;
                    }
                }
            }
        }
    }
}

impl<E: Element<8>, L: Locals<E>> Write<'_, '_, E, L> {
    /// Writes the poses on the threads of the backend.
    #[inline]
    pub(super) fn on_threads(self) {
        #[cfg(feature = "rayon")]
        if self.run.many() {
            let Self { run, locals, poses } = self;
            let joints = run.parents.len();
            let all = (poses, joints);
            return run.backend.share(grain(joints), all, &|first, (poses, _): Rows<'_, E>| {
                let range = first..first + poses.len() / joints;
                let (run, locals) = (&run.part(range.clone()), locals.part(joints, range));
                run.backend.run(Write { run, locals, poses });
            });
        }
        self.run.backend.run(self);
    }
}
