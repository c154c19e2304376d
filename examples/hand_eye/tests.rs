//! Both solutions, on robots whose X is known.

use crate::calibration::{CalibrationError, Pair};
use crate::robot::Robot;
use crate::{Solve, errors, separate, simultaneous};
use dq8::{DualQuat, Quat};

const SOLVERS: [Solve; 2] = [simultaneous::solve, separate::solve];

fn turn(axis: [f64; 3], angle: f64, translation: [f64; 3]) -> DualQuat<f64> {
    let length = axis.iter().map(|c| c * c).sum::<f64>().sqrt();
    let rotation = Quat::from_axis_angle(axis.map(|c| c / length), angle);
    DualQuat::from_rotation_translation(rotation, translation)
}

#[test]
fn without_noise_the_camera_is_found_exactly() {
    for seed in 1..=200 {
        for motions in [2, 3, 20] {
            let mut robot = Robot::new(seed);
            let pairs = robot.pairs(motions, 0.0);
            for solve in SOLVERS {
                let found = solve(&pairs).unwrap();
                let off = [robot.camera.angle_to(found), robot.camera.distance_to(found)];
                assert!(off.iter().all(|off| *off < 1e-13), "robot {seed}, {motions}: {off:?}");
                assert!(found.is_normalized());
            }
        }
    }
}

/// X at the identity, with half a turn, with no translation and with a large one; motions of a pure
/// translation between; half turns of the hand.
#[test]
fn no_place_of_the_camera_is_special() {
    let cameras = [
        DualQuat::IDENTITY,
        turn([1.0, 0.0, 0.0], std::f64::consts::PI, [0.0; 3]),
        turn([1.0, 2.0, 2.0], std::f64::consts::PI, [1.0, -2.0, 0.5]),
        DualQuat::from_translation([0.1, 0.2, 0.3]),
        turn([0.0, 0.0, 1.0], 0.5, [30.0, 0.0, -10.0]),
    ];
    let hands = [
        turn([0.0, 0.0, 1.0], 1.0, [0.0; 3]),
        DualQuat::from_translation([0.3, 0.4, -0.2]),
        turn([0.0, 1.0, 0.0], -2.0, [0.1, 0.2, 0.0]),
        DualQuat::IDENTITY,
    ];
    for camera in cameras {
        let pairs = hands.map(|hand| Pair { hand, eye: camera.conjugate() * hand * camera });
        // The signs of A and B say nothing.
        let flipped = pairs.map(|Pair { hand, eye }| Pair { hand: -hand, eye });
        let other = pairs.map(|Pair { hand, eye }| Pair { hand, eye: -eye });
        for pairs in [pairs, flipped, other] {
            for solve in SOLVERS {
                let found = solve(&pairs).unwrap();
                assert!(camera.angle_to(found) < 1e-14, "{camera:?}: {found:?}");
                // Translations are rounded in proportion to their length.
                let far = camera.translation().iter().map(|c| c.abs()).sum::<f64>();
                assert!(camera.distance_to(found) < 1e-14 * (1.0 + far), "{camera:?}: {found:?}");
            }
        }
    }
}

#[test]
fn errors_are_those_of_the_noise_and_shrink_with_the_root_of_the_motions() {
    for solve in SOLVERS {
        let at = |motions, noise| errors(solve, motions, noise).unwrap();
        let (low, high, many) = (at(10, 1e-5), at(10, 1e-3), at(40, 1e-5));
        for c in 0..2 {
            let growth = high[c] / low[c];
            assert!((99.9..100.1).contains(&growth), "a hundred times the noise: {growth}");
            let gain = low[c] / many[c];
            assert!((1.8..2.6).contains(&gain), "four times the motions: {gain}");
            assert!((0.4e-5..1e-5).contains(&low[c]), "{}", low[c]);
        }
    }
}

/// The screw congruence theorem: A and B have the same angle and slide, and so the same scalar
/// parts.
#[test]
fn hand_and_camera_move_by_congruent_screws() {
    let (mut exact, mut noisy) = (0.0_f64, 0.0_f64);
    for seed in 1..=100 {
        for pair in Robot::new(seed).pairs(10, 0.0) {
            let [hand, eye] = pair.canonical().map(DualQuat::dual_scalar);
            let off = [hand.real - eye.real, hand.dual - eye.dual];
            let all = off.into_iter().chain(pair.mismatch());
            exact = all.fold(exact, |worst, off| worst.max(off.abs()));
        }
        for pair in Robot::new(seed).pairs(10, 1e-3) {
            noisy = pair.mismatch().into_iter().fold(noisy, |worst, off| worst.max(off.abs()));
        }
    }
    assert!(exact < 2e-15, "{exact:e}");
    assert!((2e-3..8e-3).contains(&noisy), "{noisy:e}");
    // Two motions that do not belong together.
    let pairs = Robot::new(1).pairs(2, 0.0);
    let mixed = Pair { hand: pairs[0].hand, eye: pairs[1].eye };
    assert!(mixed.mismatch().iter().any(|off| off.abs() > 0.1));
}

