//! Damped least squares in the shape of the tree, for many goals.
//!
//! To a twist ξ of its link, a goal is what a rigid body is: with μ and ν the squares of its
//! weights for position and rotation, and p its point, ξᵀJᵀJξ is twice the energy of the mass
//! μ at p with the rotational inertia ν. So JᵀJ is the mass matrix of a tree that carries these
//! bodies, found from the leaves to the base (composite rigid bodies: Featherstone, *Rigid Body
//! Dynamics Algorithms*, 2008, ch. 6), and Jᵀe is what their forces do to the joints. Only pairs
//! of joints of which one carries the other have an entry, and a factorisation that begins at the
//! leaves fills no others (ch. 8). 15 goals of a humanoid of 35 rates are 341 entries instead of
//! the 1,485 of JJᵀ, of which each takes 35 products.

use super::freedom::Freedom;
use super::model::Model;
use super::problem::{Goal, Reach};
use super::report::Options;
use super::scratch::{BODY, Scratch};
use super::step::FLOOR;
use crate::mechanism::step::{NONE, Step};
use dq8::batch::vector::{self, epsilon};
use dq8::geometry::Twist;
use dq8::{Real, Scalar};
use dq8_simd::{Lanes, Mask};

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// JᵀJ and Jᵀe at the poses that have been computed last.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn assemble(&mut self) {
        let (level, reach) = (self.level, self.reach);
        let zero = L::splat(level, L::Real::default());
        self.scratch.bodies.fill(zero);
        for freedom in reach.freedoms.iter().filter(|freedom| freedom.is_slide()) {
            // In radians, as all changes are.
            let at = freedom.twist as usize;
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
            // The largest branch of a link has its slot, and comes first; the others leave theirs
            // to those that follow.
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

    /// Adds the body that a goal is, and the force that its error is.
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

    /// What a freedom has to do with itself and with those that carry it, and with the errors.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn set_row(&mut self, body: &[L; BODY], column: usize) {
        let (level, reach, scratch) = (self.level, self.reach, &mut self.scratch);
        let Some(mut freedom) = reach.freedoms.get(column) else { return };
        let twist: [L; 6] = scratch.twists.record(level, freedom.twist as usize);
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
        scratch.right.set(column, dot(twist, [tx, ty, tz, fx, fy, fz]));
        let momentum = [ax, ay, az, lx, ly, lz];
        let last = (freedom.first + freedom.depth) as usize;
        for up in 0..=freedom.depth as usize {
            let twist = scratch.twists.record(level, freedom.twist as usize);
            scratch.system.set(last - up, dot(twist, momentum));
            let Some(carrier) = reach.freedoms.get(freedom.above as usize) else { break };
            freedom = carrier;
        }
    }

    /// x with (JᵀJ + λ²1) x = Jᵀe + λ²z in `radians`, z the wishes; without the rows and
    /// columns of what is held, which does what it does to the others.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn solve_tree(&mut self, damping: L, wishes: bool) {
        let (level, freedoms, scratch) = (self.level, self.reach.freedoms, &mut self.scratch);
        let (zero, one) = (damping.constant(0.0), damping.constant(1.0));
        let Scratch { system, factor, right, radians, held, changes, .. } = scratch;
        let (mut trace, mut holds) = (zero, zero.lt(zero));
        for (index, freedom) in freedoms.iter().enumerate() {
            trace = trace + system.get(level, (freedom.first + freedom.depth) as usize);
            holds = holds | held.get(level, index).eq(one);
            let mut asked = right.get(level, index);
            if wishes {
                asked = damping.mul_add(scratch.wishes.get(level, index), asked);
            }
            radians.set(index, asked);
        }
        for (to, from) in factor.0.iter_mut().zip(system.0.iter()) {
            *to = *from;
        }
        if holds.any() {
            // What is held goes to the right side, and its row and column become those of the
            // identity.
            for (index, freedom) in freedoms.iter().enumerate() {
                let is_held = held.get(level, index).eq(one);
                let unit = if freedom.is_slide() { self.scales.radians_per_length } else { one };
                let own = L::select(is_held, changes.get(level, index) * unit, zero);
                let (mut other, mut at) = (index, (freedom.first + freedom.depth) as usize);
                while let Some(carrier) = freedoms.get(other) {
                    let entry = factor.get(level, at);
                    let is_other = held.get(level, other).eq(one);
                    let of_other =
                        if carrier.is_slide() { self.scales.radians_per_length } else { one };
                    let theirs = L::select(is_other, changes.get(level, other) * of_other, zero);
                    radians.set(index, entry.neg_mul_add(theirs, radians.get(level, index)));
                    if other != index {
                        radians.set(other, entry.neg_mul_add(own, radians.get(level, other)));
                    }
                    let kept = L::select(is_held | is_other, zero, entry);
                    factor
                        .set(at, if other == index { L::select(is_held, one, kept) } else { kept });
                    (other, at) = (carrier.above as usize, at.wrapping_sub(1));
                }
            }
            for index in 0..freedoms.len() {
                let is_held = held.get(level, index).eq(one);
                radians.set(index, L::select(is_held, zero, radians.get(level, index)));
            }
        }
        let least = trace
            .mul_add(damping.constant(0.25 * epsilon::<L>()), damping + damping.constant(FLOOR));
        // From the leaves: JᵀJ = LᵀDL. What carries a freedom is the beginning of what carries
        // that one's.
        for (index, freedom) in freedoms.iter().enumerate().rev() {
            let (first, depth) = (freedom.first as usize, freedom.depth as usize);
            let Some((above, own)) = factor.0.split_at_mut_checked(first) else { return };
            let Some((pivot, own)) = own.get_mut(..=depth).and_then(<[_]>::split_last_mut) else {
                return;
            };
            let pivot = L::load(level, pivot) + least;
            let reciprocal = one / L::select(pivot.lt(least), least, pivot);
            let asked = radians.get(level, index);
            let mut carrier = freedom.above as usize;
            for up in (0..depth).rev() {
                let Some(other) = freedoms.get(carrier) else { break };
                let Some(entry) = own.get(up).map(|entry| L::load(level, entry)) else { break };
                let part = entry * reciprocal;
                radians.set(carrier, part.neg_mul_add(asked, radians.get(level, carrier)));
                let theirs = above.get_mut(other.first as usize..).unwrap_or_default();
                for (to, from) in theirs.iter_mut().zip(own.iter().take(up + 1)) {
                    part.neg_mul_add(L::load(level, from), L::load(level, to)).store(to);
                }
                carrier = other.above as usize;
            }
            for entry in own.iter_mut() {
                (L::load(level, entry) * reciprocal).store(entry);
            }
            radians.set(index, asked * reciprocal);
        }
        for (index, freedom) in freedoms.iter().enumerate() {
            let mut solved = radians.get(level, index);
            let mut carrier = freedom.above as usize;
            for up in (0..freedom.depth as usize).rev() {
                let part = factor.get(level, freedom.first as usize + up);
                solved = part.neg_mul_add(radians.get(level, carrier), solved);
                carrier = freedoms.get(carrier).map_or(usize::MAX, |other| other.above as usize);
            }
            radians.set(index, solved);
        }
    }
}

