//! The methods that search: for one configuration, for many configurations, and for clips of
//! frames.
//!
//! Each method checks the lengths of its slices once and collects the slices in a [`Work`], which a
//! [`Search`] reads.

use super::model::Model;
use super::problem::Reach;
use super::report::{Options, Report, Settings, Tracking};
use super::scratch::check_scratch;
use super::search::{Lane, Search, Work};
use dq8::internal::Choice;
#[cfg(feature = "rayon")]
use dq8::internal::Outputs;
#[cfg(feature = "alloc")]
use dq8::internal::Rows;
use dq8::scalar::DualQuat;
use dq8::storage::same_length;
use dq8::{Backend, Kernel, Scalar, ShapeError};
use dq8_simd::{Lanes, Level, MAX_LANES, Portable};

impl<R> Reach<'_, R>
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    /// Changes the values of one configuration until each goal is at its target: `targets[i]`
    /// belongs to `goals[i]`. Nothing is allocated. `scratch` must have at least the length
    /// [`scratch_len`](Self::scratch_len), and may have any content.
    ///
    /// Targets are normalized. The outcome is [`Outcome::Invalid`](super::Outcome::Invalid), and
    /// `values` is untouched, if a target is farther than 10⁻³ from unit, an option is out of
    /// its range, or a target or a value is not finite. Values of joints that move no goal are not
    /// checked.
    ///
    /// Each iteration is a damped step within the limits. If a goal asks for a whole pose, the step
    /// also uses second derivatives. If two steps in a row hardly reduce the error, or limits stop
    /// all progress, the search begins again from another configuration ([`Options::restarts`]).
    /// Each restart compares new configurations that are spread evenly within the limits, and
    /// begins at the configuration nearest to the targets. The report has the largest errors at the
    /// returned values, over all goals. Components without a weight do not count.
    ///
    /// The result stays near a good start. To follow a target that moves, pass the values of the
    /// previous call as the start, and set `restarts` to false.
    ///
    /// # Errors
    /// If there are not as many targets as goals, if `values` does not have the length of a
    /// configuration, or if `scratch` is too short; `values` is untouched.
    pub fn solve(
        &self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        scratch: &mut [R],
        options: &Options<R>,
    ) -> Result<Report<R>, ShapeError> {
        self.search::<true, false>(targets, values, scratch, options.into())
    }

    /// Solves as [`solve`](Self::solve) does, but without [restarts](Options::restarts), even if
    /// the options ask for them. It is meant for a target that moves, with the values of the
    /// previous call as the start. A program that calls no other search does not contain the code
    /// of restarts, which saves a third of the code.
    ///
    /// # Errors
    /// The errors of [`solve`](Self::solve).
    pub fn follow(
        &self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        scratch: &mut [R],
        options: &Options<R>,
    ) -> Result<Report<R>, ShapeError> {
        self.search::<false, false>(targets, values, scratch, options.into())
    }

    /// Follows moving targets of many goals. Steps are of first order. If the goals have more than
    /// six components, steps solve sparse normal equations, in which an entry is nonzero only if
    /// one joint carries the other, or a joint that mimics either of them does. This takes a fifth
    /// of the time or less. The length that weighs
    /// as much as a radian does not depend on the position of a floating joint (see
    /// [`Options::length_per_radian`]). Unless a posture or the start has a weight, steps are
    /// damped by half of the squared error, averaged over the goals (λ² = ½|e|², Sugihara
    /// 2011). The search returns its final values and not its best values, so an arm keeps
    /// following a moving target even while the target is out of reach. With the option
    /// [`steady`](Tracking::steady) it stands still where steps gain too little.
    /// [`ReachJob::sequence`](super::ReachJob::sequence) tracks targets in clips, on lanes.
    ///
    /// # Errors
    /// The errors of [`solve`](Self::solve).
    pub fn track(
        &self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        scratch: &mut [R],
        options: &Tracking<R>,
    ) -> Result<Report<R>, ShapeError> {
        self.search::<false, true>(targets, values, scratch, options.into())
    }

    #[inline]
    fn search<const RESTARTS: bool, const TRACK: bool>(
        &self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        scratch: &mut [R],
        settings: Settings<'_, R>,
    ) -> Result<Report<R>, ShapeError> {
        let mut reports = [Report::default()];
        let work = Work { targets, values, reports: &mut reports, settings, clips: None };
        let work = work.checked(self)?;
        check_scratch(scratch.len(), self.scratch_len())?;
        if let Some(model) = Model::<R, TRACK>::new(Portable, self, work.settings, scratch) {
            Search::new(model, work, &mut [Lane::IDLE]).run::<RESTARTS>();
        }
        let [report] = reports;
        Ok(report)
    }
}

