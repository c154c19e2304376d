//! The quicker forms that floats have of the textbook reference, where a table of operations cannot
//! reach: at every size, in what is not finite, far outside [0, 1]. (`agree` and `oracle` hold
//! floats against the reference, and both against 60 digits, for every operation.)

use dq8::{DualQuat, Quat, Real};
use dq8_contract::bound::unit_roundoff;
use dq8_contract::inputs;
use dq8_contract::textbook::Textbook;
use proptest::prelude::*;

/// Quicker forms leave large and small numbers to the reference: at each size, on both sides of
/// where they do, a motion is the same up to rounding, and what has no answer has none.
#[test]
fn normalization_and_inverse_are_the_same_at_every_size() {
    fn compare<F: Real>(largest: i32, step: usize) {
        let u = unit_roundoff(size_of::<F>() == 4);
        let motion = inputs::edge_motions()[60];
        let exponents = || (-largest..=largest).step_by(step).map(|exponent| 2f64.powi(exponent));
        let (mut answers, mut none) = (0, 0);
        for (p, q) in exponents().flat_map(|p| exponents().map(move |q| (p, q))) {
            let sized: [f64; 8] = std::array::from_fn(|i| motion[i] * if i < 4 { p } else { q });
            let quick = DualQuat::from_array(sized.map(F::from_f64));
            let textbook = DualQuat::from_array(sized.map(|c| Textbook(F::from_f64(c))));
            let pairs = [
                (quick.try_normalize().ok(), textbook.try_normalize().ok()),
                (quick.try_inverse().ok(), textbook.try_inverse().ok()),
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
    compare::<f32>(123, 3);
    compare::<f64>(1020, 7);
}

/// Where p·q is lost below the normal numbers, so is what it would take away from q.
#[test]
fn small_dual_parts_keep_their_digits_beside_every_real_part() {
    let motion: [f64; 8] = [0.1, -0.7, 0.5, 0.5, 0.3, 0.9, -0.4, 0.7];
    for p in [1.0, 0.6, 0.51, 0.49, 0.05, 1.1e-3] {
        for q in [1e-36, 1e-38, 1e-40] {
            // A dual part that is not orthogonal: taking off what lies along p matters.
            let sized: [f32; 8] = std::array::from_fn(|i| {
                (if i < 4 { motion[i] * p } else { (motion[i] + motion[i - 4]) * q }) as f32
            });
            let wanted = DualQuat::from_array(sized.map(f64::from));
            let single = DualQuat::from_array(sized);
            for (got, wanted) in
                [(single.normalize(), wanted.normalize()), (single.inverse(), wanted.inverse())]
            {
                let size = wanted.dual().norm();
                let pairs = got.dual().to_array().into_iter().zip(wanted.dual().to_array());
                for (got, wanted) in pairs {
                    // And below the normal numbers some steps of the smallest number, of what q is
                    // over |p|.
                    let digits = 1e-6 + 32.0 * 1.4e-45 * p / q;
                    let off = (f64::from(got) - wanted).abs();
                    assert!(off <= size * digits, "{got:e}, {wanted:e} of {sized:?}");
                }
            }
        }
    }
}

/// A quicker form that takes every number it is given would give half an answer here.
#[test]
fn what_is_not_finite_is_refused_whole() {
    fn answers<F: Real>(numbers: [f64; 8]) -> [bool; 2] {
        let motion = DualQuat::from_array(numbers.map(F::from_f64));
        [motion.try_normalize().is_ok(), motion.try_inverse().is_ok()]
    }
    let number = prop_oneof![
        8 => -2.0..2.0_f64,
        1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 3e38, 1e-40]),
    ];
    inputs::for_all(1000, &prop::array::uniform8(number), |numbers| {
        let motion = DualQuat::from_array(numbers.map(|c| c as f32));
        for answer in [motion.normalize(), motion.inverse()] {
            let finite = answer.to_array().map(f32::is_finite);
            assert!(finite == [finite[0]; 8], "{answer:?} of {motion:?}");
        }
        // |p| itself may be no float though p is one: the reference has nothing to divide by then.
        if !numbers[..4].iter().any(|c| c.abs() > 1e38) {
            assert_eq!(answers::<f32>(numbers), answers::<Textbook<f32>>(numbers), "{numbers:?}");
            assert_eq!(answers::<f64>(numbers), answers::<Textbook<f64>>(numbers), "{numbers:?}");
        }
    });
}

/// Registers sum in the order of the reference.
#[test]
fn products_are_those_of_the_reference_to_the_last_bit() {
    fn compare<F: Real>(a: [f64; 8], b: [f64; 8]) {
        let floats = |motion: [f64; 8]| DualQuat::from_array(motion.map(F::from_f64));
        let book =
            |motion: [f64; 8]| DualQuat::from_array(motion.map(|c| Textbook(F::from_f64(c))));
        let motion = (floats(a) * floats(b), book(a) * book(b));
        let rotation = (floats(a).real() * floats(b).real(), book(a).real() * book(b).real());
        let got = motion.0.to_array().into_iter().chain(rotation.0.to_array());
        let wanted = motion.1.to_array().into_iter().chain(rotation.1.to_array());
        for (got, wanted) in got.zip(wanted) {
            let (got, wanted): (f64, f64) = (got.into(), wanted.into());
            let same = got.to_bits() == wanted.to_bits() || got.is_nan() && wanted.is_nan();
            assert!(same, "{got:e}, {wanted:e} of {a:?} and {b:?}");
        }
    }
    let number = prop_oneof![
        8 => -2.0..2.0_f64,
        1 => prop::sample::select(vec![0.0, -0.0, 1.0, f64::INFINITY, f64::NAN, 3e38, 1e-40]),
    ];
    let motion = || prop::array::uniform8(number.clone());
    inputs::for_all(1000, &(motion(), motion()), |(a, b)| {
        compare::<f32>(a, b);
        compare::<f64>(a, b);
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
