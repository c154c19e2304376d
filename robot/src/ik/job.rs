//! Searches as callers ask for them: one configuration, many, and clips of frames.
//!
//! All of them check lengths, and hand [`Work`] to a [`Search`](super::search::Search).

use super::model::Model;
use super::problem::Reach;
use super::report::{Options, Report};
use super::scratch::enough;
use super::search::{Lane, Search, Work};
use dq8::scalar::DualQuat;
use dq8::seams::Choice;
#[cfg(feature = "rayon")]
use dq8::seams::Outputs;
#[cfg(feature = "alloc")]
use dq8::seams::Rows;
use dq8::storage::same_length;
use dq8::{Backend, Kernel, Scalar, ShapeError};
use dq8_simd::{Lanes, Level, MAX_LANES, Portable};

impl<R> Reach<'_, R>
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    /// Moves one configuration from `values` until each goal is at its target: `targets[i]` belongs
    /// to `goals[i]`. Without allocation; `scratch` has [`scratch_len`](Self::scratch_len) numbers
    /// or more, and may hold anything.
    ///
    /// Targets are normalized; farther than 10⁻³ from unit they are
    /// [`Outcome::Invalid`](super::Outcome::Invalid), and so are numbers that are not finite, but
    /// for values of joints that move no goal, and options that are none: `values` is untouched
    /// then.
    ///
    /// Each iteration is a damped step within the limits, of second order where a goal asks for the
    /// whole pose. Where two steps in a row do not lead much nearer, or limits leave no way nearer,
    /// the search begins again from another configuration ([`Options::restarts`]), the nearest to
    /// the targets of some that are spread evenly within the limits; each restart draws others.
    /// What is reported is the error at the values that are returned; of several goals the largest,
    /// of components that are asked for.
    ///
    /// A good start is kept to: to follow a target that moves, start from the last values, and set
    /// `restarts` to false.
    ///
    /// # Errors
    /// If there are not as many targets as goals and values as the mechanism has, or too little
    /// scratch; `values` is untouched.
    pub fn solve(
        &self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        scratch: &mut [R],
        options: &Options<R>,
    ) -> Result<Report<R>, ShapeError> {
        self.search::<true, false>(targets, values, scratch, options)
    }

    /// [`solve`](Self::solve) without [restarts](Options::restarts), whatever the options say: for
    /// a target that moves, from the last values. It needs no more than that of a program, so that
    /// a controller holds a third less code.
    ///
    /// # Errors
    /// As [`solve`](Self::solve).
    pub fn follow(
        &self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        scratch: &mut [R],
        options: &Options<R>,
    ) -> Result<Report<R>, ShapeError> {
        let options = Options { restarts: false, ..*options };
        self.search::<false, false>(targets, values, scratch, &options)
    }

    /// [`follow`](Self::follow) for many goals: steps are of first order, and of more than a pose
    /// by normal equations that have the shape of the tree, in a fifth of the time or less; and
    /// where a length per radian is not [given](Options::length_per_radian), weights stay what they
    /// are however far something that floats has gone. Steps are damped by half of the squared
    /// error (λ² = ½|e|², Sugihara 2011; of many goals, of its mean), unless a posture or the
    /// start weighs, and the last one is what is returned: in front of a target that it cannot
    /// reach, an arm goes on with the target in every frame. [`Options::track`] is made for it,
    /// [`ReachJob::sequence`](super::ReachJob::sequence) does it for clips on lanes.
    ///
    /// # Errors
    /// As [`solve`](Self::solve).
    pub fn track(
        &self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        scratch: &mut [R],
        options: &Options<R>,
    ) -> Result<Report<R>, ShapeError> {
        let options = Options { restarts: false, ..*options };
        self.search::<false, true>(targets, values, scratch, &options)
    }

    #[inline]
    fn search<const AGAIN: bool, const TRACK: bool>(
        &self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        scratch: &mut [R],
        options: &Options<R>,
    ) -> Result<Report<R>, ShapeError> {
        let mut reports = [Report::default()];
        let work = Work { targets, values, reports: &mut reports, options, clips: None };
        work.check(self)?;
        enough(scratch.len(), self.scratch_len())?;
        if let Some(model) = Model::<R, TRACK>::new(Portable, self, work.options, scratch) {
            Search::new(model, work, &mut [Lane::IDLE]).run::<AGAIN>();
        }
        let [report] = reports;
        Ok(report)
    }
}

