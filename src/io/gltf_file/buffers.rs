//! The bytes that a glTF file's numbers are in: its own chunk, data URIs, or files beside it.

use std::borrow::Cow;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use gltf::Document;
use gltf::buffer::Source;

use crate::io::text_lines::shown;
use crate::io::{Limits, ReadMeshError};

/// One buffer.
pub(super) struct Buffer<'a> {
    pub(super) bytes: Cow<'a, [u8]>,
    /// The byte of the file at which it begins, if it is in the file as it stands.
    pub(super) start: Option<usize>,
}

/// An error about part of a file.
pub(super) fn in_item(item: impl Into<String>, reason: impl Into<String>) -> ReadMeshError {
    ReadMeshError::InItem {
        item: item.into(),
        reason: reason.into(),
    }
}

/// Brings all buffers.
pub(super) fn load_buffers<'a>(
    document: &Document,
    binary_chunk: Option<(&'a [u8], usize)>,
    limits: &Limits,
    sibling: &dyn Fn(&str) -> Option<Vec<u8>>,
) -> Result<Vec<Buffer<'a>>, ReadMeshError> {
    let mut buffers = Vec::new();
    let mut total = 0_u64;
    for buffer in document.buffers() {
        let item = format!("buffers[{}]", buffer.index());
        let loaded = match buffer.source() {
            Source::Bin => {
                let (bytes, start) = binary_chunk.ok_or_else(|| {
                    in_item(&item, "has no uri, and the file has no binary chunk")
                })?;
                Buffer {
                    bytes: Cow::Borrowed(bytes),
                    start: Some(start),
                }
            }
            Source::Uri(uri) => Buffer {
                bytes: Cow::Owned(load_uri(uri, &item, sibling)?),
                start: None,
            },
        };
        if loaded.bytes.len() < buffer.length() {
            return Err(in_item(
                item,
                format!(
                    "{} bytes, but {} announced",
                    loaded.bytes.len(),
                    buffer.length()
                ),
            ));
        }
        total += loaded.bytes.len() as u64;
        if total > limits.file_bytes.saturating_mul(2) {
            return Err(ReadMeshError::TooLarge {
                size: total,
                most: limits.file_bytes.saturating_mul(2),
            });
        }
        buffers.push(loaded);
    }
    Ok(buffers)
}

fn load_uri(
    uri: &str,
    item: &str,
    sibling: &dyn Fn(&str) -> Option<Vec<u8>>,
) -> Result<Vec<u8>, ReadMeshError> {
    if let Some(rest) = uri.strip_prefix("data:") {
        let text = rest.split_once(";base64,").map(|(_, text)| text);
        let text = text.ok_or_else(|| in_item(item, "a data uri that is not base64"))?;
        return STANDARD
            .decode(text)
            .map_err(|error| in_item(item, format!("not valid base64: {error}")));
    }
    let name = percent_decoded(uri);
    let outside = name.starts_with('/')
        || name.contains([':', '\\'])
        || name.split('/').any(|part| part == "..");
    if outside {
        let reason = format!("{} is not a file in the same folder", shown(uri.as_bytes()));
        return Err(in_item(item, reason));
    }
    sibling(&name).ok_or_else(|| {
        in_item(
            item,
            format!(
                "the file {} in the same folder is needed and cannot be read; a .glb file holds everything",
                shown(name.as_bytes())
            ),
        )
    })
}

/// `%20` and the like as the characters that they stand for.
fn percent_decoded(uri: &str) -> String {
    let bytes = uri.as_bytes();
    let mut decoded = Vec::with_capacity(bytes.len());
    let mut at = 0;
    while at < bytes.len() {
        let hex = (bytes[at] == b'%')
            .then(|| bytes.get(at + 1..at + 3))
            .flatten()
            .and_then(|hex| std::str::from_utf8(hex).ok())
            .and_then(|hex| u8::from_str_radix(hex, 16).ok());
        decoded.push(hex.unwrap_or(bytes[at]));
        at += if hex.is_some() { 3 } else { 1 };
    }
    String::from_utf8_lossy(&decoded).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_percent_decoded_and_stay_beside_the_file() {
        assert_eq!(percent_decoded("a%20b%2"), "a b%2");
        let asked = |uri: &str| load_uri(uri, "buffers[0]", &|name| Some(name.as_bytes().to_vec()));
        assert_eq!(asked("heart%201.bin").unwrap(), b"heart 1.bin");
        for outside in [
            "../x.bin",
            "/etc/passwd",
            "a/%2e%2e/b",
            "http://x/y",
            "c:\\x",
        ] {
            assert!(asked(outside).is_err(), "{outside}");
        }
    }
}
