use crate::accessor::number;
use crate::args::Method;
use crate::bones::{IDENTITY, affine};
use crate::file::File;
use crate::{obj, tube, uri};
use gltf::Glb;
use gltf::accessor::DataType;
use gltf::binary::Header;
use std::path::Path;

/// What the text of the strip says before its buffer.
const SCENE: &str = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,2]}],
"nodes":[{"children":[1],"translation":[0,0,5]},{"translation":[0,1,0]},{"mesh":0,"skin":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":6,"WEIGHTS_0":1}}]}],
"skins":[{"joints":[0,1],"inverseBindMatrices":2}],
"animations":[{"name":"turn","channels":[
{"sampler":0,"target":{"node":1,"path":"rotation"}},
{"sampler":1,"target":{"node":1,"path":"scale"}}],
"samplers":[{"input":3,"output":4},{"input":3,"output":5,"interpolation":"CUBICSPLINE"}]}],"#;

/// What it says behind the views of that.
const ACCESSORS: &str = r#""accessors":[{"bufferView":0,"count":3,"type":"VEC3","componentType":5126,"min":[0,0,0],"max":[1,2,0]},
{"bufferView":1,"count":3,"type":"VEC4","componentType":5126},
{"bufferView":2,"count":2,"type":"MAT4","componentType":5126},
{"bufferView":3,"count":2,"type":"SCALAR","componentType":5126,"min":[0],"max":[1]},
{"bufferView":4,"count":2,"type":"VEC4","componentType":5126},
{"bufferView":5,"count":6,"type":"VEC3","componentType":5126},
{"bufferView":6,"count":3,"type":"VEC4","componentType":5121}]}"#;

