//! For quaternions.

use super::{each, sine, three};
use crate::case::length;
use crate::vector::sub;
use crate::vectors::Vector;

pub(crate) fn product(vector: &Vector) -> Vec<f64> {
    each(4, vector.norm("a") * vector.norm("b"))
}

/// The sine of half the angle of a nearly unit quaternion, w first.
pub(crate) fn turn(vector: &Vector, name: &str) -> f64 {
    length(&vector.input(name)[1..])
}

/// What is between two turns is no more than both.
pub(crate) fn turns(vector: &Vector) -> f64 {
    turn(vector, "a") + turn(vector, "b")
}

/// The vector part of small turns is relative to them; beyond a radian a sine is known to the last
/// place of its angle.
pub(crate) fn of_turn(angle: f64) -> Vec<f64> {
    [each(1, 1.0), each(3, angle.min(1.0))].concat()
}

/// The length of the vector rounds, and with it the angle.
pub(crate) fn from_scaled_axis(vector: &Vector) -> Vec<f64> {
    let angle = vector.norm("p");
    [each(1, angle.max(1.0)), each(3, angle)].concat()
}

/// Where is up is known as well as the directions are, over the sine between them.
pub(crate) fn look_to(vector: &Vector) -> Vec<f64> {
    each(4, 1.0 / sine(three(vector.input("p")), three(vector.input("q"))))
}

pub(crate) fn look_at(vector: &Vector) -> Vec<f64> {
    let [eye, target, up] = ["p", "q", "r"].map(|name| three(vector.input(name)));
    let turn = 1.0 / sine(sub(target, eye), up);
    [each(4, turn), each(4, turn * length(&eye))].concat()
}
