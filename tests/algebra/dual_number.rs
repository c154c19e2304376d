//! Dual numbers and their functions.

use super::{Sides, chunks, column, see};
use dq8::{Dual, DualNumber};
use dq8_contract::case::Case;
use dq8_contract::implementation::{Visitor, visit_implementations};
use dq8_contract::ledger::{Ledger, Line, line};
use dq8_contract::sample::Sample;

/// About 1.6 times the worst.
#[rustfmt::skip]
const LAWS: &[Line] = &[
    line("x + y = y + x, xy = yx", &[], 4.0, "products are summed in another order"),
    line("(xy)z = x(yz), x(y + z) = xy + xz", &[], 3.2, "two products a side"),
    line("ε² = 0", &[], 0.0, "products with zero are exact"),
    line("f(x) = f(a) + εb f′(a)", &[], 0.0, "one product"),
    line("x · 1/x = 1, x/y = x · 1/y", &[], 2.5, "quotients against a product of quotients"),
    line("(√x)² = x", &[], 1.6, "a root and a product"),
    line("xᵐxⁿ = xᵐ⁺ⁿ", &[], 3.2, "seven products"),
    line("sin² + cos² = 1, tan = sin/cos", &[], 0.8, "a sine and a cosine each"),
    line("exp(x + y) = exp x exp y, exp(ln x) = x", &[], 4.2, "exponentials are as steep as they are large"),
    line("sin(arcsin x) = x, cos(arccos x) = x, tan(arctan x) = x", &[], 2.5, "an arc and its sine"),
    line("atan2(r sin x, r cos x) = x", &[], 0.6, "two sines, two products, an arc"),
];

struct Laws<'a>(&'a Ledger);

impl Visitor for Laws<'_> {
    fn visit<M: Sample>(&mut self, on: &'static str) {
        for cases in chunks::<M>() {
            hold::<M>(self.0, on, &cases);
        }
    }
}

fn sides<M: Sample>(left: M::Dual, right: M::Dual) -> Sides<M> {
    left.parts().into_iter().zip(right.parts()).collect()
}

fn hold<M: Sample>(ledger: &Ledger, on: &str, cases: &[Case]) {
    // Real parts in (−1, 1), dual parts in (−2, 2).
    let number = |real: fn(&Case) -> f64, dual: fn(&Case) -> f64| {
        <M::Dual as DualNumber>::new(
            column::<M>(cases, |case| real(case) * 0.45),
            column::<M>(cases, dual),
        )
    };
    let x = number(|case| case.v[0], |case| case.w[0]);
    let y = number(|case| case.v[1], |case| case.w[1]);
    let z = number(|case| case.v[2], |case| case.w[2]);
    let real = |value: f64| <M::Dual as DualNumber>::new(M::splat(value), M::splat(0.0));
    let (one, zero) = (real(1.0), real(0.0));
    // Between 1 and 3.
    let p = x + real(2.0);
    let q = y + real(2.0);
    let see = |law: &str, left: M::Dual, right: M::Dual, scale: f64| {
        see::<M>(ledger, on, law, sides::<M>(left, right), &vec![scale; M::LANES]);
    };

    see("x + y = y + x, xy = yx", x + y, y + x, 1.0);
    see("x + y = y + x, xy = yx", x * y, y * x, 2.0);
    let law = "(xy)z = x(yz), x(y + z) = xy + xz";
    see(law, (x * y) * z, x * (y * z), 4.0);
    see(law, x * (y + z), x * y + x * z, 4.0);
    see(law, x * (y - z), -(x * z - x * y), 4.0);
    let epsilon = <M::Dual as DualNumber>::new(M::splat(0.0), M::splat(1.0));
    see("ε² = 0", epsilon * epsilon, zero, 1.0);
    let [a, b] = x.parts();
    see("f(x) = f(a) + εb f′(a)", x.apply(a, M::splat(1.0)), x, 1.0);
    see("f(x) = f(a) + εb f′(a)", x.scale(M::splat(2.0)), x + x, 1.0);
    see("f(x) = f(a) + εb f′(a)", <M::Dual as DualNumber>::new(a, b), x, 1.0);
    let law = "x · 1/x = 1, x/y = x · 1/y";
    see(law, p * p.recip(), one, 2.0);
    see(law, p / q, p * q.recip(), 8.0);
    see("(√x)² = x", p.sqrt() * p.sqrt(), p, 4.0);
    see("xᵐxⁿ = xᵐ⁺ⁿ", p.powi(3) * p.powi(4), p.powi(7), 16_384.0);
    see("xᵐxⁿ = xᵐ⁺ⁿ", p.powi(-2) * p.powi(2), one, 4.0);
    see("xᵐxⁿ = xᵐ⁺ⁿ", p.powi(0), one, 1.0);

    let law = "sin² + cos² = 1, tan = sin/cos";
    let (sin, cos) = (p.sin(), p.cos());
    see(law, sin * sin + cos * cos, one, 4.0);
    see(law, x.tan(), x.sin() / x.cos(), 16.0);
    let law = "exp(x + y) = exp x exp y, exp(ln x) = x";
    see(law, (p + q).exp(), p.exp() * q.exp(), 1600.0);
    see(law, p.ln().exp(), p, 4.0);
    let law = "sin(arcsin x) = x, cos(arccos x) = x, tan(arctan x) = x";
    see(law, x.asin().sin(), x, 16.0);
    see(law, x.acos().cos(), x, 16.0);
    see(law, p.atan().tan(), p, 16.0);
    see("atan2(r sin x, r cos x) = x", (q * sin).atan2(q * cos), p, 16.0);
}

#[test]
fn dual_numbers_of_every_implementation_keep_the_laws() {
    Ledger::keep("dual numbers", LAWS, |ledger| visit_implementations(&mut Laws(ledger)));
}

#[test]
fn what_has_no_inverse_is_an_error() {
    for real in [0.0_f64, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let error = Dual::new(real, 1.0).inverse().unwrap_err();
        assert!(error.real_norm == real.abs() || real.is_nan() && error.real_norm.is_nan());
    }
    assert_eq!(Dual::new(-4.0, 2.0).inverse(), Ok(Dual::new(-0.25, -0.125)));
}
