//! Dual vectors, screws, twists and wrenches, and the limb of two bones.

use dq8::ik::TwoBone;

geometry! { screws:
    "DualVector::cross"(a: dual_vector, b: dual_vector) -> dual_vector, cross, [
        within(1.9, "sums of 2 and 4 products")],
        plain a.cross(b);
    "DualVector::dot"(a: dual_vector, b: dual_vector) -> point, dot, [
        within(0.8, "sums of 3 and 6 products")],
        plain a.dot(b);
    "DualVector::scale_dual"(a: dual_vector, s: two) -> dual_vector, scale_dual, [
        within(1.1, "a product, and a sum of two")],
        plain a.scale_dual(s);
    "Screw::pitch"(a: screw) -> number, |v| each(1, v.out[0].abs()), [
        within(0.75, "one quotient")],
        plain a.pitch();
    "Twist::velocity_at"(a: twist, p: point) -> point, velocity_at, [
        within(1.4, "a sum of 3 terms")],
        plain a.velocity_at(p);
    "Wrench::dot"(a: wrench, b: twist) -> number, power, [
        within(1.1, "a sum of 6 products")],
        plain a.dot(b);
    "TwoBone::reach"(p: point, lengths: two, q: point, r: point) -> limb, reach, [
        on(&["bent"], 1.1, "of the scale, which is over the sine of the bend"),
        on(&["flat"], 13.5, "of that scale; the way to the target rounds, and is as long as both bones"),
        within(7.5, "two arctangents of roots, up to π; a frame of two directions, and products of two quaternions")],
        alone TwoBone::reach(p, lengths, q, r);
}
