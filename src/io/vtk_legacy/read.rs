//! Reading a legacy VTK file from its first line to the end of its geometry.

use super::cells::{cell_count, read_cells};
use super::cursor::{LegacyCursor, scalar};
use super::skip::{skip_field, skip_metadata};
use crate::io::binary_cursor::{Scalar, count as whole};
use crate::io::mesh_draft::{MeshDraft, Place};
use crate::io::text_lines::{count, shown};
use crate::io::{Limits, MeshFile, ReadMeshError};

/// A cell whose type comes later in the file.
struct PendingCell {
    end: usize,
    place: Place,
}

/// What has been read of a file.
struct Reader<'a> {
    cursor: LegacyCursor<'a>,
    draft: MeshDraft,
    grid: bool,
    cells: Vec<PendingCell>,
    cell_corners: Vec<u32>,
}

/// Reads points and surface cells; arrays on points and cells are passed over.
pub(crate) fn read_vtk_legacy(bytes: &[u8], limits: &Limits) -> Result<MeshFile, ReadMeshError> {
    let mut cursor = LegacyCursor::new(bytes);
    let grid = read_header(&mut cursor)?;
    let mut reader = Reader {
        cursor,
        draft: MeshDraft::new(limits, 0),
        grid,
        cells: Vec::new(),
        cell_corners: Vec::new(),
    };
    while let Some((place, words)) = reader.cursor.keyword_line() {
        if !reader.read_section(&words, place)? {
            break;
        }
    }
    if let Some(cell) = reader.cells.first() {
        return Err(cell.place.error("cells without CELL_TYPES"));
    }
    reader.draft.finish()
}

/// The first four lines; whether the file is an UnstructuredGrid.
fn read_header(cursor: &mut LegacyCursor<'_>) -> Result<bool, ReadMeshError> {
    if !cursor.line().starts_with(b"# vtk DataFile Version") {
        return Err(Place::Line(1).error("the first line is not \"# vtk DataFile Version …\""));
    }
    cursor.line(); // the title
    let place = cursor.place();
    let binary = match cursor.line().to_ascii_uppercase().as_slice() {
        b"ASCII" => false,
        b"BINARY" => true,
        other => return Err(place.error(format!("{} is not ASCII or BINARY", shown(other)))),
    };
    cursor.skip_white();
    let place = cursor.place();
    let kind = cursor.line();
    let grid = match kind.to_ascii_uppercase().as_slice() {
        b"DATASET POLYDATA" => false,
        b"DATASET UNSTRUCTURED_GRID" => true,
        _ => {
            return Err(place.error(format!(
                "{} is not DATASET POLYDATA or DATASET UNSTRUCTURED_GRID",
                shown(kind)
            )));
        }
    };
    if binary {
        cursor.set_binary();
    }
    Ok(grid)
}

