//! Arrays from C, which are checked first and borrowed later.

use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::slice;

/// An array that is read.
pub(crate) struct Input<T> {
    start: *const T,
    count: usize,
    pub(crate) span: Span,
}

impl<T: Copy> Input<T> {
    /// An array of `count` elements from `start`. `R` is the type of the pointer in C.
    pub(crate) fn new<R>(start: *const R, count: usize) -> Result<Self, Status> {
        let start = start.cast();
        Ok(Self { start, count, span: Span::of(start, count)? })
    }

    /// An array of one element, or of none if C passes null.
    pub(crate) fn unless_null<R>(start: *const R) -> Result<Self, Status> {
        Self::new(start, usize::from(!start.is_null()))
    }

    /// # Safety
    /// The elements must be there, any bits must be valid for `T`, and nothing may write them while
    /// `'a` lasts.
    pub(crate) unsafe fn slice<'a>(&self) -> &'a [T] {
        if self.count == 0 {
            return &[];
        }
        // SAFETY: `Span::of` has checked that the array is neither null nor misaligned nor too
        // large. The caller guarantees that its memory is valid and not aliased.
        unsafe { slice::from_raw_parts(self.start, self.count) }
    }
}

/// An array that is written.
pub(crate) struct Output<T> {
    start: *mut T,
    count: usize,
    pub(crate) span: Span,
}

impl<T: Copy> Output<T> {
    /// An array of `count` elements from `start`. `R` is the type of the pointer in C.
    pub(crate) fn new<R>(start: *mut R, count: usize) -> Result<Self, Status> {
        let start = start.cast();
        Ok(Self { start, count, span: Span::of(start, count)? })
    }

    /// An array of one element, or of none if C passes null.
    pub(crate) fn unless_null<R>(start: *mut R) -> Result<Self, Status> {
        Self::new(start, usize::from(!start.is_null()))
    }

    /// # Safety
    /// The elements must be there, any bits must be valid for `T`, and nothing else may read or
    /// write them while `'a` lasts.
    pub(crate) unsafe fn slice<'a>(&self) -> &'a mut [T] {
        if self.count == 0 {
            return &mut [];
        }
        // SAFETY: `Span::of` has checked that the array is neither null nor misaligned nor too
        // large. The caller guarantees that its memory is valid and not aliased.
        unsafe { slice::from_raw_parts_mut(self.start, self.count) }
    }

    /// Writes the only element, or nothing if C has passed null.
    ///
    /// # Safety
    /// The element must be there, and nothing else may read or write it now.
    pub(crate) unsafe fn write(&self, value: T) {
        if self.count > 0 {
            // SAFETY: `Span::of` has checked that the pointer is neither null nor misaligned. The
            // caller guarantees that it points to valid memory.
            unsafe { self.start.write(value) }
        }
    }
}

/// Memory from C that may be uninitialised.
pub(crate) type Buffer = [MaybeUninit<u8>];

/// The bytes of a buffer that has another type in C.
pub(crate) fn bytes<T>(buffer: &mut [MaybeUninit<T>]) -> &mut Buffer {
    // SAFETY: it is the same memory, and `MaybeUninit` claims nothing about its content.
    unsafe { slice::from_raw_parts_mut(buffer.as_mut_ptr().cast(), size_of_val(buffer)) }
}

/// Writes `value` `count` times to the first aligned place in `buffer`. Returns these values and
/// the rest of the buffer, or `None` if it is too small. If `count` is 0, the buffer need not be
/// aligned.
pub(crate) fn place<T: Copy>(
    buffer: &mut Buffer,
    count: usize,
    value: T,
) -> Option<(&mut [T], &mut Buffer)> {
    if count == 0 {
        return Some((&mut [], buffer));
    }
    let (_, buffer) = buffer.split_at_mut_checked(buffer.as_ptr().align_offset(align_of::<T>()))?;
    let (own, rest) = buffer.split_at_mut_checked(count.checked_mul(size_of::<T>())?)?;
    let start = own.as_mut_ptr().cast::<T>();
    for index in 0..count {
        // SAFETY: `start` is aligned, and `own` has the bytes of `count` values.
        unsafe { start.add(index).write(value) };
    }
    // SAFETY: all values have been written, and `own` is not used any more.
    Some((unsafe { slice::from_raw_parts_mut(start, count) }, rest))
}

/// Reads one element. Callers do so before they write anything, so it may overlap an output.
///
/// # Safety
/// The element must be there, any bits must be valid for `T`, and nothing may write it now.
pub(crate) unsafe fn read<T: Copy, R>(from: *const R) -> Result<T, Status> {
    let input = Input::<T>::new(from, 1)?;
    // SAFETY: `Input::new` has checked that the pointer is neither null nor misaligned. The caller
    // guarantees that it points to a valid element.
    Ok(unsafe { input.start.read() })
}

/// Calls `elsewhere` with two arrays of `count` elements, or `in_place` if they are the same array.
///
/// # Safety
/// The caller must keep the conditions of [`Input::slice`] and [`Output::slice`].
pub(crate) unsafe fn from_to<T: Copy, R, E>(
    from: *const R,
    to: *mut R,
    count: usize,
    elsewhere: impl FnOnce(&[T], &mut [T]) -> Result<(), E>,
    in_place: impl FnOnce(&mut [T]) -> Result<(), E>,
) -> Done
where
    Status: From<E>,
{
    let (from, to) = (Input::<T>::new(from, count)?, Output::<T>::new(to, count)?);
    if to.start.cast_const() == from.start {
        // SAFETY: the caller guarantees that the array is valid, and the input, which is the same
        // array, is not borrowed here.
        return Ok(in_place(unsafe { to.slice() })?);
    }
    disjoint(&[to.span], &[from.span])?;
    // SAFETY: the caller guarantees that both arrays are valid, and the check above found that they
    // do not overlap.
    Ok(elsewhere(unsafe { from.slice() }, unsafe { to.slice() })?)
}

/// Computes one thing from another. The output may overlap the input.
///
/// # Safety
/// The caller must keep the conditions of [`read`] and [`Output::write`].
pub(crate) unsafe fn one<A: Copy, B: Copy, R>(
    from: *const R,
    to: *mut R,
    of: impl FnOnce(A) -> Result<B, Status>,
) -> Done {
    let to = Output::new(to, 1)?;
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    unsafe { to.write(of(read(from)?)?) };
    Ok(())
}

/// Computes one thing from two others. The output may overlap the inputs.
///
/// # Safety
/// The caller must keep the conditions of [`read`] and [`Output::write`].
pub(crate) unsafe fn two<A: Copy, B: Copy, C: Copy, R>(
    a: *const R,
    b: *const R,
    to: *mut R,
    of: impl FnOnce(A, B) -> Result<C, Status>,
) -> Done {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    let b = unsafe { read(b)? };
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    unsafe { one(a, to, |a| of(a, b)) }
}
