//! Where formulas break: zeros, infinities, NaN, subnormals, ends of ranges. Blends, metrics and
//! derivatives have edge cases of their own beside their tests.

#[path = "edges/infinite.rs"]
mod infinite;

use dq8::{DualQuat, DualVector, InverseError, MatrixError, NormalizeError, Quat, Twist, Wrench};
use dq8_contract::inputs::{Arguments, Case, NUMBERS, proptest_config, turn_and_move};
use dq8_contract::repertoire::{NAMES, answer};
use dq8_contract::tolerance::{section, unit_roundoff};
use dq8_contract::{for_every_implementation, sample::Sample};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use std::error::Error;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

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

/// Any bits of the type, and among them numbers that hurt and ordinary ones.
fn any_number(single: bool) -> impl Strategy<Value = f64> {
    let bits = if single {
        any::<u32>().prop_map(|bits| f64::from(f32::from_bits(bits))).boxed()
    } else {
        any::<u64>().prop_map(f64::from_bits).boxed()
    };
    prop_oneof![2 => bits, 1 => prop::sample::select(HARD.to_vec()), 1 => -4.0..4.0_f64]
}

/// All methods of the contract and its operators, whatever they answer.
fn do_everything<M: Sample>(case: &Case) {
    let x = Arguments::<M>::new(&[*case]);
    for name in NAMES {
        let (numbers, masks) = answer(name, &x).lane(0);
        assert!(numbers.len() + masks.len() > 0);
    }
    let twist = Twist { angular: x.v, linear: x.w };
    let other = Twist { angular: x.weights, linear: x.v };
    let _ = (M::dlb(&[]), M::dlb_running(&x.influences()), M::dib(&x.influences(), x.tolerance, 3));
    let _ = (x.a.slerp_lerp(x.b, x.t), M::squad_control(x.a, x.b, x.c));
    let _ = (x.a.squad(x.b, x.c, x.b, x.t), x.a.angle_to(x.b), x.a.distance_to(x.b));
    let _ = (x.a.distance_weighted(x.b, x.s), x.a.point_error(x.b, x.v), x.a.shell_error(x.b, x.s));
    let _ = (x.a.needs_renormalization(x.tolerance), x.a.derivative_spatial(twist));
    let _ = (x.a.derivative_body(twist), x.a.spatial_twist(x.b), x.a.body_twist(x.b));
    let _ = (x.a.derivative_from_velocity(x.v, x.w), x.a.velocity(x.b));
    let _ = (M::from_twist(twist), x.a.to_twist(), x.a.integrate_spatial(twist, x.t));
    let _ = (x.a.integrate_body(twist, x.t), x.a.adjoint(twist));
    let _ = x.a.coadjoint(Wrench { torque: x.v, force: x.w });
    let _ = (M::left_jacobian(twist, other), M::right_jacobian(twist, other));
    let _ = (M::left_jacobian_inverse(twist, other), M::right_jacobian_inverse(twist, other));
}

#[test]
fn no_operation_panics_on_any_numbers() {
    fn check<M: Sample>() {
        let numbers = prop::collection::vec(any_number(M::SINGLE), NUMBERS);
        let done = TestRunner::new(proptest_config(64)).run(&numbers, |numbers| {
            let numbers = numbers.as_slice().try_into().expect("as many as were asked for");
            do_everything::<M>(&Case::of_numbers(numbers));
            Ok(())
        });
        done.unwrap_or_else(|failure| panic!("{failure}"));
    }
    for_every_implementation!(|_name, M| check::<M>());
}

fn splat<M: Sample>(motion: [f64; 8]) -> M {
    M::motion(motion.map(M::splat))
}

