//! Arms of six hinges: the arm, its solutions, and the walk from targets to all of them.
//!
//! Arms of the two families are solved by formula (`branches.rs`), and every solution is put
//! through the mechanism once more before it counts. Other arms are searched from many starts.

use super::branches::{Arm, Complex};
use super::family::{Family, Geometry};
use super::freedom::Range;
use super::problem::Reach;
use super::report::{Options, Report};
use super::scratch::enough;
use super::search::Work;
use crate::mechanism::joint::JointKind;
use crate::mechanism::step::{NONE, UNIT};
use crate::mechanism::values::checked_cos_sin;
use crate::mechanism::walk::HalfPose;
use core::ops::Deref;
use dq8::batch::{self, cos_sin, half_turns, vector};
#[cfg(feature = "alloc")]
use dq8::seams::Rows;
use dq8::seams::{Choice, errors};
use dq8::storage::same_length;
use dq8::{Backend, DualQuat, Kernel, Real, Scalar, ShapeError};
use dq8_simd::{Lanes, Level, Mask, Portable};

/// An arm of six hinges that carries the only goal of a [`Reach`], a whole pose: what it is, found
/// once, to say all of the ways in which it reaches a target.
///
/// Arms of two [families](Family), which nearly all of industry is made of, have up to eight, and
/// all of them are found, by formula. A turn of a hinge more or less is no other way: of those
/// within the limits the nearest to the start is given. Each is checked by the mechanism itself,
/// which is then at the target but for rounding; so a target may be out of reach by 64 units of the
/// last place (2⁻⁵² or 2⁻²³) of the arm's size. For other arms there are searches from
/// many starts: some 99 of 100 are found. Where axes miss a family by 10⁻³ at most, as of arms
/// whose angles were typed with few digits, the starts are what its formula finds, which are far
/// fewer.
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
    /// Looks at the axes. Those that are to be parallel, or to meet, may be apart by 10⁻⁸
    /// radians and of the arm's size (`f32`: 10⁻⁵). A posture has no part in it.
    ///
    /// # Errors
    /// If there are other goals, or it is none of a whole pose, or what carries its link are not
    /// six hinges with values of their own and fixed joints.
    pub fn new(reach: Reach<'a, R>) -> Result<Self, SolutionsError> {
        let reach = Reach { posture: None, ..reach };
        Ok(Self { geometry: Geometry::of(&reach)?, reach })
    }

    /// How its axes lie.
    #[must_use]
    pub fn family(&self) -> Family {
        if self.geometry.is_exact() { self.geometry.family } else { Family::Other }
    }

    /// Where the values of the six hinges are among all of the mechanism.
    #[must_use]
    pub fn values(&self) -> [usize; 6] {
        let mut values = [0; 6];
        for (slot, freedom) in values.iter_mut().zip(self.reach.freedoms) {
            *slot = freedom.value as usize;
        }
        values
    }

    /// How many numbers [`solutions`](Self::solutions) needs to compute in: none for the two
    /// families.
    #[must_use]
    pub fn scratch_len(&self) -> usize {
        self.with_values(self.reach.scratch_len())
    }

    /// How many a [`SolutionsJob`](super::SolutionsJob) needs, with any instructions: none for the
    /// two families.
    #[must_use]
    pub fn batch_scratch_len(&self) -> usize {
        self.with_values(self.reach.batch_scratch_len())
    }

    fn with_values(&self, scratch: usize) -> usize {
        let is_other = self.family() == Family::Other;
        if is_other { scratch.saturating_add(remembered(&self.reach)) } else { 0 }
    }
}

pub(super) fn check<R: Real>(
    targets: &[DualQuat<R>],
    starts: &[[R; 6]],
) -> Result<(), SolutionsError> {
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

/// All ways in which an arm of six hinges has its tool at a target, the nearest to the start first.
/// A slice of them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solutions<R> {
    all: [Solution<R>; 8],
    count: usize,
    /// Whether there are no others. False where they were searched for: then there may be more.
    pub is_complete: bool,
}

/// One way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solution<R> {
    /// The values of the six hinges, from the base up, within their limits; of the turns that are
    /// there, the nearest to the start.
    pub values: [R; 6],
    /// How far they are from the start: the root of the sum of squares, radians.
    pub distance: R,
    /// Where the arm can move without moving its tool, or comes no farther.
    pub singular: Singular,
}

