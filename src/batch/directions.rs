//! Rotations from an axis and an angle, about the coordinate axes, and from one direction to
//! another.

use crate::batch::length::Length;
use crate::batch::{DualQuat, Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// Returns the axis, of length 1, and the angle in [0, π] radians of unit quaternions q. Both
    /// are taken from the [canonical](DualQuat::canonical) choice of ±q. The identity has the axis
    /// (1, 0, 0).
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
        // In `still` lanes the vector part is zero, so the angle is zero, or NaN if w is NaN.
        (axis, L::select(still, zero * short.w(), turn + turn))
    }

    /// Returns the turn by |v| radians about the direction of v. The result is NaN where |v| is
    /// beyond 2¹⁷ (`f32`) or 2⁴⁶ (`f64`) radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_scaled_axis(v: [L; 3]) -> Self {
        let zero = v[0].constant(0.0);
        let half = vector::scale(v, v[0].constant(0.5));
        let log = crate::geometry::DualVector { real: half, dual: [zero; 3] };
        DualQuat::exp(log).real()
    }

    /// Returns the axis of unit quaternions times the angle, a vector with a length in [0, π]. The
    /// identity gives zero.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn to_scaled_axis(self) -> [L; 3] {
        let one = self.w().constant(1.0);
        let short = self.scale(L::select(self.points_back(), -one, one));
        let scale = short.half_angle_over_sine();
        vector::scale(short.xyz(), scale + scale)
    }
}

impl<L: Lanes> Quat<L> {
    /// Returns the turns by `angle` radians about the x axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation_x(angle: L) -> Self {
        let (zero, one) = (angle.constant(0.0), angle.constant(1.0));
        Self::from_axis_angle([one, zero, zero], angle)
    }

    /// Returns the turns by `angle` radians about the y axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation_y(angle: L) -> Self {
        let (zero, one) = (angle.constant(0.0), angle.constant(1.0));
        Self::from_axis_angle([zero, one, zero], angle)
    }

    /// Returns the turns by `angle` radians about the z axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation_z(angle: L) -> Self {
        let (zero, one) = (angle.constant(0.0), angle.constant(1.0));
        Self::from_axis_angle([zero, zero, one], angle)
    }

    /// Returns the smallest turns that take the direction of `from` to the direction of `to`, two
    /// vectors of any length. Between opposite directions the turn is about the axis orthogonal to
    /// `from` that is nearest to the coordinate axis farthest from `from`. A zero vector gives NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation_arc(from: [L; 3], to: [L; 3]) -> Self {
        let one = from[0].constant(1.0);
        let (a, b) = (Length::of(from, one).divide_all(from), Length::of(to, one).divide_all(to));
        let (sum, difference) = (vector::add(a, b), vector::sub(b, a));
        let across = vector::cross(sum, difference);
        let length = Length::of(across, one);
        // In `straight` lanes the directions are opposite or equal. A turn about any axis
        // orthogonal to a direction takes it to its opposite. For equal directions the sine is
        // zero, so the axis has no effect.
        let straight = length.value().eq(one.constant(0.0));
        let axis = vector::select(straight, vector::any_across(a), length.divide_all(across));
        let (cosine, sine) = (Length::of(sum, one).value(), Length::of(difference, one).value());
        Self::from_parts(vector::scale(axis, sine), cosine).normalize()
    }
}
