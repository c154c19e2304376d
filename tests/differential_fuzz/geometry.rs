//! The tables of geometry: nothing panics on any numbers, and lanes of one family give the same
//! bits, for numbers of every size side by side.

use super::Findings;
use super::families::Families;
use dq8_contract::geometry::{self, Place};
use dq8_contract::implementation::On;
use dq8_contract::lanes::MAX_LANES;
use dq8_contract::random::{Random, bits};

pub(crate) fn round(all: &[On], random: &mut Random, seed: u64, findings: &mut Findings) {
    for (place, _) in geometry::operations() {
        let given = given(place, random, all[0]);
        let mut families = Families::default();
        for &on in all.iter().filter(|on| place.is_on(on)) {
            let answers: Vec<_> =
                given.chunks(on.lanes).flat_map(|lanes| place.answers_given(on, lanes)).collect();
            findings.calls += answers.len() as u64;
            if !on.name.starts_with("lanes") {
                continue;
            }
            let bits = |answer: &Vec<f64>| answer.iter().copied().map(bits).collect();
            if let Some((first, lane)) = families.add(on, answers.iter().map(bits).collect()) {
                let what = format!("{}, {} and {}: other bits", place.name(), on.name, first.name);
                findings.add(what, 1.0, || {
                    format!("seed {seed}: {:?}, given {:?}", answers[lane], given[lane])
                });
            }
        }
    }
}

/// Numbers of each lane; what is one number for all lanes is the same in all.
fn given(place: Place, random: &mut Random, on: On) -> Vec<Vec<f64>> {
    let of_all: Vec<_> = place.shapes().map(|_| random.below(6) as f64).collect();
    let lane = |lane: usize| {
        // A quarter of the lanes is ordinary, and all numbers of others may be anything.
        let share = [0.0, 0.1, 0.5, 1.0][lane % 4] * random.between(0.0, 1.0);
        let mut numbers = Vec::new();
        for (shape, &common) in place.shapes().zip(&of_all) {
            numbers.push(match shape {
                "order" | "integer" => common,
                _ => on.round(random.number(on.single, share)),
            });
        }
        numbers
    };
    (0..MAX_LANES).map(lane).collect()
}
