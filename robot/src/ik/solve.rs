//! One configuration.

use super::lane::Lane;
use super::model::Model;
use super::problem::Reach;
use super::report::{Options, Report};
use super::scratch::enough;
use super::search::{Search, Work};
use dq8::scalar::DualQuat;
use dq8::storage::same_length;
use dq8::{Scalar, ShapeError};
use dq8_simd::{Lanes, Portable};

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
