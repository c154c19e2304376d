//! The text in the bytes of a file.

use super::warning::UrdfWarning;
use encoding_rs::{Encoding, UTF_8};
use std::borrow::Cow;

/// By the byte order mark, or else as the declaration says, or else UTF-8. What is not in that encoding becomes U+FFFD,
/// with a warning: most readers of URDF do not look at the encoding at all.
pub(crate) fn text(bytes: &[u8]) -> (Cow<'_, str>, Option<UrdfWarning>) {
    let declared = declared(bytes).unwrap_or(b"UTF-8");
    let known = Encoding::for_label_no_replacement(declared);
    // A declaration that can be read as ASCII is not in UTF-16, whatever it says.
    let ascii = known.filter(|encoding| encoding.is_ascii_compatible()).unwrap_or(UTF_8);
    let (text, encoding, failed) = ascii.decode(bytes);
    let name = String::from_utf8_lossy(declared);
    let what = match text.find('\u{fffd}').filter(|_| failed) {
        Some(at) => {
            Some((at, format!("bytes that are not {} are read as \u{fffd}", encoding.name())))
        }
        None => known
            .is_none()
            .then(|| (0, format!("the encoding {name:?} is unknown and read as UTF-8"))),
    };
    let warning = what.map(|(at, text_of)| UrdfWarning {
        line: 1 + text[..at].matches('\n').count() as u32,
        element: "<?xml?>".into(),
        text: text_of,
    });
    (text, warning)
}

/// The encoding that a declaration names. Comments may stand before it.
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

/// What comes after the first `end`.
fn after<'b>(bytes: &'b [u8], end: &[u8]) -> Option<&'b [u8]> {
    let at = bytes.windows(end.len()).position(|window| window == end)?;
    Some(&bytes[at + end.len()..])
}
