//! [`Task`]: what is to be measured.

mod animation;
mod hierarchy;
mod pairs;
mod points;

pub use crate::scene::Shape;
pub use hierarchy::Way;
pub use pairs::Operation;
pub use points::Motions;

use crate::caches::{Caches, Level};
use crate::contest::Contest;
use crate::limit::Limit;

/// A contest whose data are not made yet.
#[derive(Clone, Copy)]
pub enum Task {
    Bandwidth,
    Pairs(Operation, Level),
    Hierarchy(Shape, Way),
    Points(Motions, Level),
    /// So many characters.
    Animation(usize),
}

impl Task {
    /// Makes the data and hands the contest to `run`.
    pub fn with_contest<R>(&self, caches: &Caches, run: impl FnOnce(&Contest<'_>) -> R) -> R {
        match *self {
            Self::Bandwidth => run(&bandwidth(caches)),
            Self::Pairs(operation, level) => pairs::with_contest(operation, level, caches, run),
            Self::Hierarchy(shape, way) => hierarchy::with_contest(shape, way, run),
            Self::Points(motions, level) => points::with_contest(motions, level, caches, run),
            Self::Animation(instances) => animation::with_contest(instances, run),
        }
    }
}

/// No contest, only limits: memory beyond the last cache.
fn bandwidth(caches: &Caches) -> Contest<'static> {
    let bytes = caches.l3 / 8 * 9;
    let limits = vec![Limit::copy("DRAM", bytes), Limit::triad("DRAM", bytes)];
    Contest { limits, ..Contest::new("limits", "DRAM", "copy and triad") }
}

#[cfg(test)]
mod tests {
    use super::{Motions, Operation, Shape, Task, Way};
    use crate::caches::{Caches, Level};

    /// Every task that anyone runs, small.
    fn all() -> Vec<Task> {
        let crowd = |instances| Shape::Crowd { instances };
        let mut tasks: Vec<_> =
            Operation::ALL.map(|operation| Task::Pairs(operation, Level::L1)).into();
        tasks.extend([Motions::One, Motions::Each].map(|by| Task::Points(by, Level::L1)));
        tasks.push(Task::Animation(64));
        tasks.extend([Way::In, Way::Out, Way::Rotations].map(|w| Task::Hierarchy(crowd(64), w)));
        tasks.extend([1, 8].map(|instances| Task::Hierarchy(crowd(instances), Way::In)));
        for shape in [
            crowd(1),
            Shape::Biped,
            Shape::Chain { joints: 1000 },
            Shape::Chains { count: 4 },
            Shape::Tree { children: 4 },
        ] {
            tasks.extend([Way::Out, Way::Strategies].map(|way| Task::Hierarchy(shape, way)));
        }
        tasks
    }

    #[test]
    fn every_contender_is_right() {
        for task in all() {
            task.with_contest(&Caches::of_this_machine(), |contest| {
                let own = contest.contenders.iter().filter(|c| c.name.starts_with("dq8 ")).count();
                assert!(own > 0, "{} {}", contest.job, contest.size);
                for contender in &contest.contenders {
                    let mut run = (contender.start)();
                    contest.check(contender, &mut *run).unwrap();
                }
            });
        }
    }
}
