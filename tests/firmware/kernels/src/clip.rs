//! Packed clips, from flash.

use dq8::hierarchy::{PackedClips, Sampled};
use dq8::law::NlerpLerp;
use dq8::{DualQuat, Hierarchy};

/// Checks clips and parents, and takes every joint to the model, at a time in frames.
#[unsafe(no_mangle)]
fn clip_play(bytes: &[u8], at: f32, parents: &[u32], models: &mut [DualQuat<f32>]) -> bool {
    let Ok(clips) = PackedClips::from_bytes(bytes) else { return false };
    let Some((place, t)) = clips.place(0, at) else { return false };
    let (places, t) = ([place], [t]);
    let Ok(sampled) = Sampled::new(NlerpLerp, clips, &places, &t) else { return false };
    Hierarchy::new(parents)
        .is_ok_and(|hierarchy| hierarchy.job().locals_to_model(sampled, models).is_ok())
}
