//! Two lines: dual angle, common perpendicular, distance, intersection.

use super::{Ray, angle, as_stored, direction, point};
use dq8::{
    Dual, Line, Real,
    geometry::DualVector,
    incidence::{CommonPerpendicular, IncidenceError},
};
use dq8_contract::bound::{exact, rounded, roundoff, within};
use dq8_contract::inputs::for_all;
use dq8_contract::vector::{add, cross, dot, length, scale, sub, unit};
use dq8_contract::worst::Worst;
use proptest::prelude::*;
use std::f64::consts::PI;

/// A unit vector, or an angle, of few operations.
const LAST_BITS: f64 = 1e-15;

fn line<R: Real>((point, direction): Ray) -> Line<R> {
    Line::from_point_direction(rounded(point), rounded(direction))
}

/// s and t for which p + su and q + tv are nearest: the derivatives of their squared distance by s
/// and t are zero.
fn nearest((p, u): Ray, (q, v): Ray) -> [[f64; 3]; 2] {
    let (w, uu, uv, vv) = (sub(q, p), dot(u, u), dot(u, v), dot(v, v));
    let determinant = uu * vv - uv * uv;
    let (uw, vw) = (dot(u, w), dot(v, w));
    let s = (uw * vv - vw * uv) / determinant;
    let t = (uw * uv - vw * uu) / determinant;
    [add(p, scale(u, s)), add(q, scale(v, t))]
}

fn skew_lines_are_measured_as_vectors_do<R: Real>(allowed: [f64; 4]) {
    let why = [
        ("angle", "an arctangent of two lengths, made of directions that were rounded to unit"),
        ("distance", "places along a unit vector that is a quotient by the sine"),
        ("feet", "three products, over the square of the sine; in f64 the solution rounds as much"),
        ("axis", "a cross product of directions that were rounded to unit, over its length"),
    ];
    let worst: [_; 4] = std::array::from_fn(|i| Worst::of(why[i].0, within(allowed[i], why[i].1)));
    for_all(512, &(point(), direction(), point(), direction()), |(p, u, q, v)| {
        let (a, b) = (as_stored::<R>((p, u)), as_stored::<R>((q, v)));
        let normal = cross(unit(a.1), unit(b.1));
        let sine = length(normal);
        if sine < 0.05 {
            return;
        }
        let found = line::<R>(a).common_perpendicular(line(b)).expect("skew lines have one");
        let CommonPerpendicular { axis, feet, angle: Dual { real, dual }, parallel } = found;
        assert!(!parallel);
        let size = (length(a.0) + length(b.0) + 1.0) / sine;
        let u = roundoff::<R>();
        worst[0].see(real.into() - angle(a.1, b.1), u, &found);
        let far = length(a.0) + length(b.0) + length(exact(feet[0])) + 1.0;
        worst[1].see(dual.into() - dot(sub(b.0, a.0), normal) / sine, u * far, &found);
        for (foot, wanted) in feet.into_iter().zip(nearest(a, b)) {
            worst[2].see(length(sub(exact(foot), wanted)), u * size / sine, &found);
        }
        worst[3].see(length(sub(exact(axis.direction), unit(normal))), u / sine, &found);
        assert!(axis.is_line(R::from_f64(8.0 * u)));
    });
}

#[test]
fn skew_lines_are_measured_as_vectors_do_in_f32() {
    skew_lines_are_measured_as_vectors_do::<f32>([6.0, 5.0, 7.0, 4.0]);
}

#[test]
fn skew_lines_are_measured_as_vectors_do_in_f64() {
    // Here the feet are also wrong by what their solution rounds away.
    skew_lines_are_measured_as_vectors_do::<f64>([6.0, 6.0, 30.0, 4.0]);
}

/// Two unit lines with these feet, at this angle.
fn pair_with(feet: [[f64; 3]; 2], l: [f64; 3], n: [f64; 3], angle: f64) -> [Ray; 2] {
    let turned = add(scale(l, angle.cos()), scale(cross(n, l), angle.sin()));
    [(feet[0], l), (feet[1], turned)]
}

