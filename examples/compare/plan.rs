//! The plan of a whole run.

use dq8_contest::caches::Level;
use dq8_contest::task::{Motions, Operation, Shape, Task, Way};

pub(crate) const JOBS: [&str; 7] = ["J1", "J2", "J3", "J4", "J5", "J6", "J7"];

/// Everything, or with `quick` what fits into the first caches; of some jobs, if there are any.
pub(crate) fn plan(quick: bool, jobs: &[&str]) -> Vec<Task> {
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
    tasks.extend(instances.iter().map(|&instances| Task::Animation(instances)));
    for operation in [Operation::Normalize, Operation::Nlerp, Operation::Sclerp] {
        tasks.push(Task::Pairs(operation, Level::L1));
    }
    tasks.push(Task::Skin);
    // The speed of the memory is no job, and takes seconds.
    tasks.retain(|task| jobs.is_empty() || task.job().is_some_and(|job| jobs.contains(&job)));
    tasks
}

#[cfg(test)]
mod tests {
    use super::{JOBS, plan};
    use dq8_contest::caches::Caches;
    use dq8_contest::task::Task;
    use std::collections::BTreeSet;

    #[test]
    fn the_quick_plan_has_every_job_and_the_whole_one_has_more() {
        let caches = Caches::of_this_machine();
        let tasks = plan(true, &[]);
        // Gigabytes, and nothing to check.
        let contests = tasks.iter().filter(|task| !matches!(task, Task::Bandwidth));
        let jobs: BTreeSet<_> = contests
            .map(|task| {
                let job = task.with_contest(&caches, |contest| contest.job);
                assert_eq!(task.job(), Some(job));
                job
            })
            .collect();
        assert_eq!(jobs, BTreeSet::from(JOBS));
        assert!(plan(false, &[]).len() > tasks.len());
    }

    #[test]
    fn a_plan_of_some_jobs_has_no_other() {
        for job in JOBS {
            let tasks = plan(false, &[job]);
            assert!(!tasks.is_empty());
            assert!(tasks.iter().all(|task| task.job() == Some(job)), "{job}");
        }
    }
}
