//! Crowds of instances: packing into blocks of every width and back, to the bit.

use bytemuck::{Pod, cast_slice};
use core::error::Error;
use dq8::{Block, Crowd, DualQuat, Real, ShapeError, f32x4, pack, unpack};
use dq8_simd::Row;

/// Calls `$check` for every width of block there is.
macro_rules! for_every_width {
    ($check:ident()) => {{
        $check::<f32, 4>();
        $check::<f32, 8>();
        $check::<f32, 16>();
        $check::<f64, 2>();
        $check::<f64, 4>();
        $check::<f64, 8>();
    }};
}

/// Eight numbers that tell instance, joint and component, exact in `f32` too.
fn pose<R: Real>(instance: usize, joint: usize) -> DualQuat<R> {
    let number = (1000 * instance + 10 * joint) as f64;
    DualQuat::from_array(core::array::from_fn(|component| R::from_f64(number + component as f64)))
}

/// `[instance][joint]`
fn poses<R: Real>(joints: usize, instances: usize) -> Vec<DualQuat<R>> {
    (0..instances).flat_map(|i| (0..joints).map(move |j| pose(i, j))).collect()
}

/// What no correct result holds: to see what has been written.
fn junk<R: Real, const N: usize>() -> Block<R, N>
where
    [R; N]: Row<Real = R>,
{
    Block::splat([R::from_f64(-7.0); 8])
}

/// The text of an error names every one of `numbers`.
fn names(error: &dyn Error, numbers: &[usize]) {
    let text = error.to_string();
    let words: Vec<usize> =
        text.split(|c: char| !c.is_ascii_digit()).filter_map(|word| word.parse().ok()).collect();
    for number in numbers {
        assert!(words.contains(number), "no {number} in \"{text}\"");
    }
}

/// Every shape with up to two full blocks and a partial one.
fn for_every_shape<const N: usize>(mut check: impl FnMut(usize, usize)) {
    for joints in [1, 2, 3, 7] {
        for instances in 0..=2 * N + 1 {
            check(joints, instances);
        }
    }
}

#[test]
fn unpacking_gives_back_what_was_packed() {
    fn round_trip<R: Real, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        for_every_shape::<N>(|joints, instances| {
            let poses = poses::<R>(joints, instances);
            let mut blocks = vec![junk::<R, N>(); instances.div_ceil(N) * joints];
            pack(joints, &poses, &mut blocks).unwrap();
            let mut back = vec![DualQuat::ZERO; poses.len()];
            unpack(joints, &blocks, &mut back).unwrap();
            assert_eq!(back, poses, "{instances} instances of {joints} joints");
        });
    }
    for_every_width!(round_trip());
}

#[test]
fn a_crowd_holds_the_poses_it_was_made_from() {
    fn round_trip<R: Real, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        for_every_shape::<N>(|joints, instances| {
            let poses = poses::<R>(joints, instances);
            let crowd = Crowd::<R, N>::from_slice(joints, &poses).unwrap();
            assert_eq!((crowd.joints(), crowd.instances()), (joints, instances));
            assert_eq!(crowd.to_vec(), poses);
            let mut copy = vec![DualQuat::ZERO; poses.len()];
            crowd.copy_to_slice(&mut copy).unwrap();
            assert_eq!(copy, poses);
            for (index, &pose) in poses.iter().enumerate() {
                assert_eq!(crowd.get(index / joints, index % joints), Some(pose));
            }
        });
    }
    for_every_width!(round_trip());
}

#[test]
fn a_crowd_set_pose_by_pose_is_the_crowd_made_from_the_slice() {
    fn pose_by_pose<R: Real, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        for_every_shape::<N>(|joints, instances| {
            let mut crowd = Crowd::<R, N>::new(joints, instances);
            // Last first: no pose may rely on those before it.
            for instance in (0..instances).rev() {
                for joint in (0..joints).rev() {
                    crowd.set(instance, joint, pose(instance, joint)).unwrap();
                }
            }
            let whole = Crowd::from_slice(joints, &poses(joints, instances)).unwrap();
            assert_eq!(crowd, whole, "{instances} instances of {joints} joints");
        });
    }
    for_every_width!(pose_by_pose());
}

#[test]
fn a_new_crowd_stands_at_the_identity() {
    fn fresh<R: Real, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        let crowd = Crowd::<R, N>::new(3, N + 1);
        assert_eq!(crowd.to_vec(), vec![DualQuat::IDENTITY; 3 * (N + 1)]);
        let identity = Block::splat(DualQuat::IDENTITY.to_array());
        assert_eq!(crowd.blocks(), vec![identity; 3 * 2]);
    }
    for_every_width!(fresh());
}