/// At which of its joints a solution is singular: it is two that meet, where the target is at the
/// edge of what can be reached, or one of infinitely many, of which the one with the angle of the
/// start is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Singular {
    /// The first axis. The centre of the wrist is on it, or as far from the plane of the arm as it
    /// gets.
    pub shoulder: bool,
    /// The second and third axis. The arm is stretched, or folded.
    pub elbow: bool,
    /// The fifth axis. It has put the last axis along one before.
    pub wrist: bool,
}

impl Singular {
    /// Whether it is singular at all.
    #[must_use]
    pub fn any(self) -> bool {
        self.shoulder || self.elbow || self.wrist
    }
}

impl<R: Real> Default for Solutions<R> {
    /// None.
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
    /// Behind those that are nearer. Of more than eight, which a search may find, the farthest is
    /// left out.
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
    /// Many targets at a time.
    pub fn job(self) -> SolutionsJob<'a, R> {
        SolutionsJob { arm: self, choice: Choice::default() }
    }
}

impl<R> SixAxisArm<'_, R>
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    /// All values of the six hinges within their limits that bring the tool to a target, the
    /// nearest to `start` first. None if it cannot be reached. `scratch` has
    /// [`scratch_len`](Self::scratch_len) numbers or more, and may hold anything.
    ///
    /// # Errors
    /// If a number is not finite or the target farther than 10⁻³ from unit, or there is too
    /// little scratch.
    pub fn solutions(
        &self,
        target: DualQuat<R>,
        start: &[R; 6],
        scratch: &mut [R],
    ) -> Result<Solutions<R>, SolutionsError> {
        enough(scratch.len(), self.scratch_len())?;
        check(&[target], &[*start])?;
        let mut found = [Solutions::default()];
        if self.geometry.family != Family::Other {
            run::<R>(Portable, self, &[target], &[*start], &mut found);
        }
        let others = if self.geometry.is_exact() { None } else { Some(remembered(&self.reach)) };
        if let (Some((values, scratch)), [found]) =
            (others.and_then(|others| scratch.split_at_mut_checked(others)), &mut found)
        {
            let size = self.reach.mechanism.values;
            search_all(
                &self.reach,
                target,
                start,
                found,
                values,
                |targets, values, reports, options| {
                    let starts = values.chunks_exact_mut(size.max(1)).zip(targets);
                    for ((values, &target), report) in starts.zip(reports) {
                        // Lengths fit; what is not there, has not converged.
                        *report = self
                            .reach
                            .follow(&[target], values, scratch, options)
                            .unwrap_or_default();
                    }
                },
            );
        }
        let [found] = found;
        Ok(found)
    }
}

/// Many targets of a [`SixAxisArm`], as many at a time as there are lanes, with options that all
/// have a default. The solutions of one do not depend on the others.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct SolutionsJob<'a, R> {
    arm: SixAxisArm<'a, R>,
    choice: Choice,
}

impl<R> SolutionsJob<'_, R> {
    dq8::seams::options!();
}

