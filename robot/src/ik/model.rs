//! [`Model`], the arithmetic of a search: the poses, errors and derivatives of the configurations
//! of all lanes.
//!
//! A round computes in this order: poses and screws ([`Model::place`]), errors
//! ([`Model::compare`]), the step toward the posture ([`Model::posture_step`]), and the Jacobian
//! ([`Model::linearize`]).
//!
//! A restart draws [`CANDIDATES`] new configurations from a sequence of low discrepancy within the
//! limits, and takes the configuration whose links are nearest to the targets. All lanes help to
//! compute the candidates. A joint value without limits stays as it was at the start.

use super::freedom::Freedom;
use super::goal::Goal;
use super::problem::Reach;
use super::report::Settings;
use super::scratch::{EXCESS, GOAL, POSE, Registers, Scratch, TARGET, TURN};
use crate::mechanism::step::{JointFrame, JointScrews, NONE};
use crate::mechanism::values::LaneValues;
use crate::mechanism::walk::{HalfPose, LinkFrames};
use dq8::batch::{DualQuat, half_turns, lie_bracket, vector};
use dq8::geometry::Twist;
use dq8::{Real, Scalar};
use dq8_simd::{Lanes, Level, MAX_LANES};

/// A configuration and its targets in each lane. With `TRACK`, steps are of first order, and steps
/// for several goals solve the sparse normal equations of `tree.rs`. `TRACK` is a constant of the
/// type so that firmware that does not track does not contain this code.
pub(super) struct Model<'s, L: Lanes, const TRACK: bool> {
    pub(super) level: L::Level,
    pub(super) reach: &'s Reach<'s, L::Real>,
    pub(super) scales: Scales<L>,
    pub(super) scratch: Scratch<'s, L>,
    pub(super) weights: PostureWeights<L>,
}

/// The weights of the posture and of the start values, which only a search that tracks has.
/// Floating joints have a weight of their own.
#[derive(Clone, Copy)]
pub(super) struct PostureWeights<L> {
    /// `true` if steps solve the sparse normal equations of `tree.rs`.
    uses_tree: bool,
    /// `true` if one of the weights is not zero.
    has_weights: bool,
    /// `true` if the weight of the posture or of the start is not zero.
    weighs_joints: bool,
    /// `true` if floating joints have a weight.
    weighs_floating: bool,
    /// The square of the weight of the posture.
    pub(super) posture: L,
    /// The square of the weight of the start.
    pub(super) start: L,
    /// The square of the weight of the start of floating joints.
    pub(super) floating: L,
    /// The units of floating joints in the dense normal equations.
    pub(super) floating_scale: L,
}

/// The factor between lengths and radians, and the quantities that keep a step short.
#[derive(Clone, Copy)]
pub(super) struct Scales<L> {
    /// The length for which an error of a distance weighs as much as an error of one radian.
    pub(super) length: L,
    /// The reciprocal of `length`.
    pub(super) radians_per_length: L,
    /// The largest change of a hinge in a step, in radians.
    pub(super) longest: L,
    /// The damping λ² of the least squares where the error is zero.
    pub(super) least_damping: L,
}

/// The errors of the links in all lanes, one register for each kind of error.
#[derive(Clone, Copy)]
pub(super) struct PoseErrors<L> {
    /// The sum of the squares of all weighted errors. Weights make radians of distances, so the
    /// unit is radians².
    pub(super) square: L,
    /// The largest angle between a link and its target, over the components with a weight.
    pub(super) angular: L,
    /// The largest distance between a link and its target, over the components with a weight.
    pub(super) linear: L,
}

/// The decisions of all lanes about the next step.
#[derive(Clone, Copy)]
pub(super) struct Decisions<L: Lanes> {
    /// The factor by which the damping of the step is greater than usual.
    pub(super) damping_factor: L,
    /// The lanes that take the step.
    pub(super) running: L::Mask,
    /// The lanes that are at their targets, and move on toward the posture.
    pub(super) arrived: L::Mask,
    /// `true` if the search may restart. Then the residual of the step must be computed.
    pub(super) may_restart: bool,
}

