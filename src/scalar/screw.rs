//! Screws: parameters, logarithm, exponential, powers and screw interpolation.

use super::{DualQuat, Quat, vector};
use crate::geometry::{DualVector, Line, Screw};
use crate::number::Real;
use crate::quick;

impl<R: Real> DualQuat<R> {
    /// Returns the screw of a unit σ (Jia §8.2), with an angle in [0, π]. σ and −σ are the
    /// same motion, and the screw is that of the motion with the [canonical](Self::canonical) sign.
    ///
    /// A pure translation has angle 0, its own direction as axis and moment 0, although Jia's
    /// moment is infinite for it. The identity has the axis (1, 0, 0).
    ///
    /// The moment is about as long as |t| divided by the angle. It is not finite if this quotient
    /// overflows, or if the reciprocal of the angle overflows (for angles below 6·10⁻³⁹ in
    /// `f32`, whatever t is). [`from_screw`](Self::from_screw) cannot restore such a motion.
    /// [`log`](Self::log) has no such limit.
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

    /// Returns σ = cos(θ̂/2) + sin(θ̂/2)(l + εm) with θ̂ = θ + εd (Jia eq. 43). It is
    /// computed by the equivalent formula in real numbers (Jia eq. 42). The axis l must have length
    /// 1, and its moment m must be orthogonal to l. The angle θ is in radians, of any size, and
    /// the slide d is a length.
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

    /// Returns the logarithm a + εb = (θ̂/2)(l + εm) of a unit σ, where σ = ±exp(a + εb).
    /// The [canonical](Self::canonical) sign of σ is taken, so that |a| ≤ π/2. The logarithm
    /// has no singularity: a pure translation has a = 0, b = t/2.
    ///
    /// The dual part is b = hm + dl/2 with the moment m of Jia's eq. 37. For a translation m is
    /// infinite and h is zero, but b is finite: b = ½ ( h t×l + h cot h (t − d l) + d l ), h =
    /// θ/2.
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

    /// Returns the logarithm a + εb of σ without changing the sign of σ, so that 0 ≤ |a| ≤
    /// π.
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

    /// Returns the exponential of a + εb, which is the screw cos ĥ + sin ĥ (l + εm) with ĥ =
    /// h + εd/2, where h = |a|, l = a/h and d/2 = b·l (Jia eq. 43). For a = 0 it is 1 + εb, the
    /// translation by 2b.
    ///
    /// The length |a| is half the angle in radians. The error of the result grows with |a|, because
    /// the rounding error of |a| does. Beyond 2¹⁶ rad in `f32` and 2⁴⁵ rad in `f64`, the
    /// rounding error of the angle may exceed 2⁻⁸ rad, so every component of the result is NaN.
    /// Powers and interpolations that reach such angles are NaN too.
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

    /// Returns σᵗ = exp(t log σ) for any real t: a motion with the axis of σ and with t times
    /// its angle and its slide (Jia eq. 44). The [canonical](Self::canonical) one of σ and −σ
    /// is raised to the power. σ must be unit.
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

    /// Returns σ^½ (Jia eq. 44), the motion that gives σ when it is applied twice: half the
    /// angle and half the slide. The [canonical](Self::canonical) one of σ and −σ is taken, so
    /// the root turns by at most a quarter of a turn. σ must be unit.
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

    /// Screw linear interpolation from `self` (a) to `other` (b) by the shorter way, a(a*b)ᵗ (Jia
    /// eq. 46; Kavan et al. 2006). The body turns and slides along one screw at constant speed.
    /// `t` = 0 gives `self`, and 1 gives ±`other`; values outside [0, 1] continue along the screw.
    /// Both motions must be unit. If they are exactly half a turn apart, both ways are equally
    /// short, and the result takes the way to `other`, not to −`other`.
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
        // If `between` is half a turn, `pow` would use the canonical sign and might turn about the
        // opposite axis. Here the sign of `between` must stay as it is.
        if between.real().w() == R::ZERO && between.real().points_back() {
            return self * between.conjugate().pow(t).conjugate();
        }
        self * between.pow(t)
    }

    /// Interpolates like [`sclerp`](Self::sclerp), but always from `self` (a) to `other` (b) and
    /// never to −`other`: a exp(t log(a*b)), where the logarithm keeps the sign of a*b. This is
    /// the longer way if the real parts of a and b have a negative scalar product. Both motions
    /// must be unit. The way from σ to −σ has no axis, so every component is then NaN. The
    /// formula is Jia's eq. 46 as written, which does not say which sign of b to take.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn sclerp_long(self, other: Self, t: R) -> Self {
        crate::scalar::must_be_unit::motions("DualQuat::sclerp_long", [self, other]);
        let log = (self.conjugate() * other).log_without_flip();
        self * Self::exp(log.scale(t))
    }
}