impl<R: Copy> Work<'_, R> {
    pub(super) fn check(&self, reach: &Reach<'_, R>) -> Result<(), ShapeError> {
        let configurations = self.reports.len();
        let (goals, values) = (reach.goals.len(), reach.mechanism.values);
        same_length("targets", self.targets.len(), configurations.saturating_mul(goals))?;
        same_length("values", self.values.len(), configurations.saturating_mul(values))
    }
}

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

impl<R: Scalar> ReachJob<'_, R> {
    /// Clips of frames, one after the other: `clips` says how many frames each has. Each frame
    /// starts from the values that the one before ended with, the first of a clip from what
    /// `values` holds there; that of the others may be anything. A lane holds a clip and goes on to
    /// the next one when it is done, so clips may have any lengths; with as many clips as there are
    /// lanes, or more, all of the CPU is used. Each frame is one call of
    /// [`Reach::track`](super::Reach::track), without restarts. A frame whose targets are none
    /// keeps the values of the one before, and is [`Invalid`](super::Outcome::Invalid).
    ///
    /// `targets` is `[frame][goal]`, `values` `[frame][value]`, and there is a report for each
    /// frame. Allocates [`batch_scratch_len`](super::Reach::batch_scratch_len) numbers for each
    /// task that runs at the same time. [`Options::track`] is made for it. For a single clip,
    /// `track` once a frame is quicker.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::ik::{Goal, Options, OwnedReach, Report};
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// let out = DualQuat::from_translation([1.0_f64, 0.0, 0.0]);
    /// let joints = [(None, DualQuat::IDENTITY), (Some(0), out), (Some(1), out)]
    ///     .map(|(on, at)| Joint::revolute(on, at, [0.0, 0.0, 1.0]));
    /// let reach = OwnedReach::new(OwnedMechanism::new(&joints)?, [Goal::position(2)])?;
    /// // Two clips, of 30 and 20 frames, along a line.
    /// let along = |frame: usize| DualQuat::from_translation([1.5, 0.01 * frame as f64, 0.0]);
    /// let targets: Vec<_> = (0..30).chain(0..20).map(along).collect();
    /// let (mut values, mut reports) = (vec![0.3; 150], vec![Report::default(); 50]);
    /// reach.job().sequence(&[30, 20], &targets, &mut values, &mut reports, &Options::track())?;
    /// // Both begin alike, and so go on.
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
        options: &Options<R>,
    ) -> Result<(), ShapeError> {
        let scratch = self.reach.batch_scratch_len();
        let options = &Options { restarts: false, ..*options };
        check(clips, reports.len())?;
        Work { targets, values, reports, options, clips: Some(clips) }.check(&self.reach)?;
        let backend = self.choice.instructions();
        let goals = self.reach.goals.len();
        let run = |first, part: Clips<'_, R>| {
            let before: usize = clips.iter().take(first).sum();
            let targets = targets.get(before * goals..).unwrap_or_default();
            let Clips { clips, values, reports } = part;
            let work = Work { targets, values, reports, options, clips: Some(clips) };
            self.run::<false, true>(backend, work, &mut alloc::vec![R::ZERO; scratch]);
        };
        let all = Clips { clips, values, reports };
        // Not the feature of dq8: another crate may ask that for threads.
        #[cfg(feature = "rayon")]
        backend.share(MAX_LANES, all, &run);
        #[cfg(not(feature = "rayon"))]
        run(0, all);
        Ok(())
    }

    /// [`sequence`](Self::sequence) in memory of the caller, without allocation, on the thread that
    /// calls: `scratch` has [`batch_scratch_len`](super::Reach::batch_scratch_len) numbers or more,
    /// and may hold anything.
    ///
    /// # Errors
    /// As there, or if there is too little scratch; nothing is written.
    pub fn sequence_in(
        &self,
        scratch: &mut [R],
        clips: &[usize],
        targets: &[DualQuat<R>],
        values: &mut [R],
        reports: &mut [Report<R>],
        options: &Options<R>,
    ) -> Result<(), ShapeError> {
        let options = &Options { restarts: false, ..*options };
        let work = Work { targets, values, reports, options, clips: Some(clips) };
        check(clips, work.reports.len())?;
        work.check(&self.reach)?;
        enough(scratch.len(), self.reach.batch_scratch_len())?;
        self.run::<false, true>(self.choice.instructions(), work, scratch);
        Ok(())
    }
}

/// Whether clips have as many frames as there are.
fn check(clips: &[usize], frames: usize) -> Result<(), ShapeError> {
    let all = clips.iter().fold(0, |all: usize, &count| all.saturating_add(count));
    same_length("frames of clips", all, frames)
}

/// What clips write, cut between two.
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
