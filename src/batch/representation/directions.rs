//! Rotations about the coordinate axes, and from one direction to another.

use crate::batch::length::Length;
use crate::batch::{Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// The turns by `angle` radians about the x axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation_x(angle: L) -> Self {
        let (zero, one) = (angle.constant(0.0), angle.constant(1.0));
        Self::from_axis_angle([one, zero, zero], angle)
    }

    /// The turns by `angle` radians about the y axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation_y(angle: L) -> Self {
        let (zero, one) = (angle.constant(0.0), angle.constant(1.0));
        Self::from_axis_angle([zero, one, zero], angle)
    }

    /// The turns by `angle` radians about the z axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation_z(angle: L) -> Self {
        let (zero, one) = (angle.constant(0.0), angle.constant(1.0));
        Self::from_axis_angle([zero, zero, one], angle)
    }

    /// The least turns that take the direction of `from` to that of `to`, vectors of any length;
    /// about the axis most across `from` where they are opposite, NaN for a zero vector.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation_arc(from: [L; 3], to: [L; 3]) -> Self {
        let one = from[0].constant(1.0);
        let (a, b) = (Length::of(from, one).divide_all(from), Length::of(to, one).divide_all(to));
        let (sum, difference) = (vector::add(a, b), vector::sub(b, a));
        let across = vector::cross(sum, difference);
        let length = Length::of(across, one);
        // Exactly opposite, or the same: then the sine is zero and the axis does not matter.
        let straight = length.value().eq(one.constant(0.0));
        let axis = vector::select(straight, vector::any_across(a), length.divide_all(across));
        let (cosine, sine) = (Length::of(sum, one).value(), Length::of(difference, one).value());
        Self::from_parts(vector::scale(axis, sine), cosine).normalize()
    }
}
