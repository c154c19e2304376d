//! What lies between two records of short numbers: the body of [`Lanes::between_shorts`] for lanes
//! without an instruction for it, and that of four portable lanes.

use crate::lanes::{Float, Lanes};
use bytemuck::Zeroable;

/// Four numbers of 16 bits, the lower byte first on every target: as they lie in files.
pub(crate) type Shorts = [u8; 8];

/// The four numbers.
#[inline(always)]
pub(crate) fn numbers(record: Shorts) -> [i16; 4] {
    let word = u64::from_le_bytes(record);
    [word as i16, (word >> 16) as i16, (word >> 32) as i16, (word >> 48) as i16]
}

/// One number after the other.
///
/// # Safety
/// As for [`Lanes::between_shorts`].
#[inline(always)]
pub(crate) unsafe fn one_by_one<L: Lanes>(
    level: L::Level,
    from: *const Shorts,
    place: impl Fn(usize) -> [usize; 2],
    t: L,
) -> [L; 4] {
    // A sum of 1.5·2²³, or 1.5·2⁵² in `f64`, and a number has the number's integer in its
    // last bits.
    let single = L::Real::SINGLE;
    let last_bits = t.constant(if single { 12_582_912.0 } else { 6_755_399_441_055_744.0 });
    let (zero, one) = (t.constant(0.0), t.constant(1.0));
    let t = L::select(zero.lt(t), t, zero);
    let t = L::select(t.lt(one), t, one);
    let weights = t.mul_add(t.constant(16384.0), last_bits).to_array();
    let mut rows = [L::Array::zeroed(); 4];
    for lane in 0..L::LANES {
        // SAFETY: promised.
        let [a, b] = place(lane).map(|place| numbers(unsafe { *from.add(place) }));
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

/// Where the lower byte is not the first, four lanes are nothing special.
#[cfg(target_endian = "big")]
pub(crate) use one_by_one as four_at_once;

/// Four lanes at once: SSE2, NEON and simd128 multiply short numbers and add them in pairs.
///
/// # Safety
/// As for [`Lanes::between_shorts`].
#[cfg(target_endian = "little")]
#[inline(always)]
pub(crate) unsafe fn four_at_once(
    _: <wide::f32x4 as Lanes>::Level,
    from: *const Shorts,
    place: impl Fn(usize) -> [usize; 2],
    t: wide::f32x4,
) -> [wide::f32x4; 4] {
    use wide::{f32x4, i16x8, i32x4, u32x4};
    let (zero, one) = (f32x4::ZERO, f32x4::ONE);
    let t = t.simd_gt(zero).select(t, zero);
    let t = t.simd_lt(one).select(t, one);
    // 2¹⁴t is in the last bits of the sum, as above; the other weight stands before it.
    let to: u32x4 = bytemuck::cast(t * f32x4::splat(16384.0) + f32x4::splat(12_582_912.0));
    let low = u32x4::splat(0xffff);
    let weights = ((u32x4::splat(16384) - (to & low)) & low) | (to << 16);
    let weights: i16x8 = bytemuck::cast(weights);
    // In each row both records of a lane: a₀a₁, a₂a₃, b₀b₁, b₂b₃.
    let mut rows = [f32x4::ZERO; 4];
    for (lane, row) in rows.iter_mut().enumerate() {
        // SAFETY: promised.
        *row = bytemuck::cast(place(lane).map(|place| unsafe { *from.add(place) }));
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
