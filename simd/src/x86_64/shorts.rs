//! Interpolation between records of four 16-bit integers with AVX2. [`crate::shorts`] has the
//! formula.

use crate::shorts::Shorts;
use core::arch::asm;
use core::arch::x86_64::*;

/// Loads records `a` and `b` of a lane into one register: record `a` into the lower half, and
/// record `b` into the upper half.
///
/// # Safety
/// The records `from + a` and `from + b` must be readable.
#[cfg_attr(not(opt_level_0), inline(always))]
#[expect(clippy::pointers_in_nomem_asm_block, reason = "the pointer is not followed")]
unsafe fn both(from: *const Shorts, [a, b]: [usize; 2]) -> __m128d {
    // SAFETY: the caller guarantees that both records are readable, and the assembly is a comment
    // without an instruction, so it does not change the address.
    unsafe {
        // The assembly makes the compiler hold the address in a general register. Without it, the
        // compiler computes the addresses of all lanes in vector registers and extracts them again,
        // which takes longer.
        let mut a = from.add(a);
        asm!("/* {0} */", inout(reg) a, options(pure, nomem, nostack, preserves_flags));
        _mm_loadh_pd(_mm_load_sd(a.cast()), from.add(b).cast())
    }
}

/// Implements [`Lanes::between_shorts`](crate::Lanes::between_shorts) for eight lanes of `f32`.
///
/// # Safety
/// For each lane, the records `from + a` and `from + b` with `[a, b] = records(lane)` must be
/// readable, and the CPU must have AVX2.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f32x8_between(
    from: *const Shorts,
    records: impl Fn(usize) -> [usize; 2],
    t: __m256,
) -> [__m256; 4] {
    // SAFETY: the caller guarantees that the CPU has AVX2, and that both records of each lane are
    // readable, which `both` reads.
    unsafe {
        // The minimum and the maximum return their second operand if the first is NaN, so NaN
        // becomes 0.
        let t = _mm256_min_ps(_mm256_max_ps(t, _mm256_setzero_ps()), _mm256_set1_ps(1.0));
        // Each lane holds its two weights: 2¹⁴ − w in the lower 16 bits and w in the upper 16
        // bits. The product t·2¹⁴ is exact, so a fused multiply-add would give the same bits,
        // and fused and unfused lanes share this function.
        let to = _mm256_mul_ps(t, _mm256_set1_ps(16384.0));
        let to = _mm256_add_ps(to, _mm256_set1_ps(12_582_912.0));
        let to = _mm256_castps_si256(to);
        let from_a = _mm256_sub_epi16(_mm256_set1_epi32(16384), to);
        let weights = _mm256_blend_epi16::<0xAA>(from_a, _mm256_slli_epi32::<16>(to));
        // The shuffle `pair` reorders 16-bit integers: it brings a₀a₁a₂a₃ b₀b₁b₂b₃
        // to a₀b₀ a₁b₁ a₂b₂ a₃b₃. The lower half of the register holds lane i, and
        // the upper half holds lane i + 4.
        let pair = _mm256_set_epi8(
            15, 14, 7, 6, 13, 12, 5, 4, 11, 10, 3, 2, 9, 8, 1, 0, //
            15, 14, 7, 6, 13, 12, 5, 4, 11, 10, 3, 2, 9, 8, 1, 0,
        );
        macro_rules! lanes {
            ($i:literal) => {{
                let lower = _mm256_castpd128_pd256(both(from, records($i)));
                let both = _mm256_insertf128_pd::<1>(lower, both(from, records($i + 4)));
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

/// Implements [`Lanes::between_shorts`](crate::Lanes::between_shorts) for sixteen lanes of `f32`,
/// eight lanes at a time. AVX-512 F, VL and DQ have no instruction that multiplies 16-bit integers
/// in 512 bits and adds the products in pairs.
///
/// # Safety
/// For each lane, the records `from + a` and `from + b` with `[a, b] = records(lane)` must be
/// readable, and the CPU must have AVX2 and AVX-512 F and DQ.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f32x16_between(
    from: *const Shorts,
    records: impl Fn(usize) -> [usize; 2],
    t: __m512,
) -> [__m512; 4] {
    // SAFETY: the caller guarantees that the CPU has AVX2 and AVX-512 F and DQ, and that both
    // records of each of the sixteen lanes are readable.
    unsafe {
        let [x, y, z, w] = f32x8_between(from, &records, _mm512_castps512_ps256(t));
        let upper = f32x8_between(
            from,
            #[cfg_attr(not(opt_level_0), inline(always))]
            |lane| records(8 + lane),
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
