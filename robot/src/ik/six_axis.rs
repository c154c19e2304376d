//! [`SixAxisArm`], an arm of six hinges, and the methods that find all joint values that bring its
//! tool to a target, the solutions.
//!
//! Arms of the two families are solved by formula (`branches.rs`), and a solution counts only if
//! the forward kinematics of the mechanism reaches the target with it. The solutions of other arms
//! are found by numerical searches from many starts.

use super::branches::{Arm, Branch, Complex};
use super::family::{Family, Geometry, SolutionsError};
use super::freedom::Range;
use super::problem::Reach;
use super::report::{Options, Report};
use super::scratch::check_scratch;
use super::search::Work;
use crate::mechanism::Mechanism;
use crate::mechanism::joint::JointKind;
use crate::mechanism::step::{NONE, UNIT};
use crate::mechanism::values::checked_cos_sin;
use crate::mechanism::walk::HalfPose;
use core::ops::Deref;
use dq8::batch::{self, cos_sin, half_turns, vector};
use dq8::internal::Choice;
#[cfg(feature = "alloc")]
use dq8::internal::Rows;
use dq8::storage::same_length;
use dq8::{Backend, DualQuat, Kernel, Real, Scalar};
use dq8_simd::{Lanes, Level, MAX_LANES, Mask, Portable};

/// An arm of six hinges that carries the only goal of a [`Reach`], a whole pose. The arm is
/// analysed once; then all solutions can be found for any target.
///
/// Most industrial arms belong to one of two [families](Family), which have up to eight solutions.
/// A formula finds all of them. Among solutions that differ by whole turns, only the one nearest to
/// the start is listed. Each solution is checked by the forward kinematics of the mechanism, which
/// puts the tool at the target except for rounding. A target counts as reachable up to 64 units in
/// the last place (2⁻⁵² or 2⁻²³) of the arm's size beyond its reach. Other arms are solved
/// by searches from many starts, which find about 99 of 100 solutions. If axes miss a family by at
/// most 10⁻³, as in arms whose angles were typed with few digits, the searches start from the
/// solutions of the family's formula, so there are far fewer searches.
///
#[doc = include_str!("six_axes.svg")]
///
/// ```
/// use dq8::DualQuat;
/// use dq8_robot::ik::{Family, Goal, OwnedReach, SixAxisArm};
/// use dq8_robot::{Joint, OwnedMechanism};
/// // A UR5, stretched along x where all values are zero.
/// let (y, z) = ([0.0_f64, 1.0, 0.0], [0.0, 0.0, 1.0]);
/// let hinges = [
///     (z, [0.0, 0.0, 0.0892]),
///     (y, [0.0, 0.1358, 0.0]),
///     (y, [0.425, -0.1197, 0.0]),
///     (y, [0.3922, 0.0, 0.0]),
///     ([0.0, 0.0, -1.0], [0.0, 0.093, 0.0]),
///     (y, [0.0, 0.0, -0.0947]),
/// ];
/// let mut joints: Vec<_> = (0_usize..6)
///     .map(|i| (i.checked_sub(1), DualQuat::from_translation(hinges[i].1), hinges[i].0))
///     .map(|(on, at, axis)| Joint::revolute(on, at, axis).with_limits([-6.28, 6.28]))
///     .collect();
/// joints.push(Joint::fixed(Some(5), DualQuat::from_translation([0.0, 0.0823, 0.0])));
/// let reach = OwnedReach::new(OwnedMechanism::new(&joints)?, [Goal::pose(6)])?;
/// let arm = SixAxisArm::new(reach.view())?;
/// assert_eq!(arm.family(), Family::ThreeParallel);
///
/// let values = [0.4, -1.2, 1.5, -0.8, 1.1, 0.2];
/// let target = reach.view().mechanism().link_pose(&values, 6)?;
/// // The families need no memory to compute in.
/// let found = arm.solutions(target, &values, &mut [])?;
/// assert!(found.len() == 8 && found.is_complete && !found[0].singular.any());
/// assert!(found[0].distance < 1e-12 && found[1].distance > 0.1);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SixAxisArm<'a, R> {
    pub(super) reach: Reach<'a, R>,
    pub(super) geometry: Geometry<R>,
}

