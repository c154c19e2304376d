//! Samples and means along a trajectory are those of one motion at a time.

use dq8::slices::TrajectoryError;
use dq8::{Backend, DualQuat, Quat, ShapeError, Twist};

/// A unit motion of some lengths, normalized again.
const LAST_BITS: f64 = 1e-15;
/// A logarithm and a power of what lies between two poses that are some lengths apart.
const SAMPLED: f64 = 2e-13;
/// Where the iterations of a mean end, and what a mean is rounded by: each squares what is left.
const SETTLED: f64 = 1e-12;
const MEANS: f64 = 2e-14;

fn poses(count: usize) -> (Vec<f64>, Vec<DualQuat<f64>>) {
    let times = (0..count).map(|i| i as f64 * 0.1 + 0.03 * (i as f64).sin()).collect();
    let pose = |i: usize| {
        let s = i as f64;
        let turn = Quat::from_axis_angle([0.36, 0.48, 0.8], (0.3 * s).sin() * 2.0);
        let pose = DualQuat::from_rotation_translation(turn, [s, (0.2 * s).cos(), -s * 0.5]);
        if i.is_multiple_of(3) { -pose } else { pose }
    };
    (times, (0..count).map(pose).collect())
}

/// By the book: the segment by a search from the start, and ScLERP on it.
fn sample(times: &[f64], poses: &[DualQuat<f64>], at: f64) -> DualQuat<f64> {
    let last = times.len() - 1;
    if at <= times[0] {
        return poses[0];
    }
    if at >= times[last] {
        return poses[last];
    }
    let k = (0..last).find(|&k| at < times[k + 1]).unwrap();
    poses[k].sclerp(poses[k + 1], (at - times[k]) / (times[k + 1] - times[k]))
}

#[test]
fn samples_are_screw_motion_between_neighbours_in_any_order() {
    for count in [1, 2, 3, 40, 200] {
        let (times, poses) = poses(count);
        let end = times[count - 1];
        for samples in [0, 1, 7, 63, 64, 65, 300] {
            let rising = (0..samples).map(|i| -0.2 + (end + 0.4) * i as f64 / samples as f64);
            let rising: Vec<_> = rising.chain(times.iter().copied()).collect();
            let falling: Vec<_> = rising.iter().rev().copied().collect();
            let wild: Vec<_> = (0..rising.len()).map(|i| rising[i * 7919 % rising.len()]).collect();
            for at in [rising, falling, wild] {
                for backend in Backend::available() {
                    let mut out = vec![DualQuat::IDENTITY; at.len()];
                    backend.resample(&times, &poses, &at, &mut out).unwrap();
                    for (&at, out) in at.iter().zip(out) {
                        let wanted = sample(&times, &poses, at);
                        // Of ±σ the sign is that of one end of the segment.
                        let same =
                            out.abs_diff_eq(wanted, SAMPLED) || (-out).abs_diff_eq(wanted, SAMPLED);
                        assert!(same, "{count} poses at {at}: {out} {wanted}");
                    }
                }
            }
        }
    }
}

/// So short a step along the twist of a sample leads where the trajectory is then.
#[test]
fn twists_of_samples_lead_along_the_trajectory() {
    let (times, poses) = poses(40);
    let end = times[39];
    // None is so near to a pose that the step would go beyond it.
    let at: Vec<_> = (0..200).map(|i| -0.2 + (end + 0.4) * f64::from(i) / 200.0 + 1e-4).collect();
    let step = 1e-6;
    for backend in Backend::available() {
        let (mut now, mut later) = (vec![DualQuat::ZERO; 200], vec![DualQuat::ZERO; 200]);
        let mut twists = vec![Twist::ZERO; 200];
        backend.resample_with_twists(&times, &poses, &at, &mut now, &mut twists).unwrap();
        let soon: Vec<_> = at.iter().map(|at| at + step).collect();
        backend.resample(&times, &poses, &soon, &mut later).unwrap();
        let mut alone = now.clone();
        backend.resample(&times, &poses, &at, &mut alone).unwrap();
        assert_eq!(now, alone, "samples are the same without twists");
        for (i, at) in at.iter().enumerate() {
            let there = now[i] * DualQuat::from_twist(twists[i].scale(step));
            let same =
                there.abs_diff_eq(later[i], SAMPLED) || there.abs_diff_eq(-later[i], SAMPLED);
            assert!(same, "{backend}, at {at}: {there} {}", later[i]);
            let inside = (times[0]..end).contains(at);
            assert_eq!(
                twists[i] != Twist::ZERO,
                inside,
                "{backend}, at {at}: it moves inside only"
            );
        }
    }
    let mut untouched = [DualQuat::ZERO; 2];
    let answer = Backend::best().resample_with_twists(
        &times,
        &poses,
        &[0.0; 2],
        &mut untouched,
        &mut [Twist::ZERO; 1],
    );
    let length = ShapeError::Length { what: "twists", length: 1, expected: 2 };
    assert_eq!((answer, untouched), (Err(length.into()), [DualQuat::ZERO; 2]));
}

