//! Four lanes of `f32`. Quads are transposed by `wide`, in the fewest shuffles, of which the
//! compiler merges a quarter with their stores (`st2`).

use core::arch::aarch64::*;
use core::mem::transmute;
use wide::f32x4;

/// Implements [`Lanes::store_triples`](crate::Lanes::store_triples).
///
/// # Safety
/// The caller must keep the conditions of that method.
#[inline(always)]
pub(crate) unsafe fn store_triples(components: [f32x4; 3], to: *mut f32) {
    // SAFETY: the caller guarantees that the numbers are writable; the types have the same
    // registers.
    unsafe { vst3q_f32(to, transmute::<[f32x4; 3], float32x4x3_t>(components)) };
}

/// Implements [`Lanes::store_adjoining`](crate::Lanes::store_adjoining) for two components.
/// `store_triples` stores three.
///
/// # Safety
/// The caller must keep the conditions of that method.
#[inline(always)]
pub(crate) unsafe fn store_adjoining<const C: usize>(components: [f32x4; C], to: *mut f32) -> bool {
    if C != 2 {
        return false;
    }
    // SAFETY: the caller guarantees that the numbers are writable. There are two components, which
    // are two registers.
    unsafe { vst2q_f32(to, components.as_ptr().cast::<float32x4x2_t>().read()) };
    true
}

/// Implements [`Lanes::load_adjoining`](crate::Lanes::load_adjoining).
///
/// # Safety
/// The caller must keep the conditions of that method.
#[inline(always)]
pub(crate) unsafe fn load_adjoining<const C: usize>(from: *const f32) -> Option<[f32x4; C]> {
    let mut to = [f32x4::ZERO; C];
    let at = to.as_mut_ptr();
    // SAFETY: the caller guarantees that four records of C numbers are readable, and `to` has C
    // vectors, which are registers.
    unsafe {
        match C {
            2 => at.cast::<float32x4x2_t>().write(vld2q_f32(from)),
            3 => at.cast::<float32x4x3_t>().write(vld3q_f32(from)),
            4 => at.cast::<float32x4x4_t>().write(vld4q_f32(from)),
            _ => return None,
        }
    }
    Some(to)
}