/// A strip of two vertices per joint, built by hand: joint 1 lies one up from joint 0, and turns by
/// 90° about z and doubles its width from 0 s to 1 s.
pub(crate) fn glb(change: impl Fn(&str) -> String) -> Vec<u8> {
    let half = core::f32::consts::FRAC_1_SQRT_2;
    // Columns: joint 1 is at y = 1 at rest.
    let mut binds = [IDENTITY; 2].map(|columns| columns.map(|column| column.map(|c| c as f32)));
    binds[1][3][1] = -1.0;
    // Positions, weights, inverse binds, times, turns, and scales: a spline of tangents and values.
    let floats: [&[f32]; 6] = [
        &[0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 2.0, 0.0],
        &[1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
        binds.as_flattened().as_flattened(),
        &[0.0, 1.0],
        &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, half, half],
        &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 1.0, 1.0, 0.0, 0.0, 0.0],
    ];
    let bytes = floats.map(|all| all.iter().flat_map(|number| number.to_le_bytes()).collect());
    let joints: Vec<u8> = vec![0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0];
    let (mut bin, mut views) = (Vec::new(), Vec::new());
    for bytes in bytes.into_iter().chain([joints]) {
        let (at, length) = (bin.len(), bytes.len());
        views.push(format!(r#"{{"buffer":0,"byteOffset":{at},"byteLength":{length}}}"#));
        bin.extend(bytes);
    }
    let (length, views) = (bin.len(), views.join(","));
    let buffer = format!(r#""buffers":[{{"byteLength":{length}}}],"bufferViews":[{views}],"#);
    let json = change(&[SCENE, &buffer, ACCESSORS].concat()).into_bytes().into();
    // The length is written as it is.
    let header = Header { magic: *b"glTF", version: 2, length: 0 };
    Glb { header, json, bin: Some(bin.into()) }.to_vec().unwrap()
}

pub(crate) fn posed(bytes: &[u8], time: f64, method: Method) -> Result<Vec<[f64; 3]>, String> {
    let file = File::parse(Path::new("strip.glb"), bytes)?;
    let animation = file.animation(Some("turn"))?;
    let worlds = file.worlds(&animation, time)?;
    let meshes = file.meshes()?;
    assert_eq!(meshes.len(), 1);
    let posed = meshes[0].pose(&worlds, method)?;
    let text = obj::text(time, &meshes, std::slice::from_ref(&posed));
    assert_eq!(text.lines().filter(|line| line.starts_with("v ")).count(), 3);
    assert!(text.ends_with("f 1 2 3\n"), "{text}");
    Ok(posed)
}

/// The strip at half a second, with some of its text changed.
pub(crate) fn strip(changes: &[(&str, &str)]) -> Result<Vec<[f64; 3]>, String> {
    let change = |json: &str| {
        changes.iter().fold(json.to_owned(), |json, (from, to)| {
            assert!(json.contains(from), "{from}");
            json.replacen(from, to, 1)
        })
    };
    posed(&glb(change), 0.5, Method::Dual)
}

fn close(a: &[[f64; 3]], b: &[[f64; 3]]) -> bool {
    a.iter().flatten().zip(b.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-6)
}

#[test]
fn a_strip_is_posed_as_by_hand() {
    let bytes = glb(str::to_owned);
    let rest = [[0.0, 0.0, 5.0], [0.0, 1.0, 5.0], [1.0, 2.0, 5.0]];
    for method in [Method::Linear, Method::Dual, Method::Mix(0.5)] {
        let got = posed(&bytes, 0.0, method).unwrap();
        assert!(close(&got, &rest), "{method:?}: {got:?}");
        // Vertex 2 belongs to joint 1: (1, 1) from it is (2, 1) scaled and (−1, 2) turned.
        let got = posed(&bytes, 1.0, method).unwrap();
        assert!(close(&got[..1], &rest[..1]) && close(&got[2..], &[[-1.0, 3.0, 5.0]]), "{got:?}");
        assert_eq!(got, posed(&bytes, 7.0, method).unwrap());
    }
    // Half the time: 45°, and half of a spline without slope, 1.5.
    let got = posed(&bytes, 0.5, Method::Dual).unwrap();
    let half = core::f64::consts::FRAC_1_SQRT_2;
    assert!(close(&got[2..], &[[0.5 * half, 1.0 + 2.5 * half, 5.0]]), "{got:?}");
}

/// Vertex 1 has the weights 0, 0, √½, √½, all of joint 0; vertex 2 those of the file.
#[test]
fn weights_that_do_not_sum_to_one_are_said_and_divided_by_their_sum_if_asked() {
    let read = |change: &str| {
        let bytes = glb(|json| json.replace(r#""bufferView":1,"count":3,"#, change));
        let file = File::parse(Path::new("strip.glb"), &bytes).unwrap();
        let worlds = file.worlds(&file.animation(None).unwrap(), 0.0).unwrap();
        (file.meshes().unwrap().remove(0), worlds)
    };
    let (whole, _) = read(r#""bufferView":1,"count":3,"#);
    assert_eq!(whole.unbalanced(), None);
    let (mut mesh, worlds) = read(
        r#""bufferView":1,"count":3,"sparse":{"count":1,"indices":{"bufferView":6,"byteOffset":5,"componentType":5121},
        "values":{"bufferView":4,"byteOffset":16}},"#,
    );
    let said = "mesh 0, primitive 0: the weights of 1 vertex do not sum to 1; those of vertex 1 sum to 1.4142135, \
                which is farthest off (--normalize divides by the sum)";
    assert_eq!(mesh.unbalanced().as_deref(), Some(said));
    let root = core::f64::consts::SQRT_2;
    let large = [[0.0, 0.0, 5.0], [0.0, root, 5.0 * root], [1.0, 2.0, 5.0]];
    assert!(close(&mesh.pose(&worlds, Method::Linear).unwrap(), &large));
    mesh.normalize();
    assert_eq!(mesh.unbalanced(), None);
    for method in [Method::Linear, Method::Dual] {
        let got = mesh.pose(&worlds, method).unwrap();
        assert!(close(&got, &[[0.0, 0.0, 5.0], [0.0, 1.0, 5.0], [1.0, 2.0, 5.0]]), "{got:?}");
    }
}

#[test]
fn a_skinned_mesh_ignores_its_own_node_and_another_follows_it() {
    let rest = posed(&glb(str::to_owned), 0.5, Method::Dual).unwrap();
    let moved = r#""mesh":0,"translation":[0,7,0]"#;
    let skinned = glb(|json| json.replace(r#""mesh":0"#, moved));
    assert_eq!(posed(&skinned, 0.5, Method::Dual).unwrap(), rest);
    let alone = glb(|json| json.replace(r#""mesh":0,"skin":0"#, moved));
    let wanted = [[0.0, 7.0, 0.0], [0.0, 8.0, 0.0], [1.0, 9.0, 0.0]];
    for method in [Method::Linear, Method::Dual, Method::Mix(0.5)] {
        assert!(close(&posed(&alone, 0.5, method).unwrap(), &wanted));
    }
}

#[test]
fn rounding_in_last_rows_is_no_reason_to_refuse() {
    let rest = posed(&glb(str::to_owned), 0.5, Method::Dual).unwrap();
    let matrix = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,5,0.999999";
    let node = format!(r#""matrix":[{matrix}]"#);
    let rounded = glb(|json| json.replace(r#""translation":[0,0,5]"#, &node));
    assert!(close(&posed(&rounded, 0.5, Method::Dual).unwrap(), &rest));
}

#[test]
fn uris_hold_bytes_or_name_files_with_percent_signs() {
    let of = Path::new("some/strip.gltf");
    assert_eq!(uri::file("a%20b%c3%BC.bin", of).unwrap(), Path::new("some/a bü.bin"));
    for broken in ["a%2", "a%", "%zz", "%ff", "https://a/b.bin"] {
        assert!(uri::file(broken, of).is_err(), "{broken}");
    }
    for text in
        ["data:application/octet-stream;base64,AAH/", "data:;base64,AAH/", "data:,%00%01%fF"]
    {
        assert_eq!(uri::data(text).unwrap().unwrap(), [0, 1, 255]);
    }
    // Each length modulo three, and the two letters that are neither letters nor digits (RFC 4648,
    // §10 and §4).
    for (text, bytes) in [
        ("", ""),
        ("Zg==", "f"),
        ("Zm8=", "fo"),
        ("Zm9v", "foo"),
        ("Zm9vYg==", "foob"),
        ("Zm9vYmE=", "fooba"),
        ("Zm9vYmFy", "foobar"),
        ("Pj4/Pz8+fn4=", ">>???>~~"),
        ("MDEyMzQ1Njc4OWF6QVo", "0123456789azAZ"),
    ] {
        let read = uri::data(&format!("data:;base64,{text}")).unwrap();
        assert_eq!(read.unwrap(), bytes.as_bytes(), "{text}");
    }
    assert_eq!(uri::data("data:;base64,+/+/").unwrap().unwrap(), [0xfb, 0xff, 0xbf]);
    for broken in ["data:;base64,%", "data:;base64,A-_A", "data:", "data:;base64", "data:,%0"] {
        assert!(uri::data(broken).unwrap().is_err(), "{broken}");
    }
    assert!(uri::data("a.bin").is_none());
}

#[test]
fn last_rows_that_are_not_0_0_0_1_are_refused() {
    for (column, number) in
        [(0, f64::NAN), (3, f64::NAN), (1, f64::INFINITY), (2, 2e-5), (3, 0.0), (3, 1.0 + 2e-5)]
    {
        let mut columns = IDENTITY;
        columns[column][3] = number;
        assert!(affine(columns).is_err(), "{number} in column {column}");
        columns[column][3] = IDENTITY[column][3] - 5e-6;
        assert_eq!(affine(columns).unwrap(), IDENTITY);
    }
}

#[test]
fn meshes_of_the_scene_are_posed_and_no_others() {
    let count = |change: &dyn Fn(&str) -> String| {
        let meshes = File::parse(Path::new("strip.glb"), &glb(change)).unwrap().meshes();
        meshes.map_or(0, |meshes| meshes.len())
    };
    let scenes = r#""scene":0,"scenes":[{"nodes":[0,2]}]"#;
    for (to, wanted) in [
        (scenes, 1),
        (r#""scenes":[{"nodes":[2]},{"nodes":[0]}]"#, 1),
        (r#""scenes":[{"nodes":[0]},{"nodes":[2]}]"#, 0),
        (r#""scene":1,"scenes":[{"nodes":[0]},{"nodes":[2]}]"#, 1),
        (r#""scene":0,"scenes":[{"nodes":[0]},{"nodes":[2]}]"#, 0),
        // Without scenes all nodes are to be seen.
        (r#""scenes":[]"#, 1),
    ] {
        assert_eq!(count(&|json| json.replace(scenes, to)), wanted, "{to}");
    }
    // A mesh below a node of the scene, two levels down.
    let below = |json: &str| {
        json.replace(r#""nodes":[0,2]}"#, r#""nodes":[0]}"#)
            .replace(r#"{"translation":[0,1,0]}"#, r#"{"translation":[0,1,0],"children":[2]}"#)
    };
    assert_eq!(count(&below), 1);
}

#[test]
fn integers_are_read_as_they_are_and_normalized_by_the_largest() {
    let bytes = [0x81_u8, 0x80, 0x7f, 0x40];
    let two = |low: usize| [bytes[low], bytes[low + 1]];
    for (data, wanted, normalized) in [
        (DataType::I8, -127.0, -1.0),
        (DataType::U8, 129.0, 129.0 / 255.0),
        (DataType::I16, f64::from(i16::from_le_bytes(two(0))), -32639.0 / 32767.0),
        (DataType::U16, f64::from(u16::from_le_bytes(two(0))), 32897.0 / 65535.0),
    ] {
        assert_eq!(number(&bytes, data, false), wanted, "{data:?}");
        assert_eq!(number(&bytes, data, true), normalized, "{data:?}");
    }
    // The least integers are −1 too, and the greatest 1 (glTF 2.0, §3.11).
    assert_eq!(number(&bytes[1..], DataType::I8, true), -1.0);
    assert_eq!(number(&bytes[2..], DataType::I8, true), 1.0);
    assert_eq!(number(&i16::MIN.to_le_bytes(), DataType::I16, true), -1.0);
    assert_eq!(number(&i16::MAX.to_le_bytes(), DataType::I16, true), 1.0);
}

#[test]
fn positions_of_signed_integers_pose_as_numbers() {
    let required = r#""extensionsRequired":["KHR_mesh_quantization"],"scene":0"#;
    let floats = r#""bufferView":0,"count":3,"type":"VEC3","componentType":5126"#;
    // (0, 0, 0), (0, 1, 0) and (−1, −2, 0), each with a number of padding.
    let numbers = [0, 0, 0, 0, 0, 1, 0, 0, -1, -2, 0, 0_i16];
    for (kind, width) in [(5120, 1), (5122, 2)] {
        let bytes = numbers.iter().flat_map(|number| number.to_le_bytes().into_iter().take(width));
        let text: String = bytes.map(|byte| format!("%{byte:02x}")).collect();
        let (length, stride) = (12 * width, 4 * width);
        let buffer = format!(r#",{{"uri":"data:,{text}","byteLength":{length}}}],"bufferViews":"#);
        let view =
            format!(r#",{{"buffer":1,"byteLength":{length},"byteStride":{stride}}}],"accessors":"#);
        let small = format!(r#""bufferView":7,"count":3,"type":"VEC3","componentType":{kind}"#);
        let bytes = glb(|json| {
            let json = json.replace(r#""scene":0"#, required).replace(floats, &small);
            json.replace(r#"],"bufferViews":"#, &buffer).replace(r#"],"accessors":"#, &view)
        });
        let got = posed(&bytes, 0.0, Method::Dual).unwrap();
        assert!(close(&got, &[[0.0, 0.0, 5.0], [0.0, 1.0, 5.0], [-1.0, -2.0, 5.0]]), "{got:?}");
    }
}

#[test]
fn what_would_be_posed_wrongly_is_refused_by_mesh_and_primitive() {
    let required = |name: &str| format!(r#""extensionsRequired":["{name}"],"scene":0"#);
    let end = r#""WEIGHTS_0":1}}]"#;
    let with = |more: &str| format!(r#""WEIGHTS_0":1}},{more}}}]"#);

    let weights = r#"}],"weights":[0,0.5]}],"skins""#;
    let weights = (
        r#"}]}],
"skins""#,
        weights,
    );
    let morphs = strip(&[(end, &with(r#""targets":[{"NORMAL":0},{"POSITION":0}]"#)), weights]);
    assert_eq!(morphs.unwrap_err(), "mesh 0, primitive 0: morph targets are not done here");
    // Normals are not posed at all.
    assert!(strip(&[(end, &with(r#""targets":[{"NORMAL":0},{"NORMAL":0}]"#)), weights]).is_ok());

    let draco =
        with(r#""extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{}}}"#);
    let unread = (r#""bufferView":0,"count":3"#, r#""count":3"#);
    let scene = required("KHR_draco_mesh_compression");
    for required in [scene.as_str(), r#""scene":0"#] {
        let refused = strip(&[(r#""scene":0"#, required), (end, &draco), unread]).unwrap_err();
        assert!(refused.starts_with("mesh 0, primitive 0: KHR_draco"), "{refused}");
    }
    // The plain numbers are there too.
    assert!(strip(&[(end, &draco)]).is_ok());

    for name in ["EXT_meshopt_compression", "KHR_meshopt_compression"] {
        let view = r#"{"buffer":0,"byteOffset":0,"#;
        let packed = format!(r#"{view}"extensions":{{"{name}":{{"buffer":0}}}},"#);
        let packed = (view, packed.as_str());
        let refused = strip(&[(r#""scene":0"#, &required(name)), packed]).unwrap_err();
        assert!(refused.starts_with(&format!("mesh 0, primitive 0: {name}")), "{refused}");
        assert!(strip(&[packed]).is_ok());
    }

    let node = (r#""mesh":0"#, r#""mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{}}"#);
    let refused = strip(&[node]).unwrap_err();
    assert!(refused.starts_with("node 2, mesh 0: EXT_mesh_gpu"), "{refused}");
    // Another extension that a file cannot do without is refused by name.
    let refused = strip(&[(r#""scene":0"#, &required("KHR_other"))]).unwrap_err();
    assert_eq!(refused, "extensionsRequired: KHR_other is not done here");
}

#[test]
fn the_tube_collapses_bulges_and_keeps() {
    let (_, linear, _) = tube::measured(tube::twist(), 0.0).unwrap();
    let (_, dual, length) = tube::measured(tube::twist(), 1.0).unwrap();
    assert!(linear < 0.75 && (dual - 1.0).abs() < 0.02, "{linear} {dual}");
    assert!((length - 1.0).abs() < 1e-9);
    let (_, bent_linear, _) = tube::measured(tube::bend(), 0.0).unwrap();
    let (_, bent_dual, _) = tube::measured(tube::bend(), 1.0).unwrap();
    let (_, mix, _) = tube::measured(tube::bend(), 0.5).unwrap();
    assert!(bent_linear < mix && mix < bent_dual, "{bent_linear} {mix} {bent_dual}");
    let (_, svg) = tube::report().unwrap();
    assert!(svg.matches("<text").count() == 12 && svg.ends_with("</svg>\n"));
}
