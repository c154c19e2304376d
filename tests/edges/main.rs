//! Where formulas break: zeros, infinities, NaN, subnormals, ends of ranges. Blends, metrics and
//! derivatives have edge cases of their own beside their tests.

mod beyond;
mod empty;
mod errors;
mod half_turn;
mod infinite;
mod parts;

use dq8::{DualQuat, Quat, geometry::DualVector, scalar::MatrixError};
use dq8_contract::bound::{Bound, within};
use dq8_contract::case::Case;
use dq8_contract::implementation::{On, implementations};
use dq8_contract::inputs::turn_and_move;
use dq8_contract::lanes::Motions;
use dq8_contract::operations::OPERATIONS;
use std::error::Error;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

/// A bound, times u.
fn allowed(on: On, bound: Bound) -> f64 {
    bound.units * on.roundoff()
}

/// The one motion that all lanes hold.
fn only(motion: Motions) -> [f64; 8] {
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
    for on in implementations() {
        let all = (1_u64 << on.lanes) - 1;
        for &motion in &bad {
            let sigma = on.same(motion);
            for (checked, unchecked) in [
                (sigma.normalize_checked(), sigma.normalize()),
                (sigma.inverse_checked(), sigma.inverse()),
            ] {
                assert_eq!(u64::from(checked.1), all, "{on:?}: {motion:?}");
                assert!(only(checked.0).iter().all(|c| c.is_nan()), "{on:?}: {motion:?}");
                let found = only(unchecked).iter().any(|c| !c.is_finite());
                assert!(found, "{on:?}: {motion:?} gives {unchecked:?}");
            }
        }
    }
}

#[test]
fn subnormal_and_huge_numbers_are_normalized_as_any_other() {
    let unit = turn_and_move([0.6, -0.48, 0.64], 1.0, [0.3, -1.2, 0.7]);
    for on in implementations() {
        let exponents = if on.single {
            vec![-40, -38, -30, -20, 0, 20, 30, 37]
        } else {
            vec![-318, -308, -200, 0, 200, 300, 307]
        };
        for exponent in exponents {
            // Not `powi`, which goes by way of 1e318.
            let size: f64 = format!("1e{exponent}").parse().expect("a number");
            let (normal, failed) = on.same(unit.map(|c| c * size)).normalize_checked();
            assert_eq!(failed, 0, "{on:?}, 1e{exponent}");
            // Subnormal numbers have fewer digits to begin with.
            let least = if on.single { 1.4e-45 } else { 4.9e-324 };
            let allowed = allowed(
                on,
                within(2.0, "as among the vectors: lengths neither overflow nor vanish"),
            ) + least / size;
            for (got, wanted) in only(normal).iter().zip(unit) {
                let error = (got - wanted).abs();
                assert!(error <= allowed, "{on:?}, 1e{exponent}: {got} is not {wanted}");
            }
        }
    }
}

#[test]
fn powers_of_tiny_screws_go_far_without_losing_the_angle() {
    for on in implementations() {
        let relative =
            allowed(on, within(5.5, "half the angle times t, which may be large, and its sine"));
        for (angle, t) in [(1e-3, 1e3), (1e-4, -1e4), (1e-6, 5e5), (1e-12, 1e11), (1e-3, 2.5)] {
            let sigma = on.same(turn_and_move([0.0, 0.0, 1.0], angle, [0.0, 0.0, angle]));
            let power = only(sigma.pow(on.splat(t)));
            let (half, slide) = (0.5 * angle * t, 0.5 * angle * t);
            let wanted = [half.sin(), half.cos(), slide * half.cos(), -slide * half.sin()];
            let got = [power[2], power[3], power[6], power[7]];
            for (got, wanted) in got.iter().zip(wanted) {
                let allowed = relative * wanted.abs().max(half.abs() * half.abs()).min(2.0) + 1e-38;
                let error = (got - wanted).abs();
                assert!(
                    error <= allowed.max(relative * 1e-3),
                    "{on:?}, {angle}^{t}: {got} {wanted}"
                );
            }
        }
    }
}

#[test]
fn the_longer_way_goes_round_and_ends_where_it_should() {
    for on in implementations() {
        let bound = allowed(on, within(6.5, "π − Θ, to 3 times of it"));
        // 3 radians of half angle: more than a quarter of a turn apart as quaternions.
        let (a, b) = (
            on.same(turn_and_move([0.0, 0.0, 1.0], 0.0, [0.0; 3])),
            on.same(turn_and_move([0.0, 0.0, 1.0], 4.0, [0.0; 3])),
        );
        for (t, angle) in [(0.0, 0.0), (0.25, 1.0), (0.5, 2.0), (1.0, 4.0), (1.5, 6.0)] {
            let got = only(a.sclerp_long(b, on.splat(t)));
            let (sin, cos) = (0.5_f64 * angle).sin_cos();
            let error = (got[2] - sin).abs().max((got[3] - cos).abs());
            assert!(error <= bound, "{on:?}, t = {t}: {got:?}");
        }
        // The way from σ to −σ has no axis.
        let lost = only(a.sclerp_long(-a, on.splat(0.5)));
        assert!(lost.iter().any(|c| c.is_nan()), "{on:?}: {lost:?}");
    }
}

