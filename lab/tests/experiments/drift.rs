//! Drift: what the report says of it, with fewer frames.

use dq8::{DualQuat, Quat, representation::RotationTranslation};
use lab::drift::{
    ARRIVAL, Deviation, Findings, Homogeneous, Loop, METHODS, Measure, Order, Repair,
    Representation, Sample, against_ideal, findings, follow, trace,
};
use lab::matrix;
use nalgebra::{Matrix3, Matrix4, Rotation3, Unit, Vector3};
use std::sync::OnceLock;

const FRAMES: usize = 4000;
const ORDERS: [Order; 2] = [Order::StateStep, Order::StepState];

/// Of one run for all tests.
fn run(order: Order) -> &'static Findings {
    static RUNS: OnceLock<[Findings; 2]> = OnceLock::new();
    &RUNS.get_or_init(|| ORDERS.map(|order| findings(FRAMES, order)))[order as usize]
}

fn samples(order: Order) -> &'static [Sample; METHODS.len()] {
    &run(order).last
}

fn sample<'a>(samples: &'a [Sample; METHODS.len()], name: &str) -> &'a Sample {
    let position = METHODS.iter().position(|method| method.name == name);
    &samples[position.unwrap_or_else(|| panic!("no method {name}"))]
}

#[test]
fn what_is_kept_in_order_stays_rigid_and_what_is_left_alone_does_not() {
    for order in ORDERS {
        let samples = samples(order);
        for name in [
            "matrix, Gram–Schmidt",
            "dual quaternion, normalized",
            "quaternion + vector, normalized",
        ] {
            let sample = sample(samples, name);
            for measure in [Measure::Skew, Measure::Stretch, Measure::Norm] {
                assert!(sample.error(measure) < 5e-6, "{order:?}, {name}, {measure:?}: {sample:?}");
            }
        }
        for name in ["matrix", "dual quaternion", "quaternion + vector"] {
            let sample = sample(samples, name);
            assert!(sample.error(Measure::Skew) > 2e-5, "{order:?}, {name}: {sample:?}");
            assert!(sample.error(Measure::Stretch) > 1e-4, "{order:?}, {name}: {sample:?}");
        }
    }
}

/// Against Kenwright §12.
#[test]
fn dual_quaternions_left_alone_drift_no_less_than_matrices() {
    for order in ORDERS {
        let samples = samples(order);
        for name in ["dual quaternion", "dual quaternion, Kenwright's matrix"] {
            for measure in [Measure::Stretch, Measure::Position] {
                let [dual, matrix] =
                    [name, "matrix"].map(|name| sample(samples, name).error(measure));
                assert!(dual > matrix, "{order:?}, {name}, {measure:?}: {dual} {matrix}");
            }
        }
        let [dual, matrix] =
            ["dual quaternion", "matrix"].map(|name| sample(samples, name).error(Measure::Skew));
        assert!(dual > matrix, "{order:?}, as unit quaternions turn points: {dual} {matrix}");
    }
}

/// For Kenwright §12: what skews is the short formula, which takes |p| = 1 for granted.
#[test]
fn by_kenwrights_own_matrix_dual_quaternions_left_alone_scale_and_do_not_skew() {
    for order in ORDERS {
        let worst = &run(order).worst;
        let listing = sample(worst, "dual quaternion, Kenwright's matrix");
        assert!(listing.error(Measure::Skew) < 1e-15, "{order:?}: {listing:?}");
        assert!(listing.error(Measure::Stretch) > 1e-4, "{order:?}: {listing:?}");
        let matrix = sample(worst, "matrix");
        assert!(matrix.error(Measure::Skew) > 1e-5, "{order:?}: {matrix:?}");
    }
}

/// Kenwright §10.1: in no frame does repair move the end by more than rounding does.
#[test]
fn gram_schmidt_brings_the_end_closer_by_steps_too_small_to_see() {
    for order in ORDERS {
        let samples = samples(order);
        let [raw, kept] = ["matrix", "matrix, Gram–Schmidt"].map(|name| sample(samples, name));
        let position = kept.error(Measure::Position);
        assert!(position < 0.5 * raw.error(Measure::Position), "{order:?}: {raw:?} {kept:?}");
        let worst = sample(&run(order).worst, "matrix, Gram–Schmidt");
        assert!((1e-7..1e-5).contains(&worst.error(Measure::Jump)), "{order:?}: {worst:?}");
    }
}

