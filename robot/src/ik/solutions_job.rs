//! All solutions, for one target and for many.

use super::branches::Arm;
use super::complex::Complex;
use super::error::SolutionsError;
use super::family::Family;
use super::range::Range;
use super::scratch::enough;
use super::search::Work;
use super::six_axis::{SixAxisArm, check};
use super::solutions::{Singular, Solution, Solutions};
use super::starts::{self, search_all};
use crate::mechanism::joint::JointKind;
use crate::mechanism::step::NONE;
use crate::mechanism::values::half_turn;
use crate::mechanism::walk::Placed;
use dq8::batch::{self, cos_sin, half_turns, vector};
use dq8::seams::Choice;
#[cfg(feature = "alloc")]
use dq8::seams::Rows;
use dq8::storage::same_length;
use dq8::{Backend, DualQuat, Kernel, Real as _, Scalar};
use dq8_simd::{Lanes, Level, Mask, Portable};

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
        let others =
            if self.geometry.is_exact() { None } else { Some(starts::values(&self.reach)) };
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
        let split = scratch.split_at_mut_checked(starts::values(&arm.reach));
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
        let mut pose = Placed::<L>::identity(level);
        let mut values = values.into_iter();
        for (position, step) in reach.mechanism.steps.iter().enumerate() {
            if !reach.moves_goal(position) {
                continue;
            }
            pose = if step.parent == NONE { Placed::root(level, step) } else { pose.place(step) };
            if let JointKind::Revolute { .. } = step.kind
                && let Some(value) = values.next()
            {
                let [cos, sin] = half_turn(value * value.constant(0.5));
                pose.rotation = pose.turn(step, cos, sin * L::splat(level, step.sign));
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