#[test]
fn motions_that_leave_the_camera_open_are_refused() {
    let camera = turn([1.0, 2.0, 3.0], 0.7, [0.1, 0.0, 0.2]);
    let seen = |hands: &[DualQuat<f64>]| -> Vec<Pair> {
        let pair =
            |hand: &DualQuat<f64>| Pair { hand: *hand, eye: camera.conjugate() * *hand * camera };
        hands.iter().map(pair).collect()
    };
    let about_z = |angle, x| turn([0.0, 0.0, 1.0], angle, [x, 0.5, -x]);
    let slide = DualQuat::from_translation([0.2, 0.1, 0.5]);
    for solve in SOLVERS {
        assert_eq!(solve(&[]), Err(CalibrationError::TooFew { motions: 0 }));
        assert_eq!(
            solve(&seen(&[about_z(1.0, 0.3)])),
            Err(CalibrationError::TooFew { motions: 1 })
        );
        // Parallel, antiparallel, with translations between, a turn too small to have an axis,
        // translations only, none at all.
        for hands in [
            &[about_z(1.0, 0.3), about_z(0.4, 0.0), about_z(-1.5, 0.1)][..],
            &[about_z(1.0, 0.3), slide, DualQuat::IDENTITY],
            &[about_z(1.0, 0.3), turn([1.0, 0.0, 0.0], 1e-8, [0.1, 0.0, 0.0])],
            &[slide, slide * slide],
            &[DualQuat::IDENTITY; 3],
        ] {
            let refused = solve(&seen(hands)).unwrap_err();
            assert!(
                matches!(refused, CalibrationError::ParallelAxes { largest_sine } if largest_sine < 1e-12)
            );
            assert!(refused.to_string().starts_with("all axes of rotation are parallel"));
        }
        for bad in [f64::NAN, f64::INFINITY, 3.0] {
            let mut pairs = seen(&[about_z(1.0, 0.3), slide]);
            let mut components = pairs[1].eye.to_array();
            components[3] = bad;
            pairs[1].eye = DualQuat::from_array(components);
            assert_eq!(solve(&pairs), Err(CalibrationError::NoMotion { index: 1 }));
        }
    }
}

/// (λ₁ − 1.3·10⁻⁷ λ₂)(λ₁ − 1.7·10⁷ λ₂), where −b and the root of the
/// discriminant are nearly the same; and the one with both signs changed.
#[test]
fn both_roots_of_the_quadratic_are_precise() {
    let (small, large) = (1.3e-7, 1.7e7);
    for sign in [1.0, -1.0] {
        let roots = simultaneous::roots(1.0, -sign * (small + large), small * large);
        let mut ratios = roots.map(|[l1, l2]| l1 / l2);
        ratios.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        for (ratio, wanted) in ratios.into_iter().zip([small, large]) {
            assert!((ratio / (sign * wanted) - 1.0).abs() < 1e-15, "{ratio} for {wanted}");
        }
    }
    // A double root, and one that noise has made complex.
    for c in [1.0, 1.0 + 1e-9] {
        let roots = simultaneous::roots(1.0, -2.0, c);
        assert!(roots.iter().all(|[l1, l2]| (l1 / l2 - 1.0).abs() < 1e-8));
    }
    assert!(simultaneous::roots(0.0, 0.0, 0.0).iter().flatten().all(|l| l.is_finite()));
}

/// A robot on a floor turns about one axis; with noise there are many, and none of them says how
/// high the camera sits.
#[test]
fn motions_in_a_plane_are_refused_with_any_noise_and_others_are_not() {
    for noise in [1e-6, 1e-5, 1e-4, 1e-3, 1e-2] {
        for seed in 1..=20 {
            let mut random = dq8_fixtures::random::Random(seed);
            let camera = random.motion(0.3);
            let axis: [f64; 3] = random.direction();
            let mut off = || {
                let twist = random.vector::<6>().map(|x| noise * x);
                DualQuat::from_twist(dq8::Twist::from_array(twist))
            };
            let mut pairs = |about: &dyn Fn(usize) -> [f64; 3]| -> Vec<Pair> {
                let pair = |i: usize| {
                    let angle = 0.1 + 0.05 * i as f64;
                    let hand = turn(about(i), angle, [0.3 + 0.1 * i as f64, 0.2, 0.0]);
                    Pair { hand: hand * off(), eye: camera.conjugate() * hand * camera * off() }
                };
                (0..20).map(pair).collect()
            };
            let [a, b, c] = [axis, [axis[1], axis[2], axis[0]], [axis[2], axis[0], -axis[1]]];
            let plane = pairs(&|_| axis);
            let space = pairs(&|i| [a, b, c][i % 3]);
            for solve in SOLVERS {
                let refused = solve(&plane).unwrap_err();
                assert!(
                    matches!(refused, CalibrationError::NoisyAxes { ratio } if ratio < 2.5),
                    "{noise}: {refused}"
                );
                let found = solve(&space).unwrap();
                assert!(camera.angle_to(found) < 20.0 * noise, "{noise}");
            }
        }
    }
}
