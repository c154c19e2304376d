//! Joint hierarchies against 4×4 matrices, in every layout on every backend.

use crate::records::{assert_same_bits, equal, same_bits, splice};
use crate::scene::{MAX_INSTANCES, On, Scene, Wanted, chain, rounded, scene};
use crate::subject::{Given, Root, Subject, Task, for_every_subject};
use core::num::NonZeroU32;
use core::ops::Range;
use dq8::{Backend, DualQuat, Hierarchy, hierarchy::Renormalize};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 20,
        max_shrink_iters: 200,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn a_model_is_the_product_of_the_matrices_from_its_root_down(scene in scene()) {
        models_of_every_subject(&scene, On::Nothing, scene.all());
    }

    #[test]
    fn one_root_transform_stands_before_every_instance(scene in scene()) {
        models_of_every_subject(&scene, On::Same, scene.all());
    }

    #[test]
    fn every_instance_stands_on_its_own_root_transform(scene in scene()) {
        models_of_every_subject(&scene, On::Each, scene.all());
    }

    #[test]
    fn a_range_of_models_stands_on_the_models_before_it(scene in scene(), on in On::any()) {
        models_of_every_subject(&scene, on, scene.range.clone());
    }

    #[test]
    fn a_local_is_the_model_seen_from_its_parent(scene in scene(), on in On::any()) {
        locals_of_every_subject(&scene, on, scene.all());
    }

    #[test]
    fn a_range_of_locals_leaves_the_others_alone(scene in scene(), on in On::any()) {
        locals_of_every_subject(&scene, on, scene.range.clone());
    }

    #[test]
    fn model_to_local_undoes_local_to_model(scene in scene(), on in On::any()) {
        let wanted = scene.every(|instance| scene.round_trip(instance, on));
        for_every_subject(|s, b| there_and_back(s, b, &scene, on, &wanted));
    }
}

fn models_of_every_subject(scene: &Scene, on: On, range: Range<usize>) {
    let wanted = scene.every(|instance| scene.models(instance, on, &range));
    for_every_subject(|s, b| models(s, b, scene, on, &range, &wanted));
}

fn locals_of_every_subject(scene: &Scene, on: On, range: Range<usize>) {
    let wanted = scene.every(|instance| scene.locals(instance, on, &range));
    for_every_subject(|s, b| locals(s, b, scene, on, &range, &wanted));
}

/// Runs the joints of `range` out of place and in place; both must agree with the matrices, with
/// each other to the bit, and leave the other joints as they were.
fn models(
    subject: &dyn Subject,
    backend: Backend,
    scene: &Scene,
    on: On,
    range: &Range<usize>,
    wanted: &[Vec<Wanted>],
) {
    let (joints, instances) = (scene.joints(), scene.instances(subject));
    let (locals, given) = (scene.poses(instances), scene.others(instances));
    // NaN wherever nothing may be read: locals outside the range, models of the range to come.
    let unread = vec![[f64::NAN; 8]; locals.len()];
    let before = splice(joints, range, &unread, &given);
    let in_place = splice(joints, range, &locals, &given);
    let locals = splice(joints, range, &locals, &unread);

    let roots = scene.roots();
    let task = Task { joints: range.clone(), ..scene.task(backend, on, &roots) };
    let models = subject.forward(&task, Given::Poses(&locals), &before);
    let in_place = subject.forward(&task, Given::InPlace, &in_place);

    assert_same_bits(&models, &in_place, "in place is not out of place");
    let outside = |models: &[_]| splice(joints, range, &unread, &models[..unread.len()]);
    let given = rounded(subject.single(), &given);
    assert_same_bits(&outside(&models), &outside(&given), "joints outside the range");
    assert_all(subject, scene, &models, wanted);
}

/// The same for model_to_local, where parents on either side of the range are read as models.
fn locals(
    subject: &dyn Subject,
    backend: Backend,
    scene: &Scene,
    on: On,
    range: &Range<usize>,
    wanted: &[Vec<Wanted>],
) {
    let (joints, instances) = (scene.joints(), scene.instances(subject));
    let (models, given) = (scene.poses(instances), scene.others(instances));
    let unread = vec![[f64::NAN; 8]; models.len()];
    let before = splice(joints, range, &unread, &given);

    let roots = scene.roots();
    let task = Task { joints: range.clone(), ..scene.task(backend, on, &roots) };
    let locals = subject.backward(&task, Some(&models), &before);
    let in_place = subject.backward(&task, None, &models);

    let outside = |locals: &[_]| splice(joints, range, &unread, &locals[..unread.len()]);
    let round = |records: &[[f64; 8]]| rounded(subject.single(), records);
    assert_same_bits(&outside(&locals), &outside(&round(&given)), "joints outside the range");
    assert_same_bits(&outside(&in_place), &outside(&round(&models)), "outside, in place");
    let inside = |locals: &[_]| splice(joints, range, &locals[..unread.len()], &unread);
    assert_same_bits(&inside(&locals), &inside(&in_place), "in place is not out of place");
    assert_all(subject, scene, &locals, wanted);
}