/// The effect of a step.
#[derive(Clone, Copy)]
pub(super) struct StepResult<L> {
    /// The squared error that remains after the step, as the linear model predicts it, in lanes in
    /// which a joint limit shortened the step. In other lanes it is zero.
    pub(super) residual: L,
    /// The sum of squares of all changes, radians².
    pub(super) change: L,
}

impl<'s, L: Lanes<Real: Scalar>, const TRACK: bool> Model<'s, L, TRACK> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(
        level: L::Level,
        reach: &'s Reach<'s, L::Real>,
        settings: Settings<'_, L::Real>,
        memory: &'s mut [L::Real],
    ) -> Option<Self> {
        let (scratch, options) = (Scratch::new(reach, memory)?, settings.options);
        // Each lane gets its own scales when it takes a configuration.
        let one = L::splat(level, dq8::Real::ONE);
        let damping = L::splat(level, options.damping);
        let scales = Scales {
            length: one,
            radians_per_length: one,
            longest: L::splat(level, options.longest_step()),
            least_damping: damping * damping,
        };
        let square = |weight: L::Real| L::splat(level, weight * weight);
        let posture = reach.posture.map_or(L::Real::default(), |_| settings.posture_weight);
        let weights = PostureWeights {
            uses_tree: TRACK && reach.uses_tree(settings),
            has_weights: TRACK && reach.has_weights(settings),
            weighs_joints: TRACK && reach.weighs_joints(settings),
            weighs_floating: TRACK && reach.weighs_floating(settings),
            posture: square(posture),
            start: square(settings.start_weight),
            floating: square(settings.floating_weight),
            floating_scale: one,
        };
        Some(Self { level, reach, scales, scratch, weights })
    }

    /// Returns `true` if the posture or the start has a weight in every step.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn has_weights(&self) -> bool {
        TRACK && self.weights.has_weights
    }

    /// Returns `true` if floating joints have a weight.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn weighs_floating(&self) -> bool {
        TRACK && self.weights.weighs_floating
    }

    /// Returns `true` if steps solve the sparse normal equations of `tree.rs`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn uses_tree(&self) -> bool {
        TRACK && self.weights.uses_tree
    }
}

/// The choice of the configurations whose poses are computed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Configurations {
    /// The present values of the lanes. The screws of the joints are computed too.
    Current,
    /// The candidates of a restart.
    Candidates,
}

/// The values of all lanes, as the walk over the joints reads them: through [`LaneValues`].
struct ValueRegisters<'r, 's, L: Lanes>(&'r Registers<'s, L>);

