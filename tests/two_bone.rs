//! Limbs of two bones, against the points that their rotations give.

use dq8::ik::{LimbError, Span, TwoBone};
use dq8::{Dual, Quat, Real};
use dq8_contract::random::Random;
use dq8_contract::textbook::Textbook;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// A few units of roundoff, of a point made of two bones no longer than about 1.
const ROUNDING: f64 = 1e-15;
/// Dozens of them: products of vectors that come from roots, cross products and rotations.
const DOZENS: f64 = 1e-14;
/// A dozen of them in `f32`.
const SINGLE: f32 = 1e-6;

/// Where knee and end are.
fn points(limb: &TwoBone<f64>, root: [f64; 3], [a, b]: [f64; 2]) -> [Vector3<f64>; 2] {
    let knee = Vector3::from(root) + Vector3::from(limb.upper.rotate([a, 0.0, 0.0]));
    [knee, knee + Vector3::from(limb.lower.rotate([b, 0.0, 0.0]))]
}

fn vector(random: &mut Random) -> [f64; 3] {
    core::array::from_fn(|_| random.signed())
}

#[test]
fn the_end_is_at_the_target_and_the_knee_on_the_side_of_the_pole() {
    let mut random = Random(20);
    let (mut within, mut worst) = (0, 0.0_f64);
    for _ in 0..2000 {
        let (root, target, pole) = (vector(&mut random), vector(&mut random), vector(&mut random));
        let lengths = [(); 2].map(|()| random.between(0.2, 1.2));
        let limb = TwoBone::reach(root, lengths, target, pole).expect("finite");
        let [knee, end] = points(&limb, root, lengths);
        let (root, target, pole) =
            (Vector3::from(root), Vector3::from(target), Vector3::from(pole));
        worst = worst.max(((end - target).norm() - limb.missed).abs());
        within += u32::from(limb.span == Span::Within);

        let way = (target - root).normalize();
        // In the plane of target and pole, on its side of the way.
        assert!((knee - root).dot(&way.cross(&pole)).abs() < DOZENS);
        let across = pole - way * way.dot(&pole);
        assert!((knee - root).dot(&across) > -DOZENS);
        // Out of reach it is straight: a root of rounding would be eight digits aside.
        if limb.span != Span::Within {
            assert!((knee - root).cross(&way).norm() < ROUNDING);
        }
        // A hinge about z between the two.
        let z = Quat::from_axis_angle([0.0, 0.0, 1.0], limb.bend);
        let hinged = limb.upper * z;
        assert!((hinged.dot(limb.lower).abs() - 1.0).abs() < DOZENS);
        assert!((0.0..=PI).contains(&limb.bend));
        assert!((limb.upper.norm() - 1.0).abs() + (limb.lower.norm() - 1.0).abs() < ROUNDING);
    }
    assert!((900..1100).contains(&within), "{within}");
    assert!(worst < 3e-15, "{worst:e}");
}

#[test]
fn a_target_too_far_stretches_and_one_too_near_folds() {
    let root = [1.0, 2.0, 3.0];
    let up = [0.0, 0.0, 1.0];
    let far = TwoBone::reach(root, [0.5, 0.25], [3.0, 2.0, 3.0], up).expect("finite");
    assert_eq!((far.span, far.bend, far.missed), (Span::Stretched, 0.0, 1.25));
    let [knee, end] = points(&far, root, [0.5, 0.25]);
    assert!(
        (knee - Vector3::new(1.5, 2.0, 3.0)).norm() + (end - Vector3::new(1.75, 2.0, 3.0)).norm()
            < ROUNDING
    );

    let near = TwoBone::reach(root, [0.5, 0.25], [1.125, 2.0, 3.0], up).expect("finite");
    assert_eq!((near.span, near.bend, near.missed), (Span::Folded, PI, 0.125));
    let [knee, end] = points(&near, root, [0.5, 0.25]);
    assert!(
        (knee - Vector3::new(1.5, 2.0, 3.0)).norm() + (end - Vector3::new(1.25, 2.0, 3.0)).norm()
            < ROUNDING
    );

    // The longer bone at the end: the knee goes the other way.
    let near = TwoBone::reach(root, [0.25, 0.5], [1.125, 2.0, 3.0], up).expect("finite");
    let [knee, end] = points(&near, root, [0.25, 0.5]);
    assert!(
        (knee - Vector3::new(0.75, 2.0, 3.0)).norm() + (end - Vector3::new(1.25, 2.0, 3.0)).norm()
            < ROUNDING
    );
}

