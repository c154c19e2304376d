//! [`Task`]: what is to be measured.

mod hierarchy;
mod skin;

pub use crate::scene::Shape;
pub use hierarchy::Way;
pub use pairs::Operation;
pub use points::Motions;

use crate::caches::{Caches, Level};
use crate::contest::Contest;
use crate::limit::Limit;
use dq8_contest_crowd::animation;
use dq8_contest_slices::{pairs, points};

/// A contest whose data are not made yet.
#[derive(Clone, Copy)]
pub enum Task {
    Bandwidth,
    Pairs(Operation, Level),
    Hierarchy(Shape, Way),
    Points(Motions, Level),
    /// So many characters.
    Animation(usize),
    /// Their locals alone, of so many characters and joints.
    Locals(usize, usize),
    Skin,
}

impl Task {
    /// The job that it is a contest of; the speed of the memory is none.
    pub fn job(&self) -> Option<&'static str> {
        Some(match self {
            Self::Bandwidth => return None,
            Self::Pairs(Operation::Product, _) => "J1",
            Self::Hierarchy(Shape::Crowd { instances: 2.. }, _) => "J2",
            Self::Hierarchy(..) => "J3",
            Self::Points(..) => "J4",
            Self::Pairs(..) => "J5",
            Self::Animation(_) | Self::Locals(..) => "J6",
            Self::Skin => "J7",
        })
    }

    /// Makes the data and hands the contest to `run`.
    pub fn with_contest<R>(&self, caches: &Caches, run: impl FnOnce(&Contest<'_>) -> R) -> R {
        let (mut run, mut result) = (Some(run), None);
        self.show(caches, &mut |contest| result = run.take().map(|run| run(contest)));
        result.expect("each task shows its contest once")
    }

    /// Not generic: contests are compiled once, here, and not by everyone who runs them.
    fn show(&self, caches: &Caches, run: &mut dyn FnMut(&Contest<'_>)) {
        match *self {
            Self::Bandwidth => run(&bandwidth(caches)),
            Self::Pairs(operation, level) => pairs::with_contest(operation, level, caches, run),
            Self::Hierarchy(shape, way) => hierarchy::with_contest(shape, way, run),
            Self::Points(motions, level) => points::with_contest(motions, level, caches, run),
            Self::Animation(instances) => animation::with_contest(instances, run),
            Self::Locals(instances, joints) => {
                animation::with_locals_contest(instances, joints, run);
            }
            Self::Skin => skin::with_contest(run),
        }
    }
}

/// No contest, only limits: memory beyond the last cache.
fn bandwidth(caches: &Caches) -> Contest<'static> {
    let bytes = caches.l3 / 8 * 9;
    let limits = vec![Limit::copy("DRAM", bytes), Limit::triad("DRAM", bytes)];
    Contest { limits, ..Contest::new("limits", "DRAM", "copy and triad") }
}
