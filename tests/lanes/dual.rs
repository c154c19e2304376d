//! Functions of dual numbers: value and derivative.

use super::{Provable, lane, lanes, measure};
use dq8::{Real, batch, scalar};
use dq8_contract::ledger::{Ledger, Line, line};
use dq8_contract::on_every_lane_type;
use std::f64::consts::{FRAC_PI_2, PI};

/// About 1.6 times the worst, relative to the value and to the derivative, or to 1/1000 where they
/// vanish. The second opinion is the scalar reference in `f64`, itself half a unit off.
#[rustfmt::skip]
const FUNCTIONS: &[Line] = &[
    line("sin", &[], 4.5, "two polynomials and the rounding of the angle that is left"),
    line("cos", &[], 5.0, "as the sine"),
    line("tan", &[], 9.0, "a quotient of both"),
    line("asin", &[], 4.5, "a root, a polynomial and a difference"),
    line("acos", &[], 4.0, "as the arcsine"),
    line("atan", &[], 5.0, "a root, two quotients and a polynomial"),
    line("atan2", &[], 6.0, "as the arctangent; the derivative cancels"),
    line("exp", &[], 4.0, "a power series"),
    line("ln", &[], 4.0, "a power series and a sum"),
    line("sqrt", &[], 3.5, "a root and a quotient"),
    line("powi", &[], 9.0, "five products"),
    line("recip", &[], 5.0, "a quotient and its square"),
];

