//! Lines and planes by themselves: made of points and directions, normalized, distances of points.

use dq8::{Line, Plane};

geometry! { lines:
    "Line::from_point_direction"(p: point, l: point) -> line,
        |v| [each(3, v.norm("l")), each(3, v.norm("p") * v.norm("l"))].concat(), [
        within(1.1, "a cross product")],
        plain Line::from_point_direction(p, l);
    "Line::from_points"(p: point, q: point) -> line, |v| [each(3, 1.0), each(3, v.norm("p"))].concat(), [
        within(3.0, "a difference over its length; a cross product, and the part of it along the line")],
        tried Line::from_points(p, q), Line::from_points_checked(p, q);
    "Line::try_normalize"(a: line) -> line, |v| [each(3, 1.0), each(3, far(v, "a"))].concat(), [
        within(2.8, "a length, a reciprocal and a product; the part of the moment along the line")],
        tried a.try_normalize(), a.normalize_checked();
    "Line::is_line"(a: line, tolerance: number) -> flag, |_| each(1, 1.0), [
        within(0.0, "a truth value")],
        plain a.is_line(tolerance), a.is_line_mask(tolerance);
    "Line::closest_point_to_origin"(a: line) -> point, |v| each(3, v.line("a").0 * v.line("a").1), [
        within(1.6, "a cross product")],
        plain a.closest_point_to_origin();
    "Line::closest_point"(a: line, p: point) -> point, closest_point, [
        within(1.2, "a cross product, and twice a product with the direction")],
        plain a.closest_point(p);
    "Line::distance_to_point"(a: line, p: point) -> number, |v| each(1, far(v, "a") + v.norm("p")), [
        on(&["near"], 0.6, "of the scale: what is left of a difference of terms as long as it"),
        within(4.9, "a line made unit, a cross product, a difference and a length")],
        tried a.distance_to_point(p), a.distance_to_point_checked(p);
    "Line::reciprocal_product"(a: line, b: line) -> number, reciprocal_product, [
        within(2.1, "a sum of 6 products")],
        plain a.reciprocal_product(b);
    "Plane::from_point_normal"(p: point, n: point) -> plane,
        |v| [each(3, v.norm("n")), each(1, v.norm("n") * v.norm("p"))].concat(), [
        within(1.4, "a sum of 3 products")],
        plain Plane::from_point_normal(p, n);
    "Plane::from_points"(p: point, q: point, r: point) -> plane, plane_from_points, [
        within(2.0, "two directions, their cross product, its length; a sum of 3 products")],
        tried Plane::from_points(p, q, r), Plane::from_points_checked(p, q, r);
    "Plane::from_line_point"(a: line, p: point) -> plane, plane_from_line_point, [
        on(&["near"], 0.6, "of the scale, which is over the distance"),
        within(2.5, "a line made unit, a difference over its length, a sum of 3 products")],
        tried Plane::from_line_point(a, p), Plane::from_line_point_checked(a, p);
    "Plane::try_normalize"(a: plane) -> plane, |v| [each(3, 1.0), each(1, offset(v, "a"))].concat(), [
        within(3.0, "a length, a reciprocal and a product")],
        tried a.try_normalize(), a.normalize_checked();
    "Plane::signed_distance"(a: plane, p: point) -> number, signed_distance, [
        within(1.0, "a sum of 4 terms")],
        plain a.signed_distance(p);
}
