//! What moves no vertex is no reason to refuse a file.

use crate::file::File;
use crate::tests::strip;
use std::path::Path;

fn same(changes: &[(&str, &str)]) {
    let got = strip(changes).unwrap_or_else(|error| panic!("{changes:?}: {error}"));
    assert_eq!(got, strip(&[]).unwrap(), "{changes:?}");
}

const ATTRIBUTES: &str = r#""WEIGHTS_0":1}"#;
const PRIMITIVE: &str = r#""WEIGHTS_0":1}}]"#;
const ASSET: &str = r#""asset":{"version":"2.0"}"#;
const CHANNELS: &str = r#""channels":["#;
const MESH_END: &str = "}]}],\n\"skins\"";

#[test]
fn attributes_of_applications_are_ignored() {
    let names = "_HEAT _FEATURE_ID_0 _feature_id_1 FEATURE_ID_0 NORMAL TEXCOORD_0 COLOR_0 BATCHID";
    for name in names.split(' ') {
        same(&[(ATTRIBUTES, &format!(r#""{name}":2,"{name}_0":2,"WEIGHTS_0":1}}"#))]);
        // Not even their accessors must be there.
        same(&[(ATTRIBUTES, &format!(r#""{name}":99,"WEIGHTS_0":1}}"#))]);
    }
}

#[test]
fn extras_are_of_any_type_and_anywhere() {
    for extras in [r#""text""#, "3", "null", "[1,{\"extras\":2}]", "true", r#"{"a":{"b":[]}}"#] {
        let extras = format!(r#""extras":{extras}"#);
        same(&[
            (ASSET, &format!(r#"{extras},"asset":{{"version":"2.0",{extras}}}"#)),
            (CHANNELS, &format!(r#"{extras},"channels":["#)),
            (
                r#"{"node":1,"path":"rotation""#,
                &format!(r#"{{{extras},"node":1,"path":"rotation""#),
            ),
            (PRIMITIVE, &format!(r#""WEIGHTS_0":1}},{extras}}}],{extras}"#)),
            (r#"{"joints""#, &format!(r#"{{{extras},"joints""#)),
            (r#""translation":[0,0,5]"#, &format!(r#""translation":[0,0,5],{extras}"#)),
            (r#""accessors":[{"#, &format!(r#""accessors":[{{{extras},"#)),
            (r#""bufferViews":[{"#, &format!(r#""bufferViews":[{{{extras},"#)),
            (r#""scenes":[{"#, &format!(r#""scenes":[{{{extras},"#)),
        ]);
    }
}

#[test]
fn channels_that_move_no_joint_are_ignored_and_the_others_keep_their_numbers() {
    let channels = [
        r#"{"sampler":0,"target":{"path":"rotation"}}"#,
        r#"{"sampler":1,"target":{"path":"weights"}}"#,
        r#"{"sampler":0,"target":{"path":"pointer","extensions":{"KHR_animation_pointer":{"pointer":"/materials/0"}}}}"#,
        r#"{"sampler":0,"target":{"node":1,"path":"pointer"}}"#,
        r#"{"sampler":0,"target":{"path":"unknown"}}"#,
        r#"{"sampler":1,"target":{"node":2,"path":"weights"}}"#,
    ];
    for channel in channels {
        same(&[(CHANNELS, &format!(r#""channels":[{channel},"#))]);
        let error = strip(&[
            (CHANNELS, &format!(r#""channels":[{channel},"#)),
            (r#""path":"scale""#, r#""path":"size""#),
        ]);
        let error = error.unwrap_err();
        assert!(error.contains("animation 0, channel 2: its path is unknown"), "{error}");
    }
    same(&[(CHANNELS, &format!(r#""channels":[{},"#, channels.join(",")))]);
}

#[test]
fn extensions_that_move_no_vertex_may_be_required() {
    let names = "KHR_texture_transform KHR_texture_basisu EXT_texture_webp EXT_texture_avif MSFT_texture_dds \
                 KHR_materials_unlit KHR_materials_variants KHR_materials_clearcoat KHR_materials_sheen \
                 KHR_materials_pbrSpecularGlossiness KHR_materials_transmission KHR_materials_anisotropy \
                 KHR_lights_punctual EXT_lights_ies EXT_mesh_features EXT_structural_metadata KHR_xmp_json_ld \
                 KHR_mesh_quantization";
    for name in names.split(' ') {
        let required = format!(
            r#""extensionsRequired":["{name}"],"extensionsUsed":["{name}"],"extensions":{{"{name}":[1]}}"#
        );
        same(&[
            (ASSET, &format!("{ASSET},{required}")),
            (
                r#""translation":[0,0,5]"#,
                &format!(r#""translation":[0,0,5],"extensions":{{"{name}":{{"light":0}}}}"#),
            ),
            (
                PRIMITIVE,
                &format!(
                    r#""WEIGHTS_0":1}},"material":0,"extensions":{{"{name}":{{"mappings":[]}}}}}}]"#
                ),
            ),
        ]);
    }
    let names = "KHR_animation_pointer KHR_other CESIUM_RTC KHR_physics_rigid_bodies texture_x MY_mesh_texture_x";
    for name in names.split(' ') {
        let required = format!(r#"{ASSET},"extensionsRequired":["KHR_materials_unlit","{name}"]"#);
        let error = strip(&[(ASSET, &required)]).unwrap_err();
        assert_eq!(error, format!("extensionsRequired: {name} is not done here"));
    }
}

#[test]
fn materials_textures_and_cameras_are_not_looked_at() {
    same(&[
        (
            ASSET,
            r#""asset":{"version":"2.0"},"textures":[{},{"sampler":7,"extensions":{"EXT_texture_webp":{"source":0}}}],
            "images":[{"uri":1}],"samplers":[{"wrapS":1}],"materials":[{"alphaMode":"?","extensions":{"KHR_materials_ior":2}}],
            "cameras":[{"type":"round"}]"#,
        ),
        (PRIMITIVE, r#""WEIGHTS_0":1},"material":5}]"#),
        (r#""translation":[0,0,5]"#, r#""translation":[0,0,5],"camera":3"#),
    ]);
}

#[test]
fn accessors_without_a_view_are_zeros() {
    let view = r#""bufferView":0,"count":3,"#;
    let close = |got: &[[f64; 3]], wanted: &[[f64; 3]]| {
        let mut pairs = got.as_flattened().iter().zip(wanted.as_flattened());
        assert!(pairs.all(|(a, b)| (a - b).abs() < 1e-6), "{got:?} {wanted:?}");
    };
    // Joint 0 is at (0, 0, 5), joint 1 one up from it and turned by 45°.
    let half = core::f64::consts::FRAC_1_SQRT_2;
    let zeros = strip(&[(view, r#""count":3,"#)]).unwrap();
    close(&[zeros[0], zeros[2]], &[[0.0, 0.0, 5.0], [half, 1.0 - half, 5.0]]);
    // Vertex 0 alone is at (1, 2, 0), where vertex 2 was; a byte of the joints says which one.
    let sparse = r#""count":3,"sparse":{"count":1,"indices":{"bufferView":6,"byteOffset":4,"componentType":5121},
        "values":{"bufferView":0,"byteOffset":24}},"#;
    let one = strip(&[(view, sparse)]).unwrap();
    close(&one, &[[1.0, 2.0, 5.0], zeros[1], zeros[2]]);
    // Positions without bounds, and joints that are all zero.
    same(&[(r#","min":[0,0,0],"max":[1,2,0]"#, "")]);
    let unmoved = strip(&[(r#""bufferView":6,"count":3,"#, r#""count":3,"#)]).unwrap();
    close(&unmoved, &[[0.0, 0.0, 5.0], [0.0, 1.0, 5.0], [1.0, 2.0, 5.0]]);
    let huge = strip(&[(view, r#""count":4294967295,"#)]).unwrap_err();
    assert!(huge.contains("4294967295 elements of nothing"), "{huge}");
}

#[test]
fn morph_targets_without_weight_move_nothing() {
    let targets =
        (PRIMITIVE, r#""WEIGHTS_0":1},"targets":[{"POSITION":0},{"NORMAL":0,"_HEAT":0}]}]"#);
    same(&[targets]);
    let weights = |weights: &str| format!("}}],\"weights\":[{weights}]}}],\"skins\"");
    for unmoved in ["0,0", "0,0.5", "-0", ""] {
        same(&[targets, (MESH_END, &weights(unmoved))]);
    }
    // A node has its own.
    same(&[targets, (MESH_END, &weights("1,0")), (r#""mesh":0"#, r#""mesh":0,"weights":[0,1]"#)]);
    let refused = "mesh 0, primitive 0: morph targets are not done here";
    let error = strip(&[targets, (MESH_END, &weights("0.1,0"))]).unwrap_err();
    assert_eq!(error, refused);
    let own = (r#""mesh":0"#, r#""mesh":0,"weights":[1]"#);
    assert_eq!(strip(&[targets, own]).unwrap_err(), refused);

    // Channels of weights: those of accessor 3 are 0 and 1, and accessor 7 is zeros.
    let channel = (CHANNELS, r#""channels":[{"sampler":2,"target":{"node":2,"path":"weights"}},"#);
    let zeros = (
        r#""componentType":5121}]"#,
        r#""componentType":5121},{"count":4,"type":"SCALAR","componentType":5126}]"#,
    );
    let samplers = r#""interpolation":"CUBICSPLINE"}]"#;
    let with = |output: usize| {
        format!(r#""interpolation":"CUBICSPLINE"}},{{"input":3,"output":{output}}}]"#)
    };
    same(&[targets, channel, zeros, (samplers, &with(7))]);
    // Without targets there is nothing to weigh.
    same(&[channel, (samplers, &with(3))]);
    let error = strip(&[targets, channel, (samplers, &with(3))]).unwrap_err();
    assert!(error.contains("animation 0, channel 0: morph targets (weight 1)"), "{error}");
}

#[test]
fn files_of_gltf_1_are_told_so() {
    let parse = |bytes: &[u8]| File::parse(Path::new("old.gltf"), bytes).unwrap_err();
    let mut binary = b"glTF".to_vec();
    binary.extend([1, 0, 0, 0, 24, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0]);
    binary.extend(b"{}  ");
    assert_eq!(parse(&binary), "glTF 1.0: only glTF 2.0 is read");
    for (text, version) in [
        (r#"{"asset":{"version":"1.0"},"meshes":{"a":{}}}"#, "1.0"),
        (r#"{"asset":{"version":1.1},"nodes":{"a":{}}}"#, "1.1"),
        (r#"{"asset":{"version":"0.8"},"extras":"x"}"#, "0.8"),
        (r#"{"meshes":{"a":{}}}"#, "1.0"),
        (r#"{"asset":{},"meshes":{"a":{}}}"#, "1.0"),
        (r#"{"asset":{"version":"3.0"}}"#, "3.0"),
    ] {
        assert_eq!(parse(text.as_bytes()), format!("glTF {version}: only glTF 2.0 is read"));
    }
    assert!(!parse(br#"{"asset":{"version":"2.1"},"meshes":1}"#).contains("only glTF"));
    let marked = "\u{feff}{\"asset\":{\"version\":\"2.0\"}}";
    assert!(File::parse(Path::new("marked.gltf"), marked.as_bytes()).is_ok());
}
