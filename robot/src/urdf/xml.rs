//! The text of a URDF file. The functions here decode its bytes, and convert the text to strict
//! XML.

use super::error::{UrdfError, UrdfWarning};
use std::borrow::Cow;

/// The text of a file, decoded from its bytes, and facts about the decoding.
struct Decoded<'b> {
    text: Cow<'b, str>,
    /// The name of the encoding from which the text was decoded.
    encoding: &'static str,
    /// `true` if some bytes are not valid in the encoding.
    failed: bool,
    /// `true` if the XML declaration names a known encoding.
    is_known: bool,
}

/// Decodes the bytes in the encoding of the byte order mark, else in the declared encoding, else as
/// UTF-8. Bytes that are not valid in that encoding become U+FFFD. They give a warning and no
/// error, as most readers of URDF ignore the encoding.
pub(crate) fn text(bytes: &[u8]) -> Result<(Cow<'_, str>, Option<UrdfWarning>), UrdfError> {
    let declared = declared(bytes).unwrap_or(b"UTF-8");
    let name = String::from_utf8_lossy(declared);
    let Some(Decoded { text, encoding, failed, is_known }) = decoded(bytes, declared) else {
        return Err(UrdfError::Encoding { encoding: name.into_owned() });
    };
    let what = match text.find('\u{fffd}').filter(|_| failed) {
        Some(at) => Some((at, format!("bytes that are not {encoding} are read as \u{fffd}"))),
        None => (!is_known).then(|| {
            (0, format!("the encoding {name:?} is unknown, so the file is read as UTF-8"))
        }),
    };
    let warning = what.map(|(at, text_of)| UrdfWarning {
        line: 1 + text[..at].matches('\n').count() as u32,
        element: "<?xml?>".into(),
        text: text_of,
    });
    Ok((text, warning))
}

#[cfg(feature = "urdf-encodings")]
fn decoded<'b>(bytes: &'b [u8], declared: &[u8]) -> Option<Decoded<'b>> {
    use encoding_rs::{Encoding, UTF_8};
    let known = Encoding::for_label_no_replacement(declared);
    // The declaration could be read as ASCII, so the text is not in UTF-16, even if the declaration
    // says so.
    let ascii = known.filter(|encoding| encoding.is_ascii_compatible()).unwrap_or(UTF_8);
    let (text, encoding, failed) = ascii.decode(bytes);
    Some(Decoded { text, encoding: encoding.name(), failed, is_known: known.is_some() })
}

/// Returns `None` if the text declares an encoding other than UTF-8 and UTF-16 and is not valid
/// UTF-8. Valid UTF-8 is read as UTF-8 whatever the file declares, because text in another encoding
/// is hardly ever valid UTF-8 by chance.
#[cfg(not(feature = "urdf-encodings"))]
fn decoded<'b>(bytes: &'b [u8], declared: &[u8]) -> Option<Decoded<'b>> {
    // A byte order mark takes precedence over the declaration, as it also does when the feature
    // `urdf-encodings` is on.
    let declared = declared.trim_ascii();
    let unicode = ["utf-8", "utf8", "utf-16", "utf-16le", "utf-16be"].map(str::as_bytes);
    match bytes {
        [0xff, 0xfe, rest @ ..] => Some(utf16("UTF-16LE", rest, u16::from_le_bytes)),
        [0xfe, 0xff, rest @ ..] => Some(utf16("UTF-16BE", rest, u16::from_be_bytes)),
        [0xef, 0xbb, 0xbf, rest @ ..] => Some(utf8(rest)),
        _ if bytes.is_ascii() => Some(utf8(bytes)),
        _ if unicode.iter().any(|name| declared.eq_ignore_ascii_case(name)) => Some(utf8(bytes)),
        _ => Some(utf8(bytes))
            .filter(|read| !read.failed)
            .map(|read| Decoded { is_known: false, ..read }),
    }
}

#[cfg(not(feature = "urdf-encodings"))]
fn utf8(bytes: &[u8]) -> Decoded<'_> {
    let text = String::from_utf8_lossy(bytes);
    let failed = matches!(text, Cow::Owned(_));
    Decoded { text, encoding: "UTF-8", failed, is_known: true }
}

