//! The layering rule of the design: imports run one way. Reads the sources as they are.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// What each module of `dq8` may import beside itself, `std`, `core` and `bytemuck`. A new module
/// needs a line here, behind those that it imports.
///
/// `scalar` and `batch` never see each other: the twins would share their bugs.
const MAY_IMPORT: &[(&str, &[&str])] = &[
    ("error", &[]),
    ("shape", &[]),
    ("sine", &[]),
    ("real", &["dq8_simd", "sine"]),
    ("geometry", &[]),
    ("motion", &["geometry"]),
    ("scalar", &["error", "real", "geometry", "motion"]),
    ("differentiate", &["real", "scalar"]),
    ("incidence", &["error", "real", "geometry", "scalar"]),
    ("representation", &["error", "real", "geometry", "scalar"]),
    ("batch", &["error", "real", "geometry", "motion", "dq8_simd"]),
    ("dispatch", &["dq8_simd"]),
    ("storage", &["shape", "real", "geometry", "dq8_simd", "scalar", "dispatch"]),
    ("palette_entry", &["dq8_simd", "batch", "storage"]),
    ("slices", &["shape", "dq8_simd", "scalar", "batch", "dispatch", "storage", "palette_entry"]),
    ("ik", &["error", "shape", "real", "geometry", "dq8_simd", "scalar", "batch", "dispatch"]),
    (
        "hierarchy",
        &[
            "error",
            "shape",
            "real",
            "geometry",
            "motion",
            "dq8_simd",
            "scalar",
            "batch",
            "dispatch",
            "storage",
            "palette_entry",
        ],
    ),
];

/// The same for `dq8-simd`. `float`, `lane`, `level` and their like name each other: a lane
/// belongs to a level, and a number has lanes.
const SIMD_MAY_IMPORT: &[(&str, &[&str])] = &[
    ("float", &["lane", "level", "octet"]),
    ("lane", &["float", "level"]),
    ("level", &["lane", "octet"]),
    ("octet", &["lane"]),
    ("block", &["lane", "level"]),
    ("portable", &["float", "lane", "level"]),
    ("square_root", &[]),
    ("checked_schedule", &[]),
    ("one", &["float", "lane", "level", "portable", "square_root"]),
    ("pair", &["float", "lane", "level"]),
    ("detect", &[]),
    ("x86_64", &["float", "lane", "level", "octet", "pair", "detect"]),
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

/// The paths from the root of its crate that `module` imports or names, and other crates of this
/// project.
fn paths(module: &[String], code: &str) -> Vec<Vec<String>> {
    let tokens = tokens(code);
    let mut found = Vec::new();
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
            "dq8" | "dq8_simd" => found.push(vec![tokens[at].clone()]),
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
                    found.push(base.iter().copied().chain(rest).cloned().collect());
                }
            }
            _ => {}
        }
        at += 1;
    }
    found
}

/// What `module` imports or names with a path: modules of its own crate by their first name, names
/// at the root by the module that `reexports` says they come from, and other crates of this project.
fn imports(
    module: &[String],
    code: &str,
    reexports: &BTreeMap<String, Vec<String>>,
) -> BTreeSet<String> {
    let paths = paths(module, code);
    let first = |path: &Vec<String>| {
        let name = path.first()?;
        Some(reexports.get(name).map_or(name, |path| &path[0]).clone())
    };
    paths.iter().filter_map(first).collect()
}

