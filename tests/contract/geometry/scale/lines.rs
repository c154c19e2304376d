//! For lines and planes.

use super::{each, sine, three};
use crate::vector::{cross, dot, sub};
use crate::vectors::Vector;

/// |m|/|l|: as far from the origin as the point of the moment may be.
pub(crate) fn far(vector: &Vector, line: &str) -> f64 {
    let (direction, moment) = vector.line(line);
    moment / direction
}

/// The distance of a plane from the origin.
pub(crate) fn offset(vector: &Vector, plane: &str) -> f64 {
    far(vector, plane)
}

pub(crate) fn closest_point(vector: &Vector) -> Vec<f64> {
    let (direction, moment) = vector.line("a");
    each(3, direction * moment + direction * direction * vector.norm("p"))
}

pub(crate) fn reciprocal_product(vector: &Vector) -> Vec<f64> {
    let [(l, m), (k, n)] = ["a", "b"].map(|line| vector.line(line));
    each(1, l * n + k * m)
}

/// A normal is known as well as the directions over the sine between them.
pub(crate) fn plane_from_points(vector: &Vector) -> Vec<f64> {
    let [p, q, r] = ["p", "q", "r"].map(|point| three(vector.input(point)));
    let turn = 1.0 / sine(sub(q, p), sub(r, p));
    [each(3, turn), each(1, turn * vector.norm("p"))].concat()
}

/// A normal is as well known as the point and the line are to themselves, over their distance.
pub(crate) fn plane_from_line_point(vector: &Vector) -> Vec<f64> {
    let p = vector.norm("p");
    let distance = distance(three(vector.input("p")), vector.input("a"));
    let turn = (far(vector, "a") + p) / distance;
    [each(3, turn), each(1, turn * p)].concat()
}

/// Of a point and a line.
fn distance(p: [f64; 3], line: &[f64]) -> f64 {
    let (l, m) = (three(line), three(&line[3..]));
    let size = crate::case::length(&l);
    let l = l.map(|c| c / size);
    let foot = cross(l, m.map(|c| c / size));
    let way = sub(p, foot);
    let along = dot(way, l);
    crate::case::length(&sub(way, l.map(|c| c * along)))
}

pub(crate) fn signed_distance(vector: &Vector) -> Vec<f64> {
    let (normal, offset) = vector.line("a");
    each(1, normal * vector.norm("p") + offset)
}

pub(crate) fn line_from_planes(vector: &Vector) -> Vec<f64> {
    let sine = sine(three(vector.input("a")), three(vector.input("b")));
    let offsets = offset(vector, "a") + offset(vector, "b");
    // The moment is divided by a sine that is as well known as the direction.
    let moment = crate::case::length(&vector.out[3..]);
    [each(3, 1.0 / sine), each(3, (offsets + moment) / sine)].concat()
}

/// How far away line and plane are, over the sine between them; the way along the line is divided
/// by a sine that is known to a rounding of 1.
pub(crate) fn crossing(vector: &Vector) -> Vec<f64> {
    let (a, b) = (three(vector.input("a")), three(vector.input("b")));
    let lengths = crate::case::length(&a) * crate::case::length(&b);
    let sine = dot(a, b).abs() / lengths;
    let sizes = far(vector, "a") + offset(vector, "b");
    let point = crate::case::length(&vector.out);
    each(3, (sizes + point) / sine)
}

/// The sine between two lines, and how far from the origin they are.
fn pair(vector: &Vector) -> (f64, f64) {
    let [a, b] = ["a", "b"].map(|line| three(vector.input(line)));
    (sine(a, b), far(vector, "a").max(far(vector, "b")))
}

/// Lines whose sine is as small as this are parallel: see `dq8::incidence`.
const PARALLEL: f64 = 1e-15;

/// θ is known to a rounding of 1, and d to one of how far away lines and feet may be.
pub(crate) fn dual_angle(vector: &Vector) -> Vec<f64> {
    let (sine, far) = pair(vector);
    vec![1.0, if sine < PARALLEL { far } else { far / sine }]
}

/// Axis, feet, angle, whether they are parallel. The feet of lines that are nearly so have errors
/// over sin²θ.
pub(crate) fn perpendicular(vector: &Vector) -> Vec<f64> {
    let (sine, far) = pair(vector);
    let parallel = sine < PARALLEL;
    let turn =
        if parallel { far / vector.out.get(13).map_or(1.0, |d| d.abs()) } else { 1.0 / sine };
    let feet = if parallel { far } else { far / (sine * sine) };
    let moment = if parallel { far * turn } else { feet };
    [each(3, turn), each(3, moment), each(6, feet), dual_angle(vector), each(1, 1.0)].concat()
}
