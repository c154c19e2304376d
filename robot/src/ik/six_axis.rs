//! All solutions for arms of six hinges.

use super::branches::Arm;
use super::complex::Complex;
use super::error::SolutionsError;
use super::family::{Family, Geometry, fit};
use super::problem::Reach;
use super::solutions::{Singular, Solution, Solutions};
use crate::mechanism::joint::JointKind;
use crate::mechanism::placed::Placed;
use crate::mechanism::step::{NONE, UNIT};
use crate::mechanism::values::half_turn;
use dq8::batch::{self, cos_sin, half_turns, vector};
use dq8::seams::{Choice, Rows};
use dq8::storage::same_length;
use dq8::{DualQuat, Kernel, Real, Scalar};
use dq8_simd::{Lanes, Level, Mask, Portable};

/// An arm of six hinges that carries the only goal of a [`Reach`], a whole pose: what it is, found once, for all of the
/// ways in which it reaches a target.
#[derive(Clone, Copy, Debug)]
pub struct SixAxisArm<'a, R> {
    pub(super) reach: Reach<'a, R>,
    pub(super) geometry: Geometry<R>,
}

impl<'a, R: Real> SixAxisArm<'a, R> {
    /// # Errors
    /// If there are other goals, or it leaves something free, or what carries its link are not six hinges, each with a value of its own, and fixed joints.
    pub fn new(reach: Reach<'a, R>) -> Result<Self, SolutionsError> {
        Ok(Self { reach, geometry: Geometry::of(&reach)? })
    }

    /// How its axes lie.
    #[must_use]
    pub fn family(&self) -> Family {
        self.geometry.family
    }

    /// Many targets at a time.
    #[must_use]
    pub fn job(self) -> SolutionsJob<'a, R> {
        SolutionsJob { arm: self, choice: Choice::default() }
    }
}

impl<R> SixAxisArm<'_, R>
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    /// All solutions for a target.
    ///
    /// # Errors
    /// If a number is not finite, or the target not unit.
    pub fn solutions(
        &self,
        target: DualQuat<R>,
        start: &[R; 6],
    ) -> Result<Solutions<R>, SolutionsError> {
        let mut found = [Solutions::default()];
        check(&[target], &[*start])?;
        run::<R>(Portable, self, &[target], &[*start], &mut found);
        let [found] = found;
        Ok(found)
    }
}

/// Many targets.
#[derive(Clone, Copy, Debug)]
pub struct SolutionsJob<'a, R> {
    arm: SixAxisArm<'a, R>,
    choice: Choice,
}

impl<R> SolutionsJob<'_, R> {
    dq8::seams::options!();
}

impl<R: Scalar> SolutionsJob<'_, R> {
    /// [`SixAxisArm::solutions`] for many targets, each with a start of its own.
    ///
    /// # Errors
    /// As there, and if there are not as many starts and places for what is found as targets; nothing is written.
    pub fn solutions(
        &self,
        targets: &[DualQuat<R>],
        starts: &[[R; 6]],
        found: &mut [Solutions<R>],
    ) -> Result<(), SolutionsError> {
        same_length("starts", starts.len(), targets.len())?;
        same_length("found", found.len(), targets.len())?;
        check(targets, starts)?;
        let backend = self.choice.instructions();
        let arm = &self.arm;
        backend.share(256, (found, 1), &|first, (found, _): Rows<Solutions<R>>| {
            let targets = targets.get(first..).unwrap_or_default();
            let starts = starts.get(first..).unwrap_or_default();
            backend.run(Targets { arm, targets, starts, found });
        });
        Ok(())
    }
}

fn check<R: Real>(targets: &[DualQuat<R>], starts: &[[R; 6]]) -> Result<(), SolutionsError> {
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
            let value = freedom.range.nearest(value, freedom.range.clamp(value));
            let (re, im) = cos_sin(value);
            (start[index], turns[index]) = (value, Complex { re, im });
        }
        let branches = Arm::new(level, &arm.geometry, target, turns).solve();
        for slot in found.iter_mut().skip(first).take(L::LANES) {
            slot.clear(true);
        }
        for branch in &branches {
            let mut exists = branch.exists;
            let (mut values, mut square) = ([zero; 6], zero);
            for (index, freedom) in arm.reach.freedoms.iter().enumerate().take(6) {
                let angle = branch.turns[index].angle();
                let value = freedom.range.nearest(angle, start[index]);
                let (_, beyond) = half_turns((value - angle) * zero.constant(0.5));
                let rounding = (value.abs() + zero.constant(4.0))
                    * zero.constant(4.0 * vector::epsilon::<L>());
                exists = exists & beyond.abs().le(rounding);
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

impl<R: Real> SixAxisArm<'_, R> {
    /// Whether values bring the tool to the target, by the mechanism as it is.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn is_there<L: Lanes<Real = R>>(&self, values: [L; 6], target: batch::DualQuat<L>) -> L::Mask
    where
        R: Scalar,
    {
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
        let fit = L::splat(level, fit::<R>() * R::from(16.0));
        let far = fit * L::splat(level, self.geometry.size);
        vector::dot(turn, turn).le(fit * fit) & vector::dot(way, way).le(far * far)
    }
}
