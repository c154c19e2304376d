//! [`Avx2`]: the level of AVX2 and FMA, with its lanes and masks.

use super::frame::align_frame;
use super::prefetch::{prefetch, prefetch_every};
use super::quads::*;
use super::shorts::*;
use super::vector::vector;
use crate::lanes::Level;
use crate::lanes::{Lanes, Mask};
use crate::pair::Pair;
use core::arch::x86_64::*;
use core::ops::{BitAnd, BitOr, Not};

/// The level of AVX2 and FMA: eight `f32` or four `f64` at a time. Only [`Avx2::detect`] makes a
/// value, so a value proves that the CPU has the instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Avx2(());

impl Avx2 {
    /// Returns the level if the CPU has AVX2 and FMA and the operating system saves their
    /// registers, and `None` if not.
    #[inline]
    #[must_use]
    pub fn detect() -> Option<Self> {
        crate::detect::avx2().then_some(Self(()))
    }
}

impl crate::sealed::Sealed for Avx2 {}
impl Level for Avx2 {
    type F32x4 = F32x4;
    type F32x8 = F32x8;
    type F32x16 = Pair<F32x8>;
    type F64x2 = F64x2;
    type F64x4 = F64x4;
    type F64x8 = Pair<F64x4>;
    type Single = F32x8;
    type Double = F64x4;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn fence(self) {
        // SAFETY: `sfence` is an instruction of SSE, which every x86-64 CPU has.
        unsafe { _mm_sfence() };
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn prefetch<T>(self, value: &T) {
        prefetch(value);
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn prefetch_every<T>(self, memory: &[T], stride: usize, count: usize) {
        prefetch_every(memory, stride, count);
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<R>(self, kernel: impl FnOnce() -> R) -> R {
        #[inline]
        #[target_feature(enable = "avx2,fma")]
        fn with_avx2<R>(kernel: impl FnOnce() -> R) -> R {
            align_frame();
            kernel()
        }
        // SAFETY: `with_avx2` needs AVX2 and FMA. Only `detect` makes `self`, after it has found
        // that the CPU has both.
        unsafe { with_avx2(kernel) }
    }
}

vector! {
    /// Four lanes of `f32` in a register of 128 bits.
    F32x4 = __m128 [f32; 4], Avx2, mask M32x4;
    add _mm_add_ps; sub _mm_sub_ps; mul _mm_mul_ps; div _mm_div_ps; sqrt _mm_sqrt_ps;
    mul_add _mm_fmadd_ps; neg_mul_add _mm_fnmadd_ps;
    splat _mm_set1_ps; load _mm_loadu_ps; store _mm_storeu_ps; stream _mm_stream_ps;
    quads f32x4_load f32x4_store f32x4_store_triples f32x4_sum;
    triples f32x4_load_triples;
    shorts one_by_one;
    and _mm_and_ps; and_not _mm_andnot_ps; or _mm_or_ps; xor _mm_xor_ps;
    less |a, b| M32x4(_mm_cmplt_ps(a.0, b.0), a.1);
    less_equal |a, b| M32x4(_mm_cmple_ps(a.0, b.0), a.1);
    equal |a, b| M32x4(_mm_cmpeq_ps(a.0, b.0), a.1);
    select |mask, yes, no| _mm_blendv_ps(no.0, yes.0, mask.0);
}

vector! {
    /// Eight lanes of `f32` in a register of 256 bits.
    F32x8 = __m256 [f32; 8], Avx2, mask M32x8;
    add _mm256_add_ps; sub _mm256_sub_ps; mul _mm256_mul_ps; div _mm256_div_ps; sqrt _mm256_sqrt_ps;
    mul_add _mm256_fmadd_ps; neg_mul_add _mm256_fnmadd_ps;
    splat _mm256_set1_ps; load _mm256_loadu_ps; store _mm256_storeu_ps; stream _mm256_stream_ps;
    quads f32x8_load f32x8_store f32x8_store_triples f32x8_sum;
    triples f32x8_load_triples;
    between_shorts f32x8_between;
    and _mm256_and_ps; and_not _mm256_andnot_ps; or _mm256_or_ps; xor _mm256_xor_ps;
    less |a, b| M32x8(_mm256_cmp_ps::<_CMP_LT_OQ>(a.0, b.0), a.1);
    less_equal |a, b| M32x8(_mm256_cmp_ps::<_CMP_LE_OQ>(a.0, b.0), a.1);
    equal |a, b| M32x8(_mm256_cmp_ps::<_CMP_EQ_OQ>(a.0, b.0), a.1);
    select |mask, yes, no| _mm256_blendv_ps(no.0, yes.0, mask.0);
}

vector! {
    /// Two lanes of `f64` in a register of 128 bits.
    F64x2 = __m128d [f64; 2], Avx2, mask M64x2;
    add _mm_add_pd; sub _mm_sub_pd; mul _mm_mul_pd; div _mm_div_pd; sqrt _mm_sqrt_pd;
    mul_add _mm_fmadd_pd; neg_mul_add _mm_fnmadd_pd;
    splat _mm_set1_pd; load _mm_loadu_pd; store _mm_storeu_pd; stream _mm_stream_pd;
    quads f64x2_load f64x2_store f64x2_store_triples;
    shorts one_by_one;
    and _mm_and_pd; and_not _mm_andnot_pd; or _mm_or_pd; xor _mm_xor_pd;
    less |a, b| M64x2(_mm_cmplt_pd(a.0, b.0), a.1);
    less_equal |a, b| M64x2(_mm_cmple_pd(a.0, b.0), a.1);
    equal |a, b| M64x2(_mm_cmpeq_pd(a.0, b.0), a.1);
    select |mask, yes, no| _mm_blendv_pd(no.0, yes.0, mask.0);
}

vector! {
    /// Four lanes of `f64` in a register of 256 bits.
    F64x4 = __m256d [f64; 4], Avx2, mask M64x4;
    add _mm256_add_pd; sub _mm256_sub_pd; mul _mm256_mul_pd; div _mm256_div_pd; sqrt _mm256_sqrt_pd;
    mul_add _mm256_fmadd_pd; neg_mul_add _mm256_fnmadd_pd;
    splat _mm256_set1_pd; load _mm256_loadu_pd; store _mm256_storeu_pd; stream _mm256_stream_pd;
    quads f64x4_load f64x4_store f64x4_store_triples f64x4_sum;
    shorts one_by_one;
    and _mm256_and_pd; and_not _mm256_andnot_pd; or _mm256_or_pd; xor _mm256_xor_pd;
    less |a, b| M64x4(_mm256_cmp_pd::<_CMP_LT_OQ>(a.0, b.0), a.1);
    less_equal |a, b| M64x4(_mm256_cmp_pd::<_CMP_LE_OQ>(a.0, b.0), a.1);
    equal |a, b| M64x4(_mm256_cmp_pd::<_CMP_EQ_OQ>(a.0, b.0), a.1);
    select |mask, yes, no| _mm256_blendv_pd(no.0, yes.0, mask.0);
}

/// Defines the mask of a lane type: a register in which each lane has all bits one (true) or all
/// bits zero (false), and an [`Avx2`] as the proof that the CPU has the instructions.
macro_rules! mask {
    ($name:ident = $register:ident, $lanes:literal; $and:ident; $or:ident; $xor:ident; $ones:expr; $bits:ident) => {
        /// One truth value per lane: each lane of the register has all bits one (true) or all bits
        /// zero (false).
        #[derive(Clone, Copy, Debug)]
        pub struct $name($register, Avx2);

        impl Mask for $name {
            const LANES: u32 = $lanes;
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn any(self) -> bool {
                self.to_bitmask() != 0
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn all(self) -> bool {
                self.to_bitmask() == (1 << $lanes) - 1
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn to_bitmask(self) -> u32 {
                // SAFETY: `self` holds an `Avx2`, which proves that the CPU has the instructions.
                unsafe { $bits(self.0) }.cast_unsigned()
            }
        }
        impl BitAnd for $name {
            type Output = Self;
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn bitand(self, other: Self) -> Self {
                // SAFETY: `self` holds an `Avx2`, which proves that the CPU has the instructions.
                Self(unsafe { $and(self.0, other.0) }, self.1)
            }
        }
        impl BitOr for $name {
            type Output = Self;
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn bitor(self, other: Self) -> Self {
                // SAFETY: `self` holds an `Avx2`, which proves that the CPU has the instructions.
                Self(unsafe { $or(self.0, other.0) }, self.1)
            }
        }
        impl Not for $name {
            type Output = Self;
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn not(self) -> Self {
                // SAFETY: `self` holds an `Avx2`, which proves that the CPU has the instructions.
                Self(unsafe { $xor(self.0, $ones) }, self.1)
            }
        }
    };
}
mask! { M32x4 = __m128, 4; _mm_and_ps; _mm_or_ps; _mm_xor_ps;
_mm_castsi128_ps(_mm_set1_epi32(-1)); _mm_movemask_ps }
mask! { M32x8 = __m256, 8; _mm256_and_ps; _mm256_or_ps; _mm256_xor_ps;
_mm256_castsi256_ps(_mm256_set1_epi32(-1)); _mm256_movemask_ps }
mask! { M64x2 = __m128d, 2; _mm_and_pd; _mm_or_pd; _mm_xor_pd;
_mm_castsi128_pd(_mm_set1_epi32(-1)); _mm_movemask_pd }
mask! { M64x4 = __m256d, 4; _mm256_and_pd; _mm256_or_pd; _mm256_xor_pd;
_mm256_castsi256_pd(_mm256_set1_epi32(-1)); _mm256_movemask_pd }
