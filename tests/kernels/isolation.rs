//! Lanes are joints, instances or segments: what is no number in one of them stays out of the
//! others.

use crate::records::{is_finite, same_bits};
use crate::scene::{Forms, MAX_INSTANCES, On, Scene, chain, motions};
use crate::subject::{Given, Subject, Task, for_every_subject};
use dq8::{Backend, hierarchy::Renormalize};
use dq8_contract::random::Random;

const POISONS: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// Three trees, and joints far from their parents.
const PARENTS: [u32; 22] = {
    const ROOT: u32 = crate::scene::ROOT;
    [ROOT, 0, 1, 1, 3, 0, ROOT, 6, 7, 8, 7, 2, ROOT, 12, 5, 5, 14, 3, 0, 1, 6, 12]
};

/// The instance, the joint, the component that is no number, and what it is.
const PLACES: [(usize, usize, usize, f64); 8] = [
    (0, 0, 0, f64::NAN),
    (1, 1, 3, f64::INFINITY),
    (9, 6, 5, f64::NEG_INFINITY),
    (16, 3, 7, f64::NAN),
    (32, 12, 1, f64::INFINITY),
    (7, 5, 4, f64::NAN),
    (2, 6, 6, f64::INFINITY),
    // One that is left over where instances are computed together.
    (32, 7, 5, f64::INFINITY),
];

/// As many instances as show all lanes and what is left over, and the places among them.
fn instances(subject: &dyn Subject) -> usize {
    if subject.things() == 1 { MAX_INSTANCES } else { subject.things() + 1 }
}

fn places(instances: usize) -> impl Iterator<Item = (usize, usize, usize, f64)> {
    PLACES
        .into_iter()
        .map(move |(at, of, component, poison)| (at % instances, of, component, poison))
}

/// Whether `joint` is `of` or descends from it.
fn descends(joint: usize, of: usize) -> bool {
    let parent =
        |&joint: &usize| PARENTS.get(PARENTS[joint] as usize).map(|_| PARENTS[joint] as usize);
    std::iter::successors(Some(joint), parent).any(|ancestor| ancestor == of)
}

/// Every record of `with` is that of `without`, to the bit, except where `reached` by what is none.
#[track_caller]
fn assert_untouched<T: AsRef<[f64]>>(
    with: &[T],
    without: &[T],
    what: &str,
    reached: impl Fn(usize, usize) -> bool,
) {
    for (index, (with, without)) in with.iter().zip(without).enumerate() {
        let (instance, joint) = (index / PARENTS.len(), index % PARENTS.len());
        if !reached(instance, joint) {
            let same = same_bits(with.as_ref(), without.as_ref());
            assert!(same, "{what}: it reached joint {joint} of instance {instance}");
        }
    }
}

/// Rotations do not know of translations, whatever those are.
#[track_caller]
fn assert_same_rotations(with: &[[f64; 8]], without: &[[f64; 8]], what: &str) {
    for (with, without) in with.iter().zip(without) {
        assert!(same_bits(&with[..4], &without[..4]), "{what}: {with:?} is not {without:?}");
    }
}

fn what(
    subject: &dyn Subject,
    backend: Backend,
    place: impl core::fmt::Debug,
    poison: f64,
) -> String {
    format!("{} on {backend}, {poison} in {place:?}", subject.name())
}

#[test]
fn a_local_that_is_no_number_reaches_the_descendants_of_its_joint_only() {
    let scene = Scene::new(&PARENTS, MAX_INSTANCES, 41);
    let (roots, binds) = (scene.roots(), scene.binds());
    let clean = Forms::new(&scene, MAX_INSTANCES);
    let every = Renormalize::Every(2.try_into().expect("not 0"));
    for_every_subject(|subject, backend| {
        let instances = instances(subject);
        // Half of the places with each.
        let tasks = [(On::Nothing, Renormalize::Never), (On::Each, every)];
        for (first, (on, renormalize)) in tasks.into_iter().enumerate() {
            let task = Task { renormalize, ..scene.task(backend, on, &roots) };
            for form in 0..4 {
                let run = |forms: &Forms| {
                    let given = forms.first(instances)[form];
                    let before = &forms.poses[..instances * PARENTS.len()];
                    let models = subject.forward(&task, given, before);
                    let palette = match given {
                        Given::InPlace => Vec::new(),
                        _ => subject.palette(&task, given, &binds, 9.0).1,
                    };
                    (models, palette)
                };
                let without = run(&clean);
                for (at, of, component, poison) in places(instances).skip(first).step_by(2) {
                    let mut forms = clean.clone();
                    forms.poison(at * PARENTS.len() + of, component, poison);
                    let with = run(&forms);
                    let what = what(subject, backend, (form, at, of, component), poison);
                    let reached = |instance, joint| instance == at && descends(joint, of);
                    assert_untouched(&with.0, &without.0, &what, reached);
                    assert_untouched(&with.1, &without.1, &what, reached);
                    assert!(!is_finite(&with.0[at * PARENTS.len() + of]), "{what}: it is lost");
                    if [component, component % 7, 0, component][form] >= 4 {
                        assert_same_rotations(&with.0, &without.0, &what);
                    }
                }
            }
        }
    });
}

