//! [`Unfused`]: a wrapper of a level and of its lanes, whose `mul_add` rounds twice.
//!
//! IEEE 754 fixes every bit of +, −, ×, ÷ and √, and the compiler never fuses a product and a
//! sum on its own. So a kernel on lanes that do not fuse has the same results, bit by bit, with
//! every instruction set and every lane count. Only the bits of NaN may differ, because IEEE 754
//! leaves them open.

use crate::lanes::{Lanes, Level, PackedDualQuat};
use crate::shorts::Shorts;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The level `T` with lanes that do not fuse the multiply-add, or the vector `T` of such a level.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Unfused<T>(pub T);

impl<V: Level> Level for Unfused<V> {
    type F32x4 = Unfused<V::F32x4>;
    type F32x8 = Unfused<V::F32x8>;
    type F32x16 = Unfused<V::F32x16>;
    type F64x2 = Unfused<V::F64x2>;
    type F64x4 = Unfused<V::F64x4>;
    type F64x8 = Unfused<V::F64x8>;
    type Single = Unfused<V::Single>;
    type Double = Unfused<V::Double>;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn fence(self) {
        self.0.fence();
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn prefetch<T>(self, value: &T) {
        self.0.prefetch(value);
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn prefetch_every<T>(self, memory: &[T], stride: usize, count: usize) {
        self.0.prefetch_every(memory, stride, count);
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn locate<T>(self, value: &T) -> &T {
        self.0.locate(value)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<R>(self, kernel: impl FnOnce() -> R) -> R {
        self.0.run(kernel)
    }
}

impl<L> crate::sealed::Sealed for Unfused<L> {}
impl<L: Lanes> Lanes for Unfused<L> {
    type Real = L::Real;
    type Mask = L::Mask;
    type Level = Unfused<L::Level>;
    type Native = Unfused<L::Native>;
    type Array = L::Array;
    const LANES: usize = L::LANES;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn level(self) -> Self::Level {
        Unfused(self.0.level())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn splat(level: Self::Level, value: L::Real) -> Self {
        Self(L::splat(level.0, value))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load(level: Self::Level, from: &L::Array) -> Self {
        Self(L::load(level.0, from))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store(self, to: &mut L::Array) {
        self.0.store(to);
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    unsafe fn stream(self, to: &mut L::Array) {
        // SAFETY: the caller calls `Level::fence` of this level before other code uses `to`, and
        // that method calls the fence of the level of `L`.
        unsafe { self.0.stream(to) }
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    unsafe fn load_quads(
        level: Self::Level,
        from: *const L::Real,
        offset: impl Fn(usize) -> usize,
    ) -> [Self; 4] {
        // SAFETY: `L` has the same lanes, and the caller guarantees that the four components from
        // `from + offset(i)` on are readable for each lane `i`.
        let [x, y, z, w] = unsafe { L::load_quads(level.0, from, offset) };
        [Self(x), Self(y), Self(z), Self(w)]
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    unsafe fn store_quads([x, y, z, w]: [Self; 4], to: *mut L::Real, stride: usize) {
        // SAFETY: `L` has the same lanes, and the caller guarantees that the four components from
        // `to + i · stride` on are writable for each lane `i`.
        unsafe { L::store_quads([x.0, y.0, z.0, w.0], to, stride) }
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    unsafe fn store_triples([x, y, z]: [Self; 3], to: *mut L::Real) {
        // SAFETY: `L` has the same lanes, and the caller guarantees that three components per lane
        // from `to` on are writable.
        unsafe { L::store_triples([x.0, y.0, z.0], to) }
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    unsafe fn load_adjoining<const C: usize>(
        level: Self::Level,
        from: *const L::Real,
    ) -> Option<[Self; C]> {
        // SAFETY: `L` has the same lanes, and the caller guarantees that `C` components per lane
        // from `from` on are readable.
        let components = unsafe { L::load_adjoining::<C>(level.0, from) };
        components.map(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |components| components.map(Self),
        )
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    unsafe fn store_adjoining<const C: usize>(components: [Self; C], to: *mut L::Real) -> bool {
        let components = components.map(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |component| component.0,
        );
        // SAFETY: `L` has the same lanes, and the caller guarantees that `C` components per lane
        // from `to` on are writable.
        unsafe { L::store_adjoining(components, to) }
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    unsafe fn between_shorts(
        level: Self::Level,
        from: *const Shorts,
        records: impl Fn(usize) -> [usize; 2],
        t: Self,
    ) -> [Self; 4] {
        // SAFETY: the caller guarantees that the records of each lane are readable, and `L` has the
        // same lanes. `L` may fuse here without a change of bits, because the product 2¹⁴·t is
        // exact.
        unsafe { L::between_shorts(level.0, from, records, t.0) }.map(Self)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn sum_quads([a, b, c, d]: [Self; 4]) -> Self {
        Self(L::sum_quads([a.0, b.0, c.0, d.0]))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn neg_mul_add(self, factor: Self, addend: Self) -> Self {
        addend - self * factor
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn copysign(self, sign: Self) -> Self {
        Self(self.0.copysign(sign.0))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn lt(self, other: Self) -> Self::Mask {
        self.0.lt(other.0)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn le(self, other: Self) -> Self::Mask {
        self.0.le(other.0)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn eq(self, other: Self) -> Self::Mask {
        self.0.eq(other.0)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self(L::select(mask, yes.0, no.0))
    }
}

impl<L: PackedDualQuat> PackedDualQuat for Unfused<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_twice(level: Self::Level, from: &[L::Real; 4]) -> Self {
        Self(L::load_twice(level.0, from))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn splat_each(level: Self::Level, from: &[L::Real; 8]) -> [Self; 8] {
        let [a, b, c, d, e, f, g, h] = L::splat_each(level.0, from);
        [Self(a), Self(b), Self(c), Self(d), Self(e), Self(f), Self(g), Self(h)]
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn columns(self) -> [Self; 4] {
        let [x, y, z, w] = self.0.columns();
        [Self(x), Self(y), Self(z), Self(w)]
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn times_epsilon(self) -> Self {
        Self(self.0.times_epsilon())
    }
}

macro_rules! operator {
    ($($trait:ident $method:ident;)*) => {$(
        impl<L: $trait<Output = L>> $trait for Unfused<L> {
            type Output = Self;
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    )*};
}
operator! { Add add; Sub sub; Mul mul; Div div; }

impl<L: Neg<Output = L>> Neg for Unfused<L> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}
