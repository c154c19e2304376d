//! What the CPU has, found once and remembered; also without std.

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