/// Kenwright §10.1: "the ideal end-effector's position and rotation were also different".
#[test]
fn the_end_of_orthonormal_matrices_is_off_by_more_than_that_of_normalized_dual_quaternions() {
    for order in ORDERS {
        let [matrix, dual] = ["matrix, Gram–Schmidt", "dual quaternion, normalized"]
            .map(|name| sample(samples(order), name).error(Measure::Position));
        assert!((1.2..4.0).contains(&(matrix / dual)), "{order:?}: {matrix} {dual}");
        assert!(matrix > 5e-5, "{order:?}: {matrix}");
    }
}

/// Kenwright §10: matrices repaired "at each level (and at each update frame)", with a solver that
/// sees them.
fn repaired(order: Order, repair: Repair, closed: Loop) -> [Deviation; 2] {
    let run = [FRAMES, 1000];
    [
        against_ideal(run, order, (repair, Homogeneous::<f32>::gram_schmidt as fn(_) -> _), closed),
        against_ideal(run, order, (repair, DualQuat::<f32>::normalize as fn(_) -> _), closed),
    ]
}

#[test]
fn no_joint_jumps_wherever_the_repair_and_whatever_the_solver_sees() {
    for order in ORDERS {
        for closed in [Loop::Open, Loop::Closed] {
            for repair in Repair::ALL {
                for deviation in repaired(order, repair, closed) {
                    assert!(deviation.jump < 2e-5, "{order:?}, {repair:?}: {}", deviation.jump);
                }
            }
        }
    }
}

#[test]
fn repair_at_each_level_mends_skew_and_scale_and_leaves_the_end_off_the_ideal() {
    for order in ORDERS {
        for closed in [Loop::Open, Loop::Closed] {
            let [left_alone, _] = repaired(order, Repair::Never, closed);
            for repair in [Repair::Levels, Repair::Both] {
                let [matrix, _] = repaired(order, repair, closed);
                assert!(matrix.skew < 1e-6 && matrix.stretch < 2e-6, "{order:?}, {repair:?}");
                assert!(left_alone.skew > 1e-5 && left_alone.stretch > 1e-4, "{order:?}");
                assert!(matrix.position < 0.5 * left_alone.position, "{order:?}, {repair:?}");
                assert!(matrix.position > 2e-5, "{order:?}, {repair:?}: {}", matrix.position);
            }
        }
    }
}

/// The end is where the solver wants it, and the chain behind it is not where the ideal one is.
#[test]
fn a_solver_that_sees_the_drift_keeps_the_end_on_its_target() {
    for order in ORDERS {
        let [open, closed] =
            [Loop::Open, Loop::Closed].map(|which| repaired(order, Repair::Never, which));
        for (open, closed) in open.iter().zip(closed) {
            assert!(closed.missed.position < 1.2e-4, "{order:?}: {:?}", closed.missed);
            assert!(open.missed.position > 4.0 * closed.missed.position, "{order:?}");
            assert!(closed.position > 0.5 * open.position, "{order:?}: {}", closed.position);
        }
    }
}

#[test]
fn normalizing_keeps_links_that_gram_schmidt_does_not() {
    let step_state = samples(Order::StepState);
    let [matrix, dual] = ["matrix, Gram–Schmidt", "dual quaternion, normalized"]
        .map(|name| sample(step_state, name).error(Measure::Link));
    assert!(10.0 * dual < matrix, "{dual} {matrix}");
    // A translation that is multiplied by nothing is not rounded.
    let state_step = samples(Order::StateStep);
    for name in ["matrix", "quaternion + vector"] {
        assert_eq!(sample(state_step, name).error(Measure::Link), 0.0, "{name}");
    }
    assert!(sample(state_step, "dual quaternion").error(Measure::Link) > 1e-5);
}

#[test]
fn kenwrights_normalize_keeps_nothing_normalized() {
    for order in ORDERS {
        let samples = samples(order);
        let [right, wrong] =
            ["dual quaternion, normalized", "dual quaternion, Kenwright's Normalize"]
                .map(|name| sample(samples, name).error(Measure::Norm));
        assert!(50.0 * right < wrong, "{order:?}: {right} {wrong}");
    }
}

