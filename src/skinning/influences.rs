use crate::number::Scalar;
use core::hint::black_box;
use dq8_simd::MAX_LANES;
use dq8_simd::internal::{CheckedIndices, Index, PickRows, Picks};

/// The number of influences of a vertex that are read at a time.
pub(super) const GROUP: usize = dq8_simd::internal::RECORDS_PER_LANE;

/// Four influences of the vertices of one register, as kernels read them, whatever the types of
/// joints and weights in memory. Influences that are not there have weight 0.
#[derive(Debug)]
pub(super) struct Influences<'a, R, J> {
    /// For each lane the joints, in the memory of the skin, and here where they do not lie there in
    /// order.
    pub(super) in_place: Option<PickRows<'a, J>>,
    pub(super) joints: Picks<'a, J>,
    /// For each lane the weights, in the same way.
    pub(super) weights_in_place: Option<&'a [[R; GROUP]; MAX_LANES]>,
    pub(super) weights: Aligned<[[R; GROUP]; MAX_LANES]>,
    /// For each lane, first, the joint of greatest weight, if these are not all.
    pub(super) pivots: Option<Picks<'a, J>>,
}

/// Memory that kernels use for one register of vertices after another.
#[derive(Debug)]
pub struct Scratch<'a, R, J> {
    pub(super) influences: Influences<'a, R, J>,
    /// For each lane the twelve numbers of the weighted sum of matrices; in `f32` in one cache
    /// line.
    pub(super) sums: Aligned<[[R; 16]; MAX_LANES]>,
}

/// At the beginning of a cache line: what is written across two is read again later.
#[derive(Debug)]
#[repr(align(64))]
pub(super) struct Aligned<T>(pub(super) T);

impl<'a, R: Scalar, J: Index> Influences<'a, R, J> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(joints: CheckedIndices<'a, J>) -> Self {
        Self {
            in_place: None,
            weights_in_place: None,
            joints: Picks::new(joints),
            weights: Aligned([[R::ZERO; GROUP]; MAX_LANES]),
            pivots: None,
        }
    }

    /// For each lane the joints: in one of two places, a choice that must not be made again for
    /// each index.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn rows(&self) -> PickRows<'_, J> {
        *settled(&self.in_place.unwrap_or_else(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || self.joints.rows(),
        ))
    }

    /// For each lane the weights, in the same way.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn weights(&self) -> &[[R; GROUP]; MAX_LANES] {
        settled(self.weights_in_place.unwrap_or(&self.weights.0))
    }
}

impl<'a, R: Scalar, J: Index> Scratch<'a, R, J> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(joints: CheckedIndices<'a, J>) -> Self {
        Self { influences: Influences::new(joints), sums: Aligned([[R::ZERO; 16]; MAX_LANES]) }
    }
}

/// A fence: what has been written is in memory, to be read in other pieces. Otherwise the compiler
/// takes vectors apart number by number, to put them together again without memory; or it reads
/// more at once than was written at once, which CPUs do not forward from stores to loads. Either
/// doubles the time.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn settled<T>(written: &T) -> &T {
    black_box(written)
}
