use super::HyperDual;
use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use dq8::Real;

impl<R: Real> Add for HyperDual<R> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(
            self.real + other.real,
            self.first + other.first,
            self.second + other.second,
            self.mixed + other.mixed,
        )
    }
}

impl<R: Real> Sub for HyperDual<R> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<R: Real> Neg for HyperDual<R> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.real, -self.first, -self.second, -self.mixed)
    }
}

/// aa′ + (ab′ + ba′)ε₁ + (ac′ + ca′)ε₂ + (ad′ + bc′ + cb′ + da′)ε₁ε₂ (Arends, chapter 5, §1).
impl<R: Real> Mul for HyperDual<R> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.real * other.real,
            self.real * other.first + self.first * other.real,
            self.real * other.second + self.second * other.real,
            self.real * other.mixed
                + self.first * other.second
                + self.second * other.first
                + self.mixed * other.real,
        )
    }
}

/// The quotient z with z·other = self, found from its real part on. Infinite or NaN where the
/// divisor has no real part, as for floats; [`HyperDual::inverse`] checks.
impl<R: Real> Div for HyperDual<R> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let real = self.real / other.real;
        let first = (self.first - real * other.first) / other.real;
        let second = (self.second - real * other.second) / other.real;
        let crossed = first * other.second + second * other.first;
        let mixed = (self.mixed - real * other.mixed - crossed) / other.real;
        Self::new(real, first, second, mixed)
    }
}

impl<R: Real> AddAssign for HyperDual<R> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<R: Real> SubAssign for HyperDual<R> {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<R: Real> MulAssign for HyperDual<R> {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl<R: Real> DivAssign for HyperDual<R> {
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl<R: Real> PartialOrd for HyperDual<R> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let by_size = |x: &Self| (x.real, x.second, x.first, x.mixed);
        by_size(self).partial_cmp(&by_size(other))
    }
}
