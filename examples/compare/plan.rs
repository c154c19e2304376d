//! The plan of a whole run.

use dq8_contest::caches::Level;
use dq8_contest::task::{Motions, Operation, Shape, Task, Way};

/// Everything, or with `quick` what fits into the first caches.
pub(crate) fn plan(quick: bool) -> Vec<Task> {
    let levels: &[Level] = if quick { &[Level::L1] } else { &Level::ALL };
    let instances: &[usize] = if quick { &[64] } else { &[64, 1024] };
    let mut tasks = vec![Task::Bandwidth];
    tasks.extend(levels.iter().map(|&level| Task::Pairs(Operation::Product, level)));
    for &instances in instances {
        tasks.extend(
            [Way::In, Way::Out, Way::Rotations]
                .map(|way| Task::Hierarchy(Shape::Crowd { instances }, way)),
        );
    }
    for shape in [Shape::Crowd { instances: 1 }, Shape::Biped, Shape::Chain { joints: 1000 }] {
        tasks.push(Task::Hierarchy(shape, Way::Out));
    }
    for motions in [Motions::One, Motions::Each] {
        tasks.extend(levels.iter().map(|&level| Task::Points(motions, level)));
    }
    for operation in [Operation::Normalize, Operation::Nlerp, Operation::Sclerp] {
        tasks.push(Task::Pairs(operation, Level::L1));
    }
    tasks
}

#[cfg(test)]
mod tests {
    use super::plan;
    use crate::progress::Progress;
    use crate::race::{Effort, race};
    use crate::results::Results;
    use dq8_contest::caches::Caches;
    use dq8_contest::task::Task;
    use std::time::Duration;

    #[test]
    fn every_contender_is_right() {
        let effort = Effort { budget: Duration::ZERO, fewest_rounds: 1, most_rounds: 1 };
        let (caches, mut results) = (Caches::of_this_machine(), Results::default());
        // Gigabytes, and nothing to check.
        for task in plan(true).iter().filter(|task| !matches!(task, Task::Bandwidth)) {
            task.with_contest(&caches, |contest| {
                race(contest, effort, &mut Progress::silent(), &mut results).unwrap();
            });
        }
        for job in ["J1", "J2", "J3", "J4", "J5"] {
            let mut own = results.rows.iter().filter(|row| row.job == job && row.is_own());
            assert!(own.any(|row| row.min > 0.0), "{job}");
        }
    }
}
