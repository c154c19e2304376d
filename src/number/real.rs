//! [`Real`]: what the scalar reference computes with; `f32` and `f64`, with trigonometry that has
//! the same bits everywhere.

#[cfg(any(feature = "std", feature = "libm"))]
use super::sine;
use crate::quick::Quick;
use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A number that the scalar reference computes with: `f32`, `f64`, or one of your own.
///
/// The functions of `f32` and `f64` are those of one version of the crate `libm`, but for sine,
/// cosine and tangent of `f32`, which it would compute in `f64`. The standard library has those of
/// the platform, whose bits differ between machines.
///
/// Accuracy is promised, and tested, for these two. [`Dual`](crate::Dual) numbers over any `Real`
/// are `Real` too, so whatever is written for every `R: Real`, the operations of this crate
/// included, can be differentiated; a number that counts its operations is another use. Kernels
/// over memory and lanes are for `f32` and `f64` alone ([`Scalar`]).
///
/// An implementation must order its numbers as `==` tells them apart, and all of `abs`, `is_finite`
/// and the comparisons must agree with that order, because edge cases are told by them.
pub trait Real:
    Copy
    + 'static
    + PartialOrd
    + Default
    + Debug
    + Display
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
    + From<f32>
    + Into<f64>
    + Send
    + Sync
{
    /// 0
    const ZERO: Self;
    /// 1
    const ONE: Self;
    /// 2
    const TWO: Self;
    /// ½
    const HALF: Self;
    /// π
    const PI: Self;
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;
    /// NaN, the answer of unchecked operations where the result does not exist.
    const NAN: Self;

    /// The nearest number of this type.
    fn from_f64(value: f64) -> Self;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// The value without its sign.
    #[must_use]
    fn abs(self) -> Self;
    /// The larger of the two; NaN if either is NaN, unlike `f32::max`.
    #[must_use]
    fn max_or_nan(self, other: Self) -> Self {
        if self > other || self.is_nan() { self } else { other }
    }
    /// Not a number.
    fn is_nan(self) -> bool {
        self.partial_cmp(&self).is_none()
    }
    /// √x
    #[must_use]
    fn sqrt(self) -> Self;
    /// sin x, radians
    #[must_use]
    fn sin(self) -> Self;
    /// cos x, radians
    #[must_use]
    fn cos(self) -> Self;
    /// tan x, radians
    #[must_use]
    fn tan(self) -> Self;
    /// arcsin x, radians
    #[must_use]
    fn asin(self) -> Self;
    /// arccos x, radians
    #[must_use]
    fn acos(self) -> Self;
    /// arctan x, radians
    #[must_use]
    fn atan(self) -> Self;
    /// The angle of the point (`x`, `self`), radians
    #[must_use]
    fn atan2(self, x: Self) -> Self;
    /// eˣ
    #[must_use]
    fn exp(self) -> Self;
    /// ln x
    #[must_use]
    fn ln(self) -> Self;

    /// The answer of the module `quick`, which operations ask before they compute the textbook
    /// form. Not part of the interface.
    #[doc(hidden)]
    #[inline(always)]
    fn quick<Q: Quick<Self>>(_operation: Q) -> Option<Q::Output> {
        None
    }
}

/// Each function with its home, which no common trait can name.
macro_rules! real {
    ($real:ident, $($name:ident = $home:ident :: $other:ident ( $($argument:ident),* );)*) => {
        impl Real for $real {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const HALF: Self = 0.5;
            const PI: Self = core::$real::consts::PI;
            const EPSILON: Self = $real::EPSILON;
            const NAN: Self = $real::NAN;

            #[inline]
            #[allow(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
            fn from_f64(value: f64) -> Self {
                value as $real
            }
            #[inline]
            fn is_finite(self) -> bool {
                $real::is_finite(self)
            }
            #[inline]
            fn abs(self) -> Self {
                $real::abs(self)
            }
            #[cfg(feature = "std")]
            #[inline]
            fn sqrt(self) -> Self {
                $real::sqrt(self)
            }
            // Not `libm`'s: it knows no instruction of microcontrollers, and this crate no `asm!`.
            #[cfg(not(feature = "std"))]
            #[inline]
            fn sqrt(self) -> Self {
                dq8_simd::internal::square_root::$real(self)
            }
            #[inline(always)]
            fn quick<Q: Quick<Self>>(operation: Q) -> Option<Q::Output> {
                operation.compute()
            }
            $(
                #[cfg(any(feature = "std", feature = "libm"))]
                #[inline]
                fn $name(self $(, $argument: Self)*) -> Self {
                    $home::$other(self $(, $argument)*)
                }
                // Never compiled to the end: `lib.rs` says what is missing, and this that nothing
                // else is.
                #[cfg(not(any(feature = "std", feature = "libm")))]
                fn $name(self $(, $argument: Self)*) -> Self {
                    $(let _ = $argument;)*
                    self
                }
            )*
        }
    };
}
real! {
    f32,
    sin = sine::sin(); cos = sine::cos(); tan = sine::tan(); asin = libm::asinf(); acos = libm::acosf();
    atan = libm::atanf(); atan2 = libm::atan2f(x); exp = libm::expf(); ln = libm::logf();
}
real! {
    f64,
    sin = libm::sin(); cos = libm::cos(); tan = libm::tan(); asin = libm::asin(); acos = libm::acos();
    atan = libm::atan(); atan2 = libm::atan2(x); exp = libm::exp(); ln = libm::log();
}

/// A number that lies in memory and in lanes: `f32` or `f64`. What everything over slices is made
/// of.
pub trait Scalar: Real + dq8_simd::Float {}
impl<R: Real + dq8_simd::Float> Scalar for R {}
