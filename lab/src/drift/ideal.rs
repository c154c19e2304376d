//! The chain against the ideal one, as Kenwright §10.1 compares them: what is repaired, where, and
//! whose state the solver looks at.

use super::chain::{Chain, LINKS, Order};
use super::representation::Representation;
use super::target::{ARRIVAL, Miss, towards};
use crate::matrix::{self, Matrix, length};
use dq8::DualQuat;

/// Where a chain is put in order in every frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Repair {
    /// Nowhere.
    Never,
    /// The state of each joint, between frames.
    States,
    /// What is concatenated, at each level of the hierarchy; the states stay as they are.
    Levels,
    /// Both, as Kenwright §10 says.
    Both,
}

impl Repair {
    /// In the order of declaration.
    pub const ALL: [Self; 4] = [Self::Never, Self::States, Self::Levels, Self::Both];

    /// For a table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Never => "never",
            Self::States => "states",
            Self::Levels => "levels",
            Self::Both => "states and levels",
        }
    }
}

/// Whose state the solver looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loop {
    /// That of the ideal chain: the steps of all representations are the same.
    Open,
    /// That of the chain itself, drifted as it is: errors of the end are seen and mended.
    Closed,
}

/// The frames of all joints in model space, rows of `[A | t]`, and of the end.
pub type Frames = [Matrix<f64, 3, 4>; LINKS + 1];

/// What becomes of a chain; numbers are the worst of all frames.
#[derive(Clone, Copy, Debug)]
pub struct Deviation {
    /// Of the end from that of the ideal chain, which takes the same steps exactly, in links.
    pub position: f64,
    /// Of the end from the same, radians.
    pub angle: f64,
    /// [`matrix::skew`] of the worst joint.
    pub skew: f64,
    /// [`matrix::stretch`] of the worst joint.
    pub stretch: f64,
    /// How far two joints are from one link apart, in links.
    pub link: f64,
    /// By how much the place of a joint jumps against the ideal one from frame to frame, in links.
    pub jump: f64,
    /// By how much the end misses the target after it has arrived.
    pub missed: Miss,
    /// In the last frame, of the ideal chain.
    pub ideal: Frames,
    /// In the last frame, of this one.
    pub actual: Frames,
}

/// Follows a target that goes round in `round` frames.
pub fn against_ideal<S: Representation>(
    [frames, round]: [usize; 2],
    order: Order,
    (repair, upkeep): (Repair, fn(S) -> S),
    closed: Loop,
) -> Deviation {
    let mut chain = Chain::<S>::bent(order);
    let mut exact = Chain::<DualQuat<f64>>::bent(order);
    let placed = |models: [Matrix<f64, 3, 4>; LINKS]| -> Frames {
        core::array::from_fn(|i| models.get(i).copied().unwrap_or_else(|| order.end(models[i - 1])))
    };
    let levels = |chain: &Chain<S>| match repair {
        Repair::Never | Repair::States => chain.models(),
        Repair::Levels | Repair::Both => chain.levels(upkeep),
    };
    let mut seen = levels(&chain).map(S::to_matrix);
    let mut ideal = exact.models().map(DualQuat::to_matrix3x4);
    let mut worst = Deviation {
        position: 0.0,
        angle: 0.0,
        skew: 0.0,
        stretch: 0.0,
        link: 0.0,
        jump: 0.0,
        missed: Miss::default(),
        ideal: placed(ideal),
        actual: placed(seen),
    };
    let mut before = offsets(&worst.actual, &worst.ideal);
    for frame in 0..frames {
        let looked_at = if closed == Loop::Closed { &seen } else { &ideal };
        let step = towards(looked_at, order, frame, round);
        chain.advance(&step);
        exact.advance(&step);
        exact.keep(DualQuat::normalize);
        if matches!(repair, Repair::States | Repair::Both) {
            chain.keep(upkeep);
        }
        seen = levels(&chain).map(S::to_matrix);
        ideal = exact.models().map(DualQuat::to_matrix3x4);
        (worst.actual, worst.ideal) = (placed(seen), placed(ideal));
        let offset = offsets(&worst.actual, &worst.ideal);
        let [.., end] = worst.actual;
        let [motion, wanted] = [end, worst.ideal[LINKS]].map(DualQuat::from_matrix3x4);
        worst.position = worst.position.max(length(offset[LINKS]));
        worst.angle = worst.angle.max(motion.angle_to(wanted));
        for (model, pair) in seen.iter().zip(worst.actual.windows(2)) {
            worst.skew = worst.skew.max(matrix::skew(matrix::left(*model)));
            worst.stretch = worst.stretch.max(matrix::stretch(matrix::left(*model)));
            let apart = length(core::array::from_fn(|i| pair[1][i][3] - pair[0][i][3]));
            // With the step behind the state the end is at the last joint.
            if apart > 0.5 {
                worst.link = worst.link.max((apart - 1.0).abs());
            }
        }
        for (now, before) in offset.iter().zip(before) {
            let jump = core::array::from_fn(|i| now[i] - before[i]);
            worst.jump = worst.jump.max(length(jump));
        }
        before = offset;
        if frame >= ARRIVAL {
            worst.missed = worst.missed.max(Miss::of(end, frame, round));
        }
    }
    worst
}

/// From the ideal place of each joint and of the end to the actual one.
fn offsets(actual: &Frames, ideal: &Frames) -> [[f64; 3]; LINKS + 1] {
    core::array::from_fn(|joint| core::array::from_fn(|i| actual[joint][i][3] - ideal[joint][i][3]))
}
