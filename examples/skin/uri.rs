//! Where the bytes of a buffer are: in the URI itself, or in a file next to that which names it.

use std::path::{Path, PathBuf};

/// The bytes of a data URI; `None` if `uri` is none, an error if it is a broken one.
pub(crate) fn data(uri: &str) -> Option<Result<Vec<u8>, &'static str>> {
    let Some((kind, data)) = uri.strip_prefix("data:")?.split_once(',') else {
        return Some(Err("a data URI without data"));
    };
    Some(if kind.ends_with(";base64") {
        base64(data).ok_or("bad base64")
    } else {
        decoded(data).ok_or("a bad data URI")
    })
}

/// The file of a relative URI in the file `of`.
pub(crate) fn file(uri: &str, of: &Path) -> Result<PathBuf, &'static str> {
    if uri.contains("://") {
        return Err("its URI is none of a file");
    }
    let name = decoded(uri).and_then(|bytes| String::from_utf8(bytes).ok());
    Ok(of.with_file_name(name.ok_or("its URI is broken")?))
}

/// Two hexadecimal digits after a percent sign are a byte (RFC 3986, §2.1).
fn decoded(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        let mut digit = || char::from(rest.next()?).to_digit(16);
        bytes.push(if byte == b'%' { (16 * digit()? + digit()?) as u8 } else { byte });
    }
    Some(bytes)
}

fn base64(text: &str) -> Option<Vec<u8>> {
    let (mut bytes, mut bits, mut held) = (Vec::new(), 0_u32, 0);
    for letter in text.trim_end_matches('=').bytes() {
        let value = match letter {
            b'A'..=b'Z' => letter - b'A',
            b'a'..=b'z' => letter - b'a' + 26,
            b'0'..=b'9' => letter - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => return None,
        };
        (bits, held) = ((bits << 6 | u32::from(value)) & 0xff_ffff, held + 6);
        if held >= 8 {
            held -= 8;
            bytes.push((bits >> held) as u8);
        }
    }
    Some(bytes)
}
