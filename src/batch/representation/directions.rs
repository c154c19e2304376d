//! Rotations about the coordinate axes, and rotations and poses that are told by directions.

use super::gram_schmidt::gram_schmidt_checked;
use super::quat_without;
use crate::batch::length::Length;
use crate::batch::{DualQuat, Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// The turns by `angle` radians about the x axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_rotation_x(angle: L) -> Self {
        let (zero, one) = (angle.constant(0.0), angle.constant(1.0));
        Self::from_axis_angle([one, zero, zero], angle)
    }

    /// The turns by `angle` radians about the y axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_rotation_y(angle: L) -> Self {
        let (zero, one) = (angle.constant(0.0), angle.constant(1.0));
        Self::from_axis_angle([zero, one, zero], angle)
    }

    /// The turns by `angle` radians about the z axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_rotation_z(angle: L) -> Self {
        let (zero, one) = (angle.constant(0.0), angle.constant(1.0));
        Self::from_axis_angle([zero, zero, one], angle)
    }

    /// The least turns that take the direction of `from` to that of `to`, vectors of any length; about the axis
    /// most across `from` where they are opposite, NaN for a zero vector.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
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

    /// The rotations that take the z axis to the direction `forward` and the y axis as near to `up` as that
    /// allows, and the lanes without one: a vector is zero, not finite, or one is along the other. Those are
    /// NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn look_to_checked(forward: [L; 3], up: [L; 3]) -> (Self, L::Mask) {
        let one = forward[0].constant(1.0);
        let (ahead, above) = (Length::of(forward, one), Length::of(up, one));
        let side = vector::cross(ahead.divide_all(forward), above.divide_all(up));
        let row = |i: usize| [forward[i], up[i], side[i]];
        let (columns, failed) = gram_schmidt_checked([row(0), row(1), row(2)]);
        // forward × up is −x.
        let row = |i: usize| [-columns[i][2], columns[i][1], columns[i][0]];
        (quat_without(failed, Self::from_matrix3([row(0), row(1), row(2)])), failed)
    }
}

impl<L: Lanes> DualQuat<L> {
    /// The poses at `eye` whose z axis points to `target`, and their y axis as near to `up` as that allows, and
    /// the lanes without one: `target` is `eye`, `up` is zero or along the way from one to the other, or a
    /// number is not finite. Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn look_at_checked(eye: [L; 3], target: [L; 3], up: [L; 3]) -> (Self, L::Mask) {
        let (rotation, failed) = Quat::look_to_checked(vector::sub(target, eye), up);
        (Self::from_rotation_translation(rotation, eye), failed)
    }
}
