//! Files that are broken: an error with its place, or a pose, never a panic.

use crate::args::Method;
use crate::error::guarded;
use crate::file::File;
use crate::tests::{glb, posed, strip};
use dq8_fixtures::random::Random;
use std::path::Path;

/// What is changed in the text of the strip, into what, and what the error names.
const BAD: &str = r#"
"children":[1] | "children":[0] | node 0
"joints":[0,1] | "joints":[0] | vertex 1
"bufferView":0,"count":3 | "bufferView":0,"count":4 | accessor 0
"JOINTS_0":6, |  | Joints
"skin":0 | "skin":7 | skin
"nodes":[0,2]}] | "nodes":[0]}] | no mesh
"componentType":5121 | "componentType":5120 | JOINTS_0 of type I8
"turn" | "other" | other
"interpolation":"CUBICSPLINE" | "interpolation":"LINEAR" | animation 0, channel 1
"input":3,"output":4 | "input":0,"output":4 | accessor 0
"byteOffset":36 | "byteOffset":36000 | view
"path":"scale" | "path":"size" | channel 1: its path
"node":1,"path":"scale" | "node":3,"path":"scale" | channel 1: there is no node 3
"sampler":1,"target":{"node":1,"path":"scale" | "sampler":0,"target":{"node":1,"path":"rotation" | channel 1: the rotation of node 1 is what channel 0 moves
"sampler":0,"target":{"node":1,"path":"rotation" | "sampler":1,"target":{"node":1,"path":"scale" | channel 1: the scale of node 1 is what channel 0 moves
"asset" | "asset | line"#;

#[test]
fn bad_files_get_an_error_with_its_place() {
    for row in BAD.trim().lines() {
        let [from, to, wanted] = row.split(" | ").collect::<Vec<_>>()[..] else { panic!("{row}") };
        let error = strip(&[(from, to)]).expect_err(from);
        assert!(error.contains(wanted), "{from}: {error}");
    }
    let bytes = glb(str::to_owned);
    for length in 0..bytes.len() {
        assert!(posed(&bytes[..length], 0.0, Method::Dual).is_err(), "{length} bytes");
    }
    // Any byte may be another: an error or a pose, never a panic.
    for at in 0..bytes.len() {
        for flip in [0x01, 0x80, 0xff] {
            let mut bytes = bytes.clone();
            bytes[at] ^= flip;
            let _ = tried(&bytes);
        }
    }
}

#[test]
fn a_key_of_zeros_is_named_by_its_channel() {
    let accessor = |more: &str| {
        format!(r#""componentType":5121}},{{{more}"type":"VEC4","componentType":5126}}]"#)
    };
    // Zeros behind a rotation: four numbers of accessor 5 that are zero.
    let (all, second) = (
        accessor(r#""count":2,"#),
        accessor(
            r#""count":2,"sparse":{"count":1,
        "indices":{"bufferView":6,"componentType":5121},"values":{"bufferView":4,"byteOffset":16}},"#,
        ),
    );
    for (accessor, key) in [(all, 0), (second, 1)] {
        let changes =
            [(r#""componentType":5121}]"#, accessor.as_str()), (r#""output":4"#, r#""output":7"#)];
        let wanted = format!(
            "animation 0, channel 0: key {key} is a quaternion of zeros, which is no rotation"
        );
        assert_eq!(strip(&changes).unwrap_err(), wanted);
    }
}

/// How many meshes were posed. A panic of the crate gltf is an error, but none of a panic in here.
fn tried(bytes: &[u8]) -> Result<usize, String> {
    let path = Path::new("strip.glb");
    let file = guarded(path, || File::parse(path, bytes))?;
    let worlds = file.worlds(&file.animation(None)?, 0.3)?;
    let meshes = file.meshes()?;
    for mesh in &meshes {
        mesh.pose(&worlds, Method::Mix(0.5))?;
    }
    Ok(meshes.len())
}

/// Lengths, offsets, counts, types and indices that are not what the rest of the file says.
#[test]
fn files_with_other_numbers_are_errors_or_poses() {
    let mut random = Random(1);
    let number = |json: &str, nth: usize| {
        let starts = json.match_indices(|c: char| c.is_ascii_digit()).map(|(at, _)| at);
        let at = starts.cycle().nth(nth).unwrap();
        (at, at + json[at..].find(|c: char| !c.is_ascii_digit()).unwrap())
    };
    let mut posed = 0;
    for _ in 0..5_000 {
        let others: Vec<_> =
            (0..1 + random.below(3)).map(|_| [300, 9, 200].map(|end| random.below(end))).collect();
        let bytes = glb(|json| {
            let mut json = json.to_owned();
            for &[nth, kind, other] in &others {
                let (at, end) = number(&json, nth);
                let other = match kind {
                    0 => (u64::MAX - other as u64).to_string(),
                    1 => (u32::MAX as usize - other).to_string(),
                    2 => format!("-{other}"),
                    3 => (5120 + other % 7).to_string(),
                    4 => format!("{other}.5"),
                    _ => (other % 10).to_string(),
                };
                json.replace_range(at..end, &other);
            }
            json
        });
        posed += tried(&bytes).unwrap_or(0);
    }
    assert!(posed > 0, "nothing but errors");
}

/// The crate gltf would take the lowest 32 bits.
#[test]
fn an_index_beyond_32_bits_is_an_error_that_names_it() {
    let far = 1_u64 << 40;
    let changes = [(r#""bufferView":0"#, &*format!(r#""bufferView":{far}"#))];
    let error = strip(&changes).unwrap_err();
    assert!(error.contains("bufferView: there is no number 1099511627776"), "{error}");
}
