//! Transposes between records of four (or three) components in memory and vectors of one component
//! each.
//!
//! A register consists of groups that hold one record each: a group has 128 bits for four `f32`, or
//! 256 bits for four `f64`. A load fills four registers with records and then transposes the four
//! registers inside of each group. For eight `f32`:
//!
//! ```text
//!             group 0          group 1
//! register 0  x0 y0 z0 w0  |  x4 y4 z4 w4      x0 x1 x2 x3  |  x4 x5 x6 x7
//! register 1  x1 y1 z1 w1  |  x5 y5 z5 w5  ->  y0 y1 y2 y3  |  y4 y5 y6 y7
//! register 2  x2 y2 z2 w2  |  x6 y6 z6 w6      z0 z1 z2 z3  |  z4 z5 z6 z7
//! register 3  x3 y3 z3 w3  |  x7 y7 z7 w7      w0 w1 w2 w3  |  w4 w5 w6 w7
//! ```
//!
//! Shuffles inside of groups are quick, and no component has to cross from one group to another.
//! The transpose is its own inverse, so a store transposes first and then writes the records.
//!
//! These functions are `unsafe`, because their arguments, registers and pointers, prove nothing
//! about the CPU and the memory. The lane types that call them prove that the CPU has the
//! instructions, and the callers of the lanes' `unsafe` methods guarantee that the memory may be
//! read or written.
#![allow(clippy::missing_safety_doc, reason = "stated once, below, for all functions")]

use core::arch::x86_64::*;

// Safety of all functions of this file: the CPU must have the instructions of the register's type.
// For each lane, a load reads the four components from `at + offset(lane)` on, a store writes the
// four components from `at + lane · stride` on, and a store of triples writes the three components
// from `at + 3 · lane` on. This memory must be readable or writable.

/// Defines the transpose of the 4 × 4 components in each 128-bit group of four registers.
macro_rules! transpose_singles {
    ($name:ident, $register:ident, $low:ident, $high:ident, $shuffle:ident) => {
        #[cfg_attr(not(opt_level_0), inline(always))]
        unsafe fn $name([a, b, c, d]: [$register; 4]) -> [$register; 4] {
            // SAFETY: the caller guarantees that the CPU has the instructions of this register, and
            // they access no memory.
            unsafe {
                let (ab, cd) = ($low(a, b), $low(c, d)); // a₀ b₀ a₁ b₁, c₀ d₀ c₁ d₁
                let (ab_high, cd_high) = ($high(a, b), $high(c, d)); // a₂ b₂ a₃ b₃, …
                [
                    $shuffle::<0b01_00_01_00>(ab, cd),
                    $shuffle::<0b11_10_11_10>(ab, cd),
                    $shuffle::<0b01_00_01_00>(ab_high, cd_high),
                    $shuffle::<0b11_10_11_10>(ab_high, cd_high),
                ]
            }
        }
    };
}
transpose_singles! { transpose_f32x4, __m128, _mm_unpacklo_ps, _mm_unpackhi_ps, _mm_shuffle_ps }
transpose_singles! { transpose_f32x8, __m256, _mm256_unpacklo_ps, _mm256_unpackhi_ps, _mm256_shuffle_ps }
transpose_singles! { transpose_f32x16, __m512, _mm512_unpacklo_ps, _mm512_unpackhi_ps, _mm512_shuffle_ps }