#[test]
fn infinite_times_are_the_ends_and_the_rest_is_refused_untouched() {
    let (times, poses) = poses(5);
    let mut out = [DualQuat::ZERO; 2];
    let best = Backend::best();
    best.resample(&times, &poses, &[f64::NEG_INFINITY, f64::INFINITY], &mut out).unwrap();
    assert!(out[0].abs_diff_eq(poses[0], LAST_BITS) && out[1].abs_diff_eq(poses[4], LAST_BITS));
    let mut out = [DualQuat::ZERO; 2];
    let mut refuse = |times: &[f64], poses: &[DualQuat<f64>], at: &[f64]| {
        let error = best.resample(times, poses, at, &mut out).unwrap_err();
        assert_eq!(out, [DualQuat::ZERO; 2]);
        assert!(!error.to_string().is_empty());
        error
    };
    assert_eq!(refuse(&[], &[], &[0.0; 2]), TrajectoryError::Empty);
    assert_eq!(
        refuse(&[0.0, 0.0], &poses[..2], &[0.0; 2]),
        TrajectoryError::NotRising { index: 1, value: 0.0 }
    );
    assert!(matches!(
        refuse(&[0.0, f64::NAN], &poses[..2], &[0.0; 2]),
        TrajectoryError::NotRising { index: 1, .. }
    ));
    assert_eq!(
        refuse(&[f64::NEG_INFINITY], &poses[..1], &[0.0; 2]),
        TrajectoryError::NotRising { index: 0, value: f64::NEG_INFINITY }
    );
    assert_eq!(refuse(&times, &poses, &[0.0, f64::NAN]), TrajectoryError::NotATime { index: 1 });
    assert!(matches!(
        refuse(&times, &poses[..2], &[0.0; 2]),
        TrajectoryError::Shape(ShapeError::Length { what: "poses", .. })
    ));
    assert!(matches!(
        refuse(&times, &poses, &[0.0; 3]),
        TrajectoryError::Shape(ShapeError::Length { what: "samples", .. })
    ));
}

#[test]
fn means_of_windows_are_means_of_their_poses() {
    let weights = [1.0, 2.0, 3.0, 2.0, 1.0];
    for count in [5, 6, 12, 21] {
        let (_, mut poses) = poses(count);
        DualQuat::make_continuous(&mut poses);
        for backend in Backend::available() {
            let mut means = vec![DualQuat::IDENTITY; count - 4];
            let converged = backend.dib_windows(&poses, &weights, SETTLED, 64, &mut means).unwrap();
            assert_eq!(converged, count - 4);
            for (window, mean) in poses.windows(5).zip(means) {
                let influences: Vec<_> = window.iter().copied().zip(weights).collect();
                let wanted = DualQuat::dib(&influences, SETTLED, 64).unwrap();
                assert!(wanted.converged && mean.abs_diff_eq(wanted.motion, MEANS), "{mean}");
            }
        }
    }
    let (_, poses) = poses(4);
    let mut means = [DualQuat::ZERO; 2];
    let best = Backend::best();
    assert!(best.dib_windows(&poses, &weights, SETTLED, 64, &mut means).is_err());
    assert!(best.dib_windows(&poses, &[], SETTLED, 64, &mut means).is_err());
    assert_eq!(best.dib_windows(&poses, &[1.0; 3], SETTLED, 0, &mut means), Ok(0));
    assert_eq!(best.dib_windows(&poses, &weights, SETTLED, 64, &mut []), Ok(0));
}

/// The difference of two times may overflow where both are finite.
#[test]
fn samples_between_the_farthest_times_are_found() {
    let poses = [0.0_f32, 2.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    let mut samples = [DualQuat::IDENTITY; 3];
    let (times, at) = ([-f32::MAX, f32::MAX], [-f32::MAX / 2.0, 0.0, f32::MAX / 2.0]);
    Backend::best().resample(&times, &poses, &at, &mut samples).unwrap();
    assert_eq!(samples.map(|pose| pose.translation()[0]), [0.5, 1.0, 1.5]);
}
