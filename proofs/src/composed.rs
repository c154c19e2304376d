//! Weighted sums that are normalized: the bound of the whole, from those of both parts.
//!
//! With z + δ for the computed sum, of real part p and dual part q, and N for the exact normalization,
//!
//! ```text
//! |N(z + δ) − N(z)| ≤ |δp|/ℓ                                real, for 2|δ|/(|a| + |b|) of Dunkl and Williams (1964)
//!                   ≤ |δq|/ℓ + (2/√3) |δp||q|/ℓ²            dual
//! ```
//!
//! where ℓ is the least length of p on the way, and the second is the largest slope of (1 − eeᵀ)/|p|, e = p/|p|. What
//! normalizing itself rounds is added. ℓ ≥ |p|(1 − 2⁻¹⁰) if u|δp| ≤ 2⁻¹⁰|p|, which holds where the bound of the real part is
//! below [`FAR`].

use crate::bound::{Analysis, U};
use crate::operations::{Form, OPERATIONS, Operation};
use crate::polynomial::Lengths;
use crate::table::bounds;
use crate::tape::{Node, Tape};
use crate::tape_of;

/// Beyond it, in units of u, sums cancel too far.
pub const FAR: f64 = 16_000.0;

/// 1/(1 − 2⁻¹⁰)², and what is of second order.
const MARGIN: f64 = 1.002_1;

/// What normalizes at the end, and the nodes of the sum that it is given.
#[must_use]
pub fn sum(
    operation: &Operation,
    tape: &Tape,
    form: Form,
    is_single: bool,
) -> Option<(&'static Operation, Vec<Node>)> {
    if !matches!(form, Form::Single | Form::Lanes) || operation.name.contains("normalize") {
        return None;
    }
    let mut last = OPERATIONS.iter().filter(|o| matches!(o.name, "normalize" | "quat_normalize"));
    last.find_map(|last| Some((last, tape.ends_in(&tape_of(last, form, is_single))?)))
}

/// The bound of each number, of which the length of the sum's real part is the group after the arguments.
pub(crate) fn of(
    operation: &Operation,
    analysis: &Analysis,
    (last, sum): &(&Operation, Vec<Node>),
    form: Form,
    fused: bool,
) -> Option<Vec<Lengths>> {
    let (real, dual) = sum.split_at(4);
    let over = Lengths([(vec![(operation.inputs.len(), -1)], MARGIN)].into());
    let own = bounds(last, form, fused).into_iter().map(|part| part.bound);
    let own: Vec<f64> = own.map(|own| Some(own?.0.values().sum())).collect::<Option<_>>()?;
    let off = analysis.vector(real)?.1.times(&over);
    let mut parts = vec![Lengths::constant(own[0]).plus(&off); 4];
    if !dual.is_empty() {
        let (size, moved) = analysis.vector(dual)?;
        let of_dual = size.scaled(own[1]).plus(&moved.scaled(1.0 + own[1] * U)).times(&over);
        let turned = off.times(&size).times(&over).scaled(2.0 / 3.0_f64.sqrt());
        parts.extend(vec![of_dual.plus(&turned); 4]);
    }
    Some(parts)
}
