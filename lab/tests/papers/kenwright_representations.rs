//! B. Kenwright, *A Beginners Guide to Dual-Quaternions*, §§3–6: what he compares dual
//! quaternions with.

use crate::{assert_close, assert_far, motions};
use core::f64::consts::{PI, TAU};
use dq8::representation::{EulerAxes, EulerFrame, EulerOrder};
use dq8::{Dual, DualQuat, Quat, Twist};
use lab::kenwright::{euler, straight, within_a_turn};
use nalgebra::SMatrix;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

fn axis_angle([x, y, z, angle]: [f64; 4]) -> Quat<f64> {
    let norm = x.hypot(y).hypot(z);
    Quat::from_axis_angle([x, y, z].map(|c| c / norm), angle)
}

fn angle(a: Quat<f64>, b: Quat<f64>) -> f64 {
    DualQuat::from_rotation(a).angle_to(DualQuat::from_rotation(b))
}

/// How far the straight line between two lists of parameters turns, against the angle of its ends.
fn detour<const N: usize>(rotation: fn([f64; N]) -> Quat<f64>, ends: [[f64; N]; 2]) -> f64 {
    let [from, to] = ends;
    let at = |t: f64| rotation(straight(from, to, t));
    let steps = (0..1000).map(|i| angle(at(f64::from(i) / 1e3), at(f64::from(i + 1) / 1e3)));
    steps.sum::<f64>() / angle(at(0.0), at(1.0))
}

#[test]
fn section_3_3_turns_about_axes_do_not_commute() {
    let (x, y) = (Quat::from_axis_angle(X, 0.7), Quat::from_axis_angle(Y, 0.4));
    assert_far((x * y).rotate([1.0, 2.0, 3.0]), (y * x).rotate([1.0, 2.0, 3.0]));
}

/// Twelve it is, but he lists eleven names, of which XZY, YZX and ZYX stand twice.
#[test]
fn section_3_3_erratum_the_list_of_twelve_orders_names_eight() {
    let printed = ["XYZ", "YXZ", "ZXY", "XZY", "YZX", "XZX", "ZYX", "XZY", "YZX", "ZYX", "ZYZ"];
    let mut all = Vec::new();
    for a in "XYZ".chars() {
        for b in "XYZ".chars().filter(|&b| b != a) {
            all.extend("XYZ".chars().filter(|&c| c != b).map(|c| String::from_iter([a, b, c])));
        }
    }
    assert_eq!(all.len(), 12);
    assert_eq!(all.iter().filter(|order| printed.contains(&order.as_str())).count(), 8);
}

/// Angles beside a whole turn and none are neighbours whose numbers are 2π apart.
#[test]
fn section_3_3_neighbours_can_have_angles_a_whole_turn_apart() {
    let [before, after] = [-0.01, 0.01].map(|off| [0.3, 0.4, off]);
    let around = before.map(within_a_turn);
    assert_close([angle(euler(before), euler(around))], [0.0], 1e-15);
    assert_close([angle(euler(around), euler(after))], [0.02], 1e-15);
    // Numbers mixed half and half go to the other side of the turn.
    let middle = core::array::from_fn(|i| 0.5 * (around[i] + after[i]));
    assert_close([angle(euler(middle), euler([0.3, 0.4, 0.0]))], [PI], 1e-14);
}

#[test]
fn section_3_3_4_a_straight_line_in_euler_angles_is_no_shortest_way() {
    let ends = [[0.1, 0.2, -0.3], [1.8, -1.2, 2.0]];
    assert!(detour(euler, ends) > 1.1, "{}", detour(euler, ends));
    // Across gimbal lock, 0.04 radians to the other side, two angles jump by half a turn: to π or
    // −π.
    let near = PI / 2.0 - 0.02;
    let across = |last| detour(euler, [[0.0, near, 0.0], [PI, near, last]]);
    assert_close([across(PI)], [PI / 2.0], 1e-3);
    assert!(across(-PI) > 150.0, "{}", across(-PI));
    // About one axis it is.
    assert_close([detour(euler, [[0.1, 0.0, 0.0], [1.8, 0.0, 0.0]])], [1.0], 1e-12);
}

