//! The limit of backends, which the C ABI has instead of backends to pass. It is for the whole process, so
//! this is one test in a binary of its own; what has no backend to pass (packing) runs on each here.

use dq8::simd::Row;
use dq8::storage::{Block, Element, pack, unpack};
use dq8::{Backend, Crowd, DualQuat, Hierarchy, Quat, Scalar};

const PARENTS: [u32; 4] = [Hierarchy::ROOT, 0, 1, 0];

fn poses(instances: usize) -> Vec<DualQuat<f64>> {
    let wave = |i: usize, f: f64| (i as f64 * f).sin();
    let pose = |i| {
        let turn = Quat::from_parts([wave(i, 0.7), wave(i, 1.1), wave(i, 1.7)], 1.5).normalize();
        DualQuat::from_rotation_translation(turn, [wave(i, 0.3), 1.0, wave(i, 0.9)])
    };
    (0..instances * PARENTS.len()).map(pose).collect()
}

/// Packed and unpacked number by number, and by the best backend that may be used.
fn packing_copies<R: Scalar, const N: usize>(poses: &[DualQuat<f64>])
where
    [R; N]: Row<Real = R>,
{
    let joints = PARENTS.len();
    let things: Vec<DualQuat<R>> = poses
        .iter()
        .map(|pose| DualQuat::from_array(pose.to_array().map(<R as dq8::Real>::from_f64)))
        .collect();
    let instances = things.len() / joints;
    let identity = DualQuat::<R>::IDENTITY.to_array();
    let mut wanted = vec![Block::<R, N>::splat(identity); instances.div_ceil(N) * joints];
    for (index, thing) in things.iter().enumerate() {
        let (instance, joint) = (index / joints, index % joints);
        let block = instance / N * joints + joint;
        Block::<R, N>::set(&mut wanted[block], instance % N, thing.to_array()).expect("a lane");
    }
    let mut blocks = vec![Block::splat([R::ZERO; 8]); wanted.len()];
    pack(joints, &things, &mut blocks).expect("they fit");
    assert_eq!(blocks, wanted);
    let mut back = vec![DualQuat::ZERO; things.len()];
    unpack(joints, &blocks, &mut back).expect("they fit");
    assert_eq!(back, things);
    assert_eq!(<Block<R, N> as Element<8>>::get(&blocks, 0), Some(things[0].to_array()));
}

#[test]
fn nothing_better_than_the_limit_computes_where_no_backend_is_named() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("parents come first");
    let crowd = Crowd::<f64, 8>::from_slice(PARENTS.len(), &poses(19)).expect("whole instances");
    let models = |named: Option<Backend>| {
        let mut crowd = crowd.clone();
        let job = hierarchy.job();
        let job = named.map_or(job.clone(), |backend| job.backend(backend));
        job.local_to_model_in_place(crowd.blocks_mut()).expect("they fit");
        crowd
    };
    let best = Backend::best();
    for backend in Backend::available() {
        let named = models(Some(backend));
        Backend::limit(Some(backend));
        assert_eq!((Backend::best(), Backend::default()), (backend, backend));
        // What is named is not limited.
        assert_eq!(Backend::available().last(), Some(best));
        assert_eq!(models(Some(best)), {
            Backend::limit(None);
            models(None)
        });
        Backend::limit(Some(backend));
        // Where one backend fuses and another does not, the bits tell which it was.
        assert_eq!(models(None), named, "{backend} is the limit");
        for instances in [1, 7, 16, 33] {
            let poses = poses(instances);
            packing_copies::<f32, 4>(&poses);
            packing_copies::<f32, 8>(&poses);
            packing_copies::<f32, 16>(&poses);
            packing_copies::<f64, 2>(&poses);
            packing_copies::<f64, 4>(&poses);
            packing_copies::<f64, 8>(&poses);
        }
        Backend::limit(None);
        assert_eq!(Backend::best(), best);
    }
}
