//! Dual numbers. Code that is generic over [`Real`] computes its own derivative when it is called
//! with dual numbers.

use super::error::{InverseError, Normed};
use crate::contract::{power, sums_by_part};
use crate::number::Real;
use core::fmt;
use core::ops::{Div, Mul};

crate::macros::pod! {
    /// A dual number a + εb, ε² = 0 (Clifford 1873).
    ///
    /// A function of a dual number is f(a + εb) = f(a) + ε b f′(a) (Jia eq. 10), so any
    /// computation with dual numbers yields the derivative along with the value:
    ///
    /// ```
    /// use dq8::Dual;
    /// // d/dx (x² sin x) at x = 2
    /// let x = Dual::new(2.0_f64, 1.0);
    /// let y = x * x * x.sin();
    /// assert!((y.dual - (4.0 * 2.0_f64.sin() + 4.0 * 2.0_f64.cos())).abs() < 1e-14);
    /// ```
    ///
    /// Dual numbers are ordered as if ε were positive and smaller than every positive number: by
    /// their real parts, and by their dual parts if the real parts are equal.
    #[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[must_use]
    pub struct Dual<R> {
        /// a, the real part.
        pub real: R,
        /// b, the dual part.
        pub dual: R,
    }
}

impl<R: Real> Dual<R> {
    /// 0 + ε0
    pub const ZERO: Self = Self::new(R::ZERO, R::ZERO);
    /// 1 + ε0
    pub const ONE: Self = Self::new(R::ONE, R::ZERO);
    /// The dual unit 0 + ε1
    pub const EPSILON: Self = Self::new(R::ZERO, R::ONE);

    /// a + εb
    #[inline]
    pub const fn new(real: R, dual: R) -> Self {
        Self { real, dual }
    }

    /// Returns 1 / (a + εb) = a⁻¹ − ε b a⁻² (Jia eq. 7).
    ///
    /// # Errors
    /// If a is zero or not finite. (A dual number 0 + εb has no inverse.)
    ///
    /// ```
    /// use dq8::Dual;
    /// let x = Dual::new(4.0_f32, 2.0);
    /// assert_eq!(x.inverse().unwrap() * x, Dual::ONE);
    /// assert!(Dual::<f32>::EPSILON.inverse().is_err());
    /// ```
    #[inline]
    pub fn inverse(self) -> Result<Self, InverseError> {
        // If 0/a is not finite (it is then NaN), a is zero, and 0 + bε has no inverse.
        if !self.real.is_finite() || !(R::ZERO / self.real).is_finite() {
            return Err(InverseError { real_norm: self.real.abs().into(), of: Normed::DualNumber });
        }
        Ok(Self::ONE / self)
    }

    /// Returns s(a + εb) for the real number s = `factor`.
    #[inline]
    pub fn scale(self, factor: R) -> Self {
        Self::new(self.real * factor, self.dual * factor)
    }

    /// Returns 1 / (a + εb) without a check. The result is infinite or NaN for a = 0, as with
    /// floats.
    #[inline]
    pub fn recip(self) -> Self {
        Self::ONE / self
    }

    /// Returns aⁿ + ε b n aⁿ⁻¹ for a whole n, by repeated squaring. The zeroth power of
    /// every number is 1, even of 0.
    ///
    /// ```
    /// use dq8::Dual;
    /// assert_eq!(Dual::new(2.0_f32, 1.0).powi(3), Dual::new(8.0, 12.0));
    /// assert_eq!(Dual::new(2.0_f32, 1.0).powi(-1), Dual::new(0.5, -0.25));
    /// ```
    #[inline]
    pub fn powi(self, n: i32) -> Self {
        power(self, Self::ONE, n)
    }

