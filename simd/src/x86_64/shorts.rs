//! Two records of four short numbers for each lane, and what lies between them.

use crate::shorts::Shorts;
use core::arch::asm;
use core::arch::x86_64::*;

/// Records a and b of a lane, one after the other.
///
/// # Safety
/// Both records that `place` says may be read.
#[cfg_attr(not(opt_level_0), inline(always))]
#[expect(clippy::pointers_in_nomem_asm_block, reason = "the pointer is not followed")]
unsafe fn both(from: *const Shorts, [a, b]: [usize; 2]) -> __m128d {
    // SAFETY: promised; the address stays what it was. Without a register of its own for each lane
    // the compiler adds up the addresses of all lanes in vectors, and takes them apart again.
    unsafe {
        let mut a = from.add(a);
        asm!("/* {0} */", inout(reg) a, options(pure, nomem, nostack, preserves_flags));
        _mm_loadh_pd(_mm_load_sd(a.cast()), from.add(b).cast())
    }
}

/// [`Lanes::between_shorts`](crate::Lanes::between_shorts) of eight lanes.
///
/// # Safety
/// As for that, and the CPU must have AVX2 and FMA.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f32x8_between(
    from: *const Shorts,
    place: impl Fn(usize) -> [usize; 2],
    t: __m256,
) -> [__m256; 4] {
    // SAFETY: promised.
    unsafe {
        // Of a number and NaN these give the second.
        let t = _mm256_min_ps(_mm256_max_ps(t, _mm256_setzero_ps()), _mm256_set1_ps(1.0));
        // 2¹⁴t is in the last bits of the sum, as in `shorts::one_by_one`; the other weight
        // stands before it. The product is exact, so nothing is fused, and unfused lanes share
        // this.
        let to = _mm256_mul_ps(t, _mm256_set1_ps(16384.0));
        let to = _mm256_add_ps(to, _mm256_set1_ps(12_582_912.0));
        let to = _mm256_castps_si256(to);
        let from_a = _mm256_sub_epi16(_mm256_set1_epi32(16384), to);
        let weights = _mm256_blend_epi16::<0xAA>(from_a, _mm256_slli_epi32::<16>(to));
        // a₀b₀, a₁b₁, a₂b₂, a₃b₃ of lanes i and i + 4.
        let pair = _mm256_set_epi8(
            15, 14, 7, 6, 13, 12, 5, 4, 11, 10, 3, 2, 9, 8, 1, 0, //
            15, 14, 7, 6, 13, 12, 5, 4, 11, 10, 3, 2, 9, 8, 1, 0,
        );
        macro_rules! lanes {
            ($i:literal) => {{
                let lower = _mm256_castpd128_pd256(both(from, place($i)));
                let both = _mm256_insertf128_pd::<1>(lower, both(from, place($i + 4)));
                _mm256_shuffle_epi8(_mm256_castpd_si256(both), pair)
            }};
        }
        let (a, b, c, d) = (lanes!(0), lanes!(1), lanes!(2), lanes!(3));
        let (ab, cd) = (_mm256_unpacklo_epi32(a, b), _mm256_unpacklo_epi32(c, d));
        let (ab_high, cd_high) = (_mm256_unpackhi_epi32(a, b), _mm256_unpackhi_epi32(c, d));
        macro_rules! between {
            ($half:ident, $ab:ident, $cd:ident) => {
                _mm256_cvtepi32_ps(_mm256_madd_epi16($half($ab, $cd), weights))
            };
        }
        [
            between!(_mm256_unpacklo_epi64, ab, cd),
            between!(_mm256_unpackhi_epi64, ab, cd),
            between!(_mm256_unpacklo_epi64, ab_high, cd_high),
            between!(_mm256_unpackhi_epi64, ab_high, cd_high),
        ]
    }
}

/// The same of sixteen lanes, eight at a time: the product of 512 bits is no part of AVX-512 F, VL
/// and DQ.
///
/// # Safety
/// As for that, and the CPU must have AVX-512 F and DQ.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f32x16_between(
    from: *const Shorts,
    place: impl Fn(usize) -> [usize; 2],
    t: __m512,
) -> [__m512; 4] {
    // SAFETY: promised.
    unsafe {
        let [x, y, z, w] = f32x8_between(from, &place, _mm512_castps512_ps256(t));
        let upper = f32x8_between(
            from,
            #[cfg_attr(not(opt_level_0), inline(always))]
            |lane| place(8 + lane),
            _mm512_extractf32x8_ps::<1>(t),
        );
        macro_rules! join {
            ($lower:ident, $c:literal) => {
                _mm512_insertf32x8::<1>(_mm512_castps256_ps512($lower), upper[$c])
            };
        }
        [join!(x, 0), join!(y, 1), join!(z, 2), join!(w, 3)]
    }
}
