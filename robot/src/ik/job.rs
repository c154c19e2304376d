//! Many configurations.

use super::lane::Lane;
use super::model::Model;
use super::problem::Reach;
use super::report::{Options, Report};
use super::scratch::enough;
use super::search::{Search, Work};
use dq8::scalar::DualQuat;
use dq8::seams::Choice;
#[cfg(feature = "alloc")]
use dq8::seams::Rows;
use dq8::{Backend, Kernel, Scalar, ShapeError};
use dq8_simd::{Level, MAX_LANES};

/// A search for many configurations, as many at a time as there are lanes, with options that all
/// have a default.
///
/// A lane that is done takes the next configuration; the result of one does not depend on the
/// others. Debug builds need a deep stack: [the
/// table](https://docs.rs/dq8/latest/dq8/guide/firmware/index.html#stack).
///
/// ```
/// use dq8::DualQuat;
/// use dq8_robot::ik::{Goal, Options, Outcome, OwnedReach, Report};
/// use dq8_robot::{Joint, OwnedMechanism};
/// let out = DualQuat::from_translation([1.0_f32, 0.0, 0.0]);
/// let joints = [(None, DualQuat::IDENTITY), (Some(0), out), (Some(1), out)]
///     .map(|(on, at)| Joint::revolute(on, at, [0.0, 0.0, 1.0]));
/// // Two angles for the position of the last link; its own angle is free, and goes to zero.
/// let reach = OwnedReach::new(OwnedMechanism::new(&joints)?, [Goal::position(2)])?;
/// let targets: Vec<_> =
///     (0..100).map(|i| DualQuat::from_translation([1.5, 0.01 * i as f32, 0.0])).collect();
/// let (mut values, mut reports) = (vec![0.3; 300], vec![Report::default(); 100]);
/// reach.job().solve(&targets, &mut values, &mut reports, &Options::default())?;
/// assert!(reports.iter().all(|report| report.outcome == Outcome::Converged));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct ReachJob<'a, R> {
    pub(super) reach: Reach<'a, R>,
    pub(super) choice: Choice,
}

impl<'a, R: Copy> Reach<'a, R> {
    /// A search for many configurations.
    pub fn job(self) -> ReachJob<'a, R> {
        ReachJob { reach: self, choice: Choice::default() }
    }
}

impl<R> ReachJob<'_, R> {
    dq8::seams::options!();
}

impl<R: Scalar> ReachJob<'_, R> {
    /// [`Reach::solve`] for many configurations. Allocates
    /// [`batch_scratch_len`](Reach::batch_scratch_len) numbers for each task that runs at the same
    /// time.
    ///
    /// `targets` is `[configuration][goal]`, `values` `[configuration][value]`, and there is a
    /// report for each configuration.
    ///
    /// # Errors
    /// If the slices hold different numbers of configurations; nothing is written.
    #[cfg(feature = "alloc")]
    pub fn solve(
        &self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        reports: &mut [Report<R>],
        options: &Options<R>,
    ) -> Result<(), ShapeError> {
        let scratch = self.reach.batch_scratch_len();
        Work { targets, values, reports, options, clips: None }.check(&self.reach)?;
        let backend = self.choice.instructions();
        let (goals, count) = (self.reach.goals.len(), self.reach.mechanism.values);
        let (grain, outputs) = (grain(reports.len()), ((reports, 1), (values, count)));
        let run = |first, ((reports, _), (values, _)): (Rows<Report<R>>, Rows<R>)| {
            let targets = targets.get(first * goals..).unwrap_or_default();
            let work = Work { targets, values, reports, options, clips: None };
            self.run::<true, false>(backend, work, &mut alloc::vec![R::ZERO; scratch]);
        };
        backend.share(grain, outputs, &run);
        Ok(())
    }

    /// [`solve`](Self::solve) in memory of the caller, without allocation, on the thread that
    /// calls: `scratch` has [`batch_scratch_len`](Reach::batch_scratch_len) numbers or more, and
    /// may hold anything.
    ///
    /// # Errors
    /// If the slices hold different numbers of configurations, or there is too little scratch;
    /// nothing is written.
    pub fn solve_in(
        &self,
        scratch: &mut [R],
        targets: &[DualQuat<R>],
        values: &mut [R],
        reports: &mut [Report<R>],
        options: &Options<R>,
    ) -> Result<(), ShapeError> {
        let work = Work { targets, values, reports, options, clips: None };
        work.check(&self.reach)?;
        enough(scratch.len(), self.reach.batch_scratch_len())?;
        self.run::<true, false>(self.choice.instructions(), work, scratch);
        Ok(())
    }

    /// What has been checked.
    pub(super) fn run<const AGAIN: bool, const TRACK: bool>(
        &self,
        backend: Backend,
        work: Work<'_, R>,
        scratch: &mut [R],
    ) {
        backend.run(Targets::<R, AGAIN, TRACK> { reach: &self.reach, work, scratch });
    }
}

/// How many configurations a task has at least. Some searches take ten times as long as others, so
/// a thread has four tasks; but the last configurations of a task leave lanes idle, so few are a
/// waste, and many are left over for one thread.
#[cfg(feature = "alloc")]
fn grain(configurations: usize) -> usize {
    #[cfg(feature = "rayon")]
    let threads = rayon::current_num_threads();
    #[cfg(not(feature = "rayon"))]
    let threads = 1;
    configurations.div_ceil(4 * threads).clamp(64, 1024)
}

/// Many configurations; lengths have been checked.
struct Targets<'s, R, const AGAIN: bool, const TRACK: bool> {
    reach: &'s Reach<'s, R>,
    work: Work<'s, R>,
    scratch: &'s mut [R],
}

impl<R: Scalar, const AGAIN: bool, const TRACK: bool> Kernel for Targets<'_, R, AGAIN, TRACK> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { reach, work, scratch } = self;
        if let Some(model) = Model::<R::Lanes<V>, TRACK>::new(level, reach, work.options, scratch) {
            Search::new(model, work, &mut [Lane::IDLE; MAX_LANES]).run::<AGAIN>();
        }
    }
}
