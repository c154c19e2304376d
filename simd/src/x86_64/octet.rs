//! One dual quaternion in a register, or in two.

use super::avx2;
use super::avx512;
use crate::lane::Lane;
use crate::octet::Octet;
use crate::pair::Pair;
use core::arch::x86_64::*;

/// Where the columns of [`Octet::columns`] change the sign.
const SIGNS: [[f64; 4]; 3] =
    [[0.0, 0.0, -0.0, -0.0], [-0.0, 0.0, 0.0, -0.0], [0.0, -0.0, 0.0, -0.0]];

/// [`SIGNS`] in every group of four.
const fn signs_f32<const N: usize>() -> [[f32; N]; 3] {
    let mut signs = [[0.0; N]; 3];
    let mut i = 0;
    while i < 3 * N {
        signs[i / N][i % N] = SIGNS[i / N][i % 4] as f32;
        i += 1;
    }
    signs
}

/// [`SIGNS`] in every group of four.
const fn signs_f64<const N: usize>() -> [[f64; N]; 3] {
    let mut signs = [[0.0; N]; 3];
    let mut i = 0;
    while i < 3 * N {
        signs[i / N][i % N] = SIGNS[i / N][i % 4];
        i += 1;
    }
    signs
}

/// The columns: an instruction that permutes each group of four, and one that flips signs.
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

/// A register that holds all eight.
macro_rules! octet {
    ($($name:ty, $signs:ident, $permute:ident, $xor:ident, $load:ident, |$v:ident| $raised:expr;)*) => {$(
        impl Octet for $name {
            #[inline(always)]
            fn columns(self) -> [Self; 4] {
                let level = self.level();
                // SAFETY: `self` proves the instructions; the pointers are those of whole arrays.
                let columns = unsafe { columns!(self.0, const { $signs::<8>() }, $permute, $xor, $load) };
                let [x, y, z, w] = columns;
                [Self(x, level), Self(y, level), Self(z, level), Self(w, level)]
            }
            #[inline(always)]
            fn raised(self) -> Self {
                let $v = self.0;
                // SAFETY: `self` proves the instructions.
                Self(unsafe { $raised }, self.level())
            }
        }
    )*};
}
octet! {
    avx2::F32x8, signs_f32, _mm256_permute_ps, _mm256_xor_ps, _mm256_loadu_ps,
        |v| _mm256_permute2f128_ps::<0x08>(v, v);
    avx512::F32x8, signs_f32, _mm256_permute_ps, _mm256_xor_ps, _mm256_loadu_ps,
        |v| _mm256_permute2f128_ps::<0x08>(v, v);
    avx512::F64x8, signs_f64, _mm512_permutex_pd, _mm512_xor_pd, _mm512_loadu_pd,
        |v| _mm512_maskz_shuffle_f64x2::<0b01_00_01_00>(0xf0, v, v);
}

impl Octet for Pair<avx2::F64x4> {
    #[inline(always)]
    fn columns(self) -> [Self; 4] {
        let level = self.level();
        let Self(lower, upper) = self;
        let signs = const { signs_f64::<4>() };
        let mut columns = [[lower.0; 4]; 2];
        for (columns, half) in columns.iter_mut().zip([lower.0, upper.0]) {
            // SAFETY: `self` proves the instructions; the pointers are those of whole arrays.
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
    #[inline(always)]
    fn raised(self) -> Self {
        Self(self.0.with(0.0), self.0)
    }
}
