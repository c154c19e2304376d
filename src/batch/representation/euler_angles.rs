//! Three turns about coordinate axes, one after the other.

use crate::batch::length::Length;
use crate::batch::trigonometry::atan2;
use crate::batch::{Quat, vector};
use crate::geometry::euler_angles::{EulerAngles, EulerSolution};
use crate::geometry::euler_order::{EulerFrame, EulerOrder};
use core::f64::consts::{FRAC_PI_2, PI};
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// The unit quaternions of three turns, [`EulerAngles::to_quat`] on lanes. One order for all lanes. NaN
    /// where an angle is beyond 2¹⁷ (`f32`) or 2⁴⁶ (`f64`) radians.
    ///
    /// ```
    /// use dq8::{batch::Quat, representation::{EulerAngles, EulerAxes, EulerFrame, EulerOrder}, simd::{Mask, f32x4}};
    /// let order = EulerOrder { axes: EulerAxes::ZYX, frame: EulerFrame::Intrinsic };
    /// let pitch = f32x4::new([0.0, 0.5, 1.0, core::f32::consts::FRAC_PI_2]);
    /// let angles = [f32x4::splat(0.75), pitch, f32x4::splat(0.5)];
    /// let solution = Quat::from_euler(EulerAngles { angles, order }).to_euler(order);
    /// // The nose straight up: yaw and roll are one turn.
    /// assert_eq!(solution.gimbal_lock.to_bitmask(), 0b1000);
    /// assert!((solution.angles.angles[0].to_array()[3] - 0.25).abs() < 1e-6);
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_euler(euler: EulerAngles<L>) -> Self {
        let [first, second, third] = euler.order.axes.indices();
        let [a, b, c] = euler.angles;
        let (first, second, third) = (about(first, a), about(second, b), about(third, c));
        match euler.order.frame {
            EulerFrame::Intrinsic => first * second * third,
            EulerFrame::Extrinsic => third * second * first,
        }
    }

    /// The Euler angles of these unit quaternions, as the reference has them: straight from the quaternion,
    /// with gimbal lock as a mask (Bernardes & Viollet 2022).
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn to_euler(self, order: EulerOrder) -> EulerSolution<L, L::Mask> {
        let [first, j, last] = order.axes.indices();
        // Intrinsic turns are extrinsic ones in the opposite order.
        let (i, reversed) = match order.frame {
            EulerFrame::Intrinsic => (last, true),
            EulerFrame::Extrinsic => (first, false),
        };
        let k = 3 - i - j;
        let (xyz, w) = (self.xyz(), self.w());
        let (zero, one) = (w.constant(0.0), w.constant(1.0));
        let handedness = if (i + 1) % 3 == j { one } else { -one };
        let (x_i, x_j, x_k) = (xyz[i], xyz[j], handedness * xyz[k]);

        // Lengths that nearly vanish are differences of components, exact but for their rounding.
        let proper = order.axes.is_proper();
        let [a, b, c, d] =
            if proper { [w, x_i, x_j, x_k] } else { [w - x_j, x_i + x_k, w + x_j, x_k - x_i] };
        let (cosine, sine) = (Length::of([a, b], one).value(), Length::of([c, d], one).value());
        // Below this the direction of a vanishing number is nothing but the rounding of q.
        let least = one.constant(2.0 * vector::epsilon::<L>());
        let lowest = sine.le(least * cosine);
        let highest = cosine.le(least * sine);
        let [low, high] = if proper { [0.0, PI] } else { [-FRAC_PI_2, FRAC_PI_2] };
        let (low, high) = (one.constant(low), one.constant(high));

        let middle = if proper {
            let half = atan2(sine, cosine);
            half + half
        } else {
            // 2 (atan(sine/cosine) − π/4), without the difference, which would cost a small β.
            let sum = sine + cosine;
            let difference = x_i.neg_mul_add(x_k, w * x_j) * one.constant(4.0);
            let half = atan2(difference, sum * sum);
            half + half
        };
        let twice = one.constant(2.0);
        let sum = argument(twice * a * b, b.neg_mul_add(b, a * a));
        let difference = argument(twice * c * d, d.neg_mul_add(d, c * c));
        let alpha = argument(a.neg_mul_add(d, b * c), b.mul_add(d, a * c));
        let gamma = argument(a.mul_add(d, b * c), b.neg_mul_add(d, a * c));
        let locked = if reversed {
            [[zero, low, sum], [zero, high, difference]]
        } else {
            [[sum, low, zero], [-difference, high, zero]]
        };
        let free = vector::select(highest, locked[1], [alpha, middle, gamma]);
        let [alpha, middle, gamma] = vector::select(lowest, locked[0], free);
        let gamma = if proper { gamma } else { handedness * gamma };
        let angles = if reversed { [gamma, middle, alpha] } else { [alpha, middle, gamma] };
        EulerSolution { angles: EulerAngles { angles, order }, gimbal_lock: lowest | highest }
    }
}

/// The angle of a point. A zero of either sign is a positive one here: which it is may depend on the sign of q.
#[cfg_attr(not(opt_level_0), inline(always))]
fn argument<L: Lanes>(sine: L, cosine: L) -> L {
    atan2(sine + sine.constant(0.0), cosine)
}

/// The turn about a coordinate axis.
#[cfg_attr(not(opt_level_0), inline(always))]
fn about<L: Lanes>(axis: usize, angle: L) -> Quat<L> {
    match axis {
        0 => Quat::from_rotation_x(angle),
        1 => Quat::from_rotation_y(angle),
        _ => Quat::from_rotation_z(angle),
    }
}
