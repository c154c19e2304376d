use super::Job;
use super::dh::{Dh, DhConvention};
use super::error::MechanismError;
use super::joint::Joint;
use super::step::Step;
use super::tree::Mechanism;
use alloc::vec;
use alloc::vec::Vec;
use dq8::geometry::Screw;
use dq8::scalar::DualQuat;
use dq8::seams::brief;
use dq8::{Real, ShapeError};

/// A [`Mechanism`] with memory of its own.
///
/// ```
/// use dq8_robot::{Joint, OwnedMechanism};
/// use dq8::DualQuat;
/// let up = DualQuat::from_translation([0.0_f32, 0.0, 1.0]);
/// let joints = [None, Some(0), Some(1)].map(|parent| Joint::revolute(parent, up, [1.0, 0.0, 0.0]));
/// let arm = OwnedMechanism::new(&joints)?;
/// let tool = arm.link_pose(&[0.0; 3], 2)?;
/// assert_eq!(tool.translation(), [0.0, 0.0, 3.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct OwnedMechanism<R> {
    steps: Vec<Step<R>>,
    values: usize,
    rates: usize,
}

brief!([R] OwnedMechanism<R>: OwnedMechanism |it| {
    links: it.steps.len(), values: it.values, rates: it.rates,
});

impl<R: Real> OwnedMechanism<R> {
    /// See [`Mechanism::new`].
    ///
    /// # Errors
    /// As there.
    pub fn new(joints: &[Joint<R>]) -> Result<Self, MechanismError> {
        Self::of(joints.len(), |steps| Mechanism::new(joints, steps))
    }

    /// See [`Mechanism::from_screws`].
    ///
    /// # Errors
    /// As there.
    pub fn from_screws(
        screws: &[(Screw<R>, [R; 2])],
        tool: DualQuat<R>,
    ) -> Result<Self, MechanismError> {
        Self::of(screws.len() + 1, |steps| Mechanism::from_screws(screws, tool, steps))
    }

    /// See [`Mechanism::from_dh`].
    ///
    /// # Errors
    /// As there.
    pub fn from_dh(
        rows: &[Dh<R>],
        convention: DhConvention,
        tool: DualQuat<R>,
    ) -> Result<Self, MechanismError> {
        Self::of(rows.len() + 1, |steps| Mechanism::from_dh(rows, convention, tool, steps))
    }

    fn of(
        count: usize,
        make: impl for<'s> FnOnce(&'s mut [Step<R>]) -> Result<Mechanism<'s, R>, MechanismError>,
    ) -> Result<Self, MechanismError> {
        let mut steps = vec![Step::default(); count];
        let Mechanism { values, rates, .. } = make(&mut steps)?;
        Ok(Self { steps, values, rates })
    }

    /// A run over many configurations: [`Mechanism::job`].
    pub fn job(&self) -> Job<'_, R>
    where
        R: Copy,
    {
        self.view().job()
    }

    /// See [`Mechanism::link_pose`].
    ///
    /// # Errors
    /// As there.
    pub fn link_pose(&self, values: &[R], link: usize) -> Result<DualQuat<R>, ShapeError> {
        self.view().link_pose(values, link)
    }

    /// See [`Mechanism::link_poses`].
    ///
    /// # Errors
    /// As there.
    pub fn link_poses(&self, values: &[R], poses: &mut [DualQuat<R>]) -> Result<(), ShapeError> {
        self.view().link_poses(values, poses)
    }

    /// The same, borrowed: everything else is asked of it.
    #[must_use]
    pub fn view(&self) -> Mechanism<'_, R> {
        Mechanism { steps: &self.steps, values: self.values, rates: self.rates }
    }
}
