//! Trajectories as C samples them: those of Rust, and what is refused.

use dq8::{Backend, DualQuat, Quat};
use dq8_capi::Status;
use dq8_capi::trajectory;
use std::ptr;

macro_rules! both {
    ($R:ident, $of:ident) => {
        mod $of {
            use super::*;

            const TIMES: [$R; 3] = [0.0, 1.0, 4.0];

            fn poses() -> [DualQuat<$R>; 3] {
                [0.0, 1.0, 3.0].map(|x| {
                    let turn = Quat::from_axis_angle([0.0, 0.0, 1.0], x);
                    DualQuat::from_rotation_translation(turn, [x, 0.0, 1.0])
                })
            }

            /// What becomes of `out`, and of the index.
            fn resample(times: &[$R], at: &[$R], out: &mut [DualQuat<$R>]) -> (Status, usize) {
                let (poses, mut bad) = (poses(), 99);
                // SAFETY: arrays are as long as is said.
                let status = unsafe {
                    trajectory::$of::resample(
                        times.as_ptr(),
                        poses.as_ptr().cast(),
                        times.len(),
                        at.as_ptr(),
                        out.as_mut_ptr().cast(),
                        at.len(),
                        &mut bad,
                    )
                };
                (status, bad)
            }

            #[test]
            fn samples_are_those_of_rust() {
                let at: Vec<$R> = (-3..20).map(|i| i as $R / 4.0).collect();
                let (mut out, mut wanted) = (vec![DualQuat::ZERO; 23], vec![DualQuat::ZERO; 23]);
                assert_eq!(resample(&TIMES, &at, &mut out), (Status::Ok, 99));
                Backend::best().resample(&TIMES, &poses(), &at, &mut wanted).unwrap();
                assert_eq!(out, wanted);
            }

            #[test]
            fn what_is_refused_names_the_time_and_writes_nothing() {
                for (times, at, wanted) in [
                    ([0.0, 0.0, 1.0], 0.5, (Status::Times, 1)),
                    ([0.0, 1.0, <$R>::INFINITY], 0.5, (Status::Times, 2)),
                    (TIMES, <$R>::NAN, (Status::NotFinite, 1)),
                ] {
                    let mut out = [DualQuat::IDENTITY; 2];
                    assert_eq!(resample(&times, &[0.0, at], &mut out), wanted);
                    assert_eq!(out, [DualQuat::IDENTITY; 2]);
                }
                assert_eq!(resample(&[], &[0.0], &mut [DualQuat::IDENTITY]).0, Status::Length);
            }

            #[test]
            fn pointers_are_checked() {
                let (mut poses, at) = (poses(), [0.5]);
                let from: *const $R = poses.as_ptr().cast();
                let (into, nowhere): (*mut $R, *const $R) =
                    (poses.as_mut_ptr().cast(), ptr::null());
                let times = TIMES.as_ptr();
                // SAFETY: arrays are as long as is said, or refused.
                unsafe {
                    let resample = |times, from, at, out| {
                        trajectory::$of::resample(times, from, 3, at, out, 1, ptr::null_mut())
                    };
                    let at = at.as_ptr();
                    assert_eq!(resample(nowhere, from, at, into), Status::NullPointer);
                    assert_eq!(resample(times, nowhere, at, into), Status::NullPointer);
                    assert_eq!(resample(times, from, nowhere, into), Status::NullPointer);
                    assert_eq!(resample(times, from, at, ptr::null_mut()), Status::NullPointer);
                    assert_eq!(resample(times, from, at, into), Status::Overlap);
                    assert_eq!(
                        resample(times, from, at.wrapping_byte_add(1), into),
                        Status::Misaligned
                    );
                }
            }
        }
    };
}
both!(f32, single);
both!(f64, double);
