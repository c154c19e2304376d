//! The peers in `peers.cpp`.

use crate::sizes::{CONTROL, POINTS, POSES};
use dq8::Scalar;
use dq8_trajectory::Time;

/// A quaternion x, y, z, w and a translation.
pub(crate) type Pose = [f64; 7];

/// Points that go along a trajectory of stamps and poses; whether times rise; times and points.
pub(crate) type Path<R> = extern "C" fn(
    &[f64; POSES],
    &[Pose; POSES],
    bool,
    &[R; POINTS],
    &[[R; 3]; POINTS],
    &mut [[R; 3]; POINTS],
);
/// Points that go along a twist.
pub(crate) type Twist<R> =
    extern "C" fn(&[f64; 6], &[R; POINTS], &[[R; 3]; POINTS], &mut [[R; 3]; POINTS]);
/// Poses and twists on a spline; whether logarithms are kept.
pub(crate) type Spline<R> = extern "C" fn(
    &[Pose; CONTROL],
    bool,
    &[R; POINTS],
    &mut [[R; 7]; POINTS],
    &mut [[R; 6]; POINTS],
);

macro_rules! peers {
    ($($number:ty: $slerp_lerp:ident $screws:ident $constant_twist:ident $spline:ident)*) => {
        // SAFETY: `peers.cpp` defines these functions with references to arrays of the same sizes,
        // which both have from `sizes.rs`. They keep no reference and throw nothing.
        unsafe extern "C" {$(
            safe fn $slerp_lerp(
                stamps: &[f64; POSES],
                poses: &[Pose; POSES],
                rises: bool,
                times: &[$number; POINTS],
                points: &[[$number; 3]; POINTS],
                moved: &mut [[$number; 3]; POINTS],
            );
            safe fn $screws(
                stamps: &[f64; POSES],
                poses: &[Pose; POSES],
                rises: bool,
                times: &[$number; POINTS],
                points: &[[$number; 3]; POINTS],
                moved: &mut [[$number; 3]; POINTS],
            );
            safe fn $constant_twist(
                twist: &[f64; 6],
                times: &[$number; POINTS],
                points: &[[$number; 3]; POINTS],
                moved: &mut [[$number; 3]; POINTS],
            );
            safe fn $spline(
                control: &[Pose; CONTROL],
                keeps: bool,
                times: &[$number; POINTS],
                poses: &mut [[$number; 7]; POINTS],
                twists: &mut [[$number; 6]; POINTS],
            );
        )*}
        $(impl Number for $number {
            const SLERP_LERP: Path<Self> = $slerp_lerp;
            const SCREWS: Path<Self> = $screws;
            const CONSTANT_TWIST: Twist<Self> = $constant_twist;
            const SPLINE: Spline<Self> = $spline;
        })*
    };
}
peers! {
    f32: slerp_lerp_float screws_float constant_twist_float spline_float
    f64: slerp_lerp_double screws_double constant_twist_double spline_double
}

/// The numbers that the peers compute with.
pub(crate) trait Number: Scalar + Time + Into<f64> {
    const SLERP_LERP: Path<Self>;
    const SCREWS: Path<Self>;
    const CONSTANT_TWIST: Twist<Self>;
    const SPLINE: Spline<Self>;
}