/// Five instances of two joints in blocks of four lanes: two instance blocks, the second with one
/// instance. Read as floats, they are `[instance block][joint][component][lane]`.
#[test]
fn the_layout_is_instance_block_then_joint_then_component_then_lane() {
    let crowd = Crowd::<f32, 4>::from_slice(2, &poses(2, 5)).unwrap();
    assert_eq!(crowd.blocks().len(), 4);
    let floats: &[f32] = cast_slice(crowd.blocks());
    assert_eq!(floats.len(), 2 * 2 * 8 * 4);

    // The rows of component 0 and 1 of joint 0, instances 0 to 3.
    assert_eq!(floats[0..4], [0.0, 1000.0, 2000.0, 3000.0]);
    assert_eq!(floats[4..8], [1.0, 1001.0, 2001.0, 3001.0]);
    // Component 7 of joint 0, then component 0 of joint 1, still instances 0 to 3.
    assert_eq!(floats[28..32], [7.0, 1007.0, 2007.0, 3007.0]);
    assert_eq!(floats[32..36], [10.0, 1010.0, 2010.0, 3010.0]);
    // The second instance block: instance 4 in lane 0, the identity in the three others.
    assert_eq!(floats[64..68], [4000.0, 0.0, 0.0, 0.0]);
    assert_eq!(floats[64 + 12..64 + 16], [4003.0, 1.0, 1.0, 1.0]);
    assert_eq!(floats[96 + 28..128], [4017.0, 0.0, 0.0, 0.0]);

    let index = |instance: usize, joint: usize, component: usize| {
        ((instance / 4 * 2 + joint) * 8 + component) * 4 + instance % 4
    };
    for (number, pose) in crowd.to_vec().into_iter().enumerate() {
        for (component, value) in pose.to_array().into_iter().enumerate() {
            assert_eq!(floats[index(number / 2, number % 2, component)].to_bits(), value.to_bits());
        }
    }
}

#[test]
fn blocks_are_floats_without_gaps_on_whole_cache_lines() {
    fn floats<R: Real + Pod, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        assert_eq!(size_of::<Block<R, N>>(), 8 * N * size_of::<R>());
        assert_eq!(align_of::<Block<R, N>>(), 64);
        let mut crowd = Crowd::<R, N>::from_slice(2, &poses(2, N + 1)).unwrap();
        let floats: &mut [R] = bytemuck::cast_slice_mut(crowd.blocks_mut());
        assert_eq!(floats.len(), 2 * 2 * 8 * N);
        // What is written through the floats is what the crowd holds: lane 0 of the last row.
        floats[4 * 8 * N - N] = R::from_f64(0.25);
        let last = crowd.get(N, 1).unwrap().to_array();
        assert_eq!(last[7], R::from_f64(0.25));
        assert_eq!(last[..7], pose::<R>(N, 1).to_array()[..7]);
    }
    for_every_width!(floats());
}

#[test]
fn lanes_without_an_instance_hold_the_identity_whatever_was_there() {
    fn padding<R: Real, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        for_every_shape::<N>(|joints, instances| {
            let mut blocks = vec![junk::<R, N>(); instances.div_ceil(N) * joints];
            pack(joints, &poses(joints, instances), &mut blocks).unwrap();
            let first_unused = instances % N;
            if first_unused > 0 {
                for block in blocks.iter().rev().take(joints) {
                    for lane in first_unused..N {
                        assert_eq!(block.get(lane), Some(DualQuat::IDENTITY.to_array()));
                    }
                }
            }
        });
    }
    for_every_width!(padding());
}

/// Packing copies and computes nothing: signs of zeros, infinities and NaN come back to the bit.
#[test]
fn every_bit_of_a_float_survives() {
    fn copied<R: Real + Pod, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        let odd = [-0.0, f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e-310, 1e-40, 0.1];
        let poses = vec![DualQuat::from_array(odd.map(R::from_f64)); N + 1];
        let back = Crowd::<R, N>::from_slice(1, &poses).unwrap().to_vec();
        assert_eq!(cast_slice::<_, u8>(&back), cast_slice::<_, u8>(&poses));
    }
    for_every_width!(copied());
}

/// A lane can be there without its instance: asking for it is refused as well.
#[test]
fn poses_beyond_the_last_instance_or_joint_are_refused() {
    fn beyond<R: Real, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        let (joints, instances) = (3, N + 1);
        let mut crowd = Crowd::<R, N>::from_slice(joints, &poses(joints, instances)).unwrap();
        let before = crowd.clone();
        let far = usize::MAX;
        for (instance, joint) in
            [(N + 1, 0), (N, 3), (0, 3), (2 * N - 1, 2), (2 * N, 0), (far, 0), (0, far), (far, far)]
        {
            assert_eq!(crowd.get(instance, joint), None);
            let error = crowd.set(instance, joint, DualQuat::ZERO).unwrap_err();
            assert_eq!(error, ShapeError::NoPose { instance, joint, instances, joints });
            names(&error, &[instance, joint, instances, joints]);
        }
        assert_eq!(crowd, before, "written in spite of the error");
    }
    for_every_width!(beyond());
}