/// At 90° about y the three Euler angles turn about two axes only; the dual quaternion there has
/// all six ways to go, as everywhere.
#[test]
fn sections_3_3_3_and_8_dual_quaternions_have_no_gimbal_lock() {
    let slopes = |[x, y, z]: [f64; 3]| {
        SMatrix::<f64, 4, 3>::from_fn(|component, changed| {
            let angle = |i: usize, at: f64| Dual::new(at, f64::from(u8::from(i == changed)));
            let turn = |axis: [f64; 3], angle| {
                Quat::from_axis_angle(axis.map(|c| Dual::new(c, 0.0)), angle)
            };
            let rotation = turn(Z, angle(2, z)) * turn(Y, angle(1, y)) * turn(X, angle(0, x));
            rotation.to_array()[component].dual
        })
    };
    assert_eq!(slopes([0.3, 0.7, -0.4]).rank(1e-9), 3);
    for lock in [PI / 2.0, -PI / 2.0] {
        assert_eq!(slopes([0.3, lock, -0.4]).rank(1e-9), 2);
        let locked = DualQuat::from_rotation_translation(euler([0.3, lock, -0.4]), [1.0, 2.0, 3.0]);
        let tangents = SMatrix::<f64, 8, 6>::from_fn(|component, i| {
            let twist = Twist::from_array(core::array::from_fn(|j| f64::from(u8::from(i == j))));
            locked.derivative_spatial(twist).to_array()[component]
        });
        assert_eq!(tangents.rank(0.1), 6);
    }
}

/// "Ill-conditioned": near gimbal lock a turn by 10⁻⁹ changes the outer angles by as much over
/// the distance from it, and the middle one by no more than itself.
#[test]
fn section_3_3_3_near_gimbal_lock_the_outer_angles_lose_digits() {
    let order = EulerOrder { axes: EulerAxes::XYZ, frame: EulerFrame::Extrinsic };
    let nudge = Quat::from_axis_angle(X, 1e-9);
    for off in [1.0, 1e-2, 1e-4, 1e-6] {
        let rotation = euler([0.3, PI / 2.0 - off, -0.4]);
        let [before, after] =
            [rotation, nudge * rotation].map(|rotation| rotation.to_euler(order).angles.angles);
        let moved = |i: usize| (after[i] - before[i]).abs() * 1e9;
        let outer = moved(0).max(moved(2));
        assert!((0.1 / off..2.0 / off).contains(&outer), "{off}: {outer}");
        assert!(moved(1) < 1.1, "{off}: {}", moved(1));
    }
}

/// "Small errors creep in": combined through quaternions a thousand times in single precision, the
/// angle is off by many times what one conversion loses.
#[test]
fn section_3_4_2_errors_of_the_angle_accumulate() {
    let (axis, step) = ([0.48_f32, 0.6, 0.64], 1e-3_f32);
    let turn = Quat::from_axis_angle(axis, step);
    let (mut axis, mut angle) = (axis, step);
    let mut errors = Vec::new();
    for n in 2..=1000 {
        (axis, angle) = (Quat::from_axis_angle(axis, angle) * turn).to_axis_angle();
        let exact = f64::from(n) * f64::from(step);
        errors.push((f64::from(angle) - exact).abs() / exact);
    }
    let epsilon = f64::from(f32::EPSILON);
    assert!(errors[0] < 2.0 * epsilon, "once: {:e}", errors[0]);
    let worst = errors.iter().fold(0.0, |worst: f64, error| worst.max(*error));
    assert!(worst > 5.0 * epsilon, "{:e} at worst", worst);
}

#[test]
fn section_3_4_2_axis_and_angle_are_many_for_one_rotation() {
    let axis = [0.6, 0.0, 0.8];
    let once = Quat::from_axis_angle(axis, 1.1);
    for turns in [-3.0, -1.0, 1.0, 2.0, 7.0] {
        let again = Quat::from_axis_angle(axis, 1.1 + turns * TAU);
        assert_close(again.rotate(X), once.rotate(X), 1e-14);
    }
    let opposite = Quat::from_axis_angle(axis.map(|c| -c), -1.1);
    assert_eq!(opposite, once);
}

