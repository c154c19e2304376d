//! Prefetches of memory that will be needed soon.

use core::arch::x86_64::*;

/// The size of a cache line in bytes, which is the same on every x86-64 CPU with these levels.
const LINE: usize = 64;

/// See [`Level::prefetch`](crate::Level::prefetch).
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn prefetch<T>(value: &T) {
    let start = core::ptr::from_ref(value).cast::<i8>();
    for offset in (0..size_of::<T>()).step_by(LINE) {
        // SAFETY: every x86-64 CPU has SSE, the address is inside of `value`, and nothing is read.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(start.add(offset)) };
    }
}

/// See [`Level::prefetch_every`](crate::Level::prefetch_every).
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn prefetch_every<T>(memory: &[T], stride: usize, count: usize) {
    for index in 0..count {
        let address = memory.as_ptr().wrapping_add(index.wrapping_mul(stride));
        // SAFETY: every x86-64 CPU has SSE, and a prefetch reads nothing and fails at no address.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(address.cast()) };
    }
}