type Double = scalar::Dual<f64>;
type Function<N> = fn(N) -> N;
type Functions<L> = Vec<(&'static str, Function<Double>, Function<batch::Dual<L>>, Vec<f64>)>;

/// Every function by its name, of scalars in `f64` and of lanes, with the places to try it at.
fn functions<L: Provable>() -> Functions<L> {
    use batch::Dual;
    let angles = places(-4.0, 4.0);
    let sines = places(-1.0, 1.0);
    let positive: Vec<_> = places(-30.0, 30.0).into_iter().map(f64::exp).collect();
    vec![
        ("sin", Double::sin, Dual::sin, angles.clone()),
        ("cos", Double::cos, Dual::cos, angles.clone()),
        ("tan", Double::tan, Dual::tan, angles),
        ("asin", Double::asin, Dual::asin, sines.clone()),
        ("acos", Double::acos, Dual::acos, sines),
        ("atan", Double::atan, Dual::atan, places(-9.0, 9.0)),
        ("exp", Double::exp, Dual::exp, places(-80.0, 80.0)),
        ("ln", Double::ln, Dual::ln, [positive.clone(), places(0.5, 2.0)].concat()),
        ("sqrt", Double::sqrt, Dual::sqrt, positive.clone()),
        ("recip", Double::recip, Dual::recip, positive),
        ("powi", |x| x.powi(5), |x| x.powi(5), places(-3.0, 3.0)),
        ("powi", |x| x.powi(-3), |x| x.powi(-3), places(0.1, 9.0)),
    ]
}

/// Numbers spread over an interval, at no round steps.
fn places(from: f64, to: f64) -> Vec<f64> {
    (1..=400).map(|i| from + (to - from) * (f64::from(i) * 0.618_033_988_749_895).fract()).collect()
}

/// What lanes of this number make of it.
fn as_stored<L: Provable>(number: f64) -> f64 {
    <L::Real as Real>::from_f64(number).into()
}

fn functions_agree<L: Provable>(ledger: &Ledger) {
    for (name, by_the_book, on_lanes, places) in functions::<L>() {
        for chunk in places.chunks(L::LANES) {
            let slopes: Vec<_> = (0..chunk.len()).map(|i| 1.5 - i as f64 / 4.0).collect();
            let found = on_lanes(batch::Dual::new(lanes(chunk), lanes(&slopes)));
            for (index, (&x, &slope)) in chunk.iter().zip(&slopes).enumerate() {
                let wanted = by_the_book(scalar::Dual::new(as_stored::<L>(x), slope));
                let got = [lane(found.real, index), lane(found.dual, index)];
                for (got, wanted) in [(got[0], wanted.real), (got[1], wanted.dual)] {
                    measure::<L, 1>(
                        ledger,
                        (name, ""),
                        [got],
                        [wanted],
                        wanted.abs().max(1e-3),
                        &x,
                    );
                }
            }
        }
    }
    let turns = places(-PI, PI);
    for (chunk, sizes) in turns.chunks(L::LANES).zip(places(-60.0, 60.0).chunks(L::LANES)) {
        let point = |i: usize| (chunk[i].sin() * sizes[i].exp(), chunk[i].cos() * sizes[i].exp());
        let (up, along): (Vec<_>, Vec<_>) = (0..chunk.len()).map(point).unzip();
        // The point moves by its own length.
        let moved: Vec<_> = sizes.iter().map(|s| s.exp()).collect();
        let x = batch::Dual::new(lanes::<L>(&along), lanes(&moved));
        let found = batch::Dual::new(lanes::<L>(&up), lanes(&moved)).atan2(x);
        for index in 0..chunk.len() {
            let number =
                |real: f64| scalar::Dual::new(as_stored::<L>(real), as_stored::<L>(moved[index]));
            let wanted = Real::atan2(number(up[index]), number(along[index]));
            let got = [lane(found.real, index), lane(found.dual, index)];
            let case = (up[index], along[index]);
            measure::<L, 1>(
                ledger,
                ("atan2", ""),
                [got[0]],
                [wanted.real],
                wanted.real.abs(),
                &case,
            );
            measure::<L, 1>(ledger, ("atan2", ""), [got[1]], [wanted.dual], 1.0, &case);
        }
    }
}

#[test]
fn functions_of_dual_numbers_on_lanes_are_those_of_the_scalar_ones() {
    Ledger::keep("functions of dual numbers", FUNCTIONS, |ledger| {
        on_every_lane_type!(functions_agree(ledger));
    });
}

/// Values at the edges, the same as the scalar functions of the same precision give.
fn edges_agree<L: Provable>() {
    let tiny = if <L::Real as Real>::EPSILON.into() > 1e-10 { 1e-40 } else { 1e-310 };
    let edges = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        tiny,
        -tiny,
        2.0,
        -2.0,
        1e30,
        -1e30,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ];
    // Beyond the range in which an angle is known, lanes have no sine.
    let known =
        |name: &str, x: f64| !["sin", "cos", "tan"].contains(&name) || x.is_nan() || x.abs() <= 1e5;
    for (name, by_the_book, on_lanes, _) in functions::<L>() {
        for x in edges.into_iter().filter(|&x| known(name, x)) {
            let found = lane(on_lanes(batch::Dual::new(lanes::<L>(&[x]), lanes(&[0.0]))).real, 0);
            let wanted = by_the_book(scalar::Dual::new(as_stored::<L>(x), 0.0)).real;
            let wanted = as_stored::<L>(wanted);
            let close = (found - wanted).abs() <= 8.0 * super::roundoff::<L>() * wanted.abs();
            let same = found == wanted || found.is_nan() && wanted.is_nan() || close;
            assert!(same, "{name}({x:e}) is {found:e}, by the book {wanted:e}");
            if wanted == 0.0 {
                assert_eq!(found.is_sign_negative(), wanted.is_sign_negative(), "{name}({x:e})");
            }
        }
    }
    for y in edges {
        for x in edges {
            let number = |real: f64| batch::Dual::new(lanes::<L>(&[real]), lanes(&[0.0]));
            let found = lane(number(y).atan2(number(x)).real, 0);
            let wanted = as_stored::<L>(y).atan2(as_stored::<L>(x));
            let close = (found - wanted).abs() <= 8.0 * super::roundoff::<L>() * wanted.abs();
            let same = found == wanted || found.is_nan() && wanted.is_nan() || close;
            // What is below the smallest number of the lanes is zero to them.
            let vanishes = found == 0.0 && wanted.abs() < 1e-30;
            assert!(same || vanishes, "atan2({y:e}, {x:e}) is {found:e}, by the book {wanted:e}");
        }
    }
}

#[test]
fn functions_of_dual_numbers_have_the_values_of_the_scalar_ones_at_the_edges() {
    on_every_lane_type!(edges_agree());
}

fn exponentials_keep_their_range<L: Provable>() {
    let single = <L::Real as Real>::EPSILON.into() > 1e-10;
    let (smallest, largest) = if single { (-103.0, 88.7) } else { (-745.0, 709.7) };
    for i in 0..=1000 {
        let x = as_stored::<L>(smallest + (largest - smallest) * f64::from(i) / 1000.0);
        let found = batch::Dual::new(lanes::<L>(&[x]), lanes(&[0.0])).exp();
        let (found, wanted) = (lane(found.real, 0), x.exp());
        // The last place of subnormal numbers is that of the smallest.
        let last = if single { f64::from(f32::from_bits(1)) } else { f64::from_bits(1) };
        assert!((found - wanted).abs() <= 4.0 * super::roundoff::<L>() * wanted + last, "exp {x}");
        let back = batch::Dual::new(lanes::<L>(&[found]), lanes(&[0.0])).ln();
        let (back, wanted) = (lane(back.real, 0), found.ln());
        let close = (back - wanted).abs() <= 4.0 * super::roundoff::<L>() * wanted.abs();
        assert!(close, "ln {found:e} is {back}, not {wanted}");
    }
}

