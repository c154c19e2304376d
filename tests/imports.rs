//! The layering rule of the design: imports run one way. Reads the sources as they are.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// What each module of `dq8` may import beside itself, `std`, `core` and `bytemuck`. A new module
/// needs a line here, behind those that it imports.
///
/// `scalar` and `batch` never see each other: the twins would share their bugs. What floats have of
/// `everyday` comes to `scalar` through `Real` alone, so that there are numbers without it to test with.
const MAY_IMPORT: &[(&str, &[&str])] = &[
    ("error", &[]),
    ("sine", &[]),
    ("geometry", &[]),
    ("motion", &["geometry"]),
    ("batch", &["error", "geometry", "motion", "dq8_simd"]),
    ("everyday", &["geometry", "batch", "dq8_simd"]),
    ("real", &["geometry", "everyday", "dq8_simd", "sine"]),
    ("scalar", &["error", "real", "geometry", "motion"]),
    ("differentiate", &["real", "scalar"]),
    ("incidence", &["error", "real", "geometry", "scalar"]),
    ("representation", &["error", "real", "geometry", "scalar"]),
    ("dispatch", &["dq8_simd"]),
    ("place", &["real", "dq8_simd", "scalar", "dispatch"]),
    ("slices", &["error", "dq8_simd", "scalar", "batch", "dispatch", "place"]),
    ("ik", &["error", "real", "geometry", "dq8_simd", "scalar", "batch", "dispatch"]),
    (
        "hierarchy",
        &[
            "error", "real", "geometry", "motion", "dq8_simd", "scalar", "batch", "dispatch",
            "place",
        ],
    ),
];

/// The same for `dq8-simd`. `float`, `lane`, `level` and their like name each other: a lane
/// belongs to a level, and a number has lanes.
const SIMD_MAY_IMPORT: &[(&str, &[&str])] = &[
    ("float", &["lane", "level", "packed"]),
    ("lane", &["float", "level"]),
    ("level", &["lane", "packed"]),
    ("packed", &["lane"]),
    ("block", &["lane", "level"]),
    ("portable", &["float", "lane", "level"]),
    ("square_root", &[]),
    ("checked_schedule", &[]),
    ("one", &["float", "lane", "level", "portable", "square_root"]),
    ("pair", &["float", "lane", "level"]),
    ("detect", &[]),
    ("x86_64", &["float", "lane", "level", "packed", "pair", "detect"]),
];

/// Files of `batch` without a twin in `scalar`: the scalar reference has these from the standard
/// library (`even`: sine and arcsine) or as a plain function (`length`: `vector::norm`).
const BATCH_ONLY: &[&str] = &["even.rs", "even_coefficients.rs", "length.rs"];

const MAX_LINES: usize = 400;

/// A source file: its module path from the crate root, its path for messages, its text.
struct Source {
    module: Vec<String>,
    path: String,
    text: String,
}

/// Every `.rs` file below `folder` of this package.
fn sources(folder: &str) -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut sources = Vec::new();
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let relative = path.strip_prefix(&root).unwrap().with_extension("");
                let names = relative.iter().map(|name| name.to_str().unwrap().to_owned());
                let module = names.filter(|name| name != "mod" && name != "lib").collect();
                let text = std::fs::read_to_string(&path).unwrap();
                sources.push(Source { module, path: path.display().to_string(), text });
            }
        }
    }
    assert!(sources.len() > 5, "no sources below {}", root.display());
    sources
}

/// Words and signs of Rust code; comments and texts are left out.
fn tokens(code: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    let mut rest = code;
    while let Some(first) = rest.chars().next() {
        let word = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").expect("a comment ends") + 2
        } else if let Some(quote) =
            ["'\"'", "'\\\"'"].iter().find(|quote| rest.starts_with(**quote))
        {
            quote.len()
        } else if rest.starts_with("r#\"") {
            rest.find("\"#").expect("a raw text ends") + 2
        } else if first == '"' {
            let mut escaped = false;
            let end = rest[1..].find(|c| {
                let ends = c == '"' && !escaped;
                escaped = c == '\\' && !escaped;
                ends
            });
            end.expect("a text ends") + 2
        } else if word > 0 {
            tokens.push(rest[..word].to_owned());
            word
        } else {
            let sign = if rest.starts_with("::") { "::" } else { &rest[..first.len_utf8()] };
            if !first.is_whitespace() {
                tokens.push(sign.to_owned());
            }
            sign.len()
        };
        rest = &rest[length..];
    }
    tokens
}

