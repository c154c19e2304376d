//! One configuration.

use crate::tree::{mechanism, tree, values};
use dq8::{Dual, DualQuat, Quat, Twist};
use dq8_fixtures::random::Random;
use dq8_robot::{Body, Joint, JointKind, Mechanism, OwnedMechanism, World, WorldAligned};
use nalgebra::{Matrix4, Rotation3, Translation3, Unit, UnitQuaternion, Vector3};

/// Forty joints one on the other, some tens of lengths away: a few roundings each.
const ROUNDING: f64 = 2e-13;
/// The same, times lever arms as long, for what a rate does far away.
const OF_RATES: f64 = 2e-13;
/// A unit vector that is turned once.
const LAST_BITS: f64 = 1e-15;

fn matrix(motion: DualQuat<f64>) -> Matrix4<f64> {
    let [a, b, c] = motion.to_matrix3x4();
    Matrix4::from_row_slice(&[a, b, c, [0.0, 0.0, 0.0, 1.0]].concat())
}

/// Link poses as products of 4×4 matrices, from the definition of each joint.
fn by_matrices(joints: &[Joint<f64>], values: &[f64]) -> Vec<Matrix4<f64>> {
    let mut first = Vec::new();
    let mut next = 0;
    for joint in joints {
        first.push(next);
        next += if joint.mimic.is_some() { 0 } else { joint.kind.values() };
    }
    let mut poses: Vec<Matrix4<f64>> = Vec::new();
    for (index, joint) in joints.iter().enumerate() {
        let number = |offset: usize| values[first[index] + offset];
        let single = || match joint.mimic {
            Some(mimic) => values[first[mimic.joint]] * mimic.multiplier + mimic.offset,
            None => number(0),
        };
        let turn = |axis: [f64; 3], angle: f64| {
            Rotation3::from_axis_angle(&Unit::new_normalize(Vector3::from(axis)), angle)
                .to_homogeneous()
        };
        let shift = |vector: Vector3<f64>| Translation3::from(vector).to_homogeneous();
        let motion = match joint.kind {
            JointKind::Revolute { axis } => turn(axis, single()),
            JointKind::Prismatic { axis } => shift(Vector3::from(axis) * single()),
            JointKind::Screw { axis, pitch } => {
                shift(Vector3::from(axis) * (pitch * single())) * turn(axis, single())
            }
            JointKind::Planar { normal } => {
                let up = Vector3::from(normal);
                let to =
                    UnitQuaternion::rotation_between(&Vector3::z(), &up).unwrap_or_else(|| {
                        UnitQuaternion::from_axis_angle(&Vector3::x_axis(), core::f64::consts::PI)
                    });
                shift(to * Vector3::new(number(0), number(1), 0.0)) * turn(normal, number(2))
            }
            JointKind::Floating => {
                let [x, y, z, w] = core::array::from_fn(number);
                let turn = UnitQuaternion::new_normalize(nalgebra::Quaternion::new(w, x, y, z));
                shift(Vector3::new(number(4), number(5), number(6))) * turn.to_homogeneous()
            }
            _ => Matrix4::identity(),
        };
        let base = joint.parent.map_or(Matrix4::identity(), |parent| poses[parent]);
        poses.push(base * matrix(joint.placement) * motion);
    }
    poses
}

#[test]
fn poses_of_links_are_products_of_matrices() {
    let mut random = Random(1);
    for count in 0..40 {
        let joints = tree(&mut random, count);
        let values = values(&mut random, &joints);
        let owned = mechanism::<f64>(&joints);
        let mut poses = vec![DualQuat::IDENTITY; count];
        owned.view().link_poses(&values, &mut poses).unwrap();
        for (link, wanted) in by_matrices(&joints, &values).into_iter().enumerate() {
            let error = (matrix(poses[link]) - wanted).amax();
            assert!(error < ROUNDING, "link {link} of {count}: {error}");
            let alone = owned.view().link_pose(&values, link).unwrap();
            assert!(alone.distance_to(poses[link]) < ROUNDING, "link {link} of {count} alone");
        }
    }
}

/// A random tree, values, rates and second rates of it, in order; dual numbers move at these.
struct Moving {
    joints: Vec<Joint<f64>>,
    values: Vec<f64>,
    rates: Vec<f64>,
    second: Vec<f64>,
    owned: OwnedMechanism<f64>,
    dual: OwnedMechanism<Dual<f64>>,
}

fn trees(seed: u64) -> impl Iterator<Item = Moving> {
    let mut random = Random(seed);
    (1..25).map(move |count| {
        let joints = tree(&mut random, count);
        let values = values(&mut random, &joints);
        let (owned, dual) = (mechanism::<f64>(&joints), mechanism(&joints));
        let mut drawn = || (0..owned.view().rates()).map(|_| random.signed()).collect();
        let (rates, second) = (drawn(), drawn());
        Moving { joints, values, rates, second, owned, dual }
    })
}

#[track_caller]
fn close(found: Twist<f64>, wanted: Twist<f64>, what: &str) {
    let error = (found - wanted).to_array().map(f64::abs).into_iter().fold(0.0, f64::max);
    assert!(error < OF_RATES, "{what}: {error}");
}