impl<'a, R: Real> SixAxisArm<'a, R> {
    /// Makes the arm of a problem. Axes count as parallel if their lines differ by at most 10⁻⁸
    /// radians (`f32`: 10⁻⁵), and as meeting if their distance is at most 10⁻⁸ (`f32`:
    /// 10⁻⁵) of the arm's size. The posture of the problem is ignored.
    ///
    /// # Errors
    /// If there is not exactly one goal, if it is not for a whole pose, or if the joints that carry
    /// its link are not six hinges with values of their own and fixed joints.
    pub fn new(reach: Reach<'a, R>) -> Result<Self, SolutionsError> {
        let reach = Reach { posture: None, ..reach };
        Ok(Self { geometry: Geometry::of(&reach)?, reach })
    }

    /// Returns the family of the arm, which follows from its axes.
    #[must_use]
    pub fn family(&self) -> Family {
        if self.geometry.is_exact() { self.geometry.family } else { Family::Other }
    }

    /// Returns the indices of the six hinges' values among the values of the mechanism.
    #[must_use]
    pub fn values(&self) -> [usize; 6] {
        let mut values = [0; 6];
        for (slot, freedom) in values.iter_mut().zip(self.reach.freedoms) {
            *slot = freedom.value as usize;
        }
        values
    }

    /// Returns the length of the scratch for [`solutions`](Self::solutions), in values of type `R`.
    /// It is zero for the two families.
    #[must_use]
    pub fn scratch_len(&self) -> usize {
        self.with_values(self.reach.scratch_len())
    }

    /// Returns the length of the scratch for a [`SolutionsJob`](super::SolutionsJob), in values of
    /// type `R`. It suffices for any number of lanes, so for any CPU. It is zero for the two
    /// families.
    #[must_use]
    pub fn batch_scratch_len(&self) -> usize {
        self.with_values(self.reach.batch_scratch_len())
    }

    /// Checks targets and their starts, as a [`SolutionsJob`](super::SolutionsJob) does before it
    /// writes.
    ///
    /// # Errors
    /// If a target or a start is not finite, a target is farther than 10⁻³ from unit, or there
    /// are not as many starts as targets.
    pub fn check(&self, targets: &[DualQuat<R>], starts: &[[R; 6]]) -> Result<(), SolutionsError> {
        same_length("starts", starts.len(), targets.len())?;
        for (index, target) in targets.iter().enumerate() {
            for number in target.to_array() {
                if !number.is_finite() {
                    return Err(SolutionsError::Target { index, value: number.into() });
                }
            }
            if !target.is_unit(R::from(UNIT)) {
                return Err(SolutionsError::NotUnit { index, norm: target.real().norm().into() });
            }
        }
        for (index, start) in starts.iter().enumerate() {
            for (hinge, value) in start.iter().enumerate() {
                if !value.is_finite() {
                    return Err(SolutionsError::Start { index, hinge, value: (*value).into() });
                }
            }
        }
        Ok(())
    }

    /// Returns the largest [`batch_scratch_len`](Self::batch_scratch_len) of the arms of a
    /// mechanism, when the goal is not known yet.
    #[must_use]
    pub fn batch_scratch_bound(mechanism: Mechanism<'_, R>) -> usize {
        let searches = Reach::scratch_bound(mechanism, 1).saturating_mul(MAX_LANES);
        searches.saturating_add(mechanism.values.saturating_mul(STARTS))
    }

    fn with_values(&self, scratch: usize) -> usize {
        let is_other = self.family() == Family::Other;
        if is_other { scratch.saturating_add(starts_len(&self.reach)) } else { 0 }
    }
}

/// All solutions of an arm of six hinges for a target, as a slice that is sorted by the distance
/// from the start.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solutions<R> {
    all: [Solution<R>; 8],
    count: usize,
    /// `true` if the arm has no other solutions; `false` if searches found the solutions, so that
    /// there may be more.
    pub is_complete: bool,
}

