//! Screws: parameters, logarithm, exponential, powers and screw interpolation.

use super::{DualQuat, Quat, vector};
use crate::geometry::{DualVector, Line, Screw};
use crate::number::Real;
use crate::quick;

impl<R: Real> DualQuat<R> {
    /// The screw of a unit σ (Jia §8.2), angle in [0, π]: of ±σ, the
    /// [canonical](Self::canonical) one is taken.
    ///
    /// A pure translation has angle 0, its own direction as axis and moment 0 (Jia's moment is
    /// infinite there); the identity has the axis (1, 0, 0).
    ///
    /// The moment is as long as t over the angle: where a turn is so small that this overflows, or
    /// one over the angle does (below 6·10⁻³⁹ in `f32`, whatever t is), it is not finite, and
    /// [`from_screw`](Self::from_screw) has no way back. The logarithm has no such end.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let screw = DualQuat::from_translation([0.0_f64, 3.0, 4.0]).to_screw();
    /// assert_eq!((screw.angle, screw.slide, screw.axis.direction), (0.0, 5.0, [0.0, 0.6, 0.8]));
    /// ```
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn to_screw(self) -> Screw<R> {
        crate::scalar::must_be_unit::motions("DualQuat::to_screw", [self]);
        let sigma = self.canonical();
        let t = sigma.translation();
        let sine = vector::norm(sigma.real().xyz());
        if sine == R::ZERO {
            let slide = vector::norm(t);
            let direction = if slide == R::ZERO {
                [R::ONE, R::ZERO, R::ZERO]
            } else {
                vector::direction(t, slide)
            };
            let axis = Line { direction, moment: [R::ZERO; 3] };
            return Screw { axis, angle: R::ZERO, slide };
        }
        let half_angle = sine.atan2(sigma.real().w());
        let direction = vector::direction(sigma.real().xyz(), sine);
        let slide = vector::dot(t, direction);
        // m = ½ (t × l + (t − d l) cot(θ/2)), Jia eq. 37
        let cot = sigma.real().w() / sine;
        let across = vector::sub(t, vector::scale(direction, slide));
        let twice = vector::add(vector::cross(t, direction), vector::scale(across, cot));
        let axis = Line { direction, moment: vector::scale(twice, R::HALF) };
        Screw { axis, angle: R::TWO * half_angle, slide }
    }