/// A flat triangle keeps its digits: cosines of the law of cosines would have lost half of them.
#[test]
fn an_almost_stretched_limb_is_as_accurate() {
    for short in [1e-4, 1e-8, 1e-12] {
        let target = [2.0 * (1.0 - short), 0.0, 0.0];
        let limb = TwoBone::reach([0.0; 3], [1.0, 1.0], target, [0.0, 1.0, 0.0]).expect("finite");
        // The bend is 2 arccos(D/2), which is 2√(2s)(1 + s/12) but for terms of s².
        let wanted = 2.0 * (2.0 * (1.0 - target[0] / 2.0)).sqrt() * (1.0 + short / 12.0);
        assert!((limb.bend / wanted - 1.0).abs() < 1e-8, "{short}: {} {wanted}", limb.bend);
    }
}

#[test]
fn a_limb_without_a_plane_takes_one() {
    let (root, lengths) = ([0.5, 0.0, 0.0], [0.4, 0.4]);
    let target = [0.5, 0.6, 0.0];
    for pole in [[0.0; 3], [0.0, 2.0, 0.0], [0.0, -1e-30, 0.0], [0.0, 1.0, 1e-17]] {
        let limb = TwoBone::reach(root, lengths, target, pole).expect("finite");
        let [knee, end] = points(&limb, root, lengths);
        assert!((end - Vector3::from(target)).norm() < ROUNDING, "{pole:?}");
        assert!((knee - Vector3::new(0.5 + 0.07_f64.sqrt(), 0.3, 0.0)).norm() < ROUNDING, "{knee}");
    }
    // The target at the root: the knee where the pole points, or on x.
    for (pole, x, y) in [([0.0, 3.0, 0.0], 0.5, 0.4), ([0.0; 3], 0.9, 0.0)] {
        let limb = TwoBone::reach(root, lengths, root, pole).expect("finite");
        assert_eq!((limb.span, limb.bend, limb.missed), (Span::Within, PI, 0.0));
        let [knee, end] = points(&limb, root, lengths);
        assert!((end - Vector3::from(root)).norm() < ROUNDING);
        assert!((knee - Vector3::new(x, y, 0.0)).norm() < ROUNDING, "{knee}");
        for lengths in [[0.25, 0.5], [0.5, 0.25]] {
            let limb = TwoBone::reach(root, lengths, root, pole).expect("finite");
            assert_eq!((limb.span, limb.missed), (Span::Folded, 0.25));
            let [knee, _] = points(&limb, root, lengths);
            let wanted = Vector3::new(x - 0.5, y, 0.0) * (lengths[0] / 0.4);
            assert!((knee - Vector3::from(root) - wanted).norm() < ROUNDING, "{knee}");
        }
    }
    // Bones without length.
    for lengths in [[0.0, 0.0], [0.4, 0.0], [0.0, 0.4]] {
        let limb = TwoBone::reach(root, lengths, target, [0.0, 0.0, 1.0]).expect("finite");
        let [_, end] = points(&limb, root, lengths);
        assert!(((end - Vector3::from(target)).norm() - limb.missed).abs() < ROUNDING);
    }
}

fn refuses<R: Real>() {
    let (inf, nan) = (R::ONE / R::ZERO, R::NAN);
    let good = [R::ONE, R::ZERO, R::TWO];
    for bad in [inf, -inf, nan] {
        for axis in 0..3 {
            let mut point = good;
            point[axis] = bad;
            for (what, [root, target, pole]) in [
                ("root", [point, good, good]),
                ("target", [good, point, good]),
                ("pole", [good, good, point]),
            ] {
                let refused = TwoBone::reach(root, [R::ONE; 2], target, pole).unwrap_err();
                let LimbError::NotFinite { what: named, index, .. } = refused else {
                    panic!("{refused}");
                };
                assert_eq!((named, index), (what, axis));
            }
        }
    }
    for bad in [inf, nan, -R::ONE] {
        for bone in 0..2 {
            let mut lengths = [R::ONE; 2];
            lengths[bone] = bad;
            let refused = TwoBone::reach(good, lengths, good, good).unwrap_err();
            assert!(matches!(refused, LimbError::Length { bone: named, .. } if named == bone));
        }
    }
}

#[test]
fn what_is_not_finite_is_refused() {
    refuses::<f64>();
    refuses::<f32>();
    let error = LimbError::Length { bone: 1, value: -2.0 };
    assert_eq!(error.to_string(), "bone 1 cannot have the length -2");
}