/// A solution: values of the six hinges that bring the tool to the target.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solution<R> {
    /// The values of the six hinges from the base up, within their limits. Whole turns are chosen
    /// so that each value is as near to the start as possible.
    pub values: [R; 6],
    /// The distance from the start in radians: the root of the sum of the squared differences of
    /// all values.
    pub distance: R,
    /// The joints at which the arm is singular.
    pub singular: Singular,
}

/// The joints at which a solution is singular. Either two solutions coincide there, because the
/// target is at the edge of the reach; or there are infinitely many solutions, of which the
/// solution with the angle of the start is given.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Singular {
    /// `true` if the arm is singular at the first axis: the wrist is on this axis, or as near to it
    /// as the offsets of the arm allow.
    pub shoulder: bool,
    /// `true` if the arm is singular at the second and third axis: it is stretched or folded.
    pub elbow: bool,
    /// `true` if the arm is singular at the fifth axis: the last axis is parallel to an axis before
    /// it.
    pub wrist: bool,
}

impl Singular {
    /// Returns `true` if the solution is singular at any joint.
    #[must_use]
    pub fn any(self) -> bool {
        self.shoulder || self.elbow || self.wrist
    }
}

impl<R: Real> Default for Solutions<R> {
    /// Returns an empty list of solutions.
    fn default() -> Self {
        let none =
            Solution { values: [R::ZERO; 6], distance: R::ZERO, singular: Singular::default() };
        Self { all: [none; 8], count: 0, is_complete: true }
    }
}

impl<R> Deref for Solutions<R> {
    type Target = [Solution<R>];

    fn deref(&self) -> &[Solution<R>] {
        self.all.get(..self.count).unwrap_or_default()
    }
}

impl<R: Real> Solutions<R> {
    /// Inserts a solution into the list, which is sorted by the distance from the start. The list
    /// holds at most eight solutions. If searches find more, the farthest solution is dropped.
    pub(super) fn insert(&mut self, solution: Solution<R>) {
        let nearer = self.iter().filter(|other| other.distance <= solution.distance).count();
        self.count = self.all.len().min(self.count + 1);
        if let Some([first, rest @ ..]) = self.all.get_mut(nearer..self.count) {
            let mut last = core::mem::replace(first, solution);
            for slot in rest {
                core::mem::swap(slot, &mut last);
            }
        }
    }

    pub(super) fn clear(&mut self, is_complete: bool) {
        (self.count, self.is_complete) = (0, is_complete);
    }
}

impl<'a, R: Copy> SixAxisArm<'a, R> {
    /// Returns a job that solves many targets at a time.
    pub fn job(self) -> SolutionsJob<'a, R> {
        SolutionsJob { arm: self, choice: Choice::default() }
    }
}

impl<R> SixAxisArm<'_, R>
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    /// Returns all joint values within the limits that bring the tool to a target, sorted by their
    /// distance from `start`. The list is empty if the target cannot be reached. `scratch` must
    /// have at least the length [`scratch_len`](Self::scratch_len), and may hold anything.
    ///
    /// # Errors
    /// If the target or the start is not finite, if the target is farther than 10⁻³ from a unit
    /// motion, or if `scratch` is too short.
    pub fn solutions(
        &self,
        target: DualQuat<R>,
        start: &[R; 6],
        scratch: &mut [R],
    ) -> Result<Solutions<R>, SolutionsError> {
        check_scratch(scratch.len(), self.scratch_len())?;
        let mut found = [Solutions::default()];
        let (targets, starts) = (&[target], &[*start]);
        let mut work =
            SolutionsKernel { arm: self, targets, starts, found: &mut found }.checked()?;
        if self.geometry.family != Family::Other {
            work.by_formula::<R>(Portable);
        }
        let size = self.reach.mechanism.values.max(1);
        work.by_searches(scratch, |work, scratch| {
            let starts = work.values.chunks_exact_mut(size).zip(work.targets);
            for ((values, &target), report) in starts.zip(work.reports) {
                let options = work.settings.options;
                // The lengths fit, so `follow` returns no error. If it did, the default report
                // would count as not converged.
                let report_of = self.reach.follow(&[target], values, scratch, options);
                *report = report_of.unwrap_or_default();
            }
        });
        let [found] = found;
        Ok(found)
    }
}

