//! [`saturated`]: indices in memory, as numbers that a check may compare.

use core::ops::Not;

/// The index as a `usize`, or the greatest one, which no memory has, where `usize` has fewer bits.
/// Cut off, it would be another index, and the greatest of all not the greatest of what is left of
/// each. Generic for the tests.
#[inline(always)]
pub(crate) fn saturated<U: TryFrom<u32> + Default + Not<Output = U>>(index: u32) -> U {
    U::try_from(index).unwrap_or(!U::default())
}

#[cfg(test)]
mod tests {
    use super::saturated;

    #[test]
    fn where_usize_has_16_bits_no_longer_index_passes_for_a_short_one() {
        for (index, wanted) in [(0, 0), (65_535, 65_535), (65_536, 65_535), (u32::MAX, 65_535)] {
            assert_eq!(saturated::<u16>(index), wanted);
        }
        // Cut off, the greatest of them is 2.
        let greatest = [65_538, 3].into_iter().fold(0, u32::max);
        assert!(saturated::<u16>(greatest) >= 3);
        assert_eq!(saturated::<u64>(u32::MAX), u32::MAX.into());
    }
}
