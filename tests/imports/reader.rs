//! Reads sources: what a module imports, however it is written.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// A source file: its module path from the crate root, its path for messages, its text.
pub(crate) struct Source {
    pub(crate) module: Vec<String>,
    pub(crate) path: String,
    pub(crate) text: String,
}

/// Every `.rs` file below `folder` of this package.
pub(crate) fn sources(folder: &str) -> Vec<Source> {
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
pub(crate) fn tokens(code: &str) -> Vec<String> {
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
pub(crate) fn tree(
    tokens: &[String],
    mut at: usize,
    prefix: &[String],
) -> (Vec<Vec<String>>, usize) {
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
pub(crate) fn paths(module: &[String], code: &str) -> Vec<Vec<String>> {
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
/// at the root by the module that `reexports` says they come from, and other crates of this
/// project.
pub(crate) fn imports(
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
pub(crate) fn reexports(room: &str) -> BTreeMap<String, Vec<String>> {
    let tokens = tokens(room);
    let uses = tokens.iter().enumerate().filter(|(_, token)| *token == "use");
    let paths = uses.flat_map(|(at, _)| tree(&tokens, at + 1, &[]).0);
    let pairs = paths.filter_map(|path| Some((path.last()?.clone(), path)));
    pairs.filter(|(name, _)| name != "*").collect()
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