/// A job for many targets of a [`SixAxisArm`], with a target in each lane. All its options have a
/// default, and the solutions of one target do not depend on the other targets.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct SolutionsJob<'a, R> {
    arm: SixAxisArm<'a, R>,
    choice: Choice,
}

impl<R> SolutionsJob<'_, R> {
    dq8::internal::options!();
}

impl<R: Scalar> SolutionsJob<'_, R> {
    /// Finds the solutions of many targets, each with its own start, as [`SixAxisArm::solutions`]
    /// does for one. Allocates scratch of the length
    /// [`batch_scratch_len`](SixAxisArm::batch_scratch_len) for each task that runs at the same
    /// time.
    ///
    /// # Errors
    /// The errors of [`SixAxisArm::solutions`], and an error if there are not as many
    /// starts and places for solutions as targets. Nothing is written then.
    #[cfg(feature = "alloc")]
    pub fn solutions(
        &self,
        targets: &[DualQuat<R>],
        starts: &[[R; 6]],
        found: &mut [Solutions<R>],
    ) -> Result<(), SolutionsError> {
        let arm = &self.arm;
        let SolutionsKernel { found, .. } =
            SolutionsKernel { arm, targets, starts, found }.checked()?;
        let backend = self.choice.instructions();
        let grain = if self.arm.family() == Family::Other { 1 } else { 256 };
        backend.share(grain, (found, 1), &|first, (found, _): Rows<'_, Solutions<R>>| {
            let targets = targets.get(first..).unwrap_or_default();
            let starts = starts.get(first..).unwrap_or_default();
            let mut scratch = alloc::vec![R::ZERO; self.arm.batch_scratch_len()];
            SolutionsKernel { arm, targets, starts, found }.run(backend, &mut scratch);
        });
        Ok(())
    }

    /// Finds the solutions of many targets as [`solutions`](Self::solutions) does, without
    /// allocation and on the calling thread. `scratch` must have at least the length
    /// [`batch_scratch_len`](SixAxisArm::batch_scratch_len), and may hold anything.
    ///
    /// # Errors
    /// The errors of [`solutions`](Self::solutions), and an error if `scratch` is too short.
    /// Nothing is written then.
    pub fn solutions_in(
        &self,
        scratch: &mut [R],
        targets: &[DualQuat<R>],
        starts: &[[R; 6]],
        found: &mut [Solutions<R>],
    ) -> Result<(), SolutionsError> {
        check_scratch(scratch.len(), self.arm.batch_scratch_len())?;
        let work = SolutionsKernel { arm: &self.arm, targets, starts, found }.checked()?;
        work.run(self.choice.instructions(), scratch);
        Ok(())
    }
}

/// The inputs and outputs of a job: the arm, targets, starts, and the slice for the solutions.
struct SolutionsKernel<'s, R> {
    arm: &'s SixAxisArm<'s, R>,
    targets: &'s [DualQuat<R>],
    starts: &'s [[R; 6]],
    found: &'s mut [Solutions<R>],
}

impl<R: Real> SolutionsKernel<'_, R> {
    /// Returns the job if its lengths fit, its inputs are finite, and its targets are unit motions;
    /// otherwise an error.
    fn checked(self) -> Result<Self, SolutionsError> {
        self.arm.check(self.targets, self.starts)?;
        same_length("found", self.found.len(), self.targets.len())?;
        Ok(self)
    }
}

