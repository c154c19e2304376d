//! Programs with a mistake each. A comment `SAYS` above one has what the compiler must say of it,
//! on a line each.
#![cfg(mistakes)]
#![allow(missing_docs)]

use dq8::hierarchy::{Layered, PackedClips, Poses, RotationsTranslations, Sampled};
use dq8::law::{Nlerp, NlerpLerp};
use dq8::representation::RotationTranslation;
use dq8::{Backend, Crowd, DualQuat, Hierarchy};

struct Mine;

/// SAYS: are no poses of 7 numbers each
/// SAYS: poses of 7 numbers and of 8 do not mix
pub fn layers_of_seven_and_of_eight_numbers(
    hierarchy: Hierarchy<'_>,
    seven: &[RotationTranslation<f32>],
    eight: &[DualQuat<f32>],
    models: &mut [DualQuat<f32>],
) {
    let mixed = Layered::blend(NlerpLerp, RotationsTranslations(seven), Poses(eight), &[0.5]);
    let _ = hierarchy.job().locals_to_model(mixed, models);
}

/// SAYS: `PackedClips<'_>` are no keys of 8 numbers of `f32` for each joint
/// SAYS: the law `NlerpLerp` plays them
pub fn packed_clips_by_another_law(clips: PackedClips<'_>) {
    let _ = Sampled::new(Nlerp, clips, &[clips.place(0, 0.5).0], &[0.5_f32]);
}

/// SAYS: `[f32; 6]` is no row of a block
/// SAYS: a row has 4, 8 or 16 numbers of `f32`, or 2, 4 or 8 of `f64`
pub fn blocks_of_six(steps: &[DualQuat<f32>]) {
    let _ = Crowd::<f32, 6>::from_slice(2, steps);
}

/// SAYS: `Mine` is not known to dq8 as a thing of 8 numbers
pub fn other_things(a: &[Mine], c: &mut [Mine]) {
    let _ = Backend::best().mul(a, a, c);
}

/// SAYS: are no locals for models of
/// SAYS: `Poses(&motions)`, `RotationsTranslations(&seven_numbers)`
pub fn bare_slices(
    hierarchy: Hierarchy<'_>,
    locals: &[DualQuat<f32>],
    models: &mut [DualQuat<f32>],
) {
    let _ = hierarchy.job().locals_to_model(locals, models);
}

/// SAYS: `[[f64; 3]; 3]` is no entry of a palette
pub fn palettes_of_rotations(
    hierarchy: Hierarchy<'_>,
    locals: &[DualQuat<f64>],
    palette: &mut [[[f64; 3]; 3]],
) {
    let _ = hierarchy.job().palette(Poses(locals), &mut [DualQuat::IDENTITY], locals, palette);
}