impl<R: Scalar> SolutionsJob<'_, R> {
    /// [`SixAxisArm::solutions`] for many targets, each with a start of its own. Allocates
    /// [`batch_scratch_len`](SixAxisArm::batch_scratch_len) numbers for each task that runs at the
    /// same time.
    ///
    /// # Errors
    /// As there, or if there are not as many starts, or places for what is found, as targets;
    /// nothing is written.
    #[cfg(feature = "alloc")]
    pub fn solutions(
        &self,
        targets: &[DualQuat<R>],
        starts: &[[R; 6]],
        found: &mut [Solutions<R>],
    ) -> Result<(), SolutionsError> {
        self.check(targets, starts, found)?;
        let backend = self.choice.instructions();
        let grain = if self.arm.family() == Family::Other { 1 } else { 256 };
        backend.share(grain, (found, 1), &|first, (found, _): Rows<'_, Solutions<R>>| {
            let targets = targets.get(first..).unwrap_or_default();
            let starts = starts.get(first..).unwrap_or_default();
            let mut scratch = alloc::vec![R::ZERO; self.arm.batch_scratch_len()];
            self.run(backend, &mut scratch, targets, starts, found);
        });
        Ok(())
    }

    /// The same in memory of the caller, without allocation, on the thread that calls: `scratch`
    /// has [`batch_scratch_len`](SixAxisArm::batch_scratch_len) numbers or more, and may hold
    /// anything.
    ///
    /// # Errors
    /// As there, or if there is too little scratch; nothing is written.
    pub fn solutions_in(
        &self,
        scratch: &mut [R],
        targets: &[DualQuat<R>],
        starts: &[[R; 6]],
        found: &mut [Solutions<R>],
    ) -> Result<(), SolutionsError> {
        enough(scratch.len(), self.arm.batch_scratch_len())?;
        self.check(targets, starts, found)?;
        self.run(self.choice.instructions(), scratch, targets, starts, found);
        Ok(())
    }

    fn check(
        &self,
        targets: &[DualQuat<R>],
        starts: &[[R; 6]],
        found: &[Solutions<R>],
    ) -> Result<(), SolutionsError> {
        same_length("starts", starts.len(), targets.len())?;
        same_length("found", found.len(), targets.len())?;
        check(targets, starts)
    }

    fn run(
        &self,
        backend: Backend,
        scratch: &mut [R],
        targets: &[DualQuat<R>],
        starts: &[[R; 6]],
        found: &mut [Solutions<R>],
    ) {
        let arm = &self.arm;
        if arm.geometry.family != Family::Other {
            backend.run(Targets { arm, targets, starts, found: &mut *found });
        }
        if arm.geometry.is_exact() {
            return;
        }
        let split = scratch.split_at_mut_checked(remembered(&arm.reach));
        let Some((values, scratch)) = split else { return };
        for ((&target, start), found) in targets.iter().zip(starts).zip(found) {
            search_all(
                &arm.reach,
                target,
                start,
                found,
                values,
                |targets, values, reports, options| {
                    let work = Work { targets, values, reports, options, clips: None };
                    // The kernel of other searches, told by `options` that it does not begin again;
                    // firmware may have no other.
                    const AGAIN: bool = cfg!(not(target_os = "none"));
                    arm.reach.job().run::<AGAIN, false>(backend, work, scratch);
                },
            );
        }
    }
}

struct Targets<'s, R> {
    arm: &'s SixAxisArm<'s, R>,
    targets: &'s [DualQuat<R>],
    starts: &'s [[R; 6]],
    found: &'s mut [Solutions<R>],
}

