//! What determines no line, plane or point; numbers that are not finite, very small or very large.

use dq8::{
    Dual, Line, Plane, Real,
    incidence::{CommonPerpendicular, IncidenceError},
};
use std::fmt::Debug;

/// The error's name, without its values.
#[track_caller]
fn refused<T: Debug>(result: Result<T, IncidenceError>) -> &'static str {
    let error = result.unwrap_err();
    assert!(!error.to_string().is_empty());
    match error {
        IncidenceError::NoDirection { .. } => "no direction",
        IncidenceError::NotFinite { .. } => "not finite",
        IncidenceError::Collinear { .. } => "collinear",
        IncidenceError::PointOnLine { .. } => "point on line",
        IncidenceError::ParallelPlanes { .. } => "parallel planes",
        IncidenceError::ParallelToPlane { .. } => "parallel to plane",
        IncidenceError::ParallelLines { .. } => "parallel lines",
        IncidenceError::SkewLines { .. } => "skew lines",
        other => panic!("an error without a name here: {other:?}"),
    }
}

fn axis<R: Real>(which: usize) -> [R; 3] {
    std::array::from_fn(|c| if c == which { R::ONE } else { R::ZERO })
}

fn what_is_not_determined_is_refused<R: Real>() {
    let n = |value: f64| R::from_f64(value);
    let (zero, p) = ([R::ZERO; 3], [n(1.0), n(-2.0), n(0.5)]);
    let [x, y, z] = [0, 1, 2].map(axis::<R>);
    let line = Line::from_point_direction(p, x);
    let floor = Plane::from_point_normal(p, z);
    let (no_line, no_plane) =
        (Line::from_point_direction(p, zero), Plane::from_point_normal(p, zero));

    assert_eq!(refused(Line::from_points(p, p)), "no direction");
    assert_eq!(refused(no_line.try_normalize()), "no direction");
    assert_eq!(refused(no_line.distance_to_point(p)), "no direction");
    assert_eq!(refused(no_line.dual_angle(line)), "no direction");
    assert_eq!(refused(line.dual_angle(no_line)), "no direction");
    assert_eq!(refused(line.distance_to_line(no_line)), "no direction");
    assert_eq!(refused(line.intersection_with_plane(no_plane)), "no direction");
    assert_eq!(refused(no_line.distance_to_plane(floor)), "no direction");
    assert_eq!(refused(no_plane.try_normalize()), "no direction");
    assert_eq!(refused(Line::from_planes(floor, no_plane)), "no direction");
    assert!(!no_line.is_line(n(1e30)));

    let shelf = Plane { normal: z.map(|c| -c * n(3.0)), offset: n(7.0) };
    assert_eq!(refused(Line::from_planes(floor, floor)), "parallel planes");
    assert_eq!(refused(Line::from_planes(floor, shelf)), "parallel planes");
    assert_eq!(refused(line.intersection_with_plane(floor)), "parallel to plane");
    assert_eq!(refused(line.intersection(line, n(1.0))), "parallel lines");

    let along = |s: f64| [p[0] + n(s), p[1] + n(s), p[2] + n(s)];
    assert_eq!(refused(Plane::from_points(p, along(1.0), along(-2.0))), "collinear");
    assert_eq!(refused(Plane::from_points(p, along(1.0), along(1.0))), "collinear");
    assert_eq!(refused(Plane::from_points(p, p, along(1.0))), "no direction");
    assert_eq!(refused(Plane::from_points(p, along(1.0), p)), "no direction");
    assert_eq!(refused(Plane::from_line_point(line, p)), "point on line");
    assert_eq!(refused(Plane::from_line_point(no_line, y)), "no direction");
    assert_eq!(
        refused(Plane::from_line_point(Line::from_point_direction(zero, x), x)),
        "point on line"
    );
}

#[test]
fn what_is_not_determined_is_refused_in_both() {
    what_is_not_determined_is_refused::<f32>();
    what_is_not_determined_is_refused::<f64>();
}

fn what_is_not_finite_is_refused<R: Real>() {
    let (one, p) = (R::ONE, [R::ONE; 3]);
    let [x, y, z] = [0, 1, 2].map(axis::<R>);
    let (line, floor) = (Line::from_point_direction(p, x), Plane::from_point_normal(p, z));
    for value in [R::NAN, one / R::ZERO, -one / R::ZERO] {
        for c in 0..3 {
            let mut bad = z;
            bad[c] = value;
            let (direction, moment) =
                (Line { direction: bad, ..line }, Line { moment: bad, ..line });
            for bad in [direction, moment] {
                assert!(!bad.is_line(one) && bad.try_normalize().is_err(), "{bad:?}");
                assert!(bad.dual_angle(line).is_err() && line.dual_angle(bad).is_err());
                assert!(
                    bad.intersection(line, one).is_err() && bad.distance_to_line(line).is_err()
                );
                assert!(bad.distance_to_point(p).is_err() && bad.distance_to_plane(floor).is_err());
                assert!(bad.intersection_with_plane(floor).is_err());
                assert!(Plane::from_line_point(bad, y).is_err());
            }
            assert!(line.distance_to_point(bad).is_err(), "{bad:?}");
            assert!(Line::from_points(bad, p).is_err() && Line::from_points(p, bad).is_err());
            assert!(
                Plane::from_points(bad, x, y).is_err() && Plane::from_points(x, y, bad).is_err()
            );
            assert!(Plane::from_line_point(line, bad).is_err());
            assert!(Plane { normal: bad, offset: one }.try_normalize().is_err());
        }
        let plane = Plane { normal: x, offset: value };
        assert!(plane.try_normalize().is_err() && Line::from_planes(plane, floor).is_err());
        assert!(
            line.intersection_with_plane(plane).is_err() && line.distance_to_plane(plane).is_err()
        );
    }
}