/// Defines a function that sums the four lanes in each 128-bit group of four registers. Lane `i` of
/// a group of the result is the sum of the same group of register `i`.
macro_rules! sum_singles {
    ($name:ident, $register:ident, $low:ident, $high:ident, $shuffle:ident, $add:ident) => {
        #[cfg_attr(not(opt_level_0), inline(always))]
        pub(super) unsafe fn $name([a, b, c, d]: [$register; 4]) -> $register {
            // SAFETY: the caller guarantees that the CPU has the instructions of this register, and
            // they access no memory.
            unsafe {
                let ab = $add($low(a, b), $high(a, b)); // a₀+a₂ b₀+b₂ a₁+a₃ b₁+b₃
                let cd = $add($low(c, d), $high(c, d));
                $add($shuffle::<0b01_00_01_00>(ab, cd), $shuffle::<0b11_10_11_10>(ab, cd))
            }
        }
    };
}
sum_singles! { f32x4_sum, __m128, _mm_unpacklo_ps, _mm_unpackhi_ps, _mm_shuffle_ps, _mm_add_ps }
sum_singles! { f32x8_sum, __m256, _mm256_unpacklo_ps, _mm256_unpackhi_ps, _mm256_shuffle_ps, _mm256_add_ps }
sum_singles! { f32x16_sum, __m512, _mm512_unpacklo_ps, _mm512_unpackhi_ps, _mm512_shuffle_ps, _mm512_add_ps }

/// Defines the loads and stores for a register type. `join` makes one register of the records of
/// lanes i, i + 4, i + 8 and so on, and loads each record with the macro `get`. `split` splits a
/// register into its 128-bit groups.
macro_rules! single_quads {
    (
        $load:ident, $store:ident, $load_triples:ident, $triples:ident, $register:ident,
        $transpose:ident, $shuffle:ident;
        join |$get:ident, $i:ident| $join:expr;
        split |$whole:ident| $split:expr;
    ) => {
        #[cfg_attr(not(opt_level_0), inline(always))]
        pub(super) unsafe fn $load(
            at: *const f32,
            offset: impl Fn(usize) -> usize,
        ) -> [$register; 4] {
            // SAFETY: the caller guarantees that the CPU has the instructions, and that the four
            // components from `at + offset(lane)` on are readable for each lane.
            unsafe {
                let mut rows = [core::mem::zeroed::<$register>(); 4];
                for ($i, row) in rows.iter_mut().enumerate() {
                    macro_rules! $get {
                        ($record:expr) => {
                            _mm_loadu_ps(at.add(offset($record)))
                        };
                    }
                    *row = $join;
                }
                $transpose(rows)
            }
        }
        #[cfg_attr(not(opt_level_0), inline(always))]
        pub(super) unsafe fn $store(components: [$register; 4], at: *mut f32, stride: usize) {
            // SAFETY: the caller guarantees that the CPU has the instructions, and that the four
            // components from `at + lane · stride` on are writable for each lane.
            unsafe {
                for (i, &$whole) in $transpose(components).iter().enumerate() {
                    for (group, &record) in $split.iter().enumerate() {
                        _mm_storeu_ps(at.add((4 * group + i) * stride), record);
                    }
                }
            }
        }
        #[cfg_attr(not(opt_level_0), inline(always))]
        pub(super) unsafe fn $load_triples(at: *const f32) -> [$register; 3] {
            // SAFETY: the caller guarantees that the CPU has the instructions, and that three
            // components per lane from `at` on are readable.
            unsafe {
                let mut rows = [core::mem::zeroed::<$register>(); 3];
                for ($i, row) in rows.iter_mut().enumerate() {
                    // Four records fill three rows of one group.
                    macro_rules! $get {
                        ($row:expr) => {
                            _mm_loadu_ps(at.add(4 * (3 * ($row / 4) + $row % 4)))
                        };
                    }
                    *row = $join;
                }
                let [a, b, c] = rows; // x₀ y₀ z₀ x₁, y₁ z₁ x₂ y₂, z₂ x₃ y₃ z₃
                let xy = $shuffle::<0b10_01_11_10>(b, c); // x₂ y₂ x₃ y₃
                let yz = $shuffle::<0b01_00_10_01>(a, b); // y₀ z₀ y₁ z₁
                [
                    $shuffle::<0b10_00_11_00>(a, xy),
                    $shuffle::<0b11_01_10_00>(yz, xy),
                    $shuffle::<0b11_00_11_01>(yz, c),
                ]
            }
        }
        #[cfg_attr(not(opt_level_0), inline(always))]
        pub(super) unsafe fn $triples([x, y, z]: [$register; 3], at: *mut f32) {
            // SAFETY: the caller guarantees that the CPU has the instructions, and that three
            // components per lane from `at` on are writable.
            unsafe {
                let xy = $shuffle::<0b10_00_10_00>(x, y); // x₀ x₂ y₀ y₂
                let yz = $shuffle::<0b11_01_11_01>(y, z); // y₁ y₃ z₁ z₃
                let zx = $shuffle::<0b11_01_10_00>(z, x); // z₀ z₂ x₁ x₃
                let rows = [
                    $shuffle::<0b10_00_10_00>(xy, zx), // x₀ y₀ z₀ x₁
                    $shuffle::<0b11_01_10_00>(yz, xy), // y₁ z₁ x₂ y₂
                    $shuffle::<0b11_01_11_01>(zx, yz), // z₂ x₃ y₃ z₃
                ];
                for (i, &$whole) in rows.iter().enumerate() {
                    for (group, &numbers) in $split.iter().enumerate() {
                        _mm_storeu_ps(at.add(4 * (3 * group + i)), numbers);
                    }
                }
            }
        }
    };
}

