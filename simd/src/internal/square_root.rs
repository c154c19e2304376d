//! The square root of one float, which `core` does not have. It compiles to one instruction on
//! targets that have a square root instruction.

/// True if `wide` computes the square root of a vector quickly: by an instruction of the target, or
/// by `std`. On other targets `wide` computes it in `f64` by operations on integers.
pub(crate) const VECTORS: bool = cfg!(any(
    not(feature = "libm"),
    feature = "std",
    target_feature = "sse2",
    all(target_arch = "aarch64", target_feature = "neon"),
    target_feature = "simd128"
));

/// Returns √`value`, correctly rounded. The root is NaN if `value` is below zero.
#[inline(always)]
#[must_use]
pub fn f32(value: f32) -> f32 {
    #[cfg(feature = "libm")]
    if !VECTORS {
        return without_vectors::f32(value);
    }
    wide::f32x4::splat(value).sqrt().to_array()[0]
}

/// Returns √`value`, correctly rounded. The root is NaN if `value` is below zero.
#[inline(always)]
#[must_use]
pub fn f64(value: f64) -> f64 {
    #[cfg(feature = "libm")]
    if !VECTORS {
        return without_vectors::f64(value);
    }
    wide::f64x2::splat(value).sqrt().to_array()[0]
}

/// Square roots for targets without vectors. `libm` computes the root of an `f32` in `f32`, and not
/// in `f64` as `wide` does.
#[cfg(feature = "libm")]
mod without_vectors {
    /// Returns √`value` by the instruction `vsqrt.f32`, which every Arm FPU has that passes
    /// arguments in its registers, from the Cortex-M4F on.
    #[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
    #[inline(always)]
    pub(super) fn f32(value: f32) -> f32 {
        let root: f32;
        // SAFETY: `target_abi = "eabihf"` passes floats in FPU registers, so the target has an FPU,
        // and every such FPU has `vsqrt.f32`. The operands name every register that the code uses.
        unsafe {
            core::arch::asm!(
                // The value is moved through a core register, because the compiler offers no FPU
                // registers (`sreg`) as operands if the FPU has no double precision.
                "vmov s0, {value}",
                "vsqrt.f32 s0, s0",
                "vmov {root}, s0",
                value = in(reg) value,
                root = lateout(reg) root,
                out("s0") _,
                options(pure, nomem, nostack),
            );
        }
        root
    }
    #[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
    pub(super) use libm::sqrtf as f32;
    // Some FPUs, such as that of the Cortex-M4F, have no double precision. No stable `cfg` tells
    // these FPUs from FPUs with double precision, so `libm` computes the root of an `f64`.
    pub(super) use libm::sqrt as f64;
}
