//! Inputs for the generic tests: edge cases, evenly spaced ones and random ones, as the tests of
//! Rust's `libm` have them. Everything here is `f64`; implementations round it to their own type.

use crate::case::{Case, length};
use crate::random::Random;
use dq8::{DualQuat, Quat, Twist};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngAlgorithm, RngSeed, TestRng, TestRunner};
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// The turn by `angle` about `axis` (of any length but zero), then the translation.
pub fn turn_and_move(axis: [f64; 3], angle: f64, translation: [f64; 3]) -> [f64; 8] {
    let length = axis.iter().map(|c| c * c).sum::<f64>().sqrt();
    let rotation = Quat::from_axis_angle(axis.map(|c| c / length), angle);
    DualQuat::from_rotation_translation(rotation, translation).to_array()
}

/// Where operations on unit motions break, both of ±σ, and evenly spaced angles.
pub fn edge_motions() -> Vec<[f64; 8]> {
    let (axis, near, far) = ([0.6, -0.48, 0.64], [0.3, -1.2, 0.7], [9e3, -4e3, 1e3]);
    let none = [0.0; 3];
    let mut motions = vec![DualQuat::IDENTITY.to_array()];
    for distance in [1e-20, 1e-3, 1.0, 1e4] {
        let moved = DualQuat::from_translation([distance, -0.5 * distance, 0.25 * distance]);
        motions.push(moved.to_array());
    }
    for (i, translation) in (1..=38).zip([none, near, far].into_iter().cycle()) {
        motions.push(turn_and_move(axis, 10.0_f64.powi(-i), translation));
    }
    for (i, translation) in (1..=9).zip([none, near, far].into_iter().cycle()) {
        motions.push(turn_and_move(axis, PI - 10.0_f64.powi(-i), translation));
    }
    for (i, translation) in (0..24).zip([none, near, far].into_iter().cycle()) {
        motions.push(turn_and_move(axis, f64::from(i) * PI / 12.0, translation));
    }
    // Half turns have w = 0 exactly, of either sign.
    let diagonal = [FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0.0];
    for direction in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], diagonal, axis] {
        for w in [0.0, -0.0] {
            for translation in [none, near, far] {
                let turn = Quat::from_parts(direction, w);
                let motion = DualQuat::from_rotation_translation(turn, translation);
                motions.push(motion.to_array());
            }
        }
    }
    let opposite: Vec<_> = motions.iter().map(|m| m.map(|c| -c)).collect();
    motions.extend(opposite);
    motions
}

/// Unit motions of every kind.
pub fn unit_motion() -> impl Strategy<Value = [f64; 8]> {
    let axis = prop::array::uniform3(-1.0..1.0_f64)
        .prop_filter("an axis has a length", |v| v.iter().map(|c| c * c).sum::<f64>() > 0.01);
    let angle = prop_oneof![
        4 => -PI..PI,
        2 => (-38.0..0.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent)),
        1 => (-9.0..0.0_f64).prop_map(|exponent| PI - 10.0_f64.powf(exponent)),
        1 => Just(0.0),
    ];
    let size = prop_oneof![Just(0.0), Just(1.0), Just(30.0), Just(1e4)];
    let translation = (vector(), size).prop_map(|(v, size)| v.map(|c| c * size));
    (axis, angle, translation, any::<bool>()).prop_map(|(axis, angle, translation, negate)| {
        turn_and_move(axis, angle, translation).map(|c| if negate { -c } else { c })
    })
}

/// Any eight numbers of one size between 1e-8 and 1e8; the real part is not zero.
pub fn general_motion() -> impl Strategy<Value = [f64; 8]> {
    let components = prop::array::uniform8(-2.0..2.0_f64);
    let components = components.prop_filter("p ≠ 0", |c| c[..4].iter().any(|c| c.abs() > 0.1));
    let exponent = prop_oneof![2 => Just(0.0), 1 => -8.0..8.0_f64];
    (components, exponent)
        .prop_map(|(components, exponent)| components.map(|c| c * 10.0_f64.powf(exponent)))
}

pub fn vector() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-2.0..2.0_f64)
}

