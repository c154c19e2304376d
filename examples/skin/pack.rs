//! An animation packed for the run time: all nodes, 30 frames a second.

use crate::file::File;
use crate::pose::Animation;
use dq8::hierarchy::{Clip, PackedClip, PackedError, Tolerance};

const RATE: f64 = 30.0;

/// The clip and what there is to say of it. Nodes that scale cannot be packed.
pub(crate) fn pack(file: &File, animation: &Animation) -> Result<(PackedClip, String), String> {
    // From the first frame to the one at or after the end.
    let count = (animation.end() * RATE).ceil() as usize + 1;
    let (mut keys, mut joints) = (Vec::new(), 0);
    for frame in 0..count {
        let locals = file.locals(animation, frame as f64 / RATE);
        joints = locals.len();
        for (node, local) in locals.iter().enumerate() {
            let (motion, stretch) = local
                .try_decompose()
                .map_err(|error| format!("node {node} in frame {frame}: {error}"))?;
            let scales =
                (0..3).any(|i| (0..3).any(|k| (stretch[i][k] - f64::from(i == k)).abs() > 1e-4));
            if scales {
                return Err(format!("node {node} scales in frame {frame}: packed clips do not"));
            }
            let ([x, y, z, w], [a, b, c]) = (motion.rotation().to_array(), motion.translation());
            keys.push([x, y, z, w, a, b, c].map(|number| number as f32));
        }
    }
    let packed = Clip::new(joints, &keys)
        .map_err(PackedError::from)
        .and_then(|clip| PackedClip::new(clip.with_rate(RATE), Tolerance::default()))
        .map_err(|error| error.to_string())?;
    let report = format!(
        "{count} frames of {joints} nodes at {RATE} a second: {} bytes packed, {} as f32\n",
        packed.as_bytes().len(),
        size_of_val(&keys[..])
    );
    Ok((packed, report))
}

#[cfg(test)]
mod tests {
    use super::pack;
    use crate::file::File;
    use crate::tests::glb;
    use std::path::Path;

    #[test]
    fn an_animation_is_packed_and_one_that_scales_is_refused_by_node() {
        let of = |change: fn(&str) -> String| {
            let file = File::parse(Path::new("strip.glb"), &glb(change)).unwrap();
            let animation = file.animation(None).unwrap();
            pack(&file, &animation).map_err(|error| error.to_string())
        };
        let (packed, report) =
            of(|json| json.replace(r#""path":"scale""#, r#""path":"translation""#)).unwrap();
        let clips = packed.clips();
        assert_eq!(
            (clips.joints(), clips.frames(0), clips.moving(0)),
            (3, Some(31), Some(2)),
            "{report}"
        );
        let error = of(str::to_owned).unwrap_err();
        assert!(error.contains("node 1 scales in frame 1"), "{error}");
    }
}
