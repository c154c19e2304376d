//! Palettes whose models go through scratch: to the last bit those of runs that keep all models.

use crate::memory::{Memory, lay, read, round};
use crate::records::assert_same_bits;
use crate::scene::{MAX_INSTANCES, ROOT, Scene, motions};
use core::num::NonZeroU32;
use dq8::hierarchy::{Bones, MatrixOrder, Poses, Renormalize, Root};
use dq8::storage::{AoSoA, Aos};
use dq8::{Backend, DualQuat, Hierarchy, Real};
use dq8_contract::random::Random;

/// Two trees; a parent lies as far back as a joint can.
#[rustfmt::skip]
const PARENTS: [u32; 20] = [ROOT, 0, 1, 2, 3, 2, 5, ROOT, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0];
const JOINTS: usize = PARENTS.len();

/// Of [`MAX_INSTANCES`]: whole registers of every width, and one instance more.
fn holds_to_the_last_bit<L: Memory>() {
    let scene = Scene::new(&PARENTS, MAX_INSTANCES, 7);
    let hierarchy = Hierarchy::new(&PARENTS).expect("parents come first");
    let poses = lay::<L, 8>(JOINTS, &scene.poses(MAX_INSTANCES));
    let rotations = lay::<L, 4>(JOINTS, &scene.rotations(MAX_INSTANCES));
    let motion = |motion: &[f64; 8]| DualQuat::from_array(round::<L::Real, 8>(*motion));
    let binds: Vec<_> = scene.binds().iter().map(motion).collect();
    let offsets: Vec<_> = scene.offsets().into_iter().map(round::<L::Real, 3>).collect();
    let roots = lay::<L, 8>(1, &scene.roots());
    let turned = Bones { rotations: &rotations[..], offsets: &offsets };
    let second = Renormalize::Every(NonZeroU32::new(2).expect("not zero"));
    let (mut models, empty) = (poses.clone(), L::filled::<12>(L::Real::ZERO));
    for backend in Backend::available() {
        let job = hierarchy.job().backend(backend);
        let jobs = [
            job.clone().on(Root::None),
            job.clone().on(Root::Each(&roots)).matrix_order(MatrixOrder::Columns),
            job.clone().on(Root::Same(motion(&scene.roots()[0]))).renormalize(second),
            job.on(Root::None).joints(..JOINTS - 3),
        ];
        for job in jobs {
            let mut of_poses = vec![empty; poses.len()];
            job.palette_and_models(Poses(&poses), &mut models, &binds, &mut of_poses).expect("fit");
            let mut of_turns = of_poses.clone();
            job.palette_and_models(turned, &mut models, &binds, &mut of_turns).expect("fit");
            // Scratch for fewer instances than there are lanes, for as many, for more, wherever it
            // begins.
            for (instances, begin) in [(1, 0), (3, 0), (8, 0), (8, 1), (16, 0), (16, 3), (40, 1)] {
                let mut scratch = vec![L::filled::<8>(L::Real::ONE); instances * JOINTS + begin];
                let scratch = &mut scratch[begin..];
                let mut palette = vec![empty; poses.len()];
                let same = |wanted: &[L::Record<12>], palette: &[L::Record<12>]| {
                    let what = format!("{} on {backend}, {instances}, {begin}", L::name());
                    assert_same_bits(&read::<L, 12>(1, palette), &read::<L, 12>(1, wanted), &what);
                };
                job.palette(Poses(&poses), scratch, &binds, &mut palette).expect("they fit");
                same(&of_poses, &palette);
                job.palette(turned, scratch, &binds, &mut palette).expect("they fit");
                same(&of_turns, &palette);
            }
        }
    }
}

#[test]
fn a_palette_through_scratch_has_the_bits_of_one_with_all_models() {
    holds_to_the_last_bit::<Aos<f32>>();
    holds_to_the_last_bit::<Aos<f64>>();
    holds_to_the_last_bit::<AoSoA<[f32; 8]>>();
}

/// Models beyond the caches are asked for ahead, which must change nothing: 64 instances are within
/// them, 2,048 not.
#[test]
fn instances_among_many_have_the_bits_of_those_among_few() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("parents come first");
    let poses = motions(&mut Random(8), 2048 * JOINTS);
    let poses: Vec<_> =
        poses.into_iter().map(|pose| DualQuat::from_array(round::<f32, 8>(pose))).collect();
    let mut models = poses.clone();
    hierarchy.local_to_model(&poses, &mut models).expect("whole instances");
    for (poses, models) in poses.chunks(64 * JOINTS).zip(models.chunks(64 * JOINTS)) {
        let mut few = poses.to_vec();
        hierarchy.local_to_model(poses, &mut few).expect("whole instances");
        assert_eq!(few, models);
    }
}
