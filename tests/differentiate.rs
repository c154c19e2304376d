//! Dual numbers as `Real`: what is written for every `R: Real` differentiates itself.

use dq8::{Dual, DualQuat, Line, Quat, Real, Twist, geometry::Screw};

/// Numbers of about 1, a few operations on each side.
const LAST_BITS: f64 = 1e-15;
/// A motion by a few lengths.
const OF_A_LENGTH: f64 = 4e-15;
/// A difference with h = 10⁻³ leaves terms of h⁴, and divides roundoff by h.
const OF_FOURTH_ORDER: f64 = 1e-10;
/// A difference with h = 10⁻⁴ leaves terms of h², and divides roundoff by h.
const OF_SECOND_ORDER: f64 = 1e-6;

type Hyper = Dual<Dual<f64>>;

fn constant<R: Real, const N: usize>(values: [f64; N]) -> [R; N] {
    values.map(R::from_f64)
}

/// A motion that depends on a parameter in every way the algebra offers: turn, screw, blend.
fn motion<R: Real>(t: R) -> DualQuat<R> {
    let turn = Quat::from_axis_angle(constant([0.6, 0.0, 0.8]), t * R::from_f64(1.3));
    let moving = DualQuat::from_rotation_translation(turn, [t, t * t, t.sin()]);
    let twist = Twist {
        angular: [R::from_f64(0.1), t.cos(), R::from_f64(0.4)],
        linear: [R::from_f64(1.0), t.exp(), R::from_f64(-2.0)],
    };
    let still = DualQuat::from_twist(twist);
    moving.sclerp(still * moving, t).nlerp(still.pow(t), R::from_f64(0.25)).normalize()
}

/// f(x + ε) = f(x) + εf′(x), the derivative by central differences of fourth order.
#[test]
fn every_operation_differentiates_itself() {
    let difference = |t: f64, h: f64| {
        let at = |s: f64| motion(t + s * h).to_array();
        let (a, b, c, d) = (at(-2.0), at(-1.0), at(1.0), at(2.0));
        core::array::from_fn::<f64, 8, _>(|i| (a[i] - d[i] + 8.0 * (c[i] - b[i])) / (12.0 * h))
    };
    for step in 1..=20 {
        let t = 0.05 * f64::from(step);
        let dual = motion(Dual::new(t, 1.0)).to_array();
        let (value, by_difference) = (motion(t).to_array(), difference(t, 1e-3));
        for i in 0..8 {
            assert!((dual[i].real - value[i]).abs() < LAST_BITS, "{t}: component {i}");
            let error = dual[i].dual - by_difference[i];
            assert!(
                error.abs() < OF_FOURTH_ORDER,
                "{t}: derivative of component {i} is off by {error}"
            );
        }
    }
}

/// Hyper-dual numbers, ε₁ and ε₂ both 1, give the second derivative at ε₁ε₂.
#[test]
fn dual_numbers_of_dual_numbers_give_second_derivatives() {
    for step in 1..=20 {
        let t = 0.05 * f64::from(step);
        let x = Hyper::new(Dual::new(t, 1.0), Dual::new(1.0, 0.0));
        let slope = |t: f64| motion(Dual::new(t, 1.0)).to_array().map(|c| c.dual);
        let h = 1e-4;
        let (before, after) = (slope(t - h), slope(t + h));
        for (i, component) in motion(x).to_array().into_iter().enumerate() {
            assert_eq!(component.real.dual, component.dual.real, "both first derivatives");
            let error = component.dual.dual - (after[i] - before[i]) / (2.0 * h);
            assert!(error.abs() < OF_SECOND_ORDER, "{t}: second derivative {i} is off by {error}");
        }
    }
}

#[test]
fn a_dual_number_whose_real_part_is_infinitesimal_has_no_inverse() {
    for real in [Dual::EPSILON, -Dual::EPSILON, Dual::ZERO, Dual::new(f64::NAN, 0.0)] {
        assert!(Dual::new(real, Dual::ONE).inverse().is_err(), "{real:?}");
    }
    let tiny = Dual::new(Dual::new(f64::from_bits(1), 0.0), Dual::ZERO);
    assert!(tiny.inverse().is_ok(), "as of the smallest float");
}

/// The derivative of a motion by `derivative_spatial` is what differentiating `from_twist` gives.
#[test]
fn twists_are_what_differentiation_finds() {
    let twist = Twist { angular: [0.3, -1.1, 0.7], linear: [2.0, 0.5, -1.0] };
    for t in [1e-9, 0.4, 1.0, 2.5] {
        let time = Dual::new(t, 1.0);
        let path = DualQuat::from_twist(Twist::from_array(
            twist.to_array().map(|c| Dual::new(c, 0.0) * time),
        ));
        let at = DualQuat::from_array(path.to_array().map(|c| c.real));
        let wanted = at.derivative_spatial(twist).to_array();
        for (found, wanted) in path.to_array().into_iter().zip(wanted) {
            assert!((found.dual - wanted).abs() < OF_A_LENGTH, "{t}: {} for {wanted}", found.dual);
        }
    }
}

