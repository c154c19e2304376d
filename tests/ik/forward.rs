//! Poses and Jacobians of arms against nalgebra, automatic differentiation and hierarchies.

use super::REACHED;
use super::arms::{Plan, Random, gantry, puma, rounded, ur5};
use dq8::ik::{Arm, ArmError, Joint, Options, Outcome};
use dq8::{Dual, DualQuat, Hierarchy, Quat, Twist, simd::Portable};

/// Six or seven joints with lever arms of about 1: two roundings for each.
const ROUNDING: f64 = 4e-15;
/// The same in `f32`.
const IN_SINGLE: f64 = 2e-6;
/// Columns are moments of axes, twice as many roundings.
const DERIVED: f64 = 8e-15;
/// A central difference h = 1e-5 apart: h² is cut off, and roundoff is divided by h.
const BY_DIFFERENCE: f64 = 5e-10;

fn poses_are_those_of_nalgebra<const N: usize>(plan: &Plan<N>) {
    let (arm, single) = (plan.arm::<f64>(), plan.arm::<f32>());
    let mut random = Random(1);
    for _ in 0..50 {
        let values = plan.draw(&mut random);
        let wanted = plan.isometry(&values).to_homogeneous();
        let on_lanes = arm.forward_lanes(Portable, &values).to_matrix3x4();
        let matrix = arm.forward(&values).to_matrix3x4();
        let in_single = single.forward(&rounded(values)).to_matrix3x4();
        for row in 0..3 {
            for column in 0..4 {
                let wanted = wanted[(row, column)];
                assert!((matrix[row][column] - wanted).abs() < ROUNDING, "{row}, {column}");
                assert!((on_lanes[row][column] - wanted).abs() < ROUNDING, "{row}, {column}");
                assert!((f64::from(in_single[row][column]) - wanted).abs() < IN_SINGLE);
            }
        }
    }
}

#[test]
fn the_pose_is_the_product_of_the_motions_of_the_joints() {
    poses_are_those_of_nalgebra(&ur5());
    poses_are_those_of_nalgebra(&puma());
    poses_are_those_of_nalgebra(&gantry());
}

fn columns_are_derivatives<const N: usize>(plan: &Plan<N>) {
    let (arm, dual) = (plan.arm::<f64>(), plan.arm::<Dual<f64>>());
    let mut random = Random(2);
    // The first at zero, where the UR5 is stretched.
    let mut values = [0.0; N];
    for _ in 0..20 {
        let (pose, columns) = arm.forward_jacobian(Portable, &values);
        let pose = DualQuat::from_array(pose.to_array());
        for (joint, column) in columns.iter().enumerate() {
            let mut moving = values.map(|value| Dual::new(value, 0.0));
            moving[joint].dual = 1.0;
            let derivative = dual.forward(&moving).to_array().map(|c| c.dual);
            let wanted = pose.spatial_twist(DualQuat::from_array(derivative));

            let at = |step: f64| {
                let mut values = values;
                values[joint] += step;
                arm.forward(&values)
            };
            let step = 1e-5;
            let difference = (at(step) * at(-step).conjugate()).to_twist().scale(0.5 / step);
            for i in 0..6 {
                let [got, wanted, difference] =
                    [*column, wanted, difference].map(|t| t.to_array()[i]);
                assert!((got - wanted).abs() < DERIVED, "joint {joint}: {got} for {wanted}");
                assert!(
                    (got - difference).abs() < BY_DIFFERENCE,
                    "joint {joint}: {got} for {difference}"
                );
            }
        }
        values = plan.draw(&mut random);
    }
}

#[test]
fn the_jacobian_is_what_differentiation_finds() {
    columns_are_derivatives(&ur5());
    columns_are_derivatives(&puma());
    columns_are_derivatives(&gantry());
}

