//! Jobs over all cores: every bit as on one.

use crate::inputs::Inputs;
use crate::scene::{Scene, step};
use crate::slices::kernels;
use crate::subject::subjects;
use dq8::representation::RotationTranslation;
use dq8::storage::Aos;
use dq8::{
    Backend, Block, Crowd, DualQuat, Hierarchy, Job, ShapeError,
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
) -> [Job<'a, Root<'a, E>>; 4] {
    let every = Renormalize::Every(3.try_into().expect("not 0"));
    let root = DualQuat::from_translation([1.0, 2.0, 3.0].map(dq8::Real::from_f64));
    [
        hierarchy.job().on(Root::None).backend(Backend::PORTABLE),
        hierarchy.job().on(Root::Same(root)),
        hierarchy.job().on(Root::Each(roots)).matrix_order(MatrixOrder::Columns),
        hierarchy.job().on(Root::None).joints(1..4).renormalize(every),
    ]
}

/// What a job writes over `before` with one thread, and with all of them.
#[track_caller]
fn on_all<'a, T: Clone + PartialEq, O: Clone>(
    job: &Job<'a, O>,
    before: &T,
    run: impl Fn(Job<'a, O>, &mut T) -> Result<(), ShapeError>,
) -> T {
    let [mut one, mut all] = [before.clone(), before.clone()];
    run(job.clone(), &mut one).expect("they fit");
    run(job.clone().threads(usize::MAX), &mut all).expect("they fit");
    assert!(one == all);
    one
}

/// In blocks, and of plain motions, where tasks end where lanes of instances do not.
#[test]
fn all_cores_compute_the_bits_of_one() {
    fn check<E: dq8::Element<8> + PartialEq>(locals: &[E])
    where
        E::Layout: dq8::storage::Layout<Real = f32>,
    {
        let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
        let roots: Vec<_> = locals.iter().step_by(PARENTS.len()).copied().collect();
        for job in jobs(&hierarchy, &roots) {
            let locals = locals.to_vec();
            let apart = on_all(&job, &locals, |job, to| job.local_to_model(&locals, to));
            let in_place = on_all(&job, &locals, |job, to| job.local_to_model_in_place(to));
            assert!(apart == in_place, "{} elements", locals.len());
        }
    }
    for instances in INSTANCES {
        check(crowd(instances).blocks());
        check(&poses(instances));
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
        let both: Vec<[f32; 7]> =
            locals.iter().map(|&local| RotationTranslation::from(local).to_array()).collect();
        let roots: Vec<_> = locals.iter().step_by(PARENTS.len()).copied().collect();
        let small = vec![[[0.0_f32; 4]; 3]; locals.len()];
        let large = vec![[[0.0_f32; 4]; 4]; locals.len()];
        let turned = Bones { rotations: &turns, offsets: &offsets };
        on_all(&hierarchy.job(), &locals, |job, to| job.locals(turned, to));
        for job in jobs(&hierarchy, &roots) {
            on_all(&job, &locals, |job, to| job.locals_to_model(turned, to));
            on_all(&job, &(locals.clone(), locals.clone()), |job, (models, palette)| {
                job.palette_and_models(turned, models, &binds, palette)
            });
            on_all(&job, &(locals.clone(), small.clone()), |job, (models, palette)| {
                job.palette_and_models(Poses(&locals[..]), models, &binds, palette)
            });
            on_all(&job, &(locals.clone(), large.clone()), |job, (models, palette)| {
                job.palette_and_models(RotationsTranslations(&both), models, &binds, palette)
            });
        }
        // And crowds of less than motions, with palettes of matrices.
        let turns = Crowd::<f32, 8, 4>::from_slice(PARENTS.len(), &turns).expect("whole instances");
        let turned = Bones { rotations: turns.blocks(), offsets: &offsets };
        let matrices = Crowd::<f32, 8, 12>::new(PARENTS.len(), instances);
        on_all(&hierarchy.job(), &(crowd(instances), matrices), |job, (models, palette)| {
            job.palette_and_models(turned, models.blocks_mut(), &binds, palette.blocks_mut())
        });
    }
}

/// Palettes whose models go through scratch memory, of which each thread has a part: of enough for
/// all, for two, for one.
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
fn means_of_windows_have_the_bits_of_one_thread_on_all() {
    let best = Backend::best();
    let near: Vec<_> = poses(1000).iter().map(|pose| pose.pow(0.1)).collect();
    let weights = [1.0, 2.0, 1.0];
    let [mut one, mut all] = [(); 2].map(|()| vec![DualQuat::IDENTITY; near.len() - 2]);
    let means = [(best, &mut one), (best.threads(2), &mut all)].map(|(backend, means)| {
        backend.dib_windows(&near, &weights, 1e-5, 20, means).expect("they fit")
    });
    assert!(one == all && means[0] == means[1], "{means:?}");
}

/// Nothing divided among threads is nothing.
#[test]
fn a_hierarchy_of_no_joints_runs_on_all_cores() {
    let hierarchy = Hierarchy::new(&[]).expect("no joints");
    let (job, mut none) = (hierarchy.job().threads(usize::MAX), [DualQuat::<f32>::IDENTITY; 0]);
    job.local_to_model_in_place(&mut none).expect("they fit");
    job.model_to_local_in_place(&mut none).expect("they fit");
    job.locals(Poses(&[DualQuat::<f32>::IDENTITY; 0]), &mut none).expect("they fit");
    job.palette(Poses(&[]), &mut none, &[], &mut [[0.0_f32; 12]; 0]).expect("they fit");
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let mut crowd = crowd(5000);
    let before = crowd.clone();
    let blocks: &[Block<f32, 8>] = before.blocks();
    let roots = &blocks[..7];
    let job = hierarchy.job().threads(usize::MAX);
    let error = job.clone().roots(roots).local_to_model_in_place(crowd.blocks_mut());
    assert_eq!(error, Err(ShapeError::Length { what: "roots", length: 7, expected: 625 }));
    let error = job.local_to_model(&blocks[5..], crowd.blocks_mut());
    assert!(matches!(error, Err(ShapeError::Length { what: "models", .. })), "{error:?}");
    let (binds, mut palette) = ([DualQuat::IDENTITY; 4], before.clone());
    let (models, entries) = (crowd.blocks_mut(), palette.blocks_mut());
    let error = job.palette_and_models(Poses(blocks), models, &binds, entries);
    assert_eq!(error, Err(ShapeError::Length { what: "inverse_binds", length: 4, expected: 5 }));
    assert_eq!((crowd, palette), (before.clone(), before));
}