    /// σ = cos(θ̂/2) + sin(θ̂/2)(l + εm), θ̂ = θ + εd (Jia eq. 43; eq. 42 is the same in
    /// real numbers, as it is computed here). The axis must have length 1, and its moment be
    /// orthogonal to it; the angle is any, in radians, the slide a length.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn from_screw(screw: Screw<R>) -> Self {
        crate::scalar::must_be_unit::axis("DualQuat::from_screw", screw.axis.direction);
        let (sin, cos) = ((screw.angle * R::HALF).sin(), (screw.angle * R::HALF).cos());
        let half_slide = screw.slide * R::HALF;
        let l = screw.axis.direction;
        let dual =
            vector::add(vector::scale(screw.axis.moment, sin), vector::scale(l, half_slide * cos));
        Self::new(
            Quat::from_parts(vector::scale(l, sin), cos),
            Quat::from_parts(dual, -half_slide * sin),
        )
    }

    /// The logarithm of a unit σ, a + εb = (θ̂/2)(l + εm) with σ = ±exp(a + εb): of ±σ,
    /// the [canonical](Self::canonical) one, so that |a| ≤ π/2. No singularity: a pure
    /// translation has a = 0, b = t/2.
    ///
    /// From Jia eq. 37, the infinite moment multiplied by the vanishing angle:
    /// b = ½ ( h t×l + h cot h (t − d l) + d l ), h = θ/2.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let log = DualQuat::from_translation([2.0_f32, 4.0, 6.0]).log();
    /// assert_eq!((log.real, log.dual), ([0.0; 3], [1.0, 2.0, 3.0]));
    /// ```
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("ln"))]
    pub fn log(self) -> DualVector<R> {
        crate::scalar::must_be_unit::motions("DualQuat::log", [self]);
        if let Some(log) = R::quick(quick::Log(self.to_array())) {
            return log;
        }
        self.canonical().log_without_flip()
    }

    /// Returns the logarithm of σ itself and not of −σ: 0 ≤ |a| ≤ π.
    #[inline]
    fn log_without_flip(self) -> DualVector<R> {
        let t = self.translation();
        let sine = vector::norm(self.real().xyz());
        let cosine = self.real().w();
        if sine == R::ZERO && cosine >= R::ZERO {
            return DualVector { real: [R::ZERO; 3], dual: vector::scale(t, R::HALF) };
        }
        let h = sine.atan2(cosine);
        let h_cot_h = h / sine * cosine;
        let l = self.real().xyz().map(|c| c / sine);
        let along = vector::scale(l, vector::dot(t, l));
        let turned = vector::add(
            vector::scale(vector::cross(t, l), h),
            vector::scale(vector::sub(t, along), h_cot_h),
        );
        DualVector {
            real: vector::scale(l, h),
            dual: vector::scale(vector::add(turned, along), R::HALF),
        }
    }

    /// The exponential of a + εb: with h = |a|, l = a/h and d/2 = b·l, the screw cos ĥ + sin ĥ
    /// (l + εm), ĥ = h + εd/2 (Jia eq. 43). For a = 0 it is 1 + εb, the translation by 2b. |a|
    /// is half the angle in radians, and the error grows with it as that of its rounding does. NaN
    /// in every component beyond 2¹⁶ rad in `f32` and 2⁴⁵ rad in `f64`, where a float is
    /// known to no more than 2⁻⁸ rad; powers and interpolations that go so far are NaN too.
    ///
    /// ```
    /// use dq8::{DualQuat, geometry::DualVector};
    /// let quarter = core::f64::consts::FRAC_PI_2;
    /// let half_turn = DualVector { real: [0.0, 0.0, quarter], dual: [0.0; 3] };
    /// let [x, y, _] = DualQuat::exp(half_turn).transform_point([1.0, 0.0, 0.0]);
    /// assert!((x + 1.0).abs() < 1e-15 && y.abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn exp(log: DualVector<R>) -> Self {
        if let Some(exp) = R::quick(quick::Exp(log)) {
            return Self::from_array(exp);
        }
        let h = vector::norm(log.real);
        if h == R::ZERO {
            return Self::new(Quat::IDENTITY, Quat::from_parts(log.dual, R::ZERO));
        }
        let (sin, cos) = (h.sin(), h.cos());
        let l = log.real.map(|c| c / h);
        let half_slide = vector::dot(log.dual, l);
        let along = vector::scale(l, half_slide);
        let across = vector::sub(log.dual, along);
        let dual = vector::add(vector::scale(across, sin / h), vector::scale(along, cos));
        Self::new(
            Quat::from_parts(vector::scale(l, sin), cos),
            Quat::from_parts(dual, -half_slide * sin),
        )
    }

    /// σᵗ = exp(t log σ): the same screw axis, t times the angle and the slide (Jia eq. 44, for
    /// any real t). Of ±σ, the [canonical](Self::canonical) one. σ must be unit.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let step = DualQuat::from_translation([1.0_f32, 2.0, 3.0]);
    /// assert_eq!(step.pow(-2.0).translation(), [-2.0, -4.0, -6.0]);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("powf"))]
    pub fn pow(self, t: R) -> Self {
        crate::scalar::must_be_unit::motions("DualQuat::pow", [self]);
        if let Some(power) = R::quick(quick::Pow(self.to_array(), t)) {
            return Self::from_array(power);
        }
        self.spilled_copy().pow_by_the_book(t).spilled_copy()
    }

    #[cold]
    #[inline(never)]
    fn pow_by_the_book(self, t: R) -> Self {
        Self::exp(self.log().scale(t))
    }

    /// σ^½ (Jia eq. 44), the motion that gives σ when made twice: half the angle, half the
    /// slide. Of ±σ, the [canonical](Self::canonical) one, so at most a quarter of a turn. σ
    /// must be unit.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn sqrt(self) -> Self {
        crate::scalar::must_be_unit::motions("DualQuat::sqrt", [self]);
        if let Some(root) = R::quick(quick::Sqrt(self.to_array())) {
            return Self::from_array(root);
        }
        self.pow(R::HALF)
    }

    /// Screw linear interpolation, a(a*b)ᵗ, by the shorter way (Jia eq. 46; Kavan et al. 2006):
    /// constant speed of turning and sliding along one screw. `t` = 0 gives `self`, 1 gives
    /// ±`other`; values outside [0, 1] go on along the screw. Both must be unit; exactly half a
    /// turn apart either way is as short, and the one of `other` as it stands is taken.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// let a = DualQuat::<f64>::IDENTITY;
    /// let b = DualQuat::from_rotation_translation(
    ///     Quat::from_axis_angle([0.0, 0.0, 1.0], 1.0),
    ///     [0.0, 0.0, 2.0],
    /// );
    /// let screw = a.sclerp(b, 0.25).to_screw();
    /// assert!((screw.angle - 0.25).abs() < 1e-15 && (screw.slide - 0.5).abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("lerp_slerp", "screw_interpolation", "interpolate"))]
    pub fn sclerp(self, other: Self, t: R) -> Self {
        crate::scalar::must_be_unit::motions("DualQuat::sclerp", [self, other]);
        if let Some(between) = R::quick(quick::Sclerp(self.to_array(), other.to_array(), t)) {
            return Self::from_array(between);
        }
        self.spilled_copy().sclerp_by_the_book(other.spilled_copy(), t).spilled_copy()
    }

    #[inline(never)]
    fn sclerp_by_the_book(self, other: Self, t: R) -> Self {
        let between = self.conjugate() * other;
        // At half a turn `pow` would turn about the canonical axis. Here the axis must be the one
        // of `other` as it is given.
        if between.real().w() == R::ZERO && between.real().points_back() {
            return self * between.conjugate().pow(t).conjugate();
        }
        self * between.pow(t)
    }

    /// Interpolates like [`sclerp`](Self::sclerp), but from `self` to `other` and not to
    /// −`other`: the longer way where the two point apart: a exp(t log(a*b)), the logarithm not
    /// turned over. Both must be unit. The way from σ to −σ itself has no axis: every component
    /// is NaN. This is Jia's eq. 46 as it is written; he leaves the sign of b open.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn sclerp_long(self, other: Self, t: R) -> Self {
        crate::scalar::must_be_unit::motions("DualQuat::sclerp_long", [self, other]);
        let log = (self.conjugate() * other).log_without_flip();
        self * Self::exp(log.scale(t))
    }
}