/// The chain of ancestors of a joint, with screws moved from the joints' frames to the base.
#[test]
fn the_jacobian_is_that_of_the_hierarchy() {
    let parents = [Hierarchy::ROOT, 0, 1, 1, 3];
    let hierarchy = Hierarchy::new(&parents).expect("parents come first");
    let mut random = Random(3);
    let rest: [DualQuat<f64>; 5] = core::array::from_fn(|_| {
        let turn = Quat::from_array(random.vector()).normalize();
        DualQuat::from_rotation_translation(turn, random.vector())
    });
    let hinge = Twist { angular: [0.6, 0.0, 0.8], linear: [0.0; 3] };
    let slide = Twist { angular: [0.0; 3], linear: [0.0, 0.6, 0.8] };
    let axes = [hinge, slide, hinge, hinge, hinge];
    let chain = [0, 1, 3, 4];

    let mut at_rest = rest;
    hierarchy.job().local_to_model_in_place(&mut at_rest).expect("they fit");
    let joints = chain.map(|joint: usize| Joint {
        screw: at_rest[joint].adjoint(axes[joint]),
        limits: [-1.0, 1.0],
    });
    let arm = Arm::new(joints, at_rest[4]).expect("the chain is an arm");

    let values: [f64; 4] = random.vector();
    let mut models = rest;
    for (&joint, &value) in chain.iter().zip(&values) {
        models[joint] = rest[joint] * DualQuat::from_twist(axes[joint].scale(value));
    }
    hierarchy.job().local_to_model_in_place(&mut models).expect("they fit");
    let wanted: [_; 5] = core::array::from_fn(|joint| models[joint].adjoint(axes[joint]));

    let (pose, columns) = arm.forward_jacobian(Portable, &values);
    let pose = DualQuat::from_array(pose.to_array());
    assert!(pose.distance_to(models[4]) + pose.angle_to(models[4]) < ROUNDING);
    for (column, joint) in columns.iter().zip(chain) {
        for (got, wanted) in column.to_array().into_iter().zip(wanted[joint].to_array()) {
            assert!((got - wanted).abs() < DERIVED, "joint {joint}: {got} for {wanted}");
        }
    }
}

#[test]
fn the_end_is_never_farther_than_the_bound() {
    let mut random = Random(4);
    let mut nearest = f64::INFINITY;
    for plan in [ur5(), puma()] {
        let (centre, length) = plan.arm::<f64>().reach_bound();
        for _ in 0..2000 {
            let end = plan.isometry(&plan.draw(&mut random)).translation.vector;
            let far = (end - nalgebra::Vector3::from(centre)).norm();
            assert!(far <= length, "{far} of {length}");
            nearest = nearest.min(length - far);
        }
    }
    assert!(nearest < 0.25, "the bound is of use: {nearest}");
    let plan = gantry();
    let (centre, length) = plan.arm::<f64>().reach_bound();
    for _ in 0..2000 {
        let end = plan.isometry(&plan.draw(&mut random)).translation.vector;
        assert!((end - nalgebra::Vector3::from(centre)).norm() <= length);
    }
}

/// Where all of the way is the pitch of one screw, the bound is that way.
#[test]
fn a_screw_reaches_as_far_as_its_pitch_takes_it() {
    let screw = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0, 0.0, 0.5] };
    let joint = Joint { screw, limits: [0.0, 8.0] };
    let arm = Arm::new([joint], DualQuat::IDENTITY).unwrap();
    assert_eq!(arm.reach_bound(), ([0.0; 3], 4.0));
    assert_eq!(arm.forward(&[8.0]).translation(), [0.0, 0.0, 4.0]);
    let left_handed = Joint { screw: Twist { linear: [0.0, 0.0, -0.5], ..screw }, ..joint };
    let arm = Arm::new([left_handed], DualQuat::IDENTITY).unwrap();
    assert_eq!(arm.reach_bound(), ([0.0; 3], 4.0));
    assert_eq!(arm.forward(&[8.0]).translation(), [0.0, 0.0, -4.0]);
    for limits in [[-8.0, 1.0], [-1.0, 8.0]] {
        let arm = Arm::new([Joint { limits, ..joint }], DualQuat::IDENTITY).unwrap();
        assert_eq!(arm.reach_bound(), ([0.0; 3], 4.0));
    }
    let endless = Joint { limits: [0.0, f64::INFINITY], ..joint };
    let error = Arm::new([endless], DualQuat::IDENTITY).unwrap_err();
    assert_eq!(error, ArmError::Limits { joint: 0, low: 0.0, high: f64::INFINITY });
}

