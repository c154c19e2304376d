//! Interpolation between records of four 16-bit integers: [`Lanes::between_shorts`] for all lanes
//! but the eight and sixteen `f32` of AVX2 and AVX-512, which have their own code. All lanes
//! interpolate in integers, so that the result has the same bits on every target:
//!
//! ```text
//! w = round(2¹⁴·t)                an integer from 0 to 2¹⁴
//! (2¹⁴ − w)·a + w·b               at most 2²⁹, so it is exact in 32 bits
//! ```
//!
//! SSE2 and simd128 compute such sums by one instruction, which multiplies 16-bit integers and adds
//! the products in pairs. NEON takes three instructions.
//!
//! The weight w needs no conversion to an integer. The lowest bit of an `f32` near 1.5·2²³ has
//! the value 1, so the sum 2¹⁴·t + 1.5·2²³ is rounded to an integer, and its lowest 16 bits
//! are w. For `f64` the constant is 1.5·2⁵².

use crate::lanes::{Float, Lanes};
use bytemuck::Zeroable;

/// A record of four 16-bit integers. Each integer has its lower byte first on every target, because
/// records are read from the bytes of files in place.
pub(crate) type Shorts = [u8; 8];

/// Returns the four 16-bit components of a record.
#[inline(always)]
pub(crate) fn numbers(record: Shorts) -> [i16; 4] {
    let word = u64::from_le_bytes(record);
    [word as i16, (word >> 16) as i16, (word >> 32) as i16, (word >> 48) as i16]
}

/// Interpolates record by record: one lane after the other, and one component after the other. It
/// works for all lane types.
///
/// # Safety
/// For each lane, the records `from + a` and `from + b` with `[a, b] = records(lane)` must be
/// readable.
#[inline(always)]
pub(crate) unsafe fn one_by_one<L: Lanes>(
    level: L::Level,
    from: *const Shorts,
    records: impl Fn(usize) -> [usize; 2],
    t: L,
) -> [L; 4] {
    let single = L::Real::SINGLE;
    let in_last_bits = t.constant(if single { 12_582_912.0 } else { 6_755_399_441_055_744.0 });
    let (zero, one) = (t.constant(0.0), t.constant(1.0));
    let t = L::select(zero.lt(t), t, zero);
    let t = L::select(t.lt(one), t, one);
    let weights = t.mul_add(t.constant(16384.0), in_last_bits).to_array();
    let mut rows = [L::Array::zeroed(); 4];
    for lane in 0..L::LANES {
        // SAFETY: `record` is one of the two indices of `records(lane)`, and the caller guarantees
        // that both records, `from + record`, are readable.
        let [a, b] = records(lane).map(|record| numbers(unsafe { *from.add(record) }));
        let sum = weights.as_ref()[lane];
        let weight =
            if single { bytemuck::cast(sum) } else { bytemuck::cast::<_, u64>(sum) as u32 };
        let weight = (weight & 0xffff) as i32;
        for (row, (a, b)) in rows.iter_mut().zip(a.into_iter().zip(b)) {
            let (a, b) = (i32::from(a), i32::from(b));
            row.as_mut()[lane] = L::Real::from_i32(a * (16384 - weight) + b * weight);
        }
    }
    let [x, y, z, w] = &rows;
    [L::load(level, x), L::load(level, y), L::load(level, z), L::load(level, w)]
}

/// Big-endian targets use [`one_by_one`] for four lanes too, because a load of a record into a
/// register would swap the bytes of its integers there.
#[cfg(target_endian = "big")]
pub(crate) use one_by_one as four_at_once;

/// Interpolates four lanes at once, by products of 16-bit integers that are added in pairs.
///
/// # Safety
/// For each lane, the records `from + a` and `from + b` with `[a, b] = records(lane)` must be
/// readable.
#[cfg(target_endian = "little")]
#[inline(always)]
pub(crate) unsafe fn four_at_once(
    _: <wide::f32x4 as Lanes>::Level,
    from: *const Shorts,
    records: impl Fn(usize) -> [usize; 2],
    t: wide::f32x4,
) -> [wide::f32x4; 4] {
    use wide::{f32x4, i16x8, i32x4, u32x4};
    let (zero, one) = (f32x4::ZERO, f32x4::ONE);
    let t = t.simd_gt(zero).select(t, zero);
    let t = t.simd_lt(one).select(t, one);
    // Each lane holds its two weights: 2¹⁴ − w in the lower 16 bits and w in the upper 16
    // bits.
    let to: u32x4 = bytemuck::cast(t * f32x4::splat(16384.0) + f32x4::splat(12_582_912.0));
    let low = u32x4::splat(0xffff);
    let weights = ((u32x4::splat(16384) - (to & low)) & low) | (to << 16);
    let weights: i16x8 = bytemuck::cast(weights);
    // Row `lane` holds both records of that lane, with two integers in each 32 bits: a₀a₁
    // a₂a₃ b₀b₁ b₂b₃.
    let mut rows = [f32x4::ZERO; 4];
    for (lane, row) in rows.iter_mut().enumerate() {
        // SAFETY: `record` is one of the two indices of `records(lane)`, and the caller guarantees
        // that both records, `from + record`, are readable.
        *row = bytemuck::cast(records(lane).map(|record| unsafe { *from.add(record) }));
    }
    let [a01, a23, b01, b23]: [u32x4; 4] = bytemuck::cast(f32x4::transpose(rows));
    let between = |pairs: u32x4| {
        let sum: i32x4 = bytemuck::cast::<_, i16x8>(pairs).dot(weights);
        sum.round_float()
    };
    let (lower, upper) =
        (|a: u32x4, b: u32x4| (a & low) | (b << 16), |a: u32x4, b: u32x4| (a >> 16) | (b & !low));
    [lower(a01, b01), upper(a01, b01), lower(a23, b23), upper(a23, b23)].map(between)
}