#[test]
fn lengths_may_be_as_large_or_small_as_numbers_are() {
    for scale in [f32::MAX / 8.0, 1e-30, f32::MIN_POSITIVE] {
        let target = [0.0, 1.2 * scale, 0.0];
        let limb = TwoBone::reach([0.0; 3], [scale; 2], target, [scale, 0.0, 0.0]).expect("finite");
        assert_eq!(limb.span, Span::Within);
        assert!((limb.bend - 2.0 * 0.6_f32.acos()).abs() < SINGLE, "{scale}: {}", limb.bend);
    }
    let long = TwoBone::reach([0.0; 3], [f32::MAX; 2], [1.0, 0.0, 0.0], [0.0; 3]);
    assert!(matches!(long, Err(LimbError::Length { bone: 1, .. })));
}

/// The knee's speed as the ankle moves, by automatic differentiation and by a difference.
#[test]
fn a_limb_differentiates_itself() {
    let bend = |x: f64| {
        let limb = TwoBone::reach([0.0; 3], [0.5, 0.4], [x, 0.2, 0.1], [0.0, 0.0, 1.0]);
        limb.expect("finite").bend
    };
    let c = |x: f64| Dual::new(x, 0.0);
    let moving = [Dual::new(0.6, 1.0), c(0.2), c(0.1)];
    let limb = TwoBone::reach([c(0.0); 3], [c(0.5), c(0.4)], moving, [c(0.0), c(0.0), c(1.0)]);
    let h = 1e-5;
    let difference = (bend(0.6 + h) - bend(0.6 - h)) / (2.0 * h);
    assert!((limb.expect("finite").bend.dual - difference).abs() < 1e-9);
}

/// A length that is no number belongs to a direction all the same.
#[test]
fn poles_and_targets_are_directions_whatever_their_length() {
    for large in [1e30, 3e38] {
        let reach = |target: [f32; 3], pole: [f32; 3]| {
            TwoBone::reach([0.0; 3], [1.0; 2], target, pole).expect("finite")
        };
        let bent = |pole: f32| reach([1.0, 1.0, 0.0], [pole, -pole, 0.0]);
        let (got, wanted) = (bent(large), bent(1.0));
        assert!(got.upper.abs_diff_eq(wanted.upper, SINGLE), "{got:?}, {wanted:?}");
        assert!(got.lower.abs_diff_eq(wanted.lower, SINGLE), "{got:?}, {wanted:?}");
        let (far, near) = (reach([large, large, 0.0], [0.0; 3]), reach([9.0, 9.0, 0.0], [0.0; 3]));
        assert!(far.upper.abs_diff_eq(near.upper, SINGLE), "{far:?}, {near:?}");
        assert_eq!(far.span, Span::Stretched);
    }
}

/// Floats take roots where the formulas have angles.
#[test]
fn roots_give_the_limbs_that_angles_give() {
    let mut random = Random(21);
    let mut spans = [0; 3];
    for i in 0..3000 {
        let [root, target, pole] = [(); 3].map(|()| vector(&mut random));
        let short = if i % 3 == 0 { 0.01 } else { 0.5 };
        let lengths = [random.between(0.5, 1.5) * short, random.between(0.5, 1.5) * 0.5];
        let quick = TwoBone::reach(root, lengths, target, pole).expect("finite");
        let book = |numbers: [f64; 3]| numbers.map(Textbook);
        let [root, target, pole] = [root, target, pole].map(book);
        let slow = TwoBone::reach(root, lengths.map(Textbook), target, pole).expect("finite");
        assert_eq!(quick.span, slow.span);
        spans[quick.span as usize] += 1;
        // Angles near a stretched limb turn by the root of a rounding.
        for (got, wanted) in [(quick.upper, slow.upper), (quick.lower, slow.lower)] {
            for (got, wanted) in got.to_array().into_iter().zip(wanted.to_array()) {
                assert!((got - wanted.0).abs() < 1e-10, "{i}: {quick:?} {slow:?}");
            }
        }
        assert!((quick.bend - slow.bend.0).abs() < 1e-10, "{i}: {quick:?} {slow:?}");
        assert!((quick.missed - slow.missed.0).abs() < ROUNDING, "{i}: {quick:?} {slow:?}");
    }
    assert!(spans.iter().all(|&count| count > 50), "{spans:?}");
}
