//! 5,000 characters walk, each at its own time, and wave with the arm alone; the GPU gets 3×4 matrices by columns.
//!
//! ```sh
//! cargo run --release --example crowd
//! ```

use dq8::hierarchy::{Layered, MatrixOrder, OwnedClip, Sampled};
use dq8::{DualQuat, Quat, Skeleton, law::NlerpLerp, representation::RotationTranslation};

/// A second of the body's two joints and the arm's three, each turning to and fro by these angles.
fn clip(angles: [f32; 5]) -> Result<OwnedClip<RotationTranslation<f32>>, dq8::ShapeError> {
    let key = |i: u8| {
        let swing = (f32::from(i / 5) * core::f32::consts::TAU / 30.0).sin();
        let rotation = Quat::from_rotation_x(angles[usize::from(i % 5)] * swing);
        RotationTranslation { rotation, translation: [0.0, 0.3, 0.0] }
    };
    Ok(OwnedClip::new(5, (0..31 * 5).map(key).collect::<Vec<_>>())?.with_rate(30.0).looping())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rig = Skeleton::new(&[-1, 0, 1, 2, 1])?; // hip → spine → shoulder → hand, spine → head
    let (walk, wave) = (clip([0.1, 0.2, 0.5, 0.3, 0.0])?, clip([0.0, 0.0, 1.5, 0.8, 0.0])?);
    let mut mask = [0.0; 5];
    mask[rig.subtree(2)?].fill(1.0);
    let mut rest = [DualQuat::from_translation([0.0_f32, 0.3, 0.0]); 5];
    rig.job().local_to_model_in_place(&mut rest)?;
    let inverse_binds = rest.map(DualQuat::conjugate);
    let roots: Vec<_> = (0..5000)
        .map(|i| DualQuat::from_translation([(i % 70) as f32, 0.0, (i / 70) as f32]))
        .collect();
    let waves: Vec<_> = (0..5000).map(|i| f32::from(i % 3 == 0)).collect(); // every third one
    let (mut scratch, mut palette) = (vec![DualQuat::IDENTITY; 16 * 5], vec![[0.0; 12]; 5000 * 5]);
    let at = |clip: &OwnedClip<_>, time: f32| -> (Vec<_>, Vec<_>) {
        (0..5000).map(|i| clip.place(time + 0.37 * i as f32)).unzip()
    };
    let ((frames, t), (frames_of_wave, s)) = (at(&walk, 0.25), at(&wave, 2.5));
    let legs = Sampled::new(NlerpLerp, walk.view(), &frames, &t)?;
    let arm = Sampled::new(NlerpLerp, wave.view(), &frames_of_wave, &s)?;
    let pose = Layered::blend(NlerpLerp, legs, arm, &waves).mask(&mask);
    let job = rig.job().roots(&roots).matrix_order(MatrixOrder::Columns);
    job.palette(pose, &mut scratch, &inverse_binds, &mut palette)?;
    println!("{} floats for the GPU, from {:?}", palette.as_flattened().len(), &palette[3]);
    // One that is looked at: its pose, to be changed by hand before it goes to models.
    let (place, mut locals) = ([frames[7]], [DualQuat::IDENTITY; 5]);
    rig.job().locals(Sampled::new(NlerpLerp, walk.view(), &place, &t[7..8])?, &mut locals)?;
    println!("its hips go {:?} a second", walk.between(NlerpLerp, 0, 0.0_f32, 1.0));
    Ok(())
}

#[test]
fn the_crowd_waves() {
    main().unwrap();
}
