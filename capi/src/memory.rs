//! Arrays as C hands them over: checked first, borrowed later.

use crate::status::{Done, Status};
use core::slice;
use dq8::ShapeError;

/// Where an array lies: the first byte, and the one after the last.
#[derive(Clone, Copy)]
struct Span {
    start: usize,
    end: usize,
}

impl Span {
    /// An array without elements lies nowhere, whatever its pointer is.
    fn of<T>(start: *const T, count: usize) -> Result<Self, Status> {
        if count == 0 {
            return Ok(Self { start: 0, end: 0 });
        }
        if start.is_null() {
            return Err(Status::NullPointer);
        }
        if !start.is_aligned() {
            return Err(Status::Misaligned);
        }
        let bytes = count.checked_mul(size_of::<T>()).filter(|bytes| *bytes <= isize::MAX as usize);
        let end = bytes.and_then(|bytes| start.addr().checked_add(bytes));
        let end = end.ok_or(Status::TooLarge)?;
        Ok(Self { start: start.addr(), end })
    }

    fn apart_from(self, other: Self) -> Done {
        let overlap = self.start < other.end && other.start < self.end;
        if overlap { Err(Status::Overlap) } else { Ok(()) }
    }
}

/// An array that is read.
pub(crate) struct Input<T> {
    start: *const T,
    count: usize,
    span: Span,
}

impl<T: Copy> Input<T> {
    /// `count` elements from `start`; `R` is what C says they are made of.
    pub(crate) fn new<R>(start: *const R, count: usize) -> Result<Self, Status> {
        let start = start.cast();
        Ok(Self { start, count, span: Span::of(start, count)? })
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
    span: Span,
}

impl<T: Copy> Output<T> {
    /// `count` elements from `start`; `R` is what C says they are made of.
    pub(crate) fn new<R>(start: *mut R, count: usize) -> Result<Self, Status> {
        let start = start.cast();
        Ok(Self { start, count, span: Span::of(start, count)? })
    }

    /// One element, or none where C passes null for what it does not want.
    pub(crate) fn unless_null<R>(start: *mut R) -> Result<Option<Self>, Status> {
        if start.is_null() { Ok(None) } else { Self::new(start, 1).map(Some) }
    }

    pub(crate) fn apart_from<U>(&self, input: &Input<U>) -> Done {
        self.span.apart_from(input.span)
    }

    pub(crate) fn apart_from_output<U>(&self, other: &Output<U>) -> Done {
        self.span.apart_from(other.span)
    }

    /// # Safety
    /// The elements are there, are any bits to `T`, and nothing else reads or writes them while `'a`
    /// lasts.
    pub(crate) unsafe fn slice<'a>(&self) -> &'a mut [T] {
        if self.count == 0 {
            return &mut [];
        }
        // SAFETY: neither null nor misaligned nor too large, by `Span::of`; the rest is promised.
        unsafe { slice::from_raw_parts_mut(self.start, self.count) }
    }

    /// Writes the only element.
    ///
    /// # Safety
    /// The element is there, and nothing else reads or writes it now.
    pub(crate) unsafe fn write(&self, value: T) {
        // SAFETY: neither null nor misaligned, by `Span::of`; the rest is promised.
        unsafe { self.start.write(value) }
    }
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
pub(crate) unsafe fn from_to<T: Copy, R>(
    from: *const R,
    to: *mut R,
    count: usize,
    apart: impl FnOnce(&[T], &mut [T]) -> Result<(), ShapeError>,
    in_place: impl FnOnce(&mut [T]) -> Result<(), ShapeError>,
) -> Done {
    let (from, to) = (Input::<T>::new(from, count)?, Output::<T>::new(to, count)?);
    if to.start.cast_const() == from.start {
        // SAFETY: promised; the input is not borrowed beside it.
        return Ok(in_place(unsafe { to.slice() })?);
    }
    to.apart_from(&from)?;
    // SAFETY: promised, and the two are apart.
    Ok(apart(unsafe { from.slice() }, unsafe { to.slice() })?)
}

/// What an array of `count` elements makes in another, apart from it.
///
/// # Safety
/// As for [`Input::slice`] and [`Output::slice`].
pub(crate) unsafe fn one_to<A: Copy, B: Copy, R>(
    from: *const R,
    to: *mut R,
    count: usize,
    run: impl FnOnce(&[A], &mut [B]) -> Result<(), ShapeError>,
) -> Done {
    let (from, to) = (Input::<A>::new(from, count)?, Output::<B>::new(to, count)?);
    to.apart_from(&from)?;
    // SAFETY: promised, and apart.
    Ok(run(unsafe { from.slice() }, unsafe { to.slice() })?)
}

/// What two arrays of `count` elements make of each other in a third, apart from both.
///
/// # Safety
/// As for [`Input::slice`] and [`Output::slice`].
pub(crate) unsafe fn two_to<A: Copy, B: Copy, C: Copy, R>(
    a: *const R,
    b: *const R,
    to: *mut R,
    count: usize,
    run: impl FnOnce(&[A], &[B], &mut [C]) -> Result<(), ShapeError>,
) -> Done {
    let (a, b) = (Input::<A>::new(a, count)?, Input::<B>::new(b, count)?);
    let to = Output::<C>::new(to, count)?;
    to.apart_from(&a)?;
    to.apart_from(&b)?;
    // SAFETY: promised, and apart.
    Ok(run(unsafe { a.slice() }, unsafe { b.slice() }, unsafe { to.slice() })?)
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
