//! For dual vectors, twists, wrenches and limbs.

use super::each;
use crate::vectors::Vector;

pub(crate) fn cross(vector: &Vector) -> Vec<f64> {
    let [real, dual] = [dot(vector)[0], dot(vector)[1]];
    [each(3, real), each(3, dual)].concat()
}

pub(crate) fn dot(vector: &Vector) -> Vec<f64> {
    let [(p, q), (r, s)] = ["a", "b"].map(|name| vector.line(name));
    vec![p * r, p * s + q * r]
}

pub(crate) fn scale_dual(vector: &Vector) -> Vec<f64> {
    let ((p, q), by) = (vector.line("a"), vector.input("s"));
    [each(3, p * by[0].abs()), each(3, q * by[0].abs() + p * by[1].abs())].concat()
}

pub(crate) fn velocity_at(vector: &Vector) -> Vec<f64> {
    let (angular, linear) = vector.line("a");
    each(3, angular * vector.norm("p") + linear)
}

pub(crate) fn power(vector: &Vector) -> Vec<f64> {
    each(1, dot(vector)[1])
}

/// The angle of a limb that is nearly straight or folded is the root of a difference of lengths, so
/// it is known as well as the way to the target over its sine.
pub(crate) fn reach(vector: &Vector) -> Vec<f64> {
    let (bones, bend, missed) = (vector.input("lengths"), vector.out[8], vector.out[9]);
    let within = missed == 0.0;
    let turn = if within { 1.0 / bend.sin().abs() } else { 1.0 };
    [each(9, turn), each(1, bones[0] + bones[1] + missed)].concat()
}
