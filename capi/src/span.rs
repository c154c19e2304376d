//! [`Span`]: where an array lies, and whether arrays lie apart.

use crate::status::{Done, Status};

/// Where an array lies: the first byte, and the one after the last.
#[derive(Clone, Copy)]
pub(crate) struct Span {
    start: usize,
    end: usize,
}

impl Span {
    /// Where arrays without elements lie: in nothing.
    pub(crate) const NOWHERE: Self = Self { start: 0, end: 0 };

    /// An array without elements lies nowhere, whatever its pointer is.
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

/// An error if an output overlaps an input or another output. Inputs may overlap each other.
pub(crate) fn apart(outputs: &[Span], inputs: &[Span]) -> Done {
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
