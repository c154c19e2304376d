//! For dual numbers.

use crate::vectors::Vector;

pub(crate) fn relative(vector: &Vector) -> Vec<f64> {
    vector.out.iter().map(|number| number.abs()).collect()
}

fn two(vector: &Vector) -> [f64; 4] {
    let (a, b) = (vector.input("a"), vector.input("b"));
    [a[0], a[1], b[0], b[1]].map(f64::abs)
}

pub(crate) fn product(vector: &Vector) -> Vec<f64> {
    let [a, da, b, db] = two(vector);
    vec![a * b, a * db + da * b]
}

pub(crate) fn quotient(vector: &Vector) -> Vec<f64> {
    let [a, da, b, db] = two(vector);
    vec![a / b, da / b + a * db / (b * b)]
}

pub(crate) fn atan2(vector: &Vector) -> Vec<f64> {
    let [y, dy, x, dx] = two(vector);
    vec![vector.out[0].abs(), (x * dy + y * dx) / (x * x + y * y)]
}
