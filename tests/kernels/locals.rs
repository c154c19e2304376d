//! Locals that are less than a motion, and skinning palettes: in every layout on every backend,
//! what the products of plain motions are.

use crate::memory::{Memory, lay, read};
use crate::records::{assert_same_bits, entries, same_bits};
use crate::scene::{Forms, On, Scene, walk};
use crate::subject::{Given, Subject, Task, for_every_subject};
use dq8::law::NlerpLerp;
use dq8::storage::{AoSoA, Aos, Block};
use dq8::{
    Backend, DualQuat, Hierarchy, Quat, Real, ShapeError,
    hierarchy::{Bones, Layered, MatrixOrder, Poses, RotationsTranslations, Tracks},
};

/// Eleven joints in two trees.
const PARENTS: [u32; 11] = [Hierarchy::ROOT, 0, 1, 1, 3, 0, Hierarchy::ROOT, 6, 7, 8, 7];

#[track_caller]
fn close(what: &str, subject: &dyn Subject, got: &[f64], wanted: &[f64]) {
    let bound = if subject.single() { 4e-6 } else { 8e-15 };
    let near = |(a, b): (&f64, &f64)| (a - b).abs() <= bound;
    assert!(
        got.len() == wanted.len() && got.iter().zip(wanted).all(near),
        "{what}, {}: {got:?} is not {wanted:?}",
        subject.name()
    );
}

#[test]
fn every_form_of_locals_gives_the_models_and_palettes_of_plain_motions() {
    let scene = Scene::new(&PARENTS, 17, 21);
    let (forms, binds) = (Forms::new(&scene, 17), scene.binds());
    for instances in [0, 1, 2, 5, 8, 17] {
        let count = instances * PARENTS.len();
        let models = walk(&PARENTS, &scene.poses(instances));
        let turned = walk(&PARENTS, &scene.turned(instances));
        for_every_subject(|subject, backend| {
            let before = vec![[f64::NAN; 8]; count];
            for given in &forms.first(instances)[..3] {
                let wanted = if matches!(given, Given::Rotations(..)) { &turned } else { &models };
                let task = Task::new(&PARENTS, backend);
                let got = subject.forward(&task, *given, &before);
                for (got, wanted) in got.iter().zip(wanted) {
                    close(&format!("models on {backend}"), subject, got, wanted);
                }
                for order in [MatrixOrder::Rows, MatrixOrder::Columns] {
                    let task = Task { order, ..task.clone() };
                    let (beside, palette) = subject.palette(&task, *given, &binds, 9.0);
                    for (index, wanted) in wanted.iter().enumerate() {
                        assert!(same_bits(&beside[index], &got[index]), "models beside a palette");
                        let bind = DualQuat::from_array(binds[index % PARENTS.len()]);
                        let wanted = DualQuat::from_array(*wanted) * bind;
                        let wanted = match palette[index].len() {
                            8 => wanted.to_array().to_vec(),
                            count => entries(wanted, order, count),
                        };
                        close(&format!("palette on {backend}"), subject, &palette[index], &wanted);
                    }
                }
            }
        });
    }
}

/// Two arrays instead of one: nothing else differs.
fn transforms_are_the_same<L: Memory>() {
    let scene = Scene::new(&PARENTS, 17, 23);
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let both = scene.rotations_translations(17);
    let turns: Vec<[f64; 4]> = both.iter().map(|[x, y, z, w, ..]| [*x, *y, *z, *w]).collect();
    let shifts: Vec<[f64; 3]> = both.iter().map(|[.., a, b, c]| [*a, *b, *c]).collect();
    for instances in [0, 1, 3, 17] {
        let some = ..instances * PARENTS.len();
        let both = lay::<L, 7>(PARENTS.len(), &both[some]);
        let rotations = &lay::<L, 4>(PARENTS.len(), &turns[some])[..];
        let translations = &lay::<L, 3>(PARENTS.len(), &shifts[some])[..];
        let transforms = Tracks { rotations, translations };
        for backend in Backend::available() {
            let job = hierarchy.job().backend(backend);
            let empty = lay::<L, 8>(PARENTS.len(), &vec![[f64::NAN; 8]; some.end]);
            let (mut models, mut wanted, mut layered) = (empty.clone(), empty.clone(), empty);
            job.locals_to_model(transforms, &mut models).expect("they fit");
            job.locals_to_model(RotationsTranslations(&both), &mut wanted).expect("they fit");
            let records = |models: &[_]| read::<L, 8>(PARENTS.len(), models);
            assert_same_bits(&records(&models), &records(&wanted), &format!("{backend}"));
            // A layer of no weight over them is nothing else either.
            let weights = vec![L::Real::ZERO; instances];
            let layer =
                Layered::blend(NlerpLerp, transforms, RotationsTranslations(&both), &weights);
            job.locals_to_model(layer, &mut layered).expect("they fit");
            for (got, wanted) in records(&layered).iter().zip(records(&wanted)).take(some.end) {
                // Rotations of a layer are normalized again; models are sums of lengths of a few
                // units in `f32`.
                let near = got.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-5);
                assert!(near, "{got:?} is not {wanted:?}, {backend}");
            }
        }
    }
}

