//! Hyper-dual numbers: a function computed with them gives its first and second derivatives.

mod arithmetic;
mod functions;
mod real;

use dq8::Real;

/// A hyper-dual number a + bε₁ + cε₂ + dε₁ε₂ with ε₁² = ε₂² = 0, ε₁ε₂ = ε₂ε₁ ≠ 0 (Fike & Alonso
/// 2011; Arends, chapter 5, §1).
///
/// f(a + ε₁ + ε₂) = f(a) + f′(a)ε₁ + f′(a)ε₂ + f″(a)ε₁ε₂ for what is written for every
/// [`Real`]; no difference is taken, so there is no step to choose.
///
/// The same numbers are `dq8::Dual<dq8::Dual<R>>`, ε₁ outside and ε₂ inside. Here they are written
/// out, and share no formula with those: each is the test of the other.
///
/// ```
/// use lab::HyperDual;
/// // x³ at x = 2: 8, 3·4 and 6·2.
/// let x = HyperDual::new(2.0, 1.0, 1.0, 0.0);
/// assert_eq!(x * x * x, HyperDual::new(8.0, 12.0, 12.0, 12.0));
/// ```
///
/// The order is that of infinitesimals, ε₁ε₂ ≪ ε₁ ≪ ε₂ ≪ 1: by a, then c, b, d, as the nested dual
/// numbers have it. Fike & Alonso compare by a alone, which [`Real`] does not allow, because
/// numbers that are neither less nor greater must be equal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HyperDual<R> {
    /// a, the value.
    pub real: R,
    /// b, of ε₁: the derivative by the variable that ε₁ is put on.
    pub first: R,
    /// c, of ε₂: the derivative by the variable that ε₂ is put on.
    pub second: R,
    /// d, of ε₁ε₂: the second derivative by both.
    pub mixed: R,
}

impl<R: Real> HyperDual<R> {
    /// ε₁
    pub const EPSILON_1: Self = Self::new(R::ZERO, R::ONE, R::ZERO, R::ZERO);
    /// ε₂
    pub const EPSILON_2: Self = Self::new(R::ZERO, R::ZERO, R::ONE, R::ZERO);
    /// ε₁ε₂
    pub const EPSILON_12: Self = Self::new(R::ZERO, R::ZERO, R::ZERO, R::ONE);

    /// a + bε₁ + cε₂ + dε₁ε₂
    #[must_use]
    pub const fn new(real: R, first: R, second: R, mixed: R) -> Self {
        Self { real, first, second, mixed }
    }

    /// a, which does not change.
    #[must_use]
    pub const fn constant(real: R) -> Self {
        Self::new(real, R::ZERO, R::ZERO, R::ZERO)
    }

    /// 1/a − b/a² ε₁ − c/a² ε₂ + (2bc/a³ − d/a²)ε₁ε₂ (Arends, chapter 5, §1).
    ///
    /// `None` if a is zero or not finite: what has no real part has no inverse.
    ///
    /// ```
    /// use dq8::Real;
    /// use lab::HyperDual;
    /// let x = HyperDual::new(2.0, 1.0, 3.0, 5.0);
    /// assert_eq!(x.inverse().map(|inverse| inverse * x), Some(HyperDual::ONE));
    /// assert!(HyperDual::<f64>::EPSILON_1.inverse().is_none());
    /// ```
    pub fn inverse(self) -> Option<Self> {
        (self.real != R::ZERO && self.real.is_finite()).then(|| Self::ONE / self)
    }

    /// ε₁ → −ε₁: a − bε₁ + cε₂ − dε₁ε₂
    #[must_use]
    pub fn conjugate_first(self) -> Self {
        Self::new(self.real, -self.first, self.second, -self.mixed)
    }

    /// ε₂ → −ε₂: a + bε₁ − cε₂ − dε₁ε₂
    #[must_use]
    pub fn conjugate_second(self) -> Self {
        Self::new(self.real, self.first, -self.second, -self.mixed)
    }

    /// ε₁ → −ε₁ and ε₂ → −ε₂: a − bε₁ − cε₂ + dε₁ε₂
    #[must_use]
    pub fn conjugate_both(self) -> Self {
        Self::new(self.real, -self.first, -self.second, self.mixed)
    }

    /// |a|, the norm: the product of the number and its three conjugates is a⁴.
    #[must_use]
    pub fn norm(self) -> R {
        self.real.abs()
    }

    /// f(a) + f′(a)bε₁ + f′(a)cε₂ + (f′(a)d + f″(a)bc)ε₁ε₂, given f(a), f′(a) and f″(a) (Fike &
    /// Alonso 2011).
    #[must_use]
    pub fn apply(self, value: R, first: R, second: R) -> Self {
        let curved = second * self.first * self.second;
        Self::new(value, first * self.first, first * self.second, first * self.mixed + curved)
    }
}
