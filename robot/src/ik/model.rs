//! The model: what each lane computes of its configuration and targets.
//!
//! In the order of a round: poses and screws (`place`), errors (`compare`), the way to the posture
//! (`wish`), and the Jacobian (`linearize`).

use super::freedom::Freedom;
use super::problem::{Goal, Reach};
use super::report::Options;
use super::scratch::{DRAWN, GOAL, POSE, Rows, Scratch, TARGET, TURN};
use crate::mechanism::step::{JointFrame, JointScrews, NONE};
use crate::mechanism::values::LaneValues;
use crate::mechanism::walk::{HalfPose, LinkFrames};
use dq8::batch::{DualQuat, half_turns, lie_bracket, vector};
use dq8::geometry::Twist;
use dq8::{Real, Scalar};
use dq8_simd::{Lanes, Level};

/// With `TRACK`, steps are of first order, and of many goals in the shape of the tree: a constant
/// of the type, so that firmware that does not follow many goals does not hold it.
pub(super) struct Model<'s, L: Lanes, const TRACK: bool> {
    pub(super) level: L::Level,
    pub(super) reach: &'s Reach<'s, L::Real>,
    pub(super) scales: Scales<L>,
    pub(super) scratch: Scratch<'s, L>,
    pub(super) follows: Follows<L>,
}

/// How a target that moves is followed.
#[derive(Clone, Copy)]
pub(super) struct Follows<L> {
    /// Whether in the shape of the tree.
    by_tree: bool,
    /// Whether the posture or the start weighs something, and the squares of both.
    weighs: bool,
    pub(super) posture: L,
    pub(super) start: L,
}

/// What makes lengths and radians comparable, and what keeps a step short.
#[derive(Clone, Copy)]
pub(super) struct Scales<L> {
    /// The length that weighs as much as a radian.
    pub(super) length: L,
    pub(super) radians_per_length: L,
    /// The most that a hinge turns.
    pub(super) longest: L,
    /// λ² where the target is.
    pub(super) least_damping: L,
}

/// How far the lanes are from their targets.
#[derive(Clone, Copy)]
pub(super) struct Apart<L> {
    /// The weighted sum of squares of all errors, in radians².
    pub(super) square: L,
    /// The largest turn and the largest distance among the goals, of what is asked for.
    pub(super) angular: L,
    pub(super) linear: L,
}

/// What a step did.
#[derive(Clone, Copy)]
pub(super) struct Stepped<L> {
    /// Where a limit cut it short, the square of the errors that it would leave by its own linear
    /// model; elsewhere zero.
    pub(super) left: L,
    /// The square of all changes, in radians.
    pub(super) moved: L,
}

impl<'s, L: Lanes<Real: Scalar>, const TRACK: bool> Model<'s, L, TRACK> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(
        level: L::Level,
        reach: &'s Reach<'s, L::Real>,
        options: &Options<L::Real>,
        memory: &'s mut [L::Real],
    ) -> Option<Self> {
        let scratch = Scratch::new(reach, memory)?;
        // Each lane has its own with what it is given.
        let one = L::splat(level, dq8::Real::ONE);
        let damping = L::splat(level, options.damping);
        let scales = Scales {
            length: one,
            radians_per_length: one,
            longest: L::splat(level, options.longest_step()),
            least_damping: damping * damping,
        };
        let square = |weight: L::Real| L::splat(level, weight * weight);
        let posture = reach.posture.map_or(L::Real::default(), |_| options.posture_weight);
        let follows = Follows {
            by_tree: TRACK && reach.is_by_tree(options),
            weighs: TRACK && reach.weighs(options),
            posture: square(posture),
            start: square(options.start_weight),
        };
        Some(Self { level, reach, scales, scratch, follows })
    }

    /// Whether the posture or the start always acts.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn weighs(&self) -> bool {
        TRACK && self.follows.weighs
    }

    /// Whether the system has the shape of the tree.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn is_by_tree(&self) -> bool {
        TRACK && self.follows.by_tree
    }
}

