//! B. Arends, thesis (Dutch), chapter 2: rotation matrices, Euler angles, gimbal lock, reflection.

use crate::{add, assert_close, assert_far, dot};
use core::f64::consts::FRAC_PI_2;
use dq8::{DualQuat, Quat};
use lab::arends::{reflection_in_a_line, turned};

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

type Matrix = [[f64; 3]; 3];

fn rotation_x(angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]]
}

fn rotation_y(angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]]
}

fn rotation_z(angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]
}

fn product(a: Matrix, b: Matrix) -> Matrix {
    let entry = |i: usize, j: usize| (0..3).map(|k| a[i][k] * b[k][j]).sum();
    core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)))
}

fn apply(matrix: Matrix, v: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| dot(row, v))
}

fn about(axis: [f64; 3], angle: f64) -> DualQuat<f64> {
    DualQuat::from_rotation(Quat::from_axis_angle(axis, angle))
}

#[track_caller]
fn assert_same(got: Matrix, wanted: Matrix) {
    (0..3).for_each(|row| assert_close(got[row], wanted[row], 1e-15));
}

/// x′ = x cos θ − y sin θ, y′ = x sin θ + y cos θ; θ > 0 is against the clock.
#[test]
fn chapter_2_section_1_turns_in_the_plane_go_against_the_clock() {
    let (theta, [x, y]) = (0.7_f64, [3.0, -2.0]);
    let (sin, cos) = theta.sin_cos();
    let in_the_plane = about(Z, theta).transform_vector([x, y, 0.0]);
    assert_close(in_the_plane, [x * cos - y * sin, x * sin + y * cos, 0.0], 1e-15);
    // (1,0) goes to (cos, sin) and (0,1) to (−sin, cos); a quarter turn takes x to y.
    assert_close(about(Z, theta).transform_vector(X), [cos, sin, 0.0], 1e-15);
    assert_close(about(Z, theta).transform_vector(Y), [-sin, cos, 0.0], 1e-15);
    assert_close(about(Z, FRAC_PI_2).transform_vector(X), Y, 1e-15);
    assert_close(about(Z, -FRAC_PI_2).transform_vector(X), [0.0, -1.0, 0.0], 1e-15);
}

#[test]
fn chapter_2_section_2_the_three_matrices_turn_about_their_axes_and_do_not_commute() {
    for angle in [0.7, -1.9, 3.0] {
        let printed = [(X, rotation_x(angle)), (Y, rotation_y(angle)), (Z, rotation_z(angle))];
        for (axis, matrix) in printed {
            assert_same(about(axis, angle).to_matrix3x4().map(|[a, b, c, _]| [a, b, c]), matrix);
        }
    }
    let (turn_x, turn_y) = (rotation_x(0.7), rotation_y(-1.9));
    assert_far(product(turn_x, turn_y)[0], product(turn_y, turn_x)[0]);
}

/// "First about x, then y, then z: Rx(φ) Ry(θ) Rz(ψ) (x, y, z)". On a column the right factor
/// acts first: about z, then y, then x. About axes that turn along it is x, y, z, as he says.
#[test]
fn chapter_2_section_2_erratum_his_product_turns_about_the_fixed_z_first() {
    let (phi, theta, psi, v) = (0.7, -1.1, 0.4, [3.0, 1.0, -2.0]);
    let printed = turned([phi, theta, psi], v);
    let one_by_one = about(X, phi)
        .transform_vector(about(Y, theta).transform_vector(about(Z, psi).transform_vector(v)));
    assert_close(printed, one_by_one, 1e-15);
    let as_said = about(Z, psi)
        .transform_vector(about(Y, theta).transform_vector(about(X, phi).transform_vector(v)));
    assert_far(printed, as_said);
    // Axes that turn along: y as the first turn leaves it, z as the first two leave it.
    let first = about(X, phi);
    let second = about(first.transform_vector(Y), theta) * first;
    let third = about(second.transform_vector(Z), psi) * second;
    assert_close(third.transform_vector(v), printed, 1e-15);
}

/// Rx(θ, Tx, Ty, Tz): the turn, then the shift.
#[test]
fn chapter_2_section_3_one_matrix_turns_and_then_shifts() {
    let (angle, t, v) = (0.7, [4.0, -1.0, 2.0], [3.0, 1.0, -2.0]);
    let both = DualQuat::from_rotation_translation(Quat::from_axis_angle(X, angle), t);
    let rows = both.to_matrix4();
    for (row, turn) in rotation_x(angle).into_iter().enumerate() {
        let [a, b, c] = turn;
        assert_close(rows[row], [a, b, c, t[row]], 1e-15);
    }
    assert_eq!(rows[3], [0.0, 0.0, 0.0, 1.0]);
    assert_close(both.transform_point(v), add(apply(rotation_x(angle), v), t), 1e-14);
    assert_eq!(DualQuat::from_translation(t).transform_point(v), add(v, t));
}

/// "With 90 or −90 degrees he adds ψ and φ": at −90 it is the difference that is left.
#[test]
fn chapter_2_section_5_erratum_at_minus_90_degrees_the_difference_is_left() {
    let locked = |phi, psi| about(X, phi) * about(Y, -FRAC_PI_2) * about(Z, psi);
    let motion = locked(0.7, 0.4);
    assert_close(motion.to_array(), locked(0.95, 0.65).to_array(), 1e-15);
    assert_far(motion.to_matrix3x4()[1], locked(0.95, 0.15).to_matrix3x4()[1]);
}

/// Printed: Refl(v) = 2 (v·l)/(l·l) l. That is twice the part along l; the mirror image in the
/// line l is v less, and keeps lengths.
#[test]
fn chapter_2_section_7_2_erratum_the_reflection_in_a_line_needs_minus_v() {
    let (l, v) = ([2.0, 6.0, -3.0], [1.0, -2.0, 0.5]);
    let printed = reflection_in_a_line(v, l);
    let mirrored = add(printed, v.map(|c| -c));
    // In space it is half a turn about the line.
    let half_turn = DualQuat::from_rotation(Quat::from_parts(l.map(|c| c / 7.0), 0.0));
    assert_close(half_turn.transform_vector(v), mirrored, 1e-15);
    assert_close([dot(mirrored, mirrored)], [dot(v, v)], 1e-14);
    assert_far([dot(printed, printed)], [dot(v, v)]);
}
