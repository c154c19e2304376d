//! Loads and stores of four lanes of `f32`. There is no `load_quads` and no `store_quads` here: the
//! transpose of `wide` takes the fewest shuffles, and the compiler merges a quarter of the shuffles
//! with the stores (`st2`).

use core::arch::aarch64::*;
use core::arch::asm;
use core::mem::transmute;
use wide::f32x4;

/// Implements [`Lanes::store_triples`](crate::Lanes::store_triples).
///
/// # Safety
/// The twelve `f32` from `to` on must be writable, and no other thread may use them during the
/// call.
#[inline(always)]
pub(crate) unsafe fn store_triples(components: [f32x4; 3], to: *mut f32) {
    // SAFETY: `vst3q_f32` writes the twelve `f32` that the caller guarantees to be writable, and
    // both types of the transmute are three registers.
    unsafe { vst3q_f32(to, transmute::<[f32x4; 3], float32x4x3_t>(components)) };
}

/// Implements [`Lanes::store_adjoining`](crate::Lanes::store_adjoining) for records of two
/// components. Records of three components are stored by [`store_triples`].
///
/// # Safety
/// The `4 · C` floats from `to` on must be writable, and no other thread may use them during the
/// call.
#[inline(always)]
pub(crate) unsafe fn store_adjoining<const C: usize>(components: [f32x4; C], to: *mut f32) -> bool {
    if C != 2 {
        return false;
    }
    // SAFETY: C is two here, so `components` is two registers, and `vst2q_f32` writes the eight
    // `f32` that the caller guarantees to be writable.
    unsafe { vst2q_f32(to, components.as_ptr().cast::<float32x4x2_t>().read()) };
    true
}

/// Implements [`Lanes::sum_quads`](crate::Lanes::sum_quads). Pairs of lanes are joined before they
/// are added, which takes half as many shuffles as a transpose of all four vectors.
#[inline(always)]
pub(crate) fn sum_quads(vectors: [f32x4; 4]) -> f32x4 {
    // SAFETY: this module is compiled only for targets with NEON, and all registers have 128 bits,
    // so the transmutes keep the size.
    unsafe {
        let [a, b, c, d] = transmute::<[f32x4; 4], [float64x2_t; 4]>(vectors);
        // a₀+a₂ a₁+a₃ b₀+b₂ b₁+b₃
        let sums = |a, b| {
            let halves = [vzip1q_f64(a, b), vzip2q_f64(a, b)];
            let [first, last] = transmute::<[float64x2_t; 2], [float32x4_t; 2]>(halves);
            vaddq_f32(first, last)
        };
        let (ab, cd) = (sums(a, b), sums(c, d));
        // The instruction adds neighbouring lanes. It is written as assembly because the compiler
        // replaces the intrinsic `vpaddq_f32` by shuffles, which it merges with those above to
        // twice as many.
        let sum: float32x4_t;
        asm!("faddp {0:v}.4s, {1:v}.4s, {2:v}.4s", out(vreg) sum, in(vreg) ab, in(vreg) cd,
            options(pure, nomem, nostack, preserves_flags));
        transmute::<float32x4_t, f32x4>(sum)
    }
}

/// Implements [`Lanes::load_adjoining`](crate::Lanes::load_adjoining).
///
/// # Safety
/// The `4 · C` floats from `from` on must be readable.
#[inline(always)]
pub(crate) unsafe fn load_adjoining<const C: usize>(from: *const f32) -> Option<[f32x4; C]> {
    let mut to = [f32x4::ZERO; C];
    let at = to.as_mut_ptr();
    // SAFETY: each arm loads four records of C components, which the caller guarantees to be
    // readable, and writes them to `to`, whose C vectors are C registers.
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
