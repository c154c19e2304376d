//! A tape is the code: it computes, to the last bit, what the compiled functions do; unfused as single floats, one lane and
//! portable lanes, fused as AVX2.

use dq8::{Backend, Kernel, Level, Real, Scalar};
use dq8_proofs::operations::{Form, Operation, functions, jobs, lanes, single};
use dq8_proofs::sample::{Random, draw};
use dq8_proofs::tape::Computed;
use dq8_proofs::tape_of;
use dq8_simd::{Float, Lanes};

/// Inputs per operation, form and precision: a sample, or as many as `run.sh` asks for.
fn count() -> usize {
    std::env::var("DQ8_PROOFS_INPUTS").map_or(10_000, |count| count.parse().expect("a number"))
}

/// Operations on lanes with the instructions of a level, many inputs at once.
struct OnLanes<'a, F>(Form, &'a str, &'a [Vec<F>]);

impl<F: Float> Kernel for OnLanes<'_, F> {
    type Output = Vec<Vec<F>>;
    const WIDE: bool = false;
    #[inline(always)]
    fn run<V: Level>(self, level: V) -> Vec<Vec<F>> {
        let Self(form, name, inputs) = self;
        let mut answers = vec![];
        for inputs in inputs.chunks(<F::Lanes<V>>::LANES) {
            let arguments: Vec<F::Lanes<V>> = (0..inputs[0].len())
                .map(|i| {
                    let row: Vec<F> = inputs.iter().map(|input| input[i]).collect();
                    Lanes::load_partial(level, &row, row[0])
                })
                .collect();
            let answer = match form {
                Form::Function => functions::run(name, &arguments),
                _ => lanes::run(name, &arguments),
            };
            let rows: Vec<_> = answer.into_iter().map(Lanes::to_array).collect();
            answers.extend(
                (0..inputs.len())
                    .map(|lane| rows.iter().map(|row| row.as_ref()[lane]).collect::<Vec<F>>()),
            );
        }
        answers
    }
}

/// Compares the tape of each operation with what `code` computes.
fn check<F: Scalar + Computed>(
    form: Form,
    fused: bool,
    code: impl Fn(&Operation, &[Vec<F>]) -> Vec<Vec<F>>,
) {
    for operation in form.operations() {
        let tape = tape_of(operation, form, F::SINGLE);
        let inputs: Vec<Vec<F>> = inputs(operation)
            .into_iter()
            .map(|input| input.into_iter().map(<F as Real>::from_f64).collect())
            .collect();
        let (mut numbers, mut on_path) = (vec![], 0);
        for (input, answer) in inputs.iter().zip(code(operation, &inputs)) {
            if !tape.run(input, fused, &mut numbers) {
                continue;
            }
            on_path += 1;
            let recorded: Vec<F> =
                tape.outputs.iter().map(|&output| numbers[output as usize]).collect();
            assert!(
                recorded == answer,
                "{} of {input:?}: tape {recorded:?}, code {answer:?}",
                operation.name
            );
        }
        // The book's norm has a path for each order of four components, and blends one for each sign of a motion or weight.
        let expected = match operation.name {
            "norm" | "nlerp" | "dlb" | "dlb_running" | "linear_skin" | "linear_normal" => {
                count() / 40
            }
            // And each sign of three products of motions.
            "dual_skin" | "dual_normal" => count() / 500,
            _ => count() / 3,
        };
        assert!(
            on_path > expected,
            "{}: only {on_path} inputs on the recorded path",
            operation.name
        );
    }
}

fn inputs(operation: &Operation) -> Vec<Vec<f64>> {
    let mut random = Random::new(0x9e37_79b9_7f4a_7c15);
    (0..count()).map(|_| draw(operation, &[1.0, 3.0], &mut random)).collect()
}

fn avx2() -> Backend {
    Backend::avx2().expect("this test compares with AVX2: run it on a CPU that has it")
}

/// For both floats.
macro_rules! both { ($($name:ident: $form:expr, $fused:expr, |$operation:ident, $inputs:ident| $code:expr;)*) => {$(
    #[test]
    fn $name() {
        check::<f32>($form, $fused, |$operation, $inputs| $code);
        check::<f64>($form, $fused, |$operation, $inputs| $code);
    }
)*} }
both! {
    single_floats: Form::Single, false, |operation, inputs|
        inputs.iter().map(|input| single::run(operation.name, input)).collect();
    one_lane: Form::Lanes, false, |operation, inputs|
        inputs.iter().map(|input| lanes::run(operation.name, input)).collect();
    fused_lanes: Form::Lanes, true, |operation, inputs| avx2().run(OnLanes(Form::Lanes, operation.name, inputs));
    functions_of_one_lane: Form::Function, false, |operation, inputs|
        inputs.iter().map(|input| functions::run(operation.name, input)).collect();
    fused_functions: Form::Function, true,
        |operation, inputs| avx2().run(OnLanes(Form::Function, operation.name, inputs));
    unfused_job: Form::Job, false, |operation, inputs|
        inputs.iter().map(|input| jobs::run(operation.name, Backend::PORTABLE, input)).collect();
    fused_job: Form::Job, true, |operation, inputs| inputs.iter().map(|input| jobs::run(operation.name, avx2(), input)).collect();
}
