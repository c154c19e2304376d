//! [`Sides`]: the two sides of a law, lane by lane; [`Law`]: whether they meet.

use crate::bound::{Bound, Kind, Scale, distance};
use crate::case::{Arguments, Case, length};
use crate::implementation::implementations;
use crate::lanes::{Motions, Reals};
use crate::scale::{grows, norms};
use dq8::{Twist, geometry::Wrench};

/// Numbers that a law says are equal.
#[derive(Clone, Debug, Default)]
pub struct Sides(Vec<(Kind, Vec<f64>, Vec<f64>)>);

impl Sides {
    /// Lane `i` of both sides from element `i`.
    pub fn numbers(kind: Kind, left: Vec<f64>, right: Vec<f64>) -> Self {
        Self(vec![(kind, left, right)])
    }

    pub fn reals(kind: Kind, left: &[Reals], right: &[Reals]) -> Self {
        assert_eq!(left.len(), right.len());
        let pairs = left.iter().zip(right);
        Self(pairs.map(|(l, r)| (kind, l.lanes(), r.lanes())).collect())
    }

    /// Rotation and translation on one scale.
    pub fn twists(left: Twist<Reals>, right: Twist<Reals>) -> Self {
        Self::reals(Kind::Plain, &left.to_array(), &right.to_array())
    }

    pub fn wrenches(left: Wrench<Reals>, right: Wrench<Reals>) -> Self {
        let flat = |wrench: Wrench<Reals>| [wrench.force, wrench.torque].concat();
        Self::reals(Kind::Plain, &flat(left), &flat(right))
    }

    pub fn motions(left: Motions, right: Motions) -> Self {
        Self::components(left.scatter(), right.scatter())
    }

    /// The same motion: of ±`right` the one on the side of `left`.
    pub fn same_motions(left: Motions, right: Motions) -> Self {
        let (left, mut right) = (left.scatter(), right.scatter());
        turn_toward(&left, &mut right);
        Self::components(left, right)
    }