/// The paths of the tree that starts at `at`, such as `a::{b, c::d}`, each behind `prefix`; and the
/// token after it.
fn tree(tokens: &[String], mut at: usize, prefix: &[String]) -> (Vec<Vec<String>>, usize) {
    let mut path = prefix.to_vec();
    loop {
        let token = tokens.get(at).map_or("", String::as_str);
        if token == "{" {
            let mut paths = Vec::new();
            at += 1;
            while tokens[at] != "}" {
                let (branch, after) = tree(tokens, at, &path);
                paths.extend(branch);
                // To the next branch, over `as name` too.
                at = after;
                while tokens[at] != "," && tokens[at] != "}" {
                    at += 1;
                }
                at += usize::from(tokens[at] == ",");
            }
            return (paths, at + 1);
        }
        path.push(token.to_owned());
        at += 1;
        if tokens.get(at).is_none_or(|sign| sign != "::") {
            return (vec![path], at);
        }
        at += 1;
    }
}

/// What `module` imports or names with a path: modules of its own crate by their first name, names
/// at the root by the module that `reexports` says they come from, and other crates of this project.
fn imports(
    module: &[String],
    code: &str,
    reexports: &BTreeMap<String, String>,
) -> BTreeSet<String> {
    let tokens = tokens(code);
    let mut found = BTreeSet::new();
    // Inline modules around the current token: name, and the depth of braces outside it.
    let mut inside: Vec<(String, usize)> = Vec::new();
    let (mut depth, mut at) = (0, 0);
    while at < tokens.len() {
        let after_path = at > 0 && tokens[at - 1] == "::";
        match tokens[at].as_str() {
            "{" => {
                if at > 1 && tokens[at - 2] == "mod" {
                    inside.push((tokens[at - 1].clone(), depth));
                }
                depth += 1;
            }
            "}" => {
                depth -= 1;
                inside.pop_if(|(_, outside)| *outside == depth);
            }
            "dq8" | "dq8_simd" => {
                found.insert(tokens[at].clone());
            }
            start @ ("crate" | "super" | "self") if !after_path => {
                let (paths, _) = tree(&tokens, at, &[]);
                let names = inside.iter().map(|(name, _)| name);
                let here: Vec<&String> = module.iter().chain(names).collect();
                for path in paths.iter().filter(|path| path.len() > 1) {
                    let ups = path.iter().take_while(|name| *name == "super").count();
                    let skip = ups.max(1);
                    let base = if start == "crate" {
                        &[][..]
                    } else {
                        &here[..here.len().saturating_sub(ups)]
                    };
                    let rest = path[skip..].iter().filter(|name| *name != "self");
                    if let Some(name) = base.iter().copied().chain(rest).next() {
                        found.insert(reexports.get(name).unwrap_or(name).clone());
                    }
                }
            }
            _ => {}
        }
        at += 1;
    }
    found
}

/// Names at the root of a crate and the module or crate that `lib.rs` has them from.
fn reexports(lib: &str) -> BTreeMap<String, String> {
    let tokens = tokens(lib);
    let uses = tokens.iter().enumerate().filter(|(_, token)| *token == "use");
    let paths = uses.flat_map(|(at, _)| tree(&tokens, at + 1, &[]).0);
    let pairs = paths.filter_map(|path| Some((path.last()?.clone(), path.first()?.clone())));
    pairs.filter(|(name, _)| name != "*").collect()
}

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
            if import != *own && !allowed.contains(&import.as_str()) {
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
        assert!(!(allowed.contains(&"everyday") && *module != "real"));
    }
}