#[test]
fn a_half_turn_has_a_logarithm_and_an_exponential() {
    for on in implementations() {
        for w in [0.0, -0.0] {
            let log = on.same([0.0, 0.0, 1.0, w, 0.0, 0.0, 0.0, 0.0]).log();
            let angle = log.real[2].first();
            let bound = allowed(on, within(1.25, "π/2, of which 1 ulp is 2 u"));
            assert!((angle - FRAC_PI_2).abs() <= bound, "{on:?}: {angle}");
            let zero = on.splat(0.0);
            let back = on.exp(DualVector { real: [zero, zero, on.splat(FRAC_PI_2)], ..log });
            let [.., z, w] = std::array::from_fn::<_, 4, _>(|i| only(back)[i]);
            let bound = allowed(on, within(3.0, "the sine of a rounded angle"));
            assert!((z - 1.0).abs() <= bound && w.abs() <= bound, "{on:?}: {z} {w}");
        }
    }
}

#[test]
fn exponentials_of_many_turns_are_as_good_as_the_angle_is_known() {
    for on in implementations() {
        let bound = allowed(on, within(1.0, "over the angle, which is rounded, and its square"));
        let zero = on.splat(0.0);
        for half in [1.0, PI, 10.0, 100.0, 1000.0] {
            let real = [zero, zero, on.splat(half)];
            let half = real[2].first();
            let got = only(on.exp(DualVector { real, dual: [zero; 3] }));
            let error = (got[2] - half.sin()).abs().max((got[3] - half.cos()).abs());
            assert!(error <= bound * half.max(1.0), "{on:?}, {half}: {error:e}");
        }
    }
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
    for on in implementations() {
        let bound =
            allowed(on, within(5.0, "rounded matrices; four ways to a quaternion, normalized"));
        for &[x, y, z, w] in &rotations {
            let rotation = Quat::from_xyzw(x, y, z, w).normalize();
            let exact = DualQuat::from_rotation_translation(rotation, [1.0, 2.0, 3.0]).canonical();
            let rows = exact.to_matrix3x4().map(|row| row.map(|c| on.splat(c)));
            let got = only(on.from_matrix3x4(rows));
            let wanted = exact.to_array();
            let apart = |sign: f64| {
                let pairs = got.iter().zip(wanted);
                pairs.map(|(a, b)| (a - sign * b).abs()).fold(0.0, f64::max)
            };
            assert!(got[3] >= 0.0 && apart(1.0).min(apart(-1.0)) <= bound, "{on:?}: {got:?}");
        }
    }
}

/// Exactly half a turn from another motion: neither way is shorter, and `sign` of the product is 0.
#[test]
fn at_half_a_turn_exactly_nothing_vanishes() {
    for on in implementations() {
        let a = [0.0, 0.0, 0.0, 1.0, 0.5, -1.0, 0.25, 0.0];
        for (direction, w) in [(1.0, 0.0), (-1.0, 0.0), (1.0, -0.0), (-1.0, -0.0)] {
            let b = [0.0, 0.0, direction, w, 2.0, 1.0, 0.0, -1.5];
            let (start, end) = (on.same(a), on.same(b));
            let half = on.splat(0.5);
            let way = "half a turn by its middle";
            let middles = [
                ("nlerp", within(2.5, "as dlb"), only(start.nlerp(end, half))),
                ("sclerp", within(2.5, way), only(start.sclerp(end, half))),
                ("sclerp_long", within(2.5, way), only(start.sclerp_long(end, half))),
                (
                    "dlb",
                    within(2.5, "as among the vectors"),
                    only(on.dlb(&[(start, half), (end, half)]).expect("two of them")),
                ),
            ];
            for (operation, bound, middle) in middles {
                let bound = allowed(on, bound);
                // A quarter of a turn about ±z, and no length gone.
                let wanted = [0.0, 0.0, direction * FRAC_1_SQRT_2, FRAC_1_SQRT_2];
                for (got, wanted) in middle.iter().zip(wanted) {
                    let error = (got - wanted).abs();
                    assert!(
                        error <= bound,
                        "{on:?}: {operation} gives {middle:?} between {a:?} {b:?}"
                    );
                }
                let along: f64 = (0..4).map(|i| middle[i] * middle[i + 4]).sum();
                assert!(along.abs() <= 4.0 * bound, "{on:?}: {operation} gives {middle:?}");
            }
            let bound = allowed(on, within(5.0, "interpolated with 0 or 1"));
            for (t, wanted) in [(0.0, a), (1.0, b)] {
                let t = on.splat(t);
                for got in [start.nlerp(end, t), start.sclerp(end, t), start.sclerp_long(end, t)] {
                    for (got, wanted) in only(got).iter().zip(wanted) {
                        assert!((got - wanted).abs() <= bound, "{on:?}: {got} {wanted}");
                    }
                }
            }
        }
    }
}

