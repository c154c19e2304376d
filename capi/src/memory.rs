//! Arrays as C hands them over: checked first, borrowed later.

use crate::span::{Span, apart};
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
    /// `count` elements from `start`; `R` is what C says they are made of.
    pub(crate) fn new<R>(start: *const R, count: usize) -> Result<Self, Status> {
        let start = start.cast();
        Ok(Self { start, count, span: Span::of(start, count)? })
    }

    /// One element, or none where C passes null for what it does not need.
    pub(crate) fn unless_null<R>(start: *const R) -> Result<Self, Status> {
        Self::new(start, usize::from(!start.is_null()))
    }

    /// # Safety
    /// The elements are there, are any bits to `T`, and nothing writes them while `'a` lasts.
    pub(crate) unsafe fn slice<'a>(&self) -> &'a [T] {
        if self.count == 0 {
            return &[];
        }
        // SAFETY: neither null nor misaligned nor too large, by `Span::of`; the rest is promised.
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
    /// `count` elements from `start`; `R` is what C says they are made of.
    pub(crate) fn new<R>(start: *mut R, count: usize) -> Result<Self, Status> {
        let start = start.cast();
        Ok(Self { start, count, span: Span::of(start, count)? })
    }

    /// One element, or none where C passes null for what it does not want.
    pub(crate) fn unless_null<R>(start: *mut R) -> Result<Self, Status> {
        Self::new(start, usize::from(!start.is_null()))
    }

    /// # Safety
    /// The elements are there, are any bits to `T`, and nothing else reads or writes them while
    /// `'a` lasts.
    pub(crate) unsafe fn slice<'a>(&self) -> &'a mut [T] {
        if self.count == 0 {
            return &mut [];
        }
        // SAFETY: neither null nor misaligned nor too large, by `Span::of`; the rest is promised.
        unsafe { slice::from_raw_parts_mut(self.start, self.count) }
    }

    /// Writes the only element, unless C does not want it.
    ///
    /// # Safety
    /// The element is there, and nothing else reads or writes it now.
    pub(crate) unsafe fn write(&self, value: T) {
        if self.count > 0 {
            // SAFETY: neither null nor misaligned, by `Span::of`; the rest is promised.
            unsafe { self.start.write(value) }
        }
    }
}

/// Memory that nothing has been written to.
pub(crate) type Room = [MaybeUninit<u8>];

/// The bytes of memory that C has for something else.
pub(crate) fn bytes<T>(room: &mut [MaybeUninit<T>]) -> &mut Room {
    // SAFETY: the same memory, of which nothing is said to have been written.
    unsafe { slice::from_raw_parts_mut(room.as_mut_ptr().cast(), size_of_val(room)) }
}

/// `count` times `value` at the first place in `room` that is aligned for it, and the room behind;
/// `None` if it is too small. Nothing needs no place: room of no bytes need not be aligned.
pub(crate) fn place<T: Copy>(
    room: &mut Room,
    count: usize,
    value: T,
) -> Option<(&mut [T], &mut Room)> {
    if count == 0 {
        return Some((&mut [], room));
    }
    let (_, room) = room.split_at_mut_checked(room.as_ptr().align_offset(align_of::<T>()))?;
    let (own, rest) = room.split_at_mut_checked(count.checked_mul(size_of::<T>())?)?;
    let start = own.as_mut_ptr().cast::<T>();
    for index in 0..count {
        // SAFETY: aligned, and `own` has room for `count`.
        unsafe { start.add(index).write(value) };
    }
    // SAFETY: all of them have been written, and `own` is not used any more.
    Some((unsafe { slice::from_raw_parts_mut(start, count) }, rest))
}

/// Reads one element, before anything is written: it may lie anywhere.
///
/// # Safety
/// The element is there and is any bits to `T`, and nothing writes it now.
pub(crate) unsafe fn read<T: Copy, R>(from: *const R) -> Result<T, Status> {
    let input = Input::<T>::new(from, 1)?;
    // SAFETY: neither null nor misaligned, by `Input::new`; the rest is promised.
    Ok(unsafe { input.start.read() })
}

/// What becomes of `count` elements in another array, or in place where the two are one.
///
/// # Safety
/// As for [`Input::slice`] and [`Output::slice`].
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
        // SAFETY: promised; the input is not borrowed beside it.
        return Ok(in_place(unsafe { to.slice() })?);
    }
    apart(&[to.span], &[from.span])?;
    // SAFETY: promised, and the two are apart.
    Ok(elsewhere(unsafe { from.slice() }, unsafe { to.slice() })?)
}

/// One thing from another.
///
/// # Safety
/// As for [`read`] and [`Output::write`].
pub(crate) unsafe fn one<A: Copy, B: Copy, R>(
    from: *const R,
    to: *mut R,
    of: impl FnOnce(A) -> Result<B, Status>,
) -> Done {
    let to = Output::new(to, 1)?;
    // SAFETY: promised.
    unsafe { to.write(of(read(from)?)?) };
    Ok(())
}

/// One thing from two.
///
/// # Safety
/// As for [`read`] and [`Output::write`].
pub(crate) unsafe fn two<A: Copy, B: Copy, C: Copy, R>(
    a: *const R,
    b: *const R,
    to: *mut R,
    of: impl FnOnce(A, B) -> Result<C, Status>,
) -> Done {
    // SAFETY: promised.
    let b = unsafe { read(b)? };
    // SAFETY: promised.
    unsafe { one(a, to, |a| of(a, b)) }
}
