//! [`Avx512`]: the level of AVX-512 F, VL and DQ, with its lanes and masks.

use super::frame::align_frame;
use super::prefetch::{prefetch, prefetch_every};
use super::quads::*;
use super::shorts::*;
use super::vector::vector;
use crate::lanes::Level;
use crate::lanes::{Lanes, Mask};
use core::arch::asm;
use core::arch::x86_64::*;
use core::ops::{BitAnd, BitOr, Not};

/// The level of AVX-512 F, VL and DQ: sixteen `f32` or eight `f64` at a time. Only
/// [`Avx512::detect`] makes a value, so a value proves that the CPU has the instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Avx512(());

impl Avx512 {
    /// Returns the level if the CPU has AVX-512 F, VL and DQ and the operating system saves their
    /// registers, and `None` if not.
    #[inline]
    #[must_use]
    pub fn detect() -> Option<Self> {
        crate::detect::avx512().then_some(Self(()))
    }

    /// Returns true if this CPU shuffles sixteen `f32` as quickly as eight. This is true of AMD's
    /// CPUs and false of Intel's.
    #[inline]
    #[must_use]
    pub fn shuffles_wide(self) -> bool {
        crate::detect::shuffles_wide()
    }
}

impl crate::sealed::Sealed for Avx512 {}
impl Level for Avx512 {
    type F32x4 = F32x4;
    type F32x8 = F32x8;
    type F32x16 = F32x16;
    type F64x2 = F64x2;
    type F64x4 = F64x4;
    type F64x8 = F64x8;
    type Single = F32x16;
    type Double = F64x8;

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
    #[expect(clippy::pointers_in_nomem_asm_block, reason = "the pointer is not followed")]
    fn locate<T>(self, value: &T) -> &T {
        let mut address = core::ptr::from_ref(value);
        // SAFETY: the assembly is a comment without an instruction, so `address` is still that of
        // `value`, which is borrowed for as long as the result.
        unsafe {
            asm!("/* {0} */", inout(reg) address, options(pure, nomem, nostack, preserves_flags));
            &*address
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<R>(self, kernel: impl FnOnce() -> R) -> R {
        #[inline]
        #[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq")]
        fn with_avx512<R>(kernel: impl FnOnce() -> R) -> R {
            align_frame();
            kernel()
        }
        // SAFETY: `with_avx512` needs AVX2, FMA and AVX-512 F, VL and DQ. Only `detect` makes
        // `self`, after it has found that the CPU has all of them.
        unsafe { with_avx512(kernel) }
    }
}

/// A mask of up to 16 lanes, as integer bits: bit `i` is the truth value of lane `i` (1 is true),
/// and the bits after the last lane are zero.
#[derive(Clone, Copy, Debug)]
pub struct Bits<const LANES: u32>(u32);

impl<const LANES: u32> Bits<LANES> {
    const ALL: u32 = (1 << LANES) - 1;
}

impl<const LANES: u32> Mask for Bits<LANES> {
    const LANES: u32 = LANES;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn any(self) -> bool {
        self.0 != 0
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn all(self) -> bool {
        self.0 == Self::ALL
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn to_bitmask(self) -> u32 {
        self.0
    }
}

impl<const LANES: u32> BitAnd for Bits<LANES> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl<const LANES: u32> BitOr for Bits<LANES> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl<const LANES: u32> Not for Bits<LANES> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn not(self) -> Self {
        Self(!self.0 & Self::ALL)
    }
}

type Bits2 = Bits<2>;
type Bits4 = Bits<4>;
type Bits8 = Bits<8>;
type Bits16 = Bits<16>;

vector! {
    /// Four lanes of `f32` in a register of 128 bits.
    F32x4 = __m128 [f32; 4], Avx512, mask Bits4;
    add _mm_add_ps; sub _mm_sub_ps; mul _mm_mul_ps; div _mm_div_ps; sqrt _mm_sqrt_ps;
    mul_add _mm_fmadd_ps; neg_mul_add _mm_fnmadd_ps;
    splat _mm_set1_ps; load _mm_loadu_ps; store _mm_storeu_ps; stream _mm_stream_ps;
    quads f32x4_load f32x4_store f32x4_store_triples f32x4_sum;
    triples f32x4_load_triples;
    shorts one_by_one;
    and _mm_and_ps; and_not _mm_andnot_ps; or _mm_or_ps; xor _mm_xor_ps;
    less |a, b| Bits(u32::from(_mm_cmp_ps_mask::<_CMP_LT_OQ>(a.0, b.0)));
    less_equal |a, b| Bits(u32::from(_mm_cmp_ps_mask::<_CMP_LE_OQ>(a.0, b.0)));
    equal |a, b| Bits(u32::from(_mm_cmp_ps_mask::<_CMP_EQ_OQ>(a.0, b.0)));
    select |mask, yes, no| _mm_mask_blend_ps(mask.0 as __mmask8, no.0, yes.0);
}

vector! {
    /// Eight lanes of `f32` in a register of 256 bits.
    F32x8 = __m256 [f32; 8], Avx512, mask Bits8;
    add _mm256_add_ps; sub _mm256_sub_ps; mul _mm256_mul_ps; div _mm256_div_ps; sqrt _mm256_sqrt_ps;
    mul_add _mm256_fmadd_ps; neg_mul_add _mm256_fnmadd_ps;
    splat _mm256_set1_ps; load _mm256_loadu_ps; store _mm256_storeu_ps; stream _mm256_stream_ps;
    quads f32x8_load f32x8_store f32x8_store_triples f32x8_sum;
    triples f32x8_load_triples;
    between_shorts f32x8_between;
    and _mm256_and_ps; and_not _mm256_andnot_ps; or _mm256_or_ps; xor _mm256_xor_ps;
    less |a, b| Bits(u32::from(_mm256_cmp_ps_mask::<_CMP_LT_OQ>(a.0, b.0)));
    less_equal |a, b| Bits(u32::from(_mm256_cmp_ps_mask::<_CMP_LE_OQ>(a.0, b.0)));
    equal |a, b| Bits(u32::from(_mm256_cmp_ps_mask::<_CMP_EQ_OQ>(a.0, b.0)));
    select |mask, yes, no| _mm256_mask_blend_ps(mask.0 as __mmask8, no.0, yes.0);
}

vector! {
    /// Sixteen lanes of `f32` in a register of 512 bits.
    F32x16 = __m512 [f32; 16], Avx512, mask Bits16;
    add _mm512_add_ps; sub _mm512_sub_ps; mul _mm512_mul_ps; div _mm512_div_ps; sqrt _mm512_sqrt_ps;
    mul_add _mm512_fmadd_ps; neg_mul_add _mm512_fnmadd_ps;
    splat _mm512_set1_ps; load _mm512_loadu_ps; store _mm512_storeu_ps; stream _mm512_stream_ps;
    quads f32x16_load f32x16_store f32x16_store_triples f32x16_sum;
    triples f32x16_load_triples;
    between_shorts f32x16_between;
    and _mm512_and_ps; and_not _mm512_andnot_ps; or _mm512_or_ps; xor _mm512_xor_ps;
    less |a, b| Bits(u32::from(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(a.0, b.0)));
    less_equal |a, b| Bits(u32::from(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(a.0, b.0)));
    equal |a, b| Bits(u32::from(_mm512_cmp_ps_mask::<_CMP_EQ_OQ>(a.0, b.0)));
    select |mask, yes, no| _mm512_mask_blend_ps(mask.0 as __mmask16, no.0, yes.0);
}

vector! {
    /// Two lanes of `f64` in a register of 128 bits.
    F64x2 = __m128d [f64; 2], Avx512, mask Bits2;
    add _mm_add_pd; sub _mm_sub_pd; mul _mm_mul_pd; div _mm_div_pd; sqrt _mm_sqrt_pd;
    mul_add _mm_fmadd_pd; neg_mul_add _mm_fnmadd_pd;
    splat _mm_set1_pd; load _mm_loadu_pd; store _mm_storeu_pd; stream _mm_stream_pd;
    quads f64x2_load f64x2_store f64x2_store_triples;
    shorts one_by_one;
    and _mm_and_pd; and_not _mm_andnot_pd; or _mm_or_pd; xor _mm_xor_pd;
    less |a, b| Bits(u32::from(_mm_cmp_pd_mask::<_CMP_LT_OQ>(a.0, b.0)));
    less_equal |a, b| Bits(u32::from(_mm_cmp_pd_mask::<_CMP_LE_OQ>(a.0, b.0)));
    equal |a, b| Bits(u32::from(_mm_cmp_pd_mask::<_CMP_EQ_OQ>(a.0, b.0)));
    select |mask, yes, no| _mm_mask_blend_pd(mask.0 as __mmask8, no.0, yes.0);
}

vector! {
    /// Four lanes of `f64` in a register of 256 bits.
    F64x4 = __m256d [f64; 4], Avx512, mask Bits4;
    add _mm256_add_pd; sub _mm256_sub_pd; mul _mm256_mul_pd; div _mm256_div_pd; sqrt _mm256_sqrt_pd;
    mul_add _mm256_fmadd_pd; neg_mul_add _mm256_fnmadd_pd;
    splat _mm256_set1_pd; load _mm256_loadu_pd; store _mm256_storeu_pd; stream _mm256_stream_pd;
    quads f64x4_load f64x4_store f64x4_store_triples f64x4_sum;
    shorts one_by_one;
    and _mm256_and_pd; and_not _mm256_andnot_pd; or _mm256_or_pd; xor _mm256_xor_pd;
    less |a, b| Bits(u32::from(_mm256_cmp_pd_mask::<_CMP_LT_OQ>(a.0, b.0)));
    less_equal |a, b| Bits(u32::from(_mm256_cmp_pd_mask::<_CMP_LE_OQ>(a.0, b.0)));
    equal |a, b| Bits(u32::from(_mm256_cmp_pd_mask::<_CMP_EQ_OQ>(a.0, b.0)));
    select |mask, yes, no| _mm256_mask_blend_pd(mask.0 as __mmask8, no.0, yes.0);
}

vector! {
    /// Eight lanes of `f64` in a register of 512 bits.
    F64x8 = __m512d [f64; 8], Avx512, mask Bits8;
    add _mm512_add_pd; sub _mm512_sub_pd; mul _mm512_mul_pd; div _mm512_div_pd; sqrt _mm512_sqrt_pd;
    mul_add _mm512_fmadd_pd; neg_mul_add _mm512_fnmadd_pd;
    splat _mm512_set1_pd; load _mm512_loadu_pd; store _mm512_storeu_pd; stream _mm512_stream_pd;
    quads f64x8_load f64x8_store f64x8_store_triples f64x8_sum;
    shorts one_by_one;
    and _mm512_and_pd; and_not _mm512_andnot_pd; or _mm512_or_pd; xor _mm512_xor_pd;
    less |a, b| Bits(u32::from(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(a.0, b.0)));
    less_equal |a, b| Bits(u32::from(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(a.0, b.0)));
    equal |a, b| Bits(u32::from(_mm512_cmp_pd_mask::<_CMP_EQ_OQ>(a.0, b.0)));
    select |mask, yes, no| _mm512_mask_blend_pd(mask.0 as __mmask8, no.0, yes.0);
}
