//! A chain of joints with a tool, of a number known at compile time: what an [`Arm`](crate::ik::Arm) is.

use super::beginnings::{Beginnings, KEPT, Poses};
use super::error::ReachError;
use super::freedom::{Freedom, freedoms};
use super::goal::Goal;
use super::job::Targets;
use super::manner::Manner;
use super::problem::Reach;
use super::report::{Options, Report};
use super::scratch::{OF_A_JOINT, OF_A_POSE, Room};
use super::search::Work;
use crate::batch;
use crate::dispatch::Backend;
use crate::geometry::Twist;
use crate::mechanism::error::MechanismError;
use crate::mechanism::joint::Joint;
use crate::mechanism::placed::Placed;
use crate::mechanism::step::Step;
use crate::mechanism::tree::Mechanism;
use crate::mechanism::values::Configuration;
use crate::mechanism::walk::{Joined, moved};
use crate::real::{Real, Scalar};
use crate::scalar::DualQuat;
use crate::shape::{ShapeError, same_length};
use dq8_simd::{Lanes, MAX_LANES, Portable};

/// Joints of one value each, every one on the one before, checked once and with what a search needs of them.
#[derive(Clone, Debug)]
pub(crate) struct Chain<R, const N: usize> {
    steps: [Step<R>; N],
    freedoms: [Freedom<R>; N],
    /// What is fixed to the last link: a step of its own, because no array has room for N + 1.
    tool: Step<R>,
    goal: [Goal<R>; 1],
    /// A point, and how far the tool can be from it.
    bound: ([R; 3], R),
    /// A length that is typical.
    size: R,
    /// Configurations to begin again from, and the poses of the tool there.
    values: [[R; N]; KEPT],
    poses: Poses<R>,
}

/// What makes no chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ChainError {
    /// The placement or the axis of this joint.
    Joint(usize),
    /// The limits of this joint: not in order, or of a slide without end, or angles that a float does not tell.
    Limits(usize),
    /// The tool.
    Tool,
}

impl<R: Real, const N: usize> Chain<R, N> {
    /// From joints, each on the one before, a tool on the last one, and what [`Reach::reach_bound`] is to be.
    pub(crate) fn new(
        joints: &[Joint<R>; N],
        tool: DualQuat<R>,
        bound: ([R; 3], R),
    ) -> Result<Self, ChainError> {
        let mut steps = [Step::default(); N];
        if let Err(error) = Mechanism::new(joints, &mut steps) {
            return Err(match error {
                MechanismError::Limits { joint, .. } => ChainError::Limits(joint),
                MechanismError::Axis { joint, .. } | MechanismError::NotFinite { joint, .. } => {
                    ChainError::Joint(joint)
                }
                // Joints of a chain have parents and no mimic.
                _ => ChainError::Tool,
            });
        }
        let mut own = [Freedom::default(); N];
        if let Err(ReachError::Limits { joint, .. }) = freedoms(&steps, &mut own, |_| true) {
            return Err(ChainError::Limits(joint));
        }
        // Beginnings are spread between two ends.
        if let Some(joint) = own.iter().position(|freedom| !freedom.range.is_finite()) {
            return Err(ChainError::Limits(joint));
        }
        let tool = Step::of(&Joint::fixed(None, tool), N).map_err(|_| ChainError::Tool)?;
        // An eighth of it is a length per radian, and not zero.
        let (_, length) = bound;
        let size = if length * R::from(0.125) > R::ZERO { length } else { R::from(8.0) };
        let goal = [Goal::pose(N.saturating_sub(1))];
        let mut chain = Self {
            steps,
            freedoms: own,
            tool,
            goal,
            bound,
            size,
            values: [[R::ZERO; N]; KEPT],
            poses: Poses::NONE,
        };
        // Once, when the arm is made: a restart then costs 128 comparisons of poses and no forward kinematics.
        for index in 0..KEPT {
            let values = own.map(|freedom| freedom.beginning(index as u64 + 1));
            if let Some(pose) = chain.view().pose(N.saturating_sub(1), &values) {
                chain.poses.set(index, pose);
            }
            if let Some(slot) = chain.values.get_mut(index) {
                *slot = values;
            }
        }
        Ok(chain)
    }

    /// The problem that it is.
    fn view(&self) -> Reach<'_, R> {
        Reach {
            mechanism: Mechanism { steps: &self.steps, values: N, rates: N },
            goals: &self.goal,
            freedoms: &self.freedoms,
            of_rates: &self.freedoms,
            posture: None,
            rows: 6,
            twists: N,
            size: self.size,
            is_endless: false,
            bound: Some(self.bound),
            tool: Some(&self.tool),
            kept: Some(Beginnings { values: self.values.as_flattened(), poses: &self.poses }),
            manner: Manner::ARM,
        }
    }

    /// A point, and a distance from it that the tool never exceeds.
    pub(crate) fn bound(&self) -> ([R; 3], R) {
        self.bound
    }
}

impl<R: Scalar, const N: usize> Chain<R, N> {
    /// The pose of the tool, and the spatial twist of each joint.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn pose_and_screws<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        values: &[L; N],
    ) -> (batch::DualQuat<L>, [Twist<L>; N]) {
        let mut screws = [Twist::from_array([L::splat(level, R::ZERO); 6]); N];
        let (mut link, mut numbers) = (Placed::identity(level), Configuration(values));
        for (step, screw) in self.steps.iter().zip(&mut screws) {
            let before = link.place(step);
            link = moved(level, before, step, &mut numbers);
            *screw = Joined { before, pose: link }.screw(step, 0);
        }
        (batch::DualQuat::from_array(link.place(&self.tool).to_motion()), screws)
    }

    /// [`Arm::reach`](crate::ik::Arm::reach) for every target.
    pub(crate) fn reach(
        &self,
        backend: Backend,
        targets: &[DualQuat<R>],
        values: &mut [[R; N]],
        reports: &mut [Report<R>],
        options: &Options<R>,
    ) -> Result<(), ShapeError> {
        same_length("values", values.len(), targets.len())?;
        same_length("reports", reports.len(), targets.len())?;
        let mut room = Memory {
            joints: [[R::ZERO; OF_A_JOINT * MAX_LANES]; N],
            rest: [R::ZERO; OF_A_POSE * MAX_LANES],
        };
        let room = Room([room.joints.as_flattened_mut(), &mut room.rest]);
        let work = Work { targets, values: values.as_flattened_mut(), reports, options };
        backend.run(Targets { reach: &self.view(), work, room });
        Ok(())
    }
}

impl<R, const N: usize> Chain<R, N>
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    /// [`Arm::reach`](crate::ik::Arm::reach).
    pub(crate) fn solve(
        &self,
        target: DualQuat<R>,
        values: &mut [R; N],
        options: &Options<R>,
    ) -> Report<R> {
        // One lane, a sixteenth of the memory: firmware has little stack.
        let mut room = Memory { joints: [[R::ZERO; OF_A_JOINT]; N], rest: [R::ZERO; OF_A_POSE] };
        let room = Room([room.joints.as_flattened_mut(), &mut room.rest]);
        let mut reports = [Report::default()];
        let work = Work { targets: &[target], values, reports: &mut reports, options };
        self.view().solve_one::<true>(work, room);
        let [report] = reports;
        report
    }
}

/// What a search computes in, on the stack, in lines of the cache.
#[repr(C, align(64))]
struct Memory<R, const N: usize, const OF_JOINTS: usize, const OF_REST: usize> {
    joints: [[R; OF_JOINTS]; N],
    rest: [R; OF_REST],
}
