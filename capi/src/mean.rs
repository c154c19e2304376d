//! The intrinsic mean of motions.

use crate::memory::{Input, Output};
use crate::screw::finite;
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::{DualQuat, Real, internal};

/// Motions and their weights.
struct Influences<R> {
    motions: *const R,
    weights: *const R,
    count: usize,
}

/// [`DualQuat::dib`] of motions and weights in two arrays.
///
/// # Safety
/// The caller must keep the conditions of [`Input::slice`] and [`Output::write`].
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
    // SAFETY: the caller guarantees that the arrays are valid, and the output is written only after
    // both have been read.
    let (motions, weights) = unsafe { (motions.slice(), weights.slice()) };
    let influences = motions.iter().enumerate();
    let influences =
        influences.map(|(at, &motion)| (motion, weights.get(at).copied().unwrap_or(R::ONE)));
    let mean = internal::dib(influences, tolerance, max_iterations).ok_or(Status::NoInfluences)?;
    let motion = finite(mean.motion)?;
    // SAFETY: the caller guarantees that the output is valid, and no input is read after this
    // write, so the output may overlap them.
    unsafe {
        out.write(motion);
        converged_to.write(i32::from(mean.converged));
    }
    Ok(())
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Computes the intrinsic mean of `count` unit motions: the motion from which the
            /// screws to all of them, times their weights, sum to zero. `weights` may be null for
            /// equal weights.
            ///
            /// The search begins at dq8_motion_blend and takes at most `max_iterations` steps, for
            /// which 32 are enough. It ends with a step that turns by at most `tolerance` radians
            /// and moves by at most `tolerance` times the longest dual part. 1e-6 is a good
            /// tolerance for float, and 1e-14 for double. `converged`, which may be null, is set to
            /// 1 if the search ended so, and otherwise to 0.
            ///
            /// If all motions are moved, so is their mean. There may be several means if motions
            /// are more than a quarter of a turn away from it. Returns DQ8_STATUS_NO_INFLUENCES if
            /// `count` is 0, and DQ8_STATUS_NOT_NORMALIZABLE if there is no mean.
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
