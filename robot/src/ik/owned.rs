//! [`OwnedReach`] and [`OwnedSixAxisArm`]: an inverse kinematics problem and a six-axis arm that
//! own their memory.

use super::family::{Family, Geometry, SolutionsError};
use super::freedom::Freedom;
use super::goal::{Goal, ReachError};
use super::job::ReachJob;
use super::problem::{Facts, Reach};
use super::rates::RatesError;
use super::report::{Options, Report, Tracking};
use super::six_axis::{SixAxisArm, Solutions, SolutionsJob};
use crate::mechanism::job::OwnedMechanism;
use crate::mechanism::tree::Mechanism;
use alloc::vec;
use alloc::vec::Vec;
use dq8::internal::brief;
use dq8::{DualQuat, Real, Scalar, ShapeError, Twist};
use dq8_simd::{Lanes, Portable};

/// A [`Reach`] that owns its memory, including the robot and its goals, so that a program can keep
/// it in a struct.
///
/// ```
/// use dq8_robot::ik::{Goal, Options, OwnedReach};
/// use dq8_robot::{Joint, OwnedMechanism};
/// use dq8::DualQuat;
/// let out = DualQuat::from_translation([1.0_f64, 0.0, 0.0]);
/// let joints = [(None, DualQuat::IDENTITY), (Some(0), out), (Some(1), out)]
///     .map(|(on, at)| Joint::revolute(on, at, [0.0, 0.0, 1.0]));
/// let mut reach = OwnedReach::new(OwnedMechanism::new(&joints)?, [Goal::position(2)])?;
/// let target = DualQuat::from_translation([1.2, 0.8, 0.0]);
/// let mut angles = [0.1, 0.2, 0.3];
/// let report = reach.solve(&[target], &mut angles, &Options::default())?;
/// assert!(report.is_converged());
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone)]
#[doc(alias("inverse_kinematics"))]
pub struct OwnedReach<R> {
    mechanism: OwnedMechanism<R>,
    goals: Vec<Goal<R>>,
    freedoms: Vec<Freedom<R>>,
    /// The number of freedoms that move a goal, which come first in `freedoms`.
    moving: usize,
    posture: Option<Vec<R>>,
    facts: Facts<R>,
    scratch: Vec<R>,
}

brief!([R] OwnedReach<R>: OwnedReach |it| { mechanism: it.mechanism, goals: it.goals.len() });

impl<R: Real> OwnedReach<R> {
    /// Makes an inverse kinematics problem as [`Reach::new`] does.
    ///
    /// # Errors
    /// The errors of [`Reach::new`].
    pub fn new(
        mechanism: OwnedMechanism<R>,
        goals: impl Into<Vec<Goal<R>>>,
    ) -> Result<Self, ReachError> {
        let goals = goals.into();
        let mut freedoms = vec![Freedom::default(); mechanism.view().rates()];
        let Reach { freedoms: moving, facts, .. } =
            Reach::new(mechanism.view(), &goals, &mut freedoms)?;
        let (moving, posture, scratch) = (moving.len(), None, Vec::new());
        Ok(Self { mechanism, goals, freedoms, moving, posture, facts, scratch })
    }

    /// The mechanism.
    #[must_use]
    pub fn mechanism(&self) -> Mechanism<'_, R> {
        self.mechanism.view()
    }

    /// Returns this problem with a preferred configuration, as [`Reach::with_posture`] does.
    ///
    /// # Errors
    /// The errors of [`Reach::with_posture`].
    pub fn with_posture(self, values: impl Into<Vec<R>>) -> Result<Self, ReachError> {
        let values = values.into();
        self.view().with_posture(&values)?;
        Ok(Self { posture: Some(values), ..self })
    }

    /// Returns a search for many configurations, as [`Reach::job`] does.
    pub fn job(&self) -> ReachJob<'_, R> {
        self.view().job()
    }

    /// Returns a view that borrows the memory of this value. The view has all other methods.
    #[must_use]
    pub fn view(&self) -> Reach<'_, R> {
        Reach {
            mechanism: self.mechanism.view(),
            goals: &self.goals,
            freedoms: self.freedoms.get(..self.moving).unwrap_or_default(),
            by_rate: &self.freedoms,
            posture: self.posture.as_deref(),
            facts: self.facts,
        }
    }
}

impl<R> OwnedReach<R>
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    /// Solves one configuration as [`Reach::solve`] does. The first call allocates the scratch.
    ///
    /// # Errors
    /// The errors of [`Reach::solve`].
    pub fn solve(
        &mut self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        options: &Options<R>,
    ) -> Result<Report<R>, ShapeError> {
        self.with_scratch(|reach, scratch| reach.solve(targets, values, scratch, options))
    }

    /// Follows a target as [`Reach::follow`] does, with its own scratch.
    ///
    /// # Errors
    /// The errors of [`Reach::follow`].
    pub fn follow(
        &mut self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        options: &Options<R>,
    ) -> Result<Report<R>, ShapeError> {
        self.with_scratch(|reach, scratch| reach.follow(targets, values, scratch, options))
    }

    /// Tracks targets as [`Reach::track`] does, with its own scratch.
    ///
    /// # Errors
    /// The errors of [`Reach::track`].
    pub fn track(
        &mut self,
        targets: &[DualQuat<R>],
        values: &mut [R],
        options: &Tracking<R>,
    ) -> Result<Report<R>, ShapeError> {
        self.with_scratch(|reach, scratch| reach.track(targets, values, scratch, options))
    }

    /// Solves for rates as [`Reach::rates`] does, with its own scratch.
    ///
    /// # Errors
    /// The errors of [`Reach::rates`].
    pub fn rates(
        &mut self,
        values: &[R],
        twists: &[Twist<R>],
        damping: R,
        rates: &mut [R],
    ) -> Result<(), RatesError> {
        self.with_scratch(|reach, scratch| reach.rates(values, twists, damping, rates, scratch))
    }

    fn with_scratch<T>(&mut self, run: impl FnOnce(&Reach<'_, R>, &mut [R]) -> T) -> T {
        let mut scratch = core::mem::take(&mut self.scratch);
        scratch.resize(self.view().scratch_len(), R::ZERO);
        let result = run(&self.view(), &mut scratch);
        self.scratch = scratch;
        result
    }
}

