//! The result of an instance is the same, however many instances stand around it.
//!
//! Plain motions are computed in lanes of instances, those left over one by one: two ways to the
//! same sums. Signs of zeros may differ, nothing else.

use crate::records::equal;
use crate::scene::{Forms, MAX_INSTANCES, On, Scene, tree};
use crate::subject::{Given, Subject, Task, for_every_subject};
use dq8::{
    Hierarchy,
    hierarchy::{MatrixOrder, Renormalize},
};
use dq8_contract::random::Random;

/// Fewer than lanes, as many, and some more; the last is what the others are held against.
/// Instances of blocks have their lanes, wherever others are: one, a block, and one more.
fn counts(subject: &dyn Subject) -> Vec<usize> {
    match subject.things() {
        1 => vec![1, 7, 16, 17, MAX_INSTANCES],
        lanes => vec![1, lanes, lanes + 1],
    }
}

/// Near parents and far ones: more than 16 joints back they are read from memory again.
fn parents() -> Vec<u32> {
    let mut parents = tree(&mut Random(4), 44, 12, 1000);
    for (joint, parent) in [(15, 0), (16, 0), (17, 0), (18, 1), (33, 17), (34, 17), (35, 20)] {
        parents[joint] = parent;
    }
    parents
}

/// What a job may be told: what roots stand on, which joints, and when it normalizes.
fn tasks<'a>(scene: &'a Scene, roots: &'a [[f64; 8]], backend: dq8::Backend) -> Vec<Task<'a>> {
    let every = Renormalize::Every(3.try_into().expect("not 0"));
    let [nothing, same, each] = On::ALL.map(|on| scene.task(backend, on, roots));
    vec![
        Task { joints: 18..41, ..nothing.clone() },
        nothing,
        Task { renormalize: every, order: MatrixOrder::Columns, ..same },
        Task { joints: 3..40, renormalize: every, ..each.clone() },
        each,
    ]
}

#[track_caller]
fn assert_prefix<T: AsRef<[f64]>>(few: &[T], many: &[T], count: usize, what: &str) {
    for (index, (few, many)) in few.iter().zip(many).take(count).enumerate() {
        let (few, many) = (few.as_ref(), many.as_ref());
        assert!(equal(few, many), "{what}, {index} of {count}: {few:?} is not {many:?}");
    }
}

#[test]
fn models_and_palettes_are_the_same_however_many_instances_stand_around_them() {
    let parents = parents();
    Hierarchy::new(&parents).expect("parents come first");
    let scene = Scene::new(&parents, MAX_INSTANCES, 31);
    let (forms, roots, binds) = (Forms::new(&scene, MAX_INSTANCES), scene.roots(), scene.binds());
    let others = scene.others(MAX_INSTANCES);
    let joints = parents.len();
    for_every_subject(|subject, backend| {
        for task in tasks(&scene, &roots, backend) {
            for form in 0..4 {
                let run = |instances: usize| {
                    let given = forms.first(instances)[form];
                    let in_place = matches!(given, Given::InPlace);
                    let before = if in_place { &forms.poses } else { &others };
                    let models = subject.forward(&task, given, &before[..instances * joints]);
                    if in_place {
                        return (models, Vec::new());
                    }
                    (models, subject.palette(&task, given, &binds, 9.0).1)
                };
                let mut counts = counts(subject);
                let all = run(counts.pop().expect("some"));
                for instances in counts {
                    let some = run(instances);
                    let what = format!("{} on {backend}, form {form}, {task:?}", subject.name());
                    assert_prefix(&some.0, &all.0, instances * joints, &what);
                    assert_prefix(&some.1, &all.1, instances * joints, &what);
                }
            }
        }
    });
}

#[test]
fn locals_are_the_same_however_many_instances_stand_around_them() {
    let scene = Scene::new(&parents(), MAX_INSTANCES, 32);
    let (models, roots) = (scene.poses(MAX_INSTANCES), scene.roots());
    let (joints, others) = (scene.joints(), scene.others(MAX_INSTANCES));
    for_every_subject(|subject, backend| {
        for task in tasks(&scene, &roots, backend) {
            let run = |instances: usize| {
                let end = instances * joints;
                let locals = subject.backward(&task, Some(&models[..end]), &others[..end]);
                let in_place = subject.backward(&task, None, &models[..end]);
                (locals, in_place)
            };
            let mut counts = counts(subject);
            let all = run(counts.pop().expect("some"));
            for instances in counts {
                let some = run(instances);
                let what = format!("{} on {backend}, {task:?}", subject.name());
                let count = instances * joints;
                assert_prefix(&some.0, &all.0, count, &what);
                assert_prefix(&some.1, &all.1, count, &what);
            }
        }
    });
}
