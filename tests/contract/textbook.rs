//! [`Textbook`]: floats without the quicker forms that floats have, so that `DualQuat` of it is the
//! textbook reference and nothing else.

use dq8::Real;
use std::fmt;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A number that computes as `F` does.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Textbook<F>(pub F);

impl<F: Real> Real for Textbook<F> {
    const ZERO: Self = Self(F::ZERO);
    const ONE: Self = Self(F::ONE);
    const TWO: Self = Self(F::TWO);
    const HALF: Self = Self(F::HALF);
    const PI: Self = Self(F::PI);
    const EPSILON: Self = Self(F::EPSILON);
    const NAN: Self = Self(F::NAN);

    fn from_f64(value: f64) -> Self {
        Self(F::from_f64(value))
    }
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    fn sin(self) -> Self {
        Self(self.0.sin())
    }
    fn cos(self) -> Self {
        Self(self.0.cos())
    }
    fn tan(self) -> Self {
        Self(self.0.tan())
    }
    fn asin(self) -> Self {
        Self(self.0.asin())
    }
    fn acos(self) -> Self {
        Self(self.0.acos())
    }
    fn atan(self) -> Self {
        Self(self.0.atan())
    }
    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0))
    }
    fn exp(self) -> Self {
        Self(self.0.exp())
    }
    fn ln(self) -> Self {
        Self(self.0.ln())
    }
}

impl<F: Real> Add for Textbook<F> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl<F: Real> Sub for Textbook<F> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl<F: Real> Mul for Textbook<F> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl<F: Real> Div for Textbook<F> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl<F: Real> Neg for Textbook<F> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<F: Real> AddAssign for Textbook<F> {
    fn add_assign(&mut self, other: Self) {
        self.0 += other.0;
    }
}

impl<F: Real> SubAssign for Textbook<F> {
    fn sub_assign(&mut self, other: Self) {
        self.0 -= other.0;
    }
}

impl<F: Real> MulAssign for Textbook<F> {
    fn mul_assign(&mut self, other: Self) {
        self.0 *= other.0;
    }
}

impl<F: Real> DivAssign for Textbook<F> {
    fn div_assign(&mut self, other: Self) {
        self.0 /= other.0;
    }
}

impl<F: Real> From<f32> for Textbook<F> {
    fn from(value: f32) -> Self {
        Self(F::from(value))
    }
}

impl<F: Real> From<Textbook<F>> for f64 {
    fn from(value: Textbook<F>) -> Self {
        value.0.into()
    }
}

impl<F: fmt::Display> fmt::Display for Textbook<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