impl<R: Scalar> Kernel for Targets<'_, R> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        run::<R::Lanes<V>>(level, self.arm, self.targets, self.starts, self.found);
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn run<L: Lanes<Real: Scalar>>(
    level: L::Level,
    arm: &SixAxisArm<'_, L::Real>,
    targets: &[DualQuat<L::Real>],
    starts: &[[L::Real; 6]],
    found: &mut [Solutions<L::Real>],
) {
    let zero = L::splat(level, L::Real::ZERO);
    // Searches go on from what is only near, and keep within the limits.
    let beside = if arm.geometry.is_exact() { zero } else { L::splat(level, arm.near()) };
    for first in (0..found.len()).step_by(L::LANES) {
        let mut numbers = [zero.to_array(); 14];
        for lane in 0..L::LANES {
            // Lanes that are left over compute along with the last.
            let from = (first + lane).min(found.len() - 1);
            let target = targets.get(from).copied().unwrap_or(DualQuat::IDENTITY);
            let start = starts.get(from).copied().unwrap_or_default();
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
            let value = freedom.range.keep(value, clamped);
            let (re, im) = cos_sin(value);
            (start[index], turns[index]) = (value, Complex { re, im });
        }
        let branches = Arm::new(level, &arm.geometry, target, turns).solve();
        for slot in found.iter_mut().skip(first).take(L::LANES) {
            slot.clear(true);
        }
        for branch in &branches {
            let mut exists = branch.exists;
            if !exists.any() {
                continue;
            }
            let (mut values, mut square) = ([zero; 6], zero);
            let fit = L::splat(level, arm.geometry.fit);
            for (index, freedom) in arm.reach.freedoms.iter().enumerate().take(6) {
                let angle = branch.turns[index].angle();
                // As far as a nearly stretched elbow tells.
                let rounding = branch.rounding(Range::rounding(start[index]), fit);
                let value = freedom.range.nearest(angle, start[index], rounding);
                let (_, beyond) = half_turns((value - angle) * zero.constant(0.5));
                exists = exists & beyond.abs().le(rounding + beside);
                let way = value - start[index];
                square = way.mul_add(way, square);
                values[index] = value;
            }
            exists = exists & arm.is_there(values, target);
            let distance = square.sqrt().to_array();
            let values = values.map(|value| value.to_array());
            let exists = exists.to_bitmask();
            let singular = branch.singular.map(|mask| mask.to_bitmask());
            for (lane, slot) in found.iter_mut().skip(first).take(L::LANES).enumerate() {
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
}

impl<R: Scalar> SixAxisArm<'_, R> {
    /// How far the arm may be from what the formulas say, by how far it is from its family.
    fn near(&self) -> R {
        self.geometry.fit * R::from(16.0)
    }

    /// Whether values bring the tool to the target, by the mechanism as it is.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn is_there<L: Lanes<Real = R>>(&self, values: [L; 6], target: batch::DualQuat<L>) -> L::Mask {
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
        let fit = L::splat(level, self.near());
        let far = fit * L::splat(level, self.geometry.size);
        vector::dot(turn, turn).le(fit * fit) & vector::dot(way, way).le(far * far)
    }
}

/// How many starts. Of the solutions of random targets, 64 find 99.8 in 100, and 32 find 98.
const STARTS: usize = 64;
/// What of half the turn between two values is another solution, and no other end of a search.
const OTHER: f32 = 1e-3;

/// How many numbers it takes to remember them.
pub(super) fn remembered<R: Copy>(reach: &Reach<'_, R>) -> usize {
    reach.mechanism.values.saturating_mul(STARTS)
}

/// The solutions that `search` comes to: from those `found` of an arm that is nearly the same; if
/// there are none, from `start` and from values that are spread evenly within the limits.
pub(super) fn search_all<R: Scalar>(
    reach: &Reach<'_, R>,
    target: DualQuat<R>,
    start: &[R; 6],
    found: &mut Solutions<R>,
    values: &mut [R],
    search: impl FnOnce(&[DualQuat<R>], &mut [R], &mut [Report<R>], &Options<R>),
) {
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
                    None => freedom.beginning(number),
                };
            }
        }
    }
    let (targets, mut reports) = ([target; STARTS], [Report::default(); STARTS]);
    let reports = reports.get_mut(..count).unwrap_or_default();
    search(targets.get(..count).unwrap_or_default(), values, reports, &options);
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
            let near = freedom.range.keep(value, freedom.range.keep(to, freedom.range.clamp(to)));
            *slot = near.to_array().as_ref().first().copied().unwrap_or_default();
            solution.distance += (*slot - start) * (*slot - start);
        }
        solution.distance = solution.distance.sqrt();
        let is_known = found.iter().any(|known| {
            let pairs = known.values.iter().zip(&solution.values);
            pairs.into_iter().all(|(&a, &b)| ((a - b) * R::HALF).sin().abs() < R::from(OTHER))
        });
        if !is_known {
            found.insert(solution);
        }
    }
}

errors! {
    /// What has no solutions to be asked for.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    SolutionsError {
        /// Lengths that do not fit.
        Shape(error: ShapeError) => "{error}";
        /// More goals than one.
        Goals { goals: usize = "How many there are." } => "there are {goals} goals, and one link has solutions";
        /// A goal that leaves some of rotation and position free.
        NoPose => "the goal leaves some of rotation and position free";
        /// A joint that carries the link and is neither fixed nor a hinge with a value of its own.
        Joint { joint: usize = "The joint." }
            => "joint {joint} carries the link, and is no hinge with a value of its own";
        /// More or fewer hinges than six that carry the link.
        Hinges { hinges: usize = "How many there are." } => "{hinges} hinges carry the link, not six";
        /// A target with a number that is not finite.
        Target { index: usize = "The target.", value: f64 = "The number in it." }
            => "target {index} is not finite: {value}";
        /// A target that is farther than 10⁻³ from a unit motion.
        NotUnit { index: usize = "The target.", norm: f64 = "The norm of its real part." }
            => "target {index} is not a unit motion: the norm of its real part is {norm}";
        /// A value of a start that is not finite.
        Start { index: usize = "The start.", hinge: usize = "The hinge.", value: f64 = "What it is." }
            => "value {hinge} of start {index} is not finite: {value}";
    }
}
