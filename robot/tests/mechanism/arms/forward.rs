//! Poses of arms from screws against nalgebra, how far they get, and screws that make no arm.

use super::super::reach::REACHED;
use dq8::geometry::Screw;
use dq8::scalar::vector;
use dq8::{DualQuat, Line, Twist};
use dq8_arms::{Arm, Axis, Plan, Random, Z, exact, gantry, puma, rounded, six_of_any_kind, ur5};
use dq8_robot::ik::{Options, Outcome};
use dq8_robot::{Mechanism, MechanismError, OwnedMechanism, Step, World};

/// Six or seven joints with lever arms of about 1: two roundings for each.
const ROUNDING: f64 = 4e-15;
/// The same in `f32`.
const IN_SINGLE: f64 = 2e-6;

/// What a screw is for a value of 1, with limits ±π.
fn screw(direction: [f64; 3], through: [f64; 3], angle: f64, slide: f64) -> (Screw<f64>, [f64; 2]) {
    let axis = Line::from_point_direction(through, direction);
    (Screw { axis, angle, slide }, [-core::f64::consts::PI, core::f64::consts::PI])
}

/// Poses by nalgebra; and where all values are zero, the columns of the Jacobian are the screws.
fn is_a_product_of_motions<const N: usize>(plan: &Plan<N>) {
    let (arm, single) = (plan.arm::<f64>(), plan.arm::<f32>());
    let mut random = Random(1);
    let all: Vec<_> = (0..50).map(|_| plan.draw(&mut random)).collect();
    let mut on_lanes = vec![DualQuat::IDENTITY; all.len()];
    let mechanism = arm.0.view().mechanism();
    mechanism.job().links(&[N]).poses(all.as_flattened(), &mut on_lanes).expect("lengths fit");
    for (values, on_lanes) in all.iter().zip(on_lanes) {
        let wanted = plan.isometry(values).to_homogeneous();
        let in_single = DualQuat::from_array(exact(single.forward(&rounded(*values)).to_array()));
        let from_joints = OwnedMechanism::new(&plan.links()).expect("an arm");
        let from_joints = from_joints.link_pose(values, N).expect("a link");
        for (pose, bound) in [
            (arm.forward(values), ROUNDING),
            (on_lanes, ROUNDING),
            (from_joints, ROUNDING),
            (in_single, IN_SINGLE),
        ] {
            for (row, numbers) in pose.to_matrix3x4().into_iter().enumerate() {
                for (column, number) in numbers.into_iter().enumerate() {
                    let error = (number - wanted[(row, column)]).abs();
                    assert!(error < bound, "{row}, {column}: {error}");
                }
            }
        }
    }
    let mut columns = [Twist::default(); N];
    mechanism.link_jacobian(World, &[0.0; N], N, &mut columns).expect("lengths fit");
    for (column, Axis { direction, through, pitch, .. }) in columns.iter().zip(plan.axes) {
        let angular = if pitch.is_some() { direction } else { [0.0; 3] };
        let moment = vector::cross(through, angular);
        let linear = vector::scale(direction, pitch.unwrap_or(1.0));
        let wanted = Twist { angular, linear: vector::add(moment, linear) };
        for (got, wanted) in column.to_array().into_iter().zip(wanted.to_array()) {
            assert!((got - wanted).abs() < ROUNDING, "{got} for {wanted}");
        }
    }
}

#[test]
fn the_pose_is_the_product_of_the_motions_of_the_joints() {
    is_a_product_of_motions(&ur5());
    is_a_product_of_motions(&puma());
    is_a_product_of_motions(&gantry());
    (0..10).for_each(|seed| is_a_product_of_motions(&six_of_any_kind(&mut Random(seed))));
}

#[test]
fn the_end_is_never_farther_than_the_bound() {
    fn nearest<const N: usize>(plan: &Plan<N>) -> f64 {
        let (mut random, mut nearest) = (Random(4), f64::INFINITY);
        let (centre, length) = plan.arm::<f64>().bound();
        for _ in 0..2000 {
            let end = plan.isometry(&plan.draw(&mut random)).translation.vector;
            let far = (end - nalgebra::Vector3::from(centre)).norm();
            assert!(far <= length, "{far} of {length}");
            nearest = nearest.min(length - far);
        }
        nearest
    }
    nearest(&gantry());
    let nearest = nearest(&ur5()).min(nearest(&puma()));
    assert!(nearest < 0.25, "the bound is of use: {nearest}");
}

/// The sum of the shortest ways from axis to axis: where points on the axes lie does not matter.
#[test]
fn the_bound_does_not_depend_on_where_along_its_axis_a_hinge_is_given() {
    let (near, mut far) = (ur5(), ur5());
    for (index, axis) in far.axes.iter_mut().enumerate() {
        let along = index as f64 - 2.0;
        for (through, direction) in axis.through.iter_mut().zip(axis.direction) {
            *through += along * direction;
        }
    }
    let [(a, short), (b, long)] = [near, far].map(|plan| plan.arm::<f64>().bound());
    assert!((short - long).abs() < ROUNDING, "{short} {long}");
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < ROUNDING), "{a:?} {b:?}");
}

