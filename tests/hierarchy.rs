//! Joint hierarchies against 4×4 matrices, on plain slices and on blocks of every width.

#[path = "hierarchy/errors.rs"]
mod errors;
#[path = "hierarchy/layout.rs"]
mod layout;
#[path = "hierarchy/matrix.rs"]
mod matrix;
#[path = "hierarchy/scene.rs"]
mod scene;

use core::num::NonZeroU32;
use core::ops::Range;
use dq8::{DualQuat, Hierarchy, Renormalize};
use layout::{Layout, bits, for_every_layout};
use proptest::prelude::*;
use scene::{Root, Scene, Wanted, scene};

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 20,
        max_shrink_iters: 200,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn a_model_is_the_product_of_the_matrices_from_its_root_down(scene in scene()) {
        for_every_layout!(models(&scene, Root::None, scene.all()));
    }

    #[test]
    fn one_root_transform_stands_before_every_instance(scene in scene()) {
        for_every_layout!(models(&scene, Root::Same, scene.all()));
    }

    #[test]
    fn every_instance_stands_on_its_own_root_transform(scene in scene()) {
        for_every_layout!(models(&scene, Root::Each, scene.all()));
    }

    #[test]
    fn a_range_of_models_stands_on_the_models_before_it(scene in scene(), root in Root::any()) {
        for_every_layout!(models(&scene, root, scene.range.clone()));
    }

    #[test]
    fn a_local_is_the_model_seen_from_its_parent(scene in scene(), root in Root::any()) {
        for_every_layout!(locals(&scene, root, scene.all()));
    }

    #[test]
    fn a_range_of_locals_leaves_the_others_alone(scene in scene(), root in Root::any()) {
        for_every_layout!(locals(&scene, root, scene.range.clone()));
    }

    #[test]
    fn model_to_local_undoes_local_to_model(scene in scene(), root in Root::any()) {
        for_every_layout!(there_and_back(&scene, root));
    }
}

/// Runs the joints of `range` out of place and in place; both must agree with the matrices, with each
/// other to the bit, and leave the other joints as they were.
fn models<P: Layout>(scene: &Scene, root: Root, range: Range<usize>) {
    let (locals, given) = (scene.poses::<P>(), scene.others::<P>());
    // NaN wherever nothing may be read: locals outside the range, models of the range to come.
    let unread = vec![P::filled(f64::NAN); locals.len()];
    let mut models = scene.splice(&range, &unread, &given);
    let mut in_place = scene.splice(&range, &locals, &given);
    let locals = scene.splice(&range, &locals, &unread);

    let roots = scene.roots::<P>();
    let job = scene.job(root, &roots).joints(range.clone());
    job.local_to_model(&locals, &mut models).unwrap();
    job.local_to_model_in_place(&mut in_place).unwrap();

    assert_eq!(bits(&models), bits(&in_place), "in place is not out of place");
    let outside = |models: &[P]| scene.splice(&range, &unread, models);
    assert_eq!(bits(&outside(&models)), bits(&outside(&given)), "joints outside the range");
    for_every_pose(scene, &models, |instance| scene.models(instance, root, &range));
}

/// The same for model_to_local, where parents on either side of the range are read as models.
fn locals<P: Layout>(scene: &Scene, root: Root, range: Range<usize>) {
    let (models, given) = (scene.poses::<P>(), scene.others::<P>());
    let unread = vec![P::filled(f64::NAN); models.len()];
    let mut locals = scene.splice(&range, &unread, &given);
    let mut in_place = models.clone();

    let roots = scene.roots::<P>();
    let job = scene.job(root, &roots).joints(range.clone());
    job.model_to_local(&models, &mut locals).unwrap();
    job.model_to_local_in_place(&mut in_place).unwrap();

    let outside = |locals: &[P]| scene.splice(&range, &unread, locals);
    assert_eq!(bits(&outside(&locals)), bits(&outside(&given)), "joints outside the range");
    assert_eq!(bits(&outside(&in_place)), bits(&outside(&models)), "outside, in place");
    let inside = |locals: &[P]| scene.splice(&range, locals, &unread);
    assert_eq!(bits(&inside(&locals)), bits(&inside(&in_place)), "in place is not out of place");
    let wanted = |instance| {
        let others = scene.models(instance, root, &(0..0));
        let locals = scene.locals(instance, root);
        scene.splice(&range, &locals, &others)
    };
    for_every_pose(scene, &locals, wanted);
}

