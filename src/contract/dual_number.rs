//! [`DualNumber`], the contract that the dual numbers of the scalar reference and of the lanes
//! share.

use crate::contract::shared_trait;
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

shared_trait! {
    /// Dual numbers a + εb with ε² = 0: a single dual number ([`Dual`](crate::Dual)), or many,
    /// one per lane ([`batch::Dual`](crate::batch::Dual)).
    ///
    /// # Laws
    ///
    /// The laws hold up to rounding for finite values; `tests/algebra/dual_number.rs` has the
    /// bounds:
    ///
    /// | law | for |
    /// |---|---|
    /// | x + y = y + x, xy = yx, (xy)z = x(yz), x(y + z) = xy + xz | all |
    /// | ε² = 0, f(x) = f(a) + εb f′(a) | all |
    /// | x · 1/x = 1, x/y = x · 1/y | a ≠ 0 |
    /// | (√x)² = x, exp(ln x) = x, xᵐxⁿ = xᵐ⁺ⁿ | a > 0 |
    /// | sin² + cos² = 1, tan = sin/cos, exp(x + y) = exp x exp y | all |
    /// | sin(arcsin x) = x, cos(arccos x) = x, tan(arctan x) = x | in their domains |
    /// | atan2(r sin x, r cos x) = x | r > 0, \|a\| < π |
    ///
    /// The documentation of [`Dual`](crate::Dual) has the formula and the source of each operation.
    /// No type outside this crate can implement the trait.
    trait DualNumber: Copy, Debug, Add<Output = Self>, Sub<Output = Self>, Mul<Output = Self>, Div<Output = Self>,
        Neg<Output = Self>;

    delegate by delegate_dual_number;

    types {
        /// A real number, or a vector with a real number per lane.
        type Real: Copy + Debug;
    }

    by_hand {
        /// Returns the real part a and the dual part b.
        fn parts(self) -> [Self::Real; 2];
    }

    inherent {
        /// Makes a + εb.
        fn new(real: Self::Real, dual: Self::Real) -> Self;
        /// Returns f(a) + εb f′(a), given f(a) and f′(a).
        fn apply(self, value: Self::Real, derivative: Self::Real) -> Self;
        /// Returns s(a + εb) for the real number s = `factor`.
        fn scale(self, factor: Self::Real) -> Self;
        /// Returns 1/(a + εb), which is infinite or NaN for a = 0.
        fn recip(self) -> Self;
        /// Returns (a + εb)ⁿ.
        fn powi(self, n: i32) -> Self;
        /// Returns √a + εb/(2√a).
        fn sqrt(self) -> Self;
        /// Returns sin a + εb cos a. On lanes, sine, cosine and tangent are NaN beyond 2¹⁶ rad
        /// (`f32`) or 2⁴⁵ rad (`f64`).
        fn sin(self) -> Self;
        /// Returns cos a − εb sin a.
        fn cos(self) -> Self;
        /// Returns tan a + εb/cos²a.
        fn tan(self) -> Self;
        /// Returns arcsin a + εb/√(1 − a²).
        fn asin(self) -> Self;
        /// Returns arccos a − εb/√(1 − a²).
        fn acos(self) -> Self;
        /// Returns arctan a + εb/(1 + a²).
        fn atan(self) -> Self;
        /// Returns the angle of the point (`x`, `self`) in radians.
        fn atan2(self, x: Self) -> Self;
        /// Returns eᵃ + εb eᵃ.
        fn exp(self) -> Self;
        /// Returns ln a + εb/a.
        fn ln(self) -> Self;
    }
}

/// Returns xⁿ for an integer n, by repeated squaring.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn power<D: DualNumber>(x: D, one: D, n: i32) -> D {
    let (mut power, mut square, mut left) = (one, x, n.unsigned_abs());
    while left > 0 {
        if left % 2 == 1 {
            power = power * square;
        }
        left /= 2;
        // The square is not needed after the last step, where it might overflow.
        if left > 0 {
            square = square * square;
        }
    }
    if n < 0 { power.recip() } else { power }
}
