//! [`Wide`]: lanes of recorded numbers, of any level, for kernels over slices.

use crate::number::Recorded;
use bytemuck::Pod;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};
use dq8_simd::sealed::Sealed;
use dq8_simd::{Lanes, Level, Mask, PackedDualQuat};

/// `N` recorded numbers.
#[derive(Clone, Copy, Debug)]
pub struct Wide<V, const S: bool, const N: usize>(pub(crate) V, pub(crate) [Recorded<S>; N]);

impl<V: Level, const S: bool, const N: usize> Wide<V, S, N> {
    pub(crate) fn zip(
        self,
        other: Self,
        f: impl Fn(Recorded<S>, Recorded<S>) -> Recorded<S>,
    ) -> Self {
        Self(self.0, core::array::from_fn(|i| f(self.1[i], other.1[i])))
    }
    fn compare(self, other: Self, f: impl Fn(Recorded<S>, Recorded<S>) -> bool) -> Bools<N> {
        Bools(core::array::from_fn(|i| f(self.1[i], other.1[i])))
    }
}

macro_rules! operators { ($($name:ident $method:ident;)*) => {$(
    impl<V: Level, const S: bool, const N: usize> $name for Wide<V, S, N> {
        type Output = Self;
        fn $method(self, other: Self) -> Self {
            self.zip(other, $name::$method)
        }
    }
)*} }
operators! { Add add; Sub sub; Mul mul; Div div; }
impl<V: Level, const S: bool, const N: usize> Neg for Wide<V, S, N> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0, self.1.map(Neg::neg))
    }
}
impl<V, const S: bool, const N: usize> Sealed for Wide<V, S, N> {}

/// `N` truth values.
#[derive(Clone, Copy, Debug)]
pub struct Bools<const N: usize>([bool; N]);
impl<const N: usize> BitAnd for Bools<N> {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        Self(core::array::from_fn(|i| self.0[i] & other.0[i]))
    }
}
impl<const N: usize> BitOr for Bools<N> {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self(core::array::from_fn(|i| self.0[i] | other.0[i]))
    }
}
impl<const N: usize> Not for Bools<N> {
    type Output = Self;
    fn not(self) -> Self {
        Self(self.0.map(Not::not))
    }
}
impl<const N: usize> Mask for Bools<N> {
    const LANES: u32 = N as u32;
    fn any(self) -> bool {
        self.0.contains(&true)
    }
    fn all(self) -> bool {
        !self.0.contains(&false)
    }
    fn to_bitmask(self) -> u32 {
        self.0.iter().enumerate().map(|(i, &bit)| u32::from(bit) << i).sum()
    }
}

impl<V: Level, const S: bool, const N: usize> Lanes for Wide<V, S, N>
where
    // As bytemuck knows of some lengths.
    [Recorded<S>; N]: Pod,
{
    type Real = Recorded<S>;
    type Mask = Bools<N>;
    type Level = V;
    type Native = Self;
    type Array = [Recorded<S>; N];
    const LANES: usize = N;
    fn level(self) -> V {
        self.0
    }
    fn splat(level: V, number: Recorded<S>) -> Self {
        Self(level, [number; N])
    }
    fn load(level: V, from: &[Recorded<S>; N]) -> Self {
        Self(level, *from)
    }
    fn store(self, to: &mut [Recorded<S>; N]) {
        *to = self.1;
    }
    unsafe fn between_shorts(
        _: V,
        _: *const [u8; 8],
        _: impl Fn(usize) -> [usize; 2],
        _: Self,
    ) -> [Self; 4] {
        panic!("exact but for one rounding: nothing to record")
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self(self.0, core::array::from_fn(|i| self.1[i].mul_add(factor.1[i], addend.1[i])))
    }
    fn neg_mul_add(self, factor: Self, addend: Self) -> Self {
        Self(self.0, core::array::from_fn(|i| self.1[i].neg_mul_add(factor.1[i], addend.1[i])))
    }
    fn sqrt(self) -> Self {
        Self(self.0, self.1.map(Lanes::sqrt))
    }
    fn abs(self) -> Self {
        Self(self.0, self.1.map(Lanes::abs))
    }
    fn copysign(self, sign: Self) -> Self {
        self.zip(sign, Lanes::copysign)
    }
    fn lt(self, other: Self) -> Bools<N> {
        self.compare(other, Lanes::lt)
    }
    fn le(self, other: Self) -> Bools<N> {
        self.compare(other, Lanes::le)
    }
    fn eq(self, other: Self) -> Bools<N> {
        self.compare(other, Lanes::eq)
    }
    fn select(mask: Bools<N>, yes: Self, no: Self) -> Self {
        Self(yes.0, core::array::from_fn(|i| if mask.0[i] { yes.1[i] } else { no.1[i] }))
    }
}
impl<V: Level, const S: bool> PackedDualQuat for Wide<V, S, 8> {}
