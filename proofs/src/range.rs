//! [`Range`]: for which sizes of the arguments a bound holds, and what it lacks below the normal numbers.

use crate::bound::{Analysis, Rounding};
use crate::composed;
use crate::operations::{Form, Operation};
use crate::polynomial::Lengths;
use crate::tape::{Node, Op, Tape};
use crate::tape_of;

/// Where nothing overflows, and what underflow adds.
#[derive(Clone, Debug)]
pub struct Range {
    /// For `f32` and `f64`, k: no number on the way overflows if no argument is longer than 2ᵏ, and, where it is divided by
    /// its length, none is shorter than 2⁻ᵏ.
    pub powers: [i32; 2],
    /// Of any number of the answer, in units of half the least number: 2⁻¹⁵⁰ or 2⁻¹⁰⁷⁵. `None` where a root is taken.
    pub underflow: Option<Lengths>,
}

/// The range of an operation; `None` where its numbers are not analysed.
#[must_use]
pub fn range(operation: &Operation, form: Form, fused: bool) -> Option<Range> {
    let (groups, mut powers, mut underflow) =
        (operation.groups(), [0; 2], Some(Lengths::default()));
    for (is_single, (power, largest)) in
        [true, false].into_iter().zip(powers.iter_mut().zip([128, 1024]))
    {
        let tape = tape_of(operation, form, is_single);
        let analysis = Analysis::of(&tape, &groups, fused);
        // A sum that is normalized: what is summed, and what is normalized by itself.
        let sum = composed::sum(operation, &tape, form, is_single);
        let sizes = sizes(&tape, &analysis, sum.as_ref().map_or(&tape.outputs, |sum| &sum.1))?;
        let last = match &sum {
            Some((last, nodes)) => {
                let most = range(last, form, fused)?.powers[usize::from(!is_single)];
                Some((most, composed::given(&analysis, last, nodes)?))
            }
            None => None,
        };
        let fits = |k: i32| {
            let below = |size: &Lengths, most: i32| log(size, k) < f64::from(most) - 0.001;
            sizes.iter().all(|size| below(size, largest))
                && last.iter().all(|(most, given)| given.iter().all(|(one, _)| below(one, *most)))
        };
        // Squares whose root is taken have a path of their own beyond these lengths.
        let divides = |op: &Op| matches!(op, Op::Div(..) | Op::Sqrt(_));
        let longest = if let Some((most, _)) = &last {
            most + 1
        } else if !tape.ops.iter().any(divides) {
            largest
        } else if is_single {
            41
        } else {
            401
        };
        *power = (0..longest).rev().find(|&k| fits(k))?;
        let below = Analysis::with(Rounding::Below, &tape, &groups, fused);
        for &output in &tape.outputs {
            match (&mut underflow, below.bound(output)) {
                (Some(worst), Some(one)) => worst.worst(&one),
                _ => underflow = None,
            }
        }
    }
    Some(Range { powers, underflow })
}

/// Of all numbers on the way, products that are not rounded among them.
fn sizes(tape: &Tape, analysis: &Analysis, of: &[Node]) -> Option<Vec<Lengths>> {
    let needed = tape.needed(of);
    let mut sizes = vec![];
    for node in (0..tape.ops.len()).filter(|&node| needed[node]) {
        if let Op::Fma(a, b, _) | Op::Nfma(a, b, _) = tape.ops[node] {
            sizes.push(analysis.size(a)?.times(&analysis.size(b)?));
        }
        sizes.push(analysis.size(node as Node)?);
    }
    Some(sizes)
}

/// log₂ of the size where lengths are 2ᵏ, or one over it if that is more.
fn log(size: &Lengths, k: i32) -> f64 {
    let of = |(powers, c): (&Vec<(usize, i32)>, &f64)| {
        c.log2() + f64::from(k * powers.iter().map(|(_, power)| power.abs()).sum::<i32>())
    };
    let terms: Vec<f64> = size.0.iter().map(of).collect();
    let largest = terms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    largest + terms.iter().map(|term| (term - largest).exp2()).sum::<f64>().log2()
}
