//! The appended section of a VTP file, cut out because raw numbers are not valid XML.

use crate::io::ReadMeshError;
use crate::io::mesh_draft::FilePosition;

/// The bytes after the underscore, and how they are encoded.
#[derive(Clone, Copy, Debug)]
pub(super) struct Appended<'a> {
    pub(super) bytes: &'a [u8],
    /// Where in the file they begin.
    pub(super) start: usize,
    pub(super) base64: bool,
}

/// The XML without the content of its appended section, and that content, if there is one.
pub(super) fn cut_appended(bytes: &[u8]) -> Result<(Vec<u8>, Option<Appended<'_>>), ReadMeshError> {
    const OPEN: &[u8] = b"<AppendedData";
    const CLOSE: &[u8] = b"</AppendedData";
    let Some(open) = find(bytes, OPEN) else {
        return Ok((bytes.to_vec(), None));
    };
    let unfinished =
        || FilePosition::Byte(bytes.len()).error("the file ends within its appended data");
    let tag_end = open + find(&bytes[open..], b">").ok_or_else(unfinished)? + 1;
    if bytes[..tag_end].ends_with(b"/>") {
        return Ok((bytes.to_vec(), None));
    }
    let underscore = find(&bytes[tag_end..], b"_")
        .filter(|&at| bytes[tag_end..tag_end + at].trim_ascii().is_empty())
        .ok_or_else(|| {
            FilePosition::Byte(tag_end).error("appended data do not begin with \"_\"")
        })?;
    let start = tag_end + underscore + 1;
    let close = bytes[start..]
        .windows(CLOSE.len())
        .rposition(|window| window == CLOSE)
        .ok_or_else(unfinished)?;
    let base64 = match &bytes[open..tag_end] {
        tag if find(tag, b"\"raw\"").is_some() || find(tag, b"'raw'").is_some() => false,
        tag if find(tag, b"base64").is_some() => true,
        _ => return Err(FilePosition::Byte(open).error("appended data are neither raw nor base64")),
    };
    let xml = [&bytes[..tag_end], &bytes[start + close..]].concat();
    let appended = Appended {
        bytes: &bytes[start..start + close],
        start,
        base64,
    };
    Ok((xml, Some(appended)))
}

fn find(bytes: &[u8], pattern: &[u8]) -> Option<usize> {
    bytes
        .windows(pattern.len())
        .position(|window| window == pattern)
}
