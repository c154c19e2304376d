//! Inputs for the generic tests: edge cases, evenly spaced ones and random ones, as the tests of
//! Rust's `libm` have them. Everything here is `f64`; implementations round it to their own type.

use crate::sample::Sample;
use dq8::{DualQuat, DualVector, Line, Plane, Quat, Screw};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngAlgorithm, RngSeed, TestRng, TestRunner};
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// One element of input: what any operation of the contract may ask for.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    pub a: [f64; 8],
    pub b: [f64; 8],
    pub c: [f64; 8],
    pub s: f64,
    pub t: f64,
    pub v: [f64; 3],
    pub w: [f64; 3],
    pub weights: [f64; 3],
    pub tolerance: f64,
    /// For `from_matrix3x4`.
    pub rows: [[f64; 4]; 3],
    /// For `from_screw`: direction, moment, angle, slide.
    pub screw: [f64; 8],
}

/// How many numbers a [`Case`] holds.
pub const NUMBERS: usize = 56;

impl Case {
    /// Any numbers at all.
    pub fn of_numbers(numbers: &[f64; NUMBERS]) -> Self {
        let mut rest = numbers.iter().copied();
        let mut next = || rest.next().expect("as many numbers as a case holds");
        Self {
            a: std::array::from_fn(|_| next()),
            b: std::array::from_fn(|_| next()),
            c: std::array::from_fn(|_| next()),
            s: next(),
            t: next(),
            v: std::array::from_fn(|_| next()),
            w: std::array::from_fn(|_| next()),
            weights: std::array::from_fn(|_| next()),
            tolerance: next(),
            rows: std::array::from_fn(|_| std::array::from_fn(|_| next())),
            screw: std::array::from_fn(|_| next()),
        }
    }

    /// Motions that are unit, with the matrix and the screw of `a`.
    pub fn of_motions(a: [f64; 8], b: [f64; 8], c: [f64; 8]) -> Self {
        let sigma = DualQuat::from_array(a);
        let screw = sigma.to_screw();
        let ([l0, l1, l2], [m0, m1, m2]) = (screw.axis.direction, screw.axis.moment);
        Self {
            a,
            b,
            c,
            s: 0.75,
            t: 0.25,
            v: [0.5, -1.5, 2.0],
            w: [-3.0, 0.25, 1.0],
            weights: [0.5, 0.25, 0.25],
            tolerance: 1e-3,
            rows: sigma.to_matrix3x4(),
            screw: [l0, l1, l2, m0, m1, m2, screw.angle, screw.slide],
        }
    }
}

/// [`Case`]s dealt out to the lanes of an implementation.
#[derive(Clone, Copy, Debug)]
pub struct Arguments<M: Sample> {
    pub a: M,
    pub b: M,
    pub c: M,
    pub s: M::Real,
    pub t: M::Real,
    pub v: [M::Real; 3],
    pub w: [M::Real; 3],
    pub weights: [M::Real; 3],
    pub tolerance: M::Real,
    pub rows: [[M::Real; 4]; 3],
    pub screw: Screw<M::Real>,
}

impl<M: Sample> Arguments<M> {
    /// Lane `i` from case `i`; lanes without a case repeat the first.
    pub fn new(cases: &[Case]) -> Self {
        let column = |pick: &dyn Fn(&Case) -> f64| {
            let lane = |i| pick(cases.get(i).unwrap_or(&cases[0]));
            M::real(&(0..M::LANES).map(lane).collect::<Vec<_>>())
        };
        let triple =
            |pick: fn(&Case) -> [f64; 3]| std::array::from_fn(|i| column(&|case| pick(case)[i]));
        let motion = |pick: fn(&Case) -> [f64; 8]| {
            M::motion(std::array::from_fn(|i| column(&|case| pick(case)[i])))
        };
        let screw: [M::Real; 8] = std::array::from_fn(|i| column(&|case| case.screw[i]));
        let [l0, l1, l2, m0, m1, m2, angle, slide] = screw;
        Self {
            a: motion(|case| case.a),
            b: motion(|case| case.b),
            c: motion(|case| case.c),
            s: column(&|case| case.s),
            t: column(&|case| case.t),
            v: triple(|case| case.v),
            w: triple(|case| case.w),
            weights: triple(|case| case.weights),
            tolerance: column(&|case| case.tolerance),
            rows: std::array::from_fn(|r| std::array::from_fn(|c| column(&|case| case.rows[r][c]))),
            screw: Screw {
                axis: Line { direction: [l0, l1, l2], moment: [m0, m1, m2] },
                angle,
                slide,
            },
        }
    }

    /// The three motions normalized, for the laws of unit ones.
    #[must_use]
    pub fn unit(self) -> Self {
        let (a, b, c) = (self.a.normalize(), self.b.normalize(), self.c.normalize());
        Self { a, b, c, ..self }
    }

    pub fn line(&self) -> Line<M::Real> {
        Line { direction: self.v, moment: self.w }
    }

    pub fn plane(&self) -> Plane<M::Real> {
        Plane { normal: self.v, offset: self.s }
    }

    pub fn dual_vector(&self) -> DualVector<M::Real> {
        DualVector { real: self.v, dual: self.w }
    }

    pub fn influences(&self) -> [(M, M::Real); 3] {
        let [wa, wb, wc] = self.weights;
        [(self.a, wa), (self.b, wb), (self.c, wc)]
    }
}

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

/// Interpolation parameters and exponents: inside [0, 1], its ends, and beyond. Multiples of 2⁻¹⁰,
/// so that sums of two are exact in every type.
pub fn parameter() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (0..=1024_i32).prop_map(|i| f64::from(i) / 1024.0),
        1 => (-2048..=3072_i32).prop_map(|i| f64::from(i) / 1024.0),
    ]
}

/// A case of motions that `motion` makes.
pub fn case(motion: impl Strategy<Value = [f64; 8]>) -> impl Strategy<Value = Case> {
    let numbers = (parameter(), parameter(), vector(), vector());
    let weights = prop::array::uniform3(0.0625..1.0_f64);
    (prop::array::uniform3(motion), numbers, weights).prop_map(
        |([a, b, c], (s, t, v, w), weights)| Case {
            s,
            t,
            v,
            w,
            weights,
            ..Case::of_motions(a, b, c)
        },
    )
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
        rows: edge.rows,
        screw: edge.screw,
        ..*random
    });
    numbered.collect::<Vec<_>>().into_iter().chain(random.iter().copied()).collect()
}

/// The unit cases and others that are no motions.
pub fn general_cases() -> Vec<Case> {
    let mut cases = unit_cases();
    cases.extend(draw(case(general_motion()), 256));
    cases
}

/// The first `count` values of a strategy, the same ones in every run.
fn draw<S: Strategy>(strategy: S, count: usize) -> Vec<S::Value> {
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(ProptestConfig::default(), rng);
    let mut next = || strategy.new_tree(&mut runner).expect("filters are mild").current();
    (0..count).map(|_| next()).collect()
}

/// `check` for `cases` values of a strategy, as [`proptest_config`] has it, where a test collects what
/// it saw: the macro `proptest!` has no room for that.
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
