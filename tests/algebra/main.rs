//! The laws in the documentation of [`Quaternion`](dq8::Quaternion) and
//! [`DualNumber`](dq8::DualNumber), on every implementation: scalar, and all lanes that there are.

mod dual_number;
mod quaternion;

use dq8_contract::bound::distance;
use dq8_contract::case::Case;
use dq8_contract::inputs;
use dq8_contract::ledger::Ledger;
use dq8_contract::sample::Sample;

/// Two sides of a law, one row of numbers each, a number a lane.
type Sides<M> = Vec<(<M as dq8::Motion>::Real, <M as dq8::Motion>::Real)>;

/// Writes down how far the sides of a law are apart, in units of u · scale.
fn see<M: Sample>(ledger: &Ledger, on: &str, law: &str, sides: Sides<M>, scales: &[f64]) {
    for (left, right) in sides {
        for ((left, right), scale) in M::lanes(left).into_iter().zip(M::lanes(right)).zip(scales) {
            let units = distance(left, right, *scale, M::SINGLE);
            ledger.measure(law, "", units, || format!("{on}: {left:e} and {right:e}"));
        }
    }
}

/// Lane `i` from case `i`; lanes beyond the last case repeat it.
fn column<M: Sample>(cases: &[Case], pick: impl Fn(&Case) -> f64) -> M::Real {
    let last = cases.len() - 1;
    M::real(&(0..M::LANES).map(|i| pick(&cases[i.min(last)])).collect::<Vec<_>>())
}

/// As many cases at a time as there are lanes.
fn chunks<M: Sample>() -> Vec<Vec<Case>> {
    let mut cases = inputs::unit_cases();
    cases.retain(|case| case.v.iter().chain(&case.w).all(|c| c.abs() > 1e-3));
    cases.chunks(M::LANES).map(<[Case]>::to_vec).collect()
}
