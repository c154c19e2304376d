//! [`Real`], the element types of the scalar reference, and its implementations for `f32` and
//! `f64`. The results of their trigonometric functions have the same bits on every machine.

#[cfg(any(feature = "std", feature = "libm"))]
use super::sine;
use crate::quick::Quick;
use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// An element type of the scalar reference: `f32`, `f64`, or a type of your own.
///
/// The functions of `f32` and `f64` are those of one version of the crate `libm`, except for sine,
/// cosine and tangent of `f32`, which `libm` would compute in `f64`. The standard library would
/// call the functions of the platform, whose results differ between machines.
///
/// Accuracy is promised and tested for `f32` and `f64`. [`Dual`](crate::Dual) numbers over any
/// `Real` are `Real` too, so all code for any `R: Real`, such as the operations of this crate, can
/// be differentiated. Another use is a type of your own that counts operations. Kernels over memory
/// and lanes take `f32` and `f64` alone ([`Scalar`]).
///
/// In every implementation `==`, the comparisons, `abs` and `is_finite` must be consistent, because
/// operations detect edge cases with them.
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
    /// The value 0.
    const ZERO: Self;
    /// The value 1.
    const ONE: Self;
    /// The value 2.
    const TWO: Self;
    /// The value ½.
    const HALF: Self;
    /// The value π.
    const PI: Self;
    /// The difference between 1 and the next larger value of this type.
    const EPSILON: Self;
    /// NaN, which unchecked operations return if there is no result.
    const NAN: Self;

    /// Returns the number of this type that is nearest to `value`.
    fn from_f64(value: f64) -> Self;
    /// Returns `true` if the value is neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// Returns the absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// Returns the larger value, or NaN if either is NaN, unlike `f32::max`.
    #[must_use]
    fn max_or_nan(self, other: Self) -> Self {
        if self > other || self.is_nan() { self } else { other }
    }
    /// Returns `true` if the value is NaN.
    fn is_nan(self) -> bool {
        self.partial_cmp(&self).is_none()
    }
    /// Returns √x.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Returns sin x, with x in radians.
    #[must_use]
    fn sin(self) -> Self;
    /// Returns cos x, with x in radians.
    #[must_use]
    fn cos(self) -> Self;
    /// Returns tan x, with x in radians.
    #[must_use]
    fn tan(self) -> Self;
    /// Returns arcsin x, in radians.
    #[must_use]
    fn asin(self) -> Self;
    /// Returns arccos x, in radians.
    #[must_use]
    fn acos(self) -> Self;
    /// Returns arctan x, in radians.
    #[must_use]
    fn atan(self) -> Self;
    /// Returns the angle of the point (`x`, `self`), in radians.
    #[must_use]
    fn atan2(self, x: Self) -> Self;
    /// Returns eˣ.
    #[must_use]
    fn exp(self) -> Self;
    /// Returns ln x.
    #[must_use]
    fn ln(self) -> Self;

    /// Returns the result of a quicker form of an operation from the module `quick`, or `None` if
    /// the textbook form must be computed. This method is not part of the public interface.
    #[doc(hidden)]
    #[inline(always)]
    fn quick<Q: Quick<Self>>(_operation: Q) -> Option<Q::Output> {
        None
    }
}

/// Implements each function of [`Real`] by a function of a library. A macro is needed because `f32`
/// and `f64` share no trait with these functions.
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
            // The square root of `libm` is not used, because on microcontrollers it does not use
            // the square root instruction. `dq8-simd` does, by `asm!`, which this crate forbids.
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
                // This body is for builds without `std` and `libm`, which `lib.rs` rejects with a
                // message. Without this body the compiler would report other errors beside that
                // message.
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

/// `f32` or `f64`, the element types of slices and lanes. All operations over slices take them.
pub trait Scalar: Real + dq8_simd::Float {}
impl<R: Real + dq8_simd::Float> Scalar for R {}
