//! Records, and whether they are the same.

use dq8::{DualQuat, hierarchy::MatrixOrder};
pub(crate) use dq8_contract::records::{equal, is_finite, same_bits};

/// The numbers of the matrix of a motion, so many, row after row or column after column.
pub(crate) fn entries(motion: DualQuat<f64>, order: MatrixOrder, count: usize) -> Vec<f64> {
    let (rows, matrix) = (count / 4, motion.to_matrix4());
    let entry = |k: usize| match order {
        MatrixOrder::Columns => matrix[k % rows][k / rows],
        _ => matrix[k / 4][k % 4],
    };
    (0..count).map(entry).collect()
}

#[track_caller]
pub(crate) fn assert_same_bits<const C: usize>(a: &[[f64; C]], b: &[[f64; C]], what: &str) {
    assert_eq!(a.len(), b.len(), "{what}");
    if same_bits(a.as_flattened(), b.as_flattened()) {
        return;
    }
    for (index, (a, b)) in a.iter().zip(b).enumerate() {
        assert!(same_bits(a, b), "{what}, {index}: {a:?} is not {b:?}");
    }
}

/// The records of `inside` at the joints of `range`, those of `outside` at the others.
pub(crate) fn splice<T: Copy>(
    joints: usize,
    range: &core::ops::Range<usize>,
    inside: &[T],
    outside: &[T],
) -> Vec<T> {
    let mut spliced = outside[..inside.len().min(outside.len())].to_vec();
    if !range.is_empty() {
        for (spliced, inside) in spliced.chunks_mut(joints).zip(inside.chunks(joints)) {
            spliced[range.clone()].copy_from_slice(&inside[range.clone()]);
        }
    }
    spliced
}