/// The locals come back as exactly as the models on the way could hold them.
fn there_and_back(
    subject: &dyn Subject,
    backend: Backend,
    scene: &Scene,
    on: On,
    wanted: &[Vec<Wanted>],
) {
    let (locals, roots) = (scene.poses(scene.instances(subject)), scene.roots());
    let task = scene.task(backend, on, &roots);
    let models = subject.forward(&task, Given::InPlace, &locals);
    let poses = subject.backward(&task, None, &models[..locals.len()]);
    assert_all(subject, scene, &poses, wanted);
}

fn assert_all(subject: &dyn Subject, scene: &Scene, poses: &[[f64; 8]], wanted: &[Vec<Wanted>]) {
    let instances = scene.instances(subject);
    let poses = poses.chunks_exact(scene.joints().max(1)).take(instances);
    for (instance, poses) in poses.enumerate() {
        for (joint, (pose, wanted)) in poses.iter().zip(&wanted[instance]).enumerate() {
            wanted.assert_is(subject.single(), pose, || {
                format!("{}, instance {instance} of {instances}, joint {joint}", subject.name())
            });
        }
    }
}

#[test]
fn any_number_of_instances_from_none_to_two_blocks_and_one_is_computed() {
    let most = Scene::small(MAX_INSTANCES);
    for (on, range) in On::ALL.into_iter().flat_map(|on| most.ranges().map(|range| (on, range))) {
        let modelled = most.every(|instance| most.models(instance, on, &range));
        let local = most.every(|instance| most.locals(instance, on, &range));
        for instances in 0..=MAX_INSTANCES {
            let scene = Scene::small(instances);
            for_every_subject(|subject, backend| {
                // More than this layout is given were fewer before.
                if scene.instances(subject) == instances {
                    models(subject, backend, &scene, on, &range, &modelled);
                    locals(subject, backend, &scene, on, &range, &local);
                }
            });
        }
    }
}

/// Every instance is moved on by one place and so into every lane, full and partial blocks alike.
#[test]
fn an_instance_gets_the_same_bits_in_every_lane() {
    for_every_subject(|subject, backend| {
        let lanes = if subject.things() == 1 { 16 } else { subject.things() };
        let scene = Scene::small(2 * lanes + 1);
        let (joints, mut poses) = (scene.joints(), scene.poses(scene.instances(subject)));
        let task = Task::new(&scene.parents, backend);
        let run = |poses: &[[f64; 8]]| {
            let models = subject.forward(&task, Given::InPlace, poses);
            models[..poses.len()].to_vec()
        };
        let mut models = run(&poses);
        for _ in 0..scene.instances(subject) {
            poses.rotate_left(joints);
            models.rotate_left(joints);
            let got = run(&poses);
            let plain = subject.things() == 1;
            // Plain motions are computed in two ways, which are alike but for the signs of zeros.
            let alike = |(a, b): (&[f64; 8], &[f64; 8])| {
                if plain { equal(a, b) } else { same_bits(a, b) }
            };
            assert!(got.iter().zip(&models).all(alike), "{} on {backend}", subject.name());
        }
    });
}

/// Only a root transform that all instances share reaches the lanes without an instance: a job does
/// not know how many of the last block are in use. They hold that root then, a motion like any
/// other.
#[test]
fn lanes_without_an_instance_stay_at_the_identity() {
    let identity = DualQuat::<f64>::IDENTITY.to_array();
    for instances in 0..=MAX_INSTANCES {
        let scene = Scene::small(instances);
        for_every_subject(|subject, backend| {
            if scene.instances(subject) != instances {
                return;
            }
            let (poses, roots) = (scene.poses(instances), scene.roots());
            let shared = rounded(subject.single(), &roots[..1])[0];
            for (root, wanted) in [
                (Root::None, identity),
                (Root::Each(&roots[..instances]), identity),
                (Root::Same(roots[0]), shared),
            ] {
                let task = Task { root, ..Task::new(&scene.parents, backend) };
                let models = subject.forward(&task, Given::InPlace, &poses);
                assert!(models[poses.len()..].iter().all(|model| *model == wanted), "{root:?}");
                assert!(models.len() - poses.len() < subject.things() * scene.joints());
                if wanted == identity {
                    let locals = subject.backward(&task, None, &models[..poses.len()]);
                    assert!(locals[poses.len()..].iter().all(|local| *local == identity));
                }
            }
        });
    }
}