/// Of which values.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Of {
    /// Of where the lanes are: screws too.
    Values,
    /// Of where they might begin again.
    Candidates,
}

struct Numbers<'r, 's, L: Lanes>(&'r Rows<'s, L>);

impl<L: Lanes> LaneValues<L> for Numbers<'_, '_, L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn get(&mut self, level: L::Level, index: usize) -> L {
        self.0.get(level, index)
    }
}

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// The poses of the links with goals, from the base up; links that carry none are left out.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn place(&mut self, of: Of) {
        let (level, reach) = (self.level, self.reach);
        let scratch = &mut self.scratch;
        let values = match of {
            Of::Values => &scratch.values,
            Of::Candidates => &scratch.candidate,
        };
        let mut numbers = Numbers(values);
        let one_half = L::splat(level, L::Real::HALF);
        let (mut position, mut twist) = (0, 0);
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
            if of == Of::Values {
                let joined = LinkFrames { joint: before, link: pose };
                for index in 0..step.kind.rates() {
                    scratch.twists.set_record(twist, joined.screw(step, index).to_array());
                    twist += 6;
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

    /// The same for a search that needs both kinds of values. In line it holds the code twice, and
    /// takes a tenth less time for one configuration: firmware calls it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn place_or_call(&mut self, of: Of) {
        if cfg!(target_os = "none") { self.call_place(of) } else { self.place(of) }
    }

    #[inline(never)]
    fn call_place(&mut self, of: Of) {
        self.level.run(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || self.place(of),
        );
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn put<L: Lanes<Real: Scalar>>(rows: &mut Rows<'_, L>, at: usize, pose: HalfPose<L>) {
    rows.set_record(at, pose.rotation);
    rows.set_record(at + 4, pose.half);
}

#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn get<L: Lanes<Real: Scalar>>(
    level: L::Level,
    rows: &Rows<'_, L>,
    at: usize,
) -> HalfPose<L> {
    HalfPose { rotation: rows.record(level, at), half: rows.record(level, at + 4) }
}

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// The errors of the poses that have been computed last: from the targets of their lanes, or
    /// all from those of one lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn compare(&mut self, lane: Option<usize>) -> Apart<L> {
        let level = self.level;
        let zero = L::splat(level, L::Real::default());
        let radians_per_length = self.radians_per_length(lane);
        let mut apart = Apart { square: zero, angular: zero, linear: zero };
        let mut row = 0;
        for (index, goal) in self.reach.goals.iter().enumerate() {
            let target = self.target(index, lane);
            let pose = self.pose(index);
            // Translations are kept halved, as dual quaternions take them.
            let end = vector::add(pose.half, pose.half);
            let mut way =
                vector::add(target.translation(), vector::scale(end, zero.constant(-1.0)));
            // A position is reached along the straight way. A whole pose is reached along the
            // screw: its twist, as the velocity of the end and not of the origin.
            let (mut angular, mut linear) = ([zero; 3], way);
            way = vector::add(way, self.drawn(index, lane));
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
            // Weights that differ from axis to axis are along the axes of the target.
            if !goal.is_even() {
                let to_target = target.real().conjugate();
                angular = to_target.rotate(angular);
                linear = to_target.rotate(linear);
                way = to_target.rotate(way);
            }
            // Tolerances are for turns and distances as they are, from the target that was asked
            // for; the square that a step makes smaller is weighted, and all in radians.
            let turn = asked(angular, goal.angular);
            let distance = asked(way, goal.linear);
            apart.angular = larger(apart.angular, turn);
            apart.linear = larger(apart.linear, distance);
            let linear = vector::scale(linear, radians_per_length);
            row = weigh(
                goal,
                angular,
                linear,
                row,
                #[cfg_attr(not(opt_level_0), inline(always))]
                |row, component| {
                    apart.square = component.mul_add(component, apart.square);
                    self.scratch.error.set(row, component);
                },
            );
        }
        apart
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
        DualQuat::from_array(self.of_goal::<DRAWN>(goal * GOAL, lane))
    }

    /// The way from there to the target that was asked for.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn drawn(&self, goal: usize, lane: Option<usize>) -> [L; 3] {
        self.of_goal(goal * GOAL + DRAWN, lane)
    }

    /// Numbers of a goal, of each lane or of one for all.
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

