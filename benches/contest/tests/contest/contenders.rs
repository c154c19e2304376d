//! Whoever is timed computes the right thing.

use dq8_contest::caches::{Caches, Level};
use dq8_contest::task::{Motions, Operation, Shape, Task, Way};

/// Every task that anyone runs, small.
fn all() -> Vec<Task> {
    let crowd = |instances| Shape::Crowd { instances };
    let mut tasks: Vec<_> =
        Operation::ALL.map(|operation| Task::Pairs(operation, Level::L1)).into();
    tasks.extend([Motions::One, Motions::Each].map(|by| Task::Points(by, Level::L1)));
    tasks.extend([Task::Animation(64), Task::Locals(64, 21)]);
    tasks.extend([Way::In, Way::Out, Way::Rotations].map(|w| Task::Hierarchy(crowd(64), w)));
    tasks.push(Task::Skin);
    tasks.extend([1, 8].map(|instances| Task::Hierarchy(crowd(instances), Way::In)));
    for shape in [
        crowd(1),
        Shape::Biped,
        Shape::Chain { joints: 1000 },
        Shape::Chains { count: 4 },
        Shape::Tree { children: 4 },
    ] {
        tasks.extend([Task::Hierarchy(shape, Way::Out)]);
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