/// Any bits of the type with weight 2, numbers that hurt with 1, and ordinary ones with the weight
/// given.
pub fn any_number(single: bool, ordinary: u32) -> impl Strategy<Value = f64> {
    let bits = if single {
        any::<u32>().prop_map(|bits| f64::from(f32::from_bits(bits))).boxed()
    } else {
        any::<u64>().prop_map(f64::from_bits).boxed()
    };
    let (inf, tiny) = (f64::INFINITY, 5e-324);
    let one = [0.0, -0.0, 1.0, -1.0, f64::NAN, inf, -inf];
    let hard = [&one[..], &[1e-45, tiny, 1e-40, 1e-20, 1e20, 1e30, 3e38, 1e308]].concat();
    prop_oneof![2 => bits, 1 => prop::sample::select(hard), ordinary => -4.0..4.0_f64]
}

/// Interpolation parameters and exponents: inside [0, 1], its ends, and beyond. Multiples of
/// 2⁻¹⁰, so that sums of two are exact in every type.
pub fn parameter() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (0..=1024_i32).prop_map(|i| f64::from(i) / 1024.0),
        1 => (-2048..=3072_i32).prop_map(|i| f64::from(i) / 1024.0),
    ]
}

/// A case of motions that `motion` makes, with the matrix and the screw of a.
pub fn case(motion: impl Strategy<Value = [f64; 8]>) -> impl Strategy<Value = Case> {
    let numbers = (parameter(), parameter(), vector(), vector());
    let weights = prop::array::uniform4(0.0625..1.0_f64);
    let twists = prop::array::uniform4(vector());
    (prop::array::uniform4(motion), numbers, weights, twists).prop_map(
        |([a, b, c, d], (s, t, v, w), weights, [angular, linear, along, across])| {
            let (x, y) = ([angular, linear].concat(), [along, across].concat());
            let (x, y) = (x.try_into().expect("six"), y.try_into().expect("six"));
            Case { d, s, t, v, w, weights, x, y, dt: s, ..Case::of_motions(a, b, c) }
        },
    )
}

impl Case {
    /// Motions that are unit, with the matrix and the screw of `a`, and ordinary numbers.
    pub fn of_motions(a: [f64; 8], b: [f64; 8], c: [f64; 8]) -> Self {
        let sigma = DualQuat::from_array(a);
        let screw = sigma.to_screw();
        let ([l0, l1, l2], [m0, m1, m2]) = (screw.axis.direction, screw.axis.moment);
        let x = [0.5, -0.25, 1.0, 1.5, 2.0, -0.5];
        Self {
            a,
            b,
            c,
            d: c,
            derivative: sigma.derivative_spatial(Twist::from_array(x)).to_array(),
            s: 0.75,
            t: 0.25,
            dt: -0.5,
            radius: 2.5,
            v: [0.5, -1.5, 2.0],
            w: [-3.0, 0.25, 1.0],
            weights: [0.5, 0.25, 0.25, 0.125],
            tolerance: 1e-3,
            rows: sigma.to_matrix3x4(),
            screw: [l0, l1, l2, m0, m1, m2, screw.angle, screw.slide],
            x,
            y: [1.0, 0.75, -0.5, -0.25, 1.25, 0.5],
            wrench: [0.25, 1.0, -1.5, 2.0, 0.5, -0.75],
        }
    }
}

/// Each edge case with two others, and random ones: for tests that do not shrink.
pub fn unit_cases() -> Vec<Case> {
    let edges = edge_motions();
    let at = |i: usize| edges[i % edges.len()];
    let paired = (0..edges.len()).map(|i| Case::of_motions(at(i), at(7 * i + 3), at(31 * i + 5)));
    let random = draw(case(unit_motion()), 256);
    // The numbers of the random cases serve the edge cases as well.
    let numbered = paired.zip(random.iter().cycle()).map(|(edge, random)| Case {
        a: edge.a,
        b: edge.b,
        c: edge.c,
        d: edge.d,
        derivative: edge.derivative,
        rows: edge.rows,
        screw: edge.screw,
        ..*random
    });
    numbered.collect::<Vec<_>>().into_iter().chain(random.iter().copied()).collect()
}