#[test]
fn copying_into_a_slice_of_another_length_leaves_it_untouched() {
    fn wrong_length<R: Real, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        let crowd = Crowd::<R, N>::from_slice(3, &poses(3, N + 1)).unwrap();
        let expected = 3 * (N + 1);
        // Other whole numbers of instances, also ones that take as many blocks, and broken ones.
        for length in [0, 3, expected - 3, expected - 1, expected + 1, expected + 3] {
            let mut slice = vec![pose(9, 9); length];
            let error = crowd.copy_to_slice(&mut slice).unwrap_err();
            assert_eq!(error, ShapeError::Length { what: "poses", length, expected });
            names(&error, &[length, expected]);
            assert_eq!(slice, vec![pose(9, 9); length]);
        }
    }
    for_every_width!(wrong_length());
}

#[test]
fn poses_that_are_no_whole_number_of_instances_are_refused() {
    fn broken<R: Real, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        for (joints, length) in [(3, 4), (3, 2), (0, 1), (0, 5), (7, 20)] {
            let poses = vec![pose::<R>(1, 1); length];
            let wanted = ShapeError::NotWhole { what: "poses", length, joints };
            names(&wanted, &[length, joints]);
            assert_eq!(Crowd::<R, N>::from_slice(joints, &poses).unwrap_err(), wanted);
            let mut blocks = vec![junk::<R, N>(); joints];
            assert_eq!(pack(joints, &poses, &mut blocks).unwrap_err(), wanted);
            assert_eq!(blocks, vec![junk(); joints]);
            let mut back = poses.clone();
            assert_eq!(unpack(joints, &blocks, &mut back).unwrap_err(), wanted);
            assert_eq!(back, poses);
        }
    }
    for_every_width!(broken());
}

#[test]
fn blocks_that_are_too_few_or_too_many_are_refused() {
    fn wrong_blocks<R: Real, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        // Three joints, one full block of instances and one more instance.
        let poses = poses::<R>(3, N + 1);
        for length in [0, 3, 5, 7, 9, poses.len()] {
            let wanted = ShapeError::Length { what: "blocks", length, expected: 6 };
            names(&wanted, &[length, 6]);
            let mut blocks = vec![junk::<R, N>(); length];
            assert_eq!(pack(3, &poses, &mut blocks).unwrap_err(), wanted);
            assert_eq!(blocks, vec![junk(); length]);
            let mut back = poses.clone();
            assert_eq!(unpack(3, &blocks, &mut back).unwrap_err(), wanted);
            assert_eq!(back, poses);
        }
    }
    for_every_width!(wrong_blocks());
}

#[test]
fn a_crowd_of_nobody_and_a_crowd_of_no_joints_hold_nothing() {
    fn nothing<R: Real, const N: usize>()
    where
        [R; N]: Row<Real = R>,
    {
        for (joints, instances) in [(0, 0), (5, 0), (0, 5)] {
            let mut crowd = Crowd::<R, N>::new(joints, instances);
            assert_eq!((crowd.joints(), crowd.instances()), (joints, instances));
            assert!(crowd.blocks().is_empty() && crowd.to_vec().is_empty());
            crowd.copy_to_slice(&mut []).unwrap();
            assert_eq!(crowd.get(0, 0), None);
            crowd.set(0, 0, DualQuat::IDENTITY).unwrap_err();
        }
        // The length of a slice cannot tell how many instances of no joints there are.
        assert_eq!(Crowd::<R, N>::from_slice(0, &[]).unwrap().instances(), 0);
        pack::<R, N>(0, &[], &mut []).unwrap();
        unpack::<R, N>(4, &[], &mut []).unwrap();
    }
    for_every_width!(nothing());
}

/// A block is what a kernel loads: lane i of every component is instance i.
#[test]
fn lanes_read_their_own_instances() {
    let crowd = Crowd::<f32, 4>::from_slice(2, &poses(2, 4)).unwrap();
    let lanes: [f32x4; 8] = crowd.blocks()[1].load(dq8::Portable);
    for (component, lanes) in lanes.into_iter().enumerate() {
        let wanted = core::array::from_fn(|i| pose::<f32>(i, 1).to_array()[component]);
        assert_eq!(lanes.to_array(), wanted);
    }
}
