//! Many configurations on all cores (feature `rayon`): whole groups of lanes to each task.

use super::frame::JacobianFrame;
use super::tree::Mechanism;
use super::values::JointValues;
use crate::dispatch::Backend;
use crate::shape::{ShapeError, same_length};
use crate::storage::{Element, Number};
use rayon::prelude::*;

/// How many elements a task has, about: some microseconds of work, where starting a task takes a fraction
/// of one.
const GRAIN: usize = 2048;

/// How many configurations, or blocks of them, a task has: a multiple of the most lanes.
fn grain(links: usize) -> usize {
    GRAIN.div_ceil(links.max(1)).next_multiple_of(dq8_simd::MAX_LANES)
}

impl Backend {
    /// [`link_poses`](Self::link_poses) on all threads of rayon's current pool. Every bit of the result is
    /// the same.
    ///
    /// # Errors
    /// As there.
    pub fn par_link_poses<T, E>(
        self,
        mechanism: Mechanism<'_, Number<E, 8>>,
        values: &[T],
        poses: &mut [E],
    ) -> Result<(), ShapeError>
    where
        T: JointValues<E::Layout> + Sync,
        E: Element<8> + Send,
    {
        let (links, count) = (mechanism.links(), mechanism.values);
        mechanism.configurations::<E::Layout, T>(values, links, poses.len())?;
        let task = grain(links);
        poses.par_chunks_mut((task * links).max(1)).enumerate().try_for_each(|(i, poses)| {
            self.link_poses(mechanism, T::part(values, count, i * task, task), poses)
        })
    }

    /// [`chosen_link_poses`](Self::chosen_link_poses) on all threads of rayon's current pool. Every bit of
    /// the result is the same.
    ///
    /// # Errors
    /// As there.
    pub fn par_chosen_link_poses<T, E>(
        self,
        mechanism: Mechanism<'_, Number<E, 8>>,
        chosen: &[usize],
        values: &[T],
        poses: &mut [E],
    ) -> Result<(), ShapeError>
    where
        T: JointValues<E::Layout> + Sync,
        E: Element<8> + Send,
    {
        mechanism.check_links(chosen)?;
        let (links, count) = (chosen.len(), mechanism.values);
        mechanism.configurations::<E::Layout, T>(values, links, poses.len())?;
        let task = grain(mechanism.links());
        poses.par_chunks_mut((task * links).max(1)).enumerate().try_for_each(|(i, poses)| {
            self.chosen_link_poses(mechanism, chosen, T::part(values, count, i * task, task), poses)
        })
    }

    /// [`link_jacobians`](Self::link_jacobians) on all threads of rayon's current pool. Every bit of the
    /// result is the same.
    ///
    /// # Errors
    /// As there.
    pub fn par_link_jacobians<F, T, E, C>(
        self,
        frame: F,
        mechanism: Mechanism<'_, Number<E, 8>>,
        links: &[usize],
        values: &[T],
        poses: &mut [E],
        columns: &mut [C],
    ) -> Result<(), ShapeError>
    where
        F: JacobianFrame + Sync,
        T: JointValues<E::Layout> + Sync,
        E: Element<8> + Send,
        C: Element<6, Layout = E::Layout> + Send,
    {
        mechanism.check_links(links)?;
        let (count, rates) = (mechanism.values, mechanism.rates);
        mechanism.configurations::<E::Layout, T>(values, links.len(), poses.len())?;
        same_length("columns", columns.len(), poses.len() * rates)?;
        let task = grain(mechanism.links());
        if rates == 0 || links.is_empty() {
            return self.link_jacobians(frame, mechanism, links, values, poses, columns);
        }
        let columns = columns.par_chunks_mut(task * links.len() * rates);
        let tasks = poses.par_chunks_mut(task * links.len()).zip(columns).enumerate();
        tasks.try_for_each(|(i, (poses, columns))| {
            let values = T::part(values, count, i * task, task);
            self.link_jacobians(frame, mechanism, links, values, poses, columns)
        })
    }

    /// [`link_velocities`](Self::link_velocities) on all threads of rayon's current pool. Every bit of the
    /// result is the same.
    ///
    /// # Errors
    /// As there.
    pub fn par_link_velocities<T, E, C>(
        self,
        mechanism: Mechanism<'_, Number<E, 8>>,
        values: &[T],
        rates: &[T],
        poses: &mut [E],
        twists: &mut [C],
    ) -> Result<(), ShapeError>
    where
        T: JointValues<E::Layout> + Sync,
        E: Element<8> + Send,
        C: Element<6, Layout = E::Layout> + Send,
    {
        let (links, count) = (mechanism.links(), [mechanism.values, mechanism.rates]);
        let elements = mechanism.configurations::<E::Layout, T>(values, links, poses.len())?;
        T::check("rates", rates.len(), count[1], elements)?;
        same_length("twists", twists.len(), poses.len())?;
        let task = grain(links);
        let length = (task * links).max(1);
        let tasks = poses.par_chunks_mut(length).zip(twists.par_chunks_mut(length)).enumerate();
        tasks.try_for_each(|(i, (poses, twists))| {
            let values = T::part(values, count[0], i * task, task);
            let rates = T::part(rates, count[1], i * task, task);
            self.link_velocities(mechanism, values, rates, poses, twists)
        })
    }

    /// [`link_accelerations`](Self::link_accelerations) on all threads of rayon's current pool. Every bit of
    /// the result is the same.
    ///
    /// # Errors
    /// As there.
    #[allow(clippy::too_many_arguments, reason = "three slices go in and three come out")]
    pub fn par_link_accelerations<T, E, C>(
        self,
        mechanism: Mechanism<'_, Number<E, 8>>,
        values: &[T],
        rates: &[T],
        second_rates: &[T],
        poses: &mut [E],
        twists: &mut [C],
        accelerations: &mut [C],
    ) -> Result<(), ShapeError>
    where
        T: JointValues<E::Layout> + Sync,
        E: Element<8> + Send,
        C: Element<6, Layout = E::Layout> + Send,
    {
        let (links, count) = (mechanism.links(), [mechanism.values, mechanism.rates]);
        let elements = mechanism.configurations::<E::Layout, T>(values, links, poses.len())?;
        T::check("rates", rates.len(), count[1], elements)?;
        T::check("second_rates", second_rates.len(), count[1], elements)?;
        same_length("twists", twists.len(), poses.len())?;
        same_length("accelerations", accelerations.len(), poses.len())?;
        let task = grain(links);
        let length = (task * links).max(1);
        let (poses, twists) = (poses.par_chunks_mut(length), twists.par_chunks_mut(length));
        let tasks = poses.zip(twists).zip(accelerations.par_chunks_mut(length)).enumerate();
        tasks.try_for_each(|(i, ((poses, twists), accelerations))| {
            let values = T::part(values, count[0], i * task, task);
            let [rates, second] =
                [rates, second_rates].map(|rates| T::part(rates, count[1], i * task, task));
            self.link_accelerations(mechanism, values, rates, second, poses, twists, accelerations)
        })
    }
}
