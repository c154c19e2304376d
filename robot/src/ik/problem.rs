//! [`Reach`], an inverse kinematics problem: a mechanism and goals for its links, facts about both
//! that are computed once, and bounds on the reach of a link.

use super::freedom::{Freedom, Range, freedoms, tree_shape};
use super::goal::{Goal, ReachError};
use crate::mechanism::job::carries;
use crate::mechanism::joint::JointKind;
use crate::mechanism::step::{Step, UNIT};
use crate::mechanism::tree::Mechanism;
use dq8::Real;
use dq8::internal::brief;
use dq8::scalar::{DualQuat, vector};

/// An inverse kinematics problem: a mechanism and goals for its links, checked once. Targets and
/// starts are arguments of each search: [`solve`](Self::solve) for one configuration, and the
/// methods of [`job`](Self::job) for many configurations.
///
/// It borrows memory of the caller: the goals, and a [`Freedom`] for each rate of the mechanism.
/// [`OwnedReach`](super::OwnedReach) owns this memory.
///
/// Joints of every kind are moved, within their limits. Joints that carry no link with a goal keep
/// their values.
///
/// A hinge has the same pose after a turn by 2π. Among the values within its limits that give the
/// same pose, the result is the value nearest to the start. A start beyond the limits is first
/// brought within them by whole turns, if that is possible. This does not apply to screw joints,
/// and to hinges that another joint mimics with a multiplier that is no integer, because a whole
/// turn gives another pose there. Far from zero, the distance between neighbouring floats is a
/// large angle. So hinges whose limits span more than 16 turns stay within 64 radians of zero in
/// `f32` and 2²⁰ in `f64`. If their limits exclude this range, they stay in the turn between the
/// limits that is nearest to zero.
///
/// Joints that mimic other joints follow them, within the limits of both joints. Limits of the
/// follower that would leave no range are [ignored](Mechanism::value_limits). A floating joint
/// turns about the axes of its link and then slides; its quaternion keeps the sign of the start.
///
/// ```
/// use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach};
/// use dq8_robot::{Joint, Mechanism, Step};
/// use dq8::{DualQuat, Quat};
/// // Two links of length 1 in a plane, and a wrist.
/// let out = DualQuat::from_translation([1.0_f64, 0.0, 0.0]);
/// let joints = [(None, DualQuat::IDENTITY), (Some(0), out), (Some(1), out)]
///     .map(|(on, at)| Joint::revolute(on, at, [0.0, 0.0, 1.0]));
/// let mut steps = [Step::default(); 3];
/// let arm = Mechanism::new(&joints, &mut steps)?;
///
/// let (goals, mut freedoms) = ([Goal::pose(2)], [Freedom::default(); 3]);
/// let reach = Reach::new(arm, &goals, &mut freedoms)?;
/// let mut scratch = [0.0; 160];
/// assert!(reach.scratch_len() <= scratch.len());
///
/// let turn = Quat::from_axis_angle([0.0, 0.0, 1.0], 1.0);
/// let target = DualQuat::from_rotation_translation(turn, [1.2, 0.8, 0.0]);
/// let mut angles = [0.1, 0.2, 0.3];
/// let report = reach.solve(&[target], &mut angles, &mut scratch, &Options::default())?;
/// assert_eq!(report.outcome, Outcome::Converged);
/// assert!(arm.link_pose(&angles, 2)?.distance_to(target) < 1e-5);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
#[doc(alias("inverse_kinematics"))]
pub struct Reach<'a, R> {
    pub(super) mechanism: Mechanism<'a, R>,
    pub(super) goals: &'a [Goal<R>],
    /// The freedoms that move the link of a goal.
    pub(super) freedoms: &'a [Freedom<R>],
    /// The memory of all freedoms, one element for each rate of the mechanism. The `column` of the
    /// element at a rate's index is the index of the rate's freedom in `freedoms`.
    pub(super) by_rate: &'a [Freedom<R>],
    /// The preferred configuration, one value for each value of the mechanism.
    pub(super) posture: Option<&'a [R]>,
    pub(super) facts: Facts<R>,
}