    /// Returns f(a + εb) = f(a) + ε b f′(a) for any function f, given f(a) and f′(a) (Jia eq.
    /// 10).
    ///
    /// ```
    /// use dq8::Dual;
    /// let cube = |x: Dual<f64>| x.apply(x.real.powi(3), 3.0 * x.real.powi(2));
    /// assert_eq!(cube(Dual::new(2.0, 1.0)), Dual::new(8.0, 12.0));
    /// ```
    #[inline]
    pub fn apply(self, value: R, derivative: R) -> Self {
        Self::new(value, self.dual * derivative)
    }

    /// Returns √(a + εb) = √a + ε b/(2√a), by Jia's eq. 10; Fabisch ("Inverse Square Root
    /// of a Dual Number") gives the reciprocal. The result is NaN for a < 0. For a = 0 its dual
    /// part is infinite, or NaN if b = 0 too.
    #[inline]
    pub fn sqrt(self) -> Self {
        let root = self.real.sqrt();
        self.apply(root, R::HALF / root)
    }

    /// Returns sin a + ε b cos a, with a in radians.
    #[inline]
    pub fn sin(self) -> Self {
        self.apply(self.real.sin(), self.real.cos())
    }

    /// Returns cos a − ε b sin a, with a in radians.
    #[inline]
    pub fn cos(self) -> Self {
        self.apply(self.real.cos(), -self.real.sin())
    }

    /// Returns tan a + ε b/cos²a, with a in radians.
    #[inline]
    pub fn tan(self) -> Self {
        let tan = self.real.tan();
        self.apply(tan, R::ONE + tan * tan)
    }

    /// Returns arcsin a + ε b/√(1 − a²) in radians for |a| ≤ 1, and NaN for any other a.
    /// The derivative is infinite at ±1.
    #[inline]
    pub fn asin(self) -> Self {
        let cos = ((R::ONE - self.real) * (R::ONE + self.real)).sqrt();
        self.apply(self.real.asin(), R::ONE / cos)
    }

    /// Returns arccos a − ε b/√(1 − a²) in radians for |a| ≤ 1, and NaN for any other a.
    /// The derivative is infinite at ±1.
    #[inline]
    pub fn acos(self) -> Self {
        let sin = ((R::ONE - self.real) * (R::ONE + self.real)).sqrt();
        self.apply(self.real.acos(), -R::ONE / sin)
    }

    /// Returns arctan a + ε b/(1 + a²), in radians.
    #[inline]
    pub fn atan(self) -> Self {
        self.apply(self.real.atan(), R::ONE / (R::ONE + self.real * self.real))
    }

    /// Returns the angle of the point (`x`, `self`) in radians, in [−π, π], with the derivative
    /// (x dy − y dx)/(x² + y²). In this formula x and y are first divided by the larger of |x|
    /// and |y|, because their squares might underflow to zero.
    #[inline]
    pub fn atan2(self, x: Self) -> Self {
        let largest = self.real.abs().max_or_nan(x.real.abs());
        let (sin, cos) = (self.real / largest, x.real / largest);
        let turned = (cos * self.dual - sin * x.dual) / (sin * sin + cos * cos);
        Self::new(self.real.atan2(x.real), turned / largest)
    }

    /// Returns eᵃ + ε b eᵃ.
    #[inline]
    pub fn exp(self) -> Self {
        let exp = self.real.exp();
        self.apply(exp, exp)
    }

    /// Returns ln a + ε b/a; the result is NaN for a < 0.
    #[inline]
    pub fn ln(self) -> Self {
        self.apply(self.real.ln(), R::ONE / self.real)
    }
}

sums_by_part! {
    /// (a + εb) + (c + εd) = (a + c) + ε(b + d) (Jia eq. 5).
    [R: Real] #[inline] Dual<R>: (real) (dual)
}

/// (a + εb)(c + εd) = ac + ε(ad + bc) (Jia eq. 6).
impl<R: Real> Mul for Dual<R> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.real * other.real, self.real * other.dual + self.dual * other.real)
    }
}

