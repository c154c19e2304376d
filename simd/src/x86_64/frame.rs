//! The place of vector registers on the stack.

use core::hint::black_box;

/// Aligns the stack frame of the caller, in which vector registers are spilled, to a cache line.
///
/// Without this, the compiler spills to wherever the stack happens to be. A slot across two cache
/// lines or two pages makes kernels that spill in their loops 2 to 4 times slower, at random from
/// run to run.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn align_frame() {
    #[repr(align(64))]
    struct CacheLine(#[allow(dead_code, reason = "only its address matters")] u8);
    // The local is mutable, so that it must be on the stack: the compiler would make a static of a
    // constant that is only read.
    let mut local = CacheLine(0);
    black_box(&mut local);
}
