//! How errors fall with each freedom.

use super::compare::weigh;
use super::goal::Goal;
use super::model::Model;
use super::scratch::{GOAL, POSE, TARGET, TURN};
use dq8::Scalar;
use dq8::batch::{DualQuat, lie_bracket, vector};
use dq8::geometry::Twist;
use dq8_simd::Lanes;

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
