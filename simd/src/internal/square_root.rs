//! The square root of one number, which `core` does not have: the instruction where there is one.

/// Whether the narrowest vector of `wide` has the instruction: wherever there are vectors, and on
/// all targets with `std`. Without both, `wide` computes with `f64` in integers.
pub(crate) const VECTORS: bool = cfg!(any(
    not(feature = "libm"),
    feature = "std",
    target_feature = "sse2",
    all(target_arch = "aarch64", target_feature = "neon"),
    target_feature = "simd128"
));

/// √`value`, correctly rounded; NaN below zero.
#[inline(always)]
#[must_use]
pub fn f32(value: f32) -> f32 {
    #[cfg(feature = "libm")]
    if !VECTORS {
        return without_vectors::f32(value);
    }
    wide::f32x4::splat(value).sqrt().to_array()[0]
}

/// √`value`, correctly rounded; NaN below zero.
#[inline(always)]
#[must_use]
pub fn f64(value: f64) -> f64 {
    #[cfg(feature = "libm")]
    if !VECTORS {
        return without_vectors::f64(value);
    }
    wide::f64x2::splat(value).sqrt().to_array()[0]
}

/// `libm` stays with `f32`, and some targets have the instruction.
#[cfg(feature = "libm")]
mod without_vectors {
    /// All FPUs whose registers carry arguments have this one, from the Cortex-M4F on.
    #[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
    #[inline(always)]
    pub(super) fn f32(value: f32) -> f32 {
        let root: f32;
        // SAFETY: the target passes floats in FPU registers, so there is an FPU, and each has a
        // square root in single precision. Nothing but the registers named here is read or written.
        unsafe {
            core::arch::asm!(
                // By way of a core register, because the compiler takes an FPU without double
                // precision for none when it looks for a register of it (`sreg`).
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
    // Double precision is not for every FPU (Cortex-M4F), and no stable `cfg` tells.
    pub(super) use libm::sqrt as f64;
}
