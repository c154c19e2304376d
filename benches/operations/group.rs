//! [`Group`]: one operation by every contender, checked and then timed.

use crate::case::{Cases, ELEMENTS, Element};
use crate::outcome::Outcome;
use crate::peer;
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput};
use dq8::{DualQuat, batch, f32x8, f32x16};
use std::hint::black_box;

/// Relative to the number, or to 1 where that is smaller.
const TOLERANCE: f64 = 1e-5;

/// The same elements in every representation.
pub(crate) struct Contenders {
    pub(crate) reference: Cases<DualQuat<f64>>,
    pub(crate) scalar: Cases<DualQuat<f32>>,
    pub(crate) lanes: Cases<batch::DualQuat<f32x8>>,
    pub(crate) wide: Cases<batch::DualQuat<f32x16>>,
}

impl Contenders {
    fn new() -> Self {
        let elements = Element::all();
        Self {
            reference: Cases::new(&elements),
            scalar: Cases::new(&elements),
            lanes: Cases::new(&elements),
            wide: Cases::new(&elements),
        }
    }
}

pub(crate) struct Group<'a> {
    group: BenchmarkGroup<'a, WallTime>,
    pub(crate) contenders: Contenders,
    /// Of each element, by scalar `f64`.
    expected: Vec<Vec<f64>>,
}

impl<'a> Group<'a> {
    pub(crate) fn new(criterion: &'a mut Criterion, name: &str) -> Self {
        let mut group = criterion.benchmark_group(name);
        group.throughput(Throughput::Elements(ELEMENTS as u64));
        Self { group, contenders: Contenders::new(), expected: Vec::new() }
    }

    pub(crate) fn expect<I: Copy, O: Outcome>(&mut self, input: &[I], operation: impl Fn(I) -> O) {
        self.expected = input.iter().map(|&i| operation(i).numbers(0)).collect();
    }

    /// `glam`, by what `input` selects.
    pub(crate) fn glam<I: Copy, O: Outcome>(
        &mut self,
        input: impl Fn(peer::Glam) -> I,
        operation: impl Fn(I) -> O,
    ) {
        let input = self.contenders.scalar.select(|case| input(case.into()));
        self.contender("glam-Affine3A", &input, operation);
    }

    /// `nalgebra`, by what `input` selects.
    pub(crate) fn nalgebra<I: Copy, O: Outcome>(
        &mut self,
        input: impl Fn(peer::Nalgebra) -> I,
        operation: impl Fn(I) -> O,
    ) {
        let input = self.contenders.scalar.select(|case| input(case.into()));
        self.contender("nalgebra-UnitDualQuaternion", &input, operation);
    }

    pub(crate) fn contender<I: Copy, O: Outcome>(
        &mut self,
        name: &str,
        input: &[I],
        operation: impl Fn(I) -> O,
    ) {
        let mut outcomes = Vec::with_capacity(input.len());
        apply(&operation, input, &mut outcomes);
        let lanes = ELEMENTS / outcomes.len();
        for (element, expected) in self.expected.iter().enumerate() {
            let numbers = outcomes[element / lanes].numbers(element % lanes);
            assert_eq!(numbers.len(), expected.len(), "{name}");
            for (number, expected) in numbers.iter().zip(expected) {
                let difference = (number - expected).abs();
                assert!(
                    difference <= TOLERANCE * expected.abs().max(1.0),
                    "{name}: element {element} is {number:e}, not {expected:e}"
                );
            }
        }
        self.group.bench_function(name, |bencher| {
            bencher.iter(|| {
                apply(&operation, black_box(input), &mut outcomes);
                black_box(&mut outcomes);
            });
        });
    }
}

/// Not inlined: its two callers would else share a copy of the operation that is not inlined either.
#[inline(never)]
fn apply<I: Copy, O>(operation: impl Fn(I) -> O, input: &[I], outcomes: &mut Vec<O>) {
    outcomes.clear();
    outcomes.extend(input.iter().map(|&input| operation(input)));
}

/// `own!(group, |case| input, |input| outcome)`: the reference and this crate's contenders. With a
/// name before the first closure, that is the same motion in every lane.
///
/// A macro because no closure is generic: each type needs its own.
macro_rules! own {
    ($group:ident, |$case:ident| $input:expr, |$i:pat_param| $outcome:expr) => {
        own!($group, _one, |$case| $input, |$i| $outcome)
    };
    ($group:ident, $one:ident, |$case:ident| $input:expr, |$i:pat_param| $outcome:expr) => {
        let $one = $group.contenders.reference.one;
        $group.expect(&$group.contenders.reference.select(|$case| $input), |$i| $outcome);
        let $one = $group.contenders.scalar.one;
        let input = $group.contenders.scalar.select(|$case| $input);
        $group.contender("scalar-f32", &input, |$i| $outcome);
        let $one = $group.contenders.lanes.one;
        let input = $group.contenders.lanes.select(|$case| $input);
        $group.contender("lanes-f32x8", &input, |$i| $outcome);
        let $one = $group.contenders.wide.one;
        let input = $group.contenders.wide.select(|$case| $input);
        $group.contender("lanes-f32x16", &input, |$i| $outcome);
    };
}