/// The locals come back as exactly as the models on the way could hold them.
fn there_and_back<P: Layout>(scene: &Scene, root: Root) {
    let (locals, roots) = (scene.poses::<P>(), scene.roots::<P>());
    let job = scene.job(root, &roots);
    let mut poses = locals.clone();
    job.local_to_model_in_place(&mut poses).unwrap();
    job.model_to_local_in_place(&mut poses).unwrap();
    for_every_pose(scene, &poses, |instance| scene.round_trip(instance, root));
}

fn for_every_pose<P: Layout>(scene: &Scene, elements: &[P], wanted: impl Fn(usize) -> Vec<Wanted>) {
    let (joints, instances) = (scene.joints(), scene.instances::<P>());
    let poses = P::flat(joints, instances, elements);
    for (instance, poses) in poses.chunks_exact(joints.max(1)).enumerate() {
        for (joint, (&pose, wanted)) in poses.iter().zip(wanted(instance)).enumerate() {
            wanted.assert_is(pose, || format!("instance {instance} of {instances}, joint {joint}"));
        }
    }
}

#[test]
fn any_number_of_instances_from_none_to_two_blocks_and_one_is_computed() {
    fn every_number<P: Layout>() {
        for instances in 0..=2 * P::INSTANCES + 1 {
            let scene = Scene::small(instances);
            assert_eq!(scene.instances::<P>(), instances);
            for root in [Root::None, Root::Same, Root::Each] {
                models::<P>(&scene, root, scene.all());
                models::<P>(&scene, root, scene.range.clone());
                locals::<P>(&scene, root, scene.all());
                locals::<P>(&scene, root, scene.range.clone());
            }
        }
    }
    for_every_layout!(every_number());
}

/// Every instance is moved on by one place and so into every lane, full and partial blocks alike.
#[test]
fn an_instance_gets_the_same_bits_in_every_lane() {
    fn every_lane<P: Layout>() {
        let instances = 2 * P::INSTANCES + 1;
        let scene = Scene::small(instances);
        let joints = scene.joints();
        let run = |poses: &[DualQuat<P::Real>]| {
            let mut elements = P::lay(joints, poses);
            let skeleton = Hierarchy::new(&scene.parents).unwrap();
            skeleton.local_to_model_in_place(&mut elements).unwrap();
            P::flat(joints, instances, &elements)
        };
        let mut poses = P::flat(joints, instances, &scene.poses::<P>());
        let mut models = run(&poses);
        for _ in 0..instances {
            poses.rotate_left(joints);
            models.rotate_left(joints);
            assert_eq!(bits(&run(&poses)), bits(&models));
        }
    }
    for_every_layout!(every_lane());
}

/// Only a root transform that all instances share reaches the lanes without an instance: a job does
/// not know how many of the last block are in use. They hold that root then, a motion like any other.
#[test]
fn lanes_without_an_instance_stay_at_the_identity() {
    fn padding<P: Layout>() {
        let identity = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
        for instances in 0..=2 * P::INSTANCES + 1 {
            let scene = Scene::small(instances);
            let roots = scene.roots::<P>();
            let used = instances % P::INSTANCES;
            let unused = if used == 0 { 0..0 } else { used..P::INSTANCES };
            let all_are = |poses: &[P], wanted: [f64; 8]| {
                for (pose, lane) in
                    poses.iter().rev().take(7).zip(core::iter::repeat(unused.clone()))
                {
                    lane.for_each(|lane| assert_eq!(pose.record(lane), wanted, "lane {lane}"));
                }
            };
            for root in [Root::None, Root::Each, Root::Same] {
                let job = scene.job(root, &roots);
                let mut poses = scene.poses::<P>();
                job.local_to_model_in_place(&mut poses).unwrap();
                let shared = matches!(root, Root::Same);
                all_are(&poses, if shared { scene.shared_root::<P>() } else { identity });
                job.model_to_local_in_place(&mut poses).unwrap();
                if !shared {
                    all_are(&poses, identity);
                }
            }
        }
    }
    for_every_layout!(padding());
}

#[test]
fn a_hierarchy_of_no_joints_takes_slices_of_no_poses() {
    fn nothing<P: Layout>() {
        let nobody = Hierarchy::new(&[]).unwrap();
        assert_eq!((nobody.joints(), nobody.parents()), (0, &[][..]));
        nobody.local_to_model::<P>(&[], &mut []).unwrap();
        nobody.local_to_model_in_place::<P>(&mut []).unwrap();
        nobody.model_to_local::<P>(&[], &mut []).unwrap();
        nobody.model_to_local_in_place::<P>(&mut []).unwrap();
        nobody.job::<P>().roots(&[]).joints(0..0).local_to_model_in_place(&mut []).unwrap();
    }
    for_every_layout!(nothing());
}

