//! [`CheckedSchedule`]: a list of steps, each of which needs the result of an earlier step, with
//! indices that are checked once.
//!
//! The poses of a single skeleton are a chain of products, each of which waits for the product
//! before it. This chain limits the speed, so the loop has no check of indices:
//!
//! ```text
//! for [to, from] in pairs:
//!     outputs[to] = step(outputs[from], inputs[to])    // no check of `to` and `from` here
//! ```

use crate::index::saturated;
#[cfg(feature = "alloc")]
use alloc::boxed::Box;

/// A list of pairs `[to, from]`, where element `to` is computed from element `from`, and all
/// indices are below a bound.
///
/// The constructor checks the indices, and the loop does not: a step takes seven cycles, and a
/// check would add half a cycle. The type `S`, a slice or a box, holds the pairs. To run a schedule
/// that holds a box, call its method `borrowed` first.
#[derive(Clone, Copy, Debug)]
pub struct CheckedSchedule<S> {
    /// Invariant: all indices in `pairs` are less than `bound`.
    pairs: S,
    bound: usize,
}

impl<S: AsRef<[[u32; 2]]>> CheckedSchedule<S> {
    /// Makes a schedule of these pairs, in this order, for slices of `bound` elements. Returns
    /// `None` if an index is not below `bound`.
    #[must_use]
    pub fn new(pairs: S, bound: usize) -> Option<Self> {
        // The largest index decides, because the compiler vectorises a maximum, but not a search
        // that ends at the first bad index.
        let largest = pairs.as_ref().as_flattened().iter().fold(0, |most, &index| index.max(most));
        let within = pairs.as_ref().is_empty() || saturated::<usize>(largest) < bound;
        within.then_some(Self { pairs, bound })
    }
}

#[cfg(feature = "alloc")]
impl CheckedSchedule<Box<[[u32; 2]]>> {
    /// Returns this schedule over borrowed pairs, without checking them again.
    #[inline(always)]
    #[must_use]
    pub fn borrowed(&self) -> CheckedSchedule<&[[u32; 2]]> {
        CheckedSchedule { pairs: &self.pairs, bound: self.bound }
    }
}

// These methods exist for slices only: another implementation of `AsRef` might return pairs here
// that `new` has not checked.
impl CheckedSchedule<&[[u32; 2]]> {
    /// Returns the length that the slices of [`run`](Self::run) must have.
    #[inline(always)]
    #[must_use]
    pub fn bound(&self) -> usize {
        self.bound
    }

    /// Computes `outputs[to] = step(&outputs[from], &inputs[to])`, pair by pair. If one of the
    /// slices does not have [`bound`](Self::bound) elements, it writes nothing and returns `None`.
    #[inline(always)]
    pub fn run<T>(
        &self,
        inputs: &[T],
        outputs: &mut [T],
        mut step: impl FnMut(&T, &T) -> T,
    ) -> Option<()> {
        if inputs.len() != self.bound || outputs.len() != self.bound {
            return None;
        }
        for &[to, from] in self.pairs {
            // SAFETY: both slices have `bound` elements, as checked above, and all indices are
            // below `bound`, by the invariant of `pairs`.
            unsafe {
                let output =
                    step(outputs.get_unchecked(from as usize), inputs.get_unchecked(to as usize));
                *outputs.get_unchecked_mut(to as usize) = output;
            }
        }
        Some(())
    }

    /// Computes `elements[to] = step(&elements[from], &elements[to])`, pair by pair. If the slice
    /// does not have [`bound`](Self::bound) elements, it writes nothing and returns `None`.
    #[inline(always)]
    pub fn run_in_place<T>(
        &self,
        elements: &mut [T],
        mut step: impl FnMut(&T, &T) -> T,
    ) -> Option<()> {
        if elements.len() != self.bound {
            return None;
        }
        for &[to, from] in self.pairs {
            // SAFETY: the slice has `bound` elements, as checked above, and all indices are below
            // `bound`, by the invariant of `pairs`.
            unsafe {
                let element = step(
                    elements.get_unchecked(from as usize),
                    elements.get_unchecked(to as usize),
                );
                *elements.get_unchecked_mut(to as usize) = element;
            }
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::CheckedSchedule;

    fn schedule(pairs: &[[u32; 2]], bound: usize) -> Option<CheckedSchedule<&[[u32; 2]]>> {
        CheckedSchedule::new(pairs, bound)
    }

    #[test]
    fn an_index_at_the_bound_is_refused_on_either_side() {
        assert!(schedule(&[[2, 1], [1, 0]], 3).is_some());
        assert!(schedule(&[[2, 1], [3, 0]], 3).is_none());
        assert!(schedule(&[[2, 1], [1, 3]], 3).is_none());
        assert!(schedule(&[], 0).is_some());
    }

    #[test]
    fn later_pairs_see_what_earlier_ones_wrote() {
        let steps = schedule(&[[2, 0], [1, 2]], 3).unwrap();
        let mut elements = [1, 10, 100];
        assert!(steps.run(&[3, 20, 200], &mut elements, |from, to| from + to).is_some());
        assert_eq!(elements, [1, 221, 201]);
        assert!(steps.run_in_place(&mut elements, |from, to| from - to).is_some());
        assert_eq!(elements, [1, -421, -200]);
    }

    #[test]
    fn a_slice_of_another_length_is_left_alone() {
        let steps = schedule(&[[1, 0]], 2).unwrap();
        let (mut short, mut long) = ([1; 1], [1; 3]);
        assert!(steps.run_in_place(&mut short, |_, _| 2).is_none());
        assert!(steps.run(&[1; 2], &mut long, |_, _| 2).is_none());
        assert!(steps.run(&[1; 3], &mut [1; 2], |_, _| 2).is_none());
        assert_eq!((short, long), ([1; 1], [1; 3]));
    }
}
