//! Errors of `f32` from the exact value (the same tape in `f64`), on random inputs and climbing
//! from the worst: each below its bound, and bounds not much larger than what is found.

use dq8_fixtures::random::Random;
use dq8_proofs::composed::FAR;
use dq8_proofs::range::{Range, range};
use dq8_proofs::record::Record;
use dq8_proofs::sample::draw;
use dq8_proofs::table::{Part, bounds};
use dq8_proofs::tape::Node;

/// How many times the worst error found a bound may be, of what has been found after this many
/// inputs.
const INPUTS: usize = 20_000;
/// The same of what is in [`LOOSE`].
const MANY: usize = 400_000;
const LOOSE: &[(&str, f64)] = &[
    ("mul", 1.2),
    ("quat_mul", 1.2),
    ("local_to_model", 1.2),
    ("local_to_model_lanes", 1.2),
    ("local_to_model_blocks", 1.2),
    ("bones", 1.5),
    ("bones_lanes", 1.5),
    ("bones_blocks", 1.5),
    ("poses_placed", 2.2),
    ("poses_slide", 2.0),
    ("translation", 1.5),
    ("from_rotation_translation", 1.1),
    ("from_translation_rotation", 1.1),
    ("transform_vector", 2.6),
    ("transform_point", 2.5),
    ("normalize", 2.1),
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

    fn ratio(&mut self, inputs: &[f32]) -> Option<(f64, &'static str, bool)> {
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
        // Climbing can pass the end of the range.
        let longest = 2_f64.powi(self.range.powers[0]);
        if longest > 1.0 && lengths.iter().any(|&length| length > longest) {
            return None;
        }
        if self.parts[0].bound.as_ref().is_some_and(|bound| bound.at(&lengths) > FAR) {
            return None;
        }
        let ratios = tape.outputs.iter().zip(&self.parts).filter_map(|(&output, part)| {
            let below = self.range.underflow.as_ref().map_or(0.0, |below| below.at(&lengths));
            let normal = part.bound.as_ref()?.at(&lengths) * 2_f64.powi(-24);
            let below = below * 2_f64.powi(-150);
            let bound = normal + below;
            let error =
                (f64::from(self.single[output as usize]) - self.double[output as usize]).abs();
            assert!(error.is_finite(), "{} overflows for {inputs:?}", operation.name);
            // 0 where nothing is rounded.
            Some((if error == 0.0 { 0.0 } else { error / bound }, part.name, below > 1e-6 * normal))
        });
        ratios.max_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// The most that is found in `count` inputs, of those whose products are below the normal
    /// numbers or of the others.
    fn worst(&mut self, is_below: bool, count: usize) -> f64 {
        let mut random = Random(1);
        let (mut worst, mut at) = (0.0, vec![]);
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
            let Some((ratio, part, below)) = self.ratio(&inputs) else { continue };
            assert!(
                ratio <= 1.0,
                "{} {part}: {ratio} of its bound for {inputs:?}",
                self.record.name()
            );
            if ratio > worst && below == is_below {
                (worst, at) = (ratio, inputs);
            }
        }
        worst
    }
}

#[test]
fn errors_stay_below_the_bounds_and_come_near() {
    for record in Record::by_lengths() {
        let is_hard = LOOSE.iter().any(|(name, _)| *name == record.operation.name);
        let (name, mut search) = (record.name(), Search::of(record));
        search.worst(true, INPUTS);
        let worst = search.worst(false, if is_hard { MANY } else { INPUTS });
        println!("{name}: bound / found {:.2}", 1.0 / worst);
        if let Some((_, loose)) = LOOSE.iter().find(|(name, _)| *name == record.operation.name) {
            assert!(worst * loose >= 1.0, "{name}: {worst} of its bound is the most found");
        }
    }
}

/// Found by an audit: what a crowd in blocks computes is no step of a plain skeleton, whose bound
/// it passes.
#[test]
fn a_step_in_blocks_keeps_its_own_bound_where_it_passes_that_of_plain_ones() {
    let inputs = [
        -0.91328526,
        0.1017865,
        0.21562095,
        0.25503656,
        -0.015472193,
        0.0070771677,
        -0.0017650796,
        0.008071553,
        0.6288371,
        -0.12410182,
        0.70922107,
        -0.068474926,
        0.2737981,
        -0.01004732,
        -0.009673273,
        0.0045161573_f32,
    ];
    let of = |name: &str| {
        let record = Record::by_lengths().find(|record| record.name() == name).expect("a record");
        Search::of(record)
    };
    let (mut blocks, plain) = (of("job.local_to_model_blocks"), of("job.local_to_model"));
    let ratio = blocks.ratio(&inputs).expect("the ordinary path").0;
    assert!(ratio < 1.0, "{ratio}");
    blocks.parts = plain.parts;
    let ratio = blocks.ratio(&inputs).expect("the ordinary path").0;
    assert!(ratio > 1.39, "{ratio}");
}
