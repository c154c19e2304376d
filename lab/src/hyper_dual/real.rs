//! Hyper-dual numbers as [`Real`]: dq8's scalar reference computes with them.

use super::HyperDual;
use core::fmt;
use dq8::Real;

impl<R: Real> Real for HyperDual<R> {
    const ZERO: Self = Self::constant(R::ZERO);
    const ONE: Self = Self::constant(R::ONE);
    const TWO: Self = Self::constant(R::TWO);
    const HALF: Self = Self::constant(R::HALF);
    const PI: Self = Self::constant(R::PI);
    const EPSILON: Self = Self::constant(R::EPSILON);
    const NAN: Self = Self::new(R::NAN, R::NAN, R::NAN, R::NAN);

    fn from_f64(value: f64) -> Self {
        Self::constant(R::from_f64(value))
    }
    fn is_finite(self) -> bool {
        let Self { real, first, second, mixed } = self;
        [real, first, second, mixed].into_iter().all(R::is_finite)
    }
    fn abs(self) -> Self {
        let positive = if self < Self::ZERO { -self } else { self };
        // −0 is not less than 0.
        Self { real: positive.real.abs(), ..positive }
    }
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
    fn sin(self) -> Self {
        Self::sin(self)
    }
    fn cos(self) -> Self {
        Self::cos(self)
    }
    fn tan(self) -> Self {
        Self::tan(self)
    }
    fn asin(self) -> Self {
        Self::asin(self)
    }
    fn acos(self) -> Self {
        Self::acos(self)
    }
    fn atan(self) -> Self {
        Self::atan(self)
    }
    fn atan2(self, x: Self) -> Self {
        Self::atan2(self, x)
    }
    fn exp(self) -> Self {
        Self::exp(self)
    }
    fn ln(self) -> Self {
        Self::ln(self)
    }
}

impl<R: Real> fmt::Display for HyperDual<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { real, first, second, mixed } = self;
        write!(f, "({real} + {first}ε₁ + {second}ε₂ + {mixed}ε₁ε₂)")
    }
}

/// a, which does not change.
impl<R: Real> From<f32> for HyperDual<R> {
    fn from(value: f32) -> Self {
        Self::constant(R::from(value))
    }
}

/// The real part, for error messages.
impl<R: Real> From<HyperDual<R>> for f64 {
    fn from(value: HyperDual<R>) -> Self {
        value.real.into()
    }
}
