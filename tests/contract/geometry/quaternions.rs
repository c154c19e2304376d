//! Quaternions by themselves.

use dq8::{DualQuat, Quat, batch};

geometry! { quaternions:
    "Quat::mul"(a: quat, b: quat) -> quat, product, [
        within(1.7, "sums of 4 products")],
        plain a * b;
    "Quat::dot"(a: quat, b: quat) -> number, |v| product(v)[..1].to_vec(), [
        within(2.1, "a sum of 4 products")],
        plain a.dot(b);
    "Quat::norm"(a: quat) -> number, |v| each(1, v.norm("a")), [
        within(2.4, "a sum of squares, half of whose error the root takes away")],
        plain a.norm();
    "Quat::normalize"(a: quat) -> quat, |_| each(4, 1.0), [
        within(1.6, "a length and a quotient")],
        plain a.normalize();
    "Quat::try_normalize"(a: quat) -> quat, |_| each(4, 1.0), [
        within(1.5, "as normalize")],
        tried a.try_normalize(), a.normalize_checked();
    "Quat::inverse"(a: quat) -> quat, |v| each(4, 1.0 / v.norm("a")), [
        within(3.5, "a length, which divides twice")],
        plain a.inverse();
    "Quat::rotate"(a: unit_quat, p: point) -> point, |v| each(3, v.norm("p")), [
        on(&["near0"], 1.5, "hardly turns"),
        within(9.0, "normalized first; an error of q counts twice on each side of v")],
        plain a.rotate(p);
    "Quat::angle_to"(a: unit_quat, b: unit_quat) -> number, |v| each(1, turns(v)), [
        on(&["close"], 1.0, "of the turns that it is between"),
        on(&["nearpi"], 15.6, "up to π, of which an ulp is 4 u; both normalized first"),
        within(7.0, "both normalized first; an arctangent, doubled")],
        plain a.angle_to(b);
    "Quat::slerp"(a: unit_quat, b: unit_quat, t: number) -> quat, |v| of_turn(turns(v)), [
        within(3.7, "an angle, two sines of parts of it, and their quotients")],
        plain a.slerp(b, t);
    "Quat::nlerp"(a: unit_quat, b: unit_quat, t: number) -> quat, |v| of_turn(turns(v)), [
        within(3.0, "a sum of two products, normalized")],
        plain a.nlerp(b, t);
    "Quat::from_axis_angle"(l: point, angle: number) -> quat, |v| of_turn(v.norm("angle")), [
        within(2.2, "a half angle, its sine and its cosine; the axis is rounded on the way in")],
        plain Quat::from_axis_angle(l, angle), batch::Quat::from_axis_angle(l, angle);
    "Quat::from_rotation_x"(angle: number) -> quat, |v| of_turn(v.norm("angle")), [
        within(1.7, "a half angle, its sine and its cosine")],
        plain Quat::from_rotation_x(angle), batch::Quat::from_rotation_x(angle);
    "Quat::from_rotation_y"(angle: number) -> quat, |v| of_turn(v.norm("angle")), [
        within(1.5, "a half angle, its sine and its cosine")],
        plain Quat::from_rotation_y(angle), batch::Quat::from_rotation_y(angle);
    "Quat::from_rotation_z"(angle: number) -> quat, |v| of_turn(v.norm("angle")), [
        within(1.5, "a half angle, its sine and its cosine")],
        plain Quat::from_rotation_z(angle), batch::Quat::from_rotation_z(angle);
    "Quat::to_axis_angle"(a: unit_quat) -> axis_angle, |v| [each(3, 1.0), each(1, turn(v, "a"))].concat(), [
        on(&["nearpi"], 14.5, "an angle up to π, of which an ulp is 4 u"),
        within(8.6, "normalized first; an arctangent, doubled")],
        plain a.to_axis_angle();
    "Quat::to_scaled_axis"(a: unit_quat) -> point, |v| each(3, turn(v, "a")), [
        on(&["near0"], 3.2, "the angle is twice the sine"),
        on(&["nearpi"], 15.9, "an angle up to π, of which an ulp is 4 u, and a product"),
        within(10.0, "an angle, a reciprocal length and two products")],
        plain a.to_scaled_axis();
    "Quat::from_scaled_axis"(p: point) -> quat, from_scaled_axis, [
        within(1.5, "a length, a sine and a cosine of it, a quotient")],
        plain Quat::from_scaled_axis(p), batch::Quat::from_scaled_axis(p);
    "Quat::from_rotation_arc"(p: point, q: point) -> quat, |v| each(4, 1.0 / v.out[0]), [
        on(&["nearpi"], 0.2, "of the scale, which is over the cosine of half the angle"),
        within(3.0, "two directions, their sum and difference, a cross product, normalized")],
        plain Quat::from_rotation_arc(p, q), batch::Quat::from_rotation_arc(p, q);
    "Quat::look_to"(p: point, q: point) -> quat, look_to, [
        on(&["close"], 0.5, "of the scale, which is over the sine"),
        within(3.0, "as gram_schmidt and from_matrix3")],
        alone Quat::look_to(p, q);
    "DualQuat::look_at"(p: point, q: point, r: point) -> motion, look_at, [
        on(&["close"], 0.4, "of the scale, which is over the sine"),
        within(2.8, "as look_to, and a product with the eye, halved")],
        alone DualQuat::look_at(p, q, r);
    "Quat::from_matrix3"(rows: matrix3) -> quat, |_| each(4, 1.0), [
        within(3.0, "rounded on the way in; divided by its largest sum and normalized")],
        plain Quat::from_matrix3(rows), batch::Quat::from_matrix3(rows);
    "Quat::to_matrix3"(a: unit_quat) -> rows, |_| each(9, 1.0), [
        on(&["near0"], 1.5, "ones and twice a component"),
        within(14.0, "normalized first; squares and sums of products, doubled")],
        plain a.to_matrix3();
}
