//! [`Span`]: the memory of an array, and the check that arrays are disjoint.

use crate::status::{Done, Status};

/// The memory of an array: the addresses of its first byte, and of the byte after its last one.
#[derive(Clone, Copy)]
pub(crate) struct Span {
    start: usize,
    end: usize,
}

impl Span {
    /// The memory of an array without elements, which overlaps nothing.
    pub(crate) const NOWHERE: Self = Self { start: 0, end: 0 };

    /// The memory of `count` elements from `start`. If `count` is 0, any pointer is good.
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