/// The reference is one of dual quaternions; another algebra follows it.
#[test]
fn in_double_precision_all_representations_agree() {
    for order in ORDERS {
        let (steps, missed) = follow(FRAMES, 1000, order);
        assert!(missed.position < 1e-3, "{order:?}: {missed:?}");
        let traces = [
            trace::<Homogeneous<f64>>(&steps, order, FRAMES, |state| state),
            trace::<RotationTranslation<f64>>(&steps, order, FRAMES, |state| state),
        ];
        for samples in traces {
            assert_eq!(samples.len(), 1);
            for measure in Measure::ALL {
                assert!(samples[0].error(measure) < 2e-12, "{order:?}, {measure:?}: {samples:?}");
            }
        }
    }
}

/// With position and orientation, in every frame after it has arrived: six degrees of freedom.
#[test]
fn the_chain_follows_targets_of_every_speed() {
    for order in ORDERS {
        for round in lab::drift::ROUNDS {
            let (_, missed) = follow(FRAMES, round, order);
            const { assert!(FRAMES > 2 * ARRIVAL) };
            assert!(missed.position < 3e-3, "{order:?}, {round}: {missed:?}");
            assert!(missed.angle < 1e-3, "{order:?}, {round}: {missed:?}");
        }
    }
}

#[test]
fn a_long_quaternion_skews_by_the_short_formula_and_only_scales_by_the_sandwich() {
    let unit = Quat::from_axis_angle([0.48, 0.6, 0.64], 1.1_f64);
    let long = unit.scale(1.01);
    let short = matrix::left(DualQuat::from_rotation(long).to_matrix());
    assert!(matrix::skew(short) > 1e-3);
    let axes: [[f64; 3]; 3] = core::array::from_fn(|axis| {
        let mut v = [0.0; 3];
        v[axis] = 1.0;
        (long * Quat::from_parts(v, 0.0) * long.conjugate()).xyz()
    });
    let sandwich = core::array::from_fn(|i| core::array::from_fn(|j| axes[j][i]));
    assert!(matrix::skew(sandwich) < 1e-15);
    assert!((matrix::stretch(sandwich) - (1.01_f64.powi(4) - 1.0)).abs() < 1e-14);
}

#[test]
fn textbook_matrices_agree_with_nalgebra() {
    let (axis, angle) = ([0.48, 0.6, 0.64], 0.7);
    let rotation = matrix::about(axis, angle);
    let theirs = Rotation3::from_axis_angle(&Unit::new_normalize(Vector3::from(axis)), angle);
    let rows = |rows: [[f64; 3]; 3]| Matrix3::from_fn(|i, j| rows[i][j]);
    assert!((rows(rotation) - theirs.matrix()).amax() < 1e-15);

    let angles = [0.3, -0.8, 1.9];
    let [x, y, z] = matrix::about_axes(angles);
    let axes = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()];
    for (turn, (axis, angle)) in [x, y, z].into_iter().zip(axes.into_iter().zip(angles)) {
        assert!((rows(turn) - Rotation3::from_axis_angle(&axis, angle).matrix()).amax() < 1e-15);
    }

    let bent = [[1.1, 0.2, -0.1], [0.1, 0.9, 0.3], [0.2, -0.1, 1.2]];
    // QR of the transpose has the rows in its first factor, but for signs.
    let (q, r) = rows(bent).transpose().qr().unpack();
    let signed = q * Matrix3::from_diagonal(&r.diagonal().map(f64::signum));
    assert!((rows(matrix::gram_schmidt(bent)) - signed.transpose()).amax() < 1e-15);
    assert!((matrix::skew(bent) - 0.29).abs() < 1e-15);

    let a = [[0.0, -1.0, 0.0, 2.0], [0.6, 0.0, -0.8, 1.0], [0.8, 0.0, 0.6, -3.0]];
    let four = |rows: [[f64; 4]; 3]| Matrix4::from_fn(|i, j| matrix::homogeneous(rows)[i][j]);
    let product = matrix::affine_product(a, matrix::rigid_inverse(a));
    assert!((four(product) - Matrix4::identity()).amax() < 1e-15);
    assert!((four(matrix::affine_product(a, a)) - four(a) * four(a)).amax() < 1e-15);
    let wide = matrix::homogeneous(a);
    let schoolbook = matrix::product(wide, wide);
    assert!((Matrix4::from_fn(|i, j| schoolbook[i][j]) - four(a) * four(a)).amax() < 1e-15);
}