/// A [`SixAxisArm`] that owns its memory, so that a program can keep it in a struct beside a
/// search.
///
/// ```
/// use dq8::DualQuat;
/// use dq8_robot::ik::{Goal, Options, OwnedReach, OwnedSixAxisArm};
/// use dq8_robot::{Joint, OwnedMechanism};
/// struct Cell {
///     reach: OwnedReach<f64>,
///     arm: OwnedSixAxisArm<f64>,
/// }
/// # let (y, z) = ([0.0_f64, 1.0, 0.0], [0.0, 0.0, 1.0]);
/// # let hinges = [
/// #     (z, [0.0, 0.0, 0.0892]),
/// #     (y, [0.0, 0.1358, 0.0]),
/// #     (y, [0.425, -0.1197, 0.0]),
/// #     (y, [0.3922, 0.0, 0.0]),
/// #     ([0.0, 0.0, -1.0], [0.0, 0.093, 0.0]),
/// #     (y, [0.0, 0.0, -0.0947]),
/// # ];
/// # let mut joints: Vec<_> = (0_usize..6)
/// #     .map(|i| (i.checked_sub(1), DualQuat::from_translation(hinges[i].1), hinges[i].0))
/// #     .map(|(on, at, axis)| Joint::revolute(on, at, axis).with_limits([-6.28, 6.28]))
/// #     .collect();
/// # joints.push(Joint::fixed(Some(5), DualQuat::from_translation([0.0, 0.0823, 0.0])));
/// // The joints of a UR5 and its tool, as for `SixAxisArm`.
/// let reach = OwnedReach::new(OwnedMechanism::new(&joints)?, Goal::pose(6))?;
/// let arm = OwnedSixAxisArm::new(reach.clone())?;
/// let mut cell = Cell { reach, arm };
///
/// // All solutions of a target, and a motion that goes on from the nearest.
/// let start = [0.4, -1.2, 1.5, -0.8, 1.1, 0.2];
/// let target = cell.reach.mechanism().link_pose(&start, 6)?;
/// let found = cell.arm.solutions(target, &start)?;
/// assert_eq!(found.len(), 8);
/// let mut values = found[0].values;
/// let next = target * DualQuat::from_translation([0.0, 0.0, 0.01]);
/// let report = cell.reach.follow(&[next], &mut values, &Options::default())?;
/// assert!(report.is_converged());
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct OwnedSixAxisArm<R> {
    reach: OwnedReach<R>,
    geometry: Geometry<R>,
}

brief!([R] OwnedSixAxisArm<R>: OwnedSixAxisArm |it| { reach: it.reach });

impl<R: Real> OwnedSixAxisArm<R> {
    /// Makes an arm as [`SixAxisArm::new`] does.
    ///
    /// # Errors
    /// The errors of [`SixAxisArm::new`].
    pub fn new(reach: OwnedReach<R>) -> Result<Self, SolutionsError> {
        let SixAxisArm { geometry, .. } = SixAxisArm::new(reach.view())?;
        Ok(Self { reach, geometry })
    }

    /// Returns the family of the arm.
    #[must_use]
    pub fn family(&self) -> Family {
        self.view().family()
    }

    /// Returns the indices of the six hinges' values among the values of the mechanism.
    #[must_use]
    pub fn values(&self) -> [usize; 6] {
        self.view().values()
    }

    /// Returns a job that solves many targets at a time, as [`SixAxisArm::job`] does.
    pub fn job(&self) -> SolutionsJob<'_, R> {
        self.view().job()
    }

    /// Returns a view that borrows the memory of this value. The view has all other methods.
    #[must_use]
    pub fn view(&self) -> SixAxisArm<'_, R> {
        let reach = Reach { posture: None, ..self.reach.view() };
        SixAxisArm { reach, geometry: self.geometry }
    }
}

impl<R> OwnedSixAxisArm<R>
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    /// Finds all solutions as [`SixAxisArm::solutions`] does. It allocates memory if the arm needs
    /// searches.
    ///
    /// # Errors
    /// The errors of [`SixAxisArm::solutions`].
    pub fn solutions(
        &self,
        target: DualQuat<R>,
        start: &[R; 6],
    ) -> Result<Solutions<R>, SolutionsError> {
        let arm = self.view();
        arm.solutions(target, start, &mut vec![R::ZERO; arm.scratch_len()])
    }
}
