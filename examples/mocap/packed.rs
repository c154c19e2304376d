//! The clip packed: a quarter of the memory, and what became of it.

use dq8::hierarchy::{Clip as Frames, PackedClip, PackedError, Sampled, Tolerance};
use dq8::{DualQuat, Hierarchy, law::NlerpLerp};
use dq8_bvh::Clip;
use std::error::Error;

/// The bytes, and what there is to say of them; `size` is that of the skeleton.
pub(crate) fn pack(clip: &Clip, size: f64) -> Result<(Vec<u8>, String), Box<dyn Error>> {
    let (parents, joints) = (clip.parents(), clip.joints.len());
    let hierarchy = Hierarchy::new(&parents)?;
    let keys: Vec<[f32; 7]> = clip.locals().iter().map(key).collect();
    // A hundredth of a millimetre of a man.
    let tolerance = Tolerance { length: (6e-6 * size) as f32, ..Tolerance::default() };
    let frames = Frames::new(joints, &keys)?.with_rate(clip.frame_time.recip());
    let packed = PackedClip::new(frames, tolerance)?;
    let (bytes, moving) = (packed.as_bytes(), packed.clips().moving(0).unwrap_or(0));
    let mut text = format!(
        "  packed      {:.1} KB of {:.1}, {moving} of {} tracks move\n",
        bytes.len() as f64 / 1e3,
        size_of_val(&keys[..]) as f64 / 1e3,
        2 * joints
    );
    for (name, distance) in [("3 %", 0.03 * size), ("100 %", size)] {
        let off = packed.deviation(&hierarchy, 0, &keys, distance)?;
        let [worst, p99] = [off.worst, off.p99].map(|off| off / size);
        text += &format!(
            "              {worst:.1e} of the size at most, {p99:.1e} of 99 in 100, {name} of it from a joint\n"
        );
    }
    text +=
        &format!("  played      the last joint half way at {:?}\n", half_way(&hierarchy, bytes)?);
    Ok((bytes.to_vec(), text))
}

/// Where the last joint is in the middle of the clip, played from its bytes.
fn half_way(hierarchy: &Hierarchy<'_>, bytes: &[u8]) -> Result<[f32; 3], Box<dyn Error>> {
    let packed = PackedClip::from_bytes(bytes.into())?;
    let clips = packed.clips();
    let middle = clips.duration(0).unwrap_or(0.0) as f32 / 2.0;
    let (places, t): (Vec<_>, Vec<_>) = clips.place(0, middle).into_iter().unzip();
    let mut models = vec![DualQuat::<f32>::IDENTITY; clips.joints()];
    let sampled = Sampled::new(NlerpLerp, clips, &places, &t)?;
    hierarchy.job().locals_to_model(sampled, &mut models)?;
    models.last().map(|model| model.translation()).ok_or_else(|| PackedError::TooLarge.into())
}

fn key(local: &DualQuat<f64>) -> [f32; 7] {
    let ([x, y, z, w], [a, b, c]) = (local.rotation().to_array(), local.translation());
    [x, y, z, w, a, b, c].map(|number| number as f32)
}

#[cfg(test)]
mod tests {
    use super::{key, pack};
    use crate::biped;
    use dq8::Hierarchy;
    use dq8::hierarchy::{Clip, PackedClip, Tolerance};

    /// What the firmware of `tests/firmware` plays: a stride of the biped at 30 frames a second.
    #[test]
    fn the_clip_of_the_firmware_is_a_stride_of_the_biped() {
        let (clip, kept) =
            (biped::clip(), include_bytes!("../../tests/firmware/jobs/src/stride.clips"));
        let joints = clip.joints.len();
        let every_other = |(frame, pose): (usize, _)| (frame % 2 == 0).then_some(pose);
        let locals = clip.locals();
        let frames = locals.chunks(joints).take(65).enumerate().filter_map(every_other);
        let keys: Vec<_> = frames.flatten().map(key).collect();
        let stride = Clip::new(joints, &keys).unwrap();
        let packed = PackedClip::new(stride, Tolerance::default()).unwrap();
        if std::env::var_os("DQ8_WRITE_STRIDE").is_some() {
            std::fs::write("../../tests/firmware/jobs/src/stride.clips", packed.as_bytes())
                .unwrap();
        }
        // Other machines round angles otherwise, so that bytes may differ, and the motion may not.
        let parents = clip.parents();
        let hierarchy = Hierarchy::new(&parents).unwrap();
        let worst =
            |packed: &PackedClip| packed.deviation(&hierarchy, 0, &keys, 1.0).unwrap().worst;
        let kept = PackedClip::from_bytes(kept.to_vec().into()).unwrap();
        let shape = |packed: &PackedClip| {
            let clips = packed.clips();
            (clips.clips(), clips.joints(), clips.frames(0), clips.duration(0), clips.loops(0))
        };
        assert_eq!(shape(&kept), shape(&packed), "DQ8_WRITE_STRIDE=1 writes it");
        let (kept, most) = (worst(&kept), 1.01 * worst(&packed));
        assert!(kept <= most, "{kept} of {most}: DQ8_WRITE_STRIDE=1 writes it");
    }

    #[test]
    fn the_biped_keeps_a_quarter_of_its_bytes_and_its_shape() {
        let (bytes, text) = pack(&biped::clip(), 1.0).unwrap();
        assert!(bytes.len() < 150_528 / 3, "{}", bytes.len());
        assert!(text.contains("of 150.5, "), "{text}");
        // Metres: 0.015 cm at 3 cm, 0.035 cm at 100 cm.
        let figures: Vec<f64> = text
            .lines()
            .filter_map(|line| line.trim().split_once(" of the size")?.0.parse().ok())
            .collect();
        assert!(figures.len() == 2 && figures[0] < 1.5e-4 && figures[1] < 3.5e-4, "{text}");
    }
}
