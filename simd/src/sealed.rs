//! [`Sealed`]: the supertrait that keeps other crates from implementing `Lanes`, `Level` and
//! `Float`.

/// A trait that other crates cannot name, and so cannot implement.
///
/// If another crate could implement `Lanes`, its safe code could write out of bounds. The type
/// `Two` below says that it has two lanes, but its array has four elements, so the last line would
/// write four records to a slice of two:
///
/// ```compile_fail
/// use core::ops::{Add, Div, Mul, Neg, Sub};
/// use dq8_simd::{Lanes, Portable, Records};
/// #[derive(Clone, Copy, Debug)]
/// struct Two(f32);
/// macro_rules! operators { ($($name:ident $method:ident)*) => {$(
///     impl $name for Two { type Output = Self; fn $method(self, _: Self) -> Self { self } }
/// )*} }
/// operators! { Add add Sub sub Mul mul Div div }
/// impl Neg for Two { type Output = Self; fn neg(self) -> Self { self } }
/// impl Lanes for Two {
///     type Real = f32;
///     type Mask = bool;
///     type Level = Portable;
///     type Native = Self;
///     type Array = [f32; 4];
///     const LANES: usize = 2;
///     fn level(self) -> Portable { Portable }
///     fn splat(_: Portable, value: f32) -> Self { Self(value) }
///     fn load(_: Portable, from: &[f32; 4]) -> Self { Self(from[0]) }
///     fn store(self, to: &mut [f32; 4]) { *to = [self.0; 4] }
///     unsafe fn between_shorts(
///         _: Portable, _: *const [u8; 8], _: impl Fn(usize) -> [usize; 2], t: Self,
///     ) -> [Self; 4] { [t; 4] }
///     fn mul_add(self, _: Self, _: Self) -> Self { self }
///     fn neg_mul_add(self, _: Self, _: Self) -> Self { self }
///     fn sqrt(self) -> Self { self }
///     fn abs(self) -> Self { self }
///     fn copysign(self, _: Self) -> Self { self }
///     fn lt(self, _: Self) -> bool { true }
///     fn le(self, _: Self) -> bool { true }
///     fn eq(self, _: Self) -> bool { true }
///     fn select(_: bool, yes: Self, _: Self) -> Self { yes }
/// }
/// Two::store_records([Two(7.0); 4], &mut [[0.0; 4]; 2]);
/// ```
pub trait Sealed {}
impl Sealed for f32 {}
impl Sealed for f64 {}
