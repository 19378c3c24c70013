//! Points and faces in one CSV file.
//!
//! A row is `v,x,y,z` for a vertex or `f,a,b,c` for a face (or more corners), with vertices
//! counted from 0 in the order of their rows. Faces may stand before their vertices. A first row that
//! begins with another word is a header; empty rows and rows that begin with `#` are passed over.

use csv::{ByteRecord, ReaderBuilder, Trim};

use super::mesh_draft::{MeshDraft, Place};
use super::text_lines::{count, shown, three_numbers};
use super::{Limits, MeshFile, ReadMeshError};

/// Reads rows of vertices and faces.
pub(super) fn read_csv_mesh(bytes: &[u8], limits: &Limits) -> Result<MeshFile, ReadMeshError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut rows = ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .quoting(false)
        .trim(Trim::All)
        .from_reader(bytes);
    let mut draft = MeshDraft::new(limits, 0);
    let mut row = ByteRecord::new();
    let mut corners = Vec::new();
    let mut first = true;
    while rows
        .read_byte_record(&mut row)
        .map_err(|error| Place::Line(rows_line(&row)).error(error.to_string()))?
    {
        let place = Place::Line(rows_line(&row));
        let mut cells = row.iter().filter(|cell| !cell.is_empty());
        match cells.next() {
            None => {}
            Some(b"v") => {
                draft.point(three_numbers(&mut cells, place)?, place)?;
                if cells.next().is_some() {
                    return Err(place.error("vertex has more than 3 coordinates"));
                }
            }
            Some(b"f") => {
                corners.clear();
                for cell in cells {
                    let index = count(cell, place)?;
                    corners.push(u32::try_from(index).map_err(|_| {
                        place.error(format!("{index} is not the index of a vertex"))
                    })?);
                }
                draft.polygon(&corners, place)?;
            }
            Some(_) if first => {}
            Some(word) => {
                return Err(place.error(format!(
                    "a row begins with {}, but \"v\" (vertex) or \"f\" (face) is needed",
                    shown(word)
                )));
            }
        }
        first = false;
    }
    draft.finish()
}

fn rows_line(row: &ByteRecord) -> usize {
    row.position()
        .map_or(1, |position| position.line() as usize)
}
