//! 5,000 characters walk over waves of sand, each at its own time, and wave with the arm alone.
//! Their feet stay above the ground; the GPU gets 3×4 matrices by columns.
//!
//! ```sh
//! cargo run --release --example crowd
//! ```

use dq8::hierarchy::{Layered, MatrixOrder, OwnedClip, Poses, Sampled};
use dq8::{
    DualQuat, Quat, Skeleton, ik::Limb, law::NlerpLerp, representation::RotationTranslation,
};

const JOINTS: usize = 11;
/// hip → spine → shoulder → hand, spine → head; hip → thigh → shin → foot, twice.
const PARENTS: [i32; JOINTS] = [-1, 0, 1, 2, 1, 0, 5, 6, 0, 8, 9];
/// They look along z, so that knees turn about x.
const LEGS: [Limb<f32>; 2] = [
    Limb { joints: [5, 6, 7], hinge: [1.0, 0.0, 0.0] },
    Limb { joints: [8, 9, 10], hinge: [1.0, 0.0, 0.0] },
];
/// From a joint of the foot to its sole.
const ANKLE: f32 = 0.1;

/// The place of a joint in its parent, in metres.
fn offset(joint: usize) -> [f32; 3] {
    match joint {
        0 => [0.0, 0.9, 0.0],
        1..5 => [0.0, 0.3, 0.0],
        5 => [-0.1, 0.0, 0.0],
        8 => [0.1, 0.0, 0.0],
        _ => [0.0, -0.43, 0.0],
    }
}

/// A second, in which each joint turns to and fro by these angles.
fn clip(angles: [f32; JOINTS]) -> Result<OwnedClip<RotationTranslation<f32>>, dq8::ShapeError> {
    let key = |i: usize| {
        let (frame, joint) = ((i / JOINTS) as f32, i % JOINTS);
        let swing = (frame * core::f32::consts::TAU / 30.0).sin();
        let rotation = Quat::from_rotation_x(angles[joint] * swing);
        RotationTranslation { rotation, translation: offset(joint) }
    };
    let keys: Vec<_> = (0..31 * JOINTS).map(key).collect();
    Ok(OwnedClip::new(JOINTS, keys)?.with_rate(30.0).looping())
}

/// The height of the ground.
fn ground(x: f32, z: f32) -> f32 {
    0.1 * (0.9 * x).sin() * (0.7 * z).cos()
}

/// The depth of the lowest foot in the ground, in metres.
fn deepest(models: &[DualQuat<f32>], roots: &[DualQuat<f32>]) -> f32 {
    let people = models.chunks(JOINTS).zip(roots);
    let feet = people.flat_map(|(joints, root)| LEGS.map(|leg| *root * joints[leg.joints[2]]));
    feet.map(|foot| foot.translation())
        .map(|[x, y, z]| ground(x, z) + ANKLE - y)
        .fold(f32::MIN, f32::max)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rig = Skeleton::new(&PARENTS)?;
    let walk = clip([0.1, 0.2, 0.5, 0.3, 0.0, 0.4, 0.3, 0.0, -0.4, -0.3, 0.0])?;
    let wave = clip([0.0, 0.0, 1.5, 0.8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])?;
    let mut mask = [0.0; JOINTS];
    mask[rig.subtree(2)?].fill(1.0);
    let mut rest: [_; JOINTS] = core::array::from_fn(|i| DualQuat::from_translation(offset(i)));
    rig.job().local_to_model_in_place(&mut rest)?;
    let inverse_binds = rest.map(DualQuat::conjugate);
    let place =
        |i: usize| [(i % 70) as f32, ground((i % 70) as f32, (i / 70) as f32), (i / 70) as f32];
    let roots: Vec<_> = (0..5000).map(|i| DualQuat::from_translation(place(i))).collect();
    let waves: Vec<_> = (0..5000).map(|i| f32::from(i % 3 == 0)).collect(); // every third one
    let at = |clip: &OwnedClip<_>, time: f32| -> (Vec<_>, Vec<_>) {
        (0..5000).map(|i| clip.place(time + 0.37 * i as f32)).unzip()
    };
    let ((frames, t), (frames_of_wave, s)) = (at(&walk, 0.25), at(&wave, 2.5));
    let legs = Sampled::new(NlerpLerp, walk.view(), &frames, &t)?;
    let arm = Sampled::new(NlerpLerp, wave.view(), &frames_of_wave, &s)?;
    let pose = Layered::blend(NlerpLerp, legs, arm, &waves).mask(&mask);

    // The pose, to be changed before it goes to models. Its characters are at their own origins,
    // where `f32` is finest.
    let mut locals = vec![DualQuat::IDENTITY; 5000 * JOINTS];
    rig.job().locals(pose, &mut locals)?;
    let mut models = locals.clone();
    rig.job().local_to_model(&locals, &mut models)?;
    println!("feet are up to {:.3} m in the ground", deepest(&models, &roots));
    // Feet that are in the ground go up onto it; knees are forward.
    let forward = vec![[0.0, 0.0, 1.0]; 5000];
    for leg in &LEGS {
        let onto = |(joints, root): (&[DualQuat<f32>], &DualQuat<f32>)| {
            let foot = joints[leg.joints[2]];
            let [x, _, z] = (*root * foot).translation();
            let [at_x, y, at_z] = foot.translation();
            [at_x, y.max(ground(x, z) + ANKLE - root.translation()[1]), at_z]
        };
        let targets: Vec<_> = models.chunks(JOINTS).zip(&roots).map(onto).collect();
        rig.job().two_bone(leg, &models, &targets, &forward, &mut locals)?;
    }
    rig.job().joints(rig.subtree(5)?.start..).local_to_model(&locals, &mut models)?;
    let left = deepest(&models, &roots);
    println!("and now up to {left:.6} m");
    assert!(left < 1e-4);

    let (mut scratch, mut palette) =
        (vec![DualQuat::IDENTITY; 16 * JOINTS], vec![[0.0; 12]; 5000 * JOINTS]);
    let job = rig.job().roots(&roots).matrix_order(MatrixOrder::Columns);
    job.palette(Poses(&locals), &mut scratch, &inverse_binds, &mut palette)?;
    println!("{} floats for the GPU, from {:?}", palette.as_flattened().len(), &palette[3]);
    println!("hips go {:?} a second", walk.between(NlerpLerp, 0, 0.0_f32, 1.0));
    Ok(())
}

#[test]
fn the_crowd_waves_and_stands_on_the_ground() {
    main().unwrap();
}
