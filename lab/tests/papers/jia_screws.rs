//! Y.-B. Jia, *Dual Quaternions*, §§8–10: lines, screws, differentiation, interpolation.

use crate::{add, assert_close, assert_far, cross, dot, length, motions, pure, third_turn};
use core::f64::consts::PI;
use dq8::{Dual, DualQuat, Line, Quat, Twist, geometry::Screw};

fn line_through(p: [f64; 3], direction: [f64; 3]) -> Line<f64> {
    Line { direction, moment: cross(p, direction) }
}

fn as_dual_quat(line: Line<f64>) -> DualQuat<f64> {
    DualQuat::new(pure(line.direction), pure(line.moment))
}

#[test]
fn section_8_1_the_moment_is_that_of_any_point_and_l_cross_m_the_closest() {
    let l = [2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0];
    let p = [1.0, 2.0, 3.0];
    let m = line_through(p, l).moment;
    let further = add(p, l.map(|c| 5.0 * c));
    assert_close(line_through(further, l).moment, m, 1e-14);
    let closest = cross(l, m);
    assert_close([dot(closest, l), length(closest)], [0.0, length(m)], 1e-15);
    assert_close(line_through(closest, l).moment, m, 1e-15);
    // The same of the moved line, whose points are the moved points.
    let [s, _] = motions();
    let moved = s.transform_line(line_through(p, l));
    for point in [p, further, closest] {
        let through = line_through(s.transform_point(point), moved.direction);
        assert_close(through.moment, moved.moment, 1e-14);
    }
    let away = cross(moved.direction, moved.moment);
    assert_close([dot(away, moved.direction), length(away)], [0.0, length(moved.moment)], 1e-14);
}

/// (cl, cm) is the same line: the same closest point, moved to the same place; l·m = 0 stays.
#[test]
fn section_8_1_a_multiple_of_the_coordinates_is_the_same_line() {
    let (p, l) = ([1.0, 2.0, 3.0], [2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0]);
    let closest = |line: Line<f64>| {
        let square = dot(line.direction, line.direction);
        cross(line.direction, line.moment).map(|c| c / square)
    };
    let [s, _] = motions();
    let line = line_through(p, l);
    for factor in [2.0, -0.5, 10.0] {
        let multiple = line_through(p, l.map(|c| factor * c));
        assert_close(multiple.moment, line.moment.map(|c| factor * c), 1e-14);
        assert_close(closest(multiple), closest(line), 1e-14);
        let moved = s.transform_line(multiple);
        assert_close(closest(moved), closest(s.transform_line(line)), 1e-14);
        assert_close([dot(moved.direction, moved.moment)], [0.0], 1e-13);
    }
}

#[test]
fn eqs_32_and_33_cross_products_turn_along_and_are_halves_of_products() {
    let (a, b) = ([1.0, -2.0, 0.5], [0.25, 3.0, -1.5]);
    let half = (pure(b) * pure(a).conjugate() + pure(a) * pure(b)).scale(0.5);
    assert_eq!(half, pure(cross(a, b)));
    let r = motions()[0].rotation();
    assert_close(cross(r.rotate(a), r.rotate(b)), r.rotate(cross(a, b)), 1e-15);
}

/// A point of the line at (0,0,3), its direction x; turned to (3,0,0) and y, shifted by (1,2,5).
#[test]
fn theorem_1_holds_for_the_motion_t_r_of_its_proof() {
    let (r, t) = (third_turn(), [1.0, 2.0, 5.0]);
    let line = line_through([0.0, 0.0, 3.0], [1.0, 0.0, 0.0]);
    let moved = line_through([4.0, 2.0, 5.0], [0.0, 1.0, 0.0]);
    assert_eq!(moved.moment, [-5.0, 0.0, 4.0]);
    let sigma = DualQuat::new(r, (pure(t) * r).scale(0.5));
    assert_eq!(sigma * as_dual_quat(line) * sigma.conjugate(), as_dual_quat(moved));
    assert_eq!(sigma.transform_line(line), moved);
}

/// The theorem says σ = r + (ε/2) r t. That one shifts first: (0,0,3) + (1,2,5) turns to (8,1,2).
#[test]
fn theorem_1_erratum_the_motion_r_t_of_its_wording_moves_the_line_elsewhere() {
    let (r, t) = (third_turn(), [1.0, 2.0, 5.0]);
    let line = line_through([0.0, 0.0, 3.0], [1.0, 0.0, 0.0]);
    let elsewhere = line_through([8.0, 1.0, 2.0], [0.0, 1.0, 0.0]);
    let wording = DualQuat::new(r, (r * pure(t)).scale(0.5));
    assert_eq!(wording * as_dual_quat(line) * wording.conjugate(), as_dual_quat(elsewhere));
    assert_eq!(wording, DualQuat::from_translation_rotation(t, r));
    assert_far(
        elsewhere.moment,
        DualQuat::from_rotation_translation(r, t).transform_line(line).moment,
    );
}

