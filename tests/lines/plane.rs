//! Lines and planes from points, lines and planes; distances and intersections.

use super::{direction, point};
use dq8::{Line, Plane, Real, geometry::DualVector, incidence::IncidenceError};
use dq8_contract::bound::{exact, rounded, roundoff, within};
use dq8_contract::inputs::for_all;
use dq8_contract::vector::{add, cross, dot, length, scale, sub, unit};
use dq8_contract::worst::Worst;
use nalgebra::{Matrix3, Vector3};

/// The point in which three planes nᵢ·x = dᵢ meet.
fn meet(planes: [([f64; 3], f64); 3]) -> [f64; 3] {
    let rows = planes.map(|(normal, _)| Vector3::from(unit(normal)).transpose());
    let offsets = Vector3::from(planes.map(|(normal, offset)| offset / length(normal)));
    let solved = Matrix3::from_rows(&rows).lu().solve(&offsets);
    solved.expect("they meet").into()
}

fn stored<R: Real>(plane: Plane<R>) -> ([f64; 3], f64) {
    (exact(plane.normal), plane.offset.into())
}

fn a_line_through_two_points_holds_both<R: Real>(allowed: f64) {
    let why = "a moment that was a rounded cross product, and a cross product with the point";
    let worst = Worst::of("points of their line", within(allowed, why));
    for_all(256, &(point(), direction()), |(p, way)| {
        let (start, end) = (rounded::<R, 3>(p), rounded::<R, 3>(add(p, way)));
        let line = Line::from_points(start, end).unwrap();
        let (p, q) = (exact(start), exact(end));
        let size = roundoff::<R>() * (length(p) + length(q));
        worst.see(line.distance_to_point(start).unwrap().into(), size, &line);
        worst.see(line.distance_to_point(end).unwrap().into(), size, &line);
        let toward = sub(exact(line.direction), unit(sub(q, p)));
        worst.see(length(toward), roundoff::<R>(), &line);
        assert!(line.is_line(R::EPSILON * R::from(4.0)));
    });
}

#[test]
fn a_line_through_two_points_holds_both_in_f32_and_f64() {
    a_line_through_two_points_holds_both::<f32>(5.0);
    a_line_through_two_points_holds_both::<f64>(5.0);
}

fn points_beside_a_line_are_as_far_as_vectors_say<R: Real>(allowed: f64) {
    let why = "a cross product and a moment, which cancel where the point is near the line";
    let worst = Worst::of("point and line", within(allowed, why));
    for_all(256, &(point(), direction(), point()), |(p, l, x)| {
        let ([p, l, x], u) = ([p, l, x].map(|v| exact(rounded::<R, 3>(v))), roundoff::<R>());
        let line = Line::<R>::from_point_direction(rounded(p), rounded(l));
        let size = u * (length(p) + length(x) + 1.0);
        let along = scale(unit(l), dot(sub(x, p), unit(l)));
        let (foot, distance) = (add(p, along), length(sub(sub(x, p), along)));
        let found = line.distance_to_point(rounded(x)).unwrap().into();
        worst.see(found - distance, size, &(p, l, x));
        let closest = line.try_normalize().unwrap().closest_point(rounded(x));
        worst.see(length(sub(exact(closest), foot)), size, &(p, l, x));
    });
}

#[test]
fn points_beside_a_line_are_as_far_as_vectors_say_in_f32_and_f64() {
    points_beside_a_line_are_as_far_as_vectors_say::<f32>(6.0);
    points_beside_a_line_are_as_far_as_vectors_say::<f64>(6.0);
}

/// Any third plane across the two cuts out of both the same point as out of the line.
fn the_line_of_two_planes_lies_in_both<R: Real>(allowed: f64) {
    let why = "two offsets times normals, over the square of the sine; in f64 the solution rounds as much";
    let worst = Worst::of("line of two planes", within(allowed, why));
    for_all(256, &(point(), direction(), direction()), |(p, m, n)| {
        let plane = |n| Plane::<R>::from_point_normal(rounded(p), rounded(n));
        let (a, b) = (plane(m), plane(n));
        let sine = length(cross(unit(m), unit(n)));
        if sine < 0.05 {
            return;
        }
        let line = Line::from_planes(a, b).unwrap();
        let across = ([a, b].map(stored), cross(m, n));
        let wanted = meet([across.0[0], across.0[1], (across.1, 0.0)]);
        let size = roundoff::<R>() * (length(p) + 1.0) / sine / sine;
        let found = exact(line.closest_point_to_origin());
        worst.see(length(sub(found, wanted)), size, &(p, m, n));
        let sense = dot(exact(line.direction), unit(cross(m, n)));
        assert!((sense - 1.0).abs() < 16.0 * roundoff::<R>() / sine);
    });
}

#[test]
fn the_line_of_two_planes_lies_in_both_in_f32_and_f64() {
    the_line_of_two_planes_lies_in_both::<f32>(6.0);
    the_line_of_two_planes_lies_in_both::<f64>(9.0);
}