    /// As [`same_motions`](Self::same_motions), and a tiny turn keeps its relative precision.
    pub fn same_small_motions(left: Motions, right: Motions) -> Self {
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

/// Two ways to the same numbers.
#[derive(Debug)]
pub struct Law {
    pub name: &'static str,
    pub bound: Bound,
    pub scale: fn(&Case) -> Scale,
    pub sides: fn(&Arguments) -> Sides,
}

impl Law {
    /// Checks it on all `cases` and every implementation, as many cases at a time as there are
    /// lanes.
    ///
    /// # Panics
    /// Where its sides lie further apart than it allows.
    pub fn holds(&self, cases: &[Case]) {
        let (name, Bound { units: allowed, reason, .. }) = (self.name, self.bound);
        for on in implementations() {
            let mut worst = 0.0_f64;
            for chunk in cases.chunks(on.lanes) {
                let sides = (self.sides)(&Arguments::new(on, chunk));
                for (lane, case) in chunk.iter().enumerate() {
                    let scale = (self.scale)(case);
                    for (kind, left, right, units) in sides.distances(lane, &scale, on.single) {
                        assert!(
                            units <= allowed,
                            "{on:?}, lane {lane}: not {name}: {left:e} and {right:e} as a {kind:?} \
                             are {units:.2} units apart, {allowed} allowed ({reason}), for {case:?}"
                        );
                        worst = worst.max(units);
                    }
                }
            }
            println!("{name:50} {worst:8.2} of {allowed:5} units, {on:?}");
        }
    }
}

/// A list of laws, a test for each: for what, on which scale, how far the sides may lie apart in
/// units of u · scale, and why. About 1.6 times the worst of all implementations in 60 000 random
/// cases, built for SSE2 and for AVX2 with fused multiplication.
#[macro_export]
macro_rules! laws {
    ($(
        $(#[$meta:meta])*
        fn $test:ident($x:ident) -> $name:literal, for $cases:expr, $scale:expr,
            within $units:literal, $reason:literal $sides:block
    )*) => {$(
        $(#[$meta])*
        fn $test() {
            let law = $crate::law::Law {
                name: $name,
                bound: $crate::bound::within($units, $reason),
                scale: $scale,
                sides: |$x| $sides,
            };
            law.holds(&$cases);
        }
    )*};
}

pub fn norm(components: &[f64]) -> f64 {
    length(components)
}

/// For sums of products of a, b and c.
pub fn triple_product(x: &Case) -> Scale {
    let [(pa, qa), (pb, qb), (pc, qc)] = norms(x);
    Scale::new(pa * pb * pc, pa * pb * qc + pa * qb * pc + qa * pb * pc)
}

pub fn product_with_sum(x: &Case) -> Scale {
    let [(pa, qa), (pb, qb), (pc, qc)] = norms(x);
    Scale::new(pa * (pb + pc), pa * (qb + qc) + qa * (pb + pc))
}

pub fn square(x: &Case) -> Scale {
    let [(pa, qa), ..] = norms(x);
    Scale::new(pa * pa, pa * qa)
}

/// For unit a, b and c, and what they do to v, w and s.
pub fn unit(x: &Case) -> Scale {
    let far: f64 = norms(x).iter().map(|(_, q)| q).sum();
    let vectors = 1.0 + length(&x.v) + length(&x.w) + x.s.abs();
    Scale::new(vectors, vectors * (1.0 + far))
}

/// For unit a, b and c alone.
pub fn unit_motions(x: &Case) -> Scale {
    Scale::new(1.0, 1.0 + norms(x).iter().map(|(_, q)| q).sum::<f64>())
}

/// For products of two vectors.
pub fn two_vectors(x: &Case) -> Scale {
    let far: f64 = norms(x).iter().map(|(_, q)| q).sum();
    let (v, w) = (length(&x.v), length(&x.w));
    Scale::new(v * w, (v + far) * w)
}

/// For what keeps the relative precision of a tiny turn.
pub fn small(x: &Case) -> Scale {
    let [(_, qa), ..] = norms(x);
    Scale { turn: length(&x.a[..3]), ..Scale::new(1.0, 1.0_f64.max(qa)) }
}

/// For powers: an angle is known to its last place, and the slide turns with it.
pub fn powers(x: &Case) -> Scale {
    let times = 1.0 + x.s.abs() + x.t.abs();
    let far: f64 = norms(x).iter().map(|(_, q)| q).sum();
    let turn = times * length(&x.a[..3]);
    Scale { turn, ..Scale::new(times, times * times * (1.0 + far)) }
}

/// How large lengths are: for unit a and b, and the first twist.
pub fn far(x: &Case) -> Scale {
    one_scale(farness(x))
}

pub fn step(x: &Case) -> Scale {
    one_scale(stepped(x))
}

pub fn with_derivative(x: &Case) -> Scale {
    one_scale(farness(x) * (1.0 + length(&x.derivative)))
}

pub fn with_wrench(x: &Case) -> Scale {
    one_scale(farness(x) * (1.0 + length(&x.wrench)))
}

pub fn power(x: &Case) -> Scale {
    one_scale(stepped(x) * (1.0 + length(&x.wrench)))
}

pub fn at_twist(x: &Case) -> Scale {
    one_scale(turned(x) * (1.0 + length(&x.y)))
}

pub fn of_twist(x: &Case) -> Scale {
    one_scale(turned(x))
}

/// (θ/2)/sin(θ/2) grows without end towards 2π.
pub fn inverse(x: &Case) -> Scale {
    one_scale(turned(x) * (1.0 + length(&x.y)) * grows(x.angle()).powi(3))
}

fn one_scale(size: f64) -> Scale {
    Scale::new(size, size)
}

fn farness(x: &Case) -> f64 {
    let [(_, qa), (_, qb), _] = norms(x);
    (1.0 + 2.0 * qa) * (1.0 + 2.0 * qb) * (1.0 + length(&x.x[3..]))
}

fn stepped(x: &Case) -> f64 {
    farness(x) * (1.0 + x.angle()) * (1.0 + x.dt.abs())
}

fn turned(x: &Case) -> f64 {
    (1.0 + x.angle()).powi(2) * (1.0 + length(&x.x[3..]))
}

/// Vectors, one a lane.
pub fn vectors(vector: [Reals; 3]) -> Vec<[f64; 3]> {
    let [x, y, z] = vector.map(|reals| reals.lanes());
    (0..x.len()).map(|lane| [x[lane], y[lane], z[lane]]).collect()
}
