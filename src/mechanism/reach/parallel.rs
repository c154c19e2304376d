//! Many configurations on all cores (feature `rayon`).

use super::problem::Reach;
use super::report::{Options, Report};
use super::search::Work;
use crate::dispatch::Backend;
use crate::real::Scalar;
use crate::scalar::DualQuat;
use crate::shape::ShapeError;
use alloc::vec;
use rayon::prelude::*;

/// How many tasks a thread has: some searches take ten times as long as others.
const TASKS: usize = 4;
/// How many configurations a task has. The last of them leave lanes idle, so few are a waste; many are
/// left over for one thread.
const FEW: usize = 64;
const MANY: usize = 1024;

impl Backend {
    /// [`reach_links`](Self::reach_links) on all threads of rayon's current pool, which allocates its scratch
    /// for each of them. Every bit of the result is the same.
    ///
    /// # Errors
    /// If the slices hold different numbers of configurations; nothing is written.
    ///
    /// ```
    /// use dq8::ik::{Options, Outcome, Report};
    /// use dq8::mechanism::{Freedom, Goal, Joint, OwnedMechanism, Reach};
    /// use dq8::{Backend, DualQuat};
    /// let out = DualQuat::from_translation([1.0_f32, 0.0, 0.0]);
    /// let joints = [(None, DualQuat::IDENTITY), (Some(0), out), (Some(1), out)]
    ///     .map(|(on, at)| Joint::revolute(on, at, [0.0, 0.0, 1.0]));
    /// let arm = OwnedMechanism::new(&joints)?;
    /// let (goals, mut freedoms) = ([Goal::position(2)], [Freedom::default(); 3]);
    /// let reach = Reach::new(arm.view(), &goals, &mut freedoms)?;
    /// let targets: Vec<_> =
    ///     (0..1000).map(|i| DualQuat::from_translation([1.5, 0.001 * i as f32, 0.0])).collect();
    /// let mut values = vec![0.3; 3000];
    /// let mut reports = vec![Report::default(); 1000];
    /// let options = Options::default();
    /// Backend::best().par_reach_links(&reach, &targets, &mut values, &mut reports, &options)?;
    /// assert!(reports.iter().all(|report| report.outcome == Outcome::Converged));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn par_reach_links<R: Scalar>(
        self,
        reach: &Reach<'_, R>,
        targets: &[DualQuat<R>],
        values: &mut [R],
        reports: &mut [Report<R>],
        options: &Options<R>,
    ) -> Result<(), ShapeError> {
        let room = reach.batch_scratch_len();
        let work = Work { targets, values, reports, options };
        work.check(reach, room, room)?;
        let Work { targets, values, reports, options } = work;
        let scratch = || vec![R::ZERO; room];
        let (goals, count) = (reach.goals.len(), reach.mechanism.values);
        if count == 0 {
            return self.reach_links(reach, targets, values, reports, &mut scratch(), options);
        }
        let tasks = TASKS * rayon::current_num_threads();
        let task = reports.len().div_ceil(tasks).clamp(FEW, MANY);
        let (targets, values) =
            (targets.par_chunks(task * goals), values.par_chunks_mut(task * count));
        let tasks = reports.par_chunks_mut(task).zip(values).zip(targets);
        tasks.try_for_each_init(scratch, |scratch, ((reports, values), targets)| {
            self.reach_links(reach, targets, values, reports, scratch, options)
        })
    }
}
