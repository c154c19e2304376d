//! The detection of the CPU's instructions. The first call asks the CPU, and later calls read a
//! static. No std is needed.

use core::arch::x86_64::__cpuid;
use core::sync::atomic::{AtomicU8, Ordering};

cpufeatures::new!(avx2_and_fma, "avx2", "fma");
cpufeatures::new!(avx512_f_vl_dq, "avx2", "fma", "avx512f", "avx512vl", "avx512dq");

/// Returns true if the CPU has AVX2 and FMA, and the operating system saves their registers.
#[inline]
pub(crate) fn avx2() -> bool {
    avx2_and_fma::get()
}

/// Returns true if the CPU has AVX-512 F, VL and DQ, and the operating system saves their
/// registers.
#[inline]
pub(crate) fn avx512() -> bool {
    avx512_f_vl_dq::get()
}

/// Returns true if the CPU shuffles 512 bits as quickly as 256 bits, as AMD's CPUs do. Intel's CPUs
/// have one port for shuffles of 512 bits, but two for shuffles of 256 bits.
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
    // Later releases of Rust made `__cpuid` safe.
    #[allow(unused_unsafe, reason = "unsafe in the oldest supported release")]
    // SAFETY: every x86-64 CPU has the instruction `cpuid` with leaf 0, which writes only the
    // registers that `__cpuid` returns.
    let maker = unsafe { __cpuid(0) };
    [maker.ebx, maker.edx, maker.ecx].map(u32::to_le_bytes) == [*b"Auth", *b"enti", *b"cAMD"]
}