/// Names in the `mod.rs` or `lib.rs` of a room and the path that it has them from.
fn reexports(room: &str) -> BTreeMap<String, Vec<String>> {
    let tokens = tokens(room);
    let uses = tokens.iter().enumerate().filter(|(_, token)| *token == "use");
    let paths = uses.flat_map(|(at, _)| tree(&tokens, at + 1, &[]).0);
    let pairs = paths.filter_map(|path| Some((path.last()?.clone(), path)));
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

/// Modules that name each other, folder by folder: one honest recursion each.
///
/// A number has lanes, a vector of lanes belongs to a level, a level has vectors, and eight of them are a
/// register for one motion.
const CIRCLES: &[(&str, &[&str])] = &[
    ("simd/src", &["float", "lane", "level", "octet"]),
    // An arm is checked by what is gathered of it. To be cut.
    ("src/ik", &["arm", "seed"]),
];

/// The name in a graph of a room for what stands in its `mod.rs`.
const ROOM: &str = "mod.rs";

/// Which modules of the folder `room` import which: those in files and folders of their own, and
/// `mod.rs` itself if it holds more than the way to them.
fn graph(sources: &[Source], room: &[String]) -> BTreeMap<String, BTreeSet<String>> {
    let own = sources.iter().find(|source| source.module == room).expect("a room has a mod.rs");
    let reexports = reexports(&own.text);
    let inner: Vec<_> = sources
        .iter()
        .filter(|source| source.module.len() > room.len() && source.module.starts_with(room))
        .collect();
    let children: BTreeSet<&String> =
        inner.iter().map(|source| &source.module[room.len()]).collect();
    // What `mod.rs` calls by a name that it has from a child, outside of `use`.
    let mut graph = BTreeMap::new();
    let words = tokens(&own.text);
    let mut used = BTreeSet::new();
    let mut at = 0;
    while at < words.len() {
        if words[at] == "use" {
            at = tree(&words, at + 1, &[]).1;
        } else if let Some(path) = reexports.get(&words[at])
            && let Some(child) = path.iter().find(|name| *name != "self")
            && children.contains(child)
        {
            used.insert(child.clone());
        }
        at += 1;
    }
    graph.insert(ROOM.to_owned(), used);
    for source in inner {
        let name = &source.module[room.len()];
        let imports = graph.entry(name.clone()).or_insert_with(BTreeSet::new);
        for path in paths(&source.module, &source.text) {
            if path.len() <= room.len() || !path.starts_with(room) {
                continue;
            }
            let mut first = &path[room.len()];
            if !children.contains(first) {
                let from = reexports
                    .get(first)
                    .and_then(|path| path.iter().find(|name| children.contains(name)));
                // What comes into the room from outside is no import inside of it.
                let foreign = reexports.contains_key(first) && from.is_none();
                let room = &ROOM.to_owned();
                match from {
                    Some(child) => first = child,
                    None if foreign => continue,
                    None => {
                        imports.insert(room.clone());
                        continue;
                    }
                }
            }
            if first != name {
                imports.insert(first.clone());
            }
        }
    }
    graph
}

/// A way from a module back to itself.
fn circle(graph: &BTreeMap<String, BTreeSet<String>>) -> Option<Vec<String>> {
    fn walk(
        graph: &BTreeMap<String, BTreeSet<String>>,
        way: &mut Vec<String>,
        done: &mut BTreeSet<String>,
    ) -> bool {
        let here = way.last().expect("a way begins somewhere").clone();
        if let Some(before) = way[..way.len() - 1].iter().position(|name| *name == here) {
            way.drain(..before);
            return true;
        }
        if done.contains(&here) {
            return false;
        }
        for next in graph.get(&here).into_iter().flatten() {
            way.push(next.clone());
            if walk(graph, way, done) {
                return true;
            }
            way.pop();
        }
        done.insert(here);
        false
    }
    let mut done = BTreeSet::new();
    graph.keys().find_map(|start| {
        let mut way = vec![start.clone()];
        walk(graph, &mut way, &mut done).then_some(way)
    })
}

/// The graph with some modules in one.
fn merged(
    graph: &BTreeMap<String, BTreeSet<String>>,
    together: &[&str],
) -> BTreeMap<String, BTreeSet<String>> {
    let one = together.join(" + ");
    let name = |name: &String| {
        if together.contains(&name.as_str()) { one.clone() } else { name.clone() }
    };
    let mut merged: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (module, imports) in graph {
        let module = name(module);
        let imports = imports.iter().map(name).filter(|import| *import != module).collect();
        merged.entry(module).or_default().extend::<BTreeSet<String>>(imports);
    }
    merged
}

#[test]
fn imports_run_one_way_inside_every_room_too() {
    let mut rooms = 0;
    for folder in ["src", "simd/src", "capi/src"] {
        let sources = sources(folder);
        let is_room = |source: &&Source| {
            let inside = |other: &Source| other.module.len() > source.module.len();
            sources.iter().any(|other| inside(other) && other.module.starts_with(&source.module))
        };
        for Source { module, .. } in sources.iter().filter(is_room) {
            // Where `dq8` begins the table of the rooms says more.
            if folder == "src" && module.is_empty() {
                continue;
            }
            let path = [&[folder.to_owned()], &module[..]].concat().join("/");
            let mut graph = graph(&sources, module);
            if let Some((_, together)) = CIRCLES.iter().find(|(room, _)| *room == path) {
                assert!(circle(&graph).is_some(), "{path} has no circle: take the exception away");
                graph = merged(&graph, together);
            }
            assert_eq!(circle(&graph), None, "{path}");
            rooms += 1;
        }
    }
    assert!(rooms >= 10, "only {rooms} rooms");
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

/// The search itself, on rooms with a circle behind every kind of import.
#[test]
fn circles_are_found_however_they_are_closed() {
    let source = |module: &str, text: &str| Source {
        module: module.split("::").filter(|name| !name.is_empty()).map(str::to_owned).collect(),
        path: module.to_owned(),
        text: text.to_owned(),
    };
    let found = |files: &[(&str, &str)]| {
        let sources: Vec<_> = files.iter().map(|(module, text)| source(module, text)).collect();
        circle(&graph(&sources, &["room".to_owned()])).map(|way| way.join(" "))
    };
    let mod_rs = "mod a; mod b; mod c; pub use a::A; pub(crate) use b::{B, self as d}; use c::C;";
    for (room, a, b, c, wanted) in [
        (mod_rs, "use super::b::X;", "use super::c::X;", "use crate::other::a::X;", None),
        (mod_rs, "use super::b::X;", "use super::a::X;", "", Some("a b a")),
        (mod_rs, "use super::B;", "fn f() -> crate::room::A { }", "", Some("a b a")),
        (
            mod_rs,
            "use super::{B, C};",
            "",
            "mod t { use super::super::b; use crate::room::A; }",
            Some("a c a"),
        ),
        (mod_rs, "mod t { use super::*; }", "use super::d;", "", None),
        // What stands in `mod.rs` itself.
        ("mod a; mod b; mod c; pub use a::A; struct S(A);", "", "use super::S;", "", None),
        (
            "mod a; mod b; mod c; pub use a::A; struct S(A);",
            "use super::S;",
            "",
            "",
            Some("a mod.rs a"),
        ),
        ("mod a; mod b; mod c; pub use a::A; // A\nstruct S;", "use super::S;", "", "", None),
    ] {
        let files = [("room", room), ("room::a", a), ("room::b", b), ("room::c", c)];
        assert_eq!(found(&files).as_deref(), wanted, "{room} / {a} / {b} / {c}");
    }
}
