//! Limbs of two bones: the same pose, and masks for what the scalar reference tells by its span or an error.

use super::{Provable, columns, exact, holds, lane, measure, on_every_level, rounded, row};
use dq8::batch;
use dq8::ik::{Span, TwoBone};
use dq8_contract::ledger::{Ledger, line};

#[derive(Clone, Debug)]
struct Case {
    root: [f64; 3],
    lengths: [f64; 2],
    target: [f64; 3],
    pole: [f64; 3],
}

/// Targets within reach, too far, too near and at the root; poles across the way, along it and none.
fn cases() -> Vec<Case> {
    let (origin, p) = ([0.0; 3], [1.0, -2.0, 0.5]);
    let mut cases = Vec::new();
    for lengths in [[1.0, 1.0], [1.0, 0.25], [0.25, 1.0], [1.0, 0.0], [0.0, 0.0]] {
        for target in [
            [1.0, 0.5, 0.25],
            [0.0, 3.0, 0.0],
            [0.0, 0.0, 0.125],
            [-1.0, 0.0, 0.0],
            [-0.75, 0.0, 0.5],
        ] {
            for pole in [[0.0, 1.0, 0.0], [0.3, -0.2, 4.0], target, origin] {
                cases.push(Case { root: origin, lengths, target, pole });
                let there = std::array::from_fn(|i| p[i] + target[i]);
                cases.push(Case { root: p, lengths, target: there, pole });
                cases.push(Case { root: p, lengths, target: p, pole });
            }
        }
    }
    let case = cases[0].clone();
    let (nan, endless) = (f64::NAN, f64::INFINITY);
    for lengths in [[-1.0, 1.0], [1.0, -0.5], [nan, 1.0], [endless, 1.0], [3e38, 3e38]] {
        cases.push(Case { lengths, ..case.clone() });
    }
    for at in [[nan, 0.0, 0.0], [0.0, endless, 0.0]] {
        cases.push(Case { root: at, ..case.clone() });
        cases.push(Case { target: at, ..case.clone() });
        cases.push(Case { pole: at, ..case.clone() });
    }
    cases
}

fn limbs_agree<L: Provable>(ledger: &Ledger) {
    for chunk in cases().chunks(L::LANES) {
        let root = columns::<L, _, 3>(chunk, |case| case.root);
        let lengths = columns::<L, _, 2>(chunk, |case| case.lengths);
        let target = columns::<L, _, 3>(chunk, |case| case.target);
        let pole = columns::<L, _, 3>(chunk, |case| case.pole);
        let (limb, failed) = batch::TwoBone::reach_checked(root, lengths, target, pole);
        for (index, case) in chunk.iter().enumerate() {
            let Case { root, lengths, target, pole } = case;
            let lengths = rounded::<L::Real, 2>(*lengths);
            let wanted = TwoBone::reach(rounded(*root), lengths, rounded(*target), rounded(*pole));
            assert_eq!(holds(failed, index), wanted.is_err(), "{case:?}");
            let (upper, lower) =
                (row(limb.upper.to_array(), index), row(limb.lower.to_array(), index));
            let (bend, missed) = (lane(limb.bend, index), lane(limb.missed, index));
            let Ok(wanted) = wanted else {
                assert!(upper.iter().chain(&lower).all(|c| c.is_nan()), "{case:?}");
                assert!(bend.is_nan() && missed.is_nan(), "{case:?}");
                continue;
            };
            let span = (holds(limb.stretched, index), holds(limb.folded, index));
            let by_the_book = (wanted.span == Span::Stretched, wanted.span == Span::Folded);
            assert_eq!(span, by_the_book, "{case:?}");
            measure::<L, 1>(ledger, ("bend", ""), [bend], [wanted.bend.into()], 1.0, case);
            measure::<L, 1>(ledger, ("missed", ""), [missed], [wanted.missed.into()], 4.0, case);
            for (got, wanted) in [(upper, wanted.upper), (lower, wanted.lower)] {
                let wanted = exact(wanted.to_array());
                // As rotations, which do not see the sign.
                let dot: f64 = got.iter().zip(wanted).map(|(a, b)| a * b).sum();
                let got = got.map(|c| c * dot.signum());
                measure::<L, 4>(ledger, ("rotation", ""), got, wanted, 1.0, case);
            }
        }
    }
}

#[test]
fn limbs_of_two_bones_on_lanes_are_those_of_the_scalar_reference() {
    #[rustfmt::skip]
    let bounds = [
        line("bend", &[], 6.5, "an arctangent by a polynomial"),
        line("missed", &[], 0.5, "a difference of lengths"),
        line("rotation", &[], 4.5, "a rotation from a matrix, and a product"),
    ];
    Ledger::keep("two bones", &bounds, |ledger| on_every_level!(limbs_agree, ledger));
}