/// A joint at rest: its derivative by its angle is half its axis, at zero as anywhere.
#[test]
fn joints_at_rest_have_derivatives() {
    let axis = Line { direction: constant([0.0, 0.6, 0.8]), moment: constant([2.0, 0.0, 0.0]) };
    let joint = Screw { axis, angle: Dual::new(0.0, 1.0), slide: Dual::new(0.0, 0.25) };
    let slope = DualQuat::from_screw(joint).to_array().map(|c| c.dual);
    assert_eq!(slope, [0.0, 0.3, 0.4, 0.0, 1.0, 0.075, 0.1, 0.0]);
}

/// Hyper-dual numbers have both first derivatives, and the second one, as tables do.
#[test]
fn functions_have_their_derivatives() {
    /// A name, the function, where, and its two derivatives there.
    type Case = (&'static str, fn(Hyper) -> Hyper, f64, [f64; 2]);
    let (sin, cos) = 0.7_f64.sin_cos();
    let (root, e) = (2.0_f64.sqrt(), 1.5_f64.exp());
    let cases: [Case; 12] = [
        ("sqrt", Real::sqrt, 2.0, [0.5 / root, -0.125 / root]),
        ("sin", Real::sin, 0.7, [cos, -sin]),
        ("cos", Real::cos, 0.7, [-sin, -cos]),
        ("tan", Real::tan, 0.7, [1.0 / (cos * cos), 2.0 * sin / cos.powi(3)]),
        ("asin", Real::asin, 0.6, [1.25, 1.171_875]),
        ("acos", Real::acos, 0.6, [-1.25, -1.171_875]),
        ("atan", Real::atan, 3.0, [0.1, -0.06]),
        ("exp", Real::exp, 1.5, [e, e]),
        ("ln", Real::ln, 4.0, [0.25, -0.0625]),
        ("abs", Real::abs, -4.0, [-1.0, 0.0]),
        ("atan2 of y", |y| y.atan2(Real::TWO), 1.0, [0.4, -0.16]),
        ("atan2 of x", |x| Hyper::TWO.atan2(x), 1.0, [-0.4, 0.16]),
    ];
    for (name, f, at, [first, second]) in cases {
        let found = f(Hyper::new(Dual::new(at, 1.0), Dual::new(1.0, 0.0)));
        let pairs = [(found.dual.real, first), (found.real.dual, first), (found.dual.dual, second)];
        for (found, wanted) in pairs {
            assert!((found - wanted).abs() < LAST_BITS, "{name}: {found} for {wanted}");
        }
    }
    type D = Dual<f64>;
    let huge = D::new(3e200, 1e200).atan2(D::new(4e200, 0.0));
    assert!((huge.dual - 0.16).abs() < LAST_BITS, "no square overflows: {}", huge.dual);
    for pole in [D::EPSILON.sqrt(), D::EPSILON.ln(), D::EPSILON.recip()] {
        assert!(!pole.dual.is_finite(), "{pole}");
    }
    assert!((-D::ONE).sqrt().real.is_nan() && (-D::ONE).ln().real.is_nan());
}

/// ε is positive and smaller than every number.
#[test]
fn order_is_that_of_an_infinitesimal() {
    let zero = <Dual<f64> as Real>::ZERO;
    assert!(Dual::EPSILON > zero && Dual::EPSILON < Dual::new(f64::MIN_POSITIVE, -1e300));
    assert_eq!((-Dual::<f64>::EPSILON).abs(), Dual::EPSILON);
    assert_eq!(Dual::new(-0.0, -2.0).abs(), Dual::new(0.0, 2.0));
    assert!(Dual::new(f64::NAN, 0.0).is_nan() && Dual::new(0.0, f64::NAN).is_nan());
    assert!(!Dual::new(0.0, f64::INFINITY).is_finite());
    assert_eq!(Dual::new(1.5, -2.0).to_string(), "(1.5 + -2ε)");
}

/// ε₁ε₂ is positive and smaller than ε₁, that smaller than ε₂, and that than every
/// number; all parts are seen.
#[test]
fn order_is_that_of_infinitesimals_of_infinitesimals_too() {
    // A number, ε₂, ε₁, ε₁ε₂.
    let hyper = |[a, b, c, d]: [f64; 4]| Hyper::new(Dual::new(a, b), Dual::new(c, d));
    let positive = [
        hyper([0.0, 0.0, 0.0, 1e300]),
        hyper([0.0, 0.0, 1.0, 0.0]),
        hyper([0.0, 0.0, 1e300, 0.0]),
        hyper([0.0, 1.0, 0.0, 0.0]),
        hyper([f64::MIN_POSITIVE, 0.0, 0.0, 0.0]),
    ];
    let mut sorted: Vec<_> = positive.into_iter().rev().map(|x| -x).collect();
    sorted.push(<Hyper as Real>::ZERO);
    sorted.extend(positive);
    assert!(sorted.is_sorted_by(|a, b| a < b), "{sorted:?}");
    for x in sorted {
        assert_eq!(x.abs(), (-x).abs());
        assert!(x.abs() >= <Hyper as Real>::ZERO && x.abs().real.real.is_sign_positive());
    }
    assert!(hyper([-0.0, 0.0, -2.0, 1.0]).abs().real.real.is_sign_positive());
    for part in 0..4 {
        for odd in [f64::NAN, f64::INFINITY] {
            let mut parts = [1.0; 4];
            parts[part] = odd;
            assert!(!hyper(parts).is_finite());
            assert_eq!(hyper(parts).is_nan(), odd.is_nan());
        }
    }
}