#[test]
fn weights_that_cancel_leave_nothing_to_normalize() {
    for on in implementations() {
        let motion = turn_and_move([0.6, -0.48, 0.64], 1.0, [0.3, -1.2, 0.7]);
        let (sigma, one) = (on.same(motion), on.splat(1.0));
        for other in [sigma, -sigma] {
            let gone = on.dlb(&[(sigma, one), (other, on.splat(-1.0))]).expect("two of them");
            assert!(only(gone).iter().all(|c| c.is_nan()), "{on:?}: {gone:?}");
        }
    }
}

#[test]
fn a_number_without_a_real_part_has_a_norm_of_nothing_and_is_not_unit() {
    for on in implementations() {
        let sigma = on.same([0.0, 0.0, -0.0, 0.0, 1.0, 2.0, 3.0, 4.0]);
        let [real, dual] = sigma.norm().map(|part| part.lanes());
        assert!(real.iter().all(|&r| r == 0.0) && dual.iter().all(|d| d.is_nan()), "{on:?}");
        for bad in [sigma, on.same([f64::NAN; 8]), on.same([f64::INFINITY; 8])] {
            assert_eq!(bad.is_unit(on.splat(0.5)), 0, "{on:?}: {bad:?}");
            assert_eq!(bad.abs_diff_eq(-bad, on.splat(0.5)), 0, "{on:?}: {bad:?}");
        }
    }
}

/// w is 0 or −0 at half a turn, and both are the same motion.
#[test]
fn zeros_of_either_sign_mean_the_same() {
    for on in implementations() {
        let c = turn_and_move([1.0, 2.0, 2.0], 0.5, [1.0, 2.0, 3.0]);
        let half_turn = |w| [0.6, 0.0, -0.8, w, 1.5, 2.0, 1.125, 0.25];
        let case = |w| Case { t: 0.75, s: 0.5, ..Case::of_motions(half_turn(w), half_turn(w), c) };
        for operation in OPERATIONS {
            let [plus, minus] = [0.0, -0.0].map(|w| operation.answer(on, &[case(w)]).lane(0));
            assert_eq!(plus, minus, "{on:?}: {}", operation.name);
        }
    }
}

#[test]
fn errors_name_what_is_wrong() {
    let zero = DualQuat::<f32>::ZERO;
    let error = zero.try_normalize().expect_err("zero has no direction");
    assert_eq!(error.real_norm, 0.0);
    assert_says(&error, "the norm of the real part is 0");
    let error = zero.try_inverse().expect_err("zero has no inverse");
    assert_eq!(error.real_norm, 0.0);
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

#[test]
fn directions_may_have_any_length() {
    let turn = |from: [f32; 3], to: [f32; 3]| Quat::from_rotation_arc(from, to);
    let wanted = turn([1.0, 1.0, 0.0], [1.0, 0.0, 0.0]);
    for size in [1e-45_f32, 1e-42, 1e-30, 1e30, 3e38] {
        let got = turn([size, size, 0.0], [1.0, 0.0, 0.0]);
        assert!(got.abs_diff_eq(wanted, 1.5 * f32::EPSILON), "{size}: {got:?}");
        let look = Quat::look_to([size, size, 0.0], [0.0, 0.0, 1.0]).expect("not dependent");
        let same = Quat::look_to([1.0, 1.0, 0.0], [0.0, 0.0, 1.0]).expect("not dependent");
        assert!(look.abs_diff_eq(same, 1.5 * f32::EPSILON), "{size}: {look:?}");
        let long = Quat::from_xyzw(size, size, 0.0, 0.0).try_normalize().expect("not zero");
        assert!(long.is_normalized(), "{size}: {long:?}");
    }
    let q = Quat::from_xyzw(4e-45_f32, 4e-45, 0.0, 0.0);
    let axis = DualQuat::new(Quat::IDENTITY, q).to_screw().axis;
    assert!((axis.direction[0] - FRAC_1_SQRT_2 as f32).abs() < 0.75 * f32::EPSILON, "{axis:?}");
}
