//! Arrays from C: their pointers are checked first, and their elements are borrowed later.

use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::slice;

/// An array that the library reads, with a pointer that is checked.
pub(crate) struct Input<T> {
    start: *const T,
    count: usize,
    pub(crate) span: Span,
}

impl<T: Copy> Input<T> {
    /// Checks the pointer of an array of `count` elements from `start` on. `R` is the type of the
    /// elements in C.
    pub(crate) fn new<R>(start: *const R, count: usize) -> Result<Self, Status> {
        let start = start.cast();
        Ok(Self { start, count, span: Span::of(start, count)? })
    }

    /// Checks the pointer of an array of one element. The array has no element if C passes null.
    pub(crate) fn unless_null<R>(start: *const R) -> Result<Self, Status> {
        Self::new(start, usize::from(!start.is_null()))
    }

    /// # Safety
    /// The array must have `count` elements, any bits must be valid for `T`, and no code may write
    /// the elements while `'a` lasts.
    pub(crate) unsafe fn slice<'a>(&self) -> &'a [T] {
        if self.count == 0 {
            return &[];
        }
        // SAFETY: `Span::of` has checked that the array is neither null nor misaligned nor too
        // large. The caller guarantees that it has `count` elements and that no code writes them.
        unsafe { slice::from_raw_parts(self.start, self.count) }
    }
}

/// An array that the library writes, with a pointer that is checked.
pub(crate) struct Output<T> {
    start: *mut T,
    count: usize,
    pub(crate) span: Span,
}

impl<T: Copy> Output<T> {
    /// Checks the pointer of an array of `count` elements from `start` on. `R` is the type of the
    /// elements in C.
    pub(crate) fn new<R>(start: *mut R, count: usize) -> Result<Self, Status> {
        let start = start.cast();
        Ok(Self { start, count, span: Span::of(start, count)? })
    }

    /// Checks the pointer of an array of one element. The array has no element if C passes null.
    pub(crate) fn unless_null<R>(start: *mut R) -> Result<Self, Status> {
        Self::new(start, usize::from(!start.is_null()))
    }

    /// # Safety
    /// The array must have `count` elements, any bits must be valid for `T`, and no other code may
    /// read or write the elements while `'a` lasts.
    pub(crate) unsafe fn slice<'a>(&self) -> &'a mut [T] {
        if self.count == 0 {
            return &mut [];
        }
        // SAFETY: `Span::of` has checked that the array is neither null nor misaligned nor too
        // large. The caller guarantees that it has `count` elements and that no other code uses
        // them.
        unsafe { slice::from_raw_parts_mut(self.start, self.count) }
    }

    /// Writes the only element. Does nothing if C has passed null.
    ///
    /// # Safety
    /// If C has not passed null, the pointer must point to an element that no other code uses
    /// during the call.
    pub(crate) unsafe fn write(&self, value: T) {
        if self.count > 0 {
            // SAFETY: `Span::of` has checked that the pointer is neither null nor misaligned. The
            // caller guarantees that it points to an element that no other code uses.
            unsafe { self.start.write(value) }
        }
    }
}

/// Memory from C whose bytes may be uninitialised.
pub(crate) type Buffer = [MaybeUninit<u8>];

/// Returns the bytes of a buffer that has elements of another type in C.
pub(crate) fn bytes<T>(buffer: &mut [MaybeUninit<T>]) -> &mut Buffer {
    // SAFETY: the result is the same memory with the same length in bytes, a byte needs no
    // alignment, and a `MaybeUninit` may have any content.
    unsafe { slice::from_raw_parts_mut(buffer.as_mut_ptr().cast(), size_of_val(buffer)) }
}

/// Writes `count` copies of `value` from the first aligned place of `buffer` on. Returns these
/// copies and the rest of the buffer, or `None` if the buffer is too small. If `count` is 0, the
/// buffer need not have an aligned place.
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
        // SAFETY: `index` is below `count`, `start` is aligned, and `own` has the bytes of `count`
        // values.
        unsafe { start.add(index).write(value) };
    }
    // SAFETY: the loop has written `count` values from `start` on, and `own`, which borrows their
    // memory, is not used any more.
    Some((unsafe { slice::from_raw_parts_mut(start, count) }, rest))
}

/// Reads one element from C. Callers read all inputs before they write, so the element may overlap
/// an output.
///
/// # Safety
/// `from` must point to an element, unless it is null or misaligned. Any bits must be valid for
/// `T`, and no other thread may write the element during the call.
pub(crate) unsafe fn read<T: Copy, R>(from: *const R) -> Result<T, Status> {
    let input = Input::<T>::new(from, 1)?;
    // SAFETY: `Input::new` has checked that the pointer is neither null nor misaligned. The caller
    // guarantees that it points to an element that no other thread writes.
    Ok(unsafe { input.start.read() })
}

/// Calls `elsewhere` with the arrays `from` and `to` of `count` elements, or `in_place` if they are
/// the same array.
///
/// # Safety
/// Both arrays must have `count` elements, any bits must be valid for `T`, and no other code may
/// use the output or write the input during the call.
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
        // SAFETY: the caller guarantees that the array has `count` elements that no other code
        // uses. The input is the same array, and it is not borrowed here.
        return Ok(in_place(unsafe { to.slice() })?);
    }
    disjoint(&[to.span], &[from.span])?;
    // SAFETY: the caller guarantees that both arrays have `count` elements, and `disjoint` has
    // checked that they do not overlap.
    Ok(elsewhere(unsafe { from.slice() }, unsafe { to.slice() })?)
}

/// Reads a value, such as a motion, and writes the value that `of` computes from it. The output may
/// overlap the input.
///
/// # Safety
/// `from` and `to` must each point to a value, any bits must be valid for `A`, and no other thread
/// may use the output or write the input during the call.
pub(crate) unsafe fn one<A: Copy, B: Copy, R>(
    from: *const R,
    to: *mut R,
    of: impl FnOnce(A) -> Result<B, Status>,
) -> Done {
    let to = Output::new(to, 1)?;
    // SAFETY: the caller guarantees that `from` and `to` each point to a value that no other thread
    // uses. The input is read before the output is written.
    unsafe { to.write(of(read(from)?)?) };
    Ok(())
}

/// Reads two values, such as motions, and writes the value that `of` computes from them. The output
/// may overlap the inputs.
///
/// # Safety
/// `a`, `b` and `to` must each point to a value, any bits must be valid for `A` and `B`, and no
/// other thread may use the output or write the inputs during the call.
pub(crate) unsafe fn two<A: Copy, B: Copy, C: Copy, R>(
    a: *const R,
    b: *const R,
    to: *mut R,
    of: impl FnOnce(A, B) -> Result<C, Status>,
) -> Done {
    // SAFETY: the caller guarantees that `b` points to a value that no other thread writes.
    let b = unsafe { read(b)? };
    // SAFETY: the caller guarantees that `a` and `to` point to values that no other thread uses.
    // `b` has been read, so the output may overlap it.
    unsafe { one(a, to, |a| of(a, b)) }
}
