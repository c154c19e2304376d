//! The problem: goals, the mechanism that is to reach them, what is found of both once, and how far a
//! link gets.

use super::freedom::{Freedom, Range, freedoms};
use super::tree::shape;
use crate::mechanism::job::carries;
use crate::mechanism::joint::JointKind;
use crate::mechanism::step::{Step, UNIT};
use crate::mechanism::tree::Mechanism;
use dq8::Real;
use dq8::scalar::{DualQuat, vector};
use dq8::seams::{brief, errors};

/// What is asked of a link: which of the six components of its error vanish, and how much each
/// weighs where not all can.
///
/// Components are in the axes of the *target*: the rotation from the link to the target as a
/// rotation vector, radians, and the way from the [`point`](Self::point) of the link to the
/// target's origin. A weight of zero leaves its component free: a drill may turn about its own
/// axis, a cup on a table slide along it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Goal<R> {
    /// The link.
    pub link: usize,
    /// The weights of the rotation about the target's x, y and z: zero, or from 10⁻⁶ to 10⁶.
    pub angular: [R; 3],
    /// The weights of the way along the target's x, y and z, likewise.
    pub linear: [R; 3],
    /// The point of the link, in its frame, that is to be at the target's origin; zero is the
    /// link's own origin.
    pub point: [R; 3],
}

impl<R: Real> Goal<R> {
    /// Rotation and position of the link.
    #[must_use]
    pub fn pose(link: usize) -> Self {
        Self { link, angular: [R::ONE; 3], linear: [R::ONE; 3], point: [R::ZERO; 3] }
    }

    /// The position of the link's origin; its rotation is free.
    #[must_use]
    pub fn position(link: usize) -> Self {
        Self { angular: [R::ZERO; 3], ..Self::pose(link) }
    }

    /// The rotation of the link; its position is free.
    #[must_use]
    pub fn orientation(link: usize) -> Self {
        Self { linear: [R::ZERO; 3], ..Self::pose(link) }
    }

    /// The same goal at a point of the link, in its frame: a fingertip, a heel, the middle of a
    /// camera.
    #[must_use]
    pub fn at(self, point: [R; 3]) -> Self {
        Self { point, ..self }
    }

    /// The same goal, of which rotation and position weigh as much as is said; what weighs nothing
    /// is free.
    #[must_use]
    pub fn weighing(self, rotation: R, position: R) -> Self {
        Self { angular: [rotation; 3], linear: [position; 3], ..self }
    }

    /// The same goal in other numbers, by way of `f64`.
    #[must_use]
    pub fn cast<S: Real>(&self) -> Goal<S> {
        let [angular, linear, point] = [self.angular, self.linear, self.point]
            .map(|numbers| numbers.map(|number| S::from_f64(number.into())));
        Goal { link: self.link, angular, linear, point }
    }

    /// The same goal with other weights of the rotation.
    #[must_use]
    pub fn with_angular(self, angular: [R; 3]) -> Self {
        Self { angular, ..self }
    }

    /// The same goal with other weights of the position.
    #[must_use]
    pub fn with_linear(self, linear: [R; 3]) -> Self {
        Self { linear, ..self }
    }
}

impl<R: Real> Goal<R> {
    /// How many components are asked for.
    pub(super) fn rows(&self) -> usize {
        let mut rows = 0;
        for weight in self.angular.into_iter().chain(self.linear) {
            rows += usize::from(weight > R::ZERO);
        }
        rows
    }

    /// Whether it is at another point than the link's origin.
    pub(super) fn is_off(&self) -> bool {
        self.point != [R::ZERO; 3]
    }

    /// Whether the rotation is free, in part, or not at all.
    pub(super) fn asks_rotation(&self) -> bool {
        let [x, y, z] = self.angular;
        x + y + z > R::ZERO
    }

    /// Whether some of the rotation is asked for, and some is free.
    pub(super) fn asks_part_of_rotation(&self) -> bool {
        let [x, y, z] = self.angular;
        let all = x > R::ZERO && y > R::ZERO && z > R::ZERO;
        self.asks_rotation() && !all
    }

