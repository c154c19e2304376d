use super::error::ReachError;
use super::freedom::{Freedom, freedoms};
use super::goal::Goal;
use super::shape::shape;
use crate::mechanism::job::carries;
use crate::mechanism::step::Step;
use crate::mechanism::tree::Mechanism;
use dq8::Real;
use dq8::seams::brief;

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
