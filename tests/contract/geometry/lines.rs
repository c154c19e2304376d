//! Lines and planes: made of points and directions, normalized, distances of points; where they
//! meet, and how they pass each other.

use dq8::{Line, Plane};

geometry! { lines:
    "Line::from_point_direction"(p: point, l: point) -> line,
        |v| [each(3, v.norm("l")), each(3, v.norm("p") * v.norm("l"))].concat(), [
        within(1.1, "a cross product")],
        plain Line::from_point_direction(p, l);
    "Line::from_points"(p: point, q: point) -> line, |v| [each(3, 1.0), each(3, v.norm("p"))].concat(), [
        within(3.0, "a difference over its length; a cross product, and the part of it along the line")],
        alone Line::from_points(p, q);
    "Line::try_normalize"(a: line) -> line, |v| [each(3, 1.0), each(3, far(v, "a"))].concat(), [
        within(2.8, "a length, a reciprocal and a product; the part of the moment along the line")],
        alone a.try_normalize();
    "Line::is_line"(a: line, tolerance: number) -> flag, |_| each(1, 1.0), [
        within(0.0, "a truth value")],
        alone Ok::<_, ()>(a.is_line(tolerance));
    "Line::closest_point_to_origin"(a: line) -> point, |v| each(3, v.line("a").0 * v.line("a").1), [
        within(1.6, "a cross product")],
        plain a.closest_point_to_origin();
    "Line::closest_point"(a: line, p: point) -> point, closest_point, [
        within(1.2, "a cross product, and twice a product with the direction")],
        plain a.closest_point(p);
    "Line::distance_to_point"(a: line, p: point) -> number, |v| each(1, far(v, "a") + v.norm("p")), [
        on(&["near"], 0.6, "of the scale: what is left of a difference of terms as long as it"),
        within(4.9, "a line made unit, a cross product, a difference and a length")],
        alone a.distance_to_point(p);
    "Line::reciprocal_product"(a: line, b: line) -> number, reciprocal_product, [
        within(2.1, "a sum of 6 products")],
        plain a.reciprocal_product(b);
    "Plane::from_point_normal"(p: point, n: point) -> plane,
        |v| [each(3, v.norm("n")), each(1, v.norm("n") * v.norm("p"))].concat(), [
        within(1.4, "a sum of 3 products")],
        plain Plane::from_point_normal(p, n);
    "Plane::from_points"(p: point, q: point, r: point) -> plane, plane_from_points, [
        within(2.0, "two directions, their cross product, its length; a sum of 3 products")],
        alone Plane::from_points(p, q, r);
    "Plane::from_line_point"(a: line, p: point) -> plane, plane_from_line_point, [
        on(&["near"], 0.6, "of the scale, which is over the distance"),
        within(2.5, "a line made unit, a difference over its length, a sum of 3 products")],
        alone Plane::from_line_point(a, p);
    "Plane::try_normalize"(a: plane) -> plane, |v| [each(3, 1.0), each(1, offset(v, "a"))].concat(), [
        within(3.0, "a length, a reciprocal and a product")],
        alone a.try_normalize();
    "Plane::signed_distance"(a: plane, p: point) -> number, signed_distance, [
        within(1.0, "a sum of 4 terms")],
        plain a.signed_distance(p);
    "Line::from_planes"(a: plane, b: plane) -> line, line_from_planes, [
        within(3.0, "two planes made unit, a cross product over its length")],
        alone Line::from_planes(a, b);
    "Line::intersection_with_plane"(a: line, b: plane) -> point, crossing, [
        within(2.5, "a foot, and a way along the line over the sine")],
        alone a.intersection_with_plane(b);
    "Line::distance_to_plane"(a: line, b: plane) -> number, |v| each(1, far(v, "a") + offset(v, "b")), [
        within(5.2, "a line and a plane made unit, a foot, a sum of 4 terms")],
        alone a.distance_to_plane(b);
    "Line::dual_angle"(a: line, b: line) -> dual, dual_angle, [
        on(&["close"], 1.3, "of the scale, which is over the sine"),
        within(8.0, "an arctangent, up to π, of which an ulp is 4 u; feet, whose difference is projected")],
        alone a.dual_angle(b);
    "Line::distance_to_line"(a: line, b: line) -> number, |v| dual_angle(v)[1..].to_vec(), [
        on(&["close"], 1.5, "of the scale, which is over the sine"),
        within(8.0, "two lines made unit, two feet, what is across their difference, its length")],
        alone a.distance_to_line(b);
    "Line::common_perpendicular"(a: line, b: line) -> perpendicular, perpendicular, [
        on(&["close"], 2.1, "of the scale, which is over the sine, or its square"),
        within(7.0, "an angle up to π; feet and moments, each with the roundings of two unit lines and of the way between")],
        alone a.common_perpendicular(b);
    "Line::intersection"(a: line, b: line, tolerance: number) -> point, |v| perpendicular(v)[6..9].to_vec(), [
        on(&["close"], 1.0, "of the scale, which is over the square of the sine"),
        within(3.5, "the middle of the feet")],
        alone a.intersection(b, tolerance);
}
