//! [`Span`]: the range of memory of an array, and the check that arrays do not overlap.

use crate::status::{Done, Status};

/// The range of memory of an array: the address of its first byte, and the address after its last
/// byte.
#[derive(Clone, Copy)]
pub(crate) struct Span {
    start: usize,
    end: usize,
}

impl Span {
    /// The range of an array without elements, which overlaps no other range.
    pub(crate) const NOWHERE: Self = Self { start: 0, end: 0 };

    /// Returns the range of `count` elements from `start` on, after it has checked that the pointer
    /// is neither null nor misaligned, and that the array fits into memory. If `count` is 0, any
    /// pointer is accepted.
    pub(crate) fn of<T>(start: *const T, count: usize) -> Result<Self, Status> {
        if count == 0 {
            return Ok(Self::NOWHERE);
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

    fn overlaps(self, other: Self) -> bool {
        self.start < other.end && other.start < self.end
    }
}

/// Checks that no output overlaps an input or another output. Inputs may overlap each other.
pub(crate) fn disjoint(outputs: &[Span], inputs: &[Span]) -> Done {
    for (index, &output) in outputs.iter().enumerate() {
        let others = outputs.iter().skip(index + 1).chain(inputs);
        for &other in others {
            if output.overlaps(other) {
                return Err(Status::Overlap);
            }
        }
    }
    Ok(())
}
