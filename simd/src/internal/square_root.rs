//! The square root of one float, which `core` does not have. It compiles to one instruction on
//! targets that have one.

/// True if the square root of a vector of `wide` is quick, which is so if the target has vectors or
/// `std`. Otherwise `wide` computes it in `f64`, with integers.
pub(crate) const VECTORS: bool = cfg!(any(
    not(feature = "libm"),
    feature = "std",
    target_feature = "sse2",
    all(target_arch = "aarch64", target_feature = "neon"),
    target_feature = "simd128"
));

/// √`value`, correctly rounded. Below zero it is NaN.
#[inline(always)]
#[must_use]
pub fn f32(value: f32) -> f32 {
    #[cfg(feature = "libm")]
    if !VECTORS {
        return without_vectors::f32(value);
    }
    wide::f32x4::splat(value).sqrt().to_array()[0]
}

/// √`value`, correctly rounded. Below zero it is NaN.
#[inline(always)]
#[must_use]
pub fn f64(value: f64) -> f64 {
    #[cfg(feature = "libm")]
    if !VECTORS {
        return without_vectors::f64(value);
    }
    wide::f64x2::splat(value).sqrt().to_array()[0]
}

/// Square roots for targets without vectors. `libm` computes that of an `f32` in `f32`.
#[cfg(feature = "libm")]
mod without_vectors {
    /// √`value`. Every Arm FPU whose registers pass arguments has the instruction, from the
    /// Cortex-M4F on.
    #[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
    #[inline(always)]
    pub(super) fn f32(value: f32) -> f32 {
        let root: f32;
        // SAFETY: the target passes floats in FPU registers, so it has an FPU, and each of these
        // has a square root in single precision. Only the registers named here are read or written.
        unsafe {
            core::arch::asm!(
                // The number goes through a core register: the compiler offers no FPU registers
                // (`sreg`) if the FPU has no double precision.
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
    // Some FPUs, as the Cortex-M4F's, have no double precision, and no stable `cfg` tells which.
    pub(super) use libm::sqrt as f64;
}
