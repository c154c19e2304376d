//! Motions and vectors for everything here: [`Case`].

use dq8::{DualQuat, Quat, Real};
use dq8_contract::bound::rounded;
use dq8_contract::inputs;

/// A motion, another one, and vectors.
#[derive(Clone, Debug)]
pub(super) struct Case {
    pub(super) a: [f64; 8],
    pub(super) b: [f64; 8],
    pub(super) v: [f64; 3],
    pub(super) w: [f64; 3],
}

/// Every motion at an edge, those next to no turn and half a turn among them.
pub(super) fn cases() -> Vec<Case> {
    let motions: Vec<_> = inputs::edge_motions()
        .into_iter()
        .filter(|m| m[4..].iter().all(|c| c.abs() < 100.0))
        .collect();
    let vector = |i: usize| {
        let at = |k: f64| 2.0 * ((i + 1) as f64 * k).sin();
        [at(1.0), at(1.7), at(2.3)]
    };
    let other = |i: usize| motions[(i * 31 + 7) % motions.len()];
    let each = motions.iter().enumerate();
    each.map(|(i, &a)| Case { a, b: other(i), v: vector(i), w: vector(i + 5) }).collect()
}

pub(super) fn quat<R: Real>([x, y, z, w, ..]: [f64; 8]) -> Quat<R> {
    Quat::from_array(rounded([x, y, z, w])).normalize()
}

pub(super) fn motion<R: Real>(components: [f64; 8]) -> DualQuat<R> {
    DualQuat::from_array(rounded(components)).normalize()
}