single_quads! {
    f32x4_load, f32x4_store, f32x4_load_triples, f32x4_store_triples, __m128,
    transpose_f32x4, _mm_shuffle_ps;
    join |get, i| get!(i);
    split |whole| [whole];
}
single_quads! {
    f32x8_load, f32x8_store, f32x8_load_triples, f32x8_store_triples, __m256,
    transpose_f32x8, _mm256_shuffle_ps;
    join |get, i| _mm256_insertf128_ps::<1>(_mm256_castps128_ps256(get!(i)), get!(i + 4));
    split |whole| [_mm256_castps256_ps128(whole), _mm256_extractf128_ps::<1>(whole)];
}
single_quads! {
    f32x16_load, f32x16_store, f32x16_load_triples, f32x16_store_triples, __m512,
    transpose_f32x16, _mm512_shuffle_ps;
    join |get, i| {
        let two = _mm512_insertf32x4::<1>(_mm512_castps128_ps512(get!(i)), get!(i + 4));
        _mm512_insertf32x4::<3>(_mm512_insertf32x4::<2>(two, get!(i + 8)), get!(i + 12))
    };
    split |whole| [
        _mm512_castps512_ps128(whole),
        _mm512_extractf32x4_ps::<1>(whole),
        _mm512_extractf32x4_ps::<2>(whole),
        _mm512_extractf32x4_ps::<3>(whole),
    ];
}

/// Transposes the 4 × 4 components of four registers.
#[cfg_attr(not(opt_level_0), inline(always))]
unsafe fn transpose_f64x4([a, b, c, d]: [__m256d; 4]) -> [__m256d; 4] {
    // SAFETY: the caller guarantees that the CPU has the instructions of this register, and they
    // access no memory.
    unsafe {
        let (ab, cd) = (_mm256_unpacklo_pd(a, b), _mm256_unpacklo_pd(c, d)); // a₀ b₀ a₂ b₂, …
        let (ab_odd, cd_odd) = (_mm256_unpackhi_pd(a, b), _mm256_unpackhi_pd(c, d));
        [
            _mm256_permute2f128_pd::<0x20>(ab, cd),
            _mm256_permute2f128_pd::<0x20>(ab_odd, cd_odd),
            _mm256_permute2f128_pd::<0x31>(ab, cd),
            _mm256_permute2f128_pd::<0x31>(ab_odd, cd_odd),
        ]
    }
}

