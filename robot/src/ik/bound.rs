//! How far links get.

use super::problem::Reach;
use super::range::Range;
use crate::mechanism::joint::JointKind;
use crate::mechanism::step::{Step, UNIT};
use dq8::Real;
use dq8::scalar::{DualQuat, vector};

impl<R: Real> Reach<'_, R> {
    /// A point that no joint moves, and a distance from it that the link of goal number `goal`
    /// never exceeds: the sum of the offsets between joints, and of what slides add. Farther
    /// targets are out of reach; nearer ones may be. `None` if there is no such distance (something
    /// floats, or slides without end), no joint carries the link, or there is no such goal.
    #[must_use]
    pub fn reach_bound(&self, goal: usize) -> Option<([R; 3], R)> {
        let goal = self.goals.get(goal)?;
        let mut link = goal.link;
        // From the link to the base. What lies below the lowest joint that moves is rigid: it
        // places the centre, and adds nothing to the distance, so the base is kept at the last
        // joint with a value.
        let (mut length, mut base) = (norm(goal.point), None);
        while let Some(step) = self.mechanism.step(link) {
            if step.kind.values() > 0 {
                length += self.slide(step);
                base = Some((link, length));
            }
            length += norm(step.placement().translation());
            link = step.parent as usize;
        }
        let (mut link, length) = base.filter(|(_, length)| length.is_finite())?;
        let mut centre = [R::ZERO; 3];
        while let Some(step) = self.mechanism.step(link) {
            centre = step.placement().transform_point(centre);
            link = step.parent as usize;
        }
        Some((centre, length))
    }

    /// How far a joint slides; infinite if there is no end.
    #[inline(never)]
    fn slide(&self, step: &Step<R>) -> R {
        let infinite = R::ONE / R::ZERO;
        let freedom = self.freedoms.get(self.column(step.rate as usize)).copied();
        let freedom = freedom.unwrap_or_default();
        let Range { low, high, .. } = freedom.range;
        // Where this joint mimics another, the limits are the other's.
        let [low, high] = [low, high].map(|end| {
            let value = end * step.multiplier + step.offset;
            value.abs()
        });
        let most = if freedom.has_ends() { low.max_or_nan(high) } else { infinite };
        match step.kind {
            JointKind::Prismatic { .. } => most,
            JointKind::Screw { pitch, .. } if pitch != R::ZERO => most * pitch.abs(),
            JointKind::Planar { .. } | JointKind::Floating => infinite,
            _ => R::ZERO,
        }
    }

    /// The longest way to a goal, without what slides without end; 1 if there is none.
    pub(super) fn typical_length(&self) -> R {
        let mut longest = R::ZERO;
        for goal in self.goals {
            let (mut length, mut link) = (norm(goal.point), goal.link);
            while let Some(step) = self.mechanism.step(link) {
                let slide = self.slide(step);
                length += if slide.is_finite() { slide } else { R::ZERO };
                length += norm(step.placement().translation());
                link = step.parent as usize;
            }
            longest = if length > longest { length } else { longest };
        }
        if longest > R::ZERO && longest.is_finite() { longest } else { R::ONE }
    }

    /// The typical length, or where something floats or slides without end, a longer way that it
    /// has to go.
    pub(super) fn typical_length_to(&self, targets: &[DualQuat<R>], values: &[R]) -> R {
        let mut longest = self.facts.size;
        if self.facts.is_endless {
            for target in targets {
                longest = longest.max_or_nan(norm(target.translation()));
            }
            for (position, step) in self.mechanism.steps.iter().enumerate() {
                if self.moves_goal(position) {
                    longest = longest.max_or_nan(slid(step, values));
                }
            }
        }
        longest
    }

    /// Whether something that moves a goal floats or slides without end, a thread too.
    pub(super) fn has_endless_slides(&self) -> bool {
        let mut has = false;
        for (position, step) in self.mechanism.steps.iter().enumerate() {
            has |= self.moves_goal(position) && !self.slide(step).is_finite();
        }
        has
    }

    /// The target of a goal, exactly unit; one beyond the bound is drawn to its edge, because from
    /// beyond it would pull the harder the farther it is. The way that it was drawn, if it was.
    /// `None` if it is not a target.
    pub(super) fn clamped(
        &self,
        goal: usize,
        target: DualQuat<R>,
        tolerance: R,
    ) -> Option<(DualQuat<R>, Option<[R; 3]>)> {
        if !(target.is_unit(R::from(UNIT)) && target.to_array().into_iter().all(Real::is_finite)) {
            return None;
        }
        let target = target.normalize();
        // With a free axis, the nearest point to aim at may lie anywhere along it.
        let asked = self.goals.get(goal)?.linear.into_iter().all(|weight| weight > R::ZERO);
        let bound = if goal == 0 { self.facts.bound } else { self.reach_bound(goal) };
        let Some((centre, length)) = bound.filter(|_| asked) else {
            return Some((target, None));
        };
        let way = vector::sub(target.translation(), centre);
        let far = norm(way);
        if !far.is_finite() {
            return None;
        }
        // All three have been rounded, the places to parts of their distance from the base.
        let sizes = length + norm(centre) + norm(target.translation());
        if far <= length + R::from(64.0) * R::EPSILON * sizes + tolerance {
            return Some((target, None));
        }
        let edge = vector::add(centre, vector::scale(way, length / far));
        let drawn = vector::sub(target.translation(), edge);
        Some((DualQuat::from_rotation_translation(target.rotation(), edge), Some(drawn)))
    }
}

/// The length of a vector: in firmware once in machine code.
#[cfg_attr(target_os = "none", inline(never))]
fn norm<R: Real>(vector: [R; 3]) -> R {
    vector::norm(vector)
}

/// The longest way along one direction that a joint has slid.
fn slid<R: Real>(step: &Step<R>, values: &[R]) -> R {
    let (lengths, factor) = match step.kind {
        JointKind::Prismatic { .. } => (0..1, R::ONE),
        JointKind::Screw { pitch, .. } => (0..1, pitch),
        JointKind::Planar { .. } => (0..2, R::ONE),
        JointKind::Floating => (4..7, R::ONE),
        JointKind::Fixed | JointKind::Revolute { .. } => return R::ZERO,
    };
    let mut longest = R::ZERO;
    for index in lengths {
        let value = values.get(step.value as usize + index).copied().unwrap_or_default();
        let length = (value * step.multiplier + step.offset) * factor;
        longest = longest.max_or_nan(length.abs());
    }
    longest
}