    /// Whether all six components are asked for: then the error is one screw.
    pub(super) fn is_pose(&self) -> bool {
        let [x, y, z] = self.linear;
        let all = x > R::ZERO && y > R::ZERO && z > R::ZERO;
        all && self.asks_rotation() && !self.asks_part_of_rotation()
    }

    /// Whether the axes do not matter: all weigh alike.
    pub(super) fn is_even(&self) -> bool {
        let ([a, b, c], [x, y, z]) = (self.angular, self.linear);
        a == b && b == c && x == y && y == z
    }
}

/// One goal, where many may stand.
#[cfg(feature = "alloc")]
impl<R> From<Goal<R>> for alloc::vec::Vec<Goal<R>> {
    fn from(goal: Goal<R>) -> Self {
        alloc::vec![goal]
    }
}

/// An inverse kinematics problem: a mechanism, and what is asked of its links; checked once.
/// Targets and starts come with each call: [`solve`](Self::solve) for one configuration,
/// [`job`](Self::job) for many.
///
/// It borrows its memory: the goals, and a [`Freedom`] for each rate of the mechanism.
/// [`OwnedReach`](super::OwnedReach) has its own.
///
/// Joints of every kind move. A whole turn of a hinge is the same pose: of the values within its
/// limits that are, the result is the nearest to the start, and a start beyond the limits begins a
/// turn or more less far where that is within them. What has an end stops there. (A float far from
/// zero is a coarse angle: hinges whose limits span more than 16 turns stay within 64 radians of
/// zero in `f32` and 2²⁰ in `f64`, or in the turn between their limits that is nearest to it. A
/// turn of a thread, or of a joint that something mimics by a part, is another pose.) Joints that
/// mimic follow, within the limits of both, [as far](Mechanism::value_limits) as those of the
/// follower leave a range. A floating joint turns about the axes of its link, and then slides; its
/// quaternion keeps the sign of the start. Joints that carry no link with a goal keep their values.
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
    /// Those that move a goal.
    pub(super) freedoms: &'a [Freedom<R>],
    /// For each rate, where its freedom is among them.
    pub(super) of_rates: &'a [Freedom<R>],
    pub(super) posture: Option<&'a [R]>,
    pub(super) facts: Facts<R>,
}

brief!([R] Reach<'_, R>: Reach |it| { mechanism: it.mechanism, goals: it.goals.len() });

/// What is found of a problem once.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facts<R> {
    /// How many components of errors there are, and how many screws.
    pub(super) rows: usize,
    pub(super) twists: usize,
    /// How many entries the system has in the shape of the tree; none if it has not that shape.
    pub(super) tree: usize,
    /// A length that is typical for the mechanism.
    pub(super) size: R,
    /// Whether something that moves a goal floats or slides without end, a thread too.
    pub(super) is_endless: bool,
    /// How far the link of the first goal gets, and from where.
    pub(super) bound: Option<([R; 3], R)>,
}