#[test]
fn a_root_that_is_no_number_reaches_its_instance_and_a_bind_its_joint_only() {
    let scene = Scene::new(&PARENTS, MAX_INSTANCES, 42);
    let (clean, binds) = (scene.roots(), scene.binds());
    let forms = Forms::new(&scene, MAX_INSTANCES);
    for_every_subject(|subject, backend| {
        let instances = instances(subject);
        let run = |form: usize, roots: &[[f64; 8]], binds: &[[f64; 8]]| {
            let task = scene.task(backend, On::Each, roots);
            subject.palette(&task, forms.first(instances)[form], binds, 9.0)
        };
        for form in 0..3 {
            let without = run(form, &clean, &binds);
            // Each place with one form or another.
            for (at, of, component, poison) in places(instances).skip(form).step_by(3) {
                let what = what(subject, backend, (form, at, of, component), poison);
                let mut roots = clean.clone();
                roots[at][component] = poison;
                let with = run(form, &roots, &binds);
                assert_untouched(&with.0, &without.0, &what, |instance, _| instance == at);
                assert_untouched(&with.1, &without.1, &what, |instance, _| instance == at);
                assert!(!is_finite(&with.0[at * PARENTS.len()]), "{what}: it is lost");

                let mut poisoned = binds.clone();
                poisoned[of][component] = poison;
                let with = run(form, &clean, &poisoned);
                assert_untouched(&with.0, &without.0, &what, |_, _| false);
                assert_untouched(&with.1, &without.1, &what, |_, joint| joint == of);
                assert!(!is_finite(&with.1[of]), "{what}: it is lost");
            }
        }
    });
}

#[test]
fn a_model_that_is_no_number_reaches_its_own_local_and_its_childrens_only() {
    let scene = Scene::new(&PARENTS, MAX_INSTANCES, 43);
    let (roots, clean) = (scene.roots(), scene.poses(MAX_INSTANCES));
    for_every_subject(|subject, backend| {
        let instances = instances(subject);
        let clean = &clean[..instances * PARENTS.len()];
        let task = scene.task(backend, On::Each, &roots);
        let run = |models: &[[f64; 8]]| {
            (subject.backward(&task, Some(models), clean), subject.backward(&task, None, models))
        };
        let without = run(clean);
        for (at, of, component, poison) in places(instances) {
            let mut models = clean.to_vec();
            models[at * PARENTS.len() + of][component] = poison;
            let with = run(&models);
            let what = what(subject, backend, (at, of, component), poison);
            let reached = |instance: usize, joint: usize| {
                instance == at && (joint == of || PARENTS[joint] as usize == of)
            };
            assert_untouched(&with.0, &without.0, &what, reached);
            assert_untouched(&with.1, &without.1, &what, reached);
            assert!(!is_finite(&with.0[at * PARENTS.len() + of]), "{what}: it is lost");
        }
    });
}

#[test]
fn a_link_that_is_no_number_reaches_the_products_from_it_on_only() {
    for_every_subject(|subject, backend| {
        for length in [1, 9, 50, 131] {
            let clean = motions(&mut Random(45), length);
            let without = subject.chain(backend, &clean);
            for at in [0, length / 9, length / 2, length - 1] {
                for (component, poison) in [0, 3, 6].into_iter().zip(POISONS) {
                    let mut links = clean.clone();
                    links[at][component] = poison;
                    let with = subject.chain(backend, &links);
                    let what = what(subject, backend, (at, length), poison);
                    let same = |i: usize| same_bits(&with[i], &without[i]);
                    assert!((0..at).all(same), "{what}: it reached what comes before");
                    assert!(!is_finite(&with[at]), "{what}: it is lost");
                    if component >= 4 {
                        assert_same_rotations(&with, &without, &what);
                    }
                }
            }
        }
    });
}

/// The same chain as a hierarchy of one instance, by a plan.
#[test]
fn a_plan_keeps_it_to_the_descendants_too() {
    let scene = Scene::new(&PARENTS, 1, 46);
    let clean = scene.poses(3);
    for (parents, backend) in
        [PARENTS.to_vec(), chain(66)].iter().flat_map(|p| Backend::available().map(move |b| (p, b)))
    {
        let skeleton = dq8::Skeleton::new(parents).expect("parents come first");
        let run = |locals: &[[f64; 8]]| {
            let mut poses: Vec<_> =
                locals.iter().map(|local| dq8::DualQuat::from_array(*local)).collect();
            let job = skeleton.job().backend(backend);
            job.local_to_model_in_place(&mut poses).expect("lengths fit");
            poses.iter().map(|pose| pose.to_array()).collect::<Vec<_>>()
        };
        let without = run(&clean);
        for (of, poison) in (0..66).flat_map(|of| POISONS.map(|poison| (of, poison))) {
            let mut locals = clean.clone();
            locals[of][of % 8] = poison;
            let with = run(&locals);
            if of % 8 >= 4 {
                assert_same_rotations(&with, &without, &format!("{of} on {backend}"));
            }
            for (index, (with, without)) in with.iter().zip(&without).enumerate() {
                let below = if parents.len() == 66 {
                    index >= of
                } else {
                    index / 22 == of / 22 && descends(index % 22, of % 22)
                };
                assert!(below || same_bits(with, without), "{of} reached {index} on {backend}");
            }
        }
    }
}
