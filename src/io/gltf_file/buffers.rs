//! The bytes that a glTF file's numbers are in: its own chunk, data URIs, or files beside it.

use std::borrow::Cow;
use std::collections::HashMap;
use std::rc::Rc;

use base64::Engine;
use base64::alphabet::STANDARD as STANDARD_ALPHABET;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig};
use gltf::Document;
use gltf::buffer::Source;

use crate::io::text_lines::shown;
use crate::io::{Limits, ReadMeshError};

/// One buffer.
#[derive(Clone)]
pub(super) struct Buffer<'a> {
    /// Shared by all buffers that are the same file.
    pub(super) bytes: Rc<Cow<'a, [u8]>>,
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

/// Brings all buffers, each file once, however many buffers name it.
pub(super) fn load_buffers<'a>(
    document: &Document,
    binary_chunk: Option<(&'a [u8], usize)>,
    limits: &Limits,
    sibling: &dyn Fn(&str) -> Option<Vec<u8>>,
) -> Result<Vec<Buffer<'a>>, ReadMeshError> {
    let mut buffers: Vec<Buffer<'_>> = Vec::new();
    let mut files: HashMap<String, Buffer<'_>> = HashMap::new();
    let mut total = 0_u64;
    for buffer in document.buffers() {
        let item = format!("buffers[{}]", buffer.index());
        let (bytes, start, name) = match buffer.source() {
            Source::Bin => {
                let (bytes, start) = binary_chunk.ok_or_else(|| {
                    in_item(&item, "has no uri, and the file has no binary chunk")
                })?;
                (Cow::Borrowed(bytes), Some(start), None)
            }
            Source::Uri(uri) => match data_of_uri(uri, &item)? {
                Some(bytes) => (Cow::Owned(bytes), None, None),
                None => {
                    let names = file_names(uri, &item)?;
                    let known = names.iter().find_map(|name| files.get(name));
                    if let Some(known) = known.filter(|it| it.bytes.len() >= buffer.length()) {
                        buffers.push(known.clone());
                        continue;
                    }
                    let (name, bytes) = load_file(names, &item, sibling)?;
                    (Cow::Owned(bytes), None, Some(name))
                }
            },
        };
        if bytes.len() < buffer.length() {
            let reason = format!("{} bytes, but {} announced", bytes.len(), buffer.length());
            return Err(in_item(item, reason));
        }
        total += bytes.len() as u64;
        if total > limits.file_bytes {
            return Err(ReadMeshError::TooLarge {
                size: total,
                most: limits.file_bytes,
            });
        }
        let bytes = Rc::new(bytes);
        let loaded = Buffer { bytes, start };
        files.extend(name.map(|name| (name, loaded.clone())));
        buffers.push(loaded);
    }
    Ok(buffers)
}

/// The content of a `data:` uri of any type; none for other uris.
fn data_of_uri(uri: &str, item: &str) -> Result<Option<Vec<u8>>, ReadMeshError> {
    let is_data = uri
        .get(..5)
        .is_some_and(|scheme| scheme.eq_ignore_ascii_case("data:"));
    if !is_data {
        return Ok(None);
    }
    let (kind, text) = uri
        .split_once(',')
        .ok_or_else(|| in_item(item, "a data uri without a comma"))?;
    let bytes = if text.contains('%') {
        Cow::Owned(percent_decoded(text))
    } else {
        Cow::Borrowed(text.as_bytes())
    };
    if !kind.to_ascii_lowercase().ends_with(";base64") {
        return Ok(Some(bytes.into_owned()));
    }
    let mut text = bytes.into_owned();
    text.retain(|b| !b.is_ascii_whitespace());
    BASE64
        .decode(&text)
        .map(Some)
        .map_err(|error| in_item(item, format!("not valid base64: {error}")))
}

/// With or without the `=` at the end that some programs leave away.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD_ALPHABET,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// The names that a uri may mean, as `/` and words alone: decoded, and as it stands. Both stay in the folder.
fn file_names(uri: &str, item: &str) -> Result<Vec<String>, ReadMeshError> {
    let decoded = String::from_utf8_lossy(&percent_decoded(uri)).into_owned();
    let mut names: Vec<String> = Vec::new();
    for name in [decoded, uri.to_owned()] {
        let name = name.replace('\\', "/");
        let parts: Vec<&str> = name.split('/').collect();
        if name.starts_with('/') || name.contains(':') || parts.contains(&"..") {
            let reason = format!("{} is not a file in the same folder", shown(uri.as_bytes()));
            return Err(in_item(item, reason));
        }
        let own = parts
            .into_iter()
            .filter(|part| !part.is_empty() && *part != ".");
        let name = own.collect::<Vec<_>>().join("/");
        if !names.contains(&name) {
            names.push(name);
        }
    }
    Ok(names)
}

/// The first of these files that can be read, with its name.
fn load_file(
    names: Vec<String>,
    item: &str,
    sibling: &dyn Fn(&str) -> Option<Vec<u8>>,
) -> Result<(String, Vec<u8>), ReadMeshError> {
    let first = names.first().cloned().unwrap_or_default();
    let mut found = names.into_iter().filter_map(|name| {
        let bytes = sibling(&name)?;
        Some((name, bytes))
    });
    found.next().ok_or_else(|| {
        in_item(
            item,
            format!(
                "the file {} in the same folder is needed and cannot be read; a .glb file holds everything",
                shown(first.as_bytes())
            ),
        )
    })
}

/// `%20` and the like as the characters that they stand for.
fn percent_decoded(uri: &str) -> Vec<u8> {
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
    decoded
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_decoded_and_stay_beside_the_file() {
        assert_eq!(percent_decoded("a%20b%2"), b"a b%2");
        let names = |uri: &str| file_names(uri, "buffers[0]");
        for (uri, expected) in [
            ("heart%201.bin", &["heart 1.bin", "heart%201.bin"][..]),
            ("./heart.bin", &["heart.bin"]),
            (".//a/./heart.bin", &["a/heart.bin"]),
            ("a\\heart.bin", &["a/heart.bin"]),
            ("herz%C3%BC.bin", &["herzü.bin", "herz%C3%BC.bin"]),
            ("50%.bin", &["50%.bin"]),
        ] {
            assert_eq!(names(uri).unwrap(), expected, "{uri}");
        }
        for outside in [
            "../x.bin",
            "/etc/passwd",
            "a/%2e%2e/b",
            "http://x/y",
            "c:\\x",
            "..\\x",
        ] {
            assert!(names(outside).is_err(), "{outside}");
        }
    }

    #[test]
    fn data_uris_of_any_type_are_read() {
        let data = |uri: &str| data_of_uri(uri, "buffers[0]");
        for uri in [
            "data:;base64,AAEC",
            "data:base64,%00%01%02",
            "data:application/octet-stream;base64,AAEC",
            "data:application/gltf-buffer;charset=x;base64,AA EC",
            "DATA:text/plain;BASE64,AAE%43",
            "data:,%00%01%02",
        ] {
            assert_eq!(data(uri).unwrap(), Some(vec![0, 1, 2]), "{uri}");
        }
        assert_eq!(data("data:;base64,AAE").unwrap(), Some(vec![0, 1]));
        assert_eq!(data("data:;base64,AAE=").unwrap(), Some(vec![0, 1]));
        assert_eq!(data("data.bin").unwrap(), None);
        for wrong in ["data:;base64", "data:;base64,A*EC"] {
            assert!(data(wrong).is_err(), "{wrong}");
        }
    }
}
