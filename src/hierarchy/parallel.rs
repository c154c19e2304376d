//! Crowds and chains over all cores (feature `rayon`): whole instances, or segments of a chain, to each
//! task.

use super::Pose;
use super::job::{Job, Root};
use super::locals::{InPlace, Motions};
use crate::dispatch::Backend;
use crate::error::ShapeError;
use crate::real::Real;
use crate::scalar::DualQuat;
use dq8_simd::Float;
use rayon::prelude::*;

/// How many elements a task has at least: some microseconds of work, where starting a task takes a
/// fraction of one.
const GRAIN: usize = 2048;

impl<P: Pose + Send + Sync> Job<'_, P>
where
    P::Real: Send + Sync,
{
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
    pub fn par_local_to_model(&self, locals: &[P], models: &mut [P]) -> Result<(), ShapeError> {
        self.check_locals(&Motions(locals), models.len())?;
        let task = self.task();
        let tasks = models.par_chunks_mut(task).zip(locals.par_chunks(task)).enumerate();
        tasks.try_for_each(|(i, (models, locals))| {
            self.part_of(i, task, models.len()).local_to_model(locals, models)
        })
    }

    /// [`local_to_model_in_place`](Self::local_to_model_in_place) on all threads of rayon's current
    /// pool. Every bit of the result is the same.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `poses` is untouched.
    pub fn par_local_to_model_in_place(&self, poses: &mut [P]) -> Result<(), ShapeError> {
        self.check_locals(&InPlace, poses.len())?;
        let task = self.task();
        let tasks = poses.par_chunks_mut(task).enumerate();
        tasks.try_for_each(|(i, poses)| {
            self.part_of(i, task, poses.len()).local_to_model_in_place(poses)
        })
    }

    /// How many elements a task has: whole instances.
    fn task(&self) -> usize {
        let joints = self.hierarchy.joints().max(1);
        GRAIN.next_multiple_of(joints)
    }

    /// The same job for the instances of task `i`.
    fn part_of(&self, i: usize, task: usize, length: usize) -> Self {
        let joints = self.hierarchy.joints().max(1);
        let first = i * task / joints;
        let root = match self.root {
            Root::Each(roots) => Root::Each(&roots[first..first + length / joints]),
            Root::None | Root::Same(_) => self.root.clone(),
        };
        Self { root, ..self.clone() }
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
    pub fn par_chain_products_in_place<R: Real + Float>(self, links: &mut [DualQuat<R>]) {
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