/// Transposes the 4 × 4 components in each half of four registers.
#[cfg_attr(not(opt_level_0), inline(always))]
unsafe fn transpose_f64x8([a, b, c, d]: [__m512d; 4]) -> [__m512d; 4] {
    // SAFETY: the caller guarantees that the CPU has the instructions of this register, and they
    // access no memory.
    unsafe {
        let first = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
        let second = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
        let (ab, cd) = (_mm512_unpacklo_pd(a, b), _mm512_unpacklo_pd(c, d));
        let (ab_odd, cd_odd) = (_mm512_unpackhi_pd(a, b), _mm512_unpackhi_pd(c, d));
        [
            _mm512_permutex2var_pd(ab, first, cd),
            _mm512_permutex2var_pd(ab_odd, first, cd_odd),
            _mm512_permutex2var_pd(ab, second, cd),
            _mm512_permutex2var_pd(ab_odd, second, cd_odd),
        ]
    }
}

/// Returns the sums of four registers: lane `i` of the result is the sum of the lanes of register
/// `i`.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f64x4_sum([a, b, c, d]: [__m256d; 4]) -> __m256d {
    // SAFETY: the caller guarantees that the CPU has the instructions of this register, and they
    // access no memory.
    unsafe {
        // a₀+a₂ a₁+a₃ c₀+c₂ c₁+c₃
        let (ac, bd) = (sum_of_halves(a, c), sum_of_halves(b, d));
        _mm256_add_pd(_mm256_unpacklo_pd(ac, bd), _mm256_unpackhi_pd(ac, bd))
    }
}

/// Adds the halves of `a` to each other, into the lower half of the result, and those of `c`, into
/// the upper half.
#[cfg_attr(not(opt_level_0), inline(always))]
unsafe fn sum_of_halves(a: __m256d, c: __m256d) -> __m256d {
    // SAFETY: the caller guarantees that the CPU has the instructions of this register, and they
    // access no memory.
    unsafe {
        _mm256_add_pd(_mm256_permute2f128_pd::<0x20>(a, c), _mm256_permute2f128_pd::<0x31>(a, c))
    }
}

/// Sums each half of four registers: lane `i` of the lower half of the result is the sum of the
/// lower half of register `i`, and likewise for the upper halves.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f64x8_sum([a, b, c, d]: [__m512d; 4]) -> __m512d {
    // SAFETY: the caller guarantees that the CPU has the instructions of this register, and they
    // access no memory.
    unsafe {
        let [a, b, c, d] = transpose_f64x8([a, b, c, d]);
        _mm512_add_pd(_mm512_add_pd(a, c), _mm512_add_pd(b, d))
    }
}

