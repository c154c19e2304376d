//! Jobs over all cores: every bit as on one.

use crate::inputs::Inputs;
use crate::scene::{Scene, step};
use crate::slices::kernels;
use crate::subject::subjects;
use dq8::storage::Aos;
use dq8::{
    Backend, Block, Crowd, DualQuat, Hierarchy, ShapeError,
    hierarchy::{Bones, MatrixOrder, Poses, Renormalize, Root, RotationsTranslations},
};
use dq8_contract::random::Random;

const PARENTS: [u32; 5] = [Hierarchy::ROOT, 0, 1, 1, 0];

/// From less than a task to several, the last of them short.
const INSTANCES: [usize; 4] = [0, 1, 100, 20_011];

fn poses(instances: usize) -> Vec<DualQuat<f32>> {
    let mut random = Random(6);
    let pose = || DualQuat::from_array(step(&mut random).motion().map(|c| c as f32));
    core::iter::repeat_with(pose).take(instances * PARENTS.len()).collect()
}

fn crowd(instances: usize) -> Crowd<f32, 8> {
    Crowd::from_slice(PARENTS.len(), &poses(instances)).expect("whole instances")
}

/// Jobs of every kind; `roots` are one for each instance.
fn jobs<'a, E: dq8::Element<8>>(
    hierarchy: &Hierarchy<'a>,
    roots: &'a [E],
) -> [dq8::Job<'a, Root<'a, E>>; 4] {
    let every = Renormalize::Every(3.try_into().expect("not 0"));
    let root = DualQuat::from_translation([1.0, 2.0, 3.0].map(dq8::Real::from_f64));
    [
        hierarchy.job().on(Root::None).backend(Backend::PORTABLE),
        hierarchy.job().on(Root::Same(root)),
        hierarchy.job().on(Root::Each(roots)).matrix_order(MatrixOrder::Columns),
        hierarchy.job().on(Root::None).joints(1..4).renormalize(every),
    ]
}

#[test]
fn all_cores_compute_the_bits_of_one() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    for instances in INSTANCES {
        let locals = crowd(instances);
        let roots = locals.blocks().iter().step_by(PARENTS.len()).copied().collect::<Vec<_>>();
        for job in jobs(&hierarchy, &roots) {
            let (mut one, mut all) = (locals.clone(), locals.clone());
            job.local_to_model(locals.blocks(), one.blocks_mut()).expect("they fit");
            job.clone()
                .threads(usize::MAX)
                .local_to_model(locals.blocks(), all.blocks_mut())
                .expect("they fit");
            assert_eq!(one, all);
            let mut in_place = locals.clone();
            job.clone()
                .threads(usize::MAX)
                .local_to_model_in_place(in_place.blocks_mut())
                .expect("they fit");
            assert_eq!(one, in_place);
        }
    }
}

/// Plain motions: tasks end where lanes of instances do not.
#[test]
fn all_cores_compute_the_bits_of_one_of_plain_motions() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    for instances in INSTANCES {
        let locals = poses(instances);
        let roots: Vec<_> = locals.iter().step_by(PARENTS.len()).copied().collect();
        for job in jobs(&hierarchy, &roots) {
            let (mut one, mut all) = (locals.clone(), locals.clone());
            job.local_to_model(&locals, &mut one).expect("they fit");
            job.clone().threads(usize::MAX).local_to_model(&locals, &mut all).expect("they fit");
            assert!(one == all, "{instances} instances");
            let mut in_place = locals.clone();
            job.clone()
                .threads(usize::MAX)
                .local_to_model_in_place(&mut in_place)
                .expect("they fit");
            assert!(one == in_place, "{instances} instances, in place");
        }
    }
}

#[test]
fn all_cores_compute_the_bits_of_one_of_every_form_and_palette() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let scene = Scene::new(&PARENTS, 1, 3);
    let binds: Vec<_> =
        scene.binds().iter().map(|b| DualQuat::from_array(b.map(|c| c as f32))).collect();
    let offsets: Vec<_> = scene.offsets().iter().map(|o| o.map(|c| c as f32)).collect();
    for instances in INSTANCES {
        let locals = poses(instances);
        let turns: Vec<_> = locals.iter().map(|local| local.rotation()).collect();
        let both: Vec<[f32; 7]> = locals
            .iter()
            .map(|local| {
                let ([x, y, z, w], [tx, ty, tz]) =
                    (local.rotation().to_array(), local.translation());
                [x, y, z, w, tx, ty, tz]
            })
            .collect();
        let roots: Vec<_> = locals.iter().step_by(PARENTS.len()).copied().collect();
        for job in jobs(&hierarchy, &roots) {
            let (mut one, mut all) = (locals.clone(), locals.clone());
            let turned = Bones { rotations: &turns, offsets: &offsets };
            job.locals_to_model(turned, &mut one).expect("they fit");
            job.clone().threads(usize::MAX).locals_to_model(turned, &mut all).expect("they fit");
            assert!(one == all, "{instances} instances, rotations");
            hierarchy.job().locals(turned, &mut one).expect("they fit");
            hierarchy.job().threads(usize::MAX).locals(turned, &mut all).expect("they fit");
            assert!(one == all, "{instances} instances, locals");

            let (mut motions, mut par_motions) = (locals.clone(), locals.clone());
            job.palette_and_models(turned, &mut one, &binds, &mut motions).expect("they fit");
            job.clone()
                .threads(usize::MAX)
                .palette_and_models(turned, &mut all, &binds, &mut par_motions)
                .expect("they fit");
            assert!(one == all && motions == par_motions, "{instances} instances, motions");

            let mut small = vec![[[0.0_f32; 4]; 3]; locals.len()];
            let mut par_small = small.clone();
            let given = Poses(&locals[..]);
            job.palette_and_models(given, &mut one, &binds, &mut small).expect("they fit");
            job.clone()
                .threads(usize::MAX)
                .palette_and_models(given, &mut all, &binds, &mut par_small)
                .expect("they fit");
            assert!(one == all && small == par_small, "{instances} instances, 3 by 4");

            let mut large = vec![[[0.0_f32; 4]; 4]; locals.len()];
            let mut par_large = large.clone();
            let given = RotationsTranslations(&both);
            job.palette_and_models(given, &mut one, &binds, &mut large).expect("they fit");
            job.clone()
                .threads(usize::MAX)
                .palette_and_models(given, &mut all, &binds, &mut par_large)
                .expect("they fit");
            assert!(one == all && large == par_large, "{instances} instances, 4 by 4");
        }
        // And crowds of less than motions, with palettes of matrices.
        let turns = Crowd::<f32, 8, 4>::from_slice(PARENTS.len(), &turns).expect("whole instances");
        let locals = Bones { rotations: turns.blocks(), offsets: &offsets };
        let (mut one, mut all) = (crowd(instances), crowd(instances));
        let mut matrices = Crowd::<f32, 8, 12>::new(PARENTS.len(), instances);
        let mut par_matrices = matrices.clone();
        let job = hierarchy.job();
        job.palette_and_models(locals, one.blocks_mut(), &binds, matrices.blocks_mut())
            .expect("they fit");
        job.clone()
            .threads(usize::MAX)
            .palette_and_models(locals, all.blocks_mut(), &binds, par_matrices.blocks_mut())
            .expect("they fit");
        assert!(one == all && matrices == par_matrices, "{instances} instances in blocks");
    }
}

