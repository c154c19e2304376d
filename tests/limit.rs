//! The limit of backends, which the C ABI has instead of backends to pass. It is for the whole process, so
//! this is one test in a binary of its own.

use dq8::{Backend, Crowd, DualQuat, Hierarchy, Quat};

const PARENTS: [u32; 4] = [Hierarchy::ROOT, 0, 1, 0];

fn poses(instances: usize) -> Vec<DualQuat<f64>> {
    let wave = |i: usize, f: f64| (i as f64 * f).sin();
    let pose = |i| {
        let turn = Quat::from_parts([wave(i, 0.7), wave(i, 1.1), wave(i, 1.7)], 1.5).normalize();
        DualQuat::from_rotation_translation(turn, [wave(i, 0.3), 1.0, wave(i, 0.9)])
    };
    (0..instances * PARENTS.len()).map(pose).collect()
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
        Backend::limit(None);
        assert_eq!(Backend::best(), best);
    }
}