impl<L: Lanes> LaneValues<L> for ValueRegisters<'_, '_, L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn get(&mut self, level: L::Level, index: usize) -> L {
        self.0.get(level, index)
    }
}

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Computes the poses of the links with goals, from the base up. Branches without a goal are
    /// left out.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn place(&mut self, of: Configurations) {
        let (level, reach) = (self.level, self.reach);
        let scratch = &mut self.scratch;
        let values = match of {
            Configurations::Current => &scratch.values,
            Configurations::Candidates => &scratch.candidate,
        };
        let mut numbers = ValueRegisters(values);
        let one_half = L::splat(level, L::Real::HALF);
        let mut position = 0;
        while let Some(step) = reach.mechanism.steps.get(position) {
            if !reach.moves_goal(position) {
                position += step.size as usize;
                continue;
            }
            position += 1;
            let before = if step.parent == NONE {
                HalfPose::on_base(level, step)
            } else {
                get(level, &scratch.slots, step.parent_slot as usize * POSE).joint_frame(step)
            };
            let pose = before.link_frame(step, &mut numbers);
            put(&mut scratch.slots, step.slot as usize * POSE, pose);
            if of == Configurations::Current {
                let joined = LinkFrames { joint: before, link: pose };
                for index in 0..step.kind.rates() {
                    let twist = joined.screw(step, index).to_array();
                    scratch.twists.set_record((step.twist as usize + index) * 6, twist);
                }
            }
            for (index, goal) in reach.goals.iter().enumerate() {
                if goal.link == step.link as usize {
                    let mut there = pose;
                    if goal.is_off() {
                        let half = vector::scale(vector::splat(level, goal.point), one_half);
                        there.half = pose.moved(half);
                    }
                    put(&mut scratch.goals, index * GOAL + TARGET, there);
                }
            }
        }
    }

    /// Calls [`place`](Self::place) in searches that restart, which need it for present values and
    /// for candidates. If both calls are inlined, the search for one configuration takes a tenth
    /// less time. Firmware calls a function that is not inlined, which keeps the code small.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn place_or_call(&mut self, of: Configurations) {
        if cfg!(target_os = "none") { self.call_place(of) } else { self.place(of) }
    }

    #[inline(never)]
    fn call_place(&mut self, of: Configurations) {
        self.level.run(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || self.place(of),
        );
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn put<L: Lanes<Real: Scalar>>(
    rows: &mut Registers<'_, L>,
    at: usize,
    pose: HalfPose<L>,
) {
    rows.set_record(at, pose.rotation);
    rows.set_record(at + 4, pose.half);
}

#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn get<L: Lanes<Real: Scalar>>(
    level: L::Level,
    rows: &Registers<'_, L>,
    at: usize,
) -> HalfPose<L> {
    HalfPose { rotation: rows.record(level, at), half: rows.record(level, at + 4) }
}

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Computes the errors of the latest poses. Each lane is compared with its own targets, or all
    /// lanes are compared with the targets of lane `lane` if it is given.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn compare(&mut self, lane: Option<usize>) -> PoseErrors<L> {
        let level = self.level;
        let zero = L::splat(level, L::Real::default());
        let radians_per_length = self.radians_per_length(lane);
        let mut errors = PoseErrors { square: zero, angular: zero, linear: zero };
        let mut row = 0;
        for (index, goal) in self.reach.goals.iter().enumerate() {
            let target = self.target(index, lane);
            let pose = self.pose(index);
            // A pose holds half of its translation, as a dual quaternion does.
            let end = vector::add(pose.half, pose.half);
            let mut way =
                vector::add(target.translation(), vector::scale(end, zero.constant(-1.0)));
            // A position is reached along a straight line. A whole pose is reached along a screw,
            // whose twist here has the velocity of the link as its linear part instead of the
            // velocity at the origin.
            let (mut angular, mut linear) = ([zero; 3], way);
            way = vector::add(way, self.excess(index, lane));
            if goal.asks_rotation() {
                let pose = DualQuat::from_array(pose.to_motion());
                let twist = (target * pose.conjugate()).to_twist();
                angular = twist.angular;
                if goal.is_pose() {
                    linear = vector::cross_onto(angular, end, twist.linear);
                }
                if goal.asks_part_of_rotation() && lane.is_none() {
                    self.scratch.goals.set_record(index * GOAL + TARGET + POSE, angular);
                }
            }
            // Weights that differ from axis to axis are for the axes of the target, so the error is
            // converted to these axes.
            if !goal.is_even() {
                let to_target = target.real().conjugate();
                angular = to_target.rotate(angular);
                linear = to_target.rotate(linear);
                way = to_target.rotate(way);
            }
            // Tolerances apply to angles and distances without weights, measured to the target
            // itself, also if it is out of reach. The squared error that a step reduces is
            // weighted, and everything in it is in radians.
            let turn = length_of_asked(angular, goal.angular);
            let distance = length_of_asked(way, goal.linear);
            errors.angular = max_or_nan(errors.angular, turn);
            errors.linear = max_or_nan(errors.linear, distance);
            let linear = vector::scale(linear, radians_per_length);
            row = for_each_row(
                goal,
                angular,
                linear,
                row,
                #[cfg_attr(not(opt_level_0), inline(always))]
                |row, component| {
                    errors.square = component.mul_add(component, errors.square);
                    self.scratch.error.set(row, component);
                },
            );
        }
        errors
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn radians_per_length(&self, lane: Option<usize>) -> L {
        let all = self.scales.radians_per_length;
        let Some(lane) = lane else { return all };
        let array = all.to_array();
        array.as_ref().get(lane).map_or(all, |&of_lane| L::splat(self.level, of_lane))
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn target(&self, goal: usize, lane: Option<usize>) -> DualQuat<L> {
        DualQuat::from_array(self.of_goal::<EXCESS>(goal * GOAL, lane))
    }

    /// If a target is out of reach, a nearer point replaces it. Returns the vector from this point
    /// to the target itself; zero for a target within reach.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn excess(&self, goal: usize, lane: Option<usize>) -> [L; 3] {
        self.of_goal(goal * GOAL + EXCESS, lane)
    }

    /// Reads `C` registers of a goal's state. Each lane gets its own components, or all lanes get
    /// the components of lane `lane` if it is given.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn of_goal<const C: usize>(&self, first: usize, lane: Option<usize>) -> [L; C] {
        let Some(lane) = lane else { return self.scratch.goals.record(self.level, first) };
        let mut numbers = [L::Real::default(); C];
        for (index, number) in numbers.iter_mut().enumerate() {
            *number = self.scratch.goals.number(first + index, lane);
        }
        vector::splat(self.level, numbers)
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn pose(&self, goal: usize) -> HalfPose<L> {
        get(self.level, &self.scratch.goals, goal * GOAL + TARGET)
    }
}