impl<R: Scalar> SolutionsKernel<'_, R> {
    fn run(self, backend: Backend, scratch: &mut [R]) {
        let arm = self.arm;
        if arm.geometry.family != Family::Other {
            backend.run(SolutionsKernel { found: &mut *self.found, ..self });
        }
        self.by_searches(scratch, |work, scratch| {
            // These searches never restart, because their `options` rule it out. `RESTARTS` still
            // has the value that other searches use, so that a program does not contain a second
            // monomorphised copy of the kernel.
            const RESTARTS: bool = cfg!(not(target_os = "none"));
            arm.reach.job().run::<RESTARTS, false>(backend, work, scratch);
        });
    }

    /// Finds the solutions by the formulas of the arm's family, for as many targets at a time as
    /// there are lanes.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn by_formula<L: Lanes<Real = R>>(&mut self, level: L::Level) {
        for first in (0..self.found.len()).step_by(L::LANES) {
            let lanes = TargetLanes::<L>::load(level, self, first);
            let branches = Arm::new(level, &self.arm.geometry, lanes.target, lanes.turns).solve();
            let rest = self.found.get_mut(first..).unwrap_or_default();
            let count = rest.len().min(L::LANES);
            let found = rest.get_mut(..count).unwrap_or_default();
            for slot in found.iter_mut() {
                slot.clear(true);
            }
            for branch in branches.iter().filter(|branch| branch.exists.any()) {
                lanes.insert(branch, found);
            }
        }
    }

    /// Finds the solutions by searches, for an arm that the formulas do not fit exactly.
    fn by_searches(self, scratch: &mut [R], mut search: impl FnMut(Work<'_, R>, &mut [R])) {
        let reach = &self.arm.reach;
        if self.arm.geometry.is_exact() {
            return;
        }
        let split = scratch.split_at_mut_checked(starts_len(reach));
        let Some((values, scratch)) = split else { return };
        for ((&target, start), found) in self.targets.iter().zip(self.starts).zip(self.found) {
            let starts = Starts { reach, target, start, found, values: &mut *values };
            starts.search_all(|work| search(work, scratch));
        }
    }
}

impl<R: Scalar> Kernel for SolutionsKernel<'_, R> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(mut self, level: V) {
        self.by_formula::<R::Lanes<V>>(level);
    }
}

/// A target and a start in each lane.
struct TargetLanes<'s, L: Lanes> {
    level: L::Level,
    arm: &'s SixAxisArm<'s, L::Real>,
    target: batch::DualQuat<L>,
    /// The values of the start, brought within the limits.
    start: [L; 6],
    /// The angles θ of `start` as complex numbers e^{iθ}.
    turns: [Complex<L>; 6],
}

