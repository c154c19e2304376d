//! Comparing records.

/// Equal, or both NaN. Zeros of either sign are equal: the order of a sum decides about them.
pub(crate) fn equal(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a == b || a.is_nan() && b.is_nan())
}

/// To the last bit; of NaN there is one.
pub(crate) fn same_bits(a: &[f64], b: &[f64]) -> bool {
    let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    a.len() == b.len() && a.iter().zip(b).all(same)
}

#[track_caller]
pub(crate) fn assert_same_bits<const C: usize>(a: &[[f64; C]], b: &[[f64; C]], what: &str) {
    assert_eq!(a.len(), b.len(), "{what}");
    for (index, (a, b)) in a.iter().zip(b).enumerate() {
        assert!(same_bits(a, b), "{what}, {index}: {a:?} is not {b:?}");
    }
}

/// Whether a record holds what no number is.
pub(crate) fn is_finite(record: &[f64]) -> bool {
    record.iter().all(|c| c.is_finite())
}

/// The records of `inside` at the joints of `range`, those of `outside` at the others.
pub(crate) fn splice<T: Copy>(
    joints: usize,
    range: &core::ops::Range<usize>,
    inside: &[T],
    outside: &[T],
) -> Vec<T> {
    let pairs = inside.iter().zip(outside).enumerate();
    pairs
        .map(
            |(index, (inside, outside))| {
                if range.contains(&(index % joints)) { *inside } else { *outside }
            },
        )
        .collect()
}
