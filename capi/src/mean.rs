//! The intrinsic mean of motions.

use crate::memory::{Input, Output};
use crate::screw::finite;
use crate::span::apart;
use crate::status::{Done, Status};
use dq8::{DualQuat, Real, internal};

/// Motions, and how each of them weighs.
struct Influences<R> {
    motions: *const R,
    weights: *const R,
    count: usize,
}

/// [`DualQuat::dib`] of motions and weights that lie apart.
///
/// # Safety
/// As for [`Input::slice`] and [`Output::write`].
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
    let told = Output::<i32>::unless_null(converged)?;
    apart(&[told.span], &[out.span])?;
    // SAFETY: promised, and nothing is written before they are read.
    let (motions, weights) = unsafe { (motions.slice(), weights.slice()) };
    let influences = motions.iter().enumerate();
    let influences =
        influences.map(|(at, &motion)| (motion, weights.get(at).copied().unwrap_or(R::ONE)));
    let mean = internal::dib(influences, tolerance, max_iterations).ok_or(Status::NoInfluences)?;
    let motion = finite(mean.motion)?;
    // SAFETY: promised, and nothing is read any more.
    unsafe {
        out.write(motion);
        told.write(i32::from(mean.converged));
    }
    Ok(())
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// The intrinsic mean of `count` unit motions: the one from which the `weights`, null
            /// for equal ones, of the screws to all of them cancel; found by steps from
            /// dq8_motion_blend, `max_iterations` at most (32 serve), until one turns by no more
            /// than `tolerance`, radians, and moves by no more than that part of the longest dual
            /// part (1e-6 serves for float, 1e-14 for double). `converged`, which may be null, is
            /// set to 1 if it came to that, or else to 0.
            ///
            /// The mean of moved motions is the moved mean. Where motions lie more than a quarter
            /// of a turn from it, there may be several. DQ8_STATUS_NO_INFLUENCES if `count` is 0,
            /// DQ8_STATUS_NOT_NORMALIZABLE if there is no mean.
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
