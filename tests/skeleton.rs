//! A `Skeleton` computes what its `Hierarchy` does, with every form of locals, root and palette,
//! whatever the order and the type of its parents.

use dq8::hierarchy::Locals;
use dq8::{
    Backend, DualQuat, Hierarchy, Job, Quat, Skeleton,
    hierarchy::{
        Bones, HierarchyError, MatrixOrder, NoRoot, ParentIndex, Poses, Renormalize, Root,
        RotationsTranslations,
    },
};

/// A biped's parents, a chain that is long enough for segments, many roots, and the smallest.
fn parents() -> Vec<Vec<u32>> {
    let root = Hierarchy::ROOT;
    let biped = vec![root, 0, 1, 2, 2, 4, 5, 2, 7, 8, 0, 10, 11, 0, 13, 14, 3];
    let chain: Vec<u32> = (0..40).map(|joint: u32| joint.wrapping_sub(1)).collect();
    vec![biped, chain, vec![root, root, 0, 1, root], vec![root; 9], vec![root], vec![]]
}

fn turn(joint: usize) -> Quat<f32> {
    let s = joint as f32;
    Quat::from_axis_angle([0.36, 0.48, 0.8], 0.4 * s.sin())
}

fn offset(joint: usize) -> [f32; 3] {
    [0.1, 0.3 * (joint as f32).cos(), -0.2]
}

fn same(a: &[DualQuat<f32>], b: &[DualQuat<f32>], plan_is_chain: bool) -> bool {
    // A tree has the same products in the same order; a chain in segments has others.
    a == b || (plan_is_chain && a.iter().zip(b).all(|(a, b)| a.abs_diff_eq(*b, 2e-5)))
}

fn options<'a, P>(
    job: Job<'a, NoRoot, P>,
    case: u32,
    backend: Backend,
    roots: &'a [DualQuat<f32>],
) -> Job<'a, Root<'a, DualQuat<f32>>, P> {
    let job = job.backend(backend).matrix_order(MatrixOrder::Columns);
    match (case, roots) {
        (1, &[root]) => job.on(Root::Same(root)),
        (2, _) => job.on(Root::None).renormalize(Renormalize::Every(3.try_into().unwrap())),
        (3, roots) => job.on(Root::Each(roots)),
        _ => job.on(Root::None),
    }
}

fn agrees<L: Locals<DualQuat<f32>>>(skeleton: &Skeleton, locals: L, before: &[DualQuat<f32>]) {
    let hierarchy = skeleton.hierarchy();
    let chain = skeleton.joints() == 40;
    let root = DualQuat::from_rotation_translation(turn(77), [4.0, 5.0, 6.0]);
    let roots: Vec<_> = (skeleton.joints() > 0).then_some(root).into_iter().collect();
    let binds: Vec<_> =
        (0..skeleton.joints()).map(|j| DualQuat::from(turn(j)).conjugate()).collect();
    for backend in Backend::available() {
        for case in 0..4 {
            let (planned, plain) = (
                options(skeleton.job(), case, backend, &roots),
                options(hierarchy.job(), case, backend, &roots),
            );
            let (mut ours, mut wanted) = (before.to_vec(), before.to_vec());
            planned.locals_to_model(locals, &mut ours).unwrap();
            plain.locals_to_model(locals, &mut wanted).unwrap();
            assert!(same(&ours, &wanted, chain), "case {case}, {backend}: {ours:?} {wanted:?}");
            let mut palettes =
                [vec![[[0.0_f32; 4]; 3]; before.len()], vec![[[0.0; 4]; 3]; before.len()]];
            let (mut ours, mut wanted) = (before.to_vec(), before.to_vec());
            planned.palette_and_models(locals, &mut ours, &binds, &mut palettes[0]).unwrap();
            plain.palette_and_models(locals, &mut wanted, &binds, &mut palettes[1]).unwrap();
            assert!(same(&ours, &wanted, chain));
            let [ours, wanted] = palettes.map(|p| p.as_flattened().as_flattened().to_vec());
            // Trees sum in another order, over lengths of some tens.
            assert!(ours.iter().zip(&wanted).all(|(a, b)| (a - b).abs() <= 1e-4), "case {case}");
            assert!(chain || ours == wanted);
        }
    }
}