/// Down to 10⁻⁷ in f32 and 10⁻¹⁵ in f64, where an arccosine has lost all.
fn small_angles_and_those_near_pi_are_exact<R: Real>(allowed: [f64; 2]) {
    let (l, n) = ([0.48, 0.64, 0.6], [0.8, -0.6, 0.0]);
    let u = roundoff::<R>();
    let why = "the chord of directions as they are stored: twice an arctangent of two lengths";
    let worst = Worst::of("nearly parallel: angle", within(allowed[0], why));
    let why = "a place along a unit vector that is a quotient by the sine";
    let distances = Worst::of("nearly parallel: distance", within(allowed[1], why));
    for exponent in 1..=15 {
        let theta = 10.0_f64.powi(-exponent);
        if theta < 16.0 * u {
            continue;
        }
        for theta in [theta, PI - theta] {
            let foot = [0.5, -1.0, 2.0];
            let [a, b] =
                pair_with([foot, add(foot, scale(n, 3.0))], l, n, theta).map(as_stored::<R>);
            let found = line::<R>(a).common_perpendicular(line(b)).unwrap();
            assert!(!found.parallel, "{theta}");
            worst.see(found.angle.real.into() - angle(a.1, b.1), u, &theta);
            // Rounding has turned the perpendicular: l × (±l′ − l) keeps what l × l′
            // rounds away.
            let sense = if theta > 1.0 { -1.0 } else { 1.0 };
            let normal = scale(cross(a.1, sub(scale(b.1, sense), a.1)), sense);
            let feet_off = 3.0 * u / length(normal).powi(2);
            let far = 3.0 + length(foot) + length(exact(found.feet[0])) + feet_off;
            let wanted = dot(sub(b.0, a.0), unit(normal));
            distances.see(found.angle.dual.into() - wanted, u * far, &theta);
        }
    }
}

#[test]
fn small_angles_and_those_near_pi_are_exact_in_both() {
    small_angles_and_those_near_pi_are_exact::<f32>([3.0, 3.0]);
    small_angles_and_those_near_pi_are_exact::<f64>([1.0, 3.0]);
}

/// cos θ̂ = a·b and sin θ̂ (axis) = a × b of the unit lines as dual vectors.
#[test]
fn inner_and_cross_product_are_cosine_and_sine_of_the_dual_angle() {
    let cosine = "six products, and the cosine of an angle that is rounded itself";
    let cosine = Worst::of("cosine", within(6.0, cosine));
    let sine = "three cross products, and the sine of a rounded angle about a rounded axis";
    let sine = Worst::of("sine", within(10.0, sine));
    for_all(512, &(point(), direction(), point(), direction()), |(p, u, q, v)| {
        let [a, b] = [(p, u), (q, v)].map(|ray| line::<f64>(ray).try_normalize().unwrap());
        let CommonPerpendicular { axis, angle, .. } = a.common_perpendicular(b).unwrap();
        let (a, b) = (DualVector::from(a), DualVector::from(b));
        let scale = roundoff::<f64>() * (length(p) + length(q) + 1.0);
        let ([real, dual], wanted) = (a.dot(b), angle.cos());
        cosine.see(real - wanted.real, roundoff::<f64>(), &angle);
        cosine.see(dual - wanted.dual, scale, &angle);
        let wanted = DualVector::from(axis).scale_dual([angle.sin().real, angle.sin().dual]);
        let off = a.cross(b) - wanted;
        sine.see(length(off.real), roundoff::<f64>(), &angle);
        sine.see(length(off.dual), scale / angle.sin().real, &angle);
    });
}

/// The order of two lines does not matter, the sense of either does.
#[test]
fn the_distance_has_the_sign_of_the_twist_between_the_lines() {
    let x = Line::from_point_direction([0.0_f64; 3], [1.0, 0.0, 0.0]);
    let above = Line::from_point_direction([0.0, 0.0, 2.0], [0.0, 1.0, 0.0]);
    let reversed = Line::from(-DualVector::from(above));
    let right = PI / 2.0;
    assert_eq!(x.dual_angle(above), Ok(Dual::new(right, 2.0)));
    assert_eq!(above.dual_angle(x), Ok(Dual::new(right, 2.0)));
    assert_eq!(x.dual_angle(reversed), Ok(Dual::new(right, -2.0)));
    assert_eq!(x.distance_to_line(reversed), Ok(2.0));
    assert_eq!(x.reciprocal_product(above), -2.0);
}

