//! A serial arm from a table of Denavit and Hartenberg.

use super::error::MechanismError;
use super::joint::{Joint, JointKind};
use super::step::Step;
use super::tree::{Mechanism, numbered, planned, room};
use dq8::Real;
use dq8::scalar::{DualQuat, Quat};

/// A row of a table of Denavit and Hartenberg: θ and d along and about z, a and α along and about
/// x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dh<R> {
    /// What is added to the value of a hinge, radians; the fixed angle of a slide.
    pub theta: R,
    /// What is added to the value of a slide; the fixed offset of a hinge.
    pub d: R,
    /// The length of the link.
    pub a: R,
    /// Its twist, radians.
    pub alpha: R,
    /// Whether the value is d, and not θ.
    pub slides: bool,
    /// The least and the largest value of the joint.
    pub limits: Option<[R; 2]>,
}

/// In which order a row acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DhConvention {
    /// z, then x: A = Rz(θ) Tz(d) Tx(a) Rx(α) (Denavit & Hartenberg 1955; Paul; Spong).
    Standard,
    /// x, then z: A = Rx(α) Tx(a) Rz(θ) Tz(d), with the a and α of the link before (Craig,
    /// *Introduction to Robotics*).
    Modified,
}

impl<R: Real> Dh<R> {
    /// A hinge without limits.
    #[must_use]
    pub fn hinge(theta: R, d: R, a: R, alpha: R) -> Self {
        Self { theta, d, a, alpha, slides: false, limits: None }
    }

    /// A slide without limits.
    #[must_use]
    pub fn slide(theta: R, d: R, a: R, alpha: R) -> Self {
        Self { slides: true, ..Self::hinge(theta, d, a, alpha) }
    }

    /// The same row with limits.
    #[must_use]
    pub fn with_limits(self, limits: [R; 2]) -> Self {
        Self { limits: Some(limits), ..self }
    }

    fn about_z(&self) -> DualQuat<R> {
        let turn = Quat::from_axis_angle([R::ZERO, R::ZERO, R::ONE], self.theta);
        DualQuat::from_rotation_translation(turn, [R::ZERO, R::ZERO, self.d])
    }

    fn about_x(&self) -> DualQuat<R> {
        let turn = Quat::from_axis_angle([R::ONE, R::ZERO, R::ZERO], self.alpha);
        DualQuat::from_rotation_translation(turn, [self.a, R::ZERO, R::ZERO])
    }
}

impl<'a, R: Real> Mechanism<'a, R> {
    /// A serial arm of N rows, A₁ … A_N tool: joint j turns or slides along its z, and link N
    /// is the tool, fixed to the last; with the identity it is the last frame of the table. `steps`
    /// are N + 1.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::{Dh, DhConvention, Mechanism, Step};
    /// // Two links of length 1 in a plane.
    /// let (rows, mut steps) = ([Dh::hinge(0.0_f64, 0.0, 1.0, 0.0); 2], [Step::default(); 3]);
    /// let arm = Mechanism::from_dh(&rows, DhConvention::Standard, DualQuat::IDENTITY, &mut steps)?;
    /// let [x, y, _] = arm.link_pose(&[0.0, core::f64::consts::FRAC_PI_2], 2)?.translation();
    /// assert!((x - 1.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If a number is not finite (in the standard form, a and α are those of the joint after),
    /// limits are not in order, the tool, as that of joint N, is farther than 10⁻³ from unit, or
    /// there are fewer steps than N + 1. `steps` may have been written.
    pub fn from_dh(
        rows: &[Dh<R>],
        convention: DhConvention,
        tool: DualQuat<R>,
        steps: &'a mut [Step<R>],
    ) -> Result<Self, MechanismError> {
        let steps = room(steps, rows.len().saturating_add(1))?;
        let (mut before, mut counts) = (DualQuat::IDENTITY, (0, 0));
        let axis = [R::ZERO, R::ZERO, R::ONE];
        let joints = rows.iter().map(Some).chain([None]);
        for ((index, row), slot) in joints.enumerate().zip(steps.iter_mut()) {
            let parent = index.checked_sub(1);
            let mut joint = Joint::fixed(parent, before * tool);
            if let Some(row) = row {
                // What is along z is the same before the motion of the joint as after it.
                let along_x = match convention {
                    DhConvention::Standard => core::mem::replace(&mut before, row.about_x()),
                    DhConvention::Modified => row.about_x(),
                };
                joint.placement = along_x * row.about_z();
                joint.limits = row.limits;
                joint.kind = match row.slides {
                    true => JointKind::Prismatic { axis },
                    false => JointKind::Revolute { axis },
                };
            }
            numbered(&joint, index, &mut counts, slot)?;
        }
        Ok(planned(steps, counts))
    }
}
