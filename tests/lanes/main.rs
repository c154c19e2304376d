//! What lanes have in addition to [`Motion`](dq8::Motion), against the scalar reference of the same
//! precision or in `f64`, lane by lane: functions of dual numbers, other representations.

mod dual;
mod jacobians;
mod matrices;
mod rotations;
mod scene;

use dq8::{Lanes, Scalar, batch, simd::Float, simd::Mask};
use dq8_contract::bound::distance;
use dq8_contract::ledger::Ledger;
use dq8_contract::sample::{Proof, Sample};

/// Lanes of a level that tests can have.
trait Provable: Lanes<Level: Proof, Real: Scalar> {}
impl<L: Lanes<Level: Proof, Real: Scalar>> Provable for L {}

/// Lane `i` from number `i`, rounded; the lanes beyond repeat the first.
fn lanes<L: Provable>(numbers: &[f64]) -> L {
    let all: Vec<_> = (0..L::LANES).map(|i| *numbers.get(i).unwrap_or(&numbers[0])).collect();
    <batch::DualQuat<L> as Sample>::real(&all)
}

/// Lane `i` from `C` numbers of case `i`.
fn columns<L: Provable, T, const C: usize>(cases: &[T], pick: impl Fn(&T) -> [f64; C]) -> [L; C] {
    std::array::from_fn(|c| lanes(&cases.iter().map(|case| pick(case)[c]).collect::<Vec<_>>()))
}

/// The number in one lane.
fn lane<L: Provable>(all: L, index: usize) -> f64 {
    all.to_array().as_ref()[index].into()
}

/// The numbers in one lane.
fn row<L: Provable, const C: usize>(all: [L; C], index: usize) -> [f64; C] {
    all.map(|number| lane(number, index))
}

/// Whether a mask holds for one lane.
fn holds<M: Mask>(mask: M, index: usize) -> bool {
    mask.to_bitmask() >> index & 1 == 1
}

/// Writes down how far numbers are from those wanted, in units of u · scale.
fn measure<L: Provable, const C: usize>(
    ledger: &Ledger,
    (op, kind): (&str, &str),
    got: [f64; C],
    wanted: [f64; C],
    scale: f64,
    case: &dyn std::fmt::Debug,
) {
    for (got, wanted) in got.into_iter().zip(wanted) {
        let units = distance(got, wanted, scale, L::Real::SINGLE);
        ledger.measure(op, kind, units, || {
            let lanes = std::any::type_name::<L>();
            format!("{lanes}: {got:e} where {wanted:e} is right, for {case:?}")
        });
    }
}
