//! A tape is the code: it computes, to the last bit, what the compiled functions do; unfused as
//! single floats, one lane and portable lanes, fused as AVX2.

use dq8::{Backend, Kernel, Level, Real};
use dq8_fixtures::random::Random;
use dq8_proofs::operations::{Form, Number, functions, lanes};
use dq8_proofs::record::Record;
use dq8_proofs::sample::draw;
use dq8_proofs::tape::{Computed, Tape};
use dq8_simd::{Float, Lanes};

/// Inputs per operation, form and precision: a sample, or as many as `run.sh` asks for.
fn count() -> usize {
    std::env::var("DQ8_PROOFS_INPUTS").map_or(10_000, |count| count.parse().expect("a number"))
}

/// Operations on lanes with the instructions of a level, many inputs at once.
struct OnLanes<'a, F>(&'a Record, &'a [Vec<F>]);

impl<F: Float> Kernel for OnLanes<'_, F> {
    type Output = Vec<Vec<F>>;
    const WIDE: bool = false;
    #[inline(always)]
    fn run<V: Level>(self, level: V) -> Vec<Vec<F>> {
        let Self(Record { operation, form, .. }, inputs) = self;
        let answers = inputs.chunks(<F::Lanes<V>>::LANES).flat_map(|inputs| {
            let arguments = (0..inputs[0].len()).map(|i| {
                let row: Vec<F> = inputs.iter().map(|input| input[i]).collect();
                Lanes::load_partial(level, &row, row[0])
            });
            let arguments: Vec<F::Lanes<V>> = arguments.collect();
            let run = if *form == Form::Function { functions::run } else { lanes::run };
            let rows = run(operation.name, Backend::PORTABLE, &arguments);
            let rows: Vec<_> = rows.into_iter().map(Lanes::to_array).collect();
            let lane = move |lane: usize| rows.iter().map(|row| row.as_ref()[lane]).collect();
            (0..inputs.len()).map(lane)
        });
        answers.collect()
    }
}

/// What the compiled code computes.
fn code<F: Number + Lanes>(record: &Record, inputs: &[Vec<F>]) -> Vec<Vec<F>> {
    let avx2 = Backend::avx2().expect("this test compares with AVX2: run it on a CPU that has it");
    let on_lanes = matches!(record.form, Form::Lanes | Form::Function);
    if record.fused && on_lanes {
        return avx2.run(OnLanes(record, inputs));
    }
    let (run, backend) = (record.form.run(), if record.fused { avx2 } else { Backend::PORTABLE });
    let answers: Vec<_> =
        inputs.iter().map(|input| run(record.operation.name, backend, input)).collect();
    // What nothing is fused in has no record of its own on AVX2.
    if on_lanes && !record.tapes.iter().any(Tape::fuses) {
        assert!(avx2.run(OnLanes(record, inputs)) == answers, "{} on AVX2", record.name());
    }
    answers
}

fn check<F: Number + Lanes + Computed>(record: &Record) {
    let (name, tape) = (record.name(), &record.tapes[usize::from(!F::SINGLE)]);
    let mut random = Random(1);
    let mut draw = || draw(record.operation, &[1.0, 3.0], &mut random);
    let inputs = (0..count()).map(|_| draw().into_iter().map(<F as Real>::from_f64).collect());
    let inputs: Vec<Vec<F>> = inputs.collect();
    let (mut numbers, mut on_path) = (vec![], 0);
    for (input, answer) in inputs.iter().zip(code(record, &inputs)) {
        if !tape.run(input, record.fused, &mut numbers) {
            continue;
        }
        on_path += 1;
        let outputs = tape.outputs.iter();
        let recorded: Vec<F> = outputs.map(|&output| numbers[output as usize]).collect();
        assert!(recorded == answer, "{name} of {input:?}: tape {recorded:?}, code {answer:?}");
    }
    // The book's norm has a path for each order of four components, and blends one for each sign of
    // a motion or weight.
    let part = match record.operation.name {
        "norm" | "nlerp" | "dlb" | "dlb_running" | "linear_skin" | "linear_normal" => 40,
        // And each sign of three products of motions.
        "dual_skin" | "dual_normal" => 500,
        _ => 3,
    };
    assert!(on_path > count() / part, "{name}: only {on_path} inputs on the recorded path");
}

#[test]
fn singles() {
    Record::all().iter().for_each(check::<f32>);
}

#[test]
fn doubles() {
    Record::all().iter().for_each(check::<f64>);
}