/// Dual numbers in place of values differentiate the poses; σ̇ σ* is half the spatial twist.
#[test]
fn jacobians_are_derivatives_of_poses_and_velocities_are_jacobians_times_rates() {
    for Moving { joints, values, rates, owned, dual, .. } in trees(2) {
        let (robot, count, zero) = (owned.view(), joints.len(), Twist::<f64>::ZERO);
        let (mut poses, mut twists) = (vec![DualQuat::IDENTITY; count], vec![zero; count]);
        robot.link_velocities(&values, &rates, &mut poses, &mut twists).unwrap();
        let (mut columns, mut others) = (vec![zero; rates.len()], vec![zero; rates.len()]);
        for (link, twist) in twists.into_iter().enumerate() {
            let pose = robot.link_jacobian(World, &values, link, &mut columns).unwrap();
            let sum = columns.iter().zip(&rates).fold(zero, |sum, (c, &rate)| sum + c.scale(rate));
            close(sum, twist, "velocity");
            robot.link_jacobian(Body, &values, link, &mut others).unwrap();
            for (column, body) in columns.iter().zip(&others) {
                close(*column, pose.adjoint(*body), "body");
            }
            robot.link_jacobian(WorldAligned, &values, link, &mut others).unwrap();
            for (column, aligned) in columns.iter().zip(&others) {
                let linear = column.velocity_at(pose.translation());
                close(*aligned, Twist { linear, ..*column }, "aligned");
            }
        }
        // Of one link: its velocity is that of its columns.
        let link = count / 2;
        robot.link_jacobian(World, &values, link, &mut columns).unwrap();
        for (rate, column) in columns.iter().enumerate() {
            let mut alone = vec![0.0; rates.len()];
            alone[rate] = 1.0;
            let moved = moving(&joints, &values, &alone, robot);
            let pose = dual.view().link_pose(&moved, link).unwrap().to_array();
            let at = DualQuat::from_array(pose.map(|number| number.real));
            let speed = DualQuat::from_array(pose.map(|number| number.dual));
            let [wx, wy, wz, _, vx, vy, vz, _] = (speed * at.conjugate()).scale(2.0).to_array();
            let wanted = Twist::from_array([wx, wy, wz, vx, vy, vz]);
            close(*column, wanted, &format!("rate {rate}, link {link} of {count}"));
        }
    }
}

/// Twists of dual numbers: values and rates that move differentiate them.
#[test]
fn accelerations_are_derivatives_of_twists() {
    for Moving { joints, values, rates, second, owned, dual } in trees(7) {
        let (robot, count, zero) = (owned.view(), joints.len(), Twist::ZERO);
        let (mut poses, mut twists) = (vec![DualQuat::IDENTITY; count], vec![zero; count]);
        let mut found = twists.clone();
        robot
            .link_accelerations(&values, &rates, &second, &mut poses, &mut twists, &mut found)
            .unwrap();
        let moved = moving(&joints, &values, &rates, robot);
        let changing: Vec<_> =
            rates.iter().zip(&second).map(|(&rate, &second)| Dual::new(rate, second)).collect();
        let mut dual_poses = vec![DualQuat::IDENTITY; count];
        let mut dual_twists = vec![Twist::from_array([Dual::new(0.0, 0.0); 6]); count];
        let view = dual.view();
        view.link_velocities(&moved, &changing, &mut dual_poses, &mut dual_twists).unwrap();
        for (link, (wanted, found)) in dual_twists.iter().zip(&found).enumerate() {
            for (wanted, found) in wanted.to_array().into_iter().zip(found.to_array()) {
                let error = (wanted.dual - found).abs() / (1.0 + found.abs());
                assert!(error < OF_RATES, "link {link} of {count}: {error}");
            }
        }
    }
}

/// Values that move at these rates.
fn moving(
    joints: &[Joint<f64>],
    values: &[f64],
    rates: &[f64],
    robot: Mechanism<'_, f64>,
) -> Vec<Dual<f64>> {
    let mut moved: Vec<_> = values.iter().map(|&value| Dual::new(value, 0.0)).collect();
    let mut rates = rates.iter().copied();
    for (index, joint) in joints.iter().enumerate() {
        if joint.mimic.is_some() {
            continue;
        }
        let first = robot.values_of(index).unwrap().start;
        if joint.kind == JointKind::Floating {
            // ṗ = ½ p ω, ṫ = R v.
            let twist: [f64; 6] = core::array::from_fn(|_| rates.next().unwrap());
            let [wx, wy, wz, vx, vy, vz] = twist;
            let turn = Quat::from_array(core::array::from_fn(|i| values[first + i]));
            let spin = (turn * Quat::from_xyzw(wx, wy, wz, 0.0)).scale(0.5).to_array();
            let slide = turn.normalize().rotate([vx, vy, vz]);
            for (offset, speed) in spin.into_iter().chain(slide).enumerate() {
                moved[first + offset].dual = speed;
            }
        } else {
            for offset in 0..joint.kind.rates() {
                moved[first + offset].dual = rates.next().unwrap();
            }
        }
    }
    moved
}

#[test]
fn the_axes_of_a_plane_are_those_of_the_frame_turned_the_shortest_way() {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0_f64]];
    let minus = |axis: [f64; 3]| axis.map(|c| 0.0 - c);
    // The normal, and where x and y go: half a turn about x for −z.
    for (normal, to_x, to_y) in
        [(z, x, y), (minus(z), x, minus(y)), (x, minus(z), y), (y, x, minus(z))]
    {
        let kind = JointKind::Planar { normal };
        let owned = mechanism::<f64>(&[Joint::new(None, DualQuat::IDENTITY, kind)]);
        for (values, wanted) in [([1.0, 0.0, 0.0], to_x), ([0.0, 1.0, 0.0], to_y)] {
            let found = owned.view().link_pose(&values, 0).unwrap().translation();
            let off = (0..3).map(|i| (found[i] - wanted[i]).abs()).fold(0.0, f64::max);
            assert!(off < LAST_BITS, "{normal:?}: {found:?} for {wanted:?}");
        }
    }
}
