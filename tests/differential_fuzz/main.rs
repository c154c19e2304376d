//! Random calls of every operation of the contract, on every implementation, against the scalar
//! path in `f64`, with input of every kind: far, tiny, nearly opposite, of many turns, of any bits.
//! Lanes of one kind of instructions are held to each other's bits, whatever their width and
//! whatever lies in the other lanes: also in the tables of geometry, and in the jobs of skeletons,
//! clips and skins, which are run for many at once, split, one by one, and in blocks.
//!
//! `DQ8_FUZZ_SECONDS` says how long (a fifth of one by default), `DQ8_FUZZ_SEED` from where; what
//! is found names the seed of its round. One lane of one operation is one call.

mod draw;
mod families;
mod geometry;
mod judge;
mod kernels;
mod limbs;
mod skeletons;
mod zeros;

use dq8_contract::case::Case;
use dq8_contract::fuzz;
use dq8_contract::implementation::{On, implementations, scalar_f64};
use dq8_contract::lanes::MAX_LANES;
use dq8_contract::operation::Operation;
use dq8_contract::operations::OPERATIONS;
use dq8_contract::random;
use draw::Draw;
use families::Families;
use judge::{Lane, Question, judge};
use std::collections::BTreeMap;

/// What was found: the worst of each operation and kind of case.
#[derive(Default)]
struct Findings {
    calls: u64,
    worst: BTreeMap<String, (f64, String)>,
}

impl Findings {
    fn add(&mut self, what: String, error: f64, place: impl FnOnce() -> String) {
        let known = self.worst.get(&what);
        if known.is_none_or(|(worst, _)| error > *worst) {
            self.worst.insert(what, (error, place()));
        }
    }
}

/// The question of each case, with what the scalar path answers in `f64`.
fn questions(operation: &Operation, cases: &[(Draw, Case)], on: On) -> Vec<Question> {
    let asked = cases.iter().map(|&(draw, case)| {
        let case = case.rounded(on);
        let given = operation.given(on, &case);
        let truth = operation.answer(scalar_f64(), &[case]).lane(0);
        let masks_about = if truth.1.is_empty() {
            [Vec::new(), Vec::new()]
        } else {
            let size = 1.0 + judge::size(&case);
            let off = 64.0 * on.roundoff() * size;
            [-off, off].map(|off| {
                let near = Case { tolerance: case.tolerance + off, ..case };
                operation.answer(scalar_f64(), &[near]).lane(0).1
            })
        };
        let finite = given.iter().flatten().all(|number| number.is_finite());
        Question { draw, case, finite, truth, masks_about }
    });
    asked.collect()
}

/// As many answers as there are questions.
fn answers(operation: &Operation, on: On, questions: &[Question]) -> Vec<Lane> {
    let given: Vec<_> =
        questions.iter().map(|question| operation.given(on, &question.case)).collect();
    let chunks = given.chunks(on.lanes).flat_map(|chunk| {
        let lanes: Vec<_> = chunk.iter().collect();
        let answer = operation.answer_given(on, &lanes);
        (0..chunk.len()).map(move |lane| answer.lane(lane)).collect::<Vec<_>>()
    });
    chunks.collect()
}

/// The bits of what a lane answers, with its truth values.
fn bits((numbers, held): &Lane) -> Vec<u64> {
    let numbers = numbers.iter().map(|&(_, number)| random::bits(number));
    numbers.chain(held.iter().map(|&held| held.into())).collect()
}

fn round(single: bool, seed: u64, findings: &mut Findings) {
    let mut random = fuzz::random(seed);
    // Of all kinds side by side.
    let cases: Vec<_> = Draw::ALL
        .into_iter()
        .cycle()
        .take(MAX_LANES)
        .map(|draw| (draw, draw.case(&mut random, single)))
        .collect();
    let all: Vec<_> = implementations().into_iter().filter(|on| on.single == single).collect();
    for operation in OPERATIONS {
        let questions = questions(operation, &cases, all[0]);
        let mut families = Families::default();
        for &on in &all {
            let answers = answers(operation, on, &questions);
            findings.calls += answers.len() as u64;
            for (question, got) in questions.iter().zip(&answers) {
                if let Some((error, what)) = judge(operation, on, question, got) {
                    let what =
                        format!("{} of {:?}, {}: {what}", operation.name, question.draw, on.name);
                    findings.add(what, error, || {
                        let numbers =
                            |lane: &Lane| lane.0.iter().map(|n| n.1).collect::<Vec<f64>>();
                        format!(
                            "seed {seed}: {:?} {:?}, f64 {:?} {:?}, given {:?}",
                            numbers(got),
                            got.1,
                            numbers(&question.truth),
                            question.truth.1,
                            operation.given(on, &question.case)
                        )
                    });
                }
            }
            if let Some((first, lane)) = families.add(on, answers.iter().map(bits).collect()) {
                let what =
                    format!("{}, {} and {}: other bits", operation.name, on.name, first.name);
                findings.add(what, 1.0, || {
                    let given = operation.given(on, &questions[lane].case);
                    format!("seed {seed}: {:?}, given {given:?}", answers[lane])
                });
            }
        }
    }
    geometry::round(&all, &mut random, seed, findings);
    if single {
        kernels::round::<f32, 16>(&mut random, seed, findings);
    } else {
        kernels::round::<f64, 2>(&mut random, seed, findings);
    }
}

fn fuzz_all(single: bool) {
    let (mut findings, name) = (Findings::default(), if single { "f32" } else { "f64" });
    fuzz::rounds(|seed| {
        let before = findings.calls;
        round(single, seed, &mut findings);
        findings.calls - before
    });
    let found: Vec<_> = findings
        .worst
        .iter()
        .map(|(what, (error, place))| format!("{what}: {error:.2}, {place}\n"))
        .collect();
    assert!(found.is_empty(), "{name}:\n{}", found.concat());
}

#[test]
fn every_implementation_in_f32_answers_as_the_scalar_path_in_f64() {
    fuzz_all(true);
}

#[test]
fn every_implementation_in_f64_answers_as_the_scalar_path_does() {
    fuzz_all(false);
}
