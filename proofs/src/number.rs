//! [`Recorded`]: a number whose operations are written on a tape. It is a `Real`, a `Float` and one
//! lane, so what dq8 has for single floats, for lanes and for slices records itself, unchanged.

use crate::lanes::Wide;
use crate::tape::{Node, Op, Order, compare, push, value};
use bytemuck::{Pod, Zeroable};
use core::any::Any;
use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use dq8::quick::Quick;
use dq8::skinning::Weight;
use dq8::{Real, Scalar};
use dq8_simd::sealed::Sealed;
use dq8_simd::{Float, Lanes, Level, Portable};

/// A node of the tape; `SINGLE` where it stands for `f32`, else for `f64`.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(transparent)]
pub struct Recorded<const SINGLE: bool>(pub Node);

macro_rules! operators { ($($name:ident $method:ident $assign:ident $method_assign:ident;)*) => {$(
    impl<const S: bool> $name for Recorded<S> {
        type Output = Self;
        fn $method(self, other: Self) -> Self {
            Self(push(Op::$name(self.0, other.0)))
        }
    }
    impl<const S: bool> $assign for Recorded<S> {
        fn $method_assign(&mut self, other: Self) {
            *self = $name::$method(*self, other);
        }
    }
)*} }
operators! {
    Add add AddAssign add_assign;
    Sub sub SubAssign sub_assign;
    Mul mul MulAssign mul_assign;
    Div div DivAssign div_assign;
}
impl<const S: bool> Neg for Recorded<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(push(Op::Neg(self.0)))
    }
}
impl<const S: bool> PartialEq for Recorded<S> {
    fn eq(&self, other: &Self) -> bool {
        compare(self.0, Order::Equal, other.0)
    }
}
impl<const S: bool> PartialOrd for Recorded<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let order = value(self.0).partial_cmp(&value(other.0))?;
        match order {
            Ordering::Less => compare(self.0, Order::Less, other.0),
            Ordering::Greater => compare(other.0, Order::Less, self.0),
            Ordering::Equal => compare(self.0, Order::Equal, other.0),
        };
        Some(order)
    }
}
impl<const S: bool> fmt::Display for Recorded<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}
impl<const S: bool> From<f32> for Recorded<S> {
    fn from(number: f32) -> Self {
        constant(number.into())
    }
}
impl<const S: bool> From<Recorded<S>> for f64 {
    fn from(number: Recorded<S>) -> Self {
        value(number.0)
    }
}
impl<const S: bool> Sealed for Recorded<S> {}

fn constant<const S: bool>(number: f64) -> Recorded<S> {
    Recorded(push(Op::Const(if S { f64::from(number as f32) } else { number })))
}

macro_rules! unrecorded { ($($name:ident($($argument:ident)?))*) => {$(
    fn $name(self $(, $argument: Self)?) -> Self {
        $(let _ = $argument;)?
        panic!("functions of libraries are not recorded")
    }
)*} }

impl<const S: bool> Real for Recorded<S> {
    const ZERO: Self = Self(0);
    const ONE: Self = Self(1);
    const TWO: Self = Self(2);
    const HALF: Self = Self(3);
    const PI: Self = Self(4);
    const EPSILON: Self = Self(if S { 5 } else { 6 });
    const NAN: Self = Self(7);
    fn from_f64(number: f64) -> Self {
        constant(number)
    }
    // Bounds are of numbers in range, which are finite.
    fn is_finite(self) -> bool {
        true
    }
    fn abs(self) -> Self {
        Self(push(Op::Abs(self.0)))
    }
    fn sqrt(self) -> Self {
        Self(push(Op::Sqrt(self.0)))
    }
    unrecorded! { sin() cos() tan() asin() acos() atan() atan2(x) exp() ln() }
    fn quick<Q: Quick<Self>>(operation: Q) -> Option<Q::Output> {
        operation.compute()
    }
}

impl<const S: bool> Float for Recorded<S> {
    const SINGLE: bool = S;
    type Lanes<V: Level> = Wide<V, S, 4>;
    type Packed<V: Level> = Wide<V, S, 8>;
    type Half<V: Level> = Wide<V, S, 4>;
    fn from_f64(number: f64) -> Self {
        constant(number)
    }
    fn from_i32(number: i32) -> Self {
        constant(f64::from(number))
    }
}

/// One number as a lane.
impl<const S: bool> Lanes for Recorded<S> {
    type Real = Self;
    type Mask = bool;
    type Level = Portable;
    type Native = Self;
    type Array = [Self; 1];
    const LANES: usize = 1;
    fn level(self) -> Portable {
        Portable
    }
    fn splat(_: Portable, number: Self) -> Self {
        number
    }
    fn load(_: Portable, from: &[Self; 1]) -> Self {
        from[0]
    }
    fn store(self, to: &mut [Self; 1]) {
        to[0] = self;
    }
    unsafe fn between_shorts(
        _: Portable,
        _: *const [u8; 8],
        _: impl Fn(usize) -> [usize; 2],
        _: Self,
    ) -> [Self; 4] {
        panic!("exact but for one rounding: nothing to record")
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self(push(Op::Fma(self.0, factor.0, addend.0)))
    }
    fn neg_mul_add(self, factor: Self, addend: Self) -> Self {
        Self(push(Op::Nfma(self.0, factor.0, addend.0)))
    }
    fn sqrt(self) -> Self {
        Real::sqrt(self)
    }
    fn abs(self) -> Self {
        Real::abs(self)
    }
    fn copysign(self, sign: Self) -> Self {
        let magnitude = Real::abs(self);
        if compare(sign.0, Order::Less, 0) { -magnitude } else { magnitude }
    }
    fn lt(self, other: Self) -> bool {
        compare(self.0, Order::Less, other.0)
    }
    fn le(self, other: Self) -> bool {
        compare(self.0, Order::LessOrEqual, other.0)
    }
    fn eq(self, other: Self) -> bool {
        compare(self.0, Order::Equal, other.0)
    }
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

/// Weights of skins: recorded as they lie in memory.
impl<const S: bool> Weight for Recorded<S> {
    fn value<R: Real>(self) -> R {
        // Itself; where it is checked, its value.
        (&self as &dyn Any).downcast_ref().copied().unwrap_or_else(|| R::from_f64(value(self.0)))
    }
    fn as_numbers<R: Scalar>(weights: &[Self]) -> Option<&[R]> {
        bytemuck::try_cast_slice(weights).ok()
    }
}
