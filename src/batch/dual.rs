use super::exponential::{exp, ln};
use super::trigonometry::{acos, asin, atan, atan2, cathetus, sin_cos};
use core::ops::{Add, Div, Mul, Neg, Sub};
use dq8_simd::Lanes;

/// Dual numbers a + εb, one per lane: [`Dual`](crate::Dual) on lanes.
#[derive(Clone, Copy, Debug)]
pub struct Dual<L> {
    /// a, the real part.
    pub real: L,
    /// b, the dual part.
    pub dual: L,
}

impl<L: Lanes> Dual<L> {
    /// a + εb
    #[inline(always)]
    #[must_use]
    pub fn new(real: L, dual: L) -> Self {
        Self { real, dual }
    }

    /// f(a + εb) = f(a) + ε b f′(a), given f(a) and f′(a) (Jia eq. 10).
    #[inline(always)]
    #[must_use]
    pub fn apply(self, value: L, derivative: L) -> Self {
        Self::new(value, self.dual * derivative)
    }

    /// s(a + εb) for a real number s.
    #[inline(always)]
    #[must_use]
    pub fn scale(self, factor: L) -> Self {
        Self::new(self.real * factor, self.dual * factor)
    }

    /// √(a + εb) = √a + ε b/(2√a)
    #[inline(always)]
    #[must_use]
    pub fn sqrt(self) -> Self {
        let root = self.real.sqrt();
        self.apply(root, root.constant(0.5) / root)
    }

    /// 1 / (a + εb) = a⁻¹ − ε b a⁻² (Jia eq. 7)
    #[inline(always)]
    #[must_use]
    pub fn recip(self) -> Self {
        let recip = self.real.constant(1.0) / self.real;
        self.apply(recip, -(recip * recip))
    }

    /// sin a + ε b cos a, radians; NaN beyond 2¹⁶ rad (`f32`) or 2⁴⁵ rad (`f64`).
    #[inline(always)]
    #[must_use]
    pub fn sin(self) -> Self {
        let (sin, cos) = sin_cos(self.real);
        self.apply(sin, cos)
    }

    /// cos a − ε b sin a, radians; NaN beyond 2¹⁶ rad (`f32`) or 2⁴⁵ rad (`f64`).
    #[inline(always)]
    #[must_use]
    pub fn cos(self) -> Self {
        let (sin, cos) = sin_cos(self.real);
        self.apply(cos, -sin)
    }

    /// tan a + ε b/cos²a, radians; NaN beyond 2¹⁶ rad (`f32`) or 2⁴⁵ rad (`f64`).
    #[inline(always)]
    #[must_use]
    pub fn tan(self) -> Self {
        let (sin, cos) = sin_cos(self.real);
        let tan = sin / cos;
        self.apply(tan, tan.mul_add(tan, tan.constant(1.0)))
    }

    /// arcsin a + ε b/√(1 − a²), radians, |a| ≤ 1, else NaN; the derivative is infinite at ±1.
    #[inline(always)]
    #[must_use]
    pub fn asin(self) -> Self {
        self.apply(asin(self.real), self.real.constant(1.0) / cathetus(self.real))
    }

    /// arccos a − ε b/√(1 − a²), radians, |a| ≤ 1, else NaN; the derivative is infinite at ±1.
    #[inline(always)]
    #[must_use]
    pub fn acos(self) -> Self {
        self.apply(acos(self.real), self.real.constant(-1.0) / cathetus(self.real))
    }

    /// arctan a + ε b/(1 + a²), radians.
    #[inline(always)]
    #[must_use]
    pub fn atan(self) -> Self {
        let one = self.real.constant(1.0);
        self.apply(atan(self.real), one / self.real.mul_add(self.real, one))
    }

    /// The angle of the point (`x`, `self`), radians, with the derivative (x dy − y dx)/(x² + y²), by
    /// ratios to the larger of the two: squares might vanish.
    #[inline(always)]
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let (up, along) = (self.real.abs(), x.real.abs());
        let largest = L::select(along.lt(up), up, along);
        let (sin, cos) = (self.real / largest, x.real / largest);
        let turned = sin.neg_mul_add(x.dual, cos * self.dual);
        let squared = sin.mul_add(sin, cos * cos);
        Self::new(atan2(self.real, x.real), turned / squared / largest)
    }

    /// eᵃ + ε b eᵃ
    #[inline(always)]
    #[must_use]
    pub fn exp(self) -> Self {
        let exp = exp(self.real);
        self.apply(exp, exp)
    }

    /// ln a + ε b/a; NaN for a < 0.
    #[inline(always)]
    #[must_use]
    pub fn ln(self) -> Self {
        self.apply(ln(self.real), self.real.constant(1.0) / self.real)
    }

    /// aⁿ + ε b n aⁿ⁻¹ for whole n, the same in every lane, by squaring.
    #[inline(always)]
    #[must_use]
    pub fn powi(self, n: i32) -> Self {
        let one = Self::new(self.real.constant(1.0), self.real.constant(0.0));
        let (mut power, mut square, mut left) = (one, self, n.unsigned_abs());
        while left > 0 {
            if left % 2 == 1 {
                power = power * square;
            }
            left /= 2;
            // One more might overflow, and ∞·0 would be NaN.
            if left > 0 {
                square = square * square;
            }
        }
        if n < 0 { power.recip() } else { power }
    }
}

impl<L: Lanes> Add for Dual<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.real + other.real, self.dual + other.dual)
    }
}

impl<L: Lanes> Sub for Dual<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.real - other.real, self.dual - other.dual)
    }
}

/// ac + ε(ad + bc)
impl<L: Lanes> Mul for Dual<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(self.real * other.real, self.real.mul_add(other.dual, self.dual * other.real))
    }
}

/// a/c + ε(bc − ad)/c²
impl<L: Lanes> Div for Dual<L> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let quotient = self.real / other.real;
        Self::new(quotient, quotient.neg_mul_add(other.dual, self.dual) / other.real)
    }
}

impl<L: Lanes> Neg for Dual<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.real, -self.dual)
    }
}
