//! Inverse kinematics on the biped: where the walk had hands and feet, joints are found that put them
//! there again.

use super::tests::joint;
use super::{ELBOW, RIBS, SHIN, SHOULDER, THIGH, WAIST, WRIST, clip};
use dq8::geometry::Screw;
use dq8::ik::{Span, TwoBone};
use dq8::{DualQuat, Line};
use dq8_robot::OwnedMechanism;
use dq8_robot::ik::{Goal, Options, Outcome, OwnedReach};
use std::f64::consts::PI;

fn sum(points: &[[f64; 3]]) -> [f64; 3] {
    core::array::from_fn(|axis| points.iter().map(|point| point[axis]).sum())
}

/// Hip, knee and ankle are a limb of two bones, and the knee tells its plane.
#[test]
fn two_bones_put_every_foot_of_the_walk_where_it_was() {
    let clip = clip();
    for frame in clip.models().unwrap().chunks_exact(clip.joints.len()) {
        for side in ["Left", "Right"] {
            let place = |name: &str| frame[joint(&clip, &format!("{side}{name}"))].translation();
            let [hip, knee, ankle] = ["Thigh", "Shin", "Foot"].map(place);
            let pole = core::array::from_fn(|axis| knee[axis] - hip[axis]);
            let limb = TwoBone::reach(hip, [THIGH, SHIN], ankle, pole).unwrap();
            assert_eq!(limb.span, Span::Within);
            let bones = [limb.upper.rotate([THIGH, 0.0, 0.0]), limb.lower.rotate([SHIN, 0.0, 0.0])];
            for (wanted, found) in
                [(knee, sum(&[hip, bones[0]])), (ankle, sum(&[hip, bones[0], bones[1]]))]
            {
                let [wanted, found] = [wanted, found].map(DualQuat::from_translation);
                let error = wanted.distance_to(found);
                assert!(error < 1e-14, "{side}: {error:e} m");
            }
        }
    }
}

/// Eleven of the 36 degrees of freedom lie between the pelvis and a hand: five more than a pose has.
#[test]
fn eleven_joints_put_the_hand_where_the_walk_had_it() {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let places = [WAIST, RIBS, SHOULDER, ELBOW, WRIST];
    let [waist, ribs, shoulder, elbow, wrist] = core::array::from_fn(|i| sum(&places[..=i]));
    // In the order of `BALL` and `HINGE`.
    let joints = [
        (y, waist),
        (z, waist),
        (x, waist),
        (y, ribs),
        (z, ribs),
        (x, ribs),
        (y, shoulder),
        (z, shoulder),
        (x, shoulder),
        (x, elbow),
        (x, wrist),
    ];
    let joints = joints.map(|(axis, through)| {
        let axis = Line::from_point_direction(through, axis);
        (Screw { axis, angle: 1.0, slide: 0.0 }, [-PI, PI])
    });
    let arm = OwnedMechanism::from_screws(&joints, DualQuat::from_translation(wrist)).unwrap();
    let reach = OwnedReach::new(arm.clone(), [Goal::pose(11)]).unwrap();
    let mut scratch = vec![0.0; reach.view().scratch_len()];

    let clip = clip();
    let [pelvis, hand] = ["Pelvis", "LeftHand"].map(|name| joint(&clip, name));
    let mut values = [0.1; 11];
    for frame in clip.models().unwrap().chunks_exact(clip.joints.len()) {
        let target = frame[pelvis].conjugate() * frame[hand];
        let report =
            reach.view().solve(&[target], &mut values, &mut scratch, &Options::default()).unwrap();
        assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
        let pose = arm.view().link_pose(&values, 11).unwrap();
        assert!(pose.distance_to(target) < 1e-5 && pose.angle_to(target) < 1e-5, "{report:?}");
    }
}