#[test]
fn exponentials_and_logarithms_reach_over_all_numbers() {
    on_every_lane_type!(exponentials_keep_their_range());
}

fn far_angles<L: Provable>() {
    let single = <L::Real as Real>::EPSILON.into() > 1e-10;
    for i in 1..=4000 {
        let x = as_stored::<L>(f64::from(i) * 16.377);
        let found = batch::Dual::new(lanes::<L>(&[x]), lanes(&[1.0])).sin();
        let [sin, cos] = [lane(found.real, 0), lane(found.dual, 0)];
        let error = (sin - x.sin()).abs().max((cos - x.cos()).abs());
        assert!(error <= 4.0 * super::roundoff::<L>(), "sin {x}: {error:e}");
    }
    let beyond = if single { 65_537.0 } else { 35_184_372_088_833.0 };
    let found = batch::Dual::new(lanes::<L>(&[beyond]), lanes(&[1.0]));
    assert!(lane(found.sin().real, 0).is_nan() && lane(found.tan().real, 0).is_nan());
}

#[test]
fn sines_of_far_angles_are_as_good_as_near_ones_and_nan_beyond_the_range() {
    on_every_lane_type!(far_angles());
}

/// a⁰ = 1, also of 0; powers of 0 have no NaN for a derivative.
fn powers_of_zero<L: Provable>() {
    let zero = batch::Dual::new(lanes::<L>(&[0.0]), lanes(&[1.0]));
    for (n, wanted) in [(0, [1.0, 0.0]), (1, [0.0, 1.0]), (2, [0.0, 0.0]), (7, [0.0, 0.0])] {
        let found = zero.powi(n);
        assert_eq!([lane(found.real, 0), lane(found.dual, 0)], wanted, "0 to the power {n}");
        let scalar = scalar::Dual::new(0.0, 1.0).powi(n);
        assert_eq!([scalar.real, scalar.dual], wanted, "0 to the power {n}");
    }
}

#[test]
fn powers_of_zero_are_zero_and_one() {
    on_every_lane_type!(powers_of_zero());
}

/// The derivative, by differences: what a mistake in both twins would not survive.
#[test]
fn derivatives_are_limits_of_differences() {
    for (name, _, on_lanes, places) in functions::<f64>() {
        for x in places.into_iter().filter(|x| x.abs() < 20.0 && (x.abs() - FRAC_PI_2).abs() > 0.1)
        {
            let at = |x: f64| on_lanes(batch::Dual::new(x, 1.0));
            let h = 1e-5 * x.abs().min(1.0);
            let slope = (at(x + h).real - at(x - h).real) / (h + h);
            // Next to the ends of the arcsine the differences are no limits yet.
            if name.starts_with('a') && x.abs() > 0.99 {
                continue;
            }
            let error = (at(x).dual - slope).abs() / (1.0 + slope.abs());
            // h² times a third derivative, next to the ends and poles of some thousands.
            assert!(error < 1e-5, "{name} at {x}: {} and {slope}", at(x).dual);
        }
    }
}

fn what_has_no_inverse_is_told<L: Provable>() {
    for real in [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, 1.0, -4.0] {
        let (inverse, failed) =
            batch::Dual::new(lanes::<L>(&[real]), lanes(&[2.0])).inverse_checked();
        let none = real == 0.0 || !real.is_finite();
        assert_eq!(super::holds(failed, 0), none, "{real}");
        let wanted = if none { [f64::NAN; 2] } else { [1.0 / real, -2.0 / (real * real)] };
        for (found, wanted) in
            [lane(inverse.real, 0), lane(inverse.dual, 0)].into_iter().zip(wanted)
        {
            assert!(found == wanted || found.is_nan() && wanted.is_nan(), "{real}: {found}");
        }
    }
}

#[test]
fn dual_numbers_without_an_inverse_have_a_mask_and_nan() {
    on_every_lane_type!(what_has_no_inverse_is_told());
}
