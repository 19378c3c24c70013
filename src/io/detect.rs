//! Which format a file has, by its content and its extension.

use super::formats::{FORMATS, Format, Head, Source, format_of_extension, mesh_format_names};
use super::mesh_draft::FilePosition;
use super::stl::is_whole_binary_stl;
use super::text_encoding::without_mark;
use super::{Limits, MeshFile, ReadMeshError};
use crate::study::Notice;

/// Reads one file, of which `file_name` only serves to tell the format by its ending.
///
/// Content that clearly is another format than the ending says is read as what it is, with a
/// note. A glTF file that keeps its numbers in other files needs [`read_mesh_with_siblings`].
///
/// # Errors
/// With the line or byte that is wrong, and why.
pub fn read_mesh(
    file_name: &str,
    bytes: &[u8],
    limits: &Limits,
) -> Result<MeshFile, ReadMeshError> {
    read_mesh_with_siblings(file_name, bytes, limits, &|_| None)
}

/// As [`read_mesh`]; `sibling` returns the content of a file beside this one by its name
/// (a relative path without `..`), or `None` if there is none.
///
/// # Errors
/// As [`read_mesh`].
pub fn read_mesh_with_siblings(
    file_name: &str,
    bytes: &[u8],
    limits: &Limits,
    sibling: &dyn Fn(&str) -> Option<Vec<u8>>,
) -> Result<MeshFile, ReadMeshError> {
    let size = bytes.len() as u64;
    if size > limits.file_bytes {
        return Err(ReadMeshError::TooLarge {
            size,
            most: limits.file_bytes,
        });
    }
    // faces number vertices in 32 bits
    let limits = &Limits {
        vertices: limits.vertices.min(u32::MAX as usize),
        ..*limits
    };
    let named = file_name
        .rsplit_once('.')
        .and_then(|(_, extension)| format_of_extension(extension));
    let unmarked = if is_whole_binary_stl(bytes) {
        None // its first bytes may be anything
    } else {
        Some(without_mark(bytes)?)
    };
    let content = unmarked.as_ref().map_or(bytes, |text| &text.bytes);
    if let Some(packer) = packer_of(bytes) {
        return Err(FilePosition::Byte(0).error(format!("packed by {packer}: unpack it first")));
    }
    let format =
        format_of_content(content)
            .or(named)
            .ok_or_else(|| ReadMeshError::UnknownFormat {
                known: mesh_format_names().join(", "),
            })?;
    let source = Source {
        bytes: content,
        limits,
        sibling,
    };
    let mut file = (format.read)(&source).map_err(|error| {
        on_one_line(match &unmarked {
            Some(text) => text.error_in_file(error, bytes.len()),
            None => error,
        })
    })?;
    if named.is_some_and(|named| named.name != format.name) {
        file.notices.push(Notice::info(format!(
            "read as {} by its content, despite its file name extension",
            format.name
        )));
    }
    Ok(file)
}

/// Reasons of other crates quote the file: without what a screen cannot show, and not endless.
fn on_one_line(mut error: ReadMeshError) -> ReadMeshError {
    const MAX_CHARS: usize = 240;
    let shown = |text: &mut String| {
        *text = text
            .chars()
            .take(MAX_CHARS)
            .map(|c| if c.is_control() { '\u{fffd}' } else { c })
            .collect();
    };
    match &mut error {
        ReadMeshError::AtLine { reason, .. } | ReadMeshError::AtByte { reason, .. } => {
            shown(reason);
        }
        ReadMeshError::InItem { item, reason } => {
            shown(item);
            shown(reason);
        }
        _ => {}
    }
    error
}

/// The program that packed a file with these first bytes.
fn packer_of(bytes: &[u8]) -> Option<&'static str> {
    let packers: [(&[u8], &str); 5] = [
        (b"\x1f\x8b", "gzip"),
        (b"PK\x03\x04", "zip"),
        (b"BZh", "bzip2"),
        (b"\xfd7zXZ", "xz"),
        (b"\x28\xb5\x2f\xfd", "zstd"),
    ];
    let found = packers
        .into_iter()
        .find(|(begin, _)| bytes.starts_with(begin));
    found
        .map(|(_, packer)| packer)
        .filter(|_| !is_whole_binary_stl(bytes))
}

/// The format whose first bytes these are.
fn format_of_content(bytes: &[u8]) -> Option<&'static Format> {
    /// Longest start of a text that formats are recognised by.
    const HEAD: usize = 1024;
    let head = Head {
        bytes,
        text: bytes[..bytes.len().min(HEAD)].trim_ascii_start(),
    };
    FORMATS.iter().find(|format| (format.recognises)(&head))
}
