//! [`Real`]: what the scalar reference computes with; `f32` and `f64`, with square root and
//! trigonometry from `std` or `libm`.

use crate::everyday;
use crate::geometry::DualVector;
#[cfg(all(not(feature = "std"), feature = "libm"))]
use crate::sine;
use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use dq8_simd::{Lanes, Portable};

/// A number that the scalar reference computes with: `f32`, `f64`, or one of your own.
///
/// The functions of `f32` and `f64` are those of the standard library. Without the feature `std` they
/// come from the crate `libm`, but for those that it computes in `f64` for `f32`.
///
/// Accuracy is promised, and tested, for these two. [`Dual`](crate::Dual) numbers over any `Real` are
/// `Real` too, so whatever is written for every `R: Real`, the operations of this crate included, can
/// be differentiated; a number that counts its operations is another use. Kernels over memory and
/// lanes are for `f32` and `f64` alone ([`Scalar`]).
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
    /// Not a number: what unchecked operations return where the result does not exist.
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

    // What the operations of dual quaternions ask for before they compute by the book: the module
    // `everyday`. Not part of the interface.
    #[doc(hidden)]
    #[inline(always)]
    fn quick_product(_a: [Self; 8], _b: [Self; 8]) -> Option<[Self; 8]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_point(_motion: [Self; 8], _point: [Self; 3]) -> Option<[Self; 3]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_matrix3x4(_motion: [Self; 8]) -> Option<[[Self; 4]; 3]> {
        None
    }
    /// All NaN: it has none.
    #[doc(hidden)]
    #[inline(always)]
    fn quick_unit(_motion: [Self; 8]) -> Option<[Self; 8]> {
        None
    }
    /// All NaN: it has none.
    #[doc(hidden)]
    #[inline(always)]
    fn quick_inverse(_motion: [Self; 8]) -> Option<[Self; 8]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_rotate(_rotation: [Self; 4], _vector: [Self; 3]) -> Option<[Self; 3]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_quaternion_product(_a: [Self; 4], _b: [Self; 4]) -> Option<[Self; 4]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_quaternion_unit(_quaternion: [Self; 4]) -> Option<[Self; 4]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_translation(_motion: [Self; 8]) -> Option<[Self; 3]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_lerp(_a: [Self; 8], _b: [Self; 8], _t: Self) -> Option<[Self; 8]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_slerp(_a: [Self; 4], _b: [Self; 4], _t: Self) -> Option<[Self; 4]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_sclerp(_a: [Self; 8], _b: [Self; 8], _t: Self) -> Option<[Self; 8]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_log(_motion: [Self; 8]) -> Option<DualVector<Self>> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_exp(_log: DualVector<Self>) -> Option<[Self; 8]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_pow(_motion: [Self; 8], _t: Self) -> Option<[Self; 8]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn quick_sqrt(_motion: [Self; 8]) -> Option<[Self; 8]> {
        None
    }
    #[doc(hidden)]
    #[inline(always)]
    fn in_one_lane<K: OneLane<Self>>(_kernel: K) -> Option<K::Output> {
        None
    }
}

/// What numbers that are lanes compute in another way than by the book. Not part of the interface.
#[doc(hidden)]
pub trait OneLane<R> {
    type Output;
    fn compute(self) -> Self::Output
    where
        R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>;
}

/// The standard library's functions are inherent and `libm`'s are free, so neither can be reached
/// through a common trait: this lists each name with its two homes.
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
                dq8_simd::square_root::$real(self)
            }
            #[inline(always)]
            fn quick_product(a: [Self; 8], b: [Self; 8]) -> Option<[Self; 8]> {
                everyday::product(a, b)
            }
            #[inline(always)]
            fn quick_point(motion: [Self; 8], point: [Self; 3]) -> Option<[Self; 3]> {
                everyday::point(motion, point)
            }
            #[inline(always)]
            fn quick_matrix3x4(motion: [Self; 8]) -> Option<[[Self; 4]; 3]> {
                everyday::matrix3x4(motion)
            }
            #[inline(always)]
            fn quick_unit(motion: [Self; 8]) -> Option<[Self; 8]> {
                everyday::unit(motion)
            }
            #[inline(always)]
            fn quick_inverse(motion: [Self; 8]) -> Option<[Self; 8]> {
                everyday::inverse(motion)
            }
            #[inline(always)]
            fn quick_rotate(rotation: [Self; 4], vector: [Self; 3]) -> Option<[Self; 3]> {
                everyday::rotate(rotation, vector)
            }
            #[inline(always)]
            fn quick_quaternion_product(a: [Self; 4], b: [Self; 4]) -> Option<[Self; 4]> {
                everyday::quaternion_product(a, b)
            }
            #[inline(always)]
            fn quick_quaternion_unit(quaternion: [Self; 4]) -> Option<[Self; 4]> {
                everyday::quaternion_unit(quaternion)
            }
            #[inline(always)]
            fn quick_translation(motion: [Self; 8]) -> Option<[Self; 3]> {
                everyday::translation(motion)
            }
            #[inline(always)]
            fn quick_lerp(a: [Self; 8], b: [Self; 8], t: Self) -> Option<[Self; 8]> {
                everyday::lerp(a, b, t)
            }
            #[inline(always)]
            fn quick_slerp(a: [Self; 4], b: [Self; 4], t: Self) -> Option<[Self; 4]> {
                everyday::slerp(a, b, t)
            }
            #[inline(always)]
            fn quick_sclerp(a: [Self; 8], b: [Self; 8], t: Self) -> Option<[Self; 8]> {
                everyday::sclerp(a, b, t)
            }
            #[inline(always)]
            fn quick_log(motion: [Self; 8]) -> Option<DualVector<Self>> {
                everyday::log(motion)
            }
            #[inline(always)]
            fn quick_exp(log: DualVector<Self>) -> Option<[Self; 8]> {
                everyday::exp(log)
            }
            #[inline(always)]
            fn quick_pow(motion: [Self; 8], t: Self) -> Option<[Self; 8]> {
                everyday::pow(motion, t)
            }
            #[inline(always)]
            fn quick_sqrt(motion: [Self; 8]) -> Option<[Self; 8]> {
                everyday::sqrt(motion)
            }
            #[inline(always)]
            fn in_one_lane<K: OneLane<Self>>(kernel: K) -> Option<K::Output> {
                Some(kernel.compute())
            }
            $(
                #[cfg(feature = "std")]
                #[inline]
                fn $name(self $(, $argument: Self)*) -> Self {
                    $real::$name(self $(, $argument)*)
                }
                #[cfg(all(not(feature = "std"), feature = "libm"))]
                #[inline]
                fn $name(self $(, $argument: Self)*) -> Self {
                    $home::$other(self $(, $argument)*)
                }
                // Never compiled to the end: `lib.rs` says what is missing, and this that nothing else is.
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

/// A number that lies in memory and in lanes: `f32` or `f64`. What everything over slices is made of.
pub trait Scalar: Real + dq8_simd::Float {}
impl<R: Real + dq8_simd::Float> Scalar for R {}
