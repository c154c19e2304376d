//! One target, and slices of them.

use super::{Arm, Options, Report};
use crate::dispatch::Backend;
use crate::real::Scalar;
use crate::scalar::DualQuat;
use crate::shape::ShapeError;
use dq8_simd::{Lanes, Portable};

impl<R, const N: usize> Arm<R, N>
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    /// Moves the joints from `values` until the end is at `target`, which is normalized first; farther
    /// than 10⁻³ from unit it is [`Outcome::Invalid`](crate::ik::Outcome::Invalid).
    ///
    /// Each iteration is a damped step of second order (Halley's) along the screws of the joints, with
    /// the error 2 log(target · pose*): λ² is a part of the squared error (Sugihara 2011); a joint that
    /// would leave its limits is held there and the others step again; a hinge that is within
    /// its limits a turn less goes on there, and ends where it is nearest to the start. Starts outside the limits begin
    /// whole turns away, within them, or at them. What is reported is the error of the pose at the values that are returned.
    ///
    /// Where two steps in a row do not lead much nearer, or limits leave no way nearer, the search
    /// begins again ([`Options::restarts`]) from the nearest of 128 poses of the arm, the next time from
    /// the second nearest, and so on. A restart counts as an iteration. So the solution may be another
    /// than the one next to the start; but the result is the same in every run.
    ///
    /// ```
    /// use dq8::ik::{Arm, Joint, Options, Outcome};
    /// use dq8::DualQuat;
    /// let joints = [0.0, 1.0].map(|x| Joint::revolute([0.0, 0.0, 1.0_f32], [x, 0.0, 0.0]));
    /// let arm = Arm::new(joints, DualQuat::from_translation([2.0, 0.0, 0.0]))?;
    /// let mut angles = [0.3, 0.5];
    /// // Two links of length 1 do not reach that far; they stretch.
    /// let target = DualQuat::from_translation([3.0, 0.0, 0.0]);
    /// let report = arm.reach(target, &mut angles, &Options::default());
    /// assert_eq!(report.outcome, Outcome::OutOfReach);
    /// assert!((report.linear_error - 1.0).abs() < 1e-2);
    /// # Ok::<(), dq8::ik::ArmError>(())
    /// ```
    pub fn reach(
        &self,
        target: DualQuat<R>,
        values: &mut [R; N],
        options: &Options<R>,
    ) -> Report<R> {
        self.chain.solve(target, values, options)
    }
}

impl Backend {
    /// [`Arm::reach`] for every target, as many at a time as there are lanes; `values[i]` and
    /// `reports[i]` belong to `targets[i]`. Debug builds need a deep stack: [the table](crate::guide::firmware#stack).
    ///
    /// # Errors
    /// If the slices differ in length; nothing is touched.
    ///
    /// ```
    /// use dq8::ik::{Arm, Joint, Options, Outcome, Report};
    /// use dq8::{Backend, DualQuat, Quat};
    /// let up = [0.0, 0.0, 1.0_f32];
    /// let joints = [0.0, 1.0, 2.0].map(|x| Joint::revolute(up, [x, 0.0, 0.0]));
    /// let arm = Arm::new(joints, DualQuat::from_translation([2.0, 0.0, 0.0]))?;
    /// let targets: [_; 11] = std::array::from_fn(|i| {
    ///     let turn = Quat::from_axis_angle(up, 0.1 * i as f32);
    ///     DualQuat::from_rotation_translation(turn, [1.0, 0.1 * i as f32, 0.0])
    /// });
    /// let mut values = [[0.1, 0.2, 0.3]; 11];
    /// let mut reports = [Report::default(); 11];
    /// Backend::best().reach(&arm, &targets, &mut values, &mut reports, &Options::default())?;
    /// assert!(reports.iter().all(|report| report.outcome == Outcome::Converged));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn reach<R: Scalar, const N: usize>(
        self,
        arm: &Arm<R, N>,
        targets: &[DualQuat<R>],
        values: &mut [[R; N]],
        reports: &mut [Report<R>],
        options: &Options<R>,
    ) -> Result<(), ShapeError> {
        arm.chain.reach(self, targets, values, reports, options)
    }
}