/// The last paragraph of §8.1: a point takes σ⋄ and a line σ*; exchanged, both come out wrong.
#[test]
fn section_8_1_points_and_lines_need_different_conjugates() {
    let [s, _] = motions();
    let line = line_through([1.0, 2.0, 3.0], [0.0, 0.6, 0.8]);
    let right = s * as_dual_quat(line) * s.conjugate();
    let wrong = s * as_dual_quat(line) * s.conjugate_both();
    assert_close(right.to_array(), as_dual_quat(s.transform_line(line)).to_array(), 1e-14);
    assert_far(wrong.to_array(), right.to_array());
}

/// Turn by θ about the line through `p`, then slide by d: x ↦ R(x − p) + p + d l.
fn turn_and_slide(p: [f64; 3], l: [f64; 3], angle: f64, slide: f64) -> DualQuat<f64> {
    let r = Quat::from_axis_angle(l, angle);
    let back = r.rotate(p).map(|c| -c);
    DualQuat::from_rotation_translation(r, add(add(p, back), l.map(|c| slide * c)))
}

#[test]
fn eqs_37_to_43_screw_parameters_and_motion_say_the_same() {
    let (p, l) = ([1.0, -2.0, 0.5], [2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0]);
    for (angle, slide) in [(0.3, 2.0), (1.5, -1.0), (3.0, 0.0), (PI - 1e-6, 4.0)] {
        let sigma = turn_and_slide(p, l, angle, slide);
        let axis = line_through(p, l);
        let screw = sigma.to_screw();
        assert_close(screw.axis.direction, l, 1e-14);
        assert_close(screw.axis.moment, axis.moment, 1e-13);
        assert_close([screw.angle, screw.slide], [angle, slide], 1e-14);
        assert_close([screw.pitch()], [slide / angle], 1e-13);
        let back = DualQuat::from_screw(Screw { axis, angle, slide });
        assert_close(back.to_array(), sigma.to_array(), 1e-14);
        // Eqs. 40 to 42: sine and cosine of the dual angle.
        let half = Dual::new(angle / 2.0, slide / 2.0);
        let scalar = sigma.dual_scalar();
        assert_close([scalar.real, scalar.dual], [half.cos().real, half.cos().dual], 1e-14);
        let wanted = as_dual_quat(axis).scale_dual(half.sin());
        assert_close(sigma.real().xyz(), wanted.real().xyz(), 1e-14);
        assert_close(sigma.dual().xyz(), wanted.dual().xyz(), 1e-14);
    }
}

#[test]
fn eqs_37_and_38_every_form_of_the_moment_is_the_same() {
    let (p, l) = ([1.0, -2.0, 0.5], [2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0]);
    let m = line_through(p, l).moment;
    for (angle, slide) in [(0.3, 2.0), (1.5, -1.0), (3.0, 0.0)] {
        let sigma = turn_and_slide(p, l, angle, slide);
        let t = sigma.translation();
        // d = t·l, and t = 2qp*.
        assert_close([dot(t, l)], [slide], 1e-14);
        let across = cross(t, l);
        let cot = 1.0 / (angle / 2.0).tan();
        let first = add(across, cross(l, across).map(|c| cot * c)).map(|c| c / 2.0);
        let rest = add(t, l.map(|c| -slide * c));
        let second = add(across, rest.map(|c| cot * c)).map(|c| c / 2.0);
        assert_close(first, m, 1e-14);
        assert_close(second, m, 1e-14);
        let (sin, cos) = (angle / 2.0).sin_cos();
        let left = add(m.map(|c| sin * c), l.map(|c| slide / 2.0 * cos * c));
        let right = add(across.map(|c| sin * c), t.map(|c| cos * c)).map(|c| c / 2.0);
        assert_close(left, right, 1e-14);
    }
}

/// §8.2 has the moment infinite "when θ = 0 or π". At π the cotangent is 0: half a turn about
/// the vertical through (1,2,0), up by 3.
#[test]
fn eq_37_erratum_the_moment_is_finite_at_half_a_turn() {
    let half_turn = Quat::from_wxyz([0.0, 0.0, 0.0, 1.0]);
    let screw = DualQuat::from_rotation_translation(half_turn, [2.0, 4.0, 3.0]).to_screw();
    assert_eq!((screw.angle, screw.slide), (PI, 3.0));
    assert_eq!(screw.axis, line_through([1.0, 2.0, 0.0], [0.0, 0.0, 1.0]));
    assert_eq!(screw.axis.moment, [2.0, -1.0, 0.0]);
}

