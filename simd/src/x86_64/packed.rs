//! [`PackedDualQuat`]: one dual quaternion in one register, or in two registers of half the size.

use super::avx2;
use super::avx512;
use crate::lanes::Lanes;
use crate::lanes::PackedDualQuat;
use crate::pair::Pair;
use core::arch::asm;
use core::arch::x86_64::*;

/// The signs of the columns c₀, c₁ and c₂ of [`PackedDualQuat::columns`]: −0 where the
/// component has a minus, and +0 elsewhere.
const SIGNS: [[f64; 4]; 3] =
    [[0.0, 0.0, -0.0, -0.0], [-0.0, 0.0, 0.0, -0.0], [0.0, -0.0, 0.0, -0.0]];

/// Returns [`SIGNS`] with the four signs of each column repeated in every group of four lanes.
const fn signs_f32<const N: usize>() -> [[f32; N]; 3] {
    let mut signs = [[0.0; N]; 3];
    let mut i = 0;
    while i < 3 * N {
        signs[i / N][i % N] = SIGNS[i / N][i % 4] as f32;
        i += 1;
    }
    signs
}

/// Returns [`SIGNS`] with the four signs of each column repeated in every group of four lanes.
const fn signs_f64<const N: usize>() -> [[f64; N]; 3] {
    let mut signs = [[0.0; N]; 3];
    let mut i = 0;
    while i < 3 * N {
        signs[i / N][i % N] = SIGNS[i / N][i % 4];
        i += 1;
    }
    signs
}

/// Computes [`PackedDualQuat::columns`] of the register `$v`. The last column is the register
/// itself. Each other column is a permutation of every group of four lanes, followed by an
/// exclusive or that flips signs.
macro_rules! columns {
    ($v:expr, $signs:expr, $permute:ident, $xor:ident, $load:ident) => {{
        let [x, y, z] = $signs;
        [
            $xor($permute::<0b00_01_10_11>($v), $load(x.as_ptr())),
            $xor($permute::<0b01_00_11_10>($v), $load(y.as_ptr())),
            $xor($permute::<0b10_11_00_01>($v), $load(z.as_ptr())),
            $v,
        ]
    }};
}

/// Computes [`PackedDualQuat::columns`] with AVX-512, whose permutations pick lanes from two
/// vectors. So the negative of the vector is computed once, and each column picks its lanes from
/// the vector and from its negative.
#[inline]
#[target_feature(enable = "avx512f,avx512vl")]
fn picked_columns(v: __m256) -> [__m256; 4] {
    let negative = _mm256_xor_ps(v, _mm256_set1_ps(-0.0));
    // Indices below 8 pick lanes of `v`, and indices from 8 on pick lanes of `negative`. The upper
    // half is permuted like the lower half.
    let [y, z] = [[10, 3, 0, 9], [1, 8, 3, 10]].map(|[a, b, c, d]| {
        let mut from = _mm256_setr_epi32(a, b, c, d, a + 4, b + 4, c + 4, d + 4);
        // The assembly hides the constant from the compiler, which would otherwise replace the
        // permutation by two instructions, without a gain (docs/measured.md, *Picked numbers*).
        // SAFETY: the assembly is a comment without an instruction, so it changes no register or
        // memory.
        unsafe {
            asm!("/* {0} */", inout(ymm_reg) from, options(pure, nomem, nostack, preserves_flags));
        }
        _mm256_permutex2var_ps(v, from, negative)
    });
    let x = _mm256_shuffle_ps::<0b00_01_10_11>(v, negative);
    [x, y, z, v]
}

/// Implements [`PackedDualQuat`] for lanes that hold all eight components in one register.
macro_rules! packed {
    ($($name:ty, |$v:ident| $columns:expr, $times_epsilon:expr, |$from:ident| $twice:expr;)*) => {$(
        impl PackedDualQuat for $name {
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn load_twice(level: Self::Level, from: &[Self::Real; 4]) -> Self {
                let $from = from.as_ptr();
                // SAFETY: `level` proves that the CPU has the instructions, and `from` has the four
                // elements that are read.
                Self(unsafe { $twice }, level)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn columns(self) -> [Self; 4] {
                let (level, $v) = (self.level(), self.0);
                // SAFETY: `self` proves that the CPU has the instructions, and each load reads one
                // array of signs, which has the size of the register.
                let [x, y, z, w] = unsafe { $columns };
                [Self(x, level), Self(y, level), Self(z, level), Self(w, level)]
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn times_epsilon(self) -> Self {
                let $v = self.0;
                // SAFETY: `self` proves that the CPU has the instructions.
                Self(unsafe { $times_epsilon }, self.level())
            }
        }
    )*};
}
packed! {
    avx2::F32x8,
        |v| columns!(v, const { signs_f32::<8>() }, _mm256_permute_ps, _mm256_xor_ps, _mm256_loadu_ps),
        _mm256_insertf128_ps::<1>(_mm256_set1_ps(-0.0), _mm256_castps256_ps128(v)),
        |from| _mm256_set_m128(_mm_loadu_ps(from), _mm_loadu_ps(from));
    avx512::F32x8,
        |v| picked_columns(v),
        _mm256_insertf128_ps::<1>(_mm256_set1_ps(-0.0), _mm256_castps256_ps128(v)),
        |from| _mm256_set_m128(_mm_loadu_ps(from), _mm_loadu_ps(from));
    avx512::F64x8,
        |v| columns!(v, const { signs_f64::<8>() }, _mm512_permutex_pd, _mm512_xor_pd, _mm512_loadu_pd),
        _mm512_insertf64x4::<1>(_mm512_set1_pd(-0.0), _mm512_castpd512_pd256(v)),
        |from| _mm512_broadcast_f64x4(_mm256_loadu_pd(from));
}

impl PackedDualQuat for Pair<avx2::F64x4> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load_twice(level: Self::Level, from: &[f64; 4]) -> Self {
        let half = avx2::F64x4::load(level, from);
        Self(half, half)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn columns(self) -> [Self; 4] {
        let level = self.level();
        let Self(lower, upper) = self;
        let signs = const { signs_f64::<4>() };
        let mut columns = [[lower.0; 4]; 2];
        for (columns, half) in columns.iter_mut().zip([lower.0, upper.0]) {
            // SAFETY: `self` proves that the CPU has the instructions, and each load reads one
            // array of signs, which has the size of the register.
            *columns = unsafe {
                columns!(half, signs, _mm256_permute4x64_pd, _mm256_xor_pd, _mm256_loadu_pd)
            };
        }
        let [[ax, ay, az, aw], [bx, by, bz, bw]] = columns;
        [
            Self(avx2::F64x4(ax, level), avx2::F64x4(bx, level)),
            Self(avx2::F64x4(ay, level), avx2::F64x4(by, level)),
            Self(avx2::F64x4(az, level), avx2::F64x4(bz, level)),
            Self(avx2::F64x4(aw, level), avx2::F64x4(bw, level)),
        ]
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn times_epsilon(self) -> Self {
        Self(self.0.constant(-0.0), self.0)
    }
}