impl<R: Real> Reach<'_, R> {
    /// Whether the posture or the start always acts.
    pub(super) fn weighs(&self, options: &Options<R>) -> bool {
        let posture = self.posture.is_some() && options.posture_weight > R::ZERO;
        posture || options.start_weight > R::ZERO
    }

    /// Whether searches with these options have the shape of the tree.
    pub(super) fn is_by_tree(&self, options: &Options<R>) -> bool {
        let is_weighed = self.posture.is_none() || options.posture_weight > R::ZERO;
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

/// Finds the place of each freedom in the tree. How many entries the system has; none where it does
/// not have the shape: where a joint that mimics shares a column, weights differ from axis to axis,
/// or a pose is all that is asked.
pub(super) fn shape<R: Real>(
    steps: &[Step<R>],
    goals: &[Goal<R>],
    rows: usize,
    of_rates: &mut [Freedom<R>],
) -> usize {
    if rows <= 6 || !goals.iter().all(Goal::is_even) {
        return 0;
    }
    let column = |of_rates: &[Freedom<R>], step: &Step<R>, index: usize| {
        of_rates.get(step.rate as usize + index).map_or(NONE, |freedom| freedom.column)
    };
    let (mut twist, mut entries) = (0, 0);
    for step in steps {
        if column(of_rates, step, 0) == NONE {
            continue;
        }
        if step.mimics {
            return 0;
        }
        let of_link = |link: u32| steps.get(steps.get(link as usize)?.position as usize);
        let (mut above, mut carrier) = (NONE, of_link(step.parent));
        while let Some(other) = carrier {
            if other.kind.rates() > 0 {
                above = column(of_rates, other, other.kind.rates() - 1);
                break;
            }
            carrier = of_link(other.parent);
        }
        for index in 0..step.kind.rates() {
            let own = column(of_rates, step, index);
            let depth = of_rates.get(above as usize).map_or(0, |carrier| carrier.depth + 1);
            if let Some(freedom) = of_rates.get_mut(own as usize) {
                (freedom.above, freedom.depth, freedom.twist) = (above, depth, twist);
                freedom.first = entries;
            }
            (above, twist, entries) = (own, twist + 6, entries + depth + 1);
        }
    }
    entries as usize
}
