//! Hyper-dual numbers written out against dq8's `Dual<Dual<f64>>`, ε₁ outside and ε₂ inside: the
//! same numbers by other formulas.

use super::{Number, invertible, parts};
use crate::inputs::{assert_close, reals};
use dq8::{Dual, DualQuat, Quat, Real, Twist};
use lab::HyperDual;
use proptest::prelude::*;

type Nested = Dual<Dual<f64>>;

fn nested(x: Number) -> Nested {
    Dual::new(Dual::new(x.real, x.second), Dual::new(x.first, x.mixed))
}

fn written_out(x: Nested) -> [f64; 4] {
    [x.real.real, x.dual.real, x.real.dual, x.dual.dual]
}

/// Within `tolerance` of the largest part.
#[track_caller]
fn assert_same(name: &str, found: Number, twin: Nested, tolerance: f64) {
    let (found, twin) = (parts(found), written_out(twin));
    let size = twin.into_iter().fold(1.0, |size: f64, c| size.max(c.abs()));
    for (i, (a, b)) in found.into_iter().zip(twin).enumerate() {
        let error = (a - b).abs() / size;
        assert!(error <= tolerance, "{name}, part {i}: {a} and {b}, apart by {error:e}");
    }
}

proptest! {
    #[test]
    fn arithmetic_agrees(x in invertible(), y in invertible()) {
        let (u, v) = (nested(x), nested(y));
        assert_same("+", x + y, u + v, 0.0);
        assert_same("−", x - y, u - v, 0.0);
        assert_same("negative", -x, -u, 0.0);
        assert_same("·", x * y, u * v, 1e-15);
        assert_same("/", x / y, u / v, 1e-15);
        assert_same("inverse", x.inverse().unwrap(), <Nested as Real>::ONE / u, 1e-15);
        assert_same("abs", x.abs(), u.abs(), 0.0);
        let (mut z, mut w) = (x, u);
        z += y;
        w += v;
        z *= x;
        w *= u;
        z -= y;
        w -= v;
        z /= x;
        w /= u;
        assert_same("assigned", z, w, 4e-15);
    }

    #[test]
    fn order_agrees(x in invertible(), y in invertible(), equal in 0_usize..4) {
        // The first parts in order are made equal, so that the later ones decide.
        let y = HyperDual {
            real: if equal > 0 { x.real } else { y.real },
            second: if equal > 1 { x.second } else { y.second },
            first: if equal > 2 { x.first } else { y.first },
            ..y
        };
        prop_assert_eq!(x.partial_cmp(&y), nested(x).partial_cmp(&nested(y)));
    }

    #[test]
    fn functions_agree(x in invertible(), y in invertible(), exponent in -3.0..3.0) {
        type Case = (&'static str, fn(Number) -> Number, fn(Nested) -> Nested);
        let everywhere: [Case; 5] = [
            ("sin", Real::sin, Real::sin),
            ("cos", Real::cos, Real::cos),
            ("exp", Real::exp, Real::exp),
            ("atan", Real::atan, Real::atan),
            ("tan", |x| (x * Real::HALF * Real::HALF).tan(), |x| (x * Real::HALF * Real::HALF).tan()),
        ];
        for (name, function, twin) in everywhere {
            assert_same(name, function(x), twin(nested(x)), 2e-15);
        }
        let positive: [Case; 2] = [("sqrt", Real::sqrt, Real::sqrt), ("ln", Real::ln, Real::ln)];
        let size = HyperDual { real: x.real.abs(), ..x };
        for (name, function, twin) in positive {
            assert_same(name, function(size), twin(nested(size)), 1e-15);
        }
        let power = (Nested::from_f64(exponent) * nested(size).ln()).exp();
        assert_same("pow", size.pow(exponent), power, 4e-15);
        let inside = HyperDual { real: x.real / 4.25, ..x };
        let within_one: [Case; 2] = [("asin", Real::asin, Real::asin), ("acos", Real::acos, Real::acos)];
        for (name, function, twin) in within_one {
            assert_same(name, function(inside), twin(nested(inside)), 2e-15);
        }
        assert_same("atan2", x.atan2(y), nested(x).atan2(nested(y)), 2e-15);
    }

    /// Everything dq8 computes: turns, screws, logarithms and blends in one motion.
    #[test]
    fn motions_agree(t in 0.05..1.0, [b, c, d] in reals(1.0)) {
        let x = HyperDual::new(t, b, c, d);
        let (found, twin) = (motion(x).to_array(), motion(nested(x)).to_array());
        for (found, twin) in found.into_iter().zip(twin) {
            assert_same("motion", found, twin, 4e-15);
        }
    }
}

/// A motion that depends on a parameter in every way the algebra offers.
fn motion<R: Real>(t: R) -> DualQuat<R> {
    let turn = Quat::from_axis_angle([0.6, 0.0, 0.8].map(R::from_f64), t * R::from_f64(1.3));
    let moving = DualQuat::from_rotation_translation(turn, [t, t * t, t.sin()]);
    let twist = Twist {
        angular: [0.1, -0.7, 0.4].map(R::from_f64),
        linear: [R::from_f64(1.0), t.exp(), R::from_f64(-2.0)],
    };
    let still = DualQuat::from_twist(twist);
    moving.sclerp(still * moving, t).nlerp(still.pow(t), R::from_f64(0.25)).normalize()
}

/// f(a), f′(a) and f″(a), known from tables.
#[test]
fn functions_have_their_derivatives() {
    type Case = (&'static str, fn(Number) -> Number, f64, [f64; 3]);
    let (sin, cos) = 0.7_f64.sin_cos();
    let root = 2.0_f64.sqrt();
    let e = 1.5_f64.exp();
    let cases: [Case; 10] = [
        ("sqrt", Number::sqrt, 2.0, [root, 0.5 / root, -0.125 / root]),
        ("sin", Number::sin, 0.7, [sin, cos, -sin]),
        ("cos", Number::cos, 0.7, [cos, -sin, -cos]),
        ("tan", Number::tan, 0.7, [sin / cos, (cos * cos).recip(), 2.0 * sin / cos.powi(3)]),
        ("asin", Number::asin, 0.6, [0.6_f64.asin(), 1.25, 1.171_875]),
        ("acos", Number::acos, 0.6, [0.6_f64.acos(), -1.25, -1.171_875]),
        ("atan", Number::atan, 3.0, [3.0_f64.atan(), 0.1, -0.06]),
        ("exp", Number::exp, 1.5, [e, e, e]),
        ("ln", Number::ln, 4.0, [4.0_f64.ln(), 0.25, -0.0625]),
        ("pow", |x| x.pow(1.5), 4.0, [8.0, 3.0, 0.375]),
    ];
    for (name, function, at, [value, first, second]) in cases {
        println!("{name}");
        let found = function(HyperDual::new(at, 1.0, 1.0, 0.0));
        assert_close(parts(found), [value, first, first, second], 2e-15);
    }
    let huge = HyperDual::new(3e200, 1e200, 0.0, 0.0).atan2(HyperDual::constant(4e200));
    assert_close(parts(huge), [0.75_f64.atan(), 0.16, 0.0, 0.0], 1e-15);
}

/// A kink has no derivative, and says so.
#[test]
fn derivatives_at_a_pole_are_not_finite() {
    let zero = HyperDual::new(0.0, 1.0, 1.0, 0.0);
    for x in [zero.sqrt(), zero.ln(), zero.inverse().unwrap_or(Number::NAN)] {
        assert!(!x.first.is_finite() && !x.second.is_finite() && !x.mixed.is_finite(), "{x}");
    }
    assert!((-Number::ONE).sqrt().real.is_nan() && (-Number::ONE).ln().real.is_nan());
}
