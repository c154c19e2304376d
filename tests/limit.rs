//! The limit of backends, which the C ABI has instead of backends to pass. It is for the whole
//! process, so this is one test in a binary of its own.

use dq8::simd::Row;
use dq8::storage::{Aos, Block, Element, pack, pack_chain, unpack, unpack_chain};
use dq8::{Backend, Crowd, DualQuat, Hierarchy, Quat, Real, Scalar};

const PARENTS: [u32; 4] = [Hierarchy::ROOT, 0, 1, 0];

fn poses(instances: usize) -> Vec<DualQuat<f64>> {
    let wave = |i: usize, f: f64| (i as f64 * f).sin();
    let pose = |i| {
        let turn = Quat::from_parts([wave(i, 0.7), wave(i, 1.1), wave(i, 1.7)], 1.5).normalize();
        DualQuat::from_rotation_translation(turn, [wave(i, 0.3), 1.0, wave(i, 0.9)])
    };
    (0..instances * PARENTS.len()).map(pose).collect()
}

/// Numbers are where the layout says, for everything that blocks hold, any number of instances and
/// segments.
fn packed_by_the_best() {
    fn of<R: Scalar, const N: usize, const C: usize>()
    where
        [R; N]: Row<Real = R>,
        [R; C]: Element<C, Layout = Aos<R>>,
    {
        let number = |thing: usize| [(); C].map(|()| <R as Real>::from_f64(thing as f64));
        for (joints, instances) in [(1, 1), (3, N - 1), (2, N), (3, 2 * N + 1)] {
            let things: Vec<_> = (0..joints * instances).map(number).collect();
            let mut blocks =
                vec![Block::<R, N, C>::splat(number(999)); joints * instances.div_ceil(N)];
            pack(joints, &things, &mut blocks).expect("they fit");
            for (index, thing) in things.iter().enumerate() {
                let (instance, joint) = (index / joints, index % joints);
                let block = &blocks[instance / N * joints + joint];
                assert_eq!(block.get(instance % N), Some(*thing));
            }
            assert_eq!(blocks.last().unwrap().get(N), None);
            let mut back = vec![number(999); things.len()];
            unpack(joints, &blocks, &mut back).expect("they fit");
            assert_eq!(back, things);
            let mut chain = vec![Block::<R, N, C>::splat(number(999)); things.len().div_ceil(N)];
            pack_chain(&things, &mut chain).expect("they fit");
            for (index, thing) in things.iter().enumerate() {
                assert_eq!(chain[index % chain.len()].get(index / chain.len()), Some(*thing));
            }
            back.fill(number(999));
            unpack_chain(&chain, &mut back).expect("they fit");
            assert_eq!(back, things);
        }
    }
    fn of_width<R: Scalar, const N: usize>()
    where
        [R; N]: Row<Real = R>,
        [R; 1]: Element<1, Layout = Aos<R>>,
        [R; 7]: Element<7, Layout = Aos<R>>,
        [R; 8]: Element<8, Layout = Aos<R>>,
        [R; 12]: Element<12, Layout = Aos<R>>,
    {
        of::<R, N, 1>();
        of::<R, N, 7>();
        of::<R, N, 8>();
        of::<R, N, 12>();
    }
    of_width::<f32, 4>();
    of_width::<f32, 8>();
    of_width::<f32, 16>();
    of_width::<f64, 2>();
    of_width::<f64, 4>();
    of_width::<f64, 8>();
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
        packed_by_the_best();
        Backend::limit(None);
        assert_eq!(Backend::best(), best);
    }
    #[cfg(feature = "reproducible")]
    {
        Backend::set_reproducible(true);
        let reproducible = Backend::reproducible();
        assert_eq!((Backend::best(), models(None)), (reproducible, models(Some(reproducible))));
        packed_by_the_best();
        // The limit holds too, and has the same bits.
        Backend::limit(Some(Backend::PORTABLE));
        assert!(Backend::best() <= reproducible);
        assert_eq!(models(None), models(Some(reproducible)));
        Backend::limit(None);
        Backend::set_reproducible(false);
        assert_eq!(Backend::best(), best);
    }
}
