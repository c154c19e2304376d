//! Lines and planes from points, lines and planes; distances and intersections.

use super::{add, direction, exact, length, point, rounded, roundoff, sub, unit};
use dq8::{Line, Plane, Real, geometry::DualVector, incidence::IncidenceError};
use dq8_contract::bound::within;
use dq8_contract::inputs::for_all;
use dq8_contract::worst::Worst;

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
