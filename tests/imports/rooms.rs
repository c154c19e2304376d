//! Inside a room, a folder with its `mod.rs`, imports run one way too.

use crate::reader::{Source, paths, reexports, sources, tokens, tree};
use std::collections::{BTreeMap, BTreeSet};

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

#[test]
fn imports_run_one_way_inside_every_room_too() {
    let mut rooms = 0;
    for folder in ["src", "simd/src", "robot/src", "trajectory/src", "capi/src"] {
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
            assert_eq!(circle(&graph(&sources, module)), None, "{path}");
            rooms += 1;
        }
    }
    assert!(rooms >= 10, "only {rooms} rooms");
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
