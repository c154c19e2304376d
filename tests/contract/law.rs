//! [`Sides`]: the two sides of a law, lane by lane, and whether they meet.

use crate::agreement::{Kind, LAWS, Scale, bound, distance};
use crate::inputs::{Arguments, Case};
use crate::sample::Sample;

/// Numbers that a law says are equal.
#[derive(Clone, Debug, Default)]
pub struct Sides(Vec<(Kind, Vec<f64>, Vec<f64>)>);

impl Sides {
    /// Lane `i` of both sides from element `i`.
    pub fn numbers(kind: Kind, left: Vec<f64>, right: Vec<f64>) -> Self {
        Self(vec![(kind, left, right)])
    }

    pub fn reals<M: Sample>(kind: Kind, left: &[M::Real], right: &[M::Real]) -> Self {
        let pairs = left.iter().zip(right);
        Self(pairs.map(|(&l, &r)| (kind, M::lanes(l), M::lanes(r))).collect())
    }

    pub fn motions<M: Sample>(left: M, right: M) -> Self {
        Self::components(left.scatter(), right.scatter())
    }

    /// The same motion: of ±`right` the one on the side of `left`.
    pub fn same_motions<M: Sample>(left: M, right: M) -> Self {
        let (left, mut right) = (left.scatter(), right.scatter());
        turn_toward(&left, &mut right);
        Self::components(left, right)
    }

    /// As [`same_motions`](Self::same_motions), and a tiny turn keeps its relative precision.
    pub fn same_small_motions<M: Sample>(left: M, right: M) -> Self {
        let mut sides = Self::same_motions(left, right);
        for (kind, ..) in &mut sides.0[..3] {
            *kind = Kind::Turn;
        }
        sides
    }

    /// The components of motions, one a lane.
    pub fn components(left: Vec<[f64; 8]>, right: Vec<[f64; 8]>) -> Self {
        let column = |motions: &[[f64; 8]], c: usize| motions.iter().map(|m| m[c]).collect();
        let kind = |c| if c < 4 { Kind::Plain } else { Kind::Length };
        Self((0..8).map(|c| (kind(c), column(&left, c), column(&right, c))).collect())
    }

    #[must_use]
    pub fn and(mut self, other: Self) -> Self {
        self.0.extend(other.0);
        self
    }

    /// What is compared in a lane, and how far apart it is in units of u · scale.
    pub fn distances(
        &self,
        lane: usize,
        scale: &Scale,
        single: bool,
    ) -> impl Iterator<Item = (Kind, f64, f64, f64)> {
        self.0.iter().map(move |(kind, left, right)| {
            let (left, right) = (left[lane], right[lane]);
            (*kind, left, right, distance(left, right, scale.of(*kind), single))
        })
    }
}

fn turn_toward(left: &[[f64; 8]], right: &mut [[f64; 8]]) {
    for (left, right) in left.iter().zip(right) {
        let dot: f64 = left.iter().zip(&*right).take(4).map(|(l, r)| l * r).sum();
        if dot < 0.0 {
            *right = right.map(|c| -c);
        }
    }
}

/// Checks a law on all `cases`, as many at a time as there are lanes.
///
/// # Panics
/// Where its sides lie further apart than its line in the table of laws allows.
pub fn holds<M: Sample>(
    implementation: &str,
    name: &str,
    cases: &[Case],
    scale: impl Fn(&Case) -> Scale,
    law: impl Fn(&Arguments<M>) -> Sides,
) {
    let allowed = bound(LAWS, name);
    let mut worst = 0.0_f64;
    for chunk in cases.chunks(M::LANES) {
        let sides = law(&Arguments::new(chunk));
        for (lane, case) in chunk.iter().enumerate() {
            for (kind, left, right, units) in sides.distances(lane, &scale(case), M::SINGLE) {
                assert!(
                    units <= allowed,
                    "{implementation}, lane {lane}: not {name}: {left:e} and {right:e} as a {kind:?} \
                     are {units:.2} units apart, {allowed} allowed, for {case:?}"
                );
                worst = worst.max(units);
            }
        }
    }
    println!("{name:50} {worst:8.2} of {allowed:5} units, {implementation}");
}

pub fn norm(components: &[f64]) -> f64 {
    components.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// |p| and |q| of a, b and c.
pub fn norms(x: &Case) -> [(f64, f64); 3] {
    [x.a, x.b, x.c].map(|m| (norm(&m[..4]), norm(&m[4..])))
}

pub fn plain_and_length(plain: f64, length: f64) -> Scale {
    Scale { plain, turn: plain, length, moment: length }
}

/// For sums of products of a, b and c.
pub fn triple_product(x: &Case) -> Scale {
    let [(pa, qa), (pb, qb), (pc, qc)] = norms(x);
    plain_and_length(pa * pb * pc, pa * pb * qc + pa * qb * pc + qa * pb * pc)
}

pub fn product(x: &Case) -> Scale {
    let [(pa, qa), (pb, qb), _] = norms(x);
    plain_and_length(pa * pb, pa * qb + qa * pb)
}

pub fn product_with_sum(x: &Case) -> Scale {
    let [(pa, qa), (pb, qb), (pc, qc)] = norms(x);
    plain_and_length(pa * (pb + pc), pa * (qb + qc) + qa * (pb + pc))
}

pub fn square(x: &Case) -> Scale {
    let [(pa, qa), ..] = norms(x);
    plain_and_length(pa * pa, pa * qa)
}

/// For results that do not grow with |p|.
pub fn quotient(x: &Case) -> Scale {
    let [(pa, qa), ..] = norms(x);
    plain_and_length(1.0, qa / pa)
}

/// For unit a, b and c, and what they do to v, w and s.
pub fn unit(x: &Case) -> Scale {
    let length: f64 = norms(x).iter().map(|(_, q)| q).sum();
    let vectors = 1.0 + norm(&x.v) + norm(&x.w) + x.s.abs();
    plain_and_length(vectors, vectors * (1.0 + length))
}

/// For unit a, b and c alone.
pub fn unit_motions(x: &Case) -> Scale {
    plain_and_length(1.0, 1.0 + norms(x).iter().map(|(_, q)| q).sum::<f64>())
}

/// For products of two vectors.
pub fn two_vectors(x: &Case) -> Scale {
    let length: f64 = norms(x).iter().map(|(_, q)| q).sum();
    let (v, w) = (norm(&x.v), norm(&x.w));
    plain_and_length(v * w, (v + length) * w)
}

/// For what keeps the relative precision of a tiny turn.
pub fn small(x: &Case) -> Scale {
    let [(_, qa), ..] = norms(x);
    Scale { turn: norm(&x.a[..3]), ..plain_and_length(1.0, 1.0_f64.max(qa)) }
}

/// For powers: an angle is known to its last place, and the slide turns with it.
pub fn powers(x: &Case) -> Scale {
    let times = 1.0 + x.s.abs() + x.t.abs();
    let length: f64 = norms(x).iter().map(|(_, q)| q).sum();
    let turn = times * norm(&x.a[..3]);
    Scale { turn, ..plain_and_length(times, times * times * (1.0 + length)) }
}

/// Vectors, one a lane.
pub fn vectors<M: Sample>(vector: [M::Real; 3]) -> Vec<[f64; 3]> {
    let rows = vector.map(M::lanes);
    (0..M::LANES).map(|lane| std::array::from_fn(|c| rows[c][lane])).collect()
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
