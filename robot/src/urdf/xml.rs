//! The text of a file as a strict reader of XML takes it, line for line. Readers of URDF are not
//! strict: they skip declarations and comments wherever and however they are written, and know
//! nothing of namespaces.

use super::error::UrdfError;
use std::collections::BTreeSet;

/// How deep elements may be in each other. TinyXML, which most readers of URDF use, has the same
/// limit.
const DEPTH: usize = 500;
/// How many attributes an element may have. The strict reader compares each with all others, which
/// takes seconds for as many as half a megabyte holds; no element of the format has more than
/// seven.
const ATTRIBUTES: usize = 1000;

/// Without declarations, comments and a document type, and with a declaration of every prefix.
pub(crate) fn strict(text: &str) -> Result<String, UrdfError> {
    // Some editors leave such characters at the ends.
    let text = text.trim_start_matches('\u{feff}').trim_end_matches(['\0', '\u{1a}']);
    let mut out = String::with_capacity(text.len());
    let (mut used, mut declared) = (BTreeSet::new(), BTreeSet::new());
    let (mut rest, mut depth, mut root) = (text, 0_usize, None);
    let line = |rest: &str| newlines(&text[..text.len() - rest.len()]).count() as u32 + 1;
    while let Some(at) = rest.find('<') {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        if let Some(length) = skipped(rest, root.is_none()) {
            let (skipped, after) = rest.split_at(length);
            if skipped.starts_with("<!DOCTYPE") && skipped.contains("<!ENTITY") {
                let message = "entities of a document type are not read".into();
                return Err(UrdfError::Parse { line: line(rest), message });
            }
            out.extend(newlines(skipped));
            rest = after;
            continue;
        }
        let section = rest.starts_with("<![CDATA[");
        let found =
            if section { ends(rest, "]]>").map(|end| (end, Vec::new())) } else { tag(rest) };
        let Some((length, colons)) = found else {
            // No XML from here on, as the strict reader will say.
            break;
        };
        let (tag, after) = rest.split_at(length);
        if !section {
            let name = tag.find(|c: char| c.is_whitespace() || c == '>').unwrap_or(length);
            let name = tag[..name].trim_end_matches('/');
            for (prefix, local) in colons.into_iter().map(|colon| around(tag, colon)) {
                match (prefix, root) {
                    ("xmlns", None) => declared.insert(local),
                    ("xmlns" | "xml" | "", _) => continue,
                    _ => used.insert(prefix),
                };
            }
            root.get_or_insert(out.len() + name.len());
            if tag.starts_with("</") {
                depth = depth.saturating_sub(1);
            } else if !tag.ends_with("/>") {
                depth += 1;
            }
            let what = match tag.matches('=').count() {
                _ if depth > DEPTH => format!("more than {DEPTH} elements are in each other"),
                // Where that many are in values, they are counted once more.
                many if many > ATTRIBUTES && attributes(tag) > ATTRIBUTES => {
                    format!("it has more than {ATTRIBUTES} attributes")
                }
                _ => String::new(),
            };
            if !what.is_empty() {
                let element = format!("{name}>");
                return Err(UrdfError::Unexpected { line: line(rest), element, what });
            }
        }
        out.push_str(tag);
        rest = after;
    }
    out.push_str(rest);
    let unknown: Vec<_> = used.difference(&declared).collect();
    let root = root.unwrap_or_default();
    // They become attributes of the root, and the strict reader looks through all of them for each
    // name.
    if unknown.len() > ATTRIBUTES {
        let (line, element) = (newlines(&out[..root]).count() as u32 + 1, "<robot>".into());
        let what = format!("its names have more than {ATTRIBUTES} prefixes");
        return Err(UrdfError::Unexpected { line, element, what });
    }
    let declarations: String =
        unknown.iter().map(|prefix| format!(" xmlns:{prefix}=\"{prefix}\"")).collect();
    out.insert_str(root, &declarations);
    Ok(out)
}

fn newlines(text: &str) -> impl Iterator<Item = char> {
    text.chars().filter(|&c| c == '\n')
}

/// The length of what is at the beginning and says nothing, if such a thing is there.
fn skipped(text: &str, before_root: bool) -> Option<usize> {
    if let Some(comment) = text.strip_prefix("<!--") {
        ends(comment, "-->").map(|length| 4 + length)
    } else if text.starts_with("<?") {
        ends(text, "?>")
    } else if before_root && text.starts_with("<!DOCTYPE") {
        document_type(text)
    } else {
        None
    }
}

/// The length up to and with `end`.
fn ends(text: &str, end: &str) -> Option<usize> {
    text.find(end).map(|at| at + end.len())
}

fn document_type(text: &str) -> Option<usize> {
    let (mut quote, mut inside) = (None, false);
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (Some(open), _) if open == c => quote = None,
            (None, '"' | '\'') => quote = Some(c),
            (None, '[' | ']') => inside = c == '[',
            (None, '>') if !inside => return Some(at + 1),
            _ => {}
        }
    }
    None
}

/// The length of a tag, and where colons are in it outside of values.
fn tag(text: &str) -> Option<(usize, Vec<usize>)> {
    let (mut quote, mut colons) = (None, Vec::new());
    for (at, byte) in text.bytes().enumerate().skip(1) {
        match (quote, byte) {
            (_, b'<') => return None,
            (Some(open), _) if open == byte => quote = None,
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b':') => colons.push(at),
            (None, b'>') => return Some((at + 1, colons)),
            _ => {}
        }
    }
    None
}

/// The signs of equality in a tag, outside of values.
fn attributes(tag: &str) -> usize {
    let (mut quote, mut count) = (None, 0);
    for byte in tag.bytes() {
        match (quote, byte) {
            (Some(open), _) if open == byte => quote = None,
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b'=') => count += 1,
            _ => {}
        }
    }
    count
}

/// The words on both sides of a colon.
fn around(tag: &str, colon: usize) -> (&str, &str) {
    let ends = |c: char| c.is_whitespace() || "<>/='\":".contains(c);
    let before = tag[..colon].rsplit(ends).next();
    (before.unwrap_or_default(), tag[colon + 1..].split(ends).next().unwrap_or_default())
}