#[test]
fn what_is_not_finite_is_refused_in_both() {
    what_is_not_finite_is_refused::<f32>();
    what_is_not_finite_is_refused::<f64>();
}

/// Squares of these overflow, or vanish.
fn numbers_of_any_size_have_answers<R: Real>(sizes: [f64; 4]) {
    for size in sizes.map(R::from_f64) {
        let n = |value: f64| R::from_f64(value) * size;
        let zero = [R::ZERO; 3];
        let a = Line::from_points(zero, [n(4.0), R::ZERO, R::ZERO]).unwrap();
        let b = Line::from_points([n(2.0), n(1.0), n(3.0)], [n(2.0), n(-1.0), n(3.0)]).unwrap();
        assert_eq!((a.direction, b.direction), (axis(0), axis(1).map(|c: R| -c)));
        let CommonPerpendicular { feet, angle, .. } = a.common_perpendicular(b).unwrap();
        assert_eq!(angle, Dual::new(R::PI * R::HALF, n(-3.0)));
        assert_eq!(feet, [[n(2.0), R::ZERO, R::ZERO], [n(2.0), R::ZERO, n(3.0)]]);
        let long = Line { direction: a.direction.map(|c| c * size), moment: a.moment };
        assert_eq!(long.dual_angle(b), Ok(angle));
        assert_eq!(a.distance_to_point([size, n(3.0), n(4.0)]), Ok(n(5.0)));

        let plane = Plane::from_points(
            [R::ZERO, R::ZERO, size],
            [size, R::ZERO, size],
            [R::ZERO, size, size],
        );
        assert_eq!(plane, Ok(Plane { normal: axis(2), offset: size }));
        let up = Line::from_points([size, size, R::ZERO], [size, size, n(0.5)]).unwrap();
        let cut =
            up.intersection_with_plane(Plane { normal: [R::ZERO, R::ZERO, size], offset: R::ZERO });
        assert_eq!(cut, Ok([size, size, R::ZERO]));
    }
}

/// One and a half units of the last place of √⅓.
const LAST_BIT: f32 = 0.75 * f32::EPSILON;

/// The length of subnormal numbers has no more digits than they have.
#[test]
fn directions_of_subnormal_numbers_have_length_one() {
    for size in [1e-45_f32, 1e-44, 1e-42, 1e-39] {
        let line = Line::from_points([0.0; 3], [size, size, 0.0]).unwrap();
        let [x, y, z] = line.direction;
        assert!((x * x + y * y + z * z - 1.0).abs() < 2.0 * f32::EPSILON, "{size}: {line:?}");
        let axis = Line { direction: [size; 3], moment: [size, -size, 0.0] }.try_normalize();
        let third = (1.0_f32 / 3.0).sqrt();
        let off = axis.unwrap().moment.map(|c| (c.abs() - third).abs());
        assert!(off[0] < LAST_BIT && off[1] < LAST_BIT, "{size}: {axis:?}");
        let plane = Plane { normal: [size; 3], offset: size }.try_normalize().unwrap();
        assert!((plane.offset - third).abs() < LAST_BIT, "{size}: {plane:?}");
    }
}

#[test]
fn numbers_of_any_size_have_answers_in_both() {
    numbers_of_any_size_have_answers::<f32>([1e-42, 1e-30, 1e30, 1e37]);
    numbers_of_any_size_have_answers::<f64>([1e-310, 1e-200, 1e200, 1e306]);
}

/// Finite input whose answer is not.
#[test]
fn answers_that_overflow_are_refused() {
    let far = Line::from_points([f32::MAX, 0.0, 0.0], [-f32::MAX, 0.0, 0.0]);
    assert_eq!(refused(far), "no direction");
    let moment = [0.0, f32::MAX, 0.0];
    let tiny = Line { direction: [1e-3, 0.0, 0.0], moment };
    assert_eq!(refused(tiny.try_normalize()), "not finite");
    let plane = Plane { normal: [0.0, 0.0, 1e-3], offset: f32::MAX };
    assert_eq!(refused(plane.try_normalize()), "not finite");
    // They cross 10⁴⁴ away.
    let x = Line::from_point_direction([0.0_f32; 3], [1.0, 0.0, 0.0]);
    let flat = Plane::from_point_normal([0.0, 0.0, 1e38], [-1e-6, 0.0, 1.0]);
    assert_eq!(refused(x.intersection_with_plane(flat)), "not finite");
    let other = Line::from_point_direction([0.0, 1e38, 0.0], [1.0, 1e-6, 0.0]);
    assert_eq!(refused(x.common_perpendicular(other)), "not finite");
}

#[test]
fn errors_say_what_and_how_much() {
    let same = Line::from_points([1.0_f32; 3], [1.0; 3]).unwrap_err();
    assert_eq!(
        same.to_string(),
        "the way between two points of a line has no direction: its length is 0"
    );
    let x = Line::from_point_direction([0.0_f64; 3], [1.0, 0.0, 0.0]);
    let above = Line::from_point_direction([0.0, 0.0, 2.5], [0.0, 1.0, 0.0]);
    let skew = x.intersection(above, 0.1).unwrap_err();
    assert_eq!(skew.to_string(), "the lines do not meet: they are 2.5 apart");
    let error: &dyn core::error::Error = &skew;
    assert!(error.source().is_none());
}
