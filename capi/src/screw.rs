//! Interpolation between motions, and the screw of a motion. The functions read all inputs before
//! they write, so outputs may be inputs.

use crate::memory::{Input, Output, one, two};
use crate::status::{Done, Status};
use dq8::{
    DualQuat, Line, Real,
    geometry::{DualVector, Screw},
    internal,
};

pub(crate) fn finite<R: Real>(motion: DualQuat<R>) -> Result<DualQuat<R>, Status> {
    let finite = motion.to_array().into_iter().all(Real::is_finite);
    if finite { Ok(motion) } else { Err(Status::NotNormalizable) }
}

/// Blends motions and weights in two arrays, like [`DualQuat::dlb`], and writes the blend to `out`.
///
/// # Safety
/// Both arrays must have `count` elements, and `out` memory for a motion. No other thread may use
/// the output or write the inputs during the call.
unsafe fn blend<R: Real>(motions: *const R, weights: *const R, count: usize, out: *mut R) -> Done {
    let motions = Input::<DualQuat<R>>::new(motions, count)?;
    let weights = Input::<R>::new(weights, count)?;
    let out = Output::new(out, 1)?;
    // SAFETY: the caller guarantees that both arrays have `count` elements, and the output is
    // written only after both slices have been read for the last time.
    let (motions, weights) = unsafe { (motions.slice(), weights.slice()) };
    let influences = motions.iter().copied().zip(weights.iter().copied());
    let sum = internal::weighted_sum(influences).ok_or(Status::NoInfluences)?;
    // SAFETY: the caller guarantees that `out` has memory for a motion. No input is read after this
    // write, so the output may overlap the inputs.
    unsafe { out.write(sum.try_normalize()?) };
    Ok(())
}

/// Returns the eight values of a screw in C: the direction and the moment of its axis, the angle,
/// and the slide.
fn numbers<R: Copy>(screw: Screw<R>) -> [R; 8] {
    let ([lx, ly, lz], [mx, my, mz]) = (screw.axis.direction, screw.axis.moment);
    [lx, ly, lz, mx, my, mz, screw.angle, screw.slide]
}

fn screw<R>([lx, ly, lz, mx, my, mz, angle, slide]: [R; 8]) -> Screw<R> {
    let axis = Line { direction: [lx, ly, lz], moment: [mx, my, mz] };
    Screw { axis, angle, slide }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Interpolates from `a` (t = 0) to `b` (t = 1) by the shorter way: the normalized
            /// linear interpolation. Returns DQ8_STATUS_NOT_NORMALIZABLE if the weighted sum cannot
            /// be normalized to a motion.
            motion::nlerp(a: *const $R, b: *const $R, t: $R, out: *mut $R) =
                two(a, b, out, |a: DualQuat<$R>, b: DualQuat<$R>| finite(a.nlerp(b, t)))
        }
        export_one! { $R
            /// Interpolates along one screw, from unit `a` (t = 0) to unit `b` (t = 1). The motion
            /// has constant speed and goes by the shorter way.
            motion::sclerp(a: *const $R, b: *const $R, t: $R, out: *mut $R) =
                two(a, b, out, |a: DualQuat<$R>, b: DualQuat<$R>| Ok(a.sclerp(b, t)))
        }
        export_one! { $R
            /// Blends `count` unit motions by `weights`, which need not sum to 1. This is dual
            /// quaternion linear blending: each motion gets the sign with which its real part has a
            /// dot product of at least 0 with the real part of the first motion, and the weighted
            /// sum is normalized.
            ///
            /// Returns DQ8_STATUS_NO_INFLUENCES if `count` is 0, and DQ8_STATUS_NOT_NORMALIZABLE if
            /// the weighted sum cannot be normalized to a motion.
            motion::blend(motions: *const $R, weights: *const $R, count: usize, out: *mut $R) =
                super::blend(motions, weights, count, out)
        }
        export_one! { $R
            /// Writes the logarithm of a unit motion. It has six components: the real part x y z,
            /// which is half the angle times the axis, then the dual part x y z. What other
            /// libraries call the logarithm, twice as large, is the twist that dq8_motion_to_twist
            /// writes.
            motion::log(motion: *const $R, log: *mut $R) =
                one(motion, log, |motion: DualQuat<$R>| {
                    let log = motion.log();
                    Ok([log.real, log.dual])
                })
        }
        export_one! { $R
            /// Writes the unit motion whose logarithm is `log`: six components, as dq8_motion_log
            /// writes them. Of a twist, dq8_from_twist computes the motion.
            motion::exp(log: *const $R, out: *mut $R) =
                one(log, out, |[real, dual]: [[$R; 3]; 2]| {
                    Ok(DualQuat::exp(DualVector { real, dual }))
                })
        }
        export_one! { $R
            /// Raises a unit motion to the power `t`. The power has the same screw axis, and t
            /// times the angle and the slide.
            motion::pow(motion: *const $R, t: $R, out: *mut $R) =
                one(motion, out, |motion: DualQuat<$R>| Ok(motion.pow(t)))
        }
        export_one! { $R
            /// Writes the screw of a unit motion as eight values. They are the direction x y z of
            /// the axis, the moment x y z of the axis, the angle from 0 to pi, and the slide along
            /// the axis. A translation has angle 0.
            motion::to_screw(motion: *const $R, screw: *mut $R) =
                one(motion, screw, |motion: DualQuat<$R>| Ok(numbers(motion.to_screw())))
        }
        export_one! { $R
            /// Writes the motion of a screw, which `numbers` gives as eight values. They are the
            /// direction x y z of the axis, of length 1, the moment x y z of the axis, at right
            /// angles to the direction, the angle, and the slide along the axis.
            motion::from_screw(numbers: *const $R, out: *mut $R) =
                one(numbers, out, |numbers: [$R; 8]| Ok(DualQuat::from_screw(screw(numbers))))
        }
    };
}
for_both_numbers!(functions);
