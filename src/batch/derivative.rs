//! Velocities: the derivative σ̇ from a twist, the twist from σ̇, and the integration of a
//! constant twist.

use super::{DualQuat, Quat, vector};
use crate::geometry::{DualVector, Twist};
use dq8_simd::Lanes;

impl<L: Lanes> DualQuat<L> {
    /// Returns the derivative σ̇ = ½ξσ for the spatial twist ξ = ω + εv.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn derivative_spatial(self, twist: Twist<L>) -> Self {
        let half = half(twist);
        let dual = times_left(half.real, self.dual()) + times_left(half.dual, self.real());
        Self::new(times_left(half.real, self.real()), dual)
    }

    /// Returns the derivative σ̇ = ½σξ for the body twist ξ = ω + εv.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn derivative_body(self, twist: Twist<L>) -> Self {
        let half = half(twist);
        let dual = times_right(self.dual(), half.real) + times_right(self.real(), half.dual);
        Self::new(times_right(self.real(), half.real), dual)
    }

    /// Returns the spatial twist 2σ̇σ* of unit σ, where σ̇ is `derivative`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn spatial_twist(self, derivative: Self) -> Twist<L> {
        let two = self.real().w().constant(2.0);
        let (p, q) = (self.real(), self.dual());
        let (p_rate, q_rate) = (derivative.real(), derivative.dual());
        let none = [two.constant(0.0); 3];
        let linear = before_conjugate(p_rate, q, before_conjugate(q_rate, p, none));
        Twist {
            angular: vector::scale(before_conjugate(p_rate, p, none), two),
            linear: vector::scale(linear, two),
        }
    }

    /// Returns the body twist 2σ*σ̇ of unit σ, where σ̇ is `derivative`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn body_twist(self, derivative: Self) -> Twist<L> {
        let two = self.real().w().constant(2.0);
        let (p, q) = (self.real(), self.dual());
        let (p_rate, q_rate) = (derivative.real(), derivative.dual());
        let none = [two.constant(0.0); 3];
        let linear = after_conjugate(q, p_rate, after_conjugate(p, q_rate, none));
        Twist {
            angular: vector::scale(after_conjugate(p, p_rate, none), two),
            linear: vector::scale(linear, two),
        }
    }

    /// Returns the derivative σ̇ = ½ωr + ½ε(ṫr + ½tωr) of unit σ, where `angular` is ω
    /// in fixed axes and `linear` is ṫ. It is computed as ½ξσ with the spatial twist ξ = ω +
    /// ε(ṫ + t × ω).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn derivative_from_velocity(self, angular: [L; 3], linear: [L; 3]) -> Self {
        let at_origin = vector::cross_onto(self.translation(), angular, linear);
        self.derivative_spatial(Twist { angular, linear: at_origin })
    }

    /// Returns the angular velocity ω and the velocity ṫ of the origin for unit σ, both in
    /// fixed axes. ṫ is v + ω × t, where ω + εv is the spatial twist.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn velocity(self, derivative: Self) -> ([L; 3], [L; 3]) {
        let twist = self.spatial_twist(derivative);
        let linear = vector::cross_onto(twist.angular, self.translation(), twist.linear);
        (twist.angular, linear)
    }

    /// Returns exp(½ξ), the motion that a constant twist ξ makes in unit time. The result is NaN
    /// where |ω| is beyond 2¹⁷ radians (`f32`; `f64`: 2⁴⁶). In `integrate_spatial` and
    /// `integrate_body` the same limit holds for the angle |ω| dt.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_twist(twist: Twist<L>) -> Self {
        Self::exp(half(twist))
    }

    /// Returns 2 log σ, the constant twist that makes the motion in unit time.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn to_twist(self) -> Twist<L> {
        let log = self.log();
        let two = self.real().w().constant(2.0);
        Twist { angular: vector::scale(log.real, two), linear: vector::scale(log.dual, two) }
    }

    /// Returns 2 log(a*b), the constant body twist that takes a = `self` to b = `other` in unit
    /// time by the shorter way.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn twist_to(self, other: Self) -> Twist<L> {
        (self.conjugate() * other).to_twist()
    }

    /// Returns exp(½ξ dt) σ for a constant spatial twist ξ; `dt` may differ from lane to lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn integrate_spatial(self, twist: Twist<L>, dt: L) -> Self {
        Self::from_twist(twist.scale(dt)) * self
    }

    /// Returns σ exp(½ξ dt) for a constant body twist ξ; `dt` may differ from lane to lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn integrate_body(self, twist: Twist<L>, dt: L) -> Self {
        self * Self::from_twist(twist.scale(dt))
    }
}

/// Returns ½ω + ½εv of the twist ω + εv.
#[cfg_attr(not(opt_level_0), inline(always))]
fn half<L: Lanes>(twist: Twist<L>) -> DualVector<L> {
    let half = twist.angular[0].constant(0.5);
    DualVector { real: vector::scale(twist.angular, half), dual: vector::scale(twist.linear, half) }
}

/// Returns vq for a pure quaternion v. With q = w + r, the vector part is w v + v × r and the
/// scalar part is −v·r.
#[cfg_attr(not(opt_level_0), inline(always))]
fn times_left<L: Lanes>(v: [L; 3], q: Quat<L>) -> Quat<L> {
    let xyz = vector::cross_onto(v, q.xyz(), vector::scale(v, q.w()));
    Quat::from_parts(xyz, -vector::dot(v, q.xyz()))
}

/// Returns qv for a pure quaternion v. With q = w + r, the vector part is w v + r × v and the
/// scalar part is −r·v.
#[cfg_attr(not(opt_level_0), inline(always))]
fn times_right<L: Lanes>(q: Quat<L>, v: [L; 3]) -> Quat<L> {
    let xyz = vector::cross_onto(q.xyz(), v, vector::scale(v, q.w()));
    Quat::from_parts(xyz, -vector::dot(q.xyz(), v))
}

/// Returns the vector part of ab*, which is w_b a − w_a b − a × b, plus `onto`.
#[cfg_attr(not(opt_level_0), inline(always))]
fn before_conjugate<L: Lanes>(a: Quat<L>, b: Quat<L>, onto: [L; 3]) -> [L; 3] {
    let onto = vector::scale_onto(a.xyz(), b.w(), onto);
    let onto = vector::scale_onto(b.xyz(), -a.w(), onto);
    vector::cross_onto(b.xyz(), a.xyz(), onto)
}

/// Returns the vector part of a*b, which is w_a b − w_b a − a × b, plus `onto`.
#[cfg_attr(not(opt_level_0), inline(always))]
fn after_conjugate<L: Lanes>(a: Quat<L>, b: Quat<L>, onto: [L; 3]) -> [L; 3] {
    let onto = vector::scale_onto(b.xyz(), a.w(), onto);
    let onto = vector::scale_onto(a.xyz(), -b.w(), onto);
    vector::cross_onto(b.xyz(), a.xyz(), onto)
}
