//! What the CPU has, found once and remembered; also without std.

use core::arch::x86_64::__cpuid;
use core::sync::atomic::{AtomicU8, Ordering};

cpufeatures::new!(avx2_and_fma, "avx2", "fma");
cpufeatures::new!(avx512_f_vl_dq, "avx2", "fma", "avx512f", "avx512vl", "avx512dq");

/// AVX2 and FMA, and an operating system that keeps their registers.
#[inline]
pub(crate) fn avx2() -> bool {
    avx2_and_fma::get()
}

/// AVX-512 F, VL and DQ, and an operating system that keeps their registers.
#[inline]
pub(crate) fn avx512() -> bool {
    avx512_f_vl_dq::get()
}

/// Whether 512 bits are shuffled as quickly as 256: on AMD's CPUs. Intel's have one port for that,
/// and two for 256 bits.
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
    // In later releases of Rust this is safe.
    #[allow(unused_unsafe, reason = "it is unsafe in the oldest that is promised")]
    // SAFETY: every x86-64 CPU has the instruction and this leaf.
    let maker = unsafe { __cpuid(0) };
    [maker.ebx, maker.edx, maker.ecx].map(u32::to_le_bytes) == [*b"Auth", *b"enti", *b"cAMD"]
}
