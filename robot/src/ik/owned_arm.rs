use super::error::SolutionsError;
use super::family::{Family, Geometry};
use super::owned::OwnedReach;
use super::problem::Reach;
use super::six_axis::SixAxisArm;
use super::solutions::Solutions;
use super::solutions_job::SolutionsJob;
use alloc::vec;
use dq8::seams::brief;
use dq8::{DualQuat, Real, Scalar};
use dq8_simd::{Lanes, Portable};

/// A [`SixAxisArm`] with memory of its own: what a program keeps beside a search.
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
/// // All ways to a target, and from the nearest on along with it.
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
    /// See [`SixAxisArm::new`].
    ///
    /// # Errors
    /// As there.
    pub fn new(reach: OwnedReach<R>) -> Result<Self, SolutionsError> {
        let SixAxisArm { geometry, .. } = SixAxisArm::new(reach.view())?;
        Ok(Self { reach, geometry })
    }

    /// See [`SixAxisArm::family`].
    #[must_use]
    pub fn family(&self) -> Family {
        self.view().family()
    }

    /// See [`SixAxisArm::values`].
    #[must_use]
    pub fn values(&self) -> [usize; 6] {
        self.view().values()
    }

    /// Many targets at a time: [`SixAxisArm::job`].
    pub fn job(&self) -> SolutionsJob<'_, R> {
        self.view().job()
    }

    /// The same, borrowed: everything else is asked of it.
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
    /// See [`SixAxisArm::solutions`]; what searches compute in is allocated, where it takes
    /// searches.
    ///
    /// # Errors
    /// As there.
    pub fn solutions(
        &self,
        target: DualQuat<R>,
        start: &[R; 6],
    ) -> Result<Solutions<R>, SolutionsError> {
        let arm = self.view();
        arm.solutions(target, start, &mut vec![R::ZERO; arm.scratch_len()])
    }
}