brief!([R] Reach<'_, R>: Reach |it| { mechanism: it.mechanism, goals: it.goals.len() });

/// Properties of a problem, which are computed once.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facts<R> {
    /// The number of weighted components of all goals, which are the rows of the Jacobian.
    pub(super) rows: usize,
    /// The number of screws of all joints up to the last joint that moves a goal.
    pub(super) twists: usize,
    /// The number of entries of the sparse normal equations of `tree.rs`, or zero if the problem
    /// cannot use these equations.
    pub(super) tree: usize,
    /// `true` if no goal has weights that differ from axis to axis.
    pub(super) is_even: bool,
    /// `true` if any joint that moves a goal mimics another joint.
    pub(super) any_mimics: bool,
    /// A length that is typical of the mechanism.
    pub(super) size: R,
    /// `true` if any joint that moves a goal is a floating joint, or a prismatic or screw joint
    /// without limits.
    pub(super) is_endless: bool,
    /// A point, and the largest distance from it that the link of the first goal can reach.
    pub(super) bound: Option<([R; 3], R)>,
    /// `true` if the reach of the link of any other goal has a bound. None has on a floating base,
    /// and walks to the base for each target would take a quarter of a search on lanes.
    pub(super) any_other_bound: bool,
}

impl<'a, R: Real> Reach<'a, R> {
    /// Makes a problem from a mechanism and goals, and checks both.
    ///
    /// # Errors
    /// If there is no goal. If a goal is for a link that does not exist or that no joint moves, has
    /// a weight that is neither zero nor between 10⁻⁶ and 10⁶, has only weights of zero, or
    /// has a point that is not finite. If there are fewer freedoms than rates. If the limits of a
    /// joint that moves a goal, and the limits of the joints that mimic it, leave no value, or are
    /// angles that floats do not tell apart. `freedoms` may have been written.
    pub fn new(
        mechanism: Mechanism<'a, R>,
        goals: &'a [Goal<R>],
        freedoms: &'a mut [Freedom<R>],
    ) -> Result<Self, ReachError> {
        if goals.is_empty() {
            return Err(ReachError::NoGoals);
        }
        let mut rows = 0;
        for (index, goal) in goals.iter().enumerate() {
            check(goal, index, mechanism.links())?;
            if !is_moved(mechanism.steps, goal.link) {
                return Err(ReachError::Unmoved { goal: index, link: goal.link });
            }
            rows += goal.rows();
        }
        let room = freedoms.len();
        let Some(by_rate) = freedoms.get_mut(..mechanism.rates) else {
            return Err(ReachError::Freedoms { freedoms: room, rates: mechanism.rates });
        };
        let steps = mechanism.steps;
        let moves = |position| moves_any(steps, position, goals);
        let count = self::freedoms(steps, by_rate, moves)?;
        let tree = tree_shape(steps, rows, by_rate, count, moves);
        let by_rate: &'a [Freedom<R>] = by_rate;
        let (mut twists, mut any_mimics) = (0, false);
        for (position, step) in steps.iter().enumerate() {
            if moves(position) {
                twists = step.twist as usize + step.kind.rates();
                any_mimics |= step.mimics;
            }
        }
        let freedoms = by_rate.get(..count).unwrap_or_default();
        let is_even = goals.iter().all(Goal::is_even);
        let (size, is_endless, bound, any_other_bound) = (R::ONE, false, None, false);
        let facts = Facts {
            rows,
            twists,
            tree,
            is_even,
            any_mimics,
            size,
            is_endless,
            bound,
            any_other_bound,
        };
        let mut reach = Self { mechanism, goals, freedoms, by_rate, posture: None, facts };
        reach.facts.size = reach.typical_length();
        reach.facts.is_endless = reach.has_endless_slides();
        reach.facts.bound = reach.reach_bound(0);
        for goal in 1..goals.len() {
            reach.facts.any_other_bound |= reach.reach_bound(goal).is_some();
        }
        Ok(reach)
    }

    /// Returns this problem with a preferred configuration, the posture. The posture has no weight
    /// against the goals: it acts in the null space of their Jacobian (Liégeois 1977). A search
    /// that has reached its targets goes on toward these values as far as the goals leave freedom.
    /// The search ends when it is within the angular tolerance of the posture, has come no nearer
    /// in 60 iterations, moves by less than 10⁻⁴ rad (so `max_step` should be larger), or has
    /// used up its iterations. With a [`Tracking::posture_weight`](super::Tracking::posture_weight)
    /// the posture acts in every step instead. If a value lies beyond a limit, the limit is
    /// preferred. Floating joints have no preference.
    ///
    /// # Errors
    /// If there are not as many values as a configuration has, or a value is not finite.
    pub fn with_posture(self, values: &'a [R]) -> Result<Self, ReachError> {
        let (length, expected) = (values.len(), self.mechanism.values);
        if length != expected {
            return Err(ReachError::PostureLength { length, expected });
        }
        for (index, &value) in values.iter().enumerate() {
            if !value.is_finite() {
                return Err(ReachError::Posture { index, value: value.into() });
            }
        }
        Ok(Self { posture: Some(values), ..self })
    }
}

