//! Axis and angle of a rotation, as a pair and as their product.

use crate::batch::length::Length;
use crate::batch::{DualQuat, Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// The axis, of length 1, and the angle in [0, π] radians of unit quaternions, of the
    /// [canonical](DualQuat::canonical) one of ±q. No turn has the axis (1, 0, 0).
    ///
    /// ```
    /// use dq8::{batch::Quat, simd::f32x4};
    /// let [zero, one] = [0.0, 1.0].map(f32x4::splat);
    /// let angles = f32x4::new([0.0, 1e-30, 1.0, 3.0]);
    /// let (axis, angle) = Quat::from_axis_angle([zero, one, zero], angles).to_axis_angle();
    /// assert_eq!(axis[0].to_array(), [1.0, 0.0, 0.0, 0.0]);
    /// assert!((angle - angles).to_array().iter().all(|off| off.abs() < 1e-6));
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn to_axis_angle(self) -> ([L; 3], L) {
        let (zero, one) = (self.w().constant(0.0), self.w().constant(1.0));
        let short = self.scale(L::select(self.points_back(), -one, one));
        let sine = Length::of(short.xyz(), one);
        let still = sine.value().eq(zero);
        let axis = vector::select(still, [one, zero, zero], sine.divide_all(short.xyz()));
        let turn = short.half_angle_over_sine() * sine.value();
        // Zero, but for a w that is no number.
        (axis, L::select(still, zero * short.w(), turn + turn))
    }

    /// The turn by |v| radians about the direction of v. NaN where |v| is beyond 2¹⁷ (`f32`) or
    /// 2⁴⁶ (`f64`) radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_scaled_axis(v: [L; 3]) -> Self {
        let zero = v[0].constant(0.0);
        let half = vector::scale(v, v[0].constant(0.5));
        let log = crate::geometry::DualVector { real: half, dual: [zero; 3] };
        DualQuat::exp(log).real()
    }

    /// The axis of unit quaternions times the angle, of length [0, π]; zero for no turn.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn to_scaled_axis(self) -> [L; 3] {
        let one = self.w().constant(1.0);
        let short = self.scale(L::select(self.points_back(), -one, one));
        let scale = short.half_angle_over_sine();
        vector::scale(short.xyz(), scale + scale)
    }
}
