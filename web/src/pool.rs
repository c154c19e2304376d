//! Memory of arrays alone. What has been an array is given to arrays again and to nothing else: a
//! view of JavaScript that outlives its array can write into another array, and never into what has
//! been checked. The list of free places lies in memory of Rust's, where no view of an array
//! reaches.

use std::cell::RefCell;
use std::slice;

/// Blocks of lanes need the most.
const ALIGNMENT: usize = 64;
const PAGE: usize = 1 << 16;

/// Free ranges, by their place; no two touch.
struct Pool(Vec<(usize, usize)>);

thread_local!(static POOL: RefCell<Pool> = const { RefCell::new(Pool(Vec::new())) });

/// So many pages from the engine, which Rust's allocator will not see.
fn grow(pages: usize) -> Option<usize> {
    #[cfg(target_arch = "wasm32")]
    let before = std::arch::wasm32::memory_grow::<0>(pages);
    #[cfg(not(target_arch = "wasm32"))]
    let before = {
        let _ = pages;
        usize::MAX
    };
    (before != usize::MAX).then(|| before * PAGE)
}

/// What an array takes; `None` if no memory has so much.
fn rounded(bytes: usize) -> Option<usize> {
    let rounded = bytes.max(1).checked_add(ALIGNMENT - 1)? / ALIGNMENT * ALIGNMENT;
    (rounded <= isize::MAX as usize).then_some(rounded)
}

impl Pool {
    /// Takes from the smallest range that is large enough, so that large ones are kept.
    fn take(&mut self, bytes: usize) -> Option<usize> {
        let fits = self.0.iter().enumerate().filter(|(_, range)| range.1 >= bytes);
        let (index, &(at, length)) = fits.min_by_key(|(_, range)| range.1)?;
        if length == bytes {
            self.0.remove(index);
        } else {
            self.0[index] = (at + bytes, length - bytes);
        }
        Some(at)
    }

    fn put(&mut self, at: usize, bytes: usize) {
        let next = self.0.partition_point(|range| range.0 < at);
        let touches_next = self.0.get(next).is_some_and(|range| at + bytes == range.0);
        let before =
            next.checked_sub(1).filter(|&before| self.0[before].0 + self.0[before].1 == at);
        match (before, touches_next) {
            (Some(before), true) => {
                self.0[before].1 += bytes + self.0[next].1;
                self.0.remove(next);
            }
            (Some(before), false) => self.0[before].1 += bytes,
            (None, true) => self.0[next] = (at, bytes + self.0[next].1),
            (None, false) => self.0.insert(next, (at, bytes)),
        }
    }

    fn allocate(&mut self, bytes: usize) -> Option<usize> {
        if let Some(at) = self.take(bytes) {
            return Some(at);
        }
        // A range at the end of memory need not be left over.
        let pages = bytes.div_ceil(PAGE);
        let at = grow(pages)?;
        self.put(at, pages * PAGE);
        self.take(bytes)
    }
}

/// So many bytes, all zero; null if they are not to be had.
#[unsafe(no_mangle)]
extern "C" fn dq8_allocate(bytes: usize) -> *mut u8 {
    let Some(bytes) = rounded(bytes) else { return std::ptr::null_mut() };
    let Some(at) = POOL.with_borrow_mut(|pool| pool.allocate(bytes)) else {
        return std::ptr::null_mut();
    };
    let at = std::ptr::with_exposed_provenance_mut::<u8>(at);
    // SAFETY: the bytes are inside of memory, are at most `isize::MAX`, and the pool has given them
    // to nobody else.
    unsafe { slice::from_raw_parts_mut(at, bytes) }.fill(0);
    at
}

/// Gives the bytes of an array back to the pool.
///
/// # Safety
/// The place and the number of bytes must be those of a call of [`dq8_allocate`].
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_free(at: *mut u8, bytes: usize) {
    if let Some(bytes) = rounded(bytes) {
        POOL.with_borrow_mut(|pool| pool.put(at.expose_provenance(), bytes));
    }
}
