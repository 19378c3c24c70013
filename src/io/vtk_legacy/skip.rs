//! Passing over what legacy VTK files hold beside the surface: field arrays and metadata.

use super::cursor::{LegacyCursor, scalar};
use crate::io::ReadMeshError;
use crate::io::mesh_draft::FilePosition;

/// Passes over a FIELD from behind its keyword on: its name, and so many named arrays, each perhaps with metadata.
pub(super) fn skip_field(cursor: &mut LegacyCursor<'_>) -> Result<(), ReadMeshError> {
    cursor.word("the name of a field")?;
    let arrays = cursor.count()?;
    cursor.begin_numbers();
    for _ in 0..arrays {
        while cursor.comes(b"METADATA") {
            cursor.word("metadata")?;
            skip_metadata(cursor);
        }
        cursor.word("an array of a field")?;
        let values = cursor.count()?.saturating_mul(cursor.count()?);
        let (kind, place) = cursor.word("a type")?;
        skip_array(cursor, values, &kind.to_ascii_lowercase(), place)?;
    }
    Ok(())
}

fn skip_array(
    cursor: &mut LegacyCursor<'_>,
    values: u64,
    kind: &[u8],
    place: FilePosition,
) -> Result<(), ReadMeshError> {
    if kind == b"string" || cursor.is_binary() {
        cursor.line();
    }
    match (kind, cursor.is_binary()) {
        (b"string", true) => {
            for _ in 0..values {
                skip_binary_string(cursor)?;
            }
        }
        (b"string", false) => {
            for _ in 0..values {
                if cursor.rest().is_empty() {
                    return Err(cursor.place().error("the file ends within a field"));
                }
                cursor.line();
            }
        }
        (b"bit", true) => {
            cursor.take(values.div_ceil(8), "a field")?;
        }
        (_, true) => {
            let bytes = values.saturating_mul(scalar(kind, place)?.size() as u64);
            cursor.take(bytes, "a field")?;
        }
        (_, false) => {
            for _ in 0..values {
                cursor.word("a number of a field")?;
            }
        }
    }
    Ok(())
}

/// A string has its length before it, in 1, 2, 4 or 8 bytes as the two highest bits say.
fn skip_binary_string(cursor: &mut LegacyCursor<'_>) -> Result<(), ReadMeshError> {
    let first = cursor.rest().first().copied().unwrap_or_default();
    let bytes = match first >> 6 {
        3 => 1,
        2 => 2,
        1 => 4,
        _ => 8,
    };
    let length = cursor.take(bytes, "the length of a string")?;
    let length = length
        .iter()
        .enumerate()
        .fold(0_u64, |length, (at, &byte)| {
            let byte = if at == 0 { byte & 0x3f } else { byte };
            length << 8 | u64::from(byte)
        });
    cursor.take(length, "a string")?;
    Ok(())
}

/// Passes over metadata from behind their keyword on. They end with an empty line; or where a section begins, if somebody took the empty lines out.
pub(super) fn skip_metadata(cursor: &mut LegacyCursor<'_>) {
    const SECTIONS: [&[u8]; 11] = [
        b"POINTS",
        b"VERTICES",
        b"LINES",
        b"POLYGONS",
        b"TRIANGLE_STRIPS",
        b"CELLS",
        b"CELL_TYPES",
        b"POINT_DATA",
        b"CELL_DATA",
        b"CONNECTIVITY",
        b"FIELD",
    ];
    cursor.line();
    while !cursor.rest().is_empty()
        && !SECTIONS.iter().any(|section| cursor.comes_on_line(section))
        && !cursor.line().is_empty()
    {}
}