/// (a + εb)/(c + εd) = a/c + ε(bc − ad)/c² (Kenwright §5.1). For c = 0 the quotient does not
/// exist, and the result is infinite or NaN, as for floats; [`Dual::inverse`] returns an error
/// instead.
impl<R: Real> Div for Dual<R> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.real / other.real;
        Self::new(quotient, (self.dual - quotient * other.dual) / other.real)
    }
}

/// Implements methods of [`Real`] by calls of the inherent methods of [`Dual`] with the same names.
macro_rules! functions {
    ($($name:ident($($x:ident)?))*) => {$(
        fn $name(self $(, $x: Self)?) -> Self {
            Self::$name(self $(, $x)?)
        }
    )*};
}

/// Forward automatic differentiation: a function written for every `R: Real` and called with x + ε
/// returns f(x) + εf′(x) (Jia eq. 10). `Dual<Dual<R>>` are the hyper-dual numbers of Fike &
/// Alonso (2011), with ε₁ outside and ε₂ inside; they give second derivatives without finite
/// differences.
///
/// The operations of [`DualQuat`](crate::DualQuat) and [`Quat`](crate::Quat) are such functions:
///
/// ```
/// use dq8::{Dual, Quat};
/// // How does a point on a wheel move as the wheel turns?
/// let angle = Dual::new(0.5_f64, 1.0);
/// let axis = [0.0, 0.0, 1.0].map(|c| Dual::new(c, 0.0));
/// let rim = [1.0, 0.0, 0.0].map(|c| Dual::new(c, 0.0));
/// let velocity = Quat::from_axis_angle(axis, angle).rotate(rim).map(|c| c.dual);
/// assert!((velocity[0] + 0.5_f64.sin()).abs() + (velocity[1] - 0.5_f64.cos()).abs() < 1e-15);
/// ```
///
/// At a kink or a pole of f, the derivative is that of the branch taken, or it is infinite or NaN,
/// as with floats. The length of a vector has a kink at zero, and the exponential and the logarithm
/// of a motion begin with a length. So for a motion without any turn, both their value and their
/// derivative are NaN. For joints that may be at rest, use `from_axis_angle` and `from_screw`,
/// which have no such point. `Real::EPSILON` is the rounding unit of `R`; the dual unit ε is
/// [`Dual::EPSILON`].
impl<R: Real> Real for Dual<R> {
    const ZERO: Self = Self::new(R::ZERO, R::ZERO);
    const ONE: Self = Self::new(R::ONE, R::ZERO);
    const TWO: Self = Self::new(R::TWO, R::ZERO);
    const HALF: Self = Self::new(R::HALF, R::ZERO);
    const PI: Self = Self::new(R::PI, R::ZERO);
    const EPSILON: Self = Self::new(R::EPSILON, R::ZERO);
    const NAN: Self = Self::new(R::NAN, R::NAN);

    fn from_f64(value: f64) -> Self {
        Self::new(R::from_f64(value), R::ZERO)
    }
    fn is_finite(self) -> bool {
        self.real.is_finite() && self.dual.is_finite()
    }
    fn abs(self) -> Self {
        // Dual numbers with equal real parts are ordered by their dual parts, so 0 − ε is
        // negative.
        let dual = if self < <Self as Real>::ZERO { -self.dual } else { self.dual };
        Self::new(self.real.abs(), dual)
    }
    functions! { sqrt() sin() cos() tan() asin() acos() atan() atan2(x) exp() ln() }
}

impl<R: Real> fmt::Display for Dual<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({} + {}ε)", self.real, self.dual)
    }
}

/// Converts a real number a to a + ε0.
impl<R: Real> From<f32> for Dual<R> {
    fn from(value: f32) -> Self {
        Self::new(R::from(value), R::ZERO)
    }
}

/// Returns the real part, which error messages print.
impl<R: Real> From<Dual<R>> for f64 {
    fn from(value: Dual<R>) -> Self {
        value.real.into()
    }
}
