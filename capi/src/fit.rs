//! The motion that brings points nearest to other points.

use crate::memory::{Input, Output};
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::fit::{FitError, PointPairs};
use dq8::{DualQuat, Real};

/// The quality of a fit, and how well the points determine a rotation.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitQuality<R> {
    /// The factor by which the points are multiplied before they are moved. It is 1 unless `scaled`
    /// was 1.
    pub scale: R,
    /// The root mean square of the distances that the fit leaves, with the weights.
    pub rms: R,
    /// The stiffness of the pairs against the turn that they resist most, over the stiffness
    /// against the turn that they resist least. A large number means that noise turns the result.
    pub condition: R,
    /// 3 for points in space, and 2 for points in a plane.
    pub rank: usize,
    /// 1 if the points are mirrored, so that one of the two arrays has left-handed coordinates: a
    /// reflection would leave less than a hundredth of the squares that the fit leaves. Otherwise
    /// 0.
    pub mirrored: i32,
}

/// The arrays of [`fit`], as C passes them.
struct Query<R> {
    points: *const R,
    moved: *const R,
    weights: *const R,
    count: usize,
    scaled: i32,
}

/// Returns the status of an error, and the index of the pair that it names.
fn fault(error: &FitError) -> (Status, Option<usize>) {
    match error {
        FitError::NotFinite { index, .. } => (Status::NotFinite, Some(*index)),
        FitError::Weight { index, .. } => (Status::Weight, Some(*index)),
        FitError::Empty => (Status::NoInfluences, None),
        FitError::Ambiguous { .. } => (Status::Ambiguous, None),
        // The enum is `non_exhaustive`. Of its other errors, only an overflow occurs here.
        _ => (Status::NotFinite, None),
    }
}

/// # Safety
/// Each array must have `count` elements, except that `weights` may be null. `motion` must point to
/// memory for a motion, and `quality` and `bad_pair` must be null or point to memory for theirs. No
/// other thread may use the outputs or write the inputs during the call.
unsafe fn fit<R: Real>(
    query: Query<R>,
    motion: *mut R,
    quality: *mut FitQuality<R>,
    bad_pair: *mut usize,
) -> Done {
    let points = Input::<[R; 3]>::new(query.points, query.count)?;
    let moved = Input::<[R; 3]>::new(query.moved, query.count)?;
    let own = if query.weights.is_null() { 0 } else { query.count };
    let weights = Input::<R>::new(query.weights, own)?;
    let to = Output::<DualQuat<R>>::new(motion, 1)?;
    let quality = Output::<FitQuality<R>>::unless_null(quality)?;
    let bad_pair = Output::<usize>::unless_null(bad_pair)?;
    let outputs = [to.span, quality.span, bad_pair.span];
    disjoint(&outputs, &[points.span, moved.span, weights.span])?;
    if !matches!(query.scaled, 0 | 1) {
        return Err(Status::UnknownValue);
    }
    // SAFETY: the caller guarantees that each array has `count` elements, and `disjoint` has
    // checked that no output overlaps them.
    let (points, moved, weights) = unsafe { (points.slice(), moved.slice(), weights.slice()) };
    let pairs = if query.weights.is_null() {
        PointPairs::new(points, moved)
    } else {
        PointPairs::weighted(points, moved, weights)
    };
    let found = pairs.and_then(|pairs| {
        let fit = if query.scaled == 1 { pairs.similarity() } else { pairs.rigid() }?;
        Ok((fit, pairs.quality(&fit)))
    });
    let (fit, told) = found.map_err(|error| {
        let (status, index) = fault(&error);
        if let Some(index) = index {
            // SAFETY: the caller guarantees that `bad_pair` is null or points to a `usize`, and
            // `disjoint` has checked that it overlaps no other array.
            unsafe { bad_pair.write(index) };
        }
        status
    })?;
    // SAFETY: the caller guarantees memory for a motion and, unless it is null, for a quality.
    // `disjoint` has checked that they overlap no other array.
    unsafe {
        to.write(fit.motion);
        quality.write(FitQuality {
            scale: fit.scale,
            rms: told.rms,
            condition: told.condition,
            rank: told.rank,
            mirrored: told.mirrored.into(),
        });
    }
    Ok(())
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Finds the motion that brings `points` nearest to `moved`: the sum of the squared
            /// distances, each multiplied by its weight, is least. Both arrays have `count` points
            /// of three components. `weights` may be null for equal weights. If `scaled` is 1, the
            /// points are first multiplied by the scale that fits best, and if it is 0 they are
            /// not. `quality`, which may be null, gets the scale and tells how well the motion
            /// fits; check its field `mirrored` if the handedness of the points is not known.
            ///
            /// Returns DQ8_STATUS_AMBIGUOUS if many rotations fit equally well, as for points on a
            /// line, and DQ8_STATUS_NO_INFLUENCES if no pair has a weight. Returns
            /// DQ8_STATUS_NOT_FINITE or _WEIGHT for a wrong point or weight, and sets `bad_pair`,
            /// which may be null, to its index. DQ8_STATUS_NOT_FINITE also means that the points
            /// are so far apart that a square overflows; `bad_pair` is then as it was.
            fit(
                points: *const $R, moved: *const $R, weights: *const $R, count: usize,
                scaled: i32, motion: *mut $R, quality: *mut FitQuality<$R>, bad_pair: *mut usize,
            ) = super::fit(
                Query { points, moved, weights, count, scaled },
                motion,
                quality,
                bad_pair,
            )
        }
    };
}
for_both_numbers!(functions);