impl Reader<'_> {
    /// Reads what a keyword announces; false where the geometry has ended.
    fn read_section(&mut self, words: &[&[u8]], place: Place) -> Result<bool, ReadMeshError> {
        let keyword = words[0].to_ascii_uppercase();
        let number = |at: usize| {
            let word = words.get(at).copied();
            count(
                word.ok_or_else(|| place.error("a count is missing"))?,
                place,
            )
        };
        match (keyword.as_slice(), self.grid) {
            (b"POINT_DATA" | b"CELL_DATA", _) => return Ok(false),
            (b"METADATA", _) => skip_metadata(&mut self.cursor),
            (b"FIELD", _) => skip_field(&mut self.cursor, number(2)?)?,
            (b"POINTS", _) => {
                let kind = scalar(words.get(2).copied().unwrap_or_default(), place)?;
                self.read_points(number(1)?, kind)?;
            }
            (b"POLYGONS", false) => {
                self.draft
                    .expect_faces(cell_count(&self.cursor, number(1)?))?;
                let draft = &mut self.draft;
                read_cells(
                    &mut self.cursor,
                    number(1)?,
                    number(2)?,
                    &mut |corners, place| draft.polygon(corners, place),
                )?;
            }
            (b"TRIANGLE_STRIPS", false) => {
                let draft = &mut self.draft;
                read_cells(
                    &mut self.cursor,
                    number(1)?,
                    number(2)?,
                    &mut |corners, place| draft.strip(corners, place),
                )?;
            }
            (b"VERTICES" | b"LINES", false) => {
                let draft = &mut self.draft;
                read_cells(&mut self.cursor, number(1)?, number(2)?, &mut |_, _| {
                    draft.skip_points_and_lines(1);
                    Ok(())
                })?;
            }
            (b"CELLS", true) => self.read_grid_cells(number(1)?, number(2)?)?,
            (b"CELL_TYPES", true) => self.read_cell_types(number(1)?, place)?,
            _ => return Err(place.error(format!("unknown keyword {}", shown(words[0])))),
        }
        Ok(true)
    }

    fn read_points(&mut self, points: u64, kind: Scalar) -> Result<(), ReadMeshError> {
        let binary = self.cursor.is_binary();
        let bytes_each = if binary { 3 * kind.size() } else { 6 };
        let bytes_present = self.cursor.rest().len();
        self.draft
            .expect_points(points, bytes_present, bytes_each)?;
        for _ in 0..points {
            let (x, place) = self.cursor.number(kind, "a coordinate")?;
            let (y, _) = self.cursor.number(kind, "a coordinate")?;
            let (z, _) = self.cursor.number(kind, "a coordinate")?;
            self.draft.point([x, y, z], place)?;
        }
        Ok(())
    }

    fn read_grid_cells(&mut self, first: u64, second: u64) -> Result<(), ReadMeshError> {
        self.draft.expect_faces(cell_count(&self.cursor, first))?;
        let (cells, all_corners) = (&mut self.cells, &mut self.cell_corners);
        read_cells(&mut self.cursor, first, second, &mut |corners, place| {
            all_corners.extend_from_slice(corners);
            cells.push(PendingCell {
                end: all_corners.len(),
                place,
            });
            Ok(())
        })
    }

    fn read_cell_types(&mut self, types: u64, place: Place) -> Result<(), ReadMeshError> {
        if types != self.cells.len() as u64 {
            let reason = format!("{types} cell types for {} cells", self.cells.len());
            return Err(place.error(reason));
        }
        let mut start = 0;
        for cell in std::mem::take(&mut self.cells) {
            let (kind, place) = self.cursor.number(Scalar::I32, "a cell type")?;
            let corners = &self.cell_corners[start..cell.end];
            add_cell(
                &mut self.draft,
                whole(kind, place)?,
                corners,
                cell.place,
                place,
            )?;
            start = cell.end;
        }
        Ok(())
    }
}

/// Adds a cell of a grid by its type, as vtkCellType.h numbers them.
fn add_cell(
    draft: &mut MeshDraft,
    kind: u64,
    corners: &[u32],
    cell_place: Place,
    type_place: Place,
) -> Result<(), ReadMeshError> {
    let (name, needed) = match kind {
        1..=4 => {
            draft.skip_points_and_lines(1);
            return Ok(());
        }
        6 => return draft.strip(corners, cell_place),
        7 => return draft.polygon(corners, cell_place),
        5 => ("triangle", 3),
        8 => ("pixel", 4),
        9 => ("quad", 4),
        _ => {
            return Err(type_place.error(format!(
                "cell type {kind} is not a flat surface (triangle, strip, polygon, pixel or quad)"
            )));
        }
    };
    if corners.len() != needed {
        let reason = format!("a {name} with {} corners", corners.len());
        return Err(cell_place.error(reason));
    }
    match *corners {
        [a, b, c, d] if kind == 8 => draft.polygon(&[a, b, d, c], cell_place),
        _ => draft.polygon(corners, cell_place),
    }
}
