//! [`saturated`]: the conversion of 32-bit indices to `usize`, for a comparison with a length.

use core::ops::Not;

/// Returns the index as a `usize`. On 16-bit targets an index that does not fit becomes the
/// greatest `usize`, which is beyond the end of every slice.
///
/// The operator `as` would drop the upper bits, so an index that is too large could become an index
/// that exists. A check of the largest of many indices could then pass by mistake. `U` is `usize`
/// everywhere but in the tests, which take a type of 16 bits.
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
        // The operator `as` would turn the greatest of these indices into 2, which is less than 3.
        let greatest = [65_538, 3].into_iter().fold(0, u32::max);
        assert!(saturated::<u16>(greatest) >= 3);
        assert_eq!(saturated::<u64>(u32::MAX), u32::MAX.into());
    }
}
