//! What is true of all functions here: places become slices.

use std::slice;

/// # Safety
/// So many things are there, or `count` is 0.
pub(crate) unsafe fn slice<'a, T>(at: *const T, count: usize) -> &'a [T] {
    // SAFETY: promised.
    if count == 0 { &[] } else { unsafe { slice::from_raw_parts(at, count) } }
}

/// # Safety
/// As for [`slice`], and nothing else refers to them.
pub(crate) unsafe fn slice_mut<'a, T>(at: *mut T, count: usize) -> &'a mut [T] {
    // SAFETY: promised.
    if count == 0 { &mut [] } else { unsafe { slice::from_raw_parts_mut(at, count) } }
}

/// Exports functions of numbers, then slices that are read, then slices that are written: each
/// slice as its place and its count. The only caller is the package, which has made and measured
/// all of them.
macro_rules! exports {
    ($($(#[$doc:meta])* fn $name:ident(
        $($argument:ident: $Argument:ty),*; $($read:ident[$reads:ident]: $Read:ty),*; $($write:ident[$writes:ident]: $Write:ty),*
    ) -> $Out:ty $body:block)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// All that is named is there, and what is written lies apart from all else.
        #[unsafe(no_mangle)]
        unsafe extern "C" fn $name(
            $($argument: $Argument,)* $($read: *const $Read, $reads: usize,)* $($write: *mut $Write, $writes: usize),*
        ) -> $Out {
            $(
                // SAFETY: promised.
                let $read = unsafe { crate::memory::slice($read, $reads) };
            )*
            $(
                // SAFETY: promised.
                let $write = unsafe { crate::memory::slice_mut($write, $writes) };
            )*
            $body
        }
    )*};
}
pub(crate) use exports;

/// Exports functions that drop what has been made.
macro_rules! frees {
    ($($name:ident: $Thing:ty),*) => {$(
        /// # Safety
        /// It has been made, and is not used any more.
        #[unsafe(no_mangle)]
        unsafe extern "C" fn $name(thing: *mut $Thing) {
            // SAFETY: promised.
            drop(unsafe { Box::from_raw(thing) });
        }
    )*};
}
pub(crate) use frees;