#[test]
fn a_skeleton_agrees_with_its_hierarchy_in_every_form() {
    for parents in parents() {
        let skeleton = Skeleton::new(&parents).unwrap();
        assert_eq!((skeleton.parents(), skeleton.joints()), (&parents[..], parents.len()));
        assert_eq!(skeleton, Skeleton::from(Hierarchy::new(&parents).unwrap()));
        for instances in [1, 3] {
            let joints = 0..parents.len() * instances;
            let rotations: Vec<_> = joints.clone().map(turn).collect();
            let seven: Vec<[f32; 7]> = joints
                .clone()
                .map(|j| {
                    let ([x, y, z, w], [a, b, c]) = (turn(j).to_array(), offset(j));
                    [x, y, z, w, a, b, c]
                })
                .collect();
            let poses: Vec<_> = joints.map(|j| DualQuat::from((turn(j), offset(j)))).collect();
            let offsets: Vec<_> = (0..parents.len()).map(offset).collect();
            let blank = vec![DualQuat::IDENTITY; poses.len()];
            if instances == 1 {
                agrees(&skeleton, Poses(&poses), &blank);
                agrees(&skeleton, RotationsTranslations(&seven), &blank);
                agrees(&skeleton, Bones { rotations: &rotations, offsets: &offsets }, &blank);
            }
            let (mut ours, mut wanted, mut out) = (poses.clone(), poses.clone(), blank);
            skeleton.job().local_to_model_in_place(&mut ours).unwrap();
            Hierarchy::new(&parents).unwrap().job().local_to_model_in_place(&mut wanted).unwrap();
            assert!(same(&ours, &wanted, true));
            skeleton.local_to_model(&poses, &mut out).unwrap();
            assert_eq!(out, ours);
        }
    }
}

#[test]
fn lengths_are_checked_and_nothing_is_written() {
    let skeleton = Skeleton::new(&[-1, 0, 1]).unwrap();
    let mut models = [DualQuat::<f32>::ZERO; 3];
    assert!(skeleton.local_to_model(&[DualQuat::IDENTITY; 2], &mut models).is_err());
    assert!(
        skeleton.job().roots(&[]).local_to_model(&[DualQuat::IDENTITY; 3], &mut models).is_err()
    );
    assert_eq!(models, [DualQuat::ZERO; 3]);
    let job = skeleton.job().joints(1..2);
    job.local_to_model(&[DualQuat::IDENTITY; 3], &mut models).unwrap();
    assert_eq!(models, [DualQuat::ZERO; 3], "a range is not the whole");
}

#[test]
fn any_order_of_parents_is_sorted_and_the_order_told() {
    for parents in parents() {
        let count = parents.len();
        // 7 and the lengths have no common divisor but for 7 itself, which is none of them.
        let shuffle: Vec<usize> = (0..count).map(|i| i * 7 % count.max(1)).collect();
        let place = |old: usize| shuffle.iter().position(|&from| from == old).unwrap();
        let mixed: Vec<Option<usize>> = shuffle
            .iter()
            .map(|&from| (parents[from] != Hierarchy::ROOT).then(|| place(parents[from] as usize)))
            .collect();
        let (skeleton, order) = Skeleton::sorted(&mixed).unwrap();
        assert_eq!(order.len(), count);
        for (joint, &old) in order.iter().enumerate() {
            let parent = skeleton.parents()[joint];
            let wanted = mixed[old];
            assert_eq!(order.get(parent as usize).copied(), wanted, "joint {joint}");
            assert!(wanted.is_none() == (parent == Hierarchy::ROOT));
        }
        // What is sorted stays.
        let (again, order) = Skeleton::sorted(skeleton.parents()).unwrap();
        assert_eq!((again, &order[..]), (skeleton, &(0..count).collect::<Vec<_>>()[..]));
    }
}