impl<'s, L: Lanes<Real: Scalar>> TargetLanes<'s, L> {
    /// Loads the targets from index `first` on, one into each lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load(level: L::Level, work: &SolutionsKernel<'s, L::Real>, first: usize) -> Self {
        let zero = L::splat(level, L::Real::ZERO);
        let arm = work.arm;
        let mut numbers = [zero.to_array(); 14];
        for lane in 0..L::LANES {
            // Lanes without a target repeat the last target.
            let from = (first + lane).min(work.found.len() - 1);
            let target = work.targets.get(from).copied().unwrap_or(DualQuat::IDENTITY);
            let start = work.starts.get(from).copied().unwrap_or_default();
            let all = target.to_array().into_iter().chain(start);
            for (array, number) in numbers.iter_mut().zip(all) {
                if let Some(slot) = array.as_mut().get_mut(lane) {
                    *slot = number;
                }
            }
        }
        let mut target = [zero; 8];
        for (lanes, array) in target.iter_mut().zip(&numbers) {
            *lanes = L::load(level, array);
        }
        let target = batch::DualQuat::from_array(target).normalize();
        let (mut start, mut turns) = ([zero; 6], [Complex { re: zero, im: zero }; 6]);
        for (index, freedom) in arm.reach.freedoms.iter().enumerate().take(6) {
            let value = L::load(level, &numbers[8 + index]);
            let clamped = freedom.range.clamp(value);
            let value = freedom.range.wrap(value, clamped);
            let (re, im) = cos_sin(value);
            (start[index], turns[index]) = (value, Complex { re, im });
        }
        Self { level, arm, target, start, turns }
    }

    /// Adds a branch, one of the eight solutions by formula, to the solutions of the lanes in which
    /// it is within the limits and reaches the target.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn insert(&self, branch: &Branch<L>, found: &mut [Solutions<L::Real>]) {
        let (level, arm, start) = (self.level, self.arm, self.start);
        let zero = L::splat(level, L::Real::ZERO);
        // If the formulas fit the arm only nearly, searches improve the solutions later and bring
        // them within the limits. So such a solution may lie beyond a limit by the tolerance.
        let margin = if arm.geometry.is_exact() { zero } else { L::splat(level, arm.tolerance()) };
        let mut exists = branch.exists;
        let (mut values, mut square) = ([zero; 6], zero);
        let most = L::splat(level, arm.geometry.tolerance);
        for (index, freedom) in arm.reach.freedoms.iter().enumerate().take(6) {
            let angle = branch.turns[index].angle();
            // A nearly stretched elbow amplifies the rounding error of the angles, so this error
            // depends on the branch.
            let rounding = branch.rounding(Range::rounding(start[index]), most);
            let value = freedom.range.wrap_within(angle, start[index], rounding);
            let (_, beyond) = half_turns((value - angle) * zero.constant(0.5));
            exists = exists & beyond.abs().le(rounding + margin);
            let way = value - start[index];
            square = way.mul_add(way, square);
            values[index] = value;
        }
        exists = exists & arm.reaches(values, self.target);
        let distance = square.sqrt().to_array();
        let values = values.map(|value| value.to_array());
        let exists = exists.to_bitmask();
        let singular = branch.singular.map(|mask| mask.to_bitmask());
        for (lane, slot) in found.iter_mut().enumerate() {
            if exists >> lane & 1 == 0 {
                continue;
            }
            let mut solution = Solution::default();
            for (value, array) in solution.values.iter_mut().zip(&values) {
                *value = array.as_ref().get(lane).copied().unwrap_or_default();
            }
            solution.distance = distance.as_ref().get(lane).copied().unwrap_or_default();
            let [shoulder, elbow, wrist] = singular.map(|mask| mask >> lane & 1 == 1);
            solution.singular = Singular { shoulder, elbow, wrist };
            slot.insert(solution);
        }
    }
}

impl<R: Scalar> SixAxisArm<'_, R> {
    /// Returns the largest angle by which a solution may miss the target, in radians, which is also
    /// the largest distance as a fraction of the arm's size: 16 times the tolerance of the family.
    fn tolerance(&self) -> R {
        self.geometry.tolerance * R::from(16.0)
    }

    /// Returns the lanes in which the forward kinematics of the mechanism reaches the target with
    /// these values.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn reaches<L: Lanes<Real = R>>(&self, values: [L; 6], target: batch::DualQuat<L>) -> L::Mask {
        let (reach, level) = (&self.reach, values[0].level());
        let mut pose = HalfPose::<L>::identity(level);
        let mut values = values.into_iter();
        for (position, step) in reach.mechanism.steps.iter().enumerate() {
            if !reach.moves_goal(position) {
                continue;
            }
            pose = if step.parent == NONE {
                HalfPose::on_base(level, step)
            } else {
                pose.joint_frame(step)
            };
            if let JointKind::Revolute { .. } = step.kind
                && let Some(value) = values.next()
            {
                let [cos, sin] = checked_cos_sin(value * value.constant(0.5));
                pose.rotation =
                    pose.rotation_about_axis(step, cos, sin * L::splat(level, step.sign));
            }
        }
        let goal = reach.goals.first().map_or([R::ZERO; 3], |goal| goal.point);
        let half = vector::scale(vector::splat(level, goal), L::splat(level, R::HALF));
        let half = pose.moved(half);
        let way = vector::sub(vector::add(half, half), target.translation());
        let turn = (batch::Quat::from_array(pose.rotation).conjugate() * target.rotation()).xyz();
        let tolerance = L::splat(level, self.tolerance());
        let far = tolerance * L::splat(level, self.geometry.size);
        vector::dot(turn, turn).le(tolerance * tolerance) & vector::dot(way, way).le(far * far)
    }
}