fn a_plane_through_three_points_holds_them<R: Real>(allowed: f64) {
    let why = "a normal that is a rounded cross product, times three points";
    let worst = Worst::of("points of their plane", within(allowed, why));
    for_all(256, &(point(), direction(), direction()), |(p, u, v)| {
        let points = [p, add(p, u), add(p, v)].map(rounded::<R, 3>);
        let [a, b, c] = points.map(exact);
        let (to_b, to_c) = (sub(b, a), sub(c, a));
        let sine = length(cross(unit(to_b), unit(to_c)));
        if sine < 0.05 {
            return;
        }
        let plane = Plane::from_points(points[0], points[1], points[2]).unwrap();
        let size = roundoff::<R>() * (length(a) + (length(to_b) + length(to_c)) / sine);
        for point in points {
            worst.see(plane.signed_distance(point).into(), size, &plane);
        }
        let off = sub(exact(plane.normal), unit(cross(to_b, to_c)));
        worst.see(length(off), roundoff::<R>() / sine, &plane);
    });
}

#[test]
fn a_plane_through_three_points_holds_them_in_f32_and_f64() {
    a_plane_through_three_points_holds_them::<f32>(5.0);
    a_plane_through_three_points_holds_them::<f64>(5.0);
}

#[test]
fn a_plane_through_a_line_and_a_point_holds_both() {
    let why = "a cross product of the line and the way to the point";
    let worst = Worst::of("plane of line and point", within(2.0, why));
    for_all(256, &(point(), direction(), direction()), |(p, l, way)| {
        let line = Line::from_point_direction(p, l);
        let x = add(p, way);
        let sine = length(cross(unit(l), unit(way)));
        if sine < 0.05 {
            return;
        }
        let plane = Plane::from_line_point(line, x).unwrap();
        let size = length(p) + length(x) + 1.0;
        let size = roundoff::<f64>() * size * (1.0 + size / length(way) / sine);
        worst.see(plane.signed_distance(x), size, &plane);
        worst.see(plane.signed_distance(p), size, &plane);
        worst.see(length(sub(plane.normal, unit(cross(l, way)))), size, &plane);
        // Twice a line and a point beside it: the second plane through them crosses in the line.
        let beside = add(x, cross(l, way));
        let other = Plane::from_line_point(line, beside).unwrap();
        let again = Line::from_planes(plane, other).unwrap();
        // Planes a few hundredths apart at the least: a line that is off by an angle has the square
        // of it here.
        assert!((dot(again.direction, unit(l)).abs() - 1.0).abs() < 1e-12);
    });
}

fn a_line_meets_a_plane_where_three_planes_do<R: Real>(allowed: f64) {
    let why = "a moment and an offset, times vectors, over the square of the sine";
    let worst = Worst::of("line and plane", within(allowed, why));
    for_all(256, &(point(), direction(), point(), direction()), |(p, l, q, n)| {
        let ([p, l], u) = ([p, l].map(|v| exact(rounded::<R, 3>(v))), roundoff::<R>());
        let line = Line::<R>::from_point_direction(rounded(p), rounded(l));
        let plane = Plane::<R>::from_point_normal(rounded(q), rounded(n));
        let sine = dot(unit(l), unit(n)).abs();
        if sine < 0.05 {
            return;
        }
        // Two planes through the line, at right angles.
        let m = cross(l, if l[0].abs() < l[1].abs() { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] });
        let k = cross(l, m);
        let (n, d) = stored(plane);
        let wanted = meet([(m, dot(m, p)), (k, dot(k, p)), (n, d)]);
        let found = exact(line.intersection_with_plane(plane).unwrap());
        let size = u * (length(p) + length(q) + 1.0) / sine / sine;
        worst.see(length(sub(found, wanted)), size, &(line, plane));
        assert_eq!(line.distance_to_plane(plane), Ok(R::ZERO));
    });
}

#[test]
fn a_line_meets_a_plane_where_three_planes_do_in_f32_and_f64() {
    a_line_meets_a_plane_where_three_planes_do::<f32>(4.0);
    a_line_meets_a_plane_where_three_planes_do::<f64>(4.0);
}

#[test]
fn a_line_beside_a_plane_keeps_its_distance() {
    let floor = Plane::from_point_normal([3.0_f32, 4.0, 1.0], [0.0, 0.0, 2.0]);
    let below = Line::from_point_direction([5.0, 0.0, -3.0], [3.0, 4.0, 0.0]);
    assert_eq!(below.distance_to_plane(floor), Ok(4.0));
    let parallel = IncidenceError::ParallelToPlane { distance: -4.0 };
    assert_eq!(below.intersection_with_plane(floor), Err(parallel));
    let within = Line::from_point_direction([5.0, 0.0, 1.0], [3.0, 4.0, 0.0]);
    let parallel = IncidenceError::ParallelToPlane { distance: 0.0 };
    assert_eq!(within.intersection_with_plane(floor), Err(parallel));
    assert_eq!(within.distance_to_plane(floor), Ok(0.0));
}

/// A screw l + ε(m + h l) has the pitch h and the axis l + εm.
#[test]
fn normalizing_a_dual_vector_leaves_the_axis_of_its_screw() {
    let why = "a quotient by the length, and what is left of the moment across the direction";
    let worst = Worst::of("axis", within(4.0, why));
    for_all(256, &(point(), direction(), -3.0..3.0_f64), |(p, l, pitch)| {
        let axis = Line::from_point_direction(p, unit(l));
        let screw = DualVector::from(axis).scale_dual([length(l), pitch * length(l)]);
        let found = Line::from(screw).try_normalize().unwrap();
        assert!(found.is_line(1e-15) && (pitch.abs() < 0.1 || !Line::from(screw).is_line(1e-6)));
        let size = roundoff::<f64>() * (length(p) + pitch.abs() + 1.0);
        worst.see(length(sub(found.moment, axis.moment)), size, &axis);
        worst.see(length(sub(found.direction, axis.direction)), roundoff::<f64>(), &axis);
    });
}
