//! The quicker forms that floats have of the textbook reference, against the reference itself: the
//! same operations on [`Textbook`] numbers, which have no quicker forms.

use dq8::{DualQuat, Quat, Real};
use dq8_contract::agreement::{LANES, bound, distance};
use dq8_contract::conformance::worst_errors;
use dq8_contract::inputs::{self, Arguments, Case, NUMBERS};
use dq8_contract::repertoire::{self, ALGEBRA, NAMES, answer};
use dq8_contract::sample::Sample;
use dq8_contract::textbook::Textbook;
use dq8_contract::tolerance::{section, unit_roundoff};
use dq8_contract::vectors;
use proptest::prelude::*;
use proptest::test_runner::{TestCaseError, TestRunner};

/// Where both ways between two motions are equally long up to rounding, either is right.
fn is_a_tie(single: bool, name: &str, case: &Case) -> bool {
    let apart = |other: &[f64; 8]| {
        let dot: f64 = case.a.iter().zip(other).take(4).map(|(a, b)| a * b).sum();
        dot.abs() < 16.0 * unit_roundoff(single)
    };
    match name {
        "nlerp" | "sclerp" | "sclerp_long" => apart(&case.b),
        "dlb" => apart(&case.b) || apart(&case.c),
        _ => false,
    }
}

/// No farther apart than lanes may be from the reference.
fn agree<F: Real>(names: &[&str], case: &Case) -> Result<(), String> {
    let single = DualQuat::<F>::SINGLE;
    let everyday = Arguments::<DualQuat<F>>::new(&[*case]);
    let textbook = Arguments::<DualQuat<Textbook<F>>>::new(&[*case]);
    for &name in names {
        if is_a_tie(single, name, case) {
            continue;
        }
        let (numbers, masks) = answer(name, &everyday).lane(0);
        let (wanted, truths) = answer(name, &textbook).lane(0);
        let scale = repertoire::scale(name, case);
        for ((kind, got), (_, wanted)) in numbers.into_iter().zip(wanted) {
            // The reference overflowed on the way, as with the moment of a tiny screw.
            let none = !wanted.is_finite();
            let units = distance(got, wanted, scale.of(kind), single);
            if !none && units > bound(LANES, name) {
                return Err(format!(
                    "{name} gives {got:e} for a {kind:?}, the reference {wanted:e}: {units:.2} units \
                     apart for {case:?}"
                ));
            }
        }
        if masks != truths {
            return Err(format!("{name} says {masks:?}, the reference {truths:?} for {case:?}"));
        }
    }
    Ok(())
}

fn both(names: &[&str], case: &Case) -> Result<(), String> {
    agree::<f32>(names, case)?;
    agree::<f64>(names, case)
}

fn check(case: impl Strategy<Value = Case>, property: impl Fn(&Case) -> Result<(), String>) {
    let mut runner = TestRunner::new(inputs::proptest_config(1000));
    runner
        .run(&case, |case| property(&case).map_err(TestCaseError::fail))
        .unwrap_or_else(|failure| panic!("{failure}"));
}

#[test]
fn edge_cases_are_those_of_the_reference() {
    for case in inputs::unit_cases() {
        both(&NAMES, &case).unwrap_or_else(|failure| panic!("{failure}"));
    }
}

#[test]
fn unit_motions_are_those_of_the_reference() {
    check(inputs::case(inputs::unit_motion()), |case| both(&NAMES, case));
}

#[test]
fn the_algebra_of_any_dual_quaternion_is_that_of_the_reference() {
    check(inputs::case(inputs::general_motion()), |case| both(&ALGEBRA, case));
}

/// What the reference needs beyond the table: a(a*b)ᵗ has two products more than slerp about the middle.
const BY_THE_BOOK: &[(&str, f64)] = &[("sclerp", 8.0)];

/// The reference keeps the bounds that floats keep, so that it may judge them.
#[test]
fn the_reference_keeps_every_bound_on_every_vector() {
    fn keeps<F: Real>(rows: &[vectors::Vector]) -> usize {
        let worst = worst_errors::<DualQuat<Textbook<F>>>("the reference", rows);
        let worst = worst.expect("every operation has a bound");
        for worst in &worst {
            let units = worst.error / unit_roundoff(DualQuat::<F>::SINGLE);
            let line = section("vectors").line(&worst.op, &worst.kind);
            let own = BY_THE_BOOK.iter().find(|(op, _)| *op == worst.op);
            let most = own.map_or(line.units, |(_, units)| units.max(line.units));
            assert!(units <= most, "{} ({}): {units} u", worst.op, worst.kind);
        }
        worst.iter().map(|worst| worst.vectors).sum()
    }
    for text in [include_str!("vectors/reference.jsonl"), include_str!("vectors/more.jsonl")] {
        let rows = vectors::parse(text).expect("the vectors can be read");
        assert_eq!((keeps::<f32>(&rows), keeps::<f64>(&rows)), (rows.len(), rows.len()));
    }
}

