//! The pictures of the documentation: SVG that rustdoc puts into its pages as it is.

use dq8_contract::legible::illegible;
use std::fs;
use std::path::{Path, PathBuf};

/// Files below a folder of the repository whose names end in `.kind`.
fn files(folder: &Path, kind: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path, kind));
        } else if path.extension().is_some_and(|extension| extension == kind) {
            found.push(path);
        }
    }
    found
}

fn sources(kind: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    ["src", "robot/src", "trajectory/src"]
        .iter()
        .flat_map(|at| files(&root.join(at), kind))
        .collect()
}

/// Each with its path.
fn pictures() -> Vec<(PathBuf, String)> {
    let pictures: Vec<_> = sources("svg")
        .into_iter()
        .map(|path| (path.clone(), fs::read_to_string(path).unwrap()))
        .collect();
    assert!(pictures.len() >= 5, "{pictures:?}");
    pictures
}

#[test]
fn pictures_are_at_most_three_kilobytes() {
    for (path, picture) in pictures() {
        assert!(picture.len() <= 3 * 1024, "{}: {} bytes", path.display(), picture.len());
    }
}

/// A block of HTML in Markdown begins with a whole tag on a line of its own and ends at an empty
/// line.
#[test]
fn markdown_takes_pictures_as_one_block() {
    for (path, picture) in pictures() {
        let path = path.display();
        let first = picture.lines().next().unwrap();
        assert!(first.starts_with("<svg ") && first.ends_with('>'), "{path}: {first}");
        assert!(picture.lines().all(|line| !line.trim().is_empty()), "{path}");
        assert!(picture.ends_with("</svg>\n"), "{path}");
    }
}

#[test]
fn texts_are_legible_at_a_width_of_700_pixels() {
    for (path, picture) in pictures() {
        assert!(picture.contains(" viewBox=\"0 0 700 "), "{}", path.display());
        assert_eq!(illegible(&picture), [""; 0], "{}", path.display());
    }
}

#[test]
fn lines_and_texts_have_the_colour_of_the_theme() {
    for (path, picture) in pictures() {
        assert!(picture.contains(" stroke=\"currentColor\""), "{}", path.display());
        assert!(
            picture.contains("<g fill=\"currentColor\" stroke=\"none\">"),
            "{}",
            path.display()
        );
        for colour in ["black", "white", "#000", "#fff"] {
            assert!(!picture.contains(&format!("\"{colour}")), "{}: {colour}", path.display());
        }
    }
}

#[test]
fn every_picture_is_in_the_documentation() {
    let texts: Vec<_> =
        sources("rs").into_iter().map(|path| fs::read_to_string(path).unwrap()).collect();
    for (path, _) in pictures() {
        let name = path.file_name().unwrap().to_string_lossy();
        let named = format!("doc = include_str!(\"{name}\")");
        assert!(texts.iter().any(|text| text.contains(&named)), "{}", path.display());
    }
}
