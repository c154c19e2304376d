//! [`PackedDualQuat`]: one dual quaternion in two registers of `f32`, or in four registers of
//! `f64`.

use crate::lanes::PackedDualQuat;
use core::arch::aarch64::*;
use core::arch::asm;
use core::mem::transmute;
use wide::{f32x8, f64x8};

/// The sign bits of the columns c₀ = (w, z, −y, −x), c₁ = (−z, w, x, −y) and c₂ = (y,
/// −x, w, −z) of [`PackedDualQuat::columns`], for `f32`.
const SINGLE: [[u32; 4]; 3] = {
    const MINUS: u32 = 1 << 31;
    [[0, 0, MINUS, MINUS], [MINUS, 0, 0, MINUS], [0, MINUS, 0, MINUS]]
};
/// The sign bits of the columns c₀, c₁ and c₂ of [`PackedDualQuat::columns`], for `f64`.
const DOUBLE: [[u64; 4]; 3] = {
    const MINUS: u64 = 1 << 63;
    [[0, 0, MINUS, MINUS], [MINUS, 0, 0, MINUS], [0, MINUS, 0, MINUS]]
};

/// Returns [`SINGLE`] in registers.
#[inline(always)]
fn signs() -> [uint32x4_t; 3] {
    // SAFETY: both types have the same size, and any bits are valid for integers.
    let mut signs = unsafe { transmute::<[[u32; 4]; 3], [uint32x4_t; 3]>(SINGLE) };
    // The assembly hides the constants from the compiler, which then loads them into registers
    // once. Without it, the compiler would fold the sign changes into other operations and load two
    // of the constants again for every product.
    for row in &mut signs {
        // SAFETY: the assembly is a comment without an instruction, so it changes no register or
        // memory.
        unsafe {
            asm!("/* {0:v} */", inout(vreg) * row, options(pure, nomem, nostack, preserves_flags));
        }
    }
    signs
}

impl PackedDualQuat for f32x8 {
    #[inline(always)]
    fn splat_each(_: Self::Level, from: &[f32; 8]) -> [Self; 8] {
        // SAFETY: this module is compiled only for targets with NEON. The loads read the first and
        // the last four of the array's eight `f32`, and an `f32x8` has the size of two registers.
        unsafe {
            let (p, q) = (vld1q_f32(from.as_ptr()), vld1q_f32(from.as_ptr().add(4)));
            let twice = |one: float32x4_t| transmute::<[float32x4_t; 2], Self>([one, one]);
            [
                twice(vdupq_laneq_f32::<0>(p)),
                twice(vdupq_laneq_f32::<1>(p)),
                twice(vdupq_laneq_f32::<2>(p)),
                twice(vdupq_laneq_f32::<3>(p)),
                twice(vdupq_laneq_f32::<0>(q)),
                twice(vdupq_laneq_f32::<1>(q)),
                twice(vdupq_laneq_f32::<2>(q)),
                twice(vdupq_laneq_f32::<3>(q)),
            ]
        }
    }
    #[inline(always)]
    fn columns(self) -> [Self; 4] {
        let [s, t, u] = signs();
        // SAFETY: this module is compiled only for targets with NEON, and an `f32x8` has the size
        // of two registers, so the transmutes keep the size.
        unsafe {
            let [p, q]: [uint32x4_t; 2] = transmute(self);
            let join = |p, q| transmute::<[uint32x4_t; 2], Self>([p, q]);
            let (yxwz_p, yxwz_q) = (vrev64q_u32(p), vrev64q_u32(q));
            let swapped = |v| vextq_u32::<2>(v, v);
            [
                join(veorq_u32(swapped(yxwz_p), s), veorq_u32(swapped(yxwz_q), s)),
                join(veorq_u32(swapped(p), t), veorq_u32(swapped(q), t)),
                join(veorq_u32(yxwz_p, u), veorq_u32(yxwz_q, u)),
                self,
            ]
        }
    }
}

impl PackedDualQuat for f64x8 {
    #[inline(always)]
    fn columns(self) -> [Self; 4] {
        // SAFETY: this module is compiled only for targets with NEON, and an `f64x8` has the size
        // of four registers, so the transmutes keep the size.
        unsafe {
            let [p_xy, p_zw, q_xy, q_zw]: [uint64x2_t; 4] = transmute(self);
            let swapped = |v| vextq_u64::<1>(v, v);
            let [p_yx, p_wz, q_yx, q_wz] =
                [swapped(p_xy), swapped(p_zw), swapped(q_xy), swapped(q_zw)];
            let signed = |[a, b, c, d]: [uint64x2_t; 4], signs: [u64; 4]| {
                let [s, t] = transmute::<[u64; 4], [uint64x2_t; 2]>(signs);
                let signed = [veorq_u64(a, s), veorq_u64(b, t), veorq_u64(c, s), veorq_u64(d, t)];
                transmute::<[uint64x2_t; 4], Self>(signed)
            };
            [
                signed([p_wz, p_yx, q_wz, q_yx], DOUBLE[0]),
                signed([p_zw, p_xy, q_zw, q_xy], DOUBLE[1]),
                signed([p_yx, p_wz, q_yx, q_wz], DOUBLE[2]),
                self,
            ]
        }
    }
}
