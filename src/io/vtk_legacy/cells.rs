//! Cells of legacy VTK files in both layouts: counts before corners (up to version 4.2), and
//! offsets apart from corners (from version 5).

use super::cursor::{LegacyCursor, scalar};
use crate::io::binary_cursor::{Scalar, count, vertex_index};
use crate::io::mesh_draft::{FilePosition, check_count};
use crate::io::{Limits, ReadMeshError};

/// Called with the corners of each cell and where it stands.
pub(super) type EachCell<'f> = &'f mut dyn FnMut(&[u32], FilePosition) -> Result<(), ReadMeshError>;

/// Reads cells from behind their keyword, `what` they are, on. Files of version 5 count offsets,
/// one more than cells.
pub(super) fn read_cells(
    cursor: &mut LegacyCursor<'_>,
    what: &'static str,
    limits: &Limits,
    each: EachCell<'_>,
) -> Result<(), ReadMeshError> {
    let (first, second) = (cursor.count()?, cursor.count()?);
    cursor.begin_numbers();
    let has_offsets = cursor.comes(b"OFFSETS");
    let cells = first.saturating_sub(u64::from(has_offsets));
    check_count(what, cells, limits.faces)?;
    // no cell has more corners than a strip of all faces
    let max_corners = limits.faces as u64 + 2;
    if has_offsets {
        read_with_offsets(cursor, first, second, max_corners, each)
    } else {
        read_with_counts(cursor, first, second, max_corners, each)
    }
}

fn check_corners(corners: u64, most: u64, place: FilePosition) -> Result<(), ReadMeshError> {
    if corners > most {
        return Err(place.error(format!("a cell of {corners} corners; the limit is {most}")));
    }
    Ok(())
}

/// `first` cells of `second` numbers in all: each a count and as many corners.
fn read_with_counts(
    cursor: &mut LegacyCursor<'_>,
    cells: u64,
    numbers: u64,
    max_corners: u64,
    each: EachCell<'_>,
) -> Result<(), ReadMeshError> {
    let mut corners = Vec::new();
    let mut numbers_left = numbers;
    for _ in 0..cells {
        let (size, place) = cursor.number(Scalar::I32, "a cell")?;
        let size = count(size, place)?;
        numbers_left = numbers_left
            .checked_sub(size.saturating_add(1))
            .ok_or_else(|| place.error(format!("cells hold more than {numbers} numbers")))?;
        check_corners(size, max_corners, place)?;
        corners.clear();
        for _ in 0..size {
            let (corner, place) = cursor.number(Scalar::I32, "a corner")?;
            corners.push(vertex_index(corner, place)?);
        }
        each(&corners, place)?;
    }
    if numbers_left > 0 {
        return Err(cursor.place().error(format!(
            "cells hold {} numbers, but {numbers} are announced",
            numbers - numbers_left
        )));
    }
    Ok(())
}

/// `offset_count` offsets, one more than cells, and `corner_count` corners.
fn read_with_offsets(
    cursor: &mut LegacyCursor<'_>,
    offset_count: u64,
    corner_count: u64,
    max_corners: u64,
    each: EachCell<'_>,
) -> Result<(), ReadMeshError> {
    let kind = array_type(cursor, "OFFSETS")?;
    let mut ends = Vec::new();
    for at in 0..offset_count {
        let (offset, place) = cursor.number(kind, "an offset")?;
        let offset = count(offset, place)?;
        let least = ends.last().copied().unwrap_or_default();
        if offset < least || offset > corner_count || (at == 0 && offset != 0) {
            return Err(place.error(format!(
                "offset {offset} is not between {least} and {corner_count}"
            )));
        }
        check_corners(offset - least, max_corners, place)?;
        ends.push(offset);
    }
    if ends.last().copied().unwrap_or_default() != corner_count {
        let reason = format!("the last offset is not the number of corners, {corner_count}");
        return Err(cursor.place().error(reason));
    }
    let kind = array_type(cursor, "CONNECTIVITY")?;
    let mut corners = Vec::new();
    for pair in ends.windows(2) {
        corners.clear();
        let mut cell_place = cursor.place();
        for at in pair[0]..pair[1] {
            let (corner, place) = cursor.number(kind, "a corner")?;
            corners.push(vertex_index(corner, place)?);
            if at == pair[0] {
                cell_place = place;
            }
        }
        each(&corners, cell_place)?;
    }
    Ok(())
}

fn array_type(cursor: &mut LegacyCursor<'_>, keyword: &str) -> Result<Scalar, ReadMeshError> {
    if !cursor.comes(keyword.as_bytes()) {
        cursor.skip_white();
        let reason = format!("{keyword} and a type are expected here");
        return Err(cursor.place().error(reason));
    }
    cursor.word(keyword)?;
    let (kind, place) = cursor.word("a type")?;
    cursor.begin_numbers();
    scalar(kind, place)
}
