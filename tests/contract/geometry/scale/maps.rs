//! For maps of points.

use super::each;
use super::matrices::sizes;
use crate::case::length;
use crate::vectors::Vector;

/// Linear parts and translations of rows of four.
fn split(rows: &[f64]) -> ([f64; 9], [f64; 3]) {
    let linear = std::array::from_fn(|i| rows[4 * (i / 3) + i % 3]);
    (linear, std::array::from_fn(|row| rows[4 * row + 3]))
}

pub(crate) fn of_motion(vector: &Vector) -> Vec<f64> {
    let (p, q) = vector.halves("a", 4);
    [each(9, 1.0), each(3, 2.0 * q / p)].concat()
}

pub(crate) fn shear(vector: &Vector) -> Vec<f64> {
    [each(9, 1.0 + vector.norm("s") * vector.norm("n")), each(3, 1.0)].concat()
}

pub(crate) fn reflection(vector: &Vector) -> Vec<f64> {
    let (normal, offset) = vector.line("a");
    [each(9, 1.0 + 2.0 * normal * normal), each(3, 2.0 * normal * offset)].concat()
}

pub(crate) fn map_of_vector(vector: &Vector) -> Vec<f64> {
    each(3, length(&split(vector.input("a")).0) * vector.norm("p"))
}

pub(crate) fn map_of_point(vector: &Vector) -> Vec<f64> {
    let translation = length(&split(vector.input("a")).1);
    map_of_vector(vector).iter().map(|scale| scale + translation).collect()
}

pub(crate) fn product_of_maps(vector: &Vector) -> Vec<f64> {
    let [(a, s), (b, t)] = ["a", "b"].map(|map| {
        let (linear, translation) = split(vector.input(map));
        (length(&linear), length(&translation))
    });
    let row = [each(3, a * b), vec![a * t + s]].concat();
    row.repeat(3)
}

/// The rotation and the stretch as of the polar decomposition, and half of the translation.
pub(crate) fn decomposed(vector: &Vector) -> Vec<f64> {
    let (linear, translation) = split(vector.input("a"));
    let (size, moves) = sizes(&linear);
    [each(4, moves), each(4, moves * length(&translation)), each(9, moves * size)].concat()
}

pub(crate) fn product_of_poses(vector: &Vector) -> Vec<f64> {
    let [(_, s), (_, t)] = ["a", "b"].map(|pose| vector.halves(pose, 4));
    [each(4, 1.0), each(3, s + t)].concat()
}

pub(crate) fn inverse_pose(vector: &Vector) -> Vec<f64> {
    [each(4, 1.0), each(3, vector.halves("a", 4).1)].concat()
}

pub(crate) fn pose_of_point(vector: &Vector) -> Vec<f64> {
    each(3, vector.norm("p") + vector.halves("a", 4).1)
}
