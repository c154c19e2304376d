//! Prefetches of memory that will be needed soon.

use core::arch::x86_64::*;

/// The size of a cache line in bytes, which is the same on every x86-64 CPU with these levels.
const LINE: usize = 64;

/// Implements [`Level::prefetch`](crate::Level::prefetch): prefetches `value`, a cache line at a
/// time.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn prefetch<T>(value: &T) {
    let start = core::ptr::from_ref(value).cast::<i8>();
    for offset in (0..size_of::<T>()).step_by(LINE) {
        // SAFETY: `offset` is less than the size of `T`, so the address is inside of `value`. Every
        // x86-64 CPU has SSE, which the prefetch needs.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(start.add(offset)) };
    }
}

/// Implements [`Level::prefetch_every`](crate::Level::prefetch_every): prefetches the first cache
/// line of elements 0, `stride`, `2 · stride` and so on, `count` elements altogether.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn prefetch_every<T>(memory: &[T], stride: usize, count: usize) {
    for index in 0..count {
        let address = memory.as_ptr().wrapping_add(index.wrapping_mul(stride));
        // SAFETY: every x86-64 CPU has SSE, which the prefetch needs. A prefetch returns no data
        // and faults at no address, so the address may be outside of `memory`.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(address.cast()) };
    }
}
