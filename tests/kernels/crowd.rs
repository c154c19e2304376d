//! Crowds of instances, of everything that blocks hold and in blocks of every width.

use crate::errors::names;
use crate::packing::{Packing, packings, things};
use dq8::simd::{Portable, Row};
use dq8::storage::Block;
use dq8::{
    Crowd, DualQuat, Hierarchy, Quat, Scalar, ShapeError,
    hierarchy::{Bones, RotationsTranslations},
};

/// Three joints a few lengths apart.
const ROUNDING: f64 = 4e-15;

fn for_every_packing(mut check: impl FnMut(&dyn Packing)) {
    for packing in packings() {
        check(&*packing);
    }
}

#[test]
fn a_crowd_holds_the_things_it_was_made_from() {
    for_every_packing(|packing| {
        for (joints, instances) in
            [1, 3].into_iter().flat_map(|j| (0..=2 * packing.lanes() + 1).map(move |i| (j, i)))
        {
            let things = things(packing.components(), joints * instances);
            let crowd = packing.crowd(joints, &things).expect("whole instances");
            assert_eq!((crowd.joints(), crowd.instances()), (joints, instances));
            assert_eq!(crowd.copy(things.len()).as_ref(), Ok(&things));
            for (index, thing) in things.iter().enumerate() {
                assert_eq!(crowd.record(index / joints, index % joints).as_ref(), Some(thing));
            }
            // As `pack` lays them.
            let blocks = instances.div_ceil(packing.lanes()) * joints;
            let way = crate::packing::Way::Instances(joints);
            assert_eq!(packing.pack(way, &things, blocks), Ok(crowd.lanes()));
        }
    });
}

#[test]
fn a_crowd_set_thing_by_thing_is_the_crowd_made_from_the_slice() {
    for_every_packing(|packing| {
        for instances in [0, 1, packing.lanes(), 2 * packing.lanes() + 1] {
            let things = things(packing.components(), 3 * instances);
            let mut crowd = packing.new_crowd(3, instances);
            // Last first: no thing may rely on those before it.
            for (index, thing) in things.iter().enumerate().rev() {
                crowd.set_record(index / 3, index % 3, thing).expect("it is inside");
            }
            let whole = packing.crowd(3, &things).expect("whole instances");
            assert_eq!(crowd.lanes(), whole.lanes(), "{instances} instances");
        }
    });
}

#[test]
fn a_new_crowd_stands_at_the_identity() {
    for_every_packing(|packing| {
        let crowd = packing.new_crowd(3, packing.lanes() + 1);
        assert_eq!(crowd.lanes(), vec![packing.padding(); 3 * 2 * packing.lanes()]);
    });
}

/// A lane can be there without its instance: asking for it is refused as well.
#[test]
fn things_beyond_the_last_instance_or_joint_are_refused() {
    for_every_packing(|packing| {
        let (joints, instances) = (3, packing.lanes() + 1);
        let things = things(packing.components(), joints * instances);
        let mut crowd = packing.crowd(joints, &things).expect("whole instances");
        let (before, far) = (crowd.lanes(), usize::MAX);
        let last = 2 * packing.lanes() - 1;
        for (instance, joint) in [
            (instances, 0),
            (packing.lanes(), 3),
            (0, 3),
            (last, 2),
            (last + 1, 0),
            (far, 0),
            (0, far),
            (far, far),
        ] {
            assert_eq!(crowd.record(instance, joint), None);
            let error = crowd.set_record(instance, joint, &things[0]).unwrap_err();
            assert_eq!(error, ShapeError::NoPose { instance, joint, instances, joints });
            names(&error, &[instance, joint, instances, joints]);
        }
        assert_eq!(crowd.lanes(), before, "written in spite of the error");
    });
}

