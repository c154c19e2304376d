//! Means of windows are those of one window at a time.

use dq8::{Backend, DualQuat, Quat};

/// Where the iterations of a mean end, and what a mean is rounded by: each squares what is left.
const SETTLED: f64 = 1e-12;
const MEANS: f64 = 2e-14;

fn poses(count: usize) -> Vec<DualQuat<f64>> {
    let pose = |i: usize| {
        let s = i as f64;
        let turn = Quat::from_axis_angle([0.36, 0.48, 0.8], (0.3 * s).sin() * 2.0);
        let pose = DualQuat::from_rotation_translation(turn, [s, (0.2 * s).cos(), -s * 0.5]);
        if i.is_multiple_of(3) { -pose } else { pose }
    };
    (0..count).map(pose).collect()
}

#[test]
fn means_of_windows_are_means_of_their_poses() {
    let weights = [1.0, 2.0, 3.0, 2.0, 1.0];
    for count in [5, 6, 12, 21] {
        let mut poses = poses(count);
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
    let poses = poses(4);
    let mut means = [DualQuat::ZERO; 2];
    let best = Backend::best();
    assert!(best.dib_windows(&poses, &weights, SETTLED, 64, &mut means).is_err());
    assert!(best.dib_windows(&poses, &[], SETTLED, 64, &mut means).is_err());
    assert_eq!(best.dib_windows(&poses, &[1.0; 3], SETTLED, 0, &mut means), Ok(0));
    assert_eq!(best.dib_windows(&poses, &weights, SETTLED, 64, &mut []), Ok(0));
}