#[test]
fn what_a_file_lists_by_joint_follows_the_order_and_its_names_do_at_once() {
    let (file, names) = ([2, -1, 1, 1], ["hand", "shoulder", "elbow", "collar"]);
    let (arm, order) = Skeleton::sorted_named(&file, &names).unwrap();
    for (old, name) in names.iter().enumerate() {
        let new = order.of(old).unwrap();
        assert_eq!((arm.name(new), order[new], arm.joint(name)), (Some(*name), old, Some(new)));
        // The parent of a file's joint is the one that it names.
        let parent = arm.parents()[new];
        let wanted = usize::try_from(file[old]).ok().and_then(|parent| order.of(parent));
        assert_eq!((parent != Hierarchy::ROOT).then_some(parent as usize), wanted, "{name}");
    }
    assert_eq!(order.gather(&names).unwrap(), ["shoulder", "elbow", "hand", "collar"]);
    assert_eq!((order.of(4), order.gather(&[1, 2, 3]).is_err()), (None, true));
    let few = Skeleton::sorted_named(&file, &names[..3]).unwrap_err();
    assert_eq!(few, HierarchyError::Names { names: 3, joints: 4 });
}

/// By the definition: who is `joint` or has it above.
fn hangs_from(parents: &[u32], mut who: usize, joint: usize) -> bool {
    while who > joint && parents[who] != Hierarchy::ROOT {
        who = parents[who] as usize;
    }
    who == joint
}

#[test]
fn a_subtree_is_the_range_of_a_joint_and_all_that_hang_from_it_or_no_range_at_all() {
    let root = Hierarchy::ROOT;
    let breadth_first = vec![root, 0, 0, 1, 2, 1, root, 6, 4];
    for parents in parents().into_iter().chain([breadth_first]) {
        let skeleton = Skeleton::new(&parents).unwrap();
        let (sorted, _) = Skeleton::sorted(&parents).unwrap();
        for joint in 0..parents.len() {
            let below = |skeleton: &Skeleton| -> Vec<usize> {
                let all = 0..skeleton.joints();
                all.filter(|&who| hangs_from(skeleton.parents(), who, joint)).collect()
            };
            match skeleton.subtree(joint) {
                Ok(range) => assert_eq!(range.collect::<Vec<_>>(), below(&skeleton)),
                Err(HierarchyError::Scattered { joint: named, beyond }) => {
                    let scattered = below(&skeleton);
                    let gap = scattered.windows(2).find(|pair| pair[1] != pair[0] + 1).unwrap();
                    assert_eq!((named, beyond), (joint, gap[1]), "{parents:?}");
                }
                Err(other) => panic!("{other}"),
            }
            let range = sorted.subtree(joint).expect("depth first");
            assert_eq!(range.collect::<Vec<_>>(), below(&sorted), "{parents:?}");
        }
        for joint in [parents.len(), parents.len() + 1, usize::MAX] {
            let refused = Err(HierarchyError::NoJoint { joint, joints: parents.len() });
            assert_eq!(skeleton.subtree(joint), refused);
        }
    }
}

#[test]
fn only_a_subtree_is_computed_and_the_rest_stays() {
    let (leg, _) = Skeleton::sorted(&[-1, 0, 0, 1, 2]).unwrap();
    let down = DualQuat::from_translation([0.0_f32, -1.0, 0.0]);
    let mut models = [down; 5];
    leg.local_to_model(&[down; 5], &mut models).unwrap();
    let before = models;
    let knee = leg.children(0).next().unwrap();
    let mut locals = [down; 5];
    locals[knee] = DualQuat::from_translation([0.0, -2.0, 0.0]);
    leg.job().joints(leg.subtree(knee).unwrap()).local_to_model(&locals, &mut models).unwrap();
    let heights = models.map(|model| model.translation()[1]);
    assert_eq!(heights, [-1.0, -3.0, -4.0, before[3].translation()[1], -3.0]);
}

