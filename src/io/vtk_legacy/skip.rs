//! Passing over what legacy VTK files hold beside the surface: field arrays and metadata.

use super::cursor::{LegacyCursor, scalar};
use crate::io::ReadMeshError;
use crate::io::mesh_draft::Place;
use crate::io::text_lines::count;

/// Passes over `arrays` named arrays of a FIELD.
pub(super) fn skip_field(cursor: &mut LegacyCursor<'_>, arrays: u64) -> Result<(), ReadMeshError> {
    for _ in 0..arrays {
        let end = cursor.place();
        let Some((place, words)) = cursor.keyword_line() else {
            return Err(end.error("the file ends within a field"));
        };
        if words.first() == Some(&&b"METADATA"[..]) {
            skip_metadata(cursor);
            continue;
        }
        let [_, components, tuples, kind] = words[..] else {
            return Err(place.error("an array of a field needs a name, two counts and a type"));
        };
        let values = count(components, place)?.saturating_mul(count(tuples, place)?);
        skip_array(cursor, values, kind, place)?;
    }
    Ok(())
}

fn skip_array(
    cursor: &mut LegacyCursor<'_>,
    values: u64,
    kind: &[u8],
    place: Place,
) -> Result<(), ReadMeshError> {
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

/// Metadata end with an empty line.
pub(super) fn skip_metadata(cursor: &mut LegacyCursor<'_>) {
    while !cursor.rest().is_empty() && !cursor.line().is_empty() {}
}
