//! Weighted sums that are normalized, or that move points without being: the bound of the whole,
//! from those of both parts.
//!
//! With z + δ for the computed sum, of real part p and dual part q, N for the exact normalization
//! and M(v) = Rv + t for what a motion of any length does to a point, which is the rotation by
//! p/|p| and t = 2qp⁻¹,
//!
//! ```text
//! |N(z + δ) − N(z)| ≤ |δp|/ℓ                                (1) real
//!                   ≤ |δq|/ℓ + (2/√3) |δp||q|/ℓ²            (2) dual
//! |M(v) − M′(v)|    ≤ 2 (|δp||v|/ℓ + |δq|/ℓ + |δp||q|/ℓ²)   (3)
//!
//! (1) by 2|δ|/(|a| + |b|) of Dunkl and Williams (1964), (3) by a⁻¹ − b⁻¹ = a⁻¹(b − a)b⁻¹
//! ```
//!
//! where ℓ is the least length of p on the way, and 2/√3 is of the largest slope of (1 −
//! eeᵀ)/|p|, e = p/|p|. What the last step itself rounds is added. ℓ ≥ |p|(1 − 2⁻¹⁰)
//! if u|δp| ≤ 2⁻¹⁰|p|, which holds where the bound of the real part, or half that of a
//! point or normal with |v| = 1, is below [`FAR`].

use crate::bound::{Analysis, U};
use crate::polynomial::{Lengths, Sum};
use crate::record::Record;
use crate::table::bounds;
use crate::tape::Node;

/// Beyond it, in units of u, sums cancel too far.
pub const FAR: f64 = 16_000.0;

/// 1/(1 − 2⁻¹⁰)², and what is of second order.
const MARGIN: f64 = 1.002_1;

/// Of each argument of what comes after a sum, its length and how far it is off.
pub(crate) fn given(
    analysis: &Analysis,
    last: &Record,
    mut nodes: &[Node],
) -> Option<Vec<(Lengths, Lengths)>> {
    let each = last.operation.inputs.iter().map(|&(_, count)| {
        let (these, rest) = nodes.split_at(count);
        nodes = rest;
        analysis.vector(these)
    });
    each.collect()
}

/// The bound of each number, of which the length of the sum's real part is the group after the
/// arguments.
pub(crate) fn of(record: &Record, precision: usize, analysis: &Analysis) -> Option<Vec<Lengths>> {
    let (last, sum) = record.last(precision)?;
    let z = record.operation.inputs.len();
    let length = |power| Sum([(vec![(z, power)], MARGIN)].into());
    let given = given(analysis, last, &sum)?;
    let (none, over) = (Lengths::default(), length(-1));
    let off = given[0].1.times(&over);
    let (size, moved) = given.get(1).map_or((&none, &none), |dual| (&dual.0, &dual.1));
    let (moved, turned) = (moved.times(&over), off.times(size).times(&over));
    let mut parts = vec![];
    for (&(name, count), part) in last.operation.parts.iter().zip(bounds(last)) {
        let mut bound = match name {
            "dual" => moved.plus(1.0, &turned.scaled(2.0 / 3.0_f64.sqrt())),
            "point" => off.times(&given[2].0).plus(1.0, &moved).plus(1.0, &turned).scaled(2.0),
            "normal" => off.times(&given[1].0).scaled(2.0),
            _ => off.clone(),
        };
        for (powers, c) in part.bound?.0 {
            let factors = powers.into_iter().map(|(argument, power)| match (argument, power) {
                (0, _) => length(power),
                (_, 1) => given[argument].0.plus(U, &given[argument].1),
                _ => unreachable!("a last step is linear in what is not normalized"),
            });
            bound =
                bound.plus(1.0, &factors.fold(Lengths::constant(c), |all, one| all.times(&one)));
        }
        parts.extend(vec![bound; count]);
    }
    Some(parts)
}