/// Calls `take` with the index of the row and the weighted value, for each component that has a
/// weight. Returns the index of the row after these.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn for_each_row<L: Lanes<Real: Scalar>>(
    goal: &Goal<L::Real>,
    angular: [L; 3],
    linear: [L; 3],
    first: usize,
    mut take: impl FnMut(usize, L),
) -> usize {
    let mut row = first;
    for (components, weights) in [(angular, goal.angular), (linear, goal.linear)] {
        for (component, weight) in components.into_iter().zip(weights) {
            if weight > L::Real::ZERO {
                take(row, component * L::splat(component.level(), weight));
                row += 1;
            }
        }
    }
    row
}

/// Returns the length of a vector whose components without a weight are set to zero.
#[cfg_attr(not(opt_level_0), inline(always))]
fn length_of_asked<L: Lanes<Real: Scalar>>(components: [L; 3], weights: [L::Real; 3]) -> L {
    let mut square = components[0].constant(0.0);
    for (component, weight) in components.into_iter().zip(weights) {
        if weight > L::Real::ZERO {
            square = component.mul_add(component, square);
        }
    }
    square.sqrt()
}

/// Returns the larger of `a` and `b`, or NaN if `b` is NaN.
#[cfg_attr(not(opt_level_0), inline(always))]
fn max_or_nan<L: Lanes>(a: L, b: L) -> L {
    L::select(b.le(a), a, b)
}

