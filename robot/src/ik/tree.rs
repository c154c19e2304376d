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
//!
//! A joint that mimics another adds to the row and column of that joint, at which freedoms of
//! different branches meet. So the paths of freedoms to the base are those of the elimination tree
//! (Liu 1990), which `freedom.rs` finds: it is the tree of the joints, with the leader below or
//! above the joints that it meets.

use super::body::Body;
use super::freedom::{Freedom, carrier};
use super::model::Model;
use super::problem::Reach;
use super::report::Settings;
use super::scratch::{EVEN_BODY, Scratch, UNEVEN_BODY};
use super::step::FLOOR;
use crate::mechanism::step::{NONE, Step};
use dq8::batch::vector::epsilon;
use dq8::geometry::Twist;
use dq8::{Real, Scalar};
use dq8_simd::{Lanes, Mask};

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Computes JᵀJ and Jᵀe at the latest poses.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn assemble(&mut self) {
        if self.reach.facts.is_even {
            self.assemble_bodies::<EVEN_BODY>();
        } else {
            self.assemble_bodies::<UNEVEN_BODY>();
        }
    }

    /// Computes JᵀJ and Jᵀe from bodies of `C` registers.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn assemble_bodies<const C: usize>(&mut self)
    where
        [L; C]: Body<L>,
    {
        let (level, reach) = (self.level, self.reach);
        let zero = L::splat(level, L::Real::default());
        self.scratch.bodies.fill(zero);
        if reach.facts.any_mimics {
            // Entries are sums over all joints that share a freedom.
            self.scratch.system.fill(zero);
            self.scratch.right_hand_side.fill(zero);
        }
        self.scale_slides();
        for (position, step) in reach.mechanism.steps.iter().enumerate().rev() {
            if !reach.moves_goal(position) {
                continue;
            }
            let at = step.slot as usize * C;
            let mut body: [L; C] = self.scratch.bodies.record(level, at);
            for (index, goal) in reach.goals.iter().enumerate() {
                if goal.link == step.link as usize {
                    body.add_goal(self, index, goal, reach.first_row(index));
                }
            }
            for index in 0..step.kind.rates() {
                if reach.facts.any_mimics {
                    self.add_row(&body, step, index);
                } else {
                    self.set_row(&body, reach.column(step.rate as usize + index));
                }
            }
            // The sums of the branches below a link meet in the slot of that link, which is also
            // the slot of its largest branch. Any other branch has a slot of its own. It adds its
            // sum to the slot of the link here, and clears its own slot for the next branch.
            let below = step.parent_slot as usize * C;
            if step.parent == NONE {
                body = [zero; C];
            } else if below != at {
                let mut others: [L; C] = self.scratch.bodies.record(level, below);
                for (to, from) in others.iter_mut().zip(body) {
                    *to = *to + from;
                }
                self.scratch.bodies.set_record(below, others);
                body = [zero; C];
            }
            self.scratch.bodies.set_record(at, body);
        }
    }

    /// Multiplies the twists of slides by the length that weighs as much as a radian, because all
    /// unknowns of the equations are in radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn scale_slides(&mut self) {
        let reach = self.reach;
        if !reach.facts.any_mimics {
            for freedom in reach.freedoms.iter().filter(|freedom| freedom.is_slide()) {
                self.scale_slide(freedom.twist_row as usize);
            }
            return;
        }
        for (position, step) in reach.mechanism.steps.iter().enumerate() {
            for index in 0..step.kind.rates() {
                let freedom = reach.freedoms.get(reach.column(step.rate as usize + index));
                if freedom.is_some_and(Freedom::is_slide) && reach.moves_goal(position) {
                    self.scale_slide((step.twist as usize + index) * 6);
                }
            }
        }
    }

    /// Multiplies the twist at the row `at` of the scratch by the length per radian.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn scale_slide(&mut self, at: usize) {
        let twist = Twist::from_array(self.scratch.twists.record(self.level, at));
        self.scratch.twists.set_record(at, twist.scale(self.scales.length).to_array());
    }

    /// Computes the row of a freedom in the normal equations: its right-hand side, and the entries
    /// in its own column and in the columns of the freedoms that carry it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn set_row<const C: usize>(&mut self, body: &[L; C], column: usize)
    where
        [L; C]: Body<L>,
    {
        let (level, reach, scratch) = (self.level, self.reach, &mut self.scratch);
        let Some(mut freedom) = reach.freedoms.get(column) else { return };
        let twist: [L; 6] = scratch.twists.record(level, freedom.twist_row as usize);
        scratch.right_hand_side.set(column, dot(twist, force(body)));
        let momentum = body.momentum(twist);
        let last = (freedom.first_entry + freedom.depth) as usize;
        for up in 0..=freedom.depth as usize {
            let twist = scratch.twists.record(level, freedom.twist_row as usize);
            scratch.system.set(last - up, dot(twist, momentum));
            let Some(carrier) = reach.freedoms.get(freedom.parent as usize) else { break };
            freedom = carrier;
        }
    }

    /// Adds what a joint contributes to the normal equations by its rate at `index`, where several
    /// joints may share a freedom: to the right-hand side, and to the entries between its freedom
    /// and the freedoms of the joints that carry it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add_row<const C: usize>(&mut self, body: &[L; C], step: &Step<L::Real>, index: usize)
    where
        [L; C]: Body<L>,
    {
        let (level, reach, scratch) = (self.level, self.reach, &mut self.scratch);
        let own = reach.column(step.rate as usize + index);
        let twist: [L; 6] = scratch.twists.record(level, (step.twist as usize + index) * 6);
        let moved = dot(twist, force(body)) + scratch.right_hand_side.get(level, own);
        scratch.right_hand_side.set(own, moved);
        let momentum = body.momentum(twist);
        let (mut joint, mut rates) = (step, index + 1);
        loop {
            for rate in (0..rates).rev() {
                let row = (joint.twist as usize + rate) * 6;
                let other = reach.column(joint.rate as usize + rate);
                let mut entry = dot(scratch.twists.record(level, row), momentum);
                // A joint that is carried by a joint of the same freedom contributes once as the
                // one of both and once as the other.
                if other == own && joint.link != step.link {
                    entry = entry + entry;
                }
                let (Some(low), Some(high)) =
                    (reach.freedoms.get(own.max(other)), reach.freedoms.get(own.min(other)))
                else {
                    continue;
                };
                let at = (low.first_entry + high.depth) as usize;
                scratch.system.set(at, entry + scratch.system.get(level, at));
            }
            let Some(carrier) = carrier(reach.mechanism.steps, joint) else { break };
            (joint, rates) = (carrier, carrier.kind.rates());
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
                // Both slices have their lengths before the loop, which then checks nothing.
                let other_row = above.get_mut(other.first_entry as usize..).unwrap_or_default();
                let (Some(to), Some(from)) = (other_row.get_mut(..=up), own.get(..=up)) else {
                    break;
                };
                for (to, from) in to.iter_mut().zip(from) {
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
    /// Returns `true` if the posture, the start, or the start of a floating joint has a weight in
    /// every step.
    pub(super) fn has_weights(&self, settings: Settings<'_, R>) -> bool {
        self.weighs_joints(settings) || self.weighs_floating(settings)
    }

    /// Returns `true` if a floating joint moves a goal, and has a weight.
    pub(super) fn weighs_floating(&self, settings: Settings<'_, R>) -> bool {
        let mut freedoms = self.freedoms.iter();
        settings.floating_weight > R::ZERO && freedoms.any(|freedom| !freedom.is_single())
    }

    /// Returns `true` if the posture or the start has a weight.
    pub(super) fn weighs_joints(&self, settings: Settings<'_, R>) -> bool {
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

/// Returns the torque and the force on a body, its last six registers.
#[cfg_attr(not(opt_level_0), inline(always))]
fn force<L: Lanes, const C: usize>(body: &[L; C]) -> [L; 6] {
    body.last_chunk().copied().unwrap_or_else(|| [body[0].constant(0.0); 6])
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn dot<L: Lanes>(a: [L; 6], b: [L; 6]) -> L {
    let mut sum = a[0] * b[0];
    for (x, y) in a.into_iter().zip(b).skip(1) {
        sum = x.mul_add(y, sum);
    }
    sum
}
