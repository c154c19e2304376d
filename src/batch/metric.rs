//! Distances between motions.

use super::length::Length;
use super::screw::HalfAngle;
use super::{DualQuat, Quat};
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// Returns the angle of the rotation a*b from a = `self` to b = `other`, in [0, π] radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn angle_to(self, other: Self) -> L {
        let between = DualQuat::from_rotation(self.conjugate() * other);
        let (one, pi) = (self.w().constant(1.0), self.w().constant(core::f64::consts::PI));
        let between = between.negate_where(between.real().w().lt(one.constant(0.0)));
        let sine = Length::of(between.real().xyz(), one).value();
        // The angle is θ = 2 sin Θ · Θ/sin Θ with Θ = θ/2. Rounding may make it a little
        // larger than π.
        let angle = (sine + sine) * HalfAngle::of(between).over_sine().real;
        L::select(pi.lt(angle), pi, angle)
    }
}

impl<L: Lanes> DualQuat<L> {
    /// Returns the angle of p_a*p_b, the rotation from one motion to the other, in [0, π] radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn angle_to(self, other: Self) -> L {
        self.real().angle_to(other.real())
    }

    /// Returns |t_a − t_b|, the distance between the translations.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn distance_to(self, other: Self) -> L {
        between(self.translation(), other.translation())
    }

    /// Returns √((λθ)² + d²) with θ = [`angle_to`](Self::angle_to), d =
    /// [`distance_to`](Self::distance_to) and λ = `length_per_radian`, which may differ from lane
    /// to lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn distance_weighted(self, other: Self, length_per_radian: L) -> L {
        let legs = [length_per_radian * self.angle_to(other), self.distance_to(other)];
        Length::of(legs, length_per_radian.constant(1.0)).value()
    }

    /// Returns |a v − b v|, the distance between the images of the point v under both motions.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn point_error(self, other: Self, point: [L; 3]) -> L {
        // Both images contain the summand v, which cancels in the difference. It is left out, so it
        // adds no rounding error.
        let half = between(self.half_displacement(point), other.half_displacement(point));
        half + half
    }

    /// Returns d + 2 r sin(θ/2), an upper bound of [`point_error`](Self::point_error) for all
    /// points within the radius r of the origin. The sine is the length of the vector part of
    /// p_a*p_b.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn shell_error(self, other: Self, radius: L) -> L {
        let turn = (self.real().conjugate() * other.real()).xyz();
        let sine = Length::of(turn, radius.constant(1.0)).value();
        (radius + radius).mul_add(sine, self.distance_to(other))
    }

    /// Returns the negation of [`is_unit`](Self::is_unit).
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn needs_renormalization(self, tolerance: L) -> L::Mask {
        !self.is_unit(tolerance)
    }
}

/// Returns the distance |a − b|.
#[cfg_attr(not(opt_level_0), inline(always))]
fn between<L: Lanes>(a: [L; 3], b: [L; 3]) -> L {
    Length::of([a[0] - b[0], a[1] - b[1], a[2] - b[2]], a[0].constant(1.0)).value()
}