/// The offset of the sum of twists among the registers of a goal's state.
const MOVED: usize = TARGET + POSE + TURN;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Computes the columns of the Jacobian of all goals. With `second_order` the columns cⱼ
    /// include the effect of half of the changes δⱼ of the first-order solution. The motion of a
    /// link is a product of exponentials, whose logarithm is (Baker, Campbell, Hausdorff)
    ///
    /// ```text
    /// Σ δⱼ (cⱼ + ½ [Σₖ₍ₖ₍ⱼ₎ δₖcₖ, cⱼ]) + third order
    /// ```
    ///
    /// where the sums run over the joints that carry the link (Halley's method: Lloyd, Irani &
    /// Ahmadi 2022). The second order takes an arm out of singular poses, and to targets near them.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn linearize(&mut self, second_order: bool) {
        let (level, reach) = (self.level, self.reach);
        let zero = L::splat(level, L::Real::default());
        self.scratch.columns.fill(zero);
        for goal in 0..reach.goals.len() {
            self.scratch.goals.set_record(goal * GOAL + MOVED, [zero; 6]);
        }
        let mut position = 0;
        while let Some(step) = reach.mechanism.steps.get(position) {
            // A branch of the tree without a goal is skipped as a whole, because no screws of its
            // joints have been written to `twists`.
            if !reach.moves_goal(position) {
                position += step.size as usize;
                continue;
            }
            for index in 0..step.kind.rates() {
                let twist = self.scratch.twists.record(level, (step.twist as usize + index) * 6);
                self.add_columns(
                    position,
                    reach.column(step.rate as usize + index),
                    Twist::from_array(twist),
                    second_order,
                );
            }
            position += 1;
        }
    }

    /// Adds a freedom's change, as a twist, to the sum of twists of a goal. Returns the sum as it
    /// was before this addition.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add_to_sum(&mut self, goal: usize, column: usize, twist: Twist<L>) -> Twist<L> {
        let (level, at) = (self.level, goal * GOAL + MOVED);
        let moved = Twist::from_array(self.scratch.goals.record(level, at));
        let next = moved + twist.scale(self.scratch.changes.get(level, column));
        self.scratch.goals.set_record(at, next.to_array());
        moved
    }

    /// Adds the screw `twist` of a joint to the joint's column of the Jacobian, in the rows of all
    /// goals whose links the joint carries. `position` is the index of the joint's step in the
    /// mechanism.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add_columns(&mut self, position: usize, column: usize, twist: Twist<L>, second_order: bool) {
        let (level, reach) = (self.level, self.reach);
        let Some(freedom) = reach.freedoms.get(column) else { return };
        let one = self.scales.length.constant(1.0);
        let mut row = column * reach.facts.rows;
        for (index, goal) in reach.goals.iter().enumerate() {
            if !reach.moves(position, goal) {
                row += goal.rows();
                continue;
            }
            let mut twist = twist;
            // Joints are visited from the base up, so the sum so far is the sum in the brackets of
            // the formula in the documentation of `linearize`. Each goal has its own sum, because
            // different joints carry different goals.
            if second_order && goal.is_pose() {
                let moved = self.add_to_sum(index, column, twist);
                twist = twist + lie_bracket(moved, twist).scale(one.constant(0.5));
            }
            // All unknowns of the equations are in radians, so the column of a slide is multiplied
            // by the length that weighs as much as a radian.
            if freedom.is_slide() {
                twist = twist.scale(self.scales.length);
            }
            let [angular, linear] = self.error_rate(index, goal, twist);
            let columns = &mut self.scratch.columns;
            row = for_each_row(
                goal,
                angular,
                linear,
                row,
                #[cfg_attr(not(opt_level_0), inline(always))]
                |row, component| {
                    // The components are added, because a joint that mimics another shares its
                    // column.
                    columns.set(row, columns.get(level, row) + component);
                },
            );
        }
    }

    /// Returns the rate at which a twist changes the error of a goal: the angular part, and the
    /// linear part at the link, both in radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn error_rate(&self, index: usize, goal: &Goal<L::Real>, twist: Twist<L>) -> [[L; 3]; 2] {
        let (level, first) = (self.level, index * GOAL + TARGET);
        let half: [L; 3] = self.scratch.goals.record(level, first + 4);
        let end = vector::add(half, half);
        // The linear part of a spatial twist is the velocity at the origin. Adding ω × end gives
        // the velocity of the link.
        let mut angular = twist.angular;
        let mut linear = vector::cross_onto(angular, end, twist.linear);
        if goal.asks_part_of_rotation() {
            // The angular error is a rotation vector. Its rate is the inverse of the right Jacobian
            // of the rotation group, at this vector, times the angular velocity.
            let nowhere = [half[0].constant(0.0); 3];
            let turn = self.scratch.goals.record(level, first + POSE);
            let at = Twist { angular: turn, linear: nowhere };
            let along = Twist { angular, linear: nowhere };
            angular = DualQuat::right_jacobian_inverse(at, along).angular;
        }
        if !goal.is_even() {
            let to_target = self.target(index, None).real().conjugate();
            angular = to_target.rotate(angular);
            linear = to_target.rotate(linear);
        }
        [angular, vector::scale(linear, self.scales.radians_per_length)]
    }
}

