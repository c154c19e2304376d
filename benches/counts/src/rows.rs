//! The contests that are counted.

use crate::count;
use dq8_contest::caches::{Caches, Level};
use dq8_contest::task::{Motions, Operation, Shape, Task, Way};

/// As many transforms as contests have at least, wherever they are counted.
const CACHES: Caches = Caches { l1: 16 << 10, l2: 1 << 20, l3: 32 << 20 };

pub(crate) fn rows() -> Vec<(&'static str, Task)> {
    let pairs = |operation| Task::Pairs(operation, Level::L1);
    let points = |motions| Task::Points(motions, Level::L1);
    let crowd = |way| Task::Hierarchy(Shape::Crowd { instances: 64 }, way);
    let single = |shape| Task::Hierarchy(shape, Way::Out);
    vec![
        ("product", pairs(Operation::Product)),
        ("crowd in place", crowd(Way::In)),
        ("crowd out of place", crowd(Way::Out)),
        ("crowd from rotations", crowd(Way::Rotations)),
        ("skeleton of 64", single(Shape::Crowd { instances: 1 })),
        ("biped", single(Shape::Biped)),
        ("chain of 1000", single(Shape::Chain { joints: 1000 })),
        ("points by one motion", points(Motions::One)),
        ("points each", points(Motions::Each)),
        ("normalize", pairs(Operation::Normalize)),
        ("NLERP", pairs(Operation::Nlerp)),
        ("ScLERP", pairs(Operation::Sclerp)),
        ("animated crowd", Task::Animation(64)),
        ("skin", Task::Skin),
    ]
}

pub(crate) fn count_all(task: &Task) {
    task.with_contest(&CACHES, |contest| {
        for contender in &contest.contenders {
            let mut run = (contender.start)();
            count(&contender.name, contest.transforms, |passes| {
                run.time(passes);
            });
        }
    });
}
