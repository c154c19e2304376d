//! Damped least squares for many goals, with sparse normal equations: entry (i, j) is nonzero only
//! if joint i carries joint j or is carried by it.
//!
//! A goal acts on a twist ξ of its link as a rigid body does. With μ and ν the squares of its
//! weights for position and rotation, and p its point, ξᵀJᵀJξ is twice the kinetic energy of
//! a mass μ at p with the rotational inertia ν. So JᵀJ is the joint-space inertia matrix H of a
//! tree that carries these bodies, by the composite-rigid-body algorithm from the leaves to the
//! base (Featherstone, *Rigid Body Dynamics Algorithms*, 2008, ch. 6), and Jᵀe are the joint
//! forces of the bodies' forces. Hᵢⱼ is only nonzero if joint i carries joint j or is carried
//! by it, and the factorisation LᵀDL from the leaves fills no other entries (ch. 8). For 15
//! goals of a humanoid of 35 rates H has 341 entries; JJᵀ would have 1,485, each a sum of 35
//! products.
//!
//! ```text
//! for each link from the leaves to the base           # assemble
//!     body = its own goals + the bodies of its children
//!     for each joint i of the link, and each joint j that carries it (and itself)
//!         H[i, j] = screw[j] · body · screw[i];  rhs[i] = screw[i] · force of body
//! H += λ² 1;  rhs += λ² z                           # solve_tree; z is the posture step
//! for each joint i from the leaves                    # H = LᵀDL
//!     for each joint j that carries i
//!         f = H[i, j] / H[i, i];  rhs[j] −= f rhs[i]
//!         for each joint k that carries j, or is j
//!             H[j, k] −= f H[i, k]
//!         H[i, j] = f
//!     rhs[i] /= H[i, i]
//! for each joint i from the base                      # x in the place of rhs
//!     for each joint j that carries i
//!         rhs[i] −= H[i, j] rhs[j]
//! ```
//!
//! Row i has the entries of the joints from the base to i, in this order. So the entries of row i
//! begin with the columns of any joint that carries i.

