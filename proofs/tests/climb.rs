//! Errors of `f32` from the exact value (the same tape in `f64`), on random inputs and climbing from the worst: each below its
//! bound, and bounds not much larger than what is found.

use dq8_fixtures::random::Random;
use dq8_proofs::composed::FAR;
use dq8_proofs::range::{Range, range};
use dq8_proofs::record::Record;
use dq8_proofs::sample::draw;
use dq8_proofs::table::{Part, bounds};
use dq8_proofs::tape::Node;

/// How many times the worst error found a bound may be, of what has been found after this many inputs.
const INPUTS: usize = 20_000;
/// The same of what is in [`LOOSE`].
const MANY: usize = 400_000;
const LOOSE: &[(&str, f64)] = &[
    ("mul", 1.0),
    ("quat_mul", 1.0),
    ("local_to_model", 1.0),
    ("local_to_model_lanes", 1.0),
    ("local_to_model_blocks", 1.0),
    ("bones", 1.0),
    ("bones_lanes", 1.0),
    ("bones_blocks", 1.0),
    ("poses_placed", 1.0),
    ("poses_slide", 1.0),
    ("translation", 1.0),
    ("from_rotation_translation", 1.0),
    ("from_translation_rotation", 1.0),
    ("transform_vector", 1.0),
    ("transform_point", 1.0),
    ("normalize", 1.0),
];

/// The largest error over its bound, and for which inputs.
struct Search {
    record: &'static Record,
    /// The weighted sum that is normalized.
    sum: Vec<Node>,
    /// Where nothing overflows, and what underflow adds; 0 where that is not known.
    range: Range,
    /// Of each output.
    parts: Vec<Part>,
    single: Vec<f32>,
    double: Vec<f64>,
}

impl Search {
    fn of(record: &'static Record) -> Self {
        let known = bounds(record);
        let of = |name| known.iter().find(|part| part.name == name).expect("a part each").clone();
        let parts = record.operation.names().map(of).collect();
        let sum =
            record.last(0).map_or(vec![], |(last, sum)| sum[..last.operation.inputs[0].1].to_vec());
        let range = range(record).unwrap_or(Range { powers: [0; 2], underflow: None });
        Self { record, sum, range, parts, single: vec![], double: vec![] }
    }

    fn ratio(&mut self, inputs: &[f32]) -> Option<(f64, &'static str)> {
        let (operation, tape) = (self.record.operation, &self.record.tapes[0]);
        if !tape.run(inputs, self.record.fused, &mut self.single) {
            return None;
        }
        let exact: Vec<f64> = inputs.iter().map(|&c| c.into()).collect();
        tape.run(&exact, false, &mut self.double);
        let mut lengths = vec![0.0; operation.inputs.len()];
        for (group, c) in operation.groups().into_iter().zip(&exact) {
            lengths[group] += c * c;
        }
        if !self.sum.is_empty() {
            let sum = self.sum.iter().map(|&node| self.double[node as usize]);
            lengths.push(sum.map(|c| c * c).sum());
        }
        let lengths: Vec<f64> = lengths.into_iter().map(f64::sqrt).collect();
        if self.parts[0].bound.as_ref().is_some_and(|bound| bound.at(&lengths) > FAR) {
            return None;
        }
        let ratios = tape.outputs.iter().zip(&self.parts).filter_map(|(&output, part)| {
            let below = self.range.underflow.as_ref().map_or(0.0, |below| below.at(&lengths));
            let bound =
                part.bound.as_ref()?.at(&lengths) * 2_f64.powi(-24) + below * 2_f64.powi(-150);
            let error =
                (f64::from(self.single[output as usize]) - self.double[output as usize]).abs();
            assert!(error.is_finite(), "{} overflows for {inputs:?}", operation.name);
            // 0 where nothing is rounded.
            Some((if error == 0.0 { 0.0 } else { error / bound }, part.name))
        });
        ratios.max_by(|a, b| a.0.total_cmp(&b.0))
    }

    fn worst(&mut self) -> f64 {
        let mut random = Random(1);
        let (mut worst, mut at) = (0.0, vec![]);
        let is_hard = LOOSE.iter().any(|(name, _)| *name == self.record.operation.name);
        let count = if is_hard { MANY } else { INPUTS };
        for i in 0..count {
            let inputs: Vec<f32> = if i < INPUTS / 4 || at.is_empty() {
                // As long as may be, or so short that products are below the normal numbers.
                let length = match (i % 8, &self.range.underflow) {
                    (6, Some(_)) => 0.99 * 2_f64.powi(self.range.powers[0]),
                    (7, Some(_)) => 1e-21,
                    _ => 1.0,
                };
                let numbers = draw(self.record.operation, &[length], &mut random);
                numbers.into_iter().map(|c| c as f32).collect()
            } else {
                // Some numbers by few units in the last place, or by many.
                let mut near: Vec<f32> = at.clone();
                for _ in 0..=random.bits() % 4 {
                    let index = random.bits() as usize % near.len();
                    let steps = ((random.bits() % 2001) as i32 - 1000) << (random.bits() % 14);
                    near[index] = f32::from_bits(near[index].to_bits().wrapping_add_signed(steps));
                }
                near
            };
            if inputs.iter().any(|c| !c.is_normal() && *c != 0.0) {
                continue;
            }
            let Some((ratio, part)) = self.ratio(&inputs) else { continue };
            assert!(
                ratio <= 1.0,
                "{} {part}: {ratio} of its bound for {inputs:?}",
                self.record.name()
            );
            if ratio > worst {
                (worst, at) = (ratio, inputs);
            }
        }
        worst
    }
}

#[test]
fn errors_stay_below_the_bounds_and_come_near() {
    for record in Record::by_lengths() {
        let (name, worst) = (record.name(), Search::of(record).worst());
        println!("{name}: bound / found {:.2}", 1.0 / worst);
        if let Some((_, loose)) = LOOSE.iter().find(|(name, _)| *name == record.operation.name) {
            assert!(worst * loose >= 1.0, "{name}: {worst} of its bound is the most found");
        }
    }
}
