//! Loads and stores of two lanes of `f64`.

use core::arch::aarch64::*;
use core::mem::transmute;
use wide::f64x2;

/// Implements [`Lanes::load_quads`](crate::Lanes::load_quads).
///
/// # Safety
/// For each lane, the four `f64` from `from + offset(lane)` on must be readable.
#[inline(always)]
pub(crate) unsafe fn load_quads(from: *const f64, offset: impl Fn(usize) -> usize) -> [f64x2; 4] {
    // SAFETY: each load reads two of the four `f64` from `from + offset(lane)` on, for lane 0 or 1,
    // which the caller guarantees to be readable. All registers have 128 bits, so both types of the
    // transmute have the same size.
    unsafe {
        let (a, b) = (from.add(offset(0)), from.add(offset(1)));
        let (xy_a, zw_a) = (vld1q_f64(a), vld1q_f64(a.add(2)));
        let (xy_b, zw_b) = (vld1q_f64(b), vld1q_f64(b.add(2)));
        transmute([
            vzip1q_f64(xy_a, xy_b),
            vzip2q_f64(xy_a, xy_b),
            vzip1q_f64(zw_a, zw_b),
            vzip2q_f64(zw_a, zw_b),
        ])
    }
}

/// Implements [`Lanes::store_quads`](crate::Lanes::store_quads).
///
/// # Safety
/// For each lane, the four `f64` from `to + lane · stride` on must be writable, and no other
/// thread may use them during the call.
#[inline(always)]
pub(crate) unsafe fn store_quads(components: [f64x2; 4], to: *mut f64, stride: usize) {
    // SAFETY: each store writes two of the four `f64` from `to + lane · stride` on, for lane 0 or
    // 1, which the caller guarantees to be writable. All registers have 128 bits, so both types of
    // the transmute have the same size.
    unsafe {
        let [x, y, z, w]: [float64x2_t; 4] = transmute(components);
        vst1q_f64(to, vzip1q_f64(x, y));
        vst1q_f64(to.add(2), vzip1q_f64(z, w));
        vst1q_f64(to.add(stride), vzip2q_f64(x, y));
        vst1q_f64(to.add(stride + 2), vzip2q_f64(z, w));
    }
}

/// Implements [`Lanes::store_triples`](crate::Lanes::store_triples).
///
/// # Safety
/// The six `f64` from `to` on must be writable, and no other thread may use them during the call.
#[inline(always)]
pub(crate) unsafe fn store_triples(components: [f64x2; 3], to: *mut f64) {
    // SAFETY: `vst3q_f64` writes the six `f64` that the caller guarantees to be writable, and both
    // types of the transmute are three registers.
    unsafe { vst3q_f64(to, transmute::<[f64x2; 3], float64x2x3_t>(components)) };
}

/// Implements [`Lanes::store_adjoining`](crate::Lanes::store_adjoining) for records of two
/// components. Records of three components are stored by [`store_triples`].
///
/// # Safety
/// The `2 · C` floats from `to` on must be writable, and no other thread may use them during the
/// call.
#[inline(always)]
pub(crate) unsafe fn store_adjoining<const C: usize>(components: [f64x2; C], to: *mut f64) -> bool {
    if C != 2 {
        return false;
    }
    // SAFETY: C is two here, so `components` is two registers, and `vst2q_f64` writes the four
    // `f64` that the caller guarantees to be writable.
    unsafe { vst2q_f64(to, components.as_ptr().cast::<float64x2x2_t>().read()) };
    true
}

/// Implements [`Lanes::load_adjoining`](crate::Lanes::load_adjoining). Records of four components
/// load as quickly by shuffles, so the function returns `None` for them.
///
/// # Safety
/// The `2 · C` floats from `from` on must be readable.
#[inline(always)]
pub(crate) unsafe fn load_adjoining<const C: usize>(from: *const f64) -> Option<[f64x2; C]> {
    let mut to = [f64x2::ZERO; C];
    let at = to.as_mut_ptr();
    // SAFETY: each arm loads two records of C components, which the caller guarantees to be
    // readable, and writes them to `to`, whose C vectors are C registers.
    unsafe {
        match C {
            2 => at.cast::<float64x2x2_t>().write(vld2q_f64(from)),
            3 => at.cast::<float64x2x3_t>().write(vld3q_f64(from)),
            _ => return None,
        }
    }
    Some(to)
}