impl<'a, R: Copy> Reach<'a, R> {
    /// Returns the mechanism.
    #[must_use]
    pub fn mechanism(&self) -> Mechanism<'a, R> {
        self.mechanism
    }

    /// Returns the goals. A search takes one target for each goal of each configuration.
    #[must_use]
    pub fn goals(&self) -> &'a [Goal<R>] {
        self.goals
    }

    /// Returns the index of a rate's freedom among the freedoms that move a goal. It is the index
    /// of the Jacobian's column too.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn column(&self, rate: usize) -> usize {
        self.by_rate.get(rate).map_or(usize::MAX, |freedom| freedom.column as usize)
    }

    /// Returns `true` if a step of second order is worth its cost: if a goal asks for a whole pose.
    pub(super) fn needs_second_order(&self) -> bool
    where
        R: Real,
    {
        let mut needs_second_order = false;
        for goal in self.goals {
            needs_second_order |= goal.is_pose();
        }
        needs_second_order
    }

    /// Returns `true` if the joint whose step is at `position` moves a goal: there is a goal for
    /// its link, or for a link that its link carries.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn moves_goal(&self, position: usize) -> bool {
        moves_any(self.mechanism.steps, position, self.goals)
    }

    /// Returns the first row of a goal's error.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn first_row(&self, goal: usize) -> usize
    where
        R: Real,
    {
        let mut row = 0;
        for goal in self.goals.iter().take(goal) {
            row += goal.rows();
        }
        row
    }

    /// Returns `true` if the joint whose step is at `position` carries the link of `goal`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn moves(&self, position: usize, goal: &Goal<R>) -> bool {
        carries(self.mechanism.steps, position, &[goal.link])
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn moves_any<R>(steps: &[Step<R>], position: usize, goals: &[Goal<R>]) -> bool {
    for goal in goals {
        if carries(steps, position, &[goal.link]) {
            return true;
        }
    }
    false
}

/// Returns `true` if a joint with a value carries the link.
fn is_moved<R: Real>(steps: &[Step<R>], link: usize) -> bool {
    let moves = |step: &Step<R>| step.kind.rates() > 0 && step.multiplier != R::ZERO;
    let mut positions = steps.iter().enumerate();
    positions.any(|(position, step)| moves(step) && carries(steps, position, &[link]))
}

fn check<R: Real>(goal: &Goal<R>, index: usize, links: usize) -> Result<(), ReachError> {
    if goal.link >= links {
        return Err(ReachError::Link { goal: index, link: goal.link, links });
    }
    for (component, weight) in goal.angular.into_iter().chain(goal.linear).enumerate() {
        // Between these bounds the square of a weight neither overflows nor becomes zero in `f32`.
        let is_moderate = weight >= R::from(1e-6) && weight <= R::from(1e6);
        if !(weight == R::ZERO || is_moderate) {
            return Err(ReachError::Weight { goal: index, component, value: weight.into() });
        }
    }
    for (component, number) in goal.point.into_iter().enumerate() {
        if !number.is_finite() {
            return Err(ReachError::Point { goal: index, component, value: number.into() });
        }
    }
    if goal.rows() == 0 {
        return Err(ReachError::NoWeight { goal: index });
    }
    Ok(())
}