/// Where all of the way is the pitch of one screw, the bound is that way; and it is searched as the
/// thread that it is.
#[test]
fn a_screw_reaches_as_far_as_its_pitch_takes_it() {
    for pitch in [0.5, -0.5] {
        for limits in [[0.0, 8.0], [-8.0, 1.0], [-1.0, 8.0]] {
            let (thread, _) = screw(Z, [0.0; 3], 1.0, pitch);
            let arm = Arm::new(&[(thread, limits)], DualQuat::IDENTITY).unwrap();
            assert_eq!(arm.bound(), ([0.0; 3], 4.0));
            // The fixed tool is turned along: with fused multiply-adds that rounds once.
            let [x, y, z] = arm.forward(&[8.0]).translation();
            assert!([x, y, z - 8.0 * pitch].iter().all(|c| c.abs() < ROUNDING), "{x} {y} {z}");
        }
    }
    for pitch in [1.0, -1.0, 0.5] {
        let (thread, _) = screw(Z, [0.0; 3], 1.0, pitch);
        let arm = Arm::new(&[(thread, [-2.0, 2.0])], DualQuat::IDENTITY).unwrap();
        let mut values = [0.1_f64];
        let report = arm.reach(arm.forward(&[1.25]), &mut values, &Options::default());
        assert_eq!(report.outcome, Outcome::Converged, "{pitch}");
        assert!((values[0] - 1.25).abs() < REACHED, "{pitch}: {values:?}");
    }
}

#[test]
fn the_moment_of_a_slide_does_not_matter() {
    let (mut slide, limits) = screw(Z, [0.0; 3], 0.0, 1.0);
    for moment in [[0.0; 3], [1.0, 2.0, 0.0], [f64::NAN; 3]] {
        slide.axis.moment = moment;
        let hinge = screw([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 1.0, 0.0);
        let home = DualQuat::from_translation([0.0, 0.0, 2.0]);
        let arm = Arm::new(&[(slide, limits), hinge], home).expect("an arm");
        assert_eq!(arm.forward(&[0.5, 0.0]).translation(), [0.0, 0.0, 2.5], "{moment:?}");
    }
}

#[test]
fn screws_that_make_no_arm_are_named() {
    let good = screw(Z, [1.0, 0.0, 0.0], 1.0, 0.0);
    let home = DualQuat::<f64>::IDENTITY;
    let refused = |bad: (Screw<f64>, [f64; 2])| {
        OwnedMechanism::from_screws(&[good, bad], home).map(|_| ()).unwrap_err()
    };
    let (inf, nan) = (f64::INFINITY, f64::NAN);

    let origin = [0.0; 3];
    for length in [0.5, 0.0, 0.9989, 1.0011] {
        let error = refused(screw([0.0, 0.0, length], origin, 1.0, 0.0));
        assert_eq!(error, MechanismError::Axis { joint: 1, length });
    }
    for bad in [nan, inf] {
        let error = refused(screw([0.0, bad, 1.0], origin, 1.0, 0.0));
        assert!(matches!(error, MechanismError::Axis { joint: 1, .. }), "{error}");
        let error = refused(screw(Z, [bad, 0.0, 0.0], 1.0, 0.0)).to_string();
        assert!(error.starts_with("the moment of joint 1 is not finite"), "{error}");
    }
    for (angle, slide) in
        [(0.0, 0.0), (2.0, 0.0), (-1.0, 0.0), (0.0, 2.0), (0.0, -1.0), (1.0, inf), (0.5, 0.5)]
            .into_iter()
            .chain([(nan, 0.0), (1.0, nan), (0.0, nan)])
    {
        let error = refused(screw(Z, origin, angle, slide));
        let wanted = MechanismError::Screw { joint: 1, angle, slide };
        assert_eq!(format!("{error:?}"), format!("{wanted:?}"));
    }
    for limits in [[1.0, 0.0], [nan, 0.0], [0.0, nan]] {
        let error = refused((good.0, limits));
        assert!(matches!(error, MechanismError::Limits { joint: 1, .. }), "{error}");
    }
    for home in [home.scale(2.0), home.scale(nan), DualQuat::ZERO] {
        let error = OwnedMechanism::from_screws(&[good, good], home).unwrap_err();
        assert!(matches!(error, MechanismError::Placement { joint: 2, .. }), "{error}");
    }
    for at in [nan, inf] {
        let home = DualQuat::from_translation([at, 0.0, 0.0]);
        for screws in [vec![], vec![good], vec![screw(Z, [0.0; 3], 0.0, 1.0)]] {
            let joint = screws.len();
            let error = OwnedMechanism::from_screws(&screws, home).unwrap_err();
            let names = matches!(error, MechanismError::NotFinite { joint: found, .. }
                | MechanismError::DualPart { joint: found, .. } if found == joint);
            assert!(names, "{error}");
        }
    }
    // Axes so far apart that a float has no number for the way between them.
    let apart = [-3e38_f32, 3e38].map(|x| {
        let axis = Line::from_point_direction([x, 0.0, 0.0], [0.0, 0.0, 1.0]);
        (Screw { axis, angle: 1.0, slide: 0.0 }, [-1.0, 1.0])
    });
    let error = OwnedMechanism::from_screws(&apart, DualQuat::IDENTITY).unwrap_err();
    assert!(matches!(error, MechanismError::NotFinite { joint: 1, .. }), "{error}");

    let mut steps = [Step::default(); 2];
    let error = Mechanism::from_screws(&[good, good], home, &mut steps).unwrap_err();
    assert_eq!(error, MechanismError::Steps { steps: 2, joints: 3 });
    assert_eq!(
        MechanismError::Screw { joint: 1, angle: 0.5, slide: 0.0 }.to_string(),
        "the screw of joint 1 turns by 0.5 and slides by 0 for a value of 1: a hinge or a thread must \
         turn by 1, and a slide must turn by 0 and slide by 1"
    );
}