/// The largest component of the step toward the posture, as a part of the longest step. The step is
/// short because it follows the null space of the present Jacobian, which is valid only nearby. A
/// planar arm of five hinges reaches the nearest posture from 49 of 50 starts in 25 iterations;
/// with a quarter in place of a half, from 48 starts in 45 iterations; with the whole longest step,
/// from 45 starts in 17 iterations.
const POSTURE_PART: f64 = 0.5;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Computes the step of each freedom toward the posture, in radians. If the posture is beyond a
    /// limit, the step is toward the limit. Endless hinges take the shorter way, and the step is
    /// scaled to a part of the longest step. Returns the squared distance from the posture.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn posture_step(&mut self) -> L {
        let (level, reach, scales) = (self.level, self.reach, self.scales);
        let zero = L::splat(level, L::Real::ZERO);
        if self.has_weights() {
            return self.weighted_posture_step();
        }
        let (mut square, mut most) = (zero, scales.longest * zero.constant(POSTURE_PART));
        let Some(posture) = reach.posture else { return zero };
        for (index, freedom) in reach.freedoms.iter().enumerate() {
            let mut way = zero;
            if let Some(&value) = posture.get(freedom.value as usize) {
                way = self.difference_to(freedom, L::splat(level, value));
            }
            self.scratch.posture_step.set(index, way);
            square = way.mul_add(way, square);
            most = L::select(most.lt(way.abs()), way.abs(), most);
        }
        let shrink = scales.longest * zero.constant(POSTURE_PART) / most;
        for index in 0..reach.freedoms.len() {
            self.scratch
                .posture_step
                .set(index, self.scratch.posture_step.get(level, index) * shrink);
        }
        square
    }

    /// Returns the difference between `value` and the present value of a freedom, in radians; zero
    /// for floating joints.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn difference_to(&self, freedom: &Freedom<L::Real>, value: L) -> L {
        let zero = value.constant(0.0);
        if !freedom.is_single() {
            return zero;
        }
        let here = self.scratch.values.get(self.level, freedom.value as usize);
        let mut way = if freedom.range.wraps() {
            let (_, rest) = half_turns((value - here) * zero.constant(0.5));
            rest + rest
        } else {
            freedom.range.clamp(value) - here
        };
        if freedom.is_slide() {
            way = way * self.scales.radians_per_length;
        }
        // A difference that overflows counts as zero.
        L::select(vector::is_finite(way), way, zero)
    }

    /// Computes the sum of the differences to the posture and to the start, each multiplied by its
    /// squared weight. Returns the weighted squared distance.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn weighted_posture_step(&mut self) -> L {
        let (level, reach) = (self.level, self.reach);
        let [to_posture, to_start] = [self.weights.posture, self.weights.start];
        let mut square = to_start.constant(0.0);
        for (index, freedom) in reach.freedoms.iter().enumerate() {
            let row = freedom.value as usize;
            let way = self.difference_to(freedom, self.scratch.start.get(level, row));
            let mut posture_step = way * to_start;
            square = way.mul_add(posture_step, square);
            if let Some(&value) = reach.posture.and_then(|posture| posture.get(row)) {
                let way = self.difference_to(freedom, L::splat(level, value));
                let weighted = way * to_posture;
                (square, posture_step) = (way.mul_add(weighted, square), posture_step + weighted);
            }
            self.scratch.posture_step.set(index, posture_step);
        }
        if self.weighs_floating() { square + self.floating_step() } else { square }
    }

    /// Drops the step toward the posture in lanes that are not at their targets yet, because it
    /// would disturb the search. If the posture or the start has a weight, the step acts in every
    /// lane and is divided by the damping λ², because its weight is a part of the damping. The
    /// weight of floating joints is no part of it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn finish_posture_step(&mut self, arrived: L::Mask, damping: L) {
        if self.has_weights() {
            let weights = self.weights;
            for (index, freedom) in self.reach.freedoms.iter().enumerate() {
                if weights.weighs_floating && !(weights.weighs_joints && freedom.is_single()) {
                    continue;
                }
                let posture_step = self.scratch.posture_step.get(self.level, index);
                self.scratch.posture_step.set(index, posture_step / damping);
            }
            return;
        }
        let count = if self.reach.posture.is_some() { self.reach.freedoms.len() } else { 0 };
        for index in 0..count {
            let posture_step = self.scratch.posture_step.get(self.level, index);
            self.scratch
                .posture_step
                .set(index, L::select(arrived, posture_step, posture_step.constant(0.0)));
        }
    }
}