#[test]
fn copying_into_a_slice_of_another_length_leaves_it_untouched() {
    for_every_packing(|packing| {
        let expected = 3 * (packing.lanes() + 1);
        let things = things(packing.components(), expected);
        let crowd = packing.crowd(3, &things).expect("whole instances");
        // Other whole numbers of instances, also ones that take as many blocks, and broken ones.
        for length in [0, 3, expected - 3, expected - 1, expected + 1, expected + 3] {
            let error = crowd.copy(length).unwrap_err();
            assert_eq!(error, ShapeError::Length { what: "things", length, expected });
            names(&error, &[length, expected]);
        }
    });
}

#[test]
fn a_crowd_of_nobody_and_a_crowd_of_no_joints_hold_nothing() {
    for_every_packing(|packing| {
        for (joints, instances) in [(0, 0), (5, 0), (0, 5)] {
            let mut crowd = packing.new_crowd(joints, instances);
            assert_eq!((crowd.joints(), crowd.instances()), (joints, instances));
            assert!(crowd.lanes().is_empty() && crowd.copy(0).is_ok_and(|all| all.is_empty()));
            assert_eq!(crowd.record(0, 0), None);
            crowd.set_record(0, 0, &packing.padding()).unwrap_err();
        }
        // The length of a slice cannot tell how many instances of no joints there are.
        assert_eq!(packing.crowd(0, &[]).expect("nobody").instances(), 0);
        let way = crate::packing::Way::Instances;
        assert_eq!(packing.pack(way(0), &[], 0), Ok(vec![]));
        assert_eq!(packing.unpack(way(4), &[], 0), Ok(vec![]));
    });
}

/// Poses have names of their own.
#[test]
fn poses_go_in_and_out_as_motions() {
    let pose = |i: usize| DualQuat::from_translation([i as f32, 1.0, -2.0]);
    let poses: Vec<_> = (0..2 * 9).map(pose).collect();
    let mut crowd = Crowd::<f32, 8>::new(2, 9);
    for (i, pose) in poses.iter().enumerate() {
        crowd.set(i / 2, i % 2, *pose).expect("it is inside");
    }
    assert_eq!(crowd, Crowd::from_slice(2, &poses).expect("whole instances"));
    assert_eq!(crowd.to_vec(), poses);
    assert_eq!((crowd.get(8, 1), crowd.get(9, 0), crowd.get(0, 2)), (Some(pose(17)), None, None));
    let (instance, joint) = (9, 1);
    let error = ShapeError::NoPose { instance, joint, instances: 9, joints: 2 };
    assert_eq!(crowd.set(instance, joint, pose(0)), Err(error));
    assert_eq!(Crowd::<f64, 4>::new(0, 3).to_vec(), []);
}

#[test]
fn blocks_are_floats_without_gaps_on_whole_cache_lines() {
    fn floats<R: Scalar, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        assert_eq!(size_of::<Block<R, N>>(), 8 * N * size_of::<R>());
        assert_eq!(align_of::<Block<R, N>>(), 64);
        let mut crowd = Crowd::<R, N>::new(2, N + 1);
        let floats: &mut [R] = bytemuck::cast_slice_mut(crowd.blocks_mut());
        assert_eq!(floats.len(), 2 * 2 * 8 * N);
        // What is written through the floats is what the crowd holds: lane 0 of the last row.
        floats[4 * 8 * N - N] = R::HALF;
        let last = crowd.get(N, 1).expect("it is inside").to_array();
        assert_eq!(last[7], R::HALF);
        assert_eq!(last[..7], DualQuat::<R>::IDENTITY.to_array()[..7]);
    }
    floats::<f32, 4>();
    floats::<f32, 8>();
    floats::<f32, 16>();
    floats::<f64, 2>();
    floats::<f64, 4>();
    floats::<f64, 8>();
}