impl<R: Copy> Work<'_, R> {
    /// Returns `self` if the lengths of all slices fit each other and the problem, and otherwise an
    /// error.
    fn checked(self, reach: &Reach<'_, R>) -> Result<Self, ShapeError> {
        let configurations = self.reports.len();
        let (goals, values) = (reach.goals.len(), reach.mechanism.values);
        if let Some(clips) = self.clips {
            let frames = clips.iter().fold(0, |frames: usize, &count| frames.saturating_add(count));
            same_length("frames of clips", frames, configurations)?;
        }
        same_length("targets", self.targets.len(), configurations.saturating_mul(goals))?;
        same_length("values", self.values.len(), configurations.saturating_mul(values))?;
        Ok(self)
    }
}

/// A search for many configurations, as many at a time as there are lanes. All its options have a
/// default.
///
/// A lane that is done takes the next configuration. The result of a configuration does not depend
/// on the other configurations. Debug builds need a deep stack: see [the
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
    /// Returns a search for many configurations.
    pub fn job(self) -> ReachJob<'a, R> {
        ReachJob { reach: self, choice: Choice::default() }
    }
}

impl<R> ReachJob<'_, R> {
    dq8::internal::options!();
}

impl<R: Scalar> ReachJob<'_, R> {
    /// Solves many configurations as [`Reach::solve`] solves one configuration. Allocates scratch
    /// of the length [`batch_scratch_len`](Reach::batch_scratch_len) for each task that runs at the
    /// same time.
    ///
    /// `targets` is `[configuration][goal]`, `values` is `[configuration][value]`, and there is a
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
        let (scratch, settings) = (self.reach.batch_scratch_len(), options.into());
        let work = Work { targets, values, reports, settings, clips: None }.checked(&self.reach)?;
        let Work { values, reports, .. } = work;
        let backend = self.choice.instructions();
        let (goals, count) = (self.reach.goals.len(), self.reach.mechanism.values);
        let (grain, outputs) = (grain(reports.len()), ((reports, 1), (values, count)));
        let run = |first, ((reports, _), (values, _)): (Rows<Report<R>>, Rows<R>)| {
            let targets = targets.get(first * goals..).unwrap_or_default();
            let work = Work { targets, values, reports, settings, clips: None };
            self.run::<true, false>(backend, work, &mut alloc::vec![R::ZERO; scratch]);
        };
        backend.share(grain, outputs, &run);
        Ok(())
    }

    /// Solves as [`solve`](Self::solve) does, without allocation and on the calling thread.
    /// `scratch` must have at least the length [`batch_scratch_len`](Reach::batch_scratch_len), and
    /// may have any content.
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
        let settings = options.into();
        let work = Work { targets, values, reports, settings, clips: None }.checked(&self.reach)?;
        check_scratch(scratch.len(), self.reach.batch_scratch_len())?;
        self.run::<true, false>(self.choice.instructions(), work, scratch);
        Ok(())
    }

    /// Runs the searches of `work`, whose lengths have been checked.
    pub(super) fn run<const RESTARTS: bool, const TRACK: bool>(
        &self,
        backend: Backend,
        work: Work<'_, R>,
        scratch: &mut [R],
    ) {
        backend.run(Batch::<R, RESTARTS, TRACK> { reach: &self.reach, work, scratch });
    }
}

/// Returns the number of configurations of a task. Some searches take ten times as long as others,
/// so there are four tasks per thread, and a thread that ends early takes another task. At the end
/// of a task some lanes are idle, so a task is not small either.
#[cfg(feature = "alloc")]
fn grain(configurations: usize) -> usize {
    #[cfg(feature = "rayon")]
    let threads = rayon::current_num_threads();
    #[cfg(not(feature = "rayon"))]
    let threads = 1;
    configurations.div_ceil(4 * threads).clamp(64, 1024)
}

/// The kernel of searches for many configurations.
struct Batch<'s, R, const RESTARTS: bool, const TRACK: bool> {
    reach: &'s Reach<'s, R>,
    work: Work<'s, R>,
    scratch: &'s mut [R],
}

impl<R: Scalar, const RESTARTS: bool, const TRACK: bool> Kernel for Batch<'_, R, RESTARTS, TRACK> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { reach, work, scratch } = self;
        if let Some(model) = Model::<R::Lanes<V>, TRACK>::new(level, reach, work.settings, scratch)
        {
            Search::new(model, work, &mut [Lane::IDLE; MAX_LANES]).run::<RESTARTS>();
        }
    }
}

