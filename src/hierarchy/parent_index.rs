//! [`ParentIndex`]: the types of numbers that name a parent.

use super::Hierarchy;
use super::error::HierarchyError;

/// A number that names a parent, or says that there is none: −1, the largest number of its type,
/// or `None`. Sealed.
pub trait ParentIndex: Copy + sealed::Sealed {
    /// The parent as it is written; `None` where there is none.
    fn number(self) -> Option<i128>;
}

mod sealed {
    pub trait Sealed {}
}

/// Not the number of a joint, and not the mark of a root.
const BEYOND: u32 = u32::MAX - 1;

/// The number by which a hierarchy knows a parent; [`BEYOND`] if that is no joint.
pub(super) fn index<P: ParentIndex>(parent: P) -> u32 {
    match parent.number() {
        None => Hierarchy::ROOT,
        Some(number) => u32::try_from(number).unwrap_or(BEYOND).min(BEYOND),
    }
}

/// The error for a parent that is no joint, which names it as it was written.
pub(super) fn as_written<P: ParentIndex>(error: HierarchyError, parents: &[P]) -> HierarchyError {
    match error {
        HierarchyError::ParentOutOfRange { joint, parent, joints } => {
            let written = parents.get(joint).and_then(|parent| parent.number());
            let parent = written.unwrap_or(parent);
            HierarchyError::ParentOutOfRange { joint, parent, joints }
        }
        _ => error,
    }
}

macro_rules! parent_indices {
    ($($number:ty)*) => {$(
        impl sealed::Sealed for $number {}
        impl ParentIndex for $number {
            fn number(self) -> Option<i128> {
                let number = self as i128;
                (number != -1 && self != Self::MAX).then_some(number)
            }
        }
        impl sealed::Sealed for Option<$number> {}
        impl ParentIndex for Option<$number> {
            fn number(self) -> Option<i128> {
                self.map(|parent| parent as i128)
            }
        }
    )*};
}
parent_indices! { u8 u16 u32 u64 usize i8 i16 i32 i64 isize }