/// Stores the first three components of a record of four.
#[cfg_attr(not(opt_level_0), inline(always))]
unsafe fn store_triple(record: __m256d, at: *mut f64) {
    // SAFETY: the caller guarantees that the CPU has AVX, and that the three components from `at`
    // on are writable.
    unsafe {
        _mm_storeu_pd(at, _mm256_castpd256_pd128(record));
        _mm_store_sd(at.add(2), _mm256_extractf128_pd::<1>(record));
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f64x4_load(at: *const f64, offset: impl Fn(usize) -> usize) -> [__m256d; 4] {
    // SAFETY: the caller guarantees that the CPU has AVX, and that the four components from
    // `at + offset(lane)` on are readable for each lane.
    unsafe {
        transpose_f64x4([
            _mm256_loadu_pd(at.add(offset(0))),
            _mm256_loadu_pd(at.add(offset(1))),
            _mm256_loadu_pd(at.add(offset(2))),
            _mm256_loadu_pd(at.add(offset(3))),
        ])
    }
}
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f64x4_store(components: [__m256d; 4], at: *mut f64, stride: usize) {
    // SAFETY: the caller guarantees that the CPU has AVX, and that the four components from
    // `at + lane · stride` on are writable for each lane.
    unsafe {
        for (i, &record) in transpose_f64x4(components).iter().enumerate() {
            _mm256_storeu_pd(at.add(i * stride), record);
        }
    }
}
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f64x4_store_triples([x, y, z]: [__m256d; 3], at: *mut f64) {
    // SAFETY: the caller guarantees that the CPU has AVX, and that the three components at
    // `at + 3i` are writable for each lane `i`.
    unsafe {
        for (i, &record) in transpose_f64x4([x, y, z, z]).iter().enumerate() {
            store_triple(record, at.add(3 * i));
        }
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f64x8_load(at: *const f64, offset: impl Fn(usize) -> usize) -> [__m512d; 4] {
    // SAFETY: the caller guarantees that the CPU has AVX-512 F, and that the four components from
    // `at + offset(lane)` on are readable for each lane.
    unsafe {
        let mut rows = [_mm512_setzero_pd(); 4];
        for (i, row) in rows.iter_mut().enumerate() {
            let lower = _mm512_castpd256_pd512(_mm256_loadu_pd(at.add(offset(i))));
            *row = _mm512_insertf64x4::<1>(lower, _mm256_loadu_pd(at.add(offset(i + 4))));
        }
        transpose_f64x8(rows)
    }
}
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f64x8_store(components: [__m512d; 4], at: *mut f64, stride: usize) {
    // SAFETY: the caller guarantees that the CPU has AVX-512 F, and that the four components from
    // `at + lane · stride` on are writable for each lane.
    unsafe {
        for (i, &records) in transpose_f64x8(components).iter().enumerate() {
            _mm256_storeu_pd(at.add(i * stride), _mm512_castpd512_pd256(records));
            _mm256_storeu_pd(at.add((i + 4) * stride), _mm512_extractf64x4_pd::<1>(records));
        }
    }
}
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f64x8_store_triples([x, y, z]: [__m512d; 3], at: *mut f64) {
    // SAFETY: the caller guarantees that the CPU has AVX-512 F, and that the three components at
    // `at + 3i` are writable for each lane `i`.
    unsafe {
        for (i, &records) in transpose_f64x8([x, y, z, z]).iter().enumerate() {
            store_triple(_mm512_castpd512_pd256(records), at.add(3 * i));
            store_triple(_mm512_extractf64x4_pd::<1>(records), at.add(3 * (i + 4)));
        }
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f64x2_load(at: *const f64, offset: impl Fn(usize) -> usize) -> [__m128d; 4] {
    // SAFETY: every x86-64 CPU has SSE2, and the caller guarantees that the four components from
    // `at + offset(lane)` on are readable for each lane.
    unsafe {
        let (a, b) = (at.add(offset(0)), at.add(offset(1)));
        let (xy_a, zw_a) = (_mm_loadu_pd(a), _mm_loadu_pd(a.add(2)));
        let (xy_b, zw_b) = (_mm_loadu_pd(b), _mm_loadu_pd(b.add(2)));
        [
            _mm_unpacklo_pd(xy_a, xy_b),
            _mm_unpackhi_pd(xy_a, xy_b),
            _mm_unpacklo_pd(zw_a, zw_b),
            _mm_unpackhi_pd(zw_a, zw_b),
        ]
    }
}
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f64x2_store([x, y, z, w]: [__m128d; 4], at: *mut f64, stride: usize) {
    // SAFETY: every x86-64 CPU has SSE2, and the caller guarantees that the four components from
    // `at + lane · stride` on are writable for each lane.
    unsafe {
        _mm_storeu_pd(at, _mm_unpacklo_pd(x, y));
        _mm_storeu_pd(at.add(2), _mm_unpacklo_pd(z, w));
        _mm_storeu_pd(at.add(stride), _mm_unpackhi_pd(x, y));
        _mm_storeu_pd(at.add(stride + 2), _mm_unpackhi_pd(z, w));
    }
}
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) unsafe fn f64x2_store_triples([x, y, z]: [__m128d; 3], at: *mut f64) {
    // SAFETY: every x86-64 CPU has SSE2, and the caller guarantees that the six components from
    // `at` on are writable.
    unsafe {
        _mm_storeu_pd(at, _mm_unpacklo_pd(x, y));
        _mm_store_sd(at.add(2), z);
        _mm_storeu_pd(at.add(3), _mm_unpackhi_pd(x, y));
        _mm_storeh_pd(at.add(5), z);
    }
}
