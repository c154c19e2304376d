//! Forward kinematics of the biped of `examples/mocap`: 16 links and 5 end sites.

use crate::Board;
use crate::answers::{BIPED_MODELS, BIPED_OFFSETS, BIPED_PARENTS, BIPED_ROTATIONS};
use crate::error::{max_or_nan, motion_error};
use crate::table::Table;
use core::hint::black_box;
use dq8::hierarchy::{Bones, PackedClips, Sampled};
use dq8::{Block, DualQuat, Hierarchy, Quat, law::NlerpLerp};

const JOINTS: usize = BIPED_PARENTS.len();
/// Six products one after the other, each of which may lose a unit.
const BOUND: f32 = 5.0;

pub(crate) fn run<B: Board>(table: &mut Table<'_, B>) {
    let Ok(biped) = Hierarchy::new(black_box(&BIPED_PARENTS)) else {
        return table.line("biped, its parents", 0, f32::NAN, 0.0);
    };
    let rotations = BIPED_ROTATIONS.map(Quat::from_array);
    let mut motions = [DualQuat::IDENTITY; JOINTS];
    for (motion, (&rotation, &offset)) in
        motions.iter_mut().zip(rotations.iter().zip(&BIPED_OFFSETS))
    {
        *motion = DualQuat::from_rotation_translation(rotation, offset);
    }

    let locals = Bones { rotations: &rotations, offsets: &BIPED_OFFSETS };
    let mut models = [DualQuat::ZERO; JOINTS];
    let instructions = table.count(|| {
        black_box(biped.job().locals_to_model(black_box(locals), black_box(&mut models)).is_ok());
    });
    table.line("biped, rotations and offsets", instructions, worst(&models), BOUND);

    // Eight bipeds in the same pose, side by side in lanes where the board has some.
    let mut crowd = motions.map(|motion| Block::<f32, 8>::splat(motion.to_array()));

    let mut models = motions;
    let instructions = table.count(|| {
        black_box(biped.job().local_to_model_in_place(black_box(&mut models)).is_ok());
    });
    table.line("biped, motions in place", instructions, worst(&models), BOUND);

    let instructions = table.count(|| {
        black_box(biped.job().local_to_model_in_place(black_box(&mut crowd)).is_ok());
    });
    let mut error = 0.0;
    for instance in 0..8 {
        let models =
            crowd.map(|block| DualQuat::from_array(block.get(instance).unwrap_or([f32::NAN; 8])));
        error = max_or_nan(worst(&models), error);
    }
    table.line("biped, one of 8 in blocks", instructions / 8, error, BOUND);
    play(table, &biped);
}

/// A stride: 33 frames of 21 joints. `examples/mocap` makes it, and tests that it does.
static STRIDE: &[u8] = include_bytes!("stride.clips");

/// Plays the stride from flash. The error is how far rotations are from unit.
fn play<B: Board>(table: &mut Table<'_, B>, biped: &Hierarchy<'_>) {
    let mut models = [DualQuat::ZERO; JOINTS];
    let Ok(clips) = PackedClips::from_bytes(black_box(STRIDE)) else {
        return table.line("biped, its stride", 0, f32::NAN, 0.0);
    };
    let instructions = table.count(|| {
        let Some((place, t)) = clips.place(0, black_box(12.3_f32)) else { return };
        let (places, t) = ([place], [t]);
        if let Ok(sampled) = Sampled::new(NlerpLerp, clips, &places, &t) {
            black_box(biped.job().locals_to_model(sampled, black_box(&mut models)).is_ok());
        }
    });
    let off = |model: &DualQuat<f32>| {
        let [x, y, z, w] = model.rotation().to_array();
        let off = x * x + y * y + z * z + w * w - 1.0;
        (if off < 0.0 { -off } else { off }) * 8_388_608.0
    };
    let error = models.iter().fold(0.0, |worst, model| max_or_nan(off(model), worst));
    table.line("biped, played from packed clips", instructions, error, 16.0);
}

fn worst(models: &[DualQuat<f32>; JOINTS]) -> f32 {
    let pairs = models.iter().zip(&BIPED_MODELS);
    pairs.fold(0.0, |worst, (model, expected)| {
        max_or_nan(motion_error(model.to_array(), expected), worst)
    })
}
