//! What separates links from their targets.

use super::forward::get;
use super::goal::Goal;
use super::model::{Apart, Model};
use super::scratch::{DRAWN, GOAL, POSE, TARGET};
use crate::mechanism::walk::Placed;
use dq8::batch::{DualQuat, vector};
use dq8::{Real, Scalar};
use dq8_simd::Lanes;

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
    pub(super) fn pose(&self, goal: usize) -> Placed<L> {
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