#[test]
fn every_file_of_scalar_has_a_twin_in_batch_and_the_other_way_round() {
    let files = |folder: &str| -> BTreeSet<String> {
        let names = sources(folder).into_iter().map(|source| source.path);
        names.map(|path| path.rsplit(['/', '\\']).next().unwrap().to_owned()).collect()
    };
    let (scalar, batch) = (files("src/scalar"), files("src/batch"));
    let alone: Vec<_> = scalar.difference(&batch).collect();
    assert!(alone.is_empty(), "only in scalar: {alone:?}");
    let alone: Vec<_> = batch.difference(&scalar).collect();
    assert_eq!(alone, BATCH_ONLY, "only in batch");
}

/// `simd` has the instructions, `capi` the pointers of C.
#[test]
fn no_unsafe_code_stands_outside_the_lanes_and_the_c_abi() {
    for source in ["src", "examples", "benches"].into_iter().flat_map(sources) {
        assert!(!tokens(&source.text).iter().any(|token| token == "unsafe"), "{}", source.path);
    }
    let lib = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/src/lib.rs")).unwrap();
    let forbid = ["#", "!", "[", "forbid", "(", "unsafe_code", ")", "]"];
    assert!(tokens(&lib).windows(forbid.len()).any(|window| window == forbid));
}

#[test]
fn no_file_is_longer_than_four_hundred_lines() {
    for source in ["src", "simd/src", "capi"].into_iter().flat_map(sources) {
        let lines = source.text.lines().count();
        assert!(lines <= MAX_LINES, "{} has {lines} lines", source.path);
    }
}

/// The reader itself, on code that tries to slip through.
#[test]
fn imports_are_found_however_they_are_written() {
    let lib = "pub use scalar::{Dual, DualQuat as D}; pub use dq8_simd::Lanes; use batch::Wide;";
    let reexports = reexports(lib);
    let found = |module: &str, code: &str| -> Vec<String> {
        let module: Vec<String> = module.split("::").map(str::to_owned).collect();
        imports(&module, code, &reexports).into_iter().collect()
    };
    for (module, code, wanted) in [
        ("batch::norm", "use crate::scalar::Quat;", &["scalar"][..]),
        ("batch::norm", "use super::super::scalar;", &["scalar"]),
        ("batch", "use super::scalar as twin;", &["scalar"]),
        ("batch", "use {crate::{real::{self, Real}, geometry}, core::fmt};", &["geometry", "real"]),
        ("batch", "fn f() { crate::hierarchy::pack() }", &["hierarchy"]),
        ("batch", "macro_rules! m { () => { $crate::scalar::f() } }", &["scalar"]),
        ("batch", "use crate::Dual;", &["scalar"]),
        ("scalar", "use crate::Lanes;", &["dq8_simd"]),
        ("scalar", "use crate::*;", &["*"]),
        ("scalar", "extern crate dq8_simd as lanes;", &["dq8_simd"]),
        ("scalar", "fn f<L: dq8_simd::Lanes>() {}", &["dq8_simd"]),
        // Inside its own module nothing leaves it.
        ("batch::norm", "use super::{Dual, vector}; use self::inner::X;", &["batch"]),
        ("real", "mod sealed { use super::Real; } use super::batch;", &["batch", "real"]),
        // Comments and texts import nothing.
        ("batch", "// crate::scalar\n/// super::scalar\n/* crate::scalar */", &[]),
        ("batch", r#"const A: &str = "a \" crate::scalar::B";"#, &[]),
        ("batch", "const A: &str = r#\"crate::scalar::\"B\"\"#;", &[]),
        ("batch", "const A: [char; 2] = ['\"', '\\\"']; use crate::scalar::B;", &["scalar"]),
        ("batch", "pub(crate) fn f<'a>() -> char { 'a' }", &[]),
    ] {
        assert_eq!(found(module, code), wanted, "{module}: {code}");
    }
}
