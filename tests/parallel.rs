//! Crowds over all cores: every bit as on one.
#![cfg(feature = "rayon")]

use dq8::{Backend, Crowd, DualQuat, Hierarchy, Quat, Renormalize, ShapeError};

const PARENTS: [u32; 5] = [Hierarchy::ROOT, 0, 1, 1, 0];

fn crowd(instances: usize) -> Crowd<f32, 8> {
    let wave = |i: usize, f: f32| (i as f32 * f).sin();
    let pose = |i| {
        let turn = Quat::from_parts([wave(i, 0.7), wave(i, 1.1), wave(i, 1.7)], 1.5).normalize();
        DualQuat::from_rotation_translation(turn, [wave(i, 0.3), 1.0, wave(i, 0.9)])
    };
    let poses: Vec<_> = (0..instances * PARENTS.len()).map(pose).collect();
    Crowd::from_slice(PARENTS.len(), &poses).expect("whole instances")
}

#[test]
fn all_cores_compute_the_bits_of_one() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    // From less than a task to several, the last of them short.
    for instances in [0, 1, 100, 20_011] {
        let locals = crowd(instances);
        let roots = locals.blocks().iter().step_by(PARENTS.len()).copied().collect::<Vec<_>>();
        let every = Renormalize::Every(3.try_into().expect("not 0"));
        let jobs = [
            hierarchy.job(),
            hierarchy.job().root(DualQuat::from_translation([1.0, 2.0, 3.0])),
            hierarchy.job().roots(&roots),
            hierarchy.job().joints(1..4).renormalize(every),
        ];
        for job in jobs {
            let (mut one, mut all) = (locals.clone(), locals.clone());
            job.local_to_model(locals.blocks(), one.blocks_mut()).expect("they fit");
            job.par_local_to_model(locals.blocks(), all.blocks_mut()).expect("they fit");
            assert_eq!(one, all);
            let mut in_place = locals.clone();
            job.par_local_to_model_in_place(in_place.blocks_mut()).expect("they fit");
            assert_eq!(one, in_place);
        }
    }
}

#[test]
fn a_chain_in_segments_of_threads_is_the_chain() {
    let backend = Backend::best();
    // None, less than a segment, whole segments, and a rest.
    for length in [0, 100, 4096, 9001] {
        let mut one = Vec::new();
        for instance in 0..length {
            let pose = crowd(1).get(0, instance % PARENTS.len()).expect("a joint");
            let turn = pose.rotation().to_array().map(f64::from);
            one.push(DualQuat::from_rotation(Quat::from_array(turn).normalize()));
        }
        let mut all = one.clone();
        backend.par_chain_products_in_place(&mut all);
        let mut product = DualQuat::<f64>::IDENTITY;
        for (i, (link, got)) in one.iter_mut().zip(&all).enumerate() {
            product = product * *link;
            for (a, b) in product.to_array().iter().zip(got.to_array()) {
                assert!((a - b).abs() < 1e-11, "link {i} of {length}: {a} {b}");
            }
        }
    }
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let mut crowd = crowd(5000);
    let before = crowd.clone();
    let blocks = before.blocks();
    let roots = &blocks[..7];
    let error = hierarchy.job().roots(roots).par_local_to_model_in_place(crowd.blocks_mut());
    assert_eq!(error, Err(ShapeError::Length { what: "roots", length: 7, expected: 625 }));
    let error = hierarchy.job().par_local_to_model(&blocks[5..], crowd.blocks_mut());
    assert!(matches!(error, Err(ShapeError::Length { what: "models", .. })), "{error:?}");
    assert_eq!(crowd, before);
}
