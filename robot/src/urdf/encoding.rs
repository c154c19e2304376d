//! The text in the bytes of a file.

use super::error::UrdfError;
use super::warning::UrdfWarning;
use std::borrow::Cow;

/// Bytes as text.
struct Decoded<'b> {
    text: Cow<'b, str>,
    /// The name of the encoding.
    encoding: &'static str,
    /// `true` if some bytes are not in it.
    failed: bool,
    /// `true` if the name that is declared is that of an encoding.
    is_known: bool,
}

/// By the byte order mark, or else as the declaration says, or else UTF-8. What is not in that
/// encoding becomes U+FFFD, with a warning: most readers of URDF do not look at the encoding at
/// all.
pub(crate) fn text(bytes: &[u8]) -> Result<(Cow<'_, str>, Option<UrdfWarning>), UrdfError> {
    let declared = declared(bytes).unwrap_or(b"UTF-8");
    let name = String::from_utf8_lossy(declared);
    let Some(Decoded { text, encoding, failed, is_known }) = decoded(bytes, declared) else {
        return Err(UrdfError::Encoding { encoding: name.into_owned() });
    };
    let what = match text.find('\u{fffd}').filter(|_| failed) {
        Some(at) => Some((at, format!("bytes that are not {encoding} are read as \u{fffd}"))),
        None => {
            (!is_known).then(|| (0, format!("the encoding {name:?} is unknown and read as UTF-8")))
        }
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
    // A declaration that can be read as ASCII is not in UTF-16, whatever it says.
    let ascii = known.filter(|encoding| encoding.is_ascii_compatible()).unwrap_or(UTF_8);
    let (text, encoding, failed) = ascii.decode(bytes);
    Some(Decoded { text, encoding: encoding.name(), failed, is_known: known.is_some() })
}

/// None in an encoding that is neither UTF-8 nor UTF-16, if it matters in which: text of others is
/// hardly ever UTF-8 by chance.
#[cfg(not(feature = "urdf-encodings"))]
fn decoded<'b>(bytes: &'b [u8], declared: &[u8]) -> Option<Decoded<'b>> {
    // A byte order mark counts more than the declaration, as with the feature.
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
