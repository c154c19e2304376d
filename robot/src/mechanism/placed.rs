//! Poses on lanes while they are computed: a rotation and half the translation, which is what
//! products with a rotation about an axis of the frame, or a translation along one, take least of.

use super::factor::Alignment;
use super::step::Step;
use dq8::Scalar;
use dq8::batch::{Quat, vector};
use dq8_simd::Lanes;

/// Poses, one per lane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed<L> {
    pub(crate) rotation: [L; 4],
    /// Half the translation: what the dual part of a motion is made of.
    pub(crate) half: [L; 3],
}

impl<L: Lanes<Real: Scalar>> Placed<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn identity(level: L::Level) -> Self {
        let zero = L::splat(level, L::Real::default());
        Self { rotation: [zero, zero, zero, zero.constant(1.0)], half: [zero; 3] }
    }

    /// The placement of a joint on the base.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn root(level: L::Level, step: &Step<L::Real>) -> Self {
        let rotation = vector::splat(level, step.rotation);
        Self { rotation, half: vector::splat(level, step.half_offset) }
    }

    /// The components of the motion r + ε ½t r: 12 multiplications.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn to_motion(self) -> [L; 8] {
        let ([x, y, z, w], [hx, hy, hz]) = (self.rotation, self.half);
        [
            x,
            y,
            z,
            w,
            hz.neg_mul_add(y, hy.mul_add(z, hx * w)),
            hx.neg_mul_add(z, hz.mul_add(x, hy * w)),
            hy.neg_mul_add(x, hx.mul_add(y, hz * w)),
            -hz.mul_add(z, hy.mul_add(y, hx * x)),
        ]
    }

    /// This pose times the placement of a joint.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn place(self, step: &Step<L::Real>) -> Self {
        let level = self.half[0].level();
        let half = self.shifted(step.shifted, step.half_offset);
        let [x, y, z, w] = step.rotation;
        let rotation = match step.turned {
            Alignment::None => self.rotation,
            Alignment::X => about::<L, 0>(self.rotation, L::splat(level, w), L::splat(level, x)),
            Alignment::Y => about::<L, 1>(self.rotation, L::splat(level, w), L::splat(level, y)),
            Alignment::Z => about::<L, 2>(self.rotation, L::splat(level, w), L::splat(level, z)),
            Alignment::Any => {
                let placement = Quat::from_array(vector::splat(level, step.rotation));
                (Quat::from_array(self.rotation) * placement).to_array()
            }
        };
        Self { rotation, half }
    }

    /// Half the translation after a constant one in the frame of this pose, of which half is given.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn shifted(self, along: Alignment, half: [L::Real; 3]) -> [L; 3] {
        let level = self.half[0].level();
        let [x, y, z] = half;
        match along {
            Alignment::None => self.half,
            Alignment::X => self.along::<0>(L::splat(level, x)),
            Alignment::Y => self.along::<1>(L::splat(level, y)),
            Alignment::Z => self.along::<2>(L::splat(level, z)),
            Alignment::Any => self.moved(vector::splat(level, half)),
        }
    }

    /// Half the translation, moved along an axis of the frame: h + d R e_K.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn along<const K: usize>(self, distance: L) -> [L; 3] {
        let (own, next, last) = (K, (K + 1) % 3, (K + 2) % 3);
        let (r, mut half) = (self.rotation, self.half);
        let twice = distance + distance;
        // R e_K = e_K + 2(…): 1 − 2(r_n² + r_l²), 2(r_K r_n + w r_l), 2(r_K r_l − w r_n).
        let squares = r[next].mul_add(r[next], r[last] * r[last]);
        half[own] = twice.neg_mul_add(squares, half[own] + distance);
        half[next] = twice.mul_add(r[own].mul_add(r[next], r[3] * r[last]), half[next]);
        half[last] = twice.mul_add(r[3].neg_mul_add(r[next], r[own] * r[last]), half[last]);
        half
    }

    /// h + R v
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn moved(self, vector: [L; 3]) -> [L; 3] {
        Quat::from_array(self.rotation).rotate_onto(vector, vector::add(vector, self.half))
    }

    /// R v
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn rotated(self, vector: [L; 3]) -> [L; 3] {
        Quat::from_array(self.rotation).rotate(vector)
    }

    /// R n for the axis of a joint: a column of the rotation, where it is an axis of the frame.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn direction(self, step: &Step<L::Real>) -> [L; 3] {
        let level = self.half[0].level();
        let at_origin = Self { half: [L::splat(level, L::Real::default()); 3], ..self };
        let one = L::splat(level, step.sign);
        match step.aligned {
            Alignment::X => at_origin.along::<0>(one),
            Alignment::Y => at_origin.along::<1>(one),
            Alignment::Z => at_origin.along::<2>(one),
            Alignment::Any | Alignment::None => self.rotated(vector::splat(level, step.axis)),
        }
    }

    /// Half the translation, moved along the axis of a joint by half a distance; `half` counts
    /// where that axis is positive.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn slide(self, step: &Step<L::Real>, half: L) -> [L; 3] {
        let level = half.level();
        match step.aligned {
            Alignment::None => self.half,
            Alignment::X => self.along::<0>(half),
            Alignment::Y => self.along::<1>(half),
            Alignment::Z => self.along::<2>(half),
            Alignment::Any => self.moved(vector::scale(vector::splat(level, step.axis), half)),
        }
    }

    /// The rotation, turned about the axis of a joint: r (c + n s).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn turn(self, step: &Step<L::Real>, cos: L, sin: L) -> [L; 4] {
        let level = cos.level();
        match step.aligned {
            Alignment::None => self.rotation,
            Alignment::X => about::<L, 0>(self.rotation, cos, sin),
            Alignment::Y => about::<L, 1>(self.rotation, cos, sin),
            Alignment::Z => about::<L, 2>(self.rotation, cos, sin),
            Alignment::Any => {
                let axis = vector::scale(vector::splat(level, step.axis), sin);
                let turn = Quat::from_parts(axis, cos);
                (Quat::from_array(self.rotation) * turn).to_array()
            }
        }
    }
}

/// r (c + s e_K): two components instead of four, 8 multiplications.
#[cfg_attr(not(opt_level_0), inline(always))]
fn about<L: Lanes, const K: usize>(r: [L; 4], cos: L, sin: L) -> [L; 4] {
    let (own, next, last) = (K, (K + 1) % 3, (K + 2) % 3);
    let mut turned = r;
    turned[next] = r[last].mul_add(sin, r[next] * cos);
    turned[last] = r[next].neg_mul_add(sin, r[last] * cos);
    turned[own] = r[3].mul_add(sin, r[own] * cos);
    turned[3] = r[own].neg_mul_add(sin, r[3] * cos);
    turned
}
