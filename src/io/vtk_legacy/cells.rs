//! Cells of legacy VTK files in both layouts: counts before corners (up to version 4.2), and
//! offsets apart from corners (from version 5).

use super::cursor::{LegacyCursor, scalar};
use crate::io::ReadMeshError;
use crate::io::binary_cursor::{Scalar, count, vertex_index};
use crate::io::mesh_draft::Place;

/// Called with the corners of each cell and where it stands.
pub(super) type EachCell<'f> = &'f mut dyn FnMut(&[u32], Place) -> Result<(), ReadMeshError>;

/// How many cells the first number after a keyword announces: files of version 5 count offsets,
/// one more than cells.
pub(super) fn cell_count(cursor: &LegacyCursor<'_>, first: u64) -> u64 {
    if has_offsets(cursor) {
        first.saturating_sub(1)
    } else {
        first
    }
}

fn has_offsets(cursor: &LegacyCursor<'_>) -> bool {
    cursor.rest().trim_ascii_start().starts_with(b"OFFSETS")
}

/// Reads cells after a keyword with the two numbers `first` and `second`.
pub(super) fn read_cells(
    cursor: &mut LegacyCursor<'_>,
    first: u64,
    second: u64,
    each: EachCell<'_>,
) -> Result<(), ReadMeshError> {
    if has_offsets(cursor) {
        read_with_offsets(cursor, first, second, each)
    } else {
        read_with_counts(cursor, first, second, each)
    }
}

/// `first` cells of `second` numbers in all: each a count and as many corners.
fn read_with_counts(
    cursor: &mut LegacyCursor<'_>,
    cells: u64,
    numbers: u64,
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
    each: EachCell<'_>,
) -> Result<(), ReadMeshError> {
    let kind = array_type(cursor, b"OFFSETS")?;
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
        ends.push(offset);
    }
    if ends.last().copied().unwrap_or_default() != corner_count {
        let reason = format!("the last offset is not the number of corners, {corner_count}");
        return Err(cursor.place().error(reason));
    }
    let kind = array_type(cursor, b"CONNECTIVITY")?;
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

fn array_type(cursor: &mut LegacyCursor<'_>, keyword: &[u8]) -> Result<Scalar, ReadMeshError> {
    let end = cursor.place();
    match cursor.keyword_line() {
        Some((place, words)) if words.len() == 2 && words[0] == keyword => scalar(words[1], place),
        other => Err(other.map_or(end, |(place, _)| place).error(format!(
            "{} and a type are expected here",
            String::from_utf8_lossy(keyword)
        ))),
    }
}
