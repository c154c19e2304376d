//! [`Range`]: for which sizes of the arguments a bound holds, and what it lacks below the normal
//! numbers.

use crate::bound::{Analysis, Rounding};
use crate::composed;
use crate::polynomial::Lengths;
use crate::record::Record;
use crate::tape::{Node, Op, Tape};

/// Where nothing overflows, and what underflow adds.
#[derive(Clone, Debug)]
pub struct Range {
    /// For `f32` and `f64`, k: no number on the way overflows if no argument is longer than 2ᵏ,
    /// and, where it is divided by its length, none is shorter than 2⁻ᵏ.
    pub powers: [i32; 2],
    /// Of any number of the answer, in units of half the least number: 2⁻¹⁵⁰ or
    /// 2⁻¹⁰⁷⁵. `None` where a root is taken.
    pub underflow: Option<Lengths>,
}

/// The range of an operation; `None` where its numbers are not analysed.
#[must_use]
pub fn range(record: &Record) -> Option<Range> {
    let (mut powers, mut underflow) = ([0; 2], Some(Lengths::default()));
    for precision in record.precisions() {
        let tape = &record.tapes[precision];
        let analysis = record.analysis(precision, Rounding::Normal);
        // A sum that is normalized: what is summed, and what is normalized by itself.
        let sum = record.last(precision);
        let sizes = sizes(tape, analysis, sum.as_ref().map_or(&tape.outputs, |sum| &sum.1))?;
        let last = match &sum {
            Some((last, nodes)) => {
                Some((range(last)?.powers, composed::given(analysis, last, nodes)?))
            }
            None => None,
        };
        for (i, largest) in [(0, 128), (1, 1024)] {
            // One code for both.
            if record.precisions().contains(&i) && i != precision {
                continue;
            }
            let fits = |k: i32| {
                let below = |size: &Lengths, most: i32| log(size, k) < f64::from(most) - 0.001;
                let given = |(most, given): &([i32; 2], Vec<(Lengths, _)>)| {
                    given.iter().all(|(one, _)| below(one, most[i]))
                };
                sizes.iter().all(|size| below(size, largest)) && last.iter().all(given)
            };
            // Squares whose root is taken have a path of their own beyond these lengths.
            let divides = |op: &Op| matches!(op, Op::Div(..) | Op::Sqrt(_));
            let longest = match &last {
                Some((most, _)) => most[i] + 1,
                None if tape.ops.iter().any(divides) => [41, 401][i],
                None => largest,
            };
            powers[i] = (0..longest).rev().find(|&k| fits(k))?;
        }
        let below = record.analysis(precision, Rounding::Below);
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
            sizes.push(analysis.size(a)?.times(analysis.size(b)?));
        }
        sizes.push(analysis.size(node as Node)?.clone());
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