/// Quicker forms leave large and small numbers to the reference: at each size, on both sides of where
/// they do, a motion is the same up to rounding, and what has no answer has none.
#[test]
fn normalization_and_inverse_are_the_same_at_every_size() {
    fn compare<F: Real>(largest: i32) {
        let u = unit_roundoff(DualQuat::<F>::SINGLE);
        let motion = inputs::edge_motions()[60];
        let exponents = || (-largest..=largest).step_by(3).map(|exponent| 2f64.powi(exponent));
        let (mut answers, mut none) = (0, 0);
        for (p, q) in exponents().flat_map(|p| exponents().map(move |q| (p, q))) {
            let sized: [f64; 8] = std::array::from_fn(|i| motion[i] * if i < 4 { p } else { q });
            let everyday = DualQuat::from_array(sized.map(F::from_f64));
            let textbook = DualQuat::from_array(sized.map(|c| Textbook(F::from_f64(c))));
            let pairs = [
                (everyday.try_normalize().ok(), textbook.try_normalize().ok()),
                (everyday.try_inverse().ok(), textbook.try_inverse().ok()),
            ];
            for (got, wanted) in pairs {
                assert_eq!(got.is_some(), wanted.is_some(), "{sized:?}");
                let (Some(got), Some(wanted)) = (got, wanted) else {
                    none += 1;
                    continue;
                };
                answers += 1;
                let (got, wanted) = (got.to_array().map(F::into), wanted.to_array().map(f64::from));
                for half in [0..4, 4..8] {
                    let size =
                        wanted[half.clone()].iter().fold(0.0_f64, |size, c| size.max(c.abs()));
                    for (got, wanted) in got[half.clone()].iter().zip(&wanted[half]) {
                        let smallest = if u > 1e-10 { 1.2e-32 } else { 2.3e-302 };
                        assert!(
                            (got - wanted).abs() <= 8.0 * u * size.max(smallest),
                            "{got:e} and {wanted:e} of {sized:?}"
                        );
                    }
                }
            }
        }
        assert!(answers > none && none > 100, "{answers} answers, {none} without");
    }
    compare::<f32>(123);
    compare::<f64>(1020);
}

/// A quicker form that takes every number it is given would give half an answer here.
#[test]
fn what_is_not_finite_is_refused_whole() {
    let cases = prop::collection::vec(
        prop_oneof![
            8 => -2.0..2.0_f64,
            1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 3e38, 1e-40]),
        ],
        NUMBERS,
    )
    .prop_map(|numbers| Case::of_numbers(numbers.as_slice().try_into().expect("as many")));
    check(cases, |case| {
        let motion = DualQuat::from_array(case.a.map(|c| c as f32));
        for answer in [motion.normalize(), motion.inverse()] {
            let finite = answer.to_array().map(f32::is_finite);
            if finite != [finite[0]; 8] {
                return Err(format!("{answer:?} of {motion:?}"));
            }
        }
        // |p| itself may be no float though p is one: the reference has nothing to divide by then.
        if case.a[..4].iter().any(|c| c.abs() > 1e38) {
            return Ok(());
        }
        both(&["normalize_checked", "inverse_checked"], case)
    });
}

/// Powers on lanes take the square of t.
#[test]
fn powers_take_numbers_whose_square_is_none() {
    let far = DualQuat::from_translation([1.0_f32, 2.0, 0.0]).pow(1e20).translation();
    assert_eq!(far, [1e20, 2e20, 0.0]);
}

/// Of zeros of either sign the way as it stands is taken, far outside [0, 1] the reference's.
#[test]
fn interpolation_takes_the_ways_of_the_reference() {
    let quarter = |axis: [f64; 3], sign: f64| {
        let [x, y, z] = axis.map(|c| c * sign);
        DualQuat::from_rotation_translation(Quat::from_xyzw(x, y, z, 0.0), [1.0, 2.0, 3.0])
    };
    let start = DualQuat::<f64>::IDENTITY;
    for sign in [1.0, -1.0] {
        let end = quarter([0.0, 0.6, 0.8], sign);
        for t in [0.0, 0.25, 0.5, 1.0, 3.0, -40.0, 1000.0] {
            let book =
                |motion: DualQuat<f64>| DualQuat::from_array(motion.to_array().map(Textbook));
            let close = |got: DualQuat<f64>, wanted: DualQuat<Textbook<f64>>| {
                let wanted = DualQuat::from_array(wanted.to_array().map(|c| c.0));
                let tolerance = 1e-15 * (1.0 + t.abs()) * (1.0 + t.abs());
                assert!(got.abs_diff_eq(wanted, tolerance), "{t}: {got:?}, {wanted:?}");
            };
            close(start.sclerp(end, t), book(start).sclerp(book(end), Textbook(t)));
            close(start.nlerp(end, t), book(start).nlerp(book(end), Textbook(t)));
            let turned = start.rotation().slerp(end.rotation(), t);
            let wanted = book(start).rotation().slerp(book(end).rotation(), Textbook(t));
            close(DualQuat::from_rotation(turned), DualQuat::from_rotation(wanted));
        }
    }
}
