//! Palettes whose models go through scratch: to the last bit those of runs that keep all models.

use core::num::NonZeroU32;
use dq8::hierarchy::{Bones, MatrixOrder, Poses, Renormalize, Root};
use dq8::{Backend, DualQuat, Hierarchy, Quat, Real, Scalar};
use dq8_contract::random::Random;

/// Two trees; a parent lies as far back as a joint can.
const PARENTS: [u32; 20] = [
    Hierarchy::ROOT,
    0,
    1,
    2,
    3,
    2,
    5,
    Hierarchy::ROOT,
    7,
    8,
    9,
    10,
    11,
    12,
    13,
    14,
    15,
    16,
    17,
    0,
];
const JOINTS: usize = PARENTS.len();
/// Whole registers of every width, and some left over.
const INSTANCES: usize = 2 * 16 + 3;

fn motions<R: Scalar>(random: &mut Random, count: usize) -> Vec<DualQuat<R>> {
    let mut number = || <R as Real>::from_f64(random.between(-1.0, 1.0));
    let mut motion = || {
        let turn = Quat::from_scaled_axis([number(), number(), number()]);
        DualQuat::from_rotation_translation(turn, [number(), number(), number()])
    };
    (0..count).map(|_| motion()).collect()
}

/// Every number of a palette, exactly.
fn numbers<R: Scalar>(palette: &[[[R; 4]; 3]]) -> Vec<u64> {
    palette.as_flattened().as_flattened().iter().map(|&n| Into::<f64>::into(n).to_bits()).collect()
}

fn holds_to_the_last_bit<R: Scalar>() {
    let random = &mut Random(7);
    let hierarchy = Hierarchy::new(&PARENTS).expect("parents come first");
    let poses = motions::<R>(random, INSTANCES * JOINTS);
    let rotations: Vec<_> = poses.iter().map(|pose| pose.rotation()).collect();
    let (binds, roots) = (motions::<R>(random, JOINTS), motions::<R>(random, INSTANCES));
    let offsets: Vec<_> = binds.iter().map(|bind| bind.translation()).collect();
    let rotations = Bones { rotations: &rotations, offsets: &offsets };
    let second = Renormalize::Every(NonZeroU32::new(2).expect("not zero"));
    let mut models = poses.clone();
    let empty = [[<R as Real>::ZERO; 4]; 3];
    for backend in Backend::available() {
        let job = hierarchy.job().backend(backend);
        let jobs = [
            job.clone().on(Root::None),
            job.clone().on(Root::Each(&roots)).matrix_order(MatrixOrder::Columns),
            job.clone().on(Root::Same(roots[0])).renormalize(second),
            job.on(Root::None).joints(..JOINTS - 3),
        ];
        for job in jobs {
            let mut wanted = vec![empty; poses.len()];
            job.palette_and_models(Poses(&poses), &mut models, &binds, &mut wanted).expect("fit");
            let mut turned = wanted.clone();
            job.palette_and_models(rotations, &mut models, &binds, &mut turned).expect("fit");
            // Scratch for fewer instances than there are lanes, for as many, for more, wherever it begins.
            for (instances, begin) in [(1, 0), (3, 0), (8, 0), (8, 1), (16, 0), (16, 3), (40, 1)] {
                let mut scratch = vec![DualQuat::<R>::IDENTITY; instances * JOINTS + begin];
                let scratch = &mut scratch[begin..];
                let mut palette = vec![empty; poses.len()];
                job.palette(Poses(&poses), scratch, &binds, &mut palette).expect("they fit");
                assert_eq!(numbers(&palette), numbers(&wanted), "{backend}, {instances}, {begin}");
                let mut palette = wanted.clone();
                job.palette(rotations, scratch, &binds, &mut palette).expect("they fit");
                assert_eq!(numbers(&palette), numbers(&turned), "{backend}, {instances}, {begin}");
            }
        }
    }
}

#[test]
fn a_palette_through_scratch_has_the_bits_of_one_with_models_in_single_precision() {
    holds_to_the_last_bit::<f32>();
}

#[test]
fn a_palette_through_scratch_has_the_bits_of_one_with_models_in_double_precision() {
    holds_to_the_last_bit::<f64>();
}

/// Models beyond the caches are asked for ahead, which must change nothing: 64 instances are within them, 2,048 not.
#[test]
fn instances_among_many_have_the_bits_of_those_among_few() {
    let random = &mut Random(8);
    let hierarchy = Hierarchy::new(&PARENTS).expect("parents come first");
    let poses = motions::<f32>(random, 2048 * JOINTS);
    let mut models = poses.clone();
    hierarchy.local_to_model(&poses, &mut models).expect("whole instances");
    for (poses, models) in poses.chunks(64 * JOINTS).zip(models.chunks(64 * JOINTS)) {
        let mut few = poses.to_vec();
        hierarchy.local_to_model(poses, &mut few).expect("whole instances");
        assert_eq!(few, models);
    }
}