use super::goal::Goal;
use super::model::Model;
use super::problem::Reach;
use super::report::Settings;
use super::scratch::{BODY, Scratch};
use super::step::FLOOR;
use crate::mechanism::step::NONE;
use dq8::batch::vector::{self, epsilon};
use dq8::geometry::Twist;
use dq8::{Real, Scalar};
use dq8_simd::{Lanes, Mask};

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Computes JᵀJ and Jᵀe at the latest poses.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn assemble(&mut self) {
        let (level, reach) = (self.level, self.reach);
        let zero = L::splat(level, L::Real::default());
        self.scratch.bodies.fill(zero);
        for freedom in reach.freedoms.iter().filter(|freedom| freedom.is_slide()) {
            // All unknowns of the equations are in radians, so the twist of a slide is multiplied
            // by the length that weighs as much as a radian.
            let at = freedom.twist_row as usize;
            let twist = Twist::from_array(self.scratch.twists.record(level, at));
            self.scratch.twists.set_record(at, twist.scale(self.scales.length).to_array());
        }
        for (position, step) in reach.mechanism.steps.iter().enumerate().rev() {
            if !reach.moves_goal(position) {
                continue;
            }
            let at = step.slot as usize * BODY;
            let mut body: [L; BODY] = self.scratch.bodies.record(level, at);
            let mut row = 0;
            for (index, goal) in reach.goals.iter().enumerate() {
                if goal.link == step.link as usize {
                    self.add_goal(&mut body, index, goal, row);
                }
                row += goal.rows();
            }
            for index in 0..step.kind.rates() {
                self.set_row(&body, reach.column(step.rate as usize + index));
            }
            // The sums of the branches below a link meet in the slot of that link, which is also
            // the slot of its largest branch. Any other branch has a slot of its own. It adds its
            // sum to the slot of the link here, and clears its own slot for the next branch.
            let below = step.parent_slot as usize * BODY;
            if step.parent == NONE {
                body = [zero; BODY];
            } else if below != at {
                let mut others: [L; BODY] = self.scratch.bodies.record(level, below);
                add(&mut others, body);
                self.scratch.bodies.set_record(below, others);
                body = [zero; BODY];
            }
            self.scratch.bodies.set_record(at, body);
        }
    }

    /// Adds to `body` the mass and the inertia that stand for a goal's weights, and the force that
    /// stands for its error. `row` is the first row of the error.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add_goal(&self, body: &mut [L; BODY], index: usize, goal: &Goal<L::Real>, row: usize) {
        let (level, half) = (self.level, self.pose(index).half);
        let end = vector::add(half, half);
        let weight = |weights: [L::Real; 3]| L::splat(level, weights[0]);
        let (turns, moves) = (weight(goal.angular), weight(goal.linear));
        let moves = moves * self.scales.radians_per_length;
        let (inertia, mass) = (turns * turns, moves * moves);
        let [x, y, z] = end;
        let [mx, my, mz] = vector::scale(end, mass);
        let [xx, yy, zz] = [mx * x, my * y, mz * z];
        let (torque, row) = if goal.asks_rotation() {
            (vector::scale(self.scratch.error.record(level, row), turns), row + 3)
        } else {
            ([inertia.constant(0.0); 3], row)
        };
        let mut force = [inertia.constant(0.0); 3];
        if goal.linear[0] > L::Real::ZERO {
            force = vector::scale(self.scratch.error.record(level, row), moves);
        }
        let [tx, ty, tz] = vector::cross_onto(end, force, torque);
        let [fx, fy, fz] = force;
        let (ixx, iyy, izz) = (inertia + yy + zz, inertia + xx + zz, inertia + xx + yy);
        let (ixy, ixz, iyz) = (-(mx * y), -(mx * z), -(my * z));
        add(body, [mass, mx, my, mz, ixx, iyy, izz, ixy, ixz, iyz, tx, ty, tz, fx, fy, fz]);
    }

    /// Computes the row of a freedom in the normal equations: its right-hand side, and the entries
    /// in its own column and in the columns of the freedoms that carry it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn set_row(&mut self, body: &[L; BODY], column: usize) {
        let (level, reach, scratch) = (self.level, self.reach, &mut self.scratch);
        let Some(mut freedom) = reach.freedoms.get(column) else { return };
        let twist: [L; 6] = scratch.twists.record(level, freedom.twist_row as usize);
        let [wx, wy, wz, vx, vy, vz] = twist;
        let (w, v) = ([wx, wy, wz], [vx, vy, vz]);
        let [mass, hx, hy, hz, xx, yy, zz, xy, xz, yz, tx, ty, tz, fx, fy, fz] = *body;
        let h = [hx, hy, hz];
        let turned = [
            xx.mul_add(wx, xy.mul_add(wy, xz * wz)),
            xy.mul_add(wx, yy.mul_add(wy, yz * wz)),
            xz.mul_add(wx, yz.mul_add(wy, zz * wz)),
        ];
        let [ax, ay, az] = vector::cross_onto(h, v, turned);
        let [lx, ly, lz] = vector::cross_onto(w, h, vector::scale(v, mass));
        scratch.right_hand_side.set(column, dot(twist, [tx, ty, tz, fx, fy, fz]));
        let momentum = [ax, ay, az, lx, ly, lz];
        let last = (freedom.first_entry + freedom.depth) as usize;
        for up in 0..=freedom.depth as usize {
            let twist = scratch.twists.record(level, freedom.twist_row as usize);
            scratch.system.set(last - up, dot(twist, momentum));
            let Some(carrier) = reach.freedoms.get(freedom.parent as usize) else { break };
            freedom = carrier;
        }
    }

    /// Solves (JᵀJ + λ²1) x = Jᵀe + λ²z for x in `radians`, where z is the step toward the
    /// posture. The changes of held freedoms are known, so their rows and columns are removed from
    /// the equations, and the products of these columns and changes are subtracted from the
    /// right-hand side.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn solve_tree(&mut self, damping: L, posture_step: bool) {
        let (level, freedoms, scratch) = (self.level, self.reach.freedoms, &mut self.scratch);
        let (zero, one) = (damping.constant(0.0), damping.constant(1.0));
        let Scratch { system, factor, right_hand_side, radians, held, changes, .. } = scratch;
        let (mut trace, mut holds) = (zero, zero.lt(zero));
        for (index, freedom) in freedoms.iter().enumerate() {
            trace = trace + system.get(level, (freedom.first_entry + freedom.depth) as usize);
            holds = holds | held.get(level, index).eq(one);
            let mut rhs = right_hand_side.get(level, index);
            if posture_step {
                rhs = damping.mul_add(scratch.posture_step.get(level, index), rhs);
            }
            radians.set(index, rhs);
        }
        for (to, from) in factor.0.iter_mut().zip(system.0.iter()) {
            *to = *from;
        }
        if holds.any() {
            // The columns of held freedoms times their changes are subtracted from the right-hand
            // side. Then the rows and columns of these freedoms become those of the identity
            // matrix.
            for (index, freedom) in freedoms.iter().enumerate() {
                let is_held = held.get(level, index).eq(one);
                let unit = if freedom.is_slide() { self.scales.radians_per_length } else { one };
                let own_change = L::select(is_held, changes.get(level, index) * unit, zero);
                let (mut other, mut at) = (index, (freedom.first_entry + freedom.depth) as usize);
                while let Some(carrier) = freedoms.get(other) {
                    let entry = factor.get(level, at);
                    let is_other = held.get(level, other).eq(one);
                    let other_unit =
                        if carrier.is_slide() { self.scales.radians_per_length } else { one };
                    let other_change =
                        L::select(is_other, changes.get(level, other) * other_unit, zero);
                    radians.set(index, entry.neg_mul_add(other_change, radians.get(level, index)));
                    if other != index {
                        radians
                            .set(other, entry.neg_mul_add(own_change, radians.get(level, other)));
                    }
                    let kept = L::select(is_held | is_other, zero, entry);
                    factor
                        .set(at, if other == index { L::select(is_held, one, kept) } else { kept });
                    (other, at) = (carrier.parent as usize, at.wrapping_sub(1));
                }
            }
            for index in 0..freedoms.len() {
                let is_held = held.get(level, index).eq(one);
                radians.set(index, L::select(is_held, zero, radians.get(level, index)));
            }
        }
        let least = trace
            .mul_add(damping.constant(0.25 * epsilon::<L>()), damping + damping.constant(FLOOR));
        // This loop factorises JᵀJ = LᵀDL from the leaves to the base. A row begins with the
        // entries of the joints that carry its freedom.
        for (index, freedom) in freedoms.iter().enumerate().rev() {
            let (first, depth) = (freedom.first_entry as usize, freedom.depth as usize);
            let Some((above, own)) = factor.0.split_at_mut_checked(first) else { return };
            let Some((pivot, own)) = own.get_mut(..=depth).and_then(<[_]>::split_last_mut) else {
                return;
            };
            let pivot = L::load(level, pivot) + least;
            let reciprocal = one / L::select(pivot.lt(least), least, pivot);
            let rhs = radians.get(level, index);
            let mut carrier = freedom.parent as usize;
            for up in (0..depth).rev() {
                let Some(other) = freedoms.get(carrier) else { break };
                let Some(entry) = own.get(up).map(|entry| L::load(level, entry)) else { break };
                let part = entry * reciprocal;
                radians.set(carrier, part.neg_mul_add(rhs, radians.get(level, carrier)));
                let other_row = above.get_mut(other.first_entry as usize..).unwrap_or_default();
                for (to, from) in other_row.iter_mut().zip(own.iter().take(up + 1)) {
                    part.neg_mul_add(L::load(level, from), L::load(level, to)).store(to);
                }
                carrier = other.parent as usize;
            }
            for entry in own.iter_mut() {
                (L::load(level, entry) * reciprocal).store(entry);
            }
            radians.set(index, rhs * reciprocal);
        }
        for (index, freedom) in freedoms.iter().enumerate() {
            let mut solved = radians.get(level, index);
            let mut carrier = freedom.parent as usize;
            for up in (0..freedom.depth as usize).rev() {
                let part = factor.get(level, freedom.first_entry as usize + up);
                solved = part.neg_mul_add(radians.get(level, carrier), solved);
                carrier = freedoms.get(carrier).map_or(usize::MAX, |other| other.parent as usize);
            }
            radians.set(index, solved);
        }
    }
}

impl<R: Real> Reach<'_, R> {
    /// Returns `true` if the posture or the start has a weight in every step.
    pub(super) fn has_weights(&self, settings: Settings<'_, R>) -> bool {
        let posture = self.posture.is_some() && settings.posture_weight > R::ZERO;
        posture || settings.start_weight > R::ZERO
    }

    /// Returns `true` if searches with these settings solve the sparse normal equations of this
    /// file.
    pub(super) fn uses_tree(&self, settings: Settings<'_, R>) -> bool {
        let is_weighed = self.posture.is_none() || settings.posture_weight > R::ZERO;
        self.facts.tree > 0 && is_weighed
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn add<L: Lanes>(to: &mut [L; BODY], from: [L; BODY]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = *to + from;
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn dot<L: Lanes>(a: [L; 6], b: [L; 6]) -> L {
    let mut sum = a[0] * b[0];
    for (x, y) in a.into_iter().zip(b).skip(1) {
        sum = x.mul_add(y, sum);
    }
    sum
}