/// A block is what a kernel loads: lane i of every component is instance i.
#[test]
fn lanes_read_their_own_instances() {
    let poses: Vec<[f32; 8]> =
        (0..8).map(|i| core::array::from_fn(|c| (100 * i + c) as f32)).collect();
    let crowd = Crowd::<f32, 4>::from_slice(2, &poses).expect("whole instances");
    let lanes: [dq8::simd::f32x4; 8] = crowd.blocks()[1].load(Portable);
    for (component, lanes) in lanes.into_iter().enumerate() {
        let wanted = core::array::from_fn(|i| poses[2 * i + 1][component]);
        assert_eq!(lanes.to_array(), wanted);
    }
}

/// Crowds of rotations, of rotations and translations and of matrices are what jobs take and give.
#[test]
fn crowds_of_less_than_motions_and_of_matrices_serve_a_job() {
    let hierarchy = Hierarchy::new(&[Hierarchy::ROOT, 0, 1]).expect("parents come first");
    let turn = |i: usize| Quat::from_axis_angle([0.6, 0.0, 0.8], 0.1 * i as f64);
    let offsets = [[1.0, 2.0, 3.0], [0.0, -1.0, 0.5], [0.25, 0.0, 2.0]];
    let turns: Vec<_> = (0..3 * 11).map(turn).collect();
    let both: Vec<[f64; 7]> = (0..3 * 11)
        .map(|i| {
            let ([x, y, z, w], [tx, ty, tz]) = (turn(i).to_array(), offsets[i % 3]);
            [x, y, z, w, tx, ty, tz]
        })
        .collect();
    let rotations = Crowd::<f64, 4, 4>::from_slice(3, &turns).expect("whole instances");
    let both = Crowd::<f64, 4, 7>::from_slice(3, &both).expect("whole instances");
    let mut models = Crowd::<f64, 4>::new(3, 11);
    let mut matrices = Crowd::<f64, 4, 12>::new(3, 11);
    let (job, binds) = (hierarchy.job(), [DualQuat::IDENTITY; 3]);
    let locals = Bones { rotations: rotations.blocks(), offsets: &offsets };
    let (to, palette) = (models.blocks_mut(), matrices.blocks_mut());
    job.palette_and_models(locals, to, &binds, palette).expect("they fit");
    let mut others = Crowd::<f64, 4>::new(3, 11);
    let locals = RotationsTranslations(both.blocks());
    job.locals_to_model(locals, others.blocks_mut()).expect("they fit");
    let local = |i: usize| DualQuat::from_rotation_translation(turn(i), offsets[i % 3]);
    for instance in 0..11 {
        let mut model = DualQuat::IDENTITY;
        for joint in 0..3 {
            model = model * local(3 * instance + joint);
            for crowd in [&models, &others] {
                let got = crowd.get(instance, joint).expect("it is inside");
                assert!(got.abs_diff_eq(model, ROUNDING), "{instance}, {joint}");
            }
            let got = matrices.record(instance, joint).expect("it is inside");
            let wanted = model.to_matrix3x4();
            for (got, wanted) in got.iter().zip(wanted.as_flattened()) {
                assert!((got - wanted).abs() < ROUNDING, "{instance}, {joint}");
            }
        }
    }
}

/// Whatever a run leaves in the lanes without an instance.
#[test]
fn crowds_are_equal_where_their_instances_are() {
    let parents = [Hierarchy::ROOT, 0];
    let hierarchy = Hierarchy::new(&parents).expect("a hierarchy");
    let step = DualQuat::from_translation([0.0_f32, 1.0, 0.0]);
    let mut moved = Crowd::<f32, 8>::from_slice(2, &[step; 6]).expect("whole instances");
    hierarchy.job().root(step).local_to_model_in_place(moved.blocks_mut()).expect("they fit");
    let mut same = Crowd::<f32, 8>::from_slice(2, &moved.to_vec()).expect("whole instances");
    assert_ne!(moved.blocks(), same.blocks());
    assert_eq!(moved, same);
    same.set(2, 1, step).expect("it is inside");
    assert_ne!(moved, same);
    assert_ne!(Crowd::<f32, 8>::new(2, 3), Crowd::new(3, 2));
}
