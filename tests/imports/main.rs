//! The layering rule of the design: imports run one way. Reads the sources as they are.

mod reader;
mod rooms;

use reader::{Source, imports, reexports, sources, tokens};
use std::collections::BTreeSet;

/// What each module of `dq8` may import beside itself, `std`, `core` and `bytemuck`. A new module
/// needs a line here, behind those that it imports.
///
/// `scalar` and `batch` never see each other: the twins would share their bugs. Of `quick`,
/// `scalar` knows the names of the operations, and the answers come through `Real` alone: so there
/// are numbers without any, to test with.
const MAY_IMPORT: &[(&str, &[&str])] = &[
    ("macros", &["dq8_simd"]),
    ("geometry", &["macros"]),
    ("contract", &["geometry"]),
    ("batch", &["geometry", "contract", "dq8_simd"]),
    ("quick", &["geometry", "batch", "dq8_simd"]),
    ("number", &["geometry", "quick", "dq8_simd"]),
    ("scalar", &["macros", "number", "geometry", "contract", "quick"]),
    ("incidence", &["macros", "number", "geometry", "scalar"]),
    ("representation", &["macros", "number", "geometry", "scalar"]),
    ("fit", &["macros", "number", "scalar", "representation"]),
    ("operators", &["macros", "number", "geometry", "scalar", "representation"]),
    ("guide", &[]),
    ("interop", &["macros", "number", "geometry", "scalar", "representation"]),
    ("backend", &["dq8_simd"]),
    (
        "storage",
        &[
            "macros",
            "number",
            "geometry",
            "dq8_simd",
            "scalar",
            "batch",
            "representation",
            "backend",
        ],
    ),
    ("law", &["dq8_simd", "batch"]),
    ("ik", &["macros", "number", "scalar", "batch", "storage", "dq8_simd"]),
    (
        "slices",
        &[
            "macros", "ik", "fit", "number", "geometry", "dq8_simd", "scalar", "batch", "law",
            "backend", "storage",
        ],
    ),
    (
        "skinning",
        &[
            "macros",
            "number",
            "dq8_simd",
            "scalar",
            "batch",
            "backend",
            "representation",
            "storage",
        ],
    ),
    ("internal", &["macros", "batch", "scalar", "quick", "backend"]),
    (
        "hierarchy",
        &[
            "macros", "ik", "number", "geometry", "contract", "dq8_simd", "scalar", "batch", "law",
            "backend", "storage",
        ],
    ),
];

/// The same for `dq8-simd`.
const SIMD_MAY_IMPORT: &[(&str, &[&str])] = &[
    ("sealed", &[]),
    ("lanes", &["sealed"]),
    ("index", &[]),
    ("block", &["lanes"]),
    ("shorts", &["lanes"]),
    // The macro `pod!` is exported from the root, where it also calls itself.
    ("internal", &["index", "lanes", "pod", "shorts"]),
    ("records", &["internal", "lanes"]),
    ("aarch64", &["lanes"]),
    ("wasm32", &["lanes"]),
    ("pair", &["lanes", "sealed", "shorts"]),
    ("detect", &[]),
    ("x86_64", &["lanes", "pair", "sealed", "detect", "shorts"]),
    ("portable", &["aarch64", "internal", "lanes", "sealed", "shorts", "wasm32", "x86_64"]),
    ("one", &["internal", "lanes", "portable", "shorts"]),
    ("unfused", &["lanes", "sealed", "shorts"]),
];

/// The same for `dq8-robot`, which Cargo keeps from everything that `dq8` does not show.
const ROBOT_MAY_IMPORT: &[(&str, &[&str])] = &[
    ("mechanism", &["dq8", "dq8_simd"]),
    ("ik", &["dq8", "dq8_simd", "mechanism"]),
    ("urdf", &["dq8", "mechanism"]),
];

/// The same for `dq8-trajectory`.
const TRAJECTORY_MAY_IMPORT: &[(&str, &[&str])] = &[
    ("error", &["dq8"]),
    ("clock", &["error"]),
    ("screw", &["dq8"]),
    ("path", &["dq8", "error", "screw"]),
    ("segments", &["dq8", "clock", "error"]),
    ("stretches", &["dq8", "path", "screw", "segments"]),
    ("along", &["dq8", "clock", "screw", "segments", "stretches"]),
    ("job", &["dq8", "along", "clock", "error", "path", "segments", "stretches"]),
    ("spline", &["dq8", "along", "clock", "error", "job", "screw", "segments"]),
    ("frames", &["dq8", "along", "clock", "error", "job", "path", "segments", "stretches"]),
    ("covariance", &["dq8"]),
    ("files", &["dq8", "error", "path"]),
    ("compare", &["dq8", "path"]),
];

/// The folders of the reference, whose files have a twin of the same name in [`LANES`].
const REFERENCE: &[&str] = &["src/scalar", "src/representation"];
const LANES: &str = "src/batch";

/// Files of the reference without a twin: no kernel asks for many of these at a time.
const REFERENCE_ONLY: &[&str] =
    &["affine.rs", "euler_angles.rs", "must_be_unit.rs", "rotation_translation.rs", "shorthand.rs"];

