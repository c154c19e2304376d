//! [`Pair`]: two vectors that act as one vector of twice the width. A level uses it for vectors
//! that are wider than its registers.

use crate::lanes::Float;
use crate::lanes::{Lanes, Mask};
use crate::shorts::Shorts;
use bytemuck::Pod;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A vector of twice the lanes of `L`: its lower half and its upper half.
#[derive(Clone, Copy, Debug)]
pub struct Pair<L>(pub(crate) L, pub(crate) L);

/// The array `[R; N]` of half a [`Pair`]. The trait names the array of the whole pair, `[R; 2N]`,
/// which generic code cannot express. The trait is sealed.
pub trait Doubled: Pod + crate::sealed::Sealed {
    /// The array `[R; 2N]`.
    type Twice: Pod + core::fmt::Debug + AsRef<[Self::Real]> + AsMut<[Self::Real]>;
    /// The element type R.
    type Real: Float;
}

impl crate::sealed::Sealed for [f32; 8] {}
impl Doubled for [f32; 8] {
    type Twice = [f32; 16];
    type Real = f32;
}

impl crate::sealed::Sealed for [f64; 4] {}
impl Doubled for [f64; 4] {
    type Twice = [f64; 8];
    type Real = f64;
}

impl<L: Lanes> crate::sealed::Sealed for Pair<L> {}
impl<L> Lanes for Pair<L>
where
    L: Lanes<Array: Doubled<Real = L::Real>>,
{
    type Real = L::Real;
    type Mask = Pair<L::Mask>;
    type Level = L::Level;
    type Native = L;
    type Array = <L::Array as Doubled>::Twice;
    const LANES: usize = 2 * L::LANES;

    #[inline(always)]
    fn level(self) -> L::Level {
        self.0.level()
    }
    #[inline(always)]
    fn splat(level: L::Level, value: L::Real) -> Self {
        Self(L::splat(level, value), L::splat(level, value))
    }
    #[inline(always)]
    fn load(level: L::Level, from: &Self::Array) -> Self {
        let [lower, upper]: &[L::Array; 2] = bytemuck::cast_ref(from);
        Self(L::load(level, lower), L::load(level, upper))
    }
    #[inline(always)]
    fn store(self, to: &mut Self::Array) {
        let [lower, upper]: &mut [L::Array; 2] = bytemuck::cast_mut(to);
        self.0.store(lower);
        self.1.store(upper);
    }
    #[inline(always)]
    unsafe fn load_quads(
        level: L::Level,
        from: *const L::Real,
        offset: impl Fn(usize) -> usize,
    ) -> [Self; 4] {
        // SAFETY: the lower half reads four components at `from + offset(i)` for the lanes `i`
        // below `L::LANES`, and the upper half for the lanes from `L::LANES` on. The caller
        // guarantees that these components are readable for all lanes of the pair.
        let [a, b] = unsafe {
            [
                L::load_quads(level, from, &offset),
                L::load_quads(
                    level,
                    from,
                    #[inline(always)]
                    |lane| offset(L::LANES + lane),
                ),
            ]
        };
        let ([ax, ay, az, aw], [bx, by, bz, bw]) = (a, b);
        [Self(ax, bx), Self(ay, by), Self(az, bz), Self(aw, bw)]
    }
    #[inline(always)]
    unsafe fn between_shorts(
        level: L::Level,
        from: *const Shorts,
        records: impl Fn(usize) -> [usize; 2],
        t: Self,
    ) -> [Self; 4] {
        // SAFETY: the lower half reads the two records `records(i)` for the lanes `i` below
        // `L::LANES`, and the upper half for the lanes from `L::LANES` on. The caller guarantees
        // that these records are readable for all lanes of the pair.
        let [a, b] = unsafe {
            [
                L::between_shorts(level, from, &records, t.0),
                L::between_shorts(
                    level,
                    from,
                    #[inline(always)]
                    |lane| records(L::LANES + lane),
                    t.1,
                ),
            ]
        };
        let ([ax, ay, az, aw], [bx, by, bz, bw]) = (a, b);
        [Self(ax, bx), Self(ay, by), Self(az, bz), Self(aw, bw)]
    }
    #[inline(always)]
    unsafe fn store_quads([x, y, z, w]: [Self; 4], to: *mut L::Real, stride: usize) {
        // SAFETY: the lower half writes four components at `to + i · stride` for the lanes `i`
        // below `L::LANES`, and the upper half for the lanes from `L::LANES` on. The caller
        // guarantees that these components are writable and unused by other threads for all lanes
        // of the pair.
        unsafe {
            L::store_quads([x.0, y.0, z.0, w.0], to, stride);
            L::store_quads([x.1, y.1, z.1, w.1], to.add(L::LANES * stride), stride);
        }
    }
    #[inline(always)]
    unsafe fn store_triples([x, y, z]: [Self; 3], to: *mut L::Real) {
        // SAFETY: the lower half writes three components at `to + 3i` for the lanes `i` below
        // `L::LANES`, and the upper half for the lanes from `L::LANES` on. The caller guarantees
        // that these components are writable and unused by other threads for all lanes of the pair.
        unsafe {
            L::store_triples([x.0, y.0, z.0], to);
            L::store_triples([x.1, y.1, z.1], to.add(3 * L::LANES));
        }
    }
    #[inline(always)]
    fn sum_quads([a, b, c, d]: [Self; 4]) -> Self {
        Self(L::sum_quads([a.0, b.0, c.0, d.0]), L::sum_quads([a.1, b.1, c.1, d.1]))
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self(self.0.mul_add(factor.0, addend.0), self.1.mul_add(factor.1, addend.1))
    }
    #[inline(always)]
    fn neg_mul_add(self, factor: Self, addend: Self) -> Self {
        Self(self.0.neg_mul_add(factor.0, addend.0), self.1.neg_mul_add(factor.1, addend.1))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt(), self.1.sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs(), self.1.abs())
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        Self(self.0.copysign(sign.0), self.1.copysign(sign.1))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        Pair(self.0.lt(other.0), self.1.lt(other.1))
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        Pair(self.0.le(other.0), self.1.le(other.1))
    }
    #[inline(always)]
    fn eq(self, other: Self) -> Self::Mask {
        Pair(self.0.eq(other.0), self.1.eq(other.1))
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self(L::select(mask.0, yes.0, no.0), L::select(mask.1, yes.1, no.1))
    }
}

/// Implements operators of two operands, which act on both halves.
macro_rules! operator {
    ($($trait:ident $method:ident;)*) => {$(
        impl<L: $trait<Output = L>> $trait for Pair<L> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0), self.1.$method(other.1))
            }
        }
    )*};
}
operator! { Add add; Sub sub; Mul mul; Div div; BitAnd bitand; BitOr bitor; }

impl<L: Neg<Output = L>> Neg for Pair<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl<M: Not<Output = M>> Not for Pair<M> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0, !self.1)
    }
}

impl<M: Mask> Mask for Pair<M> {
    const LANES: u32 = 2 * M::LANES;
    #[inline(always)]
    fn any(self) -> bool {
        self.0.any() || self.1.any()
    }
    #[inline(always)]
    fn all(self) -> bool {
        self.0.all() && self.1.all()
    }
    #[inline(always)]
    fn to_bitmask(self) -> u32 {
        self.0.to_bitmask() | (self.1.to_bitmask() << M::LANES)
    }
}
