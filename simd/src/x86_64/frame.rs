//! The alignment of the stack slots to which vector registers are spilled.

use core::hint::black_box;

/// Aligns the stack frame of the caller, to which vector registers are spilled, to a cache line.
///
/// Without this, the stack slots have the alignment that the stack happens to have. A slot that
/// crosses from one cache line or page to the next makes kernels that spill in their loops 2 to 4
/// times slower, at random from run to run.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn align_frame() {
    #[repr(align(64))]
    struct CacheLine(#[allow(dead_code, reason = "only its address matters")] u8);
    // The variable is borrowed mutably, so it must be on the stack. If it were only read, the
    // compiler could put it in static memory.
    let mut local = CacheLine(0);
    black_box(&mut local);
}
