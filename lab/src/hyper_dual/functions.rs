//! Functions by their value and their two derivatives. Where a derivative is infinite the result
//! is infinite or NaN, as floats have it.

use super::HyperDual;
use dq8::Real;

impl<R: Real> HyperDual<R> {
    /// √a, with f′ = 1/(2√a) and f″ = −1/(4a√a); NaN for a < 0, no derivatives for a = 0.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let root = self.real.sqrt();
        let first = R::HALF / root;
        self.apply(root, first, -R::HALF * first / self.real)
    }

    /// sin a, radians, with f′ = cos a and f″ = −sin a.
    #[must_use]
    pub fn sin(self) -> Self {
        let (sin, cos) = (self.real.sin(), self.real.cos());
        self.apply(sin, cos, -sin)
    }

    /// cos a, radians, with f′ = −sin a and f″ = −cos a.
    #[must_use]
    pub fn cos(self) -> Self {
        let (sin, cos) = (self.real.sin(), self.real.cos());
        self.apply(cos, -sin, -cos)
    }

    /// tan a, radians, with f′ = 1 + tan²a and f″ = 2 tan a f′.
    #[must_use]
    pub fn tan(self) -> Self {
        let tan = self.real.tan();
        let first = R::ONE + tan * tan;
        self.apply(tan, first, R::TWO * tan * first)
    }

    /// arcsin a, radians, |a| ≤ 1, else NaN, with f′ = 1/√(1 − a²) and f″ = a f′³.
    #[must_use]
    pub fn asin(self) -> Self {
        let first = R::ONE / ((R::ONE - self.real) * (R::ONE + self.real)).sqrt();
        self.apply(self.real.asin(), first, self.real * first * first * first)
    }

    /// arccos a, radians, |a| ≤ 1, else NaN, with f′ = −1/√(1 − a²) and f″ = a f′³.
    #[must_use]
    pub fn acos(self) -> Self {
        let first = -R::ONE / ((R::ONE - self.real) * (R::ONE + self.real)).sqrt();
        self.apply(self.real.acos(), first, self.real * first * first * first)
    }

    /// arctan a, radians, with f′ = 1/(1 + a²) and f″ = −2a f′².
    #[must_use]
    pub fn atan(self) -> Self {
        let first = R::ONE / (R::ONE + self.real * self.real);
        self.apply(self.real.atan(), first, -R::TWO * self.real * first * first)
    }

    /// The angle of the point z = `x` + i `self`, radians: Im ln z, with dz/z and the second
    /// derivative dz₁₂/z − (dz₁/z)(dz₂/z). By ratios to the larger of the two: squares might vanish.
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let largest = self.real.abs().max_or_nan(x.real.abs());
        let (sin, cos) = (self.real / largest, x.real / largest);
        let size = (sin * sin + cos * cos) * largest;
        let grown = |dx: R, dy: R| (cos * dx + sin * dy) / size;
        let turned = |dx: R, dy: R| (cos * dy - sin * dx) / size;
        let (first, second) = (turned(x.first, self.first), turned(x.second, self.second));
        let crossed = grown(x.first, self.first) * second + grown(x.second, self.second) * first;
        let mixed = turned(x.mixed, self.mixed) - crossed;
        Self::new(self.real.atan2(x.real), first, second, mixed)
    }

    /// eᵃ, which is its own derivative.
    #[must_use]
    pub fn exp(self) -> Self {
        let exp = self.real.exp();
        self.apply(exp, exp, exp)
    }

    /// ln a, with f′ = 1/a and f″ = −1/a²; NaN for a < 0.
    #[must_use]
    pub fn ln(self) -> Self {
        let first = R::ONE / self.real;
        self.apply(self.real.ln(), first, -first * first)
    }

    /// aᵖ = exp(p ln a) for a > 0 and a constant p, with f′ = p aᵖ/a and f″ = (p − 1) f′/a; NaN for
    /// a < 0.
    #[must_use]
    pub fn pow(self, exponent: R) -> Self {
        let value = (exponent * self.real.ln()).exp();
        let first = exponent * value / self.real;
        self.apply(value, first, (exponent - R::ONE) * first / self.real)
    }
}
