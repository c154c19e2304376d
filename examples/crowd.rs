//! A thousand characters play one clip, each at its own time and place; the GPU gets 3×4 matrices by columns.
//!
//! ```sh
//! cargo run --release --example crowd
//! ```

use dq8::hierarchy::{Clip, Sampled};
use dq8::{DualQuat, Quat, Skeleton, hierarchy::MatrixOrder, law::NlerpLerp};
use std::error::Error;

const CHARACTERS: usize = 1000;
const FRAMES_PER_SECOND: f32 = 30.0;

/// Key frames of a leg that swings once per second: [x, y, z, w, tx, ty, tz] per joint.
fn keys(frame: u8) -> [[f32; 7]; 3] {
    let swing = 0.5 * (f32::from(frame) * core::f32::consts::TAU / FRAMES_PER_SECOND).sin();
    [(swing, 0.9), (-0.6 * swing.abs(), -0.45), (0.0, -0.45)].map(|(angle, y)| {
        let [qx, qy, qz, qw] = Quat::from_rotation_x(angle).to_array();
        [qx, qy, qz, qw, 0.0, y, 0.0]
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    // What a file holds: parents in any order, key frames [frame][joint], the mesh's rest pose.
    let (skeleton, _) = Skeleton::sorted(&[-1, 0, 1])?; // hip → knee → foot
    let keys: Vec<[f32; 7]> = (0..=30).flat_map(keys).collect();
    let clip = Clip::new(skeleton.joints(), &keys)?;
    let mut rest = [0.9, -0.45, -0.45].map(|y| DualQuat::from_translation([0.0, y, 0.0]));
    skeleton.job().local_to_model_in_place(&mut rest)?;
    let inverse_binds = rest.map(DualQuat::conjugate);

    let place = |i: usize| DualQuat::from_translation([(i % 40) as f32, 0.0, (i / 40) as f32]);
    let roots: Vec<_> = (0..CHARACTERS).map(place).collect();
    // Models of 16 instances at a time stay in the cache; nobody needs them afterwards.
    let mut scratch = vec![DualQuat::IDENTITY; 16 * skeleton.joints()];
    let mut palette = vec![[0.0; 12]; CHARACTERS * skeleton.joints()];
    for seconds in [0.0, 0.25, 0.5] {
        let at = |i: usize| (seconds + 0.37 * i as f32).fract() * FRAMES_PER_SECOND;
        let (frames, t): (Vec<_>, Vec<_>) = (0..CHARACTERS).map(|i| clip.place(at(i))).unzip();
        let locals = Sampled::new(NlerpLerp, clip, &frames, &t)?;
        let job = skeleton.job().roots(&roots).matrix_order(MatrixOrder::Columns);
        job.palette(locals, &mut scratch, &inverse_binds, &mut palette)?;
        let upload: &[f32] = palette.as_flattened();
        println!("{seconds:4} s: {} floats, from {:?}", upload.len(), &upload[..12]);
    }
    Ok(())
}

#[test]
fn the_crowd_plays() {
    main().unwrap();
}