#[test]
fn no_instances_are_a_whole_number_of_instances() {
    fn nobody<P: Layout>() {
        let arm = Hierarchy::new(&[Hierarchy::ROOT, 0, 1]).unwrap();
        arm.local_to_model::<P>(&[], &mut []).unwrap();
        arm.model_to_local::<P>(&[], &mut []).unwrap();
        arm.job::<P>().roots(&[]).joints(1..2).local_to_model_in_place(&mut []).unwrap();
    }
    for_every_layout!(nobody());
}

#[test]
fn an_empty_range_computes_nothing() {
    fn nothing<P: Layout>() {
        let scene = Scene::small(1);
        for at in 0..=scene.joints() {
            models::<P>(&scene, Root::Each, at..at);
            locals::<P>(&scene, Root::Each, at..at);
        }
    }
    for_every_layout!(nothing());
}

/// Locals of norm 1¼, so that a model that is not normalized shows how many came before it.
#[test]
fn every_nth_joint_is_normalized_and_no_other() {
    fn norms<P: Layout>() {
        let parents: Vec<u32> = (0..7_u32).map(|joint| joint.wrapping_sub(1)).collect();
        let chain = Hierarchy::new(&parents).unwrap();
        let factor = P::Real::from(1.25);
        let step = DualQuat::from_translation([2.0, 0.0, 0.0].map(P::Real::from)).scale(factor);
        let locals = P::lay(7, &[step; 7]);
        let norms = |policy: Renormalize, range: Range<usize>| -> Vec<f64> {
            let mut models = locals.clone();
            let job = chain.job().joints(range).renormalize(policy);
            job.local_to_model_in_place(&mut models).unwrap();
            P::flat(7, 1, &models).iter().map(|model| model.real().norm().into()).collect()
        };
        let every = |n: u32| Renormalize::Every(NonZeroU32::new(n).unwrap());
        let powers: Vec<f64> = (1..=7).map(|n| 1.25_f64.powi(n)).collect();
        assert_eq!(norms(Renormalize::Never, 0..7), powers);
        assert_eq!(norms(Renormalize::default(), 0..7), powers);
        assert_eq!(norms(every(1), 0..7), [1.0; 7]);
        assert_eq!(norms(every(3), 0..7), [1.25, 1.5625, 1.0, 1.25, 1.5625, 1.0, 1.25]);
        assert_eq!(norms(every(8), 0..7), powers);
        // Counted along the parent array, not from the start of the range: joints 2 and 5.
        assert_eq!(norms(every(3), 1..4), [1.25, 1.5625, 1.0, 1.25, 1.25, 1.25, 1.25]);
    }
    for_every_layout!(norms());
}

/// Recursion would need a frame a joint: ten thousand do not fit the stack of this thread.
#[test]
fn a_chain_of_ten_thousand_joints_needs_no_stack() {
    fn chain<P: Layout>() {
        const JOINTS: u32 = 10_000;
        let parents: Vec<u32> = (0..JOINTS).map(|joint| joint.wrapping_sub(1)).collect();
        let chain = Hierarchy::new(&parents).unwrap();
        // Whole numbers of a unit step, so that every sum is exact in f32 too.
        let step = DualQuat::from_translation([0.0, 2.0, -1.0].map(P::Real::from));
        let mut poses = P::lay(JOINTS as usize, &vec![step; JOINTS as usize]);
        let locals = poses.clone();
        chain.local_to_model_in_place(&mut poses).unwrap();
        let models = P::flat(JOINTS as usize, 1, &poses);
        for (joint, model) in models.iter().enumerate() {
            let height = (joint + 1) as f64;
            assert_eq!(model.translation().map(Into::into), [0.0, 2.0 * height, -height]);
        }
        chain.model_to_local_in_place(&mut poses).unwrap();
        assert_eq!(P::flat(JOINTS as usize, 1, &poses), P::flat(JOINTS as usize, 1, &locals));
    }
    let small_stack = std::thread::Builder::new().stack_size(1024 * 1024);
    let run = small_stack.spawn(|| for_every_layout!(chain())).unwrap();
    run.join().unwrap();
}
