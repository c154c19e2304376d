//! Random inputs: vectors of a length, some with components that are equal, tiny or zero.

use crate::operations::Operation;
use dq8_fixtures::random::Random;

/// Each argument a vector of about the length in `lengths`, in order of the groups.
pub fn draw(operation: &Operation, lengths: &[f64], random: &mut Random) -> Vec<f64> {
    let mut numbers = vec![];
    for (&(_, count), length) in operation.inputs.iter().zip(lengths.iter().cycle()) {
        let kind = random.bits() % 6;
        if count == 1 {
            numbers.push(random.signed() * length);
            continue;
        }
        let vector: Vec<f64> = (0..count)
            .map(|_| match kind {
                0 => 1.0 + random.signed() * 1e-3,
                1 => random.signed().powi(5),
                2 if random.bits().is_multiple_of(2) => 0.0,
                _ => (0..4).map(|_| random.signed()).sum(),
            })
            .collect();
        let norm = vector.iter().map(|c| c * c).sum::<f64>().sqrt();
        let sign = if random.bits().is_multiple_of(2) { 1.0 } else { -1.0 };
        numbers.extend(vector.iter().enumerate().map(|(i, c)| {
            if norm == 0.0 { if i == 0 { *length } else { 0.0 } } else { sign * c * length / norm }
        }));
    }
    numbers
}

/// Numbers without zeros or equals, all motions unit, scalar parts positive: the ordinary path.
#[must_use]
pub fn ordinary(operation: &Operation) -> Vec<f64> {
    let four = [0.1, -0.3, 0.5, 0.806_225_774_829_854_9];
    let numbers = operation.groups().into_iter().scan((usize::MAX, 0), |(last, at), group| {
        *at = if *last == group { *at + 1 } else { 0 };
        *last = group;
        let factor = 1.0 + 0.01 * (group / 2) as f64;
        let single = |number: f64| f64::from(number as f32);
        Some(match operation.inputs[group].1 {
            1 => single(0.6 * factor),
            // A cosine and a sine, which are unit to the last digit: else mechanisms normalize
            // them.
            2 => [0.6, 0.8][*at],
            _ => single(four[*at % 4] * factor),
        })
    });
    numbers.collect()
}
