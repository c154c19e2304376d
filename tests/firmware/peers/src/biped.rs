use crate::contender::{Contender, Micromath};
use core::hint::black_box;
use dq8::{DualQuat, Hierarchy};
use dq8_firmware_jobs::answers::{BIPED_MODELS, BIPED_OFFSETS, BIPED_PARENTS, BIPED_ROTATIONS};
use dq8_firmware_jobs::error::{error, max_or_nan};
use dq8_firmware_jobs::{Board, Table};
use nalgebra::Isometry3;

const JOINTS: usize = BIPED_PARENTS.len();
const BOUND: f32 = 6.0;

pub(crate) fn run<B: Board>(table: &mut Table<'_, B>) {
    let mut models = locals::<DualQuat<f32>>();
    let parents = BIPED_PARENTS;
    let Ok(biped) = Hierarchy::new(black_box(&parents)) else { return };
    let cost = table.count(|| _ = biped.job().local_to_model_in_place(black_box(&mut models)));
    table.line("biped, dq8, Hierarchy", cost, worst(&models), BOUND);
    one::<DualQuat<f32>, B>(table);
    one::<Isometry3<f32>, B>(table);
    one::<Micromath, B>(table);
}

/// The loop that one writes without a crate for hierarchies.
#[inline(never)]
fn forward<C: Contender>(parents: &[u32], poses: &mut [C]) {
    for joint in 0..poses.len() {
        if let Some(&parent) = parents.get(joint)
            && let Some(&parent) = poses.get(parent as usize)
        {
            poses[joint] = parent * poses[joint];
        }
    }
}

fn locals<C: Contender>() -> [C; JOINTS] {
    core::array::from_fn(|joint| C::new(BIPED_ROTATIONS[joint], BIPED_OFFSETS[joint]))
}

fn one<C: Contender, B: Board>(table: &mut Table<'_, B>) {
    let mut poses = locals::<C>();
    let cost = table.count(|| forward(black_box(&BIPED_PARENTS), black_box(&mut poses)));
    table.line(C::NAMES.biped, cost, worst(&poses), BOUND);
}

fn worst<C: Contender>(models: &[C; JOINTS]) -> f32 {
    let pairs = models.iter().zip(BIPED_MODELS);
    pairs.fold(0.0, |worst, (model, expected)| {
        let expected = DualQuat::from_array(expected).translation();
        max_or_nan(error(&model.translation(), &expected), worst)
    })
}