/// Four poses within a radian or so of each other, of any spread, about unit motions of every kind.
pub fn cluster() -> impl Strategy<Value = Case> {
    let axis = prop::array::uniform3(-1.0..1.0_f64)
        .prop_filter("an axis has a length", |v| v.iter().map(|c| c * c).sum::<f64>() > 0.01);
    let member = (axis, -0.7..0.7_f64, vector());
    let size = prop_oneof![3 => Just(1.0), 1 => (-6.0..0.0_f64).prop_map(|e| 10.0_f64.powf(e))];
    let poses =
        (unit_motion(), prop::array::uniform4(member), size).prop_map(|(centre, members, size)| {
            members.map(|(axis, angle, translation)| {
                let offset = turn_and_move(axis, size * angle, translation.map(|c| size * c));
                (DualQuat::from_array(centre) * DualQuat::from_array(offset)).to_array()
            })
        });
    let weights = prop::array::uniform4(0.0625..1.0_f64);
    (poses, weights, 0.0..=1.0_f64).prop_map(|([a, b, c, d], weights, t)| Case {
        d,
        weights,
        t,
        // A body of which a few units are large.
        v: [3.0, -2.4, 3.2],
        radius: 5.0,
        ..Case::of_motions(a, b, c)
    })
}

/// Angles where something happens: nothing at all, subnormal and vanishing squares, where series
/// end (1, √10), half and whole turns.
const ANGLES: [f64; 32] = [
    0.0, 1e-45, 1e-38, 1e-30, 1e-20, 1e-12, 1e-8, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.5, 0.999_999,
    1.000_001, 1.5, 2.0, 2.5, 3.0, 3.135, PI, 3.145, 3.162, 3.1623, 3.2, 4.0, 5.0, 6.0, 6.2, 6.8,
    9.0, 12.0,
];

/// Every angle with twists and translations of several sizes.
pub fn twist_cases() -> Vec<Case> {
    let mut random = Random(8);
    let mut cases = Vec::new();
    for size in [0.0, 1e-20, 1.0, 30.0, 1e4] {
        for angle in ANGLES {
            cases.push(twist_case(&mut random, angle, size));
        }
        for _ in 0..60 {
            let angle = 6.0 * random.signed().abs();
            cases.push(twist_case(&mut random, angle, size));
        }
    }
    cases
}

/// |ω| is `angle`, and translations are of the size `size`.
pub fn twist_case(random: &mut Random, angle: f64, size: f64) -> Case {
    let pose = random.motion(size);
    let [x, y] = [random.twist(size), random.twist(size.min(1.0))];
    let turns = length(&x[..3]);
    let x = std::array::from_fn(|i| if i < 3 { x[i] / turns * angle } else { x[i] });
    let derivative = pose.derivative_spatial(Twist::from_array(random.twist(size)));
    let other = random.motion(size).to_array();
    Case {
        derivative: derivative.to_array(),
        x,
        y,
        wrench: random.twist(size.min(1.0)),
        dt: random.signed(),
        ..Case::of_motions(pose.to_array(), other, other)
    }
}

/// The unit cases and others that are no motions.
pub fn general_cases() -> Vec<Case> {
    let mut cases = unit_cases();
    cases.extend(draw(case(general_motion()), 256));
    cases
}

/// The first `count` values of a strategy, the same ones in every run.
pub fn draw<S: Strategy>(strategy: S, count: usize) -> Vec<S::Value> {
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(ProptestConfig::default(), rng);
    let mut next = || strategy.new_tree(&mut runner).expect("filters are mild").current();
    (0..count).map(|_| next()).collect()
}

/// `check` for `cases` values of a strategy, as [`proptest_config`] has it, where a test collects
/// what it saw: the macro `proptest!` has no room for that.
pub fn for_all<S: Strategy>(cases: u32, strategy: &S, check: impl Fn(S::Value)) {
    let done = TestRunner::new(proptest_config(cases)).run(strategy, |value| {
        check(value);
        Ok(())
    });
    done.unwrap_or_else(|failure| panic!("{failure}"));
}

/// The settings of proptest here: the same inputs in every run unless `PROPTEST_RNG_SEED` says
/// otherwise, and no files of failures beside the sources.
pub fn proptest_config(cases: u32) -> ProptestConfig {
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::default() };
    let chosen = std::env::var_os("PROPTEST_CASES").is_some();
    let rng_seed = match config.rng_seed {
        RngSeed::Random => RngSeed::Fixed(8),
        fixed @ RngSeed::Fixed(_) => fixed,
    };
    ProptestConfig { cases: if chosen { config.cases } else { cases }, rng_seed, ..config }
}
