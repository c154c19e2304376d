//! [`Body`], the composite bodies from which `tree.rs` assembles the sparse normal equations.

use super::goal::Goal;
use super::model::Model;
use super::scratch::{EVEN_BODY, GOAL, POSE, TARGET, UNEVEN_BODY};
use dq8::batch::{DualQuat, vector};
use dq8::geometry::Twist;
use dq8::{Real, Scalar};
use dq8_simd::Lanes;

/// The inertia that stands for the weights of goals, and the torque and the force that stand for
/// their errors, which are the last six registers. The inertia and the forces of several goals are
/// added.
pub(super) trait Body<L: Lanes>: Copy {
    /// Adds to `self` what stands for a goal. `row` is the first row of the goal's error.
    fn add_goal<const TRACK: bool>(
        &mut self,
        model: &Model<'_, L, TRACK>,
        index: usize,
        goal: &Goal<L::Real>,
        row: usize,
    );
    /// Returns the angular and the linear momentum of a body that moves with a twist.
    fn momentum(&self, twist: [L; 6]) -> [L; 6];
}

/// The body of goals whose weights are equal for all axes: its mass, its mass times its position,
/// and its inertia (xx, yy, zz, xy, xz, yz).
impl<L: Lanes<Real: Scalar>> Body<L> for [L; EVEN_BODY] {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add_goal<const TRACK: bool>(
        &mut self,
        model: &Model<'_, L, TRACK>,
        index: usize,
        goal: &Goal<L::Real>,
        row: usize,
    ) {
        let (level, half) = (model.level, model.pose(index).half);
        let end = vector::add(half, half);
        let weight = |weights: [L::Real; 3]| L::splat(level, weights[0]);
        let (turns, moves) = (weight(goal.angular), weight(goal.linear));
        let moves = moves * model.scales.radians_per_length;
        let (inertia, mass) = (turns * turns, moves * moves);
        let [x, y, z] = end;
        let [mx, my, mz] = vector::scale(end, mass);
        let [xx, yy, zz] = [mx * x, my * y, mz * z];
        let (torque, row) = if goal.asks_rotation() {
            (vector::scale(model.scratch.error.record(level, row), turns), row + 3)
        } else {
            ([inertia.constant(0.0); 3], row)
        };
        let mut force = [inertia.constant(0.0); 3];
        if goal.linear[0] > L::Real::ZERO {
            force = vector::scale(model.scratch.error.record(level, row), moves);
        }
        let [tx, ty, tz] = vector::cross_onto(end, force, torque);
        let [fx, fy, fz] = force;
        let (ixx, iyy, izz) = (inertia + yy + zz, inertia + xx + zz, inertia + xx + yy);
        let (ixy, ixz, iyz) = (-(mx * y), -(mx * z), -(my * z));
        let own = [mass, mx, my, mz, ixx, iyy, izz, ixy, ixz, iyz, tx, ty, tz, fx, fy, fz];
        for (to, from) in self.iter_mut().zip(own) {
            *to = *to + from;
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn momentum(&self, [wx, wy, wz, vx, vy, vz]: [L; 6]) -> [L; 6] {
        let (w, v) = ([wx, wy, wz], [vx, vy, vz]);
        let [mass, hx, hy, hz, xx, yy, zz, xy, xz, yz, ..] = *self;
        let h = [hx, hy, hz];
        let turned = [
            xx.mul_add(wx, xy.mul_add(wy, xz * wz)),
            xy.mul_add(wx, yy.mul_add(wy, yz * wz)),
            xz.mul_add(wx, yz.mul_add(wy, zz * wz)),
        ];
        let [ax, ay, az] = vector::cross_onto(h, v, turned);
        let [lx, ly, lz] = vector::cross_onto(w, h, vector::scale(v, mass));
        [ax, ay, az, lx, ly, lz]
    }
}

/// The body of goals whose weights may differ from axis to axis, so that it is heavier along some
/// axes than along others: its inertia and its mass, both as symmetric matrices (xx, yy, zz, xy,
/// xz, yz), and between them the rows of the matrix by which a linear velocity changes the angular
/// momentum.
impl<L: Lanes<Real: Scalar>> Body<L> for [L; UNEVEN_BODY] {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add_goal<const TRACK: bool>(
        &mut self,
        model: &Model<'_, L, TRACK>,
        index: usize,
        goal: &Goal<L::Real>,
        row: usize,
    ) {
        let (level, scratch, half) = (model.level, &model.scratch, model.pose(index).half);
        let (end, mut row) = (vector::add(half, half), row);
        let (zero, one) = (end[0].constant(0.0), end[0].constant(1.0));
        // The error of an even goal is along the axes of the base, and any other error is along the
        // axes of the target, which are the columns of its rotation matrix.
        let mut axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        if !goal.is_even() {
            let [[a, b, c], [d, e, f], [g, h, i]] = model.target(index, None).real().to_matrix3();
            axes = [[a, d, g], [b, e, h], [c, f, i]];
        }
        // A row of the Jacobian of the goal has an angular and a linear part. The body is the sum
        // of the products of all rows with themselves, and the force the sum of all rows times
        // their errors.
        let mut turn: [L; 3] = [zero; 3];
        if goal.asks_part_of_rotation() {
            turn = scratch.goals.record(level, index * GOAL + TARGET + POSE);
        }
        for (axis, weight) in axes.into_iter().zip(goal.angular) {
            if weight > L::Real::ZERO {
                let mut angular = axis;
                if goal.asks_part_of_rotation() {
                    // The transpose of the matrix in `error_rate` is that of the opposite vector.
                    let at = Twist { angular: vector::scale(turn, -one), linear: [zero; 3] };
                    let along = Twist { angular, linear: [zero; 3] };
                    angular = DualQuat::right_jacobian_inverse(at, along).angular;
                }
                let angular = vector::scale(angular, L::splat(level, weight));
                let error = scratch.error.get(level, row);
                add_product(self, [0, 1, 2, 3, 4, 5], angular);
                add_scaled(self, 21, angular, error);
                row += 1;
            }
        }
        for (axis, weight) in axes.into_iter().zip(goal.linear) {
            if weight > L::Real::ZERO {
                let weight = L::splat(level, weight) * model.scales.radians_per_length;
                let linear = vector::scale(axis, weight);
                let angular = vector::cross(end, linear);
                let error = scratch.error.get(level, row);
                add_product(self, [0, 1, 2, 3, 4, 5], angular);
                for (first, component) in [6, 9, 12].into_iter().zip(angular) {
                    add_scaled(self, first, linear, component);
                }
                add_product(self, [15, 16, 17, 18, 19, 20], linear);
                add_scaled(self, 21, angular, error);
                add_scaled(self, 24, linear, error);
                row += 1;
            }
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn momentum(&self, [wx, wy, wz, vx, vy, vz]: [L; 6]) -> [L; 6] {
        let [xx, yy, zz, xy, xz, yz, a, b, c, d, e, f, g, h, i, rest @ ..] = *self;
        let [mxx, myy, mzz, mxy, mxz, myz, ..] = rest;
        let dot = |[a, b, c]: [L; 3], [x, y, z]: [L; 3], sum: L| {
            c.mul_add(z, b.mul_add(y, a.mul_add(x, sum)))
        };
        let (w, v, zero) = ([wx, wy, wz], [vx, vy, vz], wx.constant(0.0));
        [
            dot([xx, xy, xz], w, dot([a, b, c], v, zero)),
            dot([xy, yy, yz], w, dot([d, e, f], v, zero)),
            dot([xz, yz, zz], w, dot([g, h, i], v, zero)),
            dot([a, d, g], w, dot([mxx, mxy, mxz], v, zero)),
            dot([b, e, h], w, dot([mxy, myy, myz], v, zero)),
            dot([c, f, i], w, dot([mxz, myz, mzz], v, zero)),
        ]
    }
}

/// Adds the product of a vector with itself to a symmetric matrix, whose elements (xx, yy, zz, xy,
/// xz, yz) have these indices.
#[cfg_attr(not(opt_level_0), inline(always))]
fn add_product<L: Lanes>(body: &mut [L; UNEVEN_BODY], to: [usize; 6], [x, y, z]: [L; 3]) {
    for (at, [a, b]) in to.into_iter().zip([[x, x], [y, y], [z, z], [x, y], [x, z], [y, z]]) {
        body[at] = a.mul_add(b, body[at]);
    }
}

/// Adds a vector times a factor to the three elements from `first` on.
#[cfg_attr(not(opt_level_0), inline(always))]
fn add_scaled<L: Lanes>(body: &mut [L; UNEVEN_BODY], first: usize, vector: [L; 3], factor: L) {
    for (at, component) in vector.into_iter().enumerate() {
        body[first + at] = component.mul_add(factor, body[first + at]);
    }
}