#[test]
fn parallel_and_antiparallel_lines_have_the_perpendicular_through_the_origin() {
    let why =
        "a length across a direction, and two feet on it: some projections one after the other";
    let worst = Worst::of("parallel", within(8.0, why));
    for_all(256, &(point(), direction(), point(), any::<bool>()), |(p, u, q, opposite)| {
        // Not twice the same direction but for a factor that rounds.
        let v = scale(u, if opposite { -3.7 } else { 0.3 });
        let found = line::<f64>((p, u)).common_perpendicular(line((q, v))).unwrap();
        let along = scale(unit(u), dot(sub(q, p), unit(u)));
        let scale = roundoff::<f64>() * (length(p) + length(q) + 1.0);
        assert!(found.parallel);
        assert!((found.angle.real - if opposite { PI } else { 0.0 }).abs() < LAST_BITS);
        worst.see(found.angle.dual - length(sub(sub(q, p), along)), scale, &found);
        for foot in found.feet {
            worst.see(dot(foot, unit(u)), scale, &found);
        }
        let apart = length(sub(found.feet[1], found.feet[0]));
        worst.see(apart - found.angle.dual, scale, &found);
        // Lines that are near each other leave the perpendicular few digits.
        assert!(dot(found.axis.direction, unit(u)).abs() < 1e-11, "{found:?}");
    });
}

#[test]
fn identical_and_opposite_lines_are_no_distance_apart() {
    for_all(256, &(point(), direction(), -2.0..2.0_f64, any::<bool>()), |(p, u, s, opposite)| {
        let (a, factor) = ((p, u), if opposite { -1.7 } else { 1.7 });
        let same = (add(p, scale(u, s)), scale(u, factor));
        let (a, b) = (line::<f64>(a), line(same));
        let found = a.common_perpendicular(b).unwrap();
        let size = length(p) + length(same.0) + 1.0;
        assert!(found.parallel && found.angle.dual < 8.0 * roundoff::<f64>() * size, "{found:?}");
        assert!(matches!(a.intersection(b, 1.0), Err(IncidenceError::ParallelLines { .. })));
        let axis = found.axis.direction;
        // Rounding alone says where the perpendicular points, and it is not long.
        let across = dot(axis, unit(u)).abs();
        assert!((length(axis) - 1.0).abs() < LAST_BITS && across < 1e-3);
    });
    // Without rounding the perpendicular is exact, whichever axis it has to keep away from.
    for direction in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [0.6, 0.0, 0.8]] {
        let a = Line::from_point_direction([0.0_f64; 3], direction);
        let found = a.common_perpendicular(a).unwrap();
        assert_eq!((found.angle, found.feet), (Dual::ZERO, [[0.0; 3]; 2]));
        assert_eq!(dot(found.axis.direction, direction), 0.0);
    }
}

fn lines_through_a_point_meet_in_it<R: Real>(allowed: f64) {
    let why = "the middle of two feet, three products each, over the sine";
    let worst = Worst::of("intersection", within(allowed, why));
    for_all(256, &(point(), direction(), direction()), |(p, u, v)| {
        let (a, b) = (as_stored::<R>((p, u)), as_stored::<R>((p, v)));
        let sine = length(cross(unit(a.1), unit(b.1)));
        if sine < 0.05 {
            return;
        }
        let size = roundoff::<R>() * (length(p) + 1.0) / sine;
        let near = line::<R>(a).intersection(line(b), R::from_f64(8.0 * size));
        worst.see(length(sub(exact(near.unwrap()), a.0)), size, &(a, b));
    });
}

#[test]
fn lines_through_a_point_meet_in_it_in_both() {
    lines_through_a_point_meet_in_it::<f32>(8.0);
    lines_through_a_point_meet_in_it::<f64>(8.0);
}

#[test]
fn skew_lines_meet_only_within_the_tolerance() {
    let x = Line::from_point_direction([0.0_f32; 3], [1.0, 0.0, 0.0]);
    let above = Line::from_point_direction([5.0, 0.0, 2.0], [0.0, -1.0, 0.0]);
    assert_eq!(x.intersection(above, 2.0), Ok([5.0, 0.0, 1.0]));
    assert_eq!(x.intersection(above, 1.9), Err(IncidenceError::SkewLines { distance: 2.0 }));
    assert!(x.intersection(above, f32::NAN).is_err());
}

/// dd/dh of the distance of a line that rises is 1, and of the angle to one that turns is 1.
#[test]
fn the_dual_angle_differentiates_itself() {
    let constant = |v: [f64; 3]| v.map(|c| Dual::new(c, 0.0));
    let x = Line::from_point_direction(constant([0.0; 3]), constant([1.0, 0.0, 0.0]));
    let (height, turn) = (Dual::new(2.0, 1.0), Dual::new(0.5_f64, 1.0));
    let zero = Dual::ZERO;
    let moving = Line::from_point_direction([zero, zero, height], [turn.cos(), turn.sin(), zero]);
    let angle = x.dual_angle(moving).unwrap();
    assert!(
        (angle.real - turn).real.abs() < LAST_BITS && (angle.real.dual - 1.0).abs() < LAST_BITS
    );
    assert_eq!(angle.dual, height);
}