/// Hands on the weighted components that a goal asks for, and says how many rows there are now.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn weigh<L: Lanes<Real: Scalar>>(
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

/// The length of the components that are asked for.
#[cfg_attr(not(opt_level_0), inline(always))]
fn asked<L: Lanes<Real: Scalar>>(components: [L; 3], weights: [L::Real; 3]) -> L {
    let mut square = components[0].constant(0.0);
    for (component, weight) in components.into_iter().zip(weights) {
        if weight > L::Real::ZERO {
            square = component.mul_add(component, square);
        }
    }
    square.sqrt()
}

/// NaN where `b` is.
#[cfg_attr(not(opt_level_0), inline(always))]
fn larger<L: Lanes>(a: L, b: L) -> L {
    L::select(b.le(a), a, b)
}

/// Where a goal keeps the twist of its link.
const MOVED: usize = TARGET + POSE + TURN;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// The columns of the Jacobian of all goals. `bent` by half of the last changes, they are of
    /// second order: what a link does is a product of exponentials, whose logarithm is (Baker,
    /// Campbell, Hausdorff)
    ///
    /// ```text
    /// Σ δⱼ (cⱼ + ½ [Σₖ₍ₖ₍ⱼ₎ δₖcₖ, cⱼ]) + third order
    /// ```
    ///
    /// over the joints that carry it (Halley's method: Lloyd, Irani & Ahmadi 2022). That the second
    /// order is right gets an arm out of singular poses and, near them, to its target.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn linearize(&mut self, bent: bool) {
        let (level, reach) = (self.level, self.reach);
        let zero = L::splat(level, L::Real::default());
        self.scratch.columns.fill(zero);
        for goal in 0..reach.goals.len() {
            self.scratch.goals.set_record(goal * GOAL + MOVED, [zero; 6]);
        }
        let (mut position, mut screw) = (0, 0);
        while let Some(step) = reach.mechanism.steps.get(position) {
            // A branch without a goal is skipped whole; so its screws have no place in memory.
            if !reach.moves_goal(position) {
                position += step.size as usize;
                continue;
            }
            for index in 0..step.kind.rates() {
                let twist = Twist::from_array(self.scratch.twists.record(level, screw));
                screw += 6;
                self.add(position, reach.column(step.rate as usize + index), twist, bent);
            }
            position += 1;
        }
    }

    /// Adds what a freedom changes to the twist of a goal, and returns what it was.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn move_on(&mut self, goal: usize, column: usize, twist: Twist<L>) -> Twist<L> {
        let (level, at) = (self.level, goal * GOAL + MOVED);
        let moved = Twist::from_array(self.scratch.goals.record(level, at));
        let next = moved + twist.scale(self.scratch.changes.get(level, column));
        self.scratch.goals.set_record(at, next.to_array());
        moved
    }

    /// Adds what a screw does to all goals that its step carries.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add(&mut self, position: usize, column: usize, twist: Twist<L>, bent: bool) {
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
            // Joints are visited from the base up, so what has moved so far is the sum in the
            // brackets above. It is kept per goal, because each goal has joints of its own.
            if bent && goal.is_pose() {
                let moved = self.move_on(index, column, twist);
                twist = twist + lie_bracket(moved, twist).scale(one.constant(0.5));
            }
            // In radians, as all changes are.
            if freedom.is_slide() {
                twist = twist.scale(self.scales.length);
            }
            let [angular, linear] = self.seen_by(index, goal, twist);
            let columns = &mut self.scratch.columns;
            row = weigh(
                goal,
                angular,
                linear,
                row,
                #[cfg_attr(not(opt_level_0), inline(always))]
                |row, component| {
                    // A sum: a joint that mimics another shares its column.
                    columns.set(row, columns.get(level, row) + component);
                },
            );
        }
    }

    /// What a twist does to the error of a goal: its angular part, and its linear part at the link,
    /// in radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn seen_by(&self, index: usize, goal: &Goal<L::Real>, twist: Twist<L>) -> [[L; 3]; 2] {
        let (level, first) = (self.level, index * GOAL + TARGET);
        let half: [L; 3] = self.scratch.goals.record(level, first + 4);
        let end = vector::add(half, half);
        // A spatial twist has the velocity of the point at the origin; ω × end makes it that of
        // the link.
        let mut angular = twist.angular;
        let mut linear = vector::cross_onto(angular, end, twist.linear);
        if goal.asks_part_of_rotation() {
            // The rotation vector of what is left changes so.
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

/// No wish is longer than this part of the longest step: what the goals leave free is so only
/// nearby. A planar arm of five hinges ends where its point allows nothing nearer from 49 of 50
/// starts in 25 iterations; with a quarter from 48 in 45, with the whole from 45 in 17.
const SHORTER: f64 = 0.5;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// The way of each freedom to the posture, or to the limit before it, in radians; the shorter
    /// one for hinges that turn endlessly; no longer than a part of a step may be. The square of
    /// all of it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn wish(&mut self) -> L {
        let (level, reach, scales) = (self.level, self.reach, self.scales);
        let zero = L::splat(level, L::Real::ZERO);
        if self.weighs() {
            return self.weighed_wish();
        }
        let (mut square, mut most) = (zero, scales.longest * zero.constant(SHORTER));
        let Some(posture) = reach.posture else { return zero };
        for (index, freedom) in reach.freedoms.iter().enumerate() {
            let mut way = zero;
            if let Some(&value) = posture.get(freedom.value as usize) {
                way = self.way_to(freedom, L::splat(level, value));
            }
            self.scratch.wishes.set(index, way);
            square = way.mul_add(way, square);
            most = L::select(most.lt(way.abs()), way.abs(), most);
        }
        let shrink = scales.longest * zero.constant(SHORTER) / most;
        for index in 0..reach.freedoms.len() {
            self.scratch.wishes.set(index, self.scratch.wishes.get(level, index) * shrink);
        }
        square
    }

    /// The way of a freedom to a value, in radians; none of what floats.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn way_to(&self, freedom: &Freedom<L::Real>, value: L) -> L {
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
        // A way too long for a float leads nowhere.
        L::select(vector::is_finite(way), way, zero)
    }

    /// The sum of the ways to the posture and back to the start, by the squares of their weights.
    /// Of the squares of both as much.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn weighed_wish(&mut self) -> L {
        let (level, reach) = (self.level, self.reach);
        let [to_posture, to_start] = [self.follows.posture, self.follows.start];
        let mut square = to_start.constant(0.0);
        for (index, freedom) in reach.freedoms.iter().enumerate() {
            let row = freedom.value as usize;
            let way = self.way_to(freedom, self.scratch.start.get(level, row));
            let mut wish = way * to_start;
            square = way.mul_add(wish, square);
            if let Some(&value) = reach.posture.and_then(|posture| posture.get(row)) {
                let way = self.way_to(freedom, L::splat(level, value));
                let asked = way * to_posture;
                (square, wish) = (way.mul_add(asked, square), wish + asked);
            }
            self.scratch.wishes.set(index, wish);
        }
        square
    }

    /// Lanes that have not arrived forget the posture, which would draw them off, unless it has a
    /// weight: then a wish is a part of the damping.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn keep_wishes(&mut self, arrived: L::Mask, damping: L) {
        if self.weighs() {
            for index in 0..self.reach.freedoms.len() {
                let wish = self.scratch.wishes.get(self.level, index);
                self.scratch.wishes.set(index, wish / damping);
            }
            return;
        }
        let wishes = if self.reach.posture.is_some() { self.reach.freedoms.len() } else { 0 };
        for index in 0..wishes {
            let wish = self.scratch.wishes.get(self.level, index);
            self.scratch.wishes.set(index, L::select(arrived, wish, wish.constant(0.0)));
        }
    }
}