/// The number of configurations that a restart compares. It is the same for any number of lanes, so
/// results do not depend on the instructions of the CPU. With half as many, fewer than 998 of 1,000
/// random targets of an arm of seven axes are reached.
const CANDIDATES: usize = 4 * MAX_LANES;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Sets the values of a lane to the candidate that is nearest to its targets. `restart` is the
    /// index of the restart. The poses of the other lanes are overwritten.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn restart(&mut self, lane: usize, restart: u32) {
        let mut nearest = None;
        for first in (0..CANDIDATES).step_by(L::LANES) {
            // No other restart uses these indices of samples. They depend on the restart alone and
            // not on the lane or the number of lanes, so results do not depend on the instructions
            // of the CPU.
            self.draw(lane, u64::from(restart) * CANDIDATES as u64 + first as u64);
            self.place_or_call(Configurations::Candidates);
            let squares = self.compare(Some(lane)).square.to_array();
            let mut picked = None;
            for (index, &square) in squares.as_ref().iter().enumerate() {
                if nearest.is_none_or(|nearest| square < nearest) {
                    (nearest, picked) = (Some(square), Some(index));
                }
            }
            // The candidate is copied at once, because the next candidates overwrite the values.
            if let Some(picked) = picked {
                let scratch = &mut self.scratch;
                for value in 0..self.reach.mechanism.values {
                    scratch.values.set_number(value, lane, scratch.candidate.number(value, picked));
                }
            }
        }
    }

    /// Sets the values of a lane to its best values.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn return_to_best(&mut self, lane: usize) {
        let scratch = &mut self.scratch;
        for value in 0..self.reach.mechanism.values {
            scratch.values.set_number(value, lane, scratch.best.number(value, lane));
        }
    }

    /// Draws one candidate into each lane: the samples from index `first` on. Values without limits
    /// are copied from the start of `lane`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn draw(&mut self, lane: usize, first: u64) {
        let scratch = &mut self.scratch;
        for value in 0..self.reach.mechanism.values {
            let start = L::splat(self.level, scratch.start.number(value, lane));
            scratch.candidate.set(value, start);
        }
        for freedom in self.reach.freedoms {
            // A freedom without limits has the stride zero and keeps the value that it had at the
            // start.
            if freedom.stride > 0 {
                for index in 0..L::LANES {
                    let value = freedom.sample(first + index as u64 + 1);
                    scratch.candidate.set_number(freedom.value as usize, index, value);
                }
            }
        }
    }
}
