//! Lines and planes together: where they meet, and how they pass each other.

use dq8::Line;

geometry! { lines:
    "Line::from_planes"(a: plane, b: plane) -> line, line_from_planes, [
        within(3.0, "two planes made unit, a cross product over its length")],
        tried Line::from_planes(a, b), Line::from_planes_checked(a, b);
    "Line::intersection_with_plane"(a: line, b: plane) -> point, crossing, [
        within(2.5, "a foot, and a way along the line over the sine")],
        tried a.intersection_with_plane(b), a.intersection_with_plane_checked(b);
    "Line::distance_to_plane"(a: line, b: plane) -> number, |v| each(1, far(v, "a") + offset(v, "b")), [
        within(5.2, "a line and a plane made unit, a foot, a sum of 4 terms")],
        tried a.distance_to_plane(b), a.distance_to_plane_checked(b);
    "Line::dual_angle"(a: line, b: line) -> dual, dual_angle, [
        on(&["close"], 1.3, "of the scale, which is over the sine"),
        within(8.0, "an arctangent, up to π, of which an ulp is 4 u; feet, whose difference is projected")],
        tried a.dual_angle(b), a.dual_angle_checked(b);
    "Line::distance_to_line"(a: line, b: line) -> number, |v| dual_angle(v)[1..].to_vec(), [
        on(&["close"], 1.5, "of the scale, which is over the sine"),
        within(8.0, "two lines made unit, two feet, what is across their difference, its length")],
        tried a.distance_to_line(b), a.distance_to_line_checked(b);
    "Line::common_perpendicular"(a: line, b: line) -> perpendicular, perpendicular, [
        on(&["close"], 2.1, "of the scale, which is over the sine, or its square"),
        within(7.0, "an angle up to π; feet and moments, each with the roundings of two unit lines and of the way between")],
        tried a.common_perpendicular(b), a.common_perpendicular_checked(b);
    "Line::intersection"(a: line, b: line, tolerance: number) -> point, |v| perpendicular(v)[6..9].to_vec(), [
        on(&["close"], 1.0, "of the scale, which is over the square of the sine"),
        within(3.5, "the middle of the feet")],
        tried a.intersection(b, tolerance), a.intersection_checked(b, tolerance);
}
