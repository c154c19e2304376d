//! Loads and stores of records of two and three `f32` for the four lanes of
//! [`Portable`](crate::Portable), by shuffles of SSE2.

use super::quads::{f32x4_load_triples, f32x4_store_triples};
use core::arch::x86_64::*;
use core::mem::transmute;
use wide::f32x4;

/// Implements [`Lanes::store_triples`](crate::Lanes::store_triples).
///
/// # Safety
/// The twelve `f32` from `to` on must be writable, and no other thread may use them during the
/// call.
#[inline(always)]
pub(crate) unsafe fn store_triples(components: [f32x4; 3], to: *mut f32) {
    // SAFETY: every x86-64 CPU has SSE2, an `f32x4` is one of its registers, and the caller
    // guarantees that the twelve `f32` are writable.
    unsafe { f32x4_store_triples(transmute::<[f32x4; 3], [__m128; 3]>(components), to) };
}

/// Implements [`Lanes::store_adjoining`](crate::Lanes::store_adjoining) for records of two
/// components. Records of three components are stored by [`store_triples`].
///
/// # Safety
/// The `4 · C` floats from `to` on must be writable, and no other thread may use them during the
/// call.
#[inline(always)]
pub(crate) unsafe fn store_adjoining<const C: usize>(components: [f32x4; C], to: *mut f32) -> bool {
    let &[x, y] = components.as_slice() else { return false };
    // SAFETY: every x86-64 CPU has SSE2, an `f32x4` is one of its registers, and the caller
    // guarantees that eight `f32` are writable for the two components.
    unsafe {
        let [x, y] = transmute::<[f32x4; 2], [__m128; 2]>([x, y]);
        _mm_storeu_ps(to, _mm_unpacklo_ps(x, y));
        _mm_storeu_ps(to.add(4), _mm_unpackhi_ps(x, y));
    }
    true
}

/// Implements [`Lanes::load_adjoining`](crate::Lanes::load_adjoining) for records of two and three
/// components.
///
/// # Safety
/// The `4 · C` floats from `from` on must be readable.
#[inline(always)]
pub(crate) unsafe fn load_adjoining<const C: usize>(from: *const f32) -> Option<[f32x4; C]> {
    let mut to = [f32x4::ZERO; C];
    // SAFETY: every x86-64 CPU has SSE2, an `f32x4` is one of its registers, and the caller
    // guarantees that four records of C components are readable.
    unsafe {
        match to.as_mut_slice() {
            [x, y] => {
                let (a, b) = (_mm_loadu_ps(from), _mm_loadu_ps(from.add(4))); // x₀ y₀ x₁ y₁, …
                *x = transmute::<__m128, f32x4>(_mm_shuffle_ps::<0b10_00_10_00>(a, b));
                *y = transmute::<__m128, f32x4>(_mm_shuffle_ps::<0b11_01_11_01>(a, b));
            }
            [x, y, z] => {
                [*x, *y, *z] = transmute::<[__m128; 3], [f32x4; 3]>(f32x4_load_triples(from));
            }
            _ => return None,
        }
    }
    Some(to)
}