#[test]
fn parents_children_and_roots_say_the_same_of_every_joint() {
    for parents in parents() {
        let skeleton = Skeleton::new(&parents).unwrap();
        let joints = 0..parents.len();
        for joint in joints.clone() {
            let parent = (parents[joint] != Hierarchy::ROOT).then_some(parents[joint] as usize);
            assert_eq!(skeleton.parent(joint), parent);
            let children: Vec<usize> = skeleton.children(joint).collect();
            let wanted = joints.clone().filter(|&j| skeleton.parent(j) == Some(joint));
            assert_eq!(children, wanted.collect::<Vec<_>>());
        }
        let roots = joints.filter(|&joint| skeleton.parent(joint).is_none());
        assert_eq!(skeleton.roots().collect::<Vec<_>>(), roots.collect::<Vec<_>>());
        for beyond in [parents.len(), u32::MAX as usize, usize::MAX] {
            assert_eq!((skeleton.parent(beyond), skeleton.children(beyond).next()), (None, None));
        }
    }
}

#[test]
fn names_are_one_for_each_joint_none_twice_and_written_below_their_parents() {
    let skeleton = Skeleton::new(&[-1, 0, 1, 0, 1]).unwrap();
    let plain = "0\n  1\n    2\n  3\n    4 (of 1)\n";
    assert_eq!(skeleton.to_string(), plain);
    assert_eq!(skeleton.hierarchy().to_string(), plain);
    assert_eq!((skeleton.name(0), skeleton.joint("")), (None, None));
    let named = skeleton.clone().with_names(["hip", "knee", "", "tail", ""]).unwrap();
    assert_ne!(named, skeleton);
    assert_eq!(named.to_string(), "0 hip\n  1 knee\n    2\n  3 tail\n    4 (of 1)\n");
    assert_eq!((named.joint("tail"), named.joint("foot"), named.joint("")), (Some(3), None, None));
    assert_eq!((named.name(1), named.name(2), named.name(5)), (Some("knee"), None, None));
    let twice = skeleton.clone().with_names(["a", "b", "", "b", ""]).unwrap_err();
    assert_eq!(twice, HierarchyError::SameName { joint: 3, earlier: 1 });
    let few = skeleton.with_names(["a"]).unwrap_err();
    assert_eq!(few, HierarchyError::Names { names: 1, joints: 5 });
}

/// Both ways to a skeleton refuse these.
fn of<P: ParentIndex>(parents: &[P]) -> [HierarchyError; 2] {
    [Skeleton::new(parents).unwrap_err(), Skeleton::sorted(parents).unwrap_err()]
}

