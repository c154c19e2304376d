use crate::contract::{power, sums_by_part};
use core::ops::{Div, Mul};
use dq8_simd::Lanes;

/// Dual numbers a + εb, one per lane: [`Dual`](crate::Dual) on lanes.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Dual<L> {
    /// The real part a.
    pub real: L,
    /// The dual part b.
    pub dual: L,
}

impl<L: Lanes> Dual<L> {
    /// Makes a + εb.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn new(real: L, dual: L) -> Self {
        Self { real, dual }
    }

    /// Returns f(a + εb) = f(a) + ε b f′(a), given f(a) and f′(a) (Jia eq. 10).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn apply(self, value: L, derivative: L) -> Self {
        Self::new(value, self.dual * derivative)
    }

    /// Returns s(a + εb) for the real number s = `factor`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn scale(self, factor: L) -> Self {
        Self::new(self.real * factor, self.dual * factor)
    }

    /// Returns √(a + εb) = √a + ε b/(2√a).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn sqrt(self) -> Self {
        let root = self.real.sqrt();
        self.apply(root, root.constant(0.5) / root)
    }

    /// Returns 1/(a + εb) = a⁻¹ − ε b a⁻² (Jia eq. 7).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn recip(self) -> Self {
        let recip = self.real.constant(1.0) / self.real;
        // The dual part is multiplied by 1/a twice, because 1/a² may overflow or vanish although
        // b/a² does not.
        Self::new(recip, -(self.dual * recip) * recip)
    }

    /// Returns [`recip`](Self::recip), and the mask of the lanes without an inverse, in which a is
    /// zero or not finite. In these lanes the result is NaN.
    ///
    /// ```
    /// use dq8::{batch::Dual, simd::{Mask, f32x4}};
    /// let x = Dual::new(f32x4::new([4.0, 0.0, f32::INFINITY, -2.0]), f32x4::splat(2.0));
    /// let (inverse, failed) = x.inverse_checked();
    /// assert_eq!(failed.to_bitmask(), 0b0110);
    /// assert_eq!((inverse * x).real.to_array()[3], 1.0);
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn inverse_checked(self) -> (Self, L::Mask) {
        let (zero, nan) = (self.real.constant(0.0), self.real.constant(f64::NAN));
        let failed = self.real.eq(zero) | !super::vector::is_finite(self.real);
        let recip = self.recip();
        let (real, dual) = (L::select(failed, nan, recip.real), L::select(failed, nan, recip.dual));
        (Self::new(real, dual), failed)
    }

    /// Returns aⁿ + ε b n aⁿ⁻¹ for an integer n, the same in every lane, by repeated
    /// squaring.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn powi(self, n: i32) -> Self {
        let one = Self::new(self.real.constant(1.0), self.real.constant(0.0));
        power(self, one, n)
    }
}

sums_by_part! {
    [L: Lanes] #[cfg_attr(not(opt_level_0), inline(always))] Dual<L>: (real) (dual)
}

/// The product ac + ε(ad + bc) of a + εb and c + εd.
impl<L: Lanes> Mul for Dual<L> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn mul(self, other: Self) -> Self {
        Self::new(self.real * other.real, self.real.mul_add(other.dual, self.dual * other.real))
    }
}

/// The quotient a/c + ε(bc − ad)/c² of a + εb and c + εd.
impl<L: Lanes> Div for Dual<L> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn div(self, other: Self) -> Self {
        let quotient = self.real / other.real;
        Self::new(quotient, quotient.neg_mul_add(other.dual, self.dual) / other.real)
    }
}