#[test]
fn transforms_are_rotations_with_translations_in_two_arrays() {
    transforms_are_the_same::<Aos<f32>>();
    transforms_are_the_same::<Aos<f64>>();
    transforms_are_the_same::<AoSoA<[f32; 8]>>();
    transforms_are_the_same::<AoSoA<[f64; 2]>>();
}

/// A palette of joints that are not computed stays as it was.
#[test]
fn a_range_of_joints_writes_its_own_entries_only() {
    let scene = Scene::new(&PARENTS, 17, 22);
    let (forms, binds, roots) = (Forms::new(&scene, 17), scene.binds(), scene.roots());
    for_every_subject(|subject, backend| {
        for instances in [1, 17] {
            for given in &forms.first(instances)[..3] {
                let all = scene.task(backend, On::Each, &roots);
                // Parents outside the range are at the identity where a palette begins.
                let task = Task { joints: 6..9, ..all };
                let (_, palette) = subject.palette(&task, *given, &binds, 9.0);
                for (index, entry) in palette[..instances * PARENTS.len()].iter().enumerate() {
                    let untouched = entry.iter().all(|number| *number == 9.0);
                    let inside = (6..9).contains(&(index % PARENTS.len()));
                    assert_eq!(untouched, !inside, "{} on {backend}, {index}", subject.name());
                }
            }
        }
    });
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    const JOINTS: usize = PARENTS.len();
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let job = hierarchy.job();
    let turns = [Quat::<f32>::IDENTITY; JOINTS];
    let offsets = [[0.0_f32; 3]; JOINTS];
    let binds = [DualQuat::<f32>::IDENTITY; JOINTS];
    let seven = DualQuat::from_translation([7.0_f32; 3]);
    let (mut models, mut palette) = ([seven; JOINTS], [seven; JOINTS]);
    let rotations = |n: usize, m: usize| Bones { rotations: &turns[..n], offsets: &offsets[..m] };
    let length = |what, length, expected| Err(ShapeError::Length { what, length, expected });
    let not_whole = Err(ShapeError::NotWhole { what: "rotations", length: 10, joints: JOINTS });

    assert_eq!(job.locals_to_model(rotations(JOINTS, 10), &mut models), length("offsets", 10, 11));
    assert_eq!(job.locals_to_model(rotations(10, JOINTS), &mut models), not_whole);
    let all = rotations(JOINTS, JOINTS);
    assert_eq!(job.locals_to_model(all, &mut models[1..]), length("models", 10, 11));
    assert_eq!(
        job.palette_and_models(all, &mut models, &binds[1..], &mut palette),
        length("inverse_binds", 10, 11)
    );
    assert_eq!(
        job.palette_and_models(all, &mut models, &binds, &mut palette[1..]),
        length("palette", 10, 11)
    );
    let apart = Tracks { rotations: &turns, translations: &offsets[1..] };
    assert_eq!(job.locals_to_model(apart, &mut models), length("translations", 10, 11));
    assert_eq!((models, palette), ([seven; JOINTS], [seven; JOINTS]));
}

/// In blocks, too: the two have no code in common before the check.
#[test]
fn offsets_are_one_for_each_joint_and_not_for_each_block() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let turns = vec![Block::<f32, 8, 4>::splat([0.0, 0.0, 0.0, 1.0]); 22];
    let mut models = vec![Block::<f32, 8>::splat([0.0; 8]); 22];
    let offsets = [[0.0_f32; 3]; 22];
    let locals = Bones { rotations: &turns, offsets: &offsets };
    let answer = hierarchy.job().locals_to_model(locals, &mut models);
    assert_eq!(answer, Err(ShapeError::Length { what: "offsets", length: 22, expected: 11 }));
    let mut palette = models.clone();
    let binds = [DualQuat::IDENTITY; 22];
    let answer = hierarchy.job().palette_and_models(
        Poses(&models.clone()),
        &mut models,
        &binds,
        &mut palette,
    );
    assert_eq!(answer, Err(ShapeError::Length { what: "inverse_binds", length: 22, expected: 11 }));
}
