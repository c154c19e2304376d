use super::chain::{Chain, Order, Steps};
use super::representation::{
    Homogeneous, Listing, Representation, kenwright_normalize, with_unit_rotation,
};
use super::target::{Miss, follow};
use crate::matrix::{self, Matrix, distance};
use core::convert::identity;
use dq8::{DualQuat, representation::RotationTranslation};

/// What is measured of a chain, the worst of its links where they have one each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// How far axes are from right angles, [`matrix::skew`].
    Skew,
    /// How far axes are from unit length, [`matrix::stretch`].
    Stretch,
    /// [`Representation::norm_error`]
    Norm,
    /// Of the end effector from where the same steps bring it exactly, in links.
    Position,
    /// Of the end effector from the same, radians.
    Angle,
    /// Of the length of a link, relative.
    Link,
    /// By how much upkeep moves the end effector in one frame, in links.
    Jump,
}

impl Measure {
    /// In the order of declaration.
    pub const ALL: [Self; 7] = [
        Self::Skew,
        Self::Stretch,
        Self::Norm,
        Self::Position,
        Self::Angle,
        Self::Link,
        Self::Jump,
    ];

    /// For a heading.
    pub fn name(self) -> &'static str {
        match self {
            Self::Skew => "skew",
            Self::Stretch => "scale",
            Self::Norm => "norm",
            Self::Position => "end position, links",
            Self::Angle => "end angle, rad",
            Self::Link => "link length",
            Self::Jump => "jump, links",
        }
    }
}

/// The state of a chain in a frame.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Steps taken.
    pub frame: usize,
    errors: [f64; Measure::ALL.len()],
}

impl Sample {
    /// One of its errors.
    pub fn error(&self, measure: Measure) -> f64 {
        self.errors[measure as usize]
    }
}

/// A representation and what keeps it in order.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// For tables and legends.
    pub name: &'static str,
    /// Takes the steps in single precision, and measures at every so many frames.
    pub trace: fn(&[Steps], Order, usize) -> Vec<Sample>,
}

/// All that are compared.
pub const METHODS: [Method; 8] = [
    Method {
        name: "matrix",
        trace: |steps, order, every| trace(steps, order, every, identity::<Homogeneous<f32>>),
    },
    Method {
        name: "matrix, Gram–Schmidt",
        trace: |steps, order, every| trace(steps, order, every, Homogeneous::<f32>::gram_schmidt),
    },
    Method {
        name: "dual quaternion",
        trace: |steps, order, every| trace(steps, order, every, identity::<DualQuat<f32>>),
    },
    Method {
        name: "dual quaternion, Kenwright's matrix",
        trace: |steps, order, every| trace(steps, order, every, |state: Listing<f32>| state),
    },
    Method {
        name: "dual quaternion, normalized",
        trace: |steps, order, every| trace(steps, order, every, DualQuat::<f32>::normalize),
    },
    Method {
        name: "dual quaternion, Kenwright's Normalize",
        trace: |steps, order, every| trace(steps, order, every, kenwright_normalize::<f32>),
    },
    Method {
        name: "quaternion + vector",
        trace: |steps, order, every| {
            trace(steps, order, every, identity::<RotationTranslation<f32>>)
        },
    },
    Method {
        name: "quaternion + vector, normalized",
        trace: |steps, order, every| trace(steps, order, every, with_unit_rotation::<f32>),
    },
];

/// Takes the steps twice, as an `S` with `upkeep` in every frame and exactly (dual quaternions in
/// double precision, normalized), and compares them at every so many frames.
pub fn trace<S: Representation>(
    steps: &[Steps],
    order: Order,
    every: usize,
    upkeep: impl Fn(S) -> S,
) -> Vec<Sample> {
    let mut chain = Chain::<S>::bent(order);
    let mut exact = Chain::<DualQuat<f64>>::bent(order);
    let mut samples = Vec::new();
    for (frame, step) in (1..).zip(steps) {
        chain.advance(step);
        exact.advance(step);
        exact.keep(DualQuat::normalize);
        let measured = frame % every == 0;
        let before = measured.then(|| chain.end());
        chain.keep(&upkeep);
        if let Some(before) = before {
            samples.push(Sample { frame, errors: errors(&chain, before, exact.end()) });
        }
    }
    samples
}

/// In the order of [`Measure`].
fn errors<S: Representation>(
    chain: &Chain<S>,
    before_upkeep: Matrix<f64, 3, 4>,
    exact: Matrix<f64, 3, 4>,
) -> [f64; Measure::ALL.len()] {
    let models = chain.models();
    let end = chain.end();
    let worst = |measure: fn(S) -> f64| models.into_iter().map(measure).fold(0.0, f64::max);
    let [motion, wanted] = [end, exact].map(DualQuat::from_matrix3x4);
    [
        worst(|model| matrix::skew(matrix::left(model.to_matrix()))),
        worst(|model| matrix::stretch(matrix::left(model.to_matrix()))),
        worst(S::norm_error),
        distance(end, exact),
        motion.angle_to(wanted),
        chain.link_error(),
        distance(before_upkeep, end),
    ]
}

/// How fast the targets are: frames for one round. What one of them does is chance.
pub const ROUNDS: [usize; 5] = [200, 500, 1000, 3000, 7000];

/// What becomes of each of [`METHODS`], and of the exact chain.
#[derive(Clone, Copy, Debug)]
pub struct Findings {
    /// In the last frame, root mean squares over targets of all speeds.
    pub last: [Sample; METHODS.len()],
    /// The worst of all frames and speeds.
    pub worst: [Sample; METHODS.len()],
    /// The worst by which the exact chain misses its target once it has arrived.
    pub missed: Miss,
}

/// Follows targets of all speeds for so many frames.
///
/// # Panics
/// For no frames.
pub fn findings(frames: usize, order: Order) -> Findings {
    let runs = ROUNDS.map(|round| follow(frames, round, order));
    let (mut last, mut worst) = (Vec::new(), Vec::new());
    for method in METHODS {
        let mut squares = [0.0; Measure::ALL.len()];
        let mut peaks = [0.0_f64; Measure::ALL.len()];
        for (steps, _) in &runs {
            let traced = (method.trace)(steps, order, 1);
            let end = traced.last().expect("at least one frame");
            for (sum, error) in squares.iter_mut().zip(end.errors) {
                *sum += error * error / ROUNDS.len() as f64;
            }
            for sample in &traced {
                for (peak, error) in peaks.iter_mut().zip(sample.errors) {
                    *peak = peak.max(error);
                }
            }
        }
        last.push(Sample { frame: frames, errors: squares.map(f64::sqrt) });
        worst.push(Sample { frame: frames, errors: peaks });
    }
    let missed = runs.iter().fold(Miss::default(), |worst, (_, missed)| worst.max(*missed));
    let all = |samples: Vec<Sample>| core::array::from_fn(|method| samples[method]);
    Findings { last: all(last), worst: all(worst), missed }
}
