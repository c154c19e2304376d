//! Where formulas break: zeros, infinities, NaN, subnormals, ends of ranges. Blends, metrics and
//! derivatives have edge cases of their own beside their tests.

use dq8::{DualQuat, DualVector, InverseError, MatrixError, NormalizeError, Quat};
use dq8_contract::inputs::{Arguments, Case, NUMBERS, turn_and_move};
use dq8_contract::repertoire::{NAMES, answer};
use dq8_contract::{for_every_implementation, sample::Sample};
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};

/// Numbers that hurt.
const HARD: [f64; 14] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    1e-45,
    5e-324,
    1e-40,
    1e-20,
    1e20,
    3e38,
    1e308,
];

#[test]
fn no_operation_panics_on_any_numbers() {
    fn check<M: Sample>(_name: &str) {
        for start in 0..HARD.len() {
            for step in [1, 3, 5] {
                let at = |i: usize| HARD[(start + i * step + i / 8) % HARD.len()];
                let case = Case::of_numbers(&std::array::from_fn::<_, NUMBERS, _>(at));
                let arguments = Arguments::<M>::new(&[case]);
                for name in NAMES {
                    assert!(!answer(name, &arguments).lane(0).0.is_empty() || is_mask(name));
                }
            }
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

fn is_mask(name: &str) -> bool {
    matches!(name, "is_unit" | "abs_diff_eq")
}

fn splat<M: Sample>(motion: [f64; 8]) -> M {
    M::motion(motion.map(M::splat))
}

/// The one motion that all lanes hold.
fn only<M: Sample>(motion: M) -> [f64; 8] {
    let lanes = motion.scatter();
    for lane in &lanes {
        for (a, b) in lane.iter().zip(&lanes[0]) {
            assert!(a == b || a.is_nan() && b.is_nan(), "lanes differ: {lanes:?}");
        }
    }
    lanes[0]
}

#[test]
fn what_cannot_be_normalised_or_inverted_is_nan_and_said_to_be() {
    let mut bad = vec![[0.0; 8], [0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0]];
    for component in 0..8 {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut motion = [0.5, 0.5, 0.5, 0.5, 1.0, -1.0, 1.0, -1.0];
            motion[component] = value;
            bad.push(motion);
        }
    }
    fn check<M: Sample>(name: &str, bad: &[[f64; 8]]) {
        let all = (1_u64 << M::LANES) - 1;
        for &motion in bad {
            let sigma = splat::<M>(motion);
            for (checked, unchecked) in [
                (sigma.normalize_checked(), sigma.normalize()),
                (sigma.inverse_checked(), sigma.inverse()),
            ] {
                assert_eq!(u64::from(M::bits(checked.1)), all, "{name}: {motion:?}");
                assert!(only(checked.0).iter().all(|c| c.is_nan()), "{name}: {motion:?}");
                let found = only(unchecked).iter().any(|c| !c.is_finite());
                assert!(found, "{name}: {motion:?} gives {unchecked:?}");
            }
        }
    }
    for_every_implementation!(|name, M| check::<M>(name, &bad));
}

#[test]
fn subnormal_and_huge_numbers_are_normalised_as_any_other() {
    let unit = turn_and_move([0.6, -0.48, 0.64], 1.0, [0.3, -1.2, 0.7]);
    fn check<M: Sample>(name: &str, unit: [f64; 8]) {
        let (exponents, bound) = if M::SINGLE {
            (vec![-40, -38, -30, -20, 0, 20, 30, 37], 2e-7)
        } else {
            (vec![-318, -308, -200, 0, 200, 300, 307], 1e-15)
        };
        for exponent in exponents {
            // Not `powi`, which goes by way of 1e318.
            let size: f64 = format!("1e{exponent}").parse().expect("a number");
            let (normal, failed) = splat::<M>(unit.map(|c| c * size)).normalize_checked();
            assert_eq!(M::bits(failed), 0, "{name}, 1e{exponent}");
            // Subnormal numbers have fewer digits to begin with.
            let least = if M::SINGLE { 1.4e-45 } else { 4.9e-324 };
            let allowed = bound + least / size;
            for (got, wanted) in only(normal).iter().zip(unit) {
                let error = (got - wanted).abs();
                assert!(error <= allowed, "{name}, 1e{exponent}: {got} is not {wanted}");
            }
        }
    }
    for_every_implementation!(|name, M| check::<M>(name, unit));
}

#[test]
fn powers_of_tiny_screws_go_far_without_losing_the_angle() {
    fn check<M: Sample>(name: &str) {
        let relative = if M::SINGLE { 1e-6 } else { 2e-15 };
        for (angle, t) in [(1e-3, 1e3), (1e-4, -1e4), (1e-6, 5e5), (1e-12, 1e11), (1e-3, 2.5)] {
            let sigma = splat::<M>(turn_and_move([0.0, 0.0, 1.0], angle, [0.0, 0.0, angle]));
            let power = only(sigma.pow(M::splat(t)));
            let (half, slide) = (0.5 * angle * t, 0.5 * angle * t);
            let wanted = [half.sin(), half.cos(), slide * half.cos(), -slide * half.sin()];
            let got = [power[2], power[3], power[6], power[7]];
            for (got, wanted) in got.iter().zip(wanted) {
                let allowed = relative * wanted.abs().max(half.abs() * half.abs()).min(2.0) + 1e-38;
                let error = (got - wanted).abs();
                assert!(
                    error <= allowed.max(relative * 1e-3),
                    "{name}, {angle}^{t}: {got} {wanted}"
                );
            }
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

#[test]
fn interpolation_between_close_poses_goes_on_straight_beyond_both() {
    fn check<M: Sample>(name: &str) {
        let relative = if M::SINGLE { 2e-6 } else { 4e-15 };
        let a = splat::<M>(DualQuat::<f64>::IDENTITY.to_array());
        let b = splat::<M>(turn_and_move([0.0, 0.0, 1.0], 1e-4, [0.0, 0.0, 1e-4]));
        for t in [-1e4, -1.0, 0.5, 2.0, 1e4] {
            let half = 0.5 * 1e-4 * t;
            let got = only(a.sclerp(b, M::splat(t)));
            let error = (got[2] - half.sin()).abs();
            assert!(error <= relative * half.abs(), "{name}, t = {t}: {} {}", got[2], half.sin());
            let error = (got[6] - half * half.cos()).abs();
            assert!(error <= relative * half.abs(), "{name}, t = {t}: {}", got[6]);
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

#[test]
fn the_longer_way_goes_round_and_ends_where_it_should() {
    fn check<M: Sample>(name: &str) {
        let bound = if M::SINGLE { 4e-7 } else { 1e-15 };
        // 3 radians of half angle: more than a quarter of a turn apart as quaternions.
        let (a, b) = (
            splat::<M>(turn_and_move([0.0, 0.0, 1.0], 0.0, [0.0; 3])),
            splat::<M>(turn_and_move([0.0, 0.0, 1.0], 4.0, [0.0; 3])),
        );
        for (t, angle) in [(0.0, 0.0), (0.25, 1.0), (0.5, 2.0), (1.0, 4.0), (1.5, 6.0)] {
            let got = only(a.sclerp_long(b, M::splat(t)));
            let (sin, cos) = (0.5_f64 * angle).sin_cos();
            let error = (got[2] - sin).abs().max((got[3] - cos).abs());
            assert!(error <= bound, "{name}, t = {t}: {got:?}");
        }
        // The way from σ to −σ has no axis.
        let lost = only(a.sclerp_long(-a, M::splat(0.5)));
        assert!(lost.iter().any(|c| c.is_nan()), "{name}: {lost:?}");
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

#[test]
fn a_half_turn_has_a_logarithm_and_an_exponential() {
    fn check<M: Sample>(name: &str) {
        let bound = if M::SINGLE { 3e-7 } else { 1e-15 };
        for w in [0.0, -0.0] {
            let log = splat::<M>([0.0, 0.0, 1.0, w, 0.0, 0.0, 0.0, 0.0]).log();
            let angle = M::lanes(log.real[2])[0];
            assert!((angle - FRAC_PI_2).abs() <= bound, "{name}: {angle}");
            let zero = M::splat(0.0);
            let back = M::exp(DualVector { real: [zero, zero, M::splat(FRAC_PI_2)], ..log });
            let [.., z, w] = std::array::from_fn::<_, 4, _>(|i| only(back)[i]);
            assert!((z - 1.0).abs() <= bound && w.abs() <= bound, "{name}: {z} {w}");
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

#[test]
fn exponentials_of_many_turns_are_as_good_as_the_angle_is_known() {
    fn check<M: Sample>(name: &str) {
        let unit = if M::SINGLE { f64::from(f32::EPSILON) } else { f64::EPSILON };
        let zero = M::splat(0.0);
        for half in [1.0, PI, 10.0, 100.0, 1000.0] {
            let real = [zero, zero, M::splat(half)];
            let half = M::lanes(real[2])[0];
            let got = only(M::exp(DualVector { real, dual: [zero; 3] }));
            let error = (got[2] - half.sin()).abs().max((got[3] - half.cos()).abs());
            assert!(error <= 2.0 * unit * half.max(1.0), "{name}, {half}: {error:e}");
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

#[test]
fn every_form_of_a_matrix_and_the_ties_between_them_give_the_rotation() {
    // Each component largest in turn, and two, three and four of them equal.
    let mut rotations = Vec::new();
    for bits in 1..16_u32 {
        for sign in 0..16_u32 {
            let component = |i: u32| {
                let size = if bits >> i & 1 == 1 { 1.0 } else { 0.01 };
                if sign >> i & 1 == 1 { -size } else { size }
            };
            rotations.push([0, 1, 2, 3].map(component));
        }
    }
    fn check<M: Sample>(name: &str, rotations: &[[f64; 4]]) {
        let bound = if M::SINGLE { 1e-6 } else { 2e-15 };
        for &[x, y, z, w] in rotations {
            let rotation = Quat::from_xyzw(x, y, z, w).normalize();
            let exact = DualQuat::from_rotation_translation(rotation, [1.0, 2.0, 3.0]).canonical();
            let rows = exact.to_matrix3x4().map(|row| row.map(M::splat));
            let got = only(M::from_matrix3x4(rows));
            let wanted = exact.to_array();
            let apart = |sign: f64| {
                let pairs = got.iter().zip(wanted);
                pairs.map(|(a, b)| (a - sign * b).abs()).fold(0.0, f64::max)
            };
            assert!(got[3] >= 0.0 && apart(1.0).min(apart(-1.0)) <= bound, "{name}: {got:?}");
        }
    }
    for_every_implementation!(|name, M| check::<M>(name, &rotations));
}

#[test]
fn errors_name_what_is_wrong() {
    let zero = DualQuat::<f32>::ZERO;
    let error = zero.try_normalize().expect_err("zero has no direction");
    assert_eq!(error, NormalizeError { real_norm: 0.0 });
    assert_says(&error, "the norm of the real part is 0");
    let error = zero.try_inverse().expect_err("zero has no inverse");
    assert_eq!(error, InverseError { real_norm: 0.0 });
    assert_says(&error, "the norm of the real part is 0");

    let (x, y, z) = ([1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]);
    let try_rows = |rows| DualQuat::<f64>::try_from_matrix3x4(rows, 1e-9).expect_err("it is bad");
    let error = try_rows([x, y, [0.0, 0.0, -1.0, 0.0]]);
    assert_eq!(error, MatrixError::Mirrors { determinant: -1.0 });
    assert_says(&error, "determinant is -1");
    let error = try_rows([x, y, [0.5, 0.0, 1.0, 0.0]]);
    assert_says(&error, "rows 0 and 2 is 0.5");
    let error = try_rows([x, [0.0, 1.0, 0.0, f64::INFINITY], z]);
    assert_says(&error, "element 1 is inf");
    let error = try_rows([x, [0.0, f64::NAN, 0.0, 0.0], z]);
    assert_says(&error, "NaN");
    let error = DualQuat::try_from_matrix4([x, y, z, [0.0, 0.0, 0.5, 1.0]], 1e-9);
    assert_says(&error.expect_err("it is projective"), "element 2 of the last row is 0.5");
}

fn assert_says(error: &dyn Error, part: &str) {
    let text = error.to_string();
    assert!(text.contains(part), "«{text}» does not say «{part}»");
}
