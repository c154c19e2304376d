//! The intrinsic mean of motions.

use crate::memory::{Input, Output};
use crate::screw::finite;
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::{DualQuat, Real, internal};

/// The arrays of `count` motions and of their weights. `weights` is null for equal weights.
struct Influences<R> {
    motions: *const R,
    weights: *const R,
    count: usize,
}

/// Computes the mean of motions and weights in two arrays, like [`DualQuat::dib`], and writes it to
/// `out`.
///
/// # Safety
/// Each array must have `count` elements. `converged` must be null or point to an `i32`, and no
/// other thread may use the outputs or write the inputs during the call.
unsafe fn mean<R: Real>(
    influences: Influences<R>,
    tolerance: R,
    max_iterations: u32,
    out: *mut R,
    converged: *mut i32,
) -> Done {
    let Influences { motions, weights, count } = influences;
    let motions = Input::<DualQuat<R>>::new(motions, count)?;
    let own = if weights.is_null() { 0 } else { count };
    let weights = Input::<R>::new(weights, own)?;
    let out = Output::new(out, 1)?;
    let converged_to = Output::<i32>::unless_null(converged)?;
    disjoint(&[converged_to.span], &[out.span])?;
    // SAFETY: the caller guarantees that each array has `count` elements, and the outputs are
    // written only after both slices have been read for the last time.
    let (motions, weights) = unsafe { (motions.slice(), weights.slice()) };
    let influences = motions.iter().enumerate();
    let influences =
        influences.map(|(at, &motion)| (motion, weights.get(at).copied().unwrap_or(R::ONE)));
    let mean = internal::dib(influences, tolerance, max_iterations).ok_or(Status::NoInfluences)?;
    let motion = finite(mean.motion)?;
    // SAFETY: the caller guarantees that `out` points to memory for a motion, and `converged` is
    // null or points to an `i32`. No input is read after these writes, so the outputs may overlap
    // the inputs.
    unsafe {
        out.write(motion);
        converged_to.write(i32::from(mean.converged));
    }
    Ok(())
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Computes the intrinsic mean of `count` unit motions: the logarithms of the motions,
            /// as seen from the mean, sum to zero when they are multiplied by `weights`. `weights`
            /// may be null for equal weights.
            ///
            /// The search begins at dq8_motion_blend and takes at most `max_iterations` steps, for
            /// which 32 are enough. The search has converged when a step turns by at most
            /// `tolerance` radians and moves by at most `tolerance` times the longest dual part. A
            /// good tolerance is 1e-6 for float, and 1e-14 for double. `converged`, which may be
            /// null, is set to 1 if the search has converged, and to 0 if it has not.
            ///
            /// If all motions are multiplied by the same motion, so is their mean. There may be
            /// several means if motions are more than a quarter of a turn away from a mean. Returns
            /// DQ8_STATUS_NO_INFLUENCES if `count` is 0, and DQ8_STATUS_NOT_NORMALIZABLE if there
            /// is no mean.
            motion::mean(
                motions: *const $R, weights: *const $R, count: usize, tolerance: $R, max_iterations: u32,
                out: *mut $R, converged: *mut i32,
            ) = super::mean(
                Influences { motions, weights, count },
                tolerance,
                max_iterations,
                out,
                converged,
            )
        }
    };
}
for_both_numbers!(functions);