/// Palettes whose models go through scratch memory, of which each thread has a part: of enough for all, for two, for one.
#[test]
fn all_cores_compute_the_bits_of_one_of_palettes_without_models() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let binds = [DualQuat::from_translation([0.5, 1.0, -2.0]); 5];
    for instances in INSTANCES {
        let locals = poses(instances);
        let roots: Vec<_> = locals.iter().step_by(PARENTS.len()).copied().collect();
        let job = hierarchy.job().roots(&roots);
        let mut one = vec![[[0.0_f32; 4]; 3]; locals.len()];
        let mut scratch = vec![DualQuat::IDENTITY; 16 * PARENTS.len()];
        job.palette(Poses(&locals), &mut scratch, &binds, &mut one).expect("they fit");
        for held in [1, 16, 33, 1000] {
            let mut scratch = vec![DualQuat::IDENTITY; held * PARENTS.len()];
            let mut all = vec![[[0.0_f32; 4]; 3]; locals.len()];
            let job = job.clone().threads(3);
            job.palette(Poses(&locals), &mut scratch, &binds, &mut all).expect("they fit");
            assert!(one == all, "{instances} instances, scratch for {held}");
        }
    }
}

/// From three tasks on, the last of them short, and between tasks of blocks and of plain things.
#[test]
fn all_cores_compute_the_bits_of_one_of_slices() {
    let inputs = Inputs::new(2 * 2048 + 77);
    for subject in subjects() {
        let inputs = inputs.rounded(subject.single());
        for (index, kernel) in kernels::<Aos<f64>>().iter().enumerate() {
            let one = subject.slices(Backend::best(), index, &inputs);
            let all = subject.slices(Backend::best().threads(3), index, &inputs);
            assert!(one == all, "{} of {}", kernel.name, subject.name());
        }
    }
}

#[test]
fn trajectories_have_the_bits_of_one_thread_on_all() {
    let poses = poses(1000);
    let times: Vec<_> = (0..poses.len()).map(|i| i as f32).collect();
    let at: Vec<_> = (0..7000).map(|i| (i * 37 % 5003) as f32 * 0.99).collect();
    let [mut one, mut all] = [(); 2].map(|()| vec![DualQuat::IDENTITY; at.len()]);
    let best = Backend::best();
    best.resample(&times, &poses, &at, &mut one).expect("they fit");
    best.threads(3).resample(&times, &poses, &at, &mut all).expect("they fit");
    assert!(one == all);
    let near: Vec<_> = poses.iter().map(|pose| pose.pow(0.1)).collect();
    let weights = [1.0, 2.0, 1.0];
    let [mut one, mut all] = [(); 2].map(|()| vec![DualQuat::IDENTITY; near.len() - 2]);
    let means = [(best, &mut one), (best.threads(2), &mut all)].map(|(backend, means)| {
        backend.dib_windows(&near, &weights, 1e-5, 20, means).expect("they fit")
    });
    assert!(one == all && means[0] == means[1], "{means:?}");
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let mut crowd = crowd(5000);
    let before = crowd.clone();
    let blocks: &[Block<f32, 8>] = before.blocks();
    let roots = &blocks[..7];
    let error = hierarchy
        .job()
        .roots(roots)
        .threads(usize::MAX)
        .local_to_model_in_place(crowd.blocks_mut());
    assert_eq!(error, Err(ShapeError::Length { what: "roots", length: 7, expected: 625 }));
    let error =
        hierarchy.job().threads(usize::MAX).local_to_model(&blocks[5..], crowd.blocks_mut());
    assert!(matches!(error, Err(ShapeError::Length { what: "models", .. })), "{error:?}");
    let binds = [DualQuat::IDENTITY; 4];
    let mut palette = before.clone();
    let error = hierarchy.job().threads(usize::MAX).palette_and_models(
        Poses(blocks),
        crowd.blocks_mut(),
        &binds,
        palette.blocks_mut(),
    );
    assert_eq!(error, Err(ShapeError::Length { what: "inverse_binds", length: 4, expected: 5 }));
    assert_eq!((crowd, palette), (before.clone(), before));
}
