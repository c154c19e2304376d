//! Crowds and chains over all cores (feature `rayon`): whole instances, or segments of a chain, to each
//! task.

use super::Job;
use super::locals::{InPlace, Locals, Poses};
use super::palette::NoEpilogue;
use crate::dispatch::Backend;
use crate::palette_entry::PaletteEntry;
use crate::real::Scalar;
use crate::scalar::DualQuat;
use crate::shape::{ShapeError, same_length};
use crate::storage::{Element, Number};
use rayon::prelude::*;

/// How many elements a task has at least: some microseconds of work, where starting a task takes a
/// fraction of one.
const GRAIN: usize = 2048;

impl<'a, E: Element<8> + Send + Sync> Job<'a, E> {
    /// [`local_to_model`](Self::local_to_model) on all threads of rayon's current pool. Every bit of
    /// the result is the same.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `models` is untouched.
    ///
    /// ```
    /// use dq8::{Crowd, DualQuat, Hierarchy};
    /// let parents = [Hierarchy::ROOT, 0];
    /// let leg = Hierarchy::new(&parents)?;
    /// let down = DualQuat::from_translation([0.0_f32, -1.0, 0.0]);
    /// let locals = Crowd::<f32, 8>::from_slice(2, &[down; 1000])?;
    /// let mut models = locals.clone();
    /// leg.job().par_local_to_model(locals.blocks(), models.blocks_mut())?;
    /// assert_eq!(models.get(499, 1).unwrap().translation(), [0.0, -2.0, 0.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn par_local_to_model(&self, locals: &[E], models: &mut [E]) -> Result<(), ShapeError> {
        self.par_locals_to_model(Poses(locals), models)
    }

    /// [`local_to_model_in_place`](Self::local_to_model_in_place) on all threads of rayon's current
    /// pool. Every bit of the result is the same.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `poses` is untouched.
    pub fn par_local_to_model_in_place(&self, poses: &mut [E]) -> Result<(), ShapeError> {
        self.par_locals_to_model(InPlace, poses)
    }

    /// [`locals_to_model`](Self::locals_to_model) on all threads of rayon's current pool. Every bit of
    /// the result is the same.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `models` is untouched.
    pub fn par_locals_to_model<L: Locals<E> + Send + Sync>(
        &self,
        locals: L,
        models: &mut [E],
    ) -> Result<(), ShapeError> {
        self.check_locals(&locals, models.len())?;
        let (task, all) = (self.task(), models.len());
        models.par_chunks_mut(task).enumerate().for_each(|(i, models)| {
            let (job, locals) = self.part(locals, i * task..i * task + models.len(), all);
            job.forward(locals, models, NoEpilogue);
        });
        Ok(())
    }

    /// Models and palette: [`locals_to_palette`](Self::locals_to_palette) on all threads of rayon's current pool. Every bit
    /// of the result is the same.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `models` and `palette` are untouched.
    pub fn par_locals_to_palette<L, M, const C: usize>(
        &self,
        locals: L,
        models: &mut [E],
        inverse_binds: &[DualQuat<Number<E, 8>>],
        palette: &mut [M],
    ) -> Result<(), ShapeError>
    where
        L: Locals<E> + Send + Sync,
        M: PaletteEntry<C, Layout = E::Layout> + Send + Sync,
    {
        self.check_locals(&locals, models.len())?;
        same_length("inverse_binds", inverse_binds.len(), self.run.parents.len())?;
        same_length("palette", palette.len(), models.len())?;
        let (task, all) = (self.task(), models.len());
        let tasks = models.par_chunks_mut(task).zip(palette.par_chunks_mut(task)).enumerate();
        tasks.try_for_each(|(i, (models, palette))| {
            let (job, locals) = self.part(locals, i * task..i * task + models.len(), all);
            job.locals_to_palette(locals, models, inverse_binds, palette)
        })
    }

    /// How many elements a task has: whole instances.
    fn task(&self) -> usize {
        GRAIN.next_multiple_of(self.run.parents.len().max(1))
    }
}

impl Backend {
    /// [`chain_products_in_place`](Self::chain_products_in_place) on all threads of rayon's current
    /// pool: the products of segments, then, serially, what comes before each of them, then every
    /// product by that. Results differ in the last bits from those of one thread, as the order of
    /// multiplication does; they do not depend on the number of threads.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let mut rope = vec![DualQuat::from_translation([0.0_f32, 0.5, 0.0]); 10_000];
    /// Backend::best().par_chain_products_in_place(&mut rope);
    /// assert_eq!(rope[9_999].translation(), [0.0, 5000.0, 0.0]);
    /// ```
    pub fn par_chain_products_in_place<R: Scalar>(self, links: &mut [DualQuat<R>]) {
        let totals = links.par_chunks_mut(GRAIN).map(|segment| {
            self.chain_products_in_place(segment);
            segment.last().copied().unwrap_or_default()
        });
        let mut before: alloc::vec::Vec<_> = totals.collect();
        self.chain_products_in_place(&mut before);
        let others = links.par_chunks_mut(GRAIN).skip(1).zip(before);
        others.for_each(|(segment, before)| self.mul_left_in_place(before, segment));
    }
}