#[test]
fn eq_37_the_moment_grows_without_bound_toward_no_turn() {
    for angle in [1e-1, 1e-2, 1e-4, 1e-6] {
        let r = Quat::from_axis_angle([0.0, 0.0, 1.0], angle);
        let screw = DualQuat::from_rotation_translation(r, [1.0, 0.0, 0.0]).to_screw();
        let moment = length(screw.axis.moment);
        assert_close([moment * 2.0 * (angle / 2.0).sin()], [1.0], 1e-9);
    }
    // At none at all dq8 takes the direction of the translation, through the origin.
    let screw = DualQuat::from_translation([0.0, 3.0, 4.0]).to_screw();
    assert_eq!((screw.angle, screw.slide), (0.0, 5.0));
    assert_eq!(screw.axis, line_through([0.0; 3], [0.0, 0.6, 0.8]));
}

#[test]
fn eq_44_a_power_keeps_the_axis_and_scales_angle_and_slide() {
    let (p, l) = ([1.0, -2.0, 0.5], [2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0]);
    let sigma = turn_and_slide(p, l, 1.5, 2.0);
    for tau in [0.25, 1.0, 2.0, -0.5] {
        let wanted = turn_and_slide(p, l, 1.5 * tau, 2.0 * tau);
        assert_close(sigma.pow(tau).to_array(), wanted.to_array(), 1e-14);
    }
}

/// A turn at the angular velocity ω of space, not of the body, from r₀, and a shift at v from
/// t₀.
#[test]
fn eq_45_the_derivative_takes_the_angular_velocity_of_space() {
    let (omega, v) = ([0.3, -0.8, 0.5], [1.0, 0.25, -2.0]);
    let [start, _] = motions();
    let at = |time: f64| {
        let speed = length(omega);
        let turn = Quat::from_axis_angle(omega.map(|c| c / speed), speed * time);
        let shift = add(start.translation(), v.map(|c| c * time));
        DualQuat::from_rotation_translation(turn * start.rotation(), shift)
    };
    let time = 0.7;
    let step = 1e-5;
    let slope = (at(time + step) - at(time - step)).scale(0.5 / step);
    let (r, t) = (at(time).rotation(), pure(at(time).translation()));
    let derivative = |r_dot: Quat<f64>| DualQuat::new(r_dot, (pure(v) * r + t * r_dot).scale(0.5));
    let of_space = (pure(omega) * r).scale(0.5);
    assert_close(slope.to_array(), derivative(of_space).to_array(), 1e-9);
    // By the twist of dq8, whose linear part is the velocity at the origin of space.
    let linear = add(v, cross(at(time).translation(), omega));
    let by_twist = at(time).derivative_spatial(Twist { angular: omega, linear });
    assert_close(by_twist.to_array(), derivative(of_space).to_array(), 1e-14);
    // ½ r ω takes ω for a velocity seen from the body: right only for what the body sees of ω.
    assert_far(slope.to_array(), derivative((r * pure(omega)).scale(0.5)).to_array());
    let seen = r.conjugate().rotate(omega);
    let of_body = (r * pure(seen)).scale(0.5);
    assert_close(slope.to_array(), derivative(of_body).to_array(), 1e-9);
}

#[test]
fn section_10_the_difference_of_two_motions_holds_that_of_their_translations() {
    let [a, b] = motions();
    let back = a.rotation().conjugate();
    let apart = add(b.translation(), a.translation().map(|c| -c));
    let dual = (back * pure(apart) * b.rotation()).scale(0.5);
    let wanted = DualQuat::new(back * b.rotation(), dual);
    assert_close((a.inverse() * b).to_array(), wanted.to_array(), 1e-15);
}

/// §10 ends with cos + l sin + ε(τd/2)(−sin + l cos), angles τθ/2: that is the screw about
/// the parallel through the origin. The term ε sin(τθ/2) m is missing.
#[test]
fn section_10_erratum_screw_interpolation_needs_the_moment_term() {
    let [a, b] = motions();
    let Screw { axis: Line { direction: l, moment: m }, angle, slide } =
        (a.conjugate() * b).to_screw();
    for tau in [0.25, 0.5, 1.0] {
        let (sin, cos) = (tau * angle / 2.0).sin_cos();
        let half_slide = tau * slide / 2.0;
        let along = Quat::from_parts(l.map(|c| c * cos), -sin).scale(half_slide);
        let real = Quat::from_parts(l.map(|c| c * sin), cos);
        let printed = a * DualQuat::new(real, along);
        let whole = a * DualQuat::new(real, along + pure(m.map(|c| c * sin)));
        let sclerp = a.sclerp(b, tau);
        assert_close(whole.to_array(), sclerp.to_array(), 1e-14);
        assert_far(printed.translation(), sclerp.translation());
    }
}