/// What the table allows, times u.
fn allowed<M: Sample>(op: &str, kind: &str) -> f64 {
    section("edges").line(op, kind).units * unit_roundoff(M::SINGLE)
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
fn what_cannot_be_normalized_or_inverted_is_nan_and_said_to_be() {
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
fn subnormal_and_huge_numbers_are_normalized_as_any_other() {
    let unit = turn_and_move([0.6, -0.48, 0.64], 1.0, [0.3, -1.2, 0.7]);
    fn check<M: Sample>(name: &str, unit: [f64; 8]) {
        let exponents = if M::SINGLE {
            vec![-40, -38, -30, -20, 0, 20, 30, 37]
        } else {
            vec![-318, -308, -200, 0, 200, 300, 307]
        };
        for exponent in exponents {
            // Not `powi`, which goes by way of 1e318.
            let size: f64 = format!("1e{exponent}").parse().expect("a number");
            let (normal, failed) = splat::<M>(unit.map(|c| c * size)).normalize_checked();
            assert_eq!(M::bits(failed), 0, "{name}, 1e{exponent}");
            // Subnormal numbers have fewer digits to begin with.
            let least = if M::SINGLE { 1.4e-45 } else { 4.9e-324 };
            let allowed = allowed::<M>("normalize", "any size") + least / size;
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
        let relative = allowed::<M>("pow", "tiny, far");
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
        let relative = allowed::<M>("sclerp", "tiny, far");
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
        let bound = allowed::<M>("sclerp_long", "long");
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
        for w in [0.0, -0.0] {
            let log = splat::<M>([0.0, 0.0, 1.0, w, 0.0, 0.0, 0.0, 0.0]).log();
            let angle = M::lanes(log.real[2])[0];
            let bound = allowed::<M>("log", "half turn");
            assert!((angle - FRAC_PI_2).abs() <= bound, "{name}: {angle}");
            let zero = M::splat(0.0);
            let back = M::exp(DualVector { real: [zero, zero, M::splat(FRAC_PI_2)], ..log });
            let [.., z, w] = std::array::from_fn::<_, 4, _>(|i| only(back)[i]);
            let bound = allowed::<M>("exp", "half turn");
            assert!((z - 1.0).abs() <= bound && w.abs() <= bound, "{name}: {z} {w}");
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

#[test]
fn exponentials_of_many_turns_are_as_good_as_the_angle_is_known() {
    fn check<M: Sample>(name: &str) {
        let bound = allowed::<M>("exp", "many turns");
        let zero = M::splat(0.0);
        for half in [1.0, PI, 10.0, 100.0, 1000.0] {
            let real = [zero, zero, M::splat(half)];
            let half = M::lanes(real[2])[0];
            let got = only(M::exp(DualVector { real, dual: [zero; 3] }));
            let error = (got[2] - half.sin()).abs().max((got[3] - half.cos()).abs());
            assert!(error <= bound * half.max(1.0), "{name}, {half}: {error:e}");
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
        let bound = allowed::<M>("from_matrix3x4", "ties");
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

/// Exactly half a turn from another motion: neither way is shorter, and `sign` of the product is 0.
#[test]
fn at_half_a_turn_exactly_nothing_vanishes() {
    fn check<M: Sample>(name: &str) {
        let a = [0.0, 0.0, 0.0, 1.0, 0.5, -1.0, 0.25, 0.0];
        for (direction, w) in [(1.0, 0.0), (-1.0, 0.0), (1.0, -0.0), (-1.0, -0.0)] {
            let b = [0.0, 0.0, direction, w, 2.0, 1.0, 0.0, -1.5];
            let (start, end) = (splat::<M>(a), splat::<M>(b));
            let half = M::splat(0.5);
            let middles = [
                ("nlerp", only(start.nlerp(end, half))),
                ("sclerp", only(start.sclerp(end, half))),
                ("sclerp_long", only(start.sclerp_long(end, half))),
                ("dlb", only(M::dlb(&[(start, half), (end, half)]).expect("two of them"))),
            ];
            for (operation, middle) in middles {
                let bound = allowed::<M>(operation, "half turn");
                // A quarter of a turn about ±z, and no length gone.
                let wanted = [0.0, 0.0, direction * FRAC_1_SQRT_2, FRAC_1_SQRT_2];
                for (got, wanted) in middle.iter().zip(wanted) {
                    let error = (got - wanted).abs();
                    assert!(
                        error <= bound,
                        "{name}: {operation} gives {middle:?} between {a:?} {b:?}"
                    );
                }
                let along: f64 = (0..4).map(|i| middle[i] * middle[i + 4]).sum();
                assert!(along.abs() <= 4.0 * bound, "{name}: {operation} gives {middle:?}");
            }
            let bound = allowed::<M>("ends", "half turn");
            for (t, wanted) in [(0.0, a), (1.0, b)] {
                let t = M::splat(t);
                for got in [start.nlerp(end, t), start.sclerp(end, t), start.sclerp_long(end, t)] {
                    for (got, wanted) in only(got).iter().zip(wanted) {
                        assert!((got - wanted).abs() <= bound, "{name}: {got} {wanted}");
                    }
                }
            }
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

#[test]
fn weights_that_cancel_leave_nothing_to_normalize() {
    fn check<M: Sample>(name: &str) {
        let motion = turn_and_move([0.6, -0.48, 0.64], 1.0, [0.3, -1.2, 0.7]);
        let (sigma, one) = (splat::<M>(motion), M::splat(1.0));
        for other in [sigma, -sigma] {
            let gone = M::dlb(&[(sigma, one), (other, M::splat(-1.0))]).expect("two of them");
            assert!(only(gone).iter().all(|c| c.is_nan()), "{name}: {gone:?}");
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

#[test]
fn a_number_without_a_real_part_has_a_norm_of_nothing_and_is_not_unit() {
    fn check<M: Sample>(name: &str) {
        let sigma = splat::<M>([0.0, 0.0, -0.0, 0.0, 1.0, 2.0, 3.0, 4.0]);
        let [real, dual] = M::dual_parts(sigma.norm()).map(M::lanes);
        assert!(real.iter().all(|&r| r == 0.0) && dual.iter().all(|d| d.is_nan()), "{name}");
        for bad in [sigma, splat::<M>([f64::NAN; 8]), splat::<M>([f64::INFINITY; 8])] {
            assert_eq!(M::bits(bad.is_unit(M::splat(0.5))), 0, "{name}: {bad:?}");
            assert_eq!(M::bits(bad.abs_diff_eq(-bad, M::splat(0.5))), 0, "{name}: {bad:?}");
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

/// w is 0 or −0 at half a turn, and both are the same motion.
#[test]
fn zeros_of_either_sign_mean_the_same() {
    fn check<M: Sample>(name: &str) {
        let half_turn = |w| [0.6, 0.0, -0.8, w, 1.5, 2.0, 1.125, 0.25];
        let case =
            |w| Case { t: 0.75, s: 0.5, ..Case::of_motions(half_turn(w), half_turn(w), [1.0; 8]) };
        let [plus, minus] = [0.0, -0.0].map(|w| Arguments::<M>::new(&[case(w)]));
        for operation in NAMES {
            let [plus, minus] = [&plus, &minus].map(|x| answer(operation, x).lane(0));
            assert_eq!(plus, minus, "{name}: {operation}");
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
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
