//! Plain `f32` and `f64` as vectors of one lane. They run the kernels on targets without SIMD, and
//! tests compare the lanes of wider vectors with them.

use crate::internal::square_root;
use crate::lanes::{Lanes, Mask};
use crate::portable::Portable;
use crate::shorts::{self, Shorts};

impl Mask for bool {
    const LANES: u32 = 1;
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
    #[inline(always)]
    fn to_bitmask(self) -> u32 {
        u32::from(self)
    }
}

/// Implements [`Lanes`] for `f32` and `f64`. This is a macro, because the methods of both types are
/// inherent, so no generic `impl` can call them.
macro_rules! one_lane {
    ($($real:ident, $bits:ty;)*) => {$(
        impl Lanes for $real {
            type Real = $real;
            type Mask = bool;
            type Level = Portable;
            type Native = Self;
            type Array = [$real; 1];
            const LANES: usize = 1;

            #[inline(always)]
            fn level(self) -> Portable {
                Portable
            }
            #[inline(always)]
            fn splat(_: Portable, value: $real) -> Self {
                value
            }
            #[inline(always)]
            fn load(_: Portable, from: &[$real; 1]) -> Self {
                from[0]
            }
            #[inline(always)]
            fn store(self, to: &mut [$real; 1]) {
                to[0] = self;
            }
            #[inline(always)]
            unsafe fn between_shorts(
                _: Portable,
                from: *const Shorts,
                records: impl Fn(usize) -> [usize; 2],
                t: Self,
            ) -> [Self; 4] {
                // SAFETY: `one_by_one` reads the records that `records` names for lane 0, which the
                // caller guarantees to be readable.
                unsafe { shorts::one_by_one(Portable, from, records, t) }
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                // `f32::mul_add` would be a slow call into a library on a target without a fused
                // multiply-add.
                self * factor + addend
            }
            #[inline(always)]
            fn neg_mul_add(self, factor: Self, addend: Self) -> Self {
                addend - self * factor
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                square_root::$real(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                <$real>::from_bits(self.to_bits() & !(1 << (<$bits>::BITS - 1)))
            }
            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                let sign_bit = 1 << (<$bits>::BITS - 1);
                <$real>::from_bits((self.to_bits() & !sign_bit) | (sign.to_bits() & sign_bit))
            }
            #[inline(always)]
            fn lt(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn le(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn eq(self, other: Self) -> bool {
                self == other
            }
            #[inline(always)]
            fn select(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
        }
    )*};
}
one_lane! {
    f32, u32;
    f64, u64;
}