/// The number of starts for each target. 64 starts find 99.8 of 100 solutions of random targets,
/// and 32 starts find 98.
const STARTS: usize = 64;
/// The limit above which two results of searches count as different solutions: the sine of half the
/// largest difference of an angle.
const DISTINCT: f32 = 1e-3;

/// Returns the total number of values in all starts of a target's searches.
fn starts_len<R: Copy>(reach: &Reach<'_, R>) -> usize {
    reach.mechanism.values.saturating_mul(STARTS)
}

/// The inputs and outputs of the searches that find all solutions for one target.
struct Starts<'s, R> {
    reach: &'s Reach<'s, R>,
    target: DualQuat<R>,
    start: &'s [R; 6],
    /// Before the search, the solutions by the formulas of a family to which the arm nearly
    /// belongs. After the search, the solutions of the arm itself.
    found: &'s mut Solutions<R>,
    /// Memory for [`STARTS`] configurations.
    values: &'s mut [R],
}

impl<R: Scalar> Starts<'_, R> {
    /// Finds the solutions to which `search` converges. The searches start from the solutions of
    /// the formulas in `found`. If there are none, they start from `start` and from values that are
    /// spread evenly within the limits.
    fn search_all(self, search: impl FnOnce(Work<'_, R>)) {
        let Self { reach, target, start, found, values } = self;
        let fine = R::from(if R::EPSILON > R::from(1e-10) { 1e-5 } else { 1e-10 });
        let options = Options {
            angular_tolerance: fine,
            linear_tolerance: fine,
            max_iterations: 50,
            restarts: false,
            ..Options::default()
        };
        values.fill(R::ZERO);
        let size = reach.mechanism.values.max(1);
        let hinges = || reach.freedoms.iter().zip(start);
        let guesses = *found;
        let count = if guesses.is_empty() { STARTS } else { guesses.len() };
        let values = values.get_mut(..count * size).unwrap_or_default();
        for (number, values) in (0..).zip(values.chunks_exact_mut(size)) {
            let guess = guesses.get(number as usize);
            for (hinge, (freedom, &start)) in hinges().enumerate() {
                let guess = guess.and_then(|guess| guess.values.get(hinge));
                if let Some(slot) = values.get_mut(freedom.value as usize) {
                    *slot = match guess {
                        Some(&guess) => guess,
                        None if number == 0 => start,
                        None => freedom.sample(number),
                    };
                }
            }
        }
        let (targets, mut reports) = ([target; STARTS], [Report::default(); STARTS]);
        let reports = reports.get_mut(..count).unwrap_or_default();
        let targets = targets.get(..count).unwrap_or_default();
        search(Work {
            targets,
            values,
            reports: &mut *reports,
            settings: (&options).into(),
            clips: None,
        });
        found.clear(false);
        for (values, report) in values.chunks_exact(size).zip(reports) {
            if !report.is_converged() {
                continue;
            }
            let mut solution = Solution::default();
            for ((freedom, &start), slot) in hinges().zip(&mut solution.values) {
                let value = values.get(freedom.value as usize).copied().unwrap_or_default();
                let [value, to] =
                    [value, start].map(|value| R::Lanes::<Portable>::splat(Portable, value));
                let wrapped =
                    freedom.range.wrap(value, freedom.range.wrap(to, freedom.range.clamp(to)));
                *slot = wrapped.to_array().as_ref().first().copied().unwrap_or_default();
                solution.distance += (*slot - start) * (*slot - start);
            }
            solution.distance = solution.distance.sqrt();
            let is_known = found.iter().any(|known| {
                let pairs = known.values.iter().zip(&solution.values);
                pairs
                    .into_iter()
                    .all(|(&a, &b)| ((a - b) * R::HALF).sin().abs() < R::from(DISTINCT))
            });
            if !is_known {
                found.insert(solution);
            }
        }
    }
}