#[test]
fn a_thread_is_searched_as_the_thread_that_it_is_whatever_its_pitch() {
    for pitch in [1.0, -1.0, 0.5] {
        let screw = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0, 0.0, pitch] };
        let arm = Arm::new([Joint { screw, limits: [-2.0, 2.0] }], DualQuat::IDENTITY).unwrap();
        let mut values = [0.1_f64];
        let report = arm.reach(arm.forward(&[1.25]), &mut values, &Options::default());
        assert_eq!(report.outcome, Outcome::Converged, "{pitch}");
        assert!((values[0] - 1.25).abs() < REACHED, "{pitch}: {values:?}");
    }
}

#[test]
fn joints_that_make_no_arm_are_named() {
    let good = Joint::revolute([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let home = DualQuat::<f64>::IDENTITY;
    let with = |joint| Arm::new([good, joint], home).map(|_| ());
    let (inf, nan) = (f64::INFINITY, f64::NAN);

    let short = Joint::revolute([0.0, 0.0, 0.5], [0.0; 3]);
    assert_eq!(with(short), Err(ArmError::Screw { joint: 1, angular: 0.5, linear: 0.0 }));
    let nothing = Joint::prismatic([0.0; 3], [0.0, 1.0]);
    assert_eq!(with(nothing), Err(ArmError::Screw { joint: 1, angular: 0.0, linear: 0.0 }));
    for bad in [nan, inf] {
        assert!(matches!(
            with(Joint::revolute([0.0, bad, 1.0], [0.0; 3])),
            Err(ArmError::Screw { joint: 1, .. })
        ));
        assert!(matches!(
            with(Joint::revolute([0.0, 0.0, 1.0], [bad, 0.0, 0.0])),
            Err(ArmError::Screw { joint: 1, .. })
        ));
    }
    for limits in [[1.0, 0.0], [nan, 0.0], [0.0, nan], [inf, inf], [-inf, -inf]] {
        assert!(matches!(with(good.with_limits(limits)), Err(ArmError::Limits { joint: 1, .. })));
    }
    let endless = Joint::prismatic([0.0, 1.0, 0.0], [0.0, inf]);
    assert_eq!(with(endless), Err(ArmError::Limits { joint: 1, low: 0.0, high: inf }));
    assert_eq!(with(good.with_limits([-inf, inf])), Ok(()));
    assert_eq!(with(good.with_limits([0.5, 0.5])), Ok(()));

    // Axes so far apart that a float has no number for the way between them.
    let [left, right] = [-3e38, 3e38].map(|x| Joint::revolute([0.0_f32, 0.0, 1.0], [x, 0.0, 0.0]));
    let apart = Arm::new([left, right], DualQuat::IDENTITY).map(|_| ());
    assert!(matches!(apart, Err(ArmError::Screw { joint: 1, .. })), "{apart:?}");

    // Angles that a float does not tell, unless the hinge is endless.
    let far = Joint::revolute([0.0_f32, 0.0, 1.0], [0.0; 3]).with_limits([1e7, 1e7 + 20.0]);
    let refused = Arm::new([far], DualQuat::IDENTITY).map(|_| ());
    assert_eq!(refused, Err(ArmError::Limits { joint: 0, low: 1e7, high: 1e7 + 20.0 }));
    assert!(Arm::new([far.with_limits([-1e7, 1e7])], DualQuat::IDENTITY).is_ok());
    assert_eq!(with(good.with_limits([1e7, 1e7 + 20.0])), Ok(()));

    for home in [
        DualQuat::ZERO,
        home.scale(2.0),
        home.scale(nan),
        DualQuat::from_translation([inf, 0.0, 0.0]),
    ] {
        assert!(matches!(Arm::new([good], home), Err(ArmError::Home { .. })));
    }
    let error = ArmError::Limits { joint: 1, low: 0.0, high: inf };
    assert_eq!(
        error.to_string(),
        "joint 1 cannot move between 0 and inf: limits must be in order, finite for what slides, and \
         angles that a float tells apart"
    );
}

/// With four decimals the pose at zero is unit to 10⁻⁴; the arm's poses are to rounding.
#[test]
fn a_home_typed_with_four_decimals_is_made_unit() {
    let turn = Quat::from_array([0.1826, 0.3651, 0.5477, 0.7303]);
    let home = DualQuat::from_rotation_translation(turn, [0.3, 0.2, 0.1]);
    let joint = Joint::revolute([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let arm = Arm::new([joint], home).expect("an arm");
    assert!(!home.is_normalized() && arm.forward(&[0.5]).is_normalized());
}