#[test]
fn a_hierarchy_of_no_joints_takes_slices_of_no_poses() {
    let nobody = Hierarchy::new(&[]).expect("it is empty");
    assert_eq!((nobody.joints(), nobody.parents()), (0, &[][..]));
    for_every_subject(|subject, backend| {
        for root in [Root::None, Root::Each(&[])] {
            let task = Task { root, ..Task::new(&[], backend) };
            assert!(subject.forward(&task, Given::Poses(&[]), &[]).is_empty());
            assert!(subject.forward(&task, Given::InPlace, &[]).is_empty());
            assert!(subject.backward(&task, Some(&[]), &[]).is_empty());
            assert!(subject.backward(&task, None, &[]).is_empty());
        }
    });
}

#[test]
fn an_empty_range_computes_nothing() {
    let scene = Scene::small(1);
    for at in 0..=scene.joints() {
        models_of_every_subject(&scene, On::Each, at..at);
        locals_of_every_subject(&scene, On::Each, at..at);
    }
}

/// Locals of norm 1¼, so that a model that is not normalized shows how many came before it.
#[test]
fn every_nth_joint_is_normalized_and_no_other() {
    let parents = chain(7);
    let step = DualQuat::from_translation([2.0, 0.0, 0.0]).scale(1.25).to_array();
    let every = |n: u32| Renormalize::Every(NonZeroU32::new(n).expect("not 0"));
    let powers: Vec<f64> = (1..=7).map(|n| 1.25_f64.powi(n)).collect();
    for_every_subject(|subject, backend| {
        // One instance, and as many as are computed in lanes.
        for instances in [1, 17] {
            let norms = |renormalize: Renormalize, joints: Range<usize>| -> Vec<f64> {
                let task = Task { joints, renormalize, ..Task::new(&parents, backend) };
                let models = subject.forward(&task, Given::InPlace, &vec![step; 7 * instances]);
                let norm = |model: &[f64; 8]| DualQuat::from_array(*model).real().norm();
                let norms: Vec<f64> = models[..7 * instances].iter().map(norm).collect();
                assert!(norms.chunks(7).all(|of_instance| of_instance == &norms[..7]));
                norms[..7].to_vec()
            };
            assert_eq!(norms(Renormalize::Never, 0..7), powers);
            assert_eq!(norms(Renormalize::default(), 0..7), powers);
            assert_eq!(norms(every(1), 0..7), [1.0; 7]);
            assert_eq!(norms(every(3), 0..7), [1.25, 1.5625, 1.0, 1.25, 1.5625, 1.0, 1.25]);
            assert_eq!(norms(every(8), 0..7), powers);
            // Counted along the parent array, not from the start of the range: joints 2 and 5.
            assert_eq!(norms(every(3), 1..4), [1.25, 1.5625, 1.0, 1.25, 1.25, 1.25, 1.25]);
        }
    });
}

/// Recursion would need a frame for each joint: three thousand do not fit the stack of this thread.
#[test]
fn a_long_chain_needs_no_stack() {
    fn check() {
        let parents = chain(3000);
        // Whole numbers of a unit step, so that every sum is exact in f32 too.
        let at = |joints: f64| DualQuat::from_translation([0.0, 2.0 * joints, -joints]).to_array();
        let locals = vec![at(1.0); parents.len()];
        let wanted: Vec<_> = (1..=parents.len()).map(|joints| at(joints as f64)).collect();
        for_every_subject(|subject, backend| {
            let task = Task::new(&parents, backend);
            let models = subject.forward(&task, Given::InPlace, &locals);
            assert!(models[..locals.len()] == wanted, "{} on {backend}", subject.name());
            let back = subject.backward(&task, None, &models[..locals.len()]);
            assert!(back[..locals.len()] == locals);
        });
    }
    let small_stack = std::thread::Builder::new().stack_size(128 * 1024);
    small_stack.spawn(check).expect("a thread").join().expect("the stack is enough");
}
