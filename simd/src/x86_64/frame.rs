use core::hint::black_box;

/// Makes the frame of the caller, a function with vector registers to spill, start at a cache line.
///
/// Left to itself, the compiler spills to wherever the stack happens to be. A slot that lies across
/// two cache lines, or two pages, makes kernels that spill in their loops 2 to 4 times slower, at
/// random from run to run.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn align_frame() {
    #[repr(align(64))]
    struct CacheLine(#[allow(dead_code, reason = "only its place matters")] u8);
    // A local that something may write to has to be where its alignment says. (A constant that is
    // only looked at would become a static.)
    let mut local = CacheLine(0);
    black_box(&mut local);
}