impl<R: Scalar> ReachJob<'_, R> {
    /// Tracks targets in clips of frames; `clips` has the number of frames of each clip. Each frame
    /// starts from the result of the previous frame. The first frame of a clip starts from its own
    /// entry in `values`; the entries of the other frames may have any content. A lane computes a
    /// clip and then takes the next clip, so clips may have any lengths. If there are at least as
    /// many clips as lanes, no lane is idle until the last clips. Each frame is one call of
    /// [`Reach::track`](super::Reach::track). A frame with an invalid target keeps the values of
    /// the frame before it, and is reported as [`Invalid`](super::Outcome::Invalid).
    ///
    /// `targets` is `[frame][goal]`, `values` is `[frame][value]`, and there is a report for each
    /// frame. Allocates scratch of the length
    /// [`batch_scratch_len`](super::Reach::batch_scratch_len) for each task that runs at the same
    /// time. For a single clip, one call of `track` per frame is quicker.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::ik::{Goal, OwnedReach, Report, Tracking};
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// let out = DualQuat::from_translation([1.0_f64, 0.0, 0.0]);
    /// let joints = [(None, DualQuat::IDENTITY), (Some(0), out), (Some(1), out)]
    ///     .map(|(on, at)| Joint::revolute(on, at, [0.0, 0.0, 1.0]));
    /// let reach = OwnedReach::new(OwnedMechanism::new(&joints)?, [Goal::position(2)])?;
    /// // Two clips, of 30 and 20 frames, along a line.
    /// let along = |frame: usize| DualQuat::from_translation([1.5, 0.01 * frame as f64, 0.0]);
    /// let targets: Vec<_> = (0..30).chain(0..20).map(along).collect();
    /// let (mut values, mut reports) = (vec![0.3; 150], vec![Report::default(); 50]);
    /// reach.job().sequence(&[30, 20], &targets, &mut values, &mut reports, &Tracking::default())?;
    /// // Both clips are the same as far as the shorter one goes.
    /// assert_eq!(values[..60], values[90..]);
    /// assert!(reports[29].linear_error < 0.01);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If the slices and the clips hold different numbers of frames; nothing is written.
    #[cfg(feature = "alloc")]
    pub fn sequence(
        &self,
        clips: &[usize],
        targets: &[DualQuat<R>],
        values: &mut [R],
        reports: &mut [Report<R>],
        options: &Tracking<R>,
    ) -> Result<(), ShapeError> {
        let scratch = self.reach.batch_scratch_len();
        let work = Work { targets, values, reports, settings: options.into(), clips: Some(clips) };
        let Work { values, reports, .. } = work.checked(&self.reach)?;
        let backend = self.choice.instructions();
        let goals = self.reach.goals.len();
        let run = |first, part: Clips<'_, R>| {
            let before: usize = clips.iter().take(first).sum();
            let targets = targets.get(before * goals..).unwrap_or_default();
            let Clips { clips, values, reports } = part;
            let work =
                Work { targets, values, reports, settings: options.into(), clips: Some(clips) };
            self.run::<false, true>(backend, work, &mut alloc::vec![R::ZERO; scratch]);
        };
        let all = Clips { clips, values, reports };
        // This tests the feature of this crate and not dq8's, because another crate may switch on
        // threads in dq8.
        #[cfg(feature = "rayon")]
        backend.share(MAX_LANES, all, &run);
        #[cfg(not(feature = "rayon"))]
        run(0, all);
        Ok(())
    }

    /// Tracks targets in clips as [`sequence`](Self::sequence) does, without allocation and on the
    /// calling thread. `scratch` must have at least the length
    /// [`batch_scratch_len`](super::Reach::batch_scratch_len), and may have any content.
    ///
    /// # Errors
    /// The errors of [`sequence`](Self::sequence), and an error if `scratch` is too short. Nothing
    /// is written then.
    pub fn sequence_in(
        &self,
        scratch: &mut [R],
        clips: &[usize],
        targets: &[DualQuat<R>],
        values: &mut [R],
        reports: &mut [Report<R>],
        options: &Tracking<R>,
    ) -> Result<(), ShapeError> {
        let work = Work { targets, values, reports, settings: options.into(), clips: Some(clips) };
        let work = work.checked(&self.reach)?;
        check_scratch(scratch.len(), self.reach.batch_scratch_len())?;
        self.run::<false, true>(self.choice.instructions(), work, scratch);
        Ok(())
    }
}

/// Clips, with the values and reports of their frames. Threads share the work in runs of whole
/// clips.
#[cfg(feature = "alloc")]
struct Clips<'s, R> {
    clips: &'s [usize],
    values: &'s mut [R],
    reports: &'s mut [Report<R>],
}

#[cfg(feature = "rayon")]
impl<R: Send> Outputs for Clips<'_, R> {
    fn things(&self) -> usize {
        self.clips.len()
    }

    fn split(self, at: usize) -> (Self, Self) {
        let Self { clips, values, reports } = self;
        let size = values.len().checked_div(reports.len()).unwrap_or(0);
        let (before, after) = clips.split_at(at.min(clips.len()));
        let frames = before.iter().sum::<usize>().min(reports.len());
        let (values, others) = values.split_at_mut(frames * size);
        let (reports, later) = reports.split_at_mut(frames);
        let first = Self { clips: before, values, reports };
        (first, Self { clips: after, values: others, reports: later })
    }
}