#[cfg(not(feature = "urdf-encodings"))]
fn utf16(encoding: &'static str, bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Decoded<'static> {
    let (pairs, rest) = bytes.as_chunks();
    let mut failed = !rest.is_empty();
    let units = char::decode_utf16(pairs.iter().map(|&pair| unit(pair)));
    let mut text: String = units
        .map(|unit| {
            failed |= unit.is_err();
            unit.unwrap_or(char::REPLACEMENT_CHARACTER)
        })
        .collect();
    text.extend((!rest.is_empty()).then_some(char::REPLACEMENT_CHARACTER));
    Decoded { text: text.into(), encoding, failed, is_known: true }
}

/// Returns the encoding that the XML declaration names. Comments may stand before the declaration.
fn declared(bytes: &[u8]) -> Option<&[u8]> {
    let mut rest = bytes.trim_ascii_start();
    while let Some(comment) = rest.strip_prefix(b"<!--") {
        rest = after(comment, b"-->")?.trim_ascii_start();
    }
    let declaration = rest.strip_prefix(b"<?xml")?;
    let end = declaration.len() - after(declaration, b"?>")?.len();
    let value = after(&declaration[..end], b"encoding")?.trim_ascii_start().strip_prefix(b"=")?;
    let (quote, value) = value.trim_ascii_start().split_first()?;
    let end = value.iter().position(|byte| byte == quote)?;
    Some(&value[..end])
}

/// Returns the bytes after the first occurrence of `end`.
fn after<'b>(bytes: &'b [u8], end: &[u8]) -> Option<&'b [u8]> {
    let at = bytes.windows(end.len()).position(|window| window == end)?;
    Some(&bytes[at + end.len()..])
}

/// The greatest depth of nested elements that is read. TinyXML, which most readers of URDF use, has
/// the same limit.
const DEPTH: usize = 500;
/// The greatest count of attributes of an element that is read. The strict XML reader compares each
/// attribute with all others, which takes seconds for half a megabyte of attributes. No element of
/// URDF has more than seven.
const ATTRIBUTES: usize = 1000;

/// Converts the text for a strict reader of XML, and keeps its line numbers: declarations, comments
/// and the document type are removed, and every prefix is declared. This is needed because other
/// readers of URDF are not strict. They skip declarations and comments at any place, and ignore
/// namespaces.
pub(crate) fn strict(text: &str) -> Result<String, UrdfError> {
    // Some editors leave a byte order mark at the beginning, or NUL or Ctrl-Z at the end.
    let text = text.trim_start_matches('\u{feff}').trim_end_matches(['\0', '\u{1a}']);
    let mut out = String::with_capacity(text.len());
    let (mut used, mut declared) = (Vec::new(), Vec::new());
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
            // The remaining text is not XML, so the strict reader will return an error for it.
            break;
        };
        let (tag, after) = rest.split_at(length);
        if !section {
            let name = tag.find(|c: char| c.is_whitespace() || c == '>').unwrap_or(length);
            let name = tag[..name].trim_end_matches('/');
            for (prefix, local) in colons.into_iter().map(|colon| around(tag, colon)) {
                match (prefix, root) {
                    ("xmlns", None) => declared.push(local),
                    ("xmlns" | "xml" | "", _) => continue,
                    _ => used.push(prefix),
                };
            }
            root.get_or_insert(out.len() + name.len());
            if tag.starts_with("</") {
                depth = depth.saturating_sub(1);
            } else if !tag.ends_with("/>") {
                depth += 1;
            }
            let what = match tag.matches('=').count() {
                _ if depth > DEPTH => format!("elements are nested more than {DEPTH} deep"),
                // Some of the counted signs of equality may stand inside attribute values, so the
                // attributes are now counted exactly.
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
    for names in [&mut used, &mut declared] {
        names.sort_unstable();
        names.dedup();
    }
    used.retain(|prefix| declared.binary_search(prefix).is_err());
    let unknown = used;
    let root = root.unwrap_or_default();
    // The declarations of prefixes become attributes of the root, and the strict reader searches
    // all of them for each name. Their count is limited, so that this search stays quick.
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

/// Returns the length of the comment, declaration or document type with which the text begins, if
/// it begins with one.
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

/// Returns the length of the text up to and including the first `end`.
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

/// Returns the length of the tag with which the text begins, and the positions of colons in it
/// outside of attribute values.
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

/// Counts the attributes of a tag: its signs of equality outside of attribute values.
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

/// Returns the words on both sides of a colon: a prefix and a name.
fn around(tag: &str, colon: usize) -> (&str, &str) {
    let ends = |c: char| c.is_whitespace() || "<>/='\":".contains(c);
    let before = tag[..colon].rsplit(ends).next();
    (before.unwrap_or_default(), tag[colon + 1..].split(ends).next().unwrap_or_default())
}
