//! Detection of the CPU's instructions, which is done once and remembered. It needs no std.

use core::arch::x86_64::__cpuid;
use core::sync::atomic::{AtomicU8, Ordering};

cpufeatures::new!(avx2_and_fma, "avx2", "fma");
cpufeatures::new!(avx512_f_vl_dq, "avx2", "fma", "avx512f", "avx512vl", "avx512dq");

/// True if the CPU has AVX2 and FMA, and the operating system saves their registers.
#[inline]
pub(crate) fn avx2() -> bool {
    avx2_and_fma::get()
}

/// True if the CPU has AVX-512 F, VL and DQ, and the operating system saves their registers.
#[inline]
pub(crate) fn avx512() -> bool {
    avx512_f_vl_dq::get()
}

/// True if the CPU shuffles 512 bits as quickly as 256, as AMD's CPUs do. Intel's have one port for
/// shuffles of 512 bits, and two for 256.
#[inline]
pub(crate) fn shuffles_wide() -> bool {
    static KNOWN: AtomicU8 = AtomicU8::new(UNKNOWN);
    const UNKNOWN: u8 = 2;
    match KNOWN.load(Ordering::Relaxed) {
        UNKNOWN => {
            let amd = is_amd();
            KNOWN.store(amd.into(), Ordering::Relaxed);
            amd
        }
        known => known == 1,
    }
}

#[cold]
fn is_amd() -> bool {
    // Later releases of Rust made this function safe.
    #[allow(unused_unsafe, reason = "unsafe in the oldest supported release")]
    // SAFETY: every x86-64 CPU has the instruction `cpuid`, and leaf 0.
    let maker = unsafe { __cpuid(0) };
    [maker.ebx, maker.edx, maker.ecx].map(u32::to_le_bytes) == [*b"Auth", *b"enti", *b"cAMD"]
}
