//! [`saturated`]: 32-bit indices as `usize`, so that a check can compare them with a length.

use core::ops::Not;

/// The index as a `usize`, or the greatest `usize` if it has fewer bits (on 16-bit targets), which
/// is beyond the end of every slice.
///
/// With `as`, an index that is too large would turn into another one that may exist, and the
/// largest of many indices would no longer be the one to check. `U` is generic so that tests can
/// have 16 bits.
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
        // With `as`, the greatest of these indices would turn into 2, which is less than the other.
        let greatest = [65_538, 3].into_iter().fold(0, u32::max);
        assert!(saturated::<u16>(greatest) >= 3);
        assert_eq!(saturated::<u64>(u32::MAX), u32::MAX.into());
    }
}