#[test]
fn parents_of_every_type_mean_the_same_and_what_is_no_tree_is_refused() {
    let wanted = Skeleton::new(&[u32::MAX, 0, 1]).unwrap();
    assert_eq!(Skeleton::new(&[-1_i16, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[-1_i32, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[-1_isize, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[u16::MAX, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[usize::MAX, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[u8::MAX, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[-1_i8, 0, 1]), Ok(wanted.clone()));
    // The largest number of every type.
    assert_eq!(Skeleton::new(&[i8::MAX, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[i16::MAX, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[i32::MAX, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[i64::MAX, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[isize::MAX, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[u64::MAX, 0, 1]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[None, Some(0_u8), Some(1)]), Ok(wanted.clone()));
    assert_eq!(Skeleton::new(&[None, Some(0_u32), Some(1)]), Ok(wanted));
    for (written, refused) in [
        (-2, of(&[-1, -2])),
        (i128::from(i64::MIN), of(&[-1, i64::MIN])),
        (i128::from(i64::MAX) - 1, of(&[-1, i64::MAX - 1])),
        (i128::from(i64::MAX), of(&[None, Some(i64::MAX)])),
        (1 << 32, of(&[-1_i64, 1 << 32])),
        (1 << 32, of(&[u64::MAX, 1 << 32])),
        (i128::from(u64::MAX) - 1, of(&[u64::MAX, u64::MAX - 1])),
        (i128::from(u32::MAX), of(&[u64::MAX, u64::from(u32::MAX)])),
        (i128::from(u32::MAX), of(&[None, Some(u32::MAX)])),
        (-1, of(&[None, Some(-1)])),
        (-128, of(&[-1, i8::MIN])),
        (254, of(&[u8::MAX, 254])),
    ] {
        for error in refused {
            let wanted = HierarchyError::ParentOutOfRange { joint: 1, parent: written, joints: 2 };
            assert_eq!(error, wanted);
            let text = error.to_string();
            assert!(text.contains(&format!("joint 1 has parent {written}")), "{text}");
        }
    }
    // A negative number that has become a `u32` before it got here.
    let cast = Hierarchy::new(&[u32::MAX, -3_i32 as u32]).unwrap_err().to_string();
    assert!(cast.contains("4294967293 (-3 as a signed number)"), "{cast}");
    assert_eq!(Skeleton::sorted(&[0]).unwrap_err(), HierarchyError::Cycle { joint: 0 });
    assert_eq!(Skeleton::sorted(&[1, 2, 3, 1]).unwrap_err(), HierarchyError::Cycle { joint: 1 });
    // Behind a root, which is in no circle.
    assert_eq!(Skeleton::sorted(&[-1, 0, 2]).unwrap_err(), HierarchyError::Cycle { joint: 2 });
    assert!(HierarchyError::Cycle { joint: 1 }.to_string().contains("its own ancestor"));
    let deep: Vec<i64> =
        (0..100_000).map(|joint| if joint == 99_999 { -1 } else { joint + 1 }).collect();
    assert_eq!(Skeleton::sorted(&deep).unwrap().1[0], 99_999);
}

/// A plan multiplies a chain in segments, in another order: for one instance alone, never for one
/// of several.
#[test]
fn instances_of_a_chain_have_the_same_bits_wherever_they_stand() {
    let chain: Vec<u32> = (0..24).map(|joint: u32| joint.wrapping_sub(1)).collect();
    let skeleton = Skeleton::new(&chain).unwrap();
    let pose: Vec<_> =
        (0..24).map(|j| DualQuat::from_rotation_translation(turn(j), offset(j))).collect();
    let binds = [DualQuat::IDENTITY; 24];
    for instances in [2, 17, 83] {
        let locals = pose.repeat(instances);
        let is_repeated = |of: &[DualQuat<f32>]| of.chunks(24).all(|one| one == &of[..24]);
        let mut models = locals.clone();
        skeleton.job().local_to_model(&locals, &mut models).unwrap();
        assert!(is_repeated(&models), "{instances} instances");
        let mut palette = locals.clone();
        for scratch in [1, 16] {
            let mut scratch = vec![DualQuat::IDENTITY; scratch * 24];
            let job = skeleton.job();
            job.palette(Poses(&locals), &mut scratch, &binds, &mut palette).unwrap();
            assert!(palette == models, "{instances} instances");
        }
        #[cfg(feature = "rayon")]
        {
            let (mut all, mut beside) = (locals.clone(), locals.clone());
            skeleton.job().threads(usize::MAX).local_to_model(&locals, &mut all).unwrap();
            assert!(all == models, "{instances} instances on all cores");
            let job = skeleton.job();
            job.threads(usize::MAX)
                .palette_and_models(Poses(&locals), &mut all, &binds, &mut beside)
                .unwrap();
            assert!(all == models && beside == models, "{instances} instances on all cores");
        }
    }
}