impl<'a, R: Real> Reach<'a, R> {
    /// Checks what is asked.
    ///
    /// # Errors
    /// If there is no goal, or one for a link that there is not or that no joint moves, or with
    /// weights that are neither zero nor between 10⁻⁶ and 10⁶, or all zero, or at a point
    /// that is not finite; if there are fewer freedoms than rates; if the limits of a joint that
    /// moves a goal and of what mimics it leave no value, or are angles that a float does not tell
    /// apart. `freedoms` may have been written.
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
        let Some(of_rates) = freedoms.get_mut(..mechanism.rates) else {
            return Err(ReachError::Freedoms { freedoms: room, rates: mechanism.rates });
        };
        let steps = mechanism.steps;
        let moves = |position| moves_any(steps, position, goals);
        let count = self::freedoms(steps, of_rates, moves)?;
        let tree = shape(steps, goals, rows, of_rates);
        let of_rates: &'a [Freedom<R>] = of_rates;
        let mut twists = 0;
        for (position, step) in steps.iter().enumerate() {
            twists += if moves(position) { step.kind.rates() } else { 0 };
        }
        let freedoms = of_rates.get(..count).unwrap_or_default();
        let facts = Facts { rows, twists, tree, size: R::ONE, is_endless: false, bound: None };
        let mut reach = Self { mechanism, goals, freedoms, of_rates, posture: None, facts };
        reach.facts.size = reach.typical_length();
        reach.facts.is_endless = reach.has_endless_slides();
        reach.facts.bound = reach.reach_bound(0);
        Ok(reach)
    }

    /// With a preferred configuration. With an
    /// [`Options::posture_weight`](super::Options::posture_weight) it always acts; without, a
    /// search that has reached its targets goes on toward these values as far as the goals leave
    /// freedom, until it is there to within the angular tolerance, comes no nearer in 60
    /// iterations, next to nothing moves (10⁻⁴ rad; so `max_step` should be more), or the
    /// iterations are used up. Weighs nothing against the goals (the null space of their Jacobian;
    /// Liégeois 1977). Beyond a limit, the limit is preferred. Of planar and other joints alike;
    /// floating joints have no preference.
    ///
    /// # Errors
    /// If there are not as many values as a configuration has, or one is not finite.
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
    /// The mechanism.
    #[must_use]
    pub fn mechanism(&self) -> Mechanism<'a, R> {
        self.mechanism
    }

    /// The goals; each configuration has a target for each of them.
    #[must_use]
    pub fn goals(&self) -> &'a [Goal<R>] {
        self.goals
    }

    /// The freedom of a rate among those that move a goal.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn column(&self, rate: usize) -> usize {
        self.of_rates.get(rate).map_or(usize::MAX, |freedom| freedom.column as usize)
    }

    /// Whether second order is worth a second look at the columns.
    pub(super) fn bends(&self) -> bool
    where
        R: Real,
    {
        let mut bends = false;
        for goal in self.goals {
            bends |= goal.is_pose();
        }
        bends
    }

    /// Whether the link of the step at a position, or one that it carries, has a goal.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn moves_goal(&self, position: usize) -> bool {
        moves_any(self.mechanism.steps, position, self.goals)
    }

    /// The same for one of the goals.
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

/// Whether some value moves a link.
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
        // Their squares are numbers too.
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

errors! {
    /// What cannot be asked of a mechanism.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    ReachError {
        /// There is no goal.
        NoGoals => "there is no goal";
        /// A goal for a link that there is not.
        Link {
            goal: usize = "The goal.", link: usize = "The link that it names.", links: usize = "How many links there are."
        }
            => "goal {goal} is for link {link}, and there are {links} links";
        /// A weight that is neither zero nor between 10⁻⁶ and 10⁶.
        Weight {
            goal: usize = "The goal.",
            component: usize = "The component: 0 to 2 of the rotation, 3 to 5 of the position.",
            value: f64 = "The weight."
        }
            => "component {component} of goal {goal} cannot weigh {value}: weights are zero, or from 1e-6 to 1e6";
        /// A point of a goal that is not finite.
        Point { goal: usize = "The goal.", component: usize = "The component.", value: f64 = "What it is." }
            => "component {component} of the point of goal {goal} is not finite: {value}";
        /// All weights of a goal are zero.
        NoWeight { goal: usize = "The goal." } => "all weights of goal {goal} are zero";
        /// A goal for a link that nothing moves: only fixed joints carry it, and such that mimic
        /// others zero times.
        Unmoved { goal: usize = "The goal.", link: usize = "The link that it names." }
            => "goal {goal} is for link {link}, and no joint that carries it moves";
        /// Too little room for the freedoms.
        Freedoms { freedoms: usize = "How many there is room for.", rates: usize = "How many rates the mechanism has." }
            => "there is room for {freedoms} freedoms where {rates} rates need one each";
        /// No value is within the limits of a joint and those of the joints that mimic it, or the
        /// limits are angles beyond what a float tells (2¹⁷ radians for `f32`, 2⁴⁶ for
        /// `f64`).
        Limits { joint: usize = "The joint.", low: f64 = "The lower limit.", high: f64 = "The upper limit." }
            => "joint {joint} cannot move between {low} and {high}: limits, also of what mimics it, must leave a value, and \
                be angles that a float tells apart";
        /// A posture of another length than a configuration.
        PostureLength { length: usize = "How many values it has.", expected: usize = "How many a configuration has." }
            => "the posture has {length} values where {expected} are needed";
        /// A value of a posture that is not finite.
        Posture { index: usize = "The value.", value: f64 = "What it is." }
            => "value {index} of the posture is not finite: {value}";
    }
}
