//! For rotations.

use super::each;
use crate::vectors::Vector;

/// The vector part of small turns is relative to them.
pub(crate) fn euler_to_quat(vector: &Vector) -> Vec<f64> {
    let turn = crate::case::length(vector.input("angles")).min(1.0);
    [each(1, 1.0), each(3, turn)].concat()
}

/// The outer angles are as well known as the rotation, over the sine between their axes.
pub(crate) fn to_euler(vector: &Vector) -> Vec<f64> {
    let order = dq8::representation::EulerOrder::ALL[vector.input("order")[0] as usize];
    let (middle, locked) = (vector.out[1], vector.out[3] == 1.0);
    let between = if order.axes.is_proper() { middle.sin() } else { middle.cos() };
    let outer = if locked { 1.0 } else { 1.0 / between.abs() };
    vec![outer, 1.0, outer, 1.0]
}
