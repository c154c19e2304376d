//! Functions of dual numbers at the edges. (`oracle` has value and derivative elsewhere, `sweep`
//! every `f32`.)

use super::{Provable, lane, lanes};
use dq8::{Real, batch, scalar};
use dq8_contract::bound::roundoff;
use dq8_contract::on_every_lane_type;

type Double = scalar::Dual<f64>;
type Function<N> = fn(N) -> N;
type Functions<L> = [(&'static str, Function<Double>, Function<batch::Dual<L>>); 12];

/// Every function by its name, of scalars in `f64` and of lanes.
fn functions<L: Provable>() -> Functions<L> {
    use batch::Dual;
    [
        ("sin", Double::sin, Dual::sin),
        ("cos", Double::cos, Dual::cos),
        ("tan", Double::tan, Dual::tan),
        ("asin", Double::asin, Dual::asin),
        ("acos", Double::acos, Dual::acos),
        ("atan", Double::atan, Dual::atan),
        ("exp", Double::exp, Dual::exp),
        ("ln", Double::ln, Dual::ln),
        ("sqrt", Double::sqrt, Dual::sqrt),
        ("recip", Double::recip, Dual::recip),
        ("powi", |x| x.powi(5), |x| x.powi(5)),
        ("powi", |x| x.powi(-3), |x| x.powi(-3)),
    ]
}

/// What lanes of this number make of it.
fn as_stored<L: Provable>(number: f64) -> f64 {
    <L::Real as Real>::from_f64(number).into()
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
    for (name, by_the_book, on_lanes) in functions::<L>() {
        for x in edges.into_iter().filter(|&x| known(name, x)) {
            let found = lane(on_lanes(batch::Dual::new(lanes::<L>(&[x]), lanes(&[0.0]))).real, 0);
            let wanted = by_the_book(scalar::Dual::new(as_stored::<L>(x), 0.0)).real;
            let wanted = as_stored::<L>(wanted);
            let close = (found - wanted).abs() <= 8.0 * roundoff::<L::Real>() * wanted.abs();
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
            let close = (found - wanted).abs() <= 8.0 * roundoff::<L::Real>() * wanted.abs();
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
        assert!((found - wanted).abs() <= 4.0 * roundoff::<L::Real>() * wanted + last, "exp {x}");
        let back = batch::Dual::new(lanes::<L>(&[found]), lanes(&[0.0])).ln();
        let (back, wanted) = (lane(back.real, 0), found.ln());
        let close = (back - wanted).abs() <= 4.0 * roundoff::<L::Real>() * wanted.abs();
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
        assert!(error <= 4.0 * roundoff::<L::Real>(), "sin {x}: {error:e}");
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