impl<R: Real> Reach<'_, R> {
    /// Returns a point that no joint moves, and a distance from this point that the link of the
    /// goal at index `goal` never exceeds: the sum of the offsets between joints and of the lengths
    /// by which joints slide. Farther targets are out of reach; nearer targets may be out of reach
    /// too. Returns `None` if a joint floats or slides without limits, if no joint carries the
    /// link, or if there is no such goal.
    #[must_use]
    pub fn reach_bound(&self, goal: usize) -> Option<([R; 3], R)> {
        let goal = self.goals.get(goal)?;
        let mut link = goal.link;
        // This loop walks from the link to the base. The joint with a value that is nearest to the
        // base turns about a point that no joint moves: the centre. Offsets between that joint and
        // the base are rigid and add nothing, so the distance is the sum at that joint.
        let (mut length, mut base) = (norm(goal.point), None);
        while let Some(step) = self.mechanism.step(link) {
            if step.kind.values() > 0 {
                length += self.slide_length(step);
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

    /// Returns the largest distance by which a joint can slide; infinity if the joint has no
    /// limits.
    #[inline(never)]
    fn slide_length(&self, step: &Step<R>) -> R {
        let infinite = R::ONE / R::ZERO;
        let freedom = self.freedoms.get(self.column(step.rate as usize)).copied();
        let freedom = freedom.unwrap_or_default();
        let Range { low, high, .. } = freedom.range;
        // The limits of a joint that mimics another joint follow from the limits of the followed
        // joint.
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

    /// Returns the longest distance along the links from the base to a goal. Joints that slide
    /// without limits do not count. Returns 1 if the distance is zero.
    pub(super) fn typical_length(&self) -> R {
        let mut longest = R::ZERO;
        for goal in self.goals {
            let (mut length, mut link) = (norm(goal.point), goal.link);
            while let Some(step) = self.mechanism.step(link) {
                let slide_length = self.slide_length(step);
                length += if slide_length.is_finite() { slide_length } else { R::ZERO };
                length += norm(step.placement().translation());
                link = step.parent as usize;
            }
            longest = if length > longest { length } else { longest };
        }
        if longest > R::ZERO && longest.is_finite() { longest } else { R::ONE }
    }

    /// Returns the typical length of the mechanism. If a joint floats or slides without limits, the
    /// result is at least the distance to the farthest target, and at least the distance by which
    /// any joint has slid at present.
    pub(super) fn typical_length_to(&self, targets: &[DualQuat<R>], values: &[R]) -> R {
        let mut longest = self.facts.size;
        if self.facts.is_endless {
            for target in targets {
                longest = longest.max_or_nan(norm(target.translation()));
            }
            for (position, step) in self.mechanism.steps.iter().enumerate() {
                if self.moves_goal(position) {
                    longest = longest.max_or_nan(longest_slide(step, values));
                }
            }
        }
        longest
    }

    /// Returns `true` if any joint that moves a goal is a floating joint, or a prismatic or screw
    /// joint without limits.
    pub(super) fn has_endless_slides(&self) -> bool {
        let mut has = false;
        for (position, step) in self.mechanism.steps.iter().enumerate() {
            has |= self.moves_goal(position) && !self.slide_length(step).is_finite();
        }
        has
    }

    /// Returns the normalized target of a goal. A target out of reach is replaced by the nearest
    /// point within the bound on the reach, because an error that grew with the distance would
    /// dominate all other errors. The second result is the vector from that point to the target.
    /// Returns `None` if the target is invalid.
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
        // If an axis has no weight, the link may be anywhere along it, so the target is never out
        // of reach and stays as it is.
        let asked = self.goals.get(goal)?.linear.into_iter().all(|weight| weight > R::ZERO);
        let bound = match goal {
            0 => self.facts.bound,
            _ if self.facts.any_other_bound => self.reach_bound(goal),
            _ => None,
        };
        let Some((centre, length)) = bound.filter(|_| asked) else {
            return Some((target, None));
        };
        let way = vector::sub(target.translation(), centre);
        let far = norm(way);
        if !far.is_finite() {
            return None;
        }
        // All three lengths have rounding errors, which are proportional to the distance from the
        // base.
        let sizes = length + norm(centre) + norm(target.translation());
        if far <= length + R::from(64.0) * R::EPSILON * sizes + tolerance {
            return Some((target, None));
        }
        let edge = vector::add(centre, vector::scale(way, length / far));
        let excess = vector::sub(target.translation(), edge);
        Some((DualQuat::from_rotation_translation(target.rotation(), edge), Some(excess)))
    }
}

/// Returns the length of a vector. In firmware this is not inlined, so that the code holds it only
/// once.
#[cfg_attr(target_os = "none", inline(never))]
fn norm<R: Real>(vector: [R; 3]) -> R {
    vector::norm(vector)
}

/// Returns the largest distance by which a joint has slid along one of its axes.
fn longest_slide<R: Real>(step: &Step<R>, values: &[R]) -> R {
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
