//! How errors fall with each freedom.

use super::compare::weigh;
use super::model::Model;
use super::scratch::{GOAL, POSE, TARGET, TURN};
use crate::batch::{DualQuat, lie_bracket, vector};
use crate::geometry::Twist;
use crate::real::Scalar;
use dq8_simd::Lanes;

impl<L: Lanes<Real: Scalar>> Model<'_, L> {
    /// The columns of the Jacobian of all goals. `bent` by half of the last changes, they are of second order:
    /// what a link does is a product of exponentials, whose logarithm is (Baker, Campbell, Hausdorff)
    ///
    /// ```text
    /// Σ δⱼ (cⱼ + ½ [Σₖ₍ₖ₍ⱼ₎ δₖcₖ, cⱼ]) + third order
    /// ```
    ///
    /// over the joints that carry it (Halley's method: Lloyd, Irani & Ahmadi 2022).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn linearize(&mut self, bent: bool) {
        let (level, reach) = (self.level, self.reach);
        let zero = L::splat(level, L::Real::default());
        self.scratch.columns.fill(zero);
        for goal in 0..reach.goals.len() {
            self.scratch.goals.set_record(goal * GOAL + TARGET + POSE + TURN, [zero; 6]);
        }
        let (mut position, mut screw) = (0, 0);
        while let Some(step) = reach.mechanism.steps.get(position) {
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

    /// Adds what a screw does to all goals that its step carries.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add(&mut self, position: usize, column: usize, twist: Twist<L>, bent: bool) {
        let (level, reach, scales) = (self.level, self.reach, self.scales);
        let Some(freedom) = reach.freedoms.get(column) else { return };
        let unit = if freedom.is_slide() { scales.length } else { scales.length.constant(1.0) };
        let mut row = column * reach.rows;
        for (index, goal) in reach.goals.iter().enumerate() {
            if !reach.moves(position, goal) {
                row += goal.rows();
                continue;
            }
            let first = index * GOAL + TARGET;
            let mut twist = twist;
            if bent && goal.is_pose() {
                let at = first + POSE + TURN;
                let moved = Twist::from_array(self.scratch.goals.record(level, at));
                let next = moved + twist.scale(self.scratch.changes.get(level, column));
                self.scratch.goals.set_record(at, next.to_array());
                twist = twist + lie_bracket(moved, twist).scale(unit.constant(0.5));
            }
            let twist = twist.scale(unit);
            let half: [L; 3] = self.scratch.goals.record(level, first + 4);
            let end = vector::add(half, half);
            let mut angular = twist.angular;
            let mut linear = vector::cross_onto(angular, end, twist.linear);
            if goal.asks_part_of_rotation() {
                // The rotation vector of what is left changes so.
                let nowhere = [unit.constant(0.0); 3];
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
            let linear = vector::scale(linear, scales.radians_per_length);
            let columns = &mut self.scratch.columns;
            row = weigh(
                goal,
                angular,
                linear,
                row,
                #[cfg_attr(not(opt_level_0), inline(always))]
                |row, component| {
                    columns.set(row, columns.get(level, row) + component);
                },
            );
        }
    }
}
