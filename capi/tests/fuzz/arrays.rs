//! Functions over plain arrays.

use crate::random::Fuzz;
use dq8_capi::Status;
use dq8_capi::{chain, lines, metric, slices, twists};

/// One call, by pointers to its arrays, the output last.
type Call = fn([*mut f32; 4], f32, usize) -> Status;

/// What a function over `count` things reads and writes: numbers a thing, 0 for none; the output last.
pub(crate) struct Function {
    name: &'static str,
    inputs: [usize; 3],
    /// Whether the first input is one thing for all.
    one: bool,
    output: usize,
    call: Call,
}

macro_rules! functions {
    ($($in_module:ident::$name:ident [$($input:literal)*] one $one:literal -> $output:literal
        |$p:ident, $t:ident, $n:ident| ($($argument:expr),*);)*) => {
        vec![$(Function {
            name: stringify!($name),
            inputs: [$($input),*],
            one: $one,
            output: $output,
            call: |$p, $t, $n| {
                let _ = $t;
                // SAFETY: arrays are as long as the table says, or pointers wrong in ways that are seen.
                unsafe { $in_module::single::$name($($argument),*) }
            },
        }),*]
    };
}

pub(crate) fn functions() -> Vec<Function> {
    functions! {
        slices::mul [8 8 0] one false -> 8 |p, t, n| (p[0], p[1], p[3], n);
        slices::normalize [8 0 0] one false -> 8 |p, t, n| (p[0], p[3], n);
        slices::inverse [8 0 0] one false -> 8 |p, t, n| (p[0], p[3], n);
        slices::nlerp [8 8 0] one false -> 8 |p, t, n| (p[0], p[1], t, p[3], n);
        slices::sclerp [8 8 0] one false -> 8 |p, t, n| (p[0], p[1], t, p[3], n);
        slices::sclerp_each [8 8 1] one false -> 8 |p, t, n| (p[0], p[1], p[2], p[3], n);
        slices::points [8 3 0] one true -> 3 |p, t, n| (p[0], p[1], p[3], n);
        slices::vectors [8 3 0] one true -> 3 |p, t, n| (p[0], p[1], p[3], n);
        slices::points_each [8 3 0] one false -> 3 |p, t, n| (p[0], p[1], p[3], n);
        slices::matrices_3x4 [8 0 0] one false -> 12 |p, t, n| (p[0], 0, p[3], n);
        slices::matrices_4x4 [8 0 0] one false -> 16 |p, t, n| (p[0], 1, p[3], n);
        slices::conjugate [8 0 0] one false -> 8 |p, t, n| (p[0], p[3], n);
        lines::lines_each [8 6 0] one false -> 6 |p, t, n| (p[0], p[1], p[3], n);
        lines::planes_each [8 4 0] one false -> 4 |p, t, n| (p[0], p[1], p[3], n);
        twists::twists_each [8 6 0] one false -> 6 |p, t, n| (p[0], p[1], p[3], n);
        twists::integrate_body [8 6 0] one false -> 8 |p, t, n| (p[0], p[1], t, p[3], n);
        twists::log [8 0 0] one false -> 6 |p, t, n| (p[0], p[3], n);
        twists::exp [6 0 0] one false -> 8 |p, t, n| (p[0], p[3], n);
        twists::pow_each [8 1 0] one false -> 8 |p, t, n| (p[0], p[1], p[3], n);
        metric::angles [8 8 0] one false -> 1 |p, t, n| (p[0], p[1], p[3], n);
        metric::distances [8 8 0] one false -> 1 |p, t, n| (p[0], p[1], p[3], n);
        chain::chain_products [8 0 0] one false -> 8 |p, t, n| (p[0], p[3], n);
    }
}

/// A function over plain arrays.
pub(crate) fn arrays(fuzz: &mut Fuzz, functions: &[Function]) {
    let function = &functions[fuzz.below(functions.len())];
    let count = 1 + fuzz.below(40);
    let mut arrays: Vec<_> = function
        .inputs
        .iter()
        .enumerate()
        .map(|(i, &numbers)| {
            fuzz.numbers(if function.one && i == 0 { numbers } else { numbers * count })
        })
        .collect();
    let mut output = fuzz.numbers(function.output * count);
    let before: Vec<u32> = output.iter().map(|c| c.to_bits()).collect();
    let mut wrong = false;
    let mut pointers = [std::ptr::null_mut(); 4];
    for (slot, (array, numbers)) in pointers.iter_mut().zip(arrays.iter_mut().zip(function.inputs))
    {
        if numbers > 0 {
            *slot = fuzz.pointer(array.as_mut_ptr(), &mut wrong);
        }
    }
    pointers[3] = fuzz.pointer(output.as_mut_ptr(), &mut wrong);
    // More than any memory holds.
    let huge = fuzz.below(50) == 0;
    let status =
        (function.call)(pointers, fuzz.number(), if huge { usize::MAX / 5 } else { count });
    assert_eq!(status == Status::Ok, !wrong && !huge, "{}: {status:?}", function.name);
    assert!(
        status == Status::Ok || output.iter().map(|c| c.to_bits()).eq(before),
        "{}",
        function.name
    );
}
