use crate::real::Scalar;
use core::hint::black_box;
use dq8_simd::MAX_LANES;
use dq8_simd::picks::{CheckedIndices, Index, Picks};

/// How many influences of a vertex are read at a time.
pub(super) const GROUP: usize = dq8_simd::picks::GROUP;

/// Four influences of the vertices of one register, as kernels read them, whatever the types of joints and
/// weights in memory; and where matrices are summed. Influences that are not there have weight 0.
#[derive(Debug)]
pub struct Influences<'a, R, J> {
    /// For each lane the joints, as entries of a palette of motions and of one of matrices.
    pub(super) motions: Picks<'a, J, 8>,
    pub(super) matrices: Picks<'a, J, 12>,
    /// For each lane the weights.
    pub(super) weights: Aligned<[[R; GROUP]; MAX_LANES]>,
    /// For each lane, first, the joint of greatest weight, if these are not all.
    pub(super) pivots: Option<Picks<'a, J, 8>>,
    /// For each row of a matrix and each lane the weighted sum.
    pub(super) rows: Aligned<[[[R; 4]; MAX_LANES]; 3]>,
    /// What nobody reads.
    pub(super) again: Aligned<[R; 4]>,
}

/// At the beginning of a cache line: what is written across two is read again later.
#[derive(Debug)]
#[repr(align(64))]
pub(super) struct Aligned<T>(pub(super) T);

impl<'a, R: Scalar, J: Index> Influences<'a, R, J> {
    #[inline(always)]
    pub(super) fn new(joints: CheckedIndices<'a, J>) -> Self {
        Self {
            motions: Picks::new(joints),
            matrices: Picks::new(joints),
            weights: Aligned([[R::ZERO; GROUP]; MAX_LANES]),
            pivots: None,
            rows: Aligned([[[R::ZERO; 4]; MAX_LANES]; 3]),
            again: Aligned([R::ZERO; 4]),
        }
    }
}

/// What has been written is in memory, to be read in other pieces. Otherwise the compiler takes vectors apart
/// number by number, to put them together again without memory; or it reads more at once than was written at
/// once, which CPUs do not forward from stores to loads. Either doubles the time.
#[inline(always)]
pub(super) fn settled<T>(written: &T) -> &T {
    black_box(written)
}
