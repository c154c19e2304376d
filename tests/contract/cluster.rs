//! [`Cluster`]: poses about a common one, for blends and paths.

use crate::inputs::{turn_and_move, unit_motion, vector};
use crate::sample::Sample;
use dq8::DualQuat;
use proptest::prelude::*;

/// Four poses within a radian or so of each other, with weights.
#[derive(Clone, Copy, Debug)]
pub struct Cluster {
    pub poses: [[f64; 8]; 4],
    pub weights: [f64; 4],
    pub t: f64,
}

/// Clusters of any size about unit motions of every kind.
pub fn cluster() -> impl Strategy<Value = Cluster> {
    let axis = prop::array::uniform3(-1.0..1.0_f64)
        .prop_filter("an axis has a length", |v| v.iter().map(|c| c * c).sum::<f64>() > 0.01);
    let member = (axis, -0.7..0.7_f64, vector());
    let size = prop_oneof![3 => Just(1.0), 1 => (-6.0..0.0_f64).prop_map(|e| 10.0_f64.powf(e))];
    let poses =
        (unit_motion(), prop::array::uniform4(member), size).prop_map(|(centre, members, size)| {
            members.map(|(axis, angle, translation)| {
                let offset = turn_and_move(axis, size * angle, translation.map(|c| size * c));
                (DualQuat::from_array(centre) * DualQuat::from_array(offset)).to_array()
            })
        });
    let weights = prop::array::uniform4(0.0625..1.0_f64);
    (poses, weights, 0.0..=1.0_f64).prop_map(|(poses, weights, t)| Cluster { poses, weights, t })
}

/// [`Cluster`]s dealt out to the lanes of an implementation.
#[derive(Clone, Copy, Debug)]
pub struct Dealt<M: Sample> {
    pub poses: [M; 4],
    pub weights: [M::Real; 4],
    pub t: M::Real,
}

impl<M: Sample> Dealt<M> {
    /// Lane `i` from cluster `i`, of which there must be as many as lanes.
    pub fn new(clusters: &[Cluster]) -> Self {
        let column = |pick: &dyn Fn(&Cluster) -> f64| {
            M::real(&clusters.iter().map(pick).collect::<Vec<_>>())
        };
        let pose = |i: usize| M::motion(std::array::from_fn(|c| column(&|x| x.poses[i][c])));
        Self {
            poses: std::array::from_fn(pose),
            weights: std::array::from_fn(|i| column(&|x| x.weights[i])),
            t: column(&|x| x.t),
        }
    }

    pub fn influences(&self) -> [(M, M::Real); 4] {
        std::array::from_fn(|i| (self.poses[i], self.weights[i]))
    }

    /// What is in a lane, rounded as it is, for the reference in `f64`.
    pub fn lane(&self, lane: usize) -> Dealt<DualQuat<f64>> {
        let number = |real| M::lanes(real)[lane];
        Dealt {
            poses: self.poses.map(|pose| DualQuat::from_array(pose.scatter()[lane])),
            weights: self.weights.map(number),
            t: number(self.t),
        }
    }
}

/// How far two dual quaternions lie apart as motions, whatever their sign: the components of the
/// rotation as they are, the others in units of `length`. NaN is infinitely far.
pub fn apart(a: [f64; 8], b: [f64; 8], length: f64) -> f64 {
    let with_sign = |sign: f64| {
        let differences = a.iter().zip(b).map(|(a, b)| (a - sign * b).abs());
        let scaled = differences.enumerate().map(|(i, d)| if i < 4 { d } else { d / length });
        scaled.fold(0.0, |worst: f64, d| if d.is_nan() { f64::INFINITY } else { worst.max(d) })
    };
    with_sign(1.0).min(with_sign(-1.0))
}

/// max(1, |t|) over the poses, |t| = 2|q|.
pub fn length(poses: &[[f64; 8]]) -> f64 {
    let sizes = poses.iter().map(|p| 2.0 * p[4..].iter().map(|c| c * c).sum::<f64>().sqrt());
    sizes.fold(1.0, f64::max)
}
