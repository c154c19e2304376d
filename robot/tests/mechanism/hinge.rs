//! Sine and cosine of a hinge's half angle, against `f64`. `f32` has few floats: all of them up to
//! the limit of 2¹⁷ rad were tried, and the worst are here.

use dq8::{Backend, DualQuat};
use dq8_fixtures::fusing::PORTABLE_FUSES;
use dq8_robot::{Joint, OwnedMechanism};

/// The angles at which a hinge errs most, in `f32`: of all, and up to half a turn, without fused
/// multiply-add and with it.
const WORST: [u32; 8] = [
    0x450df5f4, 0x47fec50a, 0x40490653, 0x4048a9f3, 0x464f7e0c, 0x46356077, 0x404908d8, 0x40452ee4,
];

/// What the documentation of mechanisms says: units of 2⁻²⁴, of sine and cosine.
const BOUNDS: [f64; 2] = [2.71, 3.35];

/// The same for angles up to half a turn.
const NEAR: [f64; 2] = [2.71, 2.19];

/// The number of angles that a backend gets at once.
const BLOCK: usize = 4096;

/// The largest errors of sine and cosine of half the angles.
fn worst(backend: Backend, angles: &[f32]) -> [f64; 2] {
    let hinge = [Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0])];
    let robot = OwnedMechanism::new(&hinge).unwrap();
    let mut poses = vec![DualQuat::IDENTITY; angles.len()];
    robot.view().job().backend(backend).poses(angles, &mut poses).unwrap();
    let mut worst = [0.0_f64; 2];
    for (angle, pose) in angles.iter().zip(&poses) {
        let (sin, cos) = (f64::from(*angle) / 2.0).sin_cos();
        let [x, y, z, w] = pose.real().to_array().map(f64::from);
        assert_eq!([x, y], [0.0; 2]);
        for (worst, error) in worst.iter_mut().zip([z - sin, w - cos]) {
            assert!(error.is_finite(), "{angle} rad");
            *worst = worst.max(error.abs() * 2f64.powi(24));
        }
    }
    worst
}

#[test]
fn a_hinge_errs_at_its_worst_angles_by_what_is_documented() {
    let angles = WORST.map(f32::from_bits);
    let largest = Backend::available().map(|backend| worst(backend, &angles));
    let largest = largest.fold([0.0_f64; 2], |a, b| std::array::from_fn(|i| a[i].max(b[i])));
    assert!(largest[0] <= BOUNDS[0] && largest[1] <= BOUNDS[1], "{largest:?}");
    // Some backend has no fused multiply-add, unless the build has it everywhere.
    if !PORTABLE_FUSES {
        assert!(largest[0] > BOUNDS[0] - 0.01 && largest[1] > BOUNDS[1] - 0.01, "{largest:?}");
    }
}

#[test]
fn no_angle_of_a_hinge_errs_by_more() {
    let stride = std::env::var("DQ8_SWEEP_STRIDE")
        .map_or(40_009, |text| text.parse().expect("DQ8_SWEEP_STRIDE is a whole number"));
    let half_a_turn = std::f32::consts::PI;
    for (first, last, bounds) in [(0.0, half_a_turn, NEAR), (half_a_turn, 131_072.0, BOUNDS)] {
        let mut angles = (first.to_bits()..=last.to_bits()).step_by(stride).map(f32::from_bits);
        while let block = angles.by_ref().take(BLOCK).collect::<Vec<_>>()
            && !block.is_empty()
        {
            for backend in Backend::available() {
                let [sin, cos] = worst(backend, &block);
                assert!(
                    sin <= bounds[0] && cos <= bounds[1],
                    "{backend}: {sin}, {cos} to {last} rad"
                );
            }
        }
    }
}

#[test]
fn the_documentation_says_by_how_much_a_hinge_errs() {
    let text = include_str!("../../src/lib.rs").replace("\n//! ", " ");
    let [sin, cos] = BOUNDS;
    let words = format!(
        "at most {sin} and {cos} units of 2⁻²⁴ at any angle in the range. Up to π the error of \
         the cosine is at most {}.",
        NEAR[1]
    );
    assert!(text.contains(&words), "{words}");
}