#[test]
fn section_3_4_2_a_straight_line_in_axis_and_angle_is_no_shortest_way() {
    let ends = [[1.0, 0.0, 0.0, 1.5], [0.0, 1.0, 0.0, 2.5]];
    assert!(detour(axis_angle, ends) > 1.01, "{}", detour(axis_angle, ends));
    // An angle that crossed from 2π to 0 takes the whole turn back.
    let crossed = [[0.0, 0.0, 1.0, TAU - 0.01], [0.0, 0.0, 1.0, 0.01]];
    assert_close([detour(axis_angle, crossed)], [(TAU - 0.02) / 0.02], 1e-9);
}

/// "Each of the columns … the base vectors and the bottom row the translation": with columns, the
/// translation is the last column. His appendix has both in rows.
#[test]
fn section_3_5_the_columns_are_the_turned_axes_and_the_moved_origin() {
    for s in motions() {
        let rows = s.to_matrix4();
        let column = |j: usize| [rows[0][j], rows[1][j], rows[2][j]];
        for (j, axis) in [X, Y, Z].into_iter().enumerate() {
            assert_close(column(j), s.transform_vector(axis), 1e-15);
        }
        assert_close(column(3), s.transform_point([0.0; 3]), 1e-15);
        assert_eq!(rows[3], [0.0, 0.0, 0.0, 1.0]);
    }
}

/// "The most compact form": eight numbers are fewer than twelve, and one more than quaternion and
/// vector.
#[test]
fn section_4_erratum_eight_numbers_are_not_the_fewest() {
    let float = size_of::<f32>();
    assert_eq!(size_of::<DualQuat<f32>>() / float, 8);
    assert_eq!(size_of::<[[f32; 4]; 3]>() / float, 12);
    assert_eq!(size_of::<(Quat<f32>, [f32; 3])>() / float, 7);
    // Arends' conclusion, for rotations alone: 4 floats against 16.
    assert_eq!(size_of::<Quat<f32>>() / float, 4);
    assert_eq!(size_of::<[[f32; 4]; 4]>() / float, 16);
}

#[test]
fn section_5_2_the_normalized_dual_part_of_a_point_on_a_curve_is_its_tangent() {
    let time = Dual::new(0.7_f64, 2.0);
    let curve = [time.cos(), time.sin(), time * time];
    let dual = curve.map(|c| c.dual);
    let norm = dual[0].hypot(dual[1]).hypot(dual[2]);
    let (sin, cos) = 0.7_f64.sin_cos();
    let tangent = [-sin, cos, 1.4].map(|c| c / 1.0_f64.hypot(1.4));
    assert_close(dual.map(|c| c / norm), tangent, 1e-15);
}

/// "The SLERP properties of quaternions are inherited": with the angle for a dual number, as in
/// slerp written over dual numbers. With the angle of the rotation alone it is no motion between
/// the ends.
#[test]
fn section_6_2_slerp_is_inherited_with_the_dual_angle_only() {
    let [a, b] = motions();
    let b = if a.dot(b).real < 0.0 { -b } else { b };
    let omega = a.dot(b).acos();
    for t in [0.25, 0.5, 0.75] {
        let [first, second] = [1.0 - t, t].map(|t| (Dual::new(t, 0.0) * omega).sin() / omega.sin());
        let slerp = a.scale_dual(first) + b.scale_dual(second);
        assert_close(slerp.to_array(), a.sclerp(b, t).to_array(), 1e-14);
        let by_the_angle_alone = a.scale(first.real) + b.scale(second.real);
        assert!(!by_the_angle_alone.is_unit(0.01));
        assert_close(by_the_angle_alone.real().to_array(), slerp.real().to_array(), 1e-15);
        assert_far(by_the_angle_alone.dual().to_array(), slerp.dual().to_array());
    }
}
