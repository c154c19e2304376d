//! One motion between others, and its screw. Inputs are read before anything is written, so outputs
//! may be inputs.

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

/// [`DualQuat::dlb`] of motions and weights that lie apart: C has no pairs of them.
///
/// # Safety
/// As for [`Input::slice`] and [`Output::write`].
unsafe fn blend<R: Real>(motions: *const R, weights: *const R, count: usize, out: *mut R) -> Done {
    let motions = Input::<DualQuat<R>>::new(motions, count)?;
    let weights = Input::<R>::new(weights, count)?;
    let out = Output::new(out, 1)?;
    // SAFETY: promised, and nothing is written before they are read.
    let (motions, weights) = unsafe { (motions.slice(), weights.slice()) };
    let influences = motions.iter().copied().zip(weights.iter().copied());
    let sum = internal::weighted_sum(influences).ok_or(Status::NoInfluences)?;
    // SAFETY: promised, and nothing is read any more.
    unsafe { out.write(sum.try_normalize()?) };
    Ok(())
}

/// A screw as C has it: direction and moment of its axis, angle, slide.
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
            /// From `a` to `b` by the shorter way, `t` of it: linear and normalized.
            /// DQ8_STATUS_NOT_NORMALIZABLE if the sum is no motion.
            motion::nlerp(a: *const $R, b: *const $R, t: $R, out: *mut $R) =
                two(a, b, out, |a: DualQuat<$R>, b: DualQuat<$R>| finite(a.nlerp(b, t)))
        }
        export_one! { $R
            /// From unit `a` to unit `b` by the shorter way, `t` of it, along one screw at constant
            /// speed.
            motion::sclerp(a: *const $R, b: *const $R, t: $R, out: *mut $R) =
                two(a, b, out, |a: DualQuat<$R>, b: DualQuat<$R>| Ok(a.sclerp(b, t)))
        }
        export_one! { $R
            /// The blend of `count` unit motions by `weights`, which need not sum to 1: their sum,
            /// each turned toward the first, normalized (dual quaternion linear blending).
            ///
            /// DQ8_STATUS_NO_INFLUENCES if `count` is 0, DQ8_STATUS_NOT_NORMALIZABLE if the sum is
            /// no motion.
            motion::blend(motions: *const $R, weights: *const $R, count: usize, out: *mut $R) =
                super::blend(motions, weights, count, out)
        }
        export_one! { $R
            /// The logarithm of a unit motion, six numbers: half the angle times the axis, and its
            /// moment.
            motion::log(motion: *const $R, log: *mut $R) =
                one(motion, log, |motion: DualQuat<$R>| {
                    let log = motion.log();
                    Ok([log.real, log.dual])
                })
        }
        export_one! { $R
            /// The motion of a logarithm of six numbers.
            motion::exp(log: *const $R, out: *mut $R) =
                one(log, out, |[real, dual]: [[$R; 3]; 2]| {
                    Ok(DualQuat::exp(DualVector { real, dual }))
                })
        }
        export_one! { $R
            /// `t` of a unit motion: the same screw axis, t times the angle and the slide.
            motion::pow(motion: *const $R, t: $R, out: *mut $R) =
                one(motion, out, |motion: DualQuat<$R>| Ok(motion.pow(t)))
        }
        export_one! { $R
            /// The screw of a unit motion, eight numbers: direction of the axis, moment of the
            /// axis, angle in 0 to pi, slide along the axis. A translation has angle 0.
            motion::to_screw(motion: *const $R, screw: *mut $R) =
                one(motion, screw, |motion: DualQuat<$R>| Ok(numbers(motion.to_screw())))
        }
        export_one! { $R
            /// The motion of a screw, eight numbers: direction of length 1, moment at right angles
            /// to it, angle, slide.
            motion::from_screw(numbers: *const $R, out: *mut $R) =
                one(numbers, out, |numbers: [$R; 8]| Ok(DualQuat::from_screw(screw(numbers))))
        }
    };
}
for_both_numbers!(functions);
