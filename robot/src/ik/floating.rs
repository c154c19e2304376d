//! The weight of floating joints against their start, which acts on their six freedoms and on no
//! others.
//!
//! With the weight w and the difference z between the start and the present pose of a floating
//! joint, a step minimises |Jx − e|² + λ²|x|² + w²|x − z|², where the last term has only
//! the freedoms of floating joints. In the sparse normal equations w² is added to their diagonal,
//! and w²z to their right-hand side. The dense equations have one damping for all freedoms, so
//! there a floating joint is given other units: with x = s y and s² = λ²/(λ² + w²), the last
//! two terms are λ²|y − z′|², where s z′ = w²z/(λ² + w²).

use super::freedom::Kind;
use super::model::Model;
use super::step::FLOOR;
use dq8::Scalar;
use dq8::batch::{DualQuat, Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Sets the step of the floating joints toward the posture to the difference between their
    /// start and their present pose, in radians, times the squared weight. Returns the weighted
    /// squared distance.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn floating_step(&mut self) -> L {
        let (level, weight, scratch) = (self.level, self.weights.floating, &mut self.scratch);
        let mut square = weight.constant(0.0);
        for (index, freedom) in self.reach.freedoms.iter().enumerate() {
            if freedom.kind != Kind::FloatingTurn(0) {
                continue;
            }
            let row = freedom.value as usize;
            let [here, start] = [&scratch.values, &scratch.start].map(|values| {
                let rotation = Quat::from_array(values.record(level, row)).normalize();
                let translation: [L; 3] = values.record(level, row + 4);
                (rotation, translation)
            });
            // The freedoms are along the axes of the link.
            let to_link = here.0.conjugate();
            let [a, b, c] = DualQuat::from_rotation(to_link * start.0).to_twist().angular;
            let away = vector::scale(here.1, weight.constant(-1.0));
            let way = to_link.rotate(vector::add(start.1, away));
            let [x, y, z] = vector::scale(way, self.scales.radians_per_length);
            for (axis, way) in [a, b, c, x, y, z].into_iter().enumerate() {
                // A difference that overflows counts as zero.
                let way = L::select(vector::is_finite(way), way, weight.constant(0.0));
                let weighted = way * weight;
                scratch.posture_step.set(index + axis, weighted);
                square = way.mul_add(weighted, square);
            }
        }
        square
    }

    /// Adds the weight to the sparse normal equations.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn weigh_floating(&mut self) {
        let (level, weight, scratch) = (self.level, self.weights.floating, &mut self.scratch);
        for (index, freedom) in self.reach.freedoms.iter().enumerate() {
            if freedom.is_single() {
                continue;
            }
            let diagonal = (freedom.first_entry + freedom.depth) as usize;
            scratch.system.set(diagonal, scratch.system.get(level, diagonal) + weight);
            let rhs = scratch.right_hand_side.get(level, index);
            scratch.right_hand_side.set(index, rhs + scratch.posture_step.get(level, index));
            scratch.posture_step.set(index, weight.constant(0.0));
        }
    }

    /// Gives floating joints the units in which the dense equations have the same damping for all
    /// freedoms.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn scale_floating(&mut self, damping: L) {
        let (level, rows, scratch) = (self.level, self.reach.facts.rows, &mut self.scratch);
        let damping = damping + damping.constant(FLOOR);
        let whole = damping + self.weights.floating;
        let scale = (damping / whole).sqrt();
        self.weights.floating_scale = scale;
        for (index, freedom) in self.reach.freedoms.iter().enumerate() {
            if freedom.is_single() {
                continue;
            }
            for row in index * rows..(index + 1) * rows {
                scratch.columns.set(row, scratch.columns.get(level, row) * scale);
            }
            let step = scratch.posture_step.get(level, index) / (whole * scale);
            scratch.posture_step.set(index, step);
        }
    }

    /// Converts the changes of floating joints from the units of
    /// [`scale_floating`](Self::scale_floating) to radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn unscale_floating(&mut self) {
        let radians = &mut self.scratch.radians;
        for (index, freedom) in self.reach.freedoms.iter().enumerate() {
            if !freedom.is_single() {
                radians.set(index, radians.get(self.level, index) * self.weights.floating_scale);
            }
        }
    }
}