/// Files of `batch` without a twin: the reference has these from the standard library (`even`,
/// `trigonometry`, `exponential`) or as a plain function (`length`: `vector::norm`).
const BATCH_ONLY: &[&str] =
    &["even.rs", "even_coefficients.rs", "exponential.rs", "length.rs", "trigonometry.rs"];

const MAX_LINES: usize = 800;

/// Every import of `folder` that its table does not allow.
fn forbidden(folder: &str, may_import: &[(&str, &[&str])]) -> Vec<String> {
    let sources = sources(folder);
    let lib = sources.iter().find(|source| source.module.is_empty()).expect("lib.rs");
    let reexports = reexports(&lib.text);
    let mut complaints = Vec::new();
    for Source { module, path, text } in &sources {
        // The root gathers what the crate shows.
        let Some(own) = module.first() else { continue };
        let Some((_, allowed)) = may_import.iter().find(|(name, _)| name == own) else {
            complaints.push(format!("{path}: the module {own} has no line in the table"));
            continue;
        };
        for import in imports(module, text, &reexports) {
            // Exported macros stand at the root: their names begin with two underscores.
            if import != *own && !import.starts_with("__") && !allowed.contains(&import.as_str()) {
                complaints.push(format!("{path}: {own} must not import {import}"));
            }
        }
    }
    complaints
}

#[test]
fn imports_of_dq8_run_one_way() {
    assert_eq!(forbidden("src", MAY_IMPORT), Vec::<String>::new());
}

#[test]
fn imports_of_the_lanes_run_one_way_and_never_to_dq8() {
    assert_eq!(forbidden("simd/src", SIMD_MAY_IMPORT), Vec::<String>::new());
}

#[test]
fn imports_of_robots_run_one_way() {
    assert_eq!(forbidden("robot/src", ROBOT_MAY_IMPORT), Vec::<String>::new());
}

#[test]
fn imports_of_trajectories_run_one_way() {
    assert_eq!(forbidden("trajectory/src", TRAJECTORY_MAY_IMPORT), Vec::<String>::new());
}

/// A table that allowed what the design forbids would let everything pass.
#[test]
fn the_tables_keep_the_twins_apart_and_have_no_circle() {
    for (module, allowed) in MAY_IMPORT {
        let before = MAY_IMPORT.iter().take_while(|(name, _)| name != module);
        for import in allowed.iter().filter(|import| **import != "dq8_simd") {
            assert!(before.clone().any(|(name, _)| name == import), "{module} before {import}");
        }
        assert!(!(allowed.contains(&"scalar") && *module == "batch"));
        assert!(!(allowed.contains(&"dq8_simd") && ["scalar", "motion"].contains(module)));
        assert!(!allowed.contains(&"quick") || ["number", "scalar", "internal"].contains(module));
    }
}

#[test]
fn every_file_of_the_reference_has_a_twin_in_batch_and_the_other_way_round() {
    let files = |folder: &str| -> BTreeSet<String> {
        let entries = std::fs::read_dir(format!("{}/{folder}", env!("CARGO_MANIFEST_DIR")));
        let names = entries.unwrap().map(|entry| entry.unwrap().file_name());
        let names = names.map(|name| name.into_string().unwrap());
        // Lanes answer with masks.
        names
            .filter(|name| name.ends_with(".rs") && name != "error.rs" && name != "mod.rs")
            .collect()
    };
    let reference: BTreeSet<_> = REFERENCE.iter().flat_map(|folder| files(folder)).collect();
    let lanes = files(LANES);
    let single: Vec<_> = reference.difference(&lanes).collect();
    let alone: Vec<_> = lanes.difference(&reference).collect();
    assert_eq!(single, REFERENCE_ONLY, "without a twin on lanes");
    assert_eq!(alone, BATCH_ONLY, "only in batch");
}

/// What declares the peers in C++ that trajectories are timed beside; all its functions are safe.
const PEERS: &str = "trajectory/contest/src/peers.rs";

/// `simd` has the instructions, `capi` the pointers of C.
#[test]
fn no_unsafe_code_stands_outside_the_lanes_and_the_c_abi() {
    for source in
        ["src", "robot", "trajectory", "examples", "benches"].into_iter().flat_map(sources)
    {
        let mut words = tokens(&source.text);
        if source.path.ends_with(PEERS) {
            let declaration = words.windows(2).position(|words| words == ["unsafe", "extern"]);
            words.remove(declaration.unwrap());
        }
        assert!(!words.iter().any(|word| word == "unsafe"), "{}", source.path);
    }
    let lib = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/src/lib.rs")).unwrap();
    let forbid = ["#", "!", "[", "forbid", "(", "unsafe_code", ")", "]"];
    assert!(tokens(&lib).windows(forbid.len()).any(|window| window == forbid));
}

#[test]
fn no_file_is_longer_than_eight_hundred_lines() {
    for source in ["src", "simd/src", "robot", "trajectory", "capi"].into_iter().flat_map(sources) {
        let lines = source.text.lines().count();
        assert!(lines <= MAX_LINES, "{} has {lines} lines", source.path);
    }
}
