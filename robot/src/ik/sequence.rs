//! Clips: many frames, each from the one before.

use super::job::ReachJob;
use super::report::{Options, Report};
use super::scratch::enough;
use super::search::Work;
use dq8::scalar::DualQuat;
#[cfg(feature = "rayon")]
use dq8::seams::Outputs;
use dq8::storage::same_length;
use dq8::{Scalar, ShapeError};
#[cfg(feature = "alloc")]
#[cfg(feature = "rayon")]
use dq8_simd::MAX_LANES;

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
