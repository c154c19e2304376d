//! What the errors of answers are measured against: a scale for each number of an answer, from the
//! inputs of the vector, so that a bound says how much worse than its own roundings a method is.

pub(super) mod duals;
pub(super) mod lines;
pub(super) mod maps;
pub(super) mod matrices;
pub(super) mod quaternions;
pub(super) mod rotations;
pub(super) mod screws;

use crate::case::length;
use crate::vector::{cross, unit};
use crate::vectors::Vector;

/// The same scale for several numbers.
pub(super) fn each(numbers: usize, scale: f64) -> Vec<f64> {
    vec![scale; numbers]
}

fn three(numbers: &[f64]) -> [f64; 3] {
    [numbers[0], numbers[1], numbers[2]]
}

/// The sine of the angle between two vectors.
fn sine(a: [f64; 3], b: [f64; 3]) -> f64 {
    length(&cross(unit(a), unit(b)))
}

impl Vector {
    /// |l| and |m| of a line, |n| and |d| of a plane, |q| and |t| of a pose.
    fn halves(&self, name: &str, at: usize) -> (f64, f64) {
        let (first, second) = self.input(name).split_at(at);
        (length(first), length(second))
    }

    pub(super) fn line(&self, name: &str) -> (f64, f64) {
        self.halves(name, 3)
    }
}
