//! Hyper-dual numbers: a function computed with them gives its first and second derivatives.

use dq8::{Dual, Real};

/// A hyper-dual number a + bε₁ + cε₂ + dε₁ε₂ with ε₁² = ε₂² = 0, ε₁ε₂ =
/// ε₂ε₁ ≠ 0 (Fike & Alonso 2011; Arends, chapter 5, §1): a dual number of dual numbers,
/// ε₁ outside and ε₂ inside.
///
/// f(a + ε₁ + ε₂) = f(a) + f′(a)ε₁ + f′(a)ε₂ + f″(a)ε₁ε₂ for what is
/// written for every [`Real`]; no difference is taken, so there is no step to choose.
pub type HyperDual<R> = Dual<Dual<R>>;

/// a + bε₁ + cε₂ + dε₁ε₂
///
/// ```
/// use lab::hyper_dual;
/// // x³ at x = 2: 8, 3·4 and 6·2.
/// let x = hyper_dual(2.0, 1.0, 1.0, 0.0);
/// assert_eq!(x * x * x, hyper_dual(8.0, 12.0, 12.0, 12.0));
/// ```
pub const fn hyper_dual<R: Real>(real: R, first: R, second: R, mixed: R) -> HyperDual<R> {
    Dual { real: Dual { real, dual: second }, dual: Dual { real: first, dual: mixed } }
}

/// a, b, c and d.
pub const fn hyper_dual_parts<R: Real>(number: HyperDual<R>) -> [R; 4] {
    let Dual { real, dual } = number;
    [real.real, dual.real, real.dual, dual.dual]
}
