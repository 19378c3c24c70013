//! Reading a legacy VTK file from its first line to the end of its geometry.

use super::cells::read_cells;
use super::cursor::{LegacyCursor, scalar};
use super::skip::{skip_field, skip_metadata};
use crate::io::binary_cursor::{Scalar, count};
use crate::io::mesh_draft::{FilePosition, MeshDraft, check_count};
use crate::io::text_lines::{shown, words};
use crate::io::{Limits, MeshFile, ReadMeshError};

/// A cell whose type comes later in the file.
struct PendingCell {
    end: usize,
    place: FilePosition,
}

/// What has been read of a file.
struct Reader<'a> {
    cursor: LegacyCursor<'a>,
    limits: &'a Limits,
    draft: MeshDraft,
    grid: bool,
    cells: Vec<PendingCell>,
    cell_corners: Vec<u32>,
}

/// Whether a text begins with the first line of the format, `# vtk DataFile Version …`.
pub(crate) fn is_legacy_header(text: &[u8]) -> bool {
    let begins = [&b"#"[..], b"vtk", b"datafile", b"version"];
    let first_line = text.split(|&b| b == b'\n' || b == b'\r').next();
    let mut found = words(first_line.unwrap_or_default());
    begins.iter().all(|word| {
        found
            .next()
            .is_some_and(|found| found.eq_ignore_ascii_case(word))
    })
}

/// Reads points and surface cells; arrays on points and cells are passed over. Keywords may be in
/// any case, numbers on any line.
pub(crate) fn read_vtk_legacy(bytes: &[u8], limits: &Limits) -> Result<MeshFile, ReadMeshError> {
    let mut cursor = LegacyCursor::new(bytes);
    let grid = read_header(&mut cursor)?;
    let mut reader = Reader {
        cursor,
        limits,
        draft: MeshDraft::new(limits, 0),
        grid,
        cells: Vec::new(),
        cell_corners: Vec::new(),
    };
    reader.cursor.skip_white();
    while !reader.cursor.rest().is_empty() && reader.read_section()? {
        reader.cursor.skip_white();
    }
    if let Some(cell) = reader.cells.first() {
        return Err(cell.place.error("cells without CELL_TYPES"));
    }
    reader.draft.finish()
}

/// The first lines; whether the file is an UnstructuredGrid.
fn read_header(cursor: &mut LegacyCursor<'_>) -> Result<bool, ReadMeshError> {
    cursor.skip_white();
    let place = cursor.place();
    if !is_legacy_header(cursor.line()) {
        return Err(place.error("the first line is not \"# vtk DataFile Version …\""));
    }
    cursor.line(); // the title
    let (word, place) = cursor.word("ASCII or BINARY")?;
    let binary = match word.to_ascii_uppercase().as_slice() {
        b"ASCII" => false,
        b"BINARY" => true,
        _ => return Err(place.error(format!("{} is not ASCII or BINARY", shown(word)))),
    };
    let (keyword, place) = cursor.word("DATASET")?;
    let (kind, _) = cursor.word("a kind of DATASET")?;
    let both = [keyword, kind].join(&b' ').to_ascii_uppercase();
    let grid = match both.as_slice() {
        b"DATASET POLYDATA" => false,
        b"DATASET UNSTRUCTURED_GRID" => true,
        _ => {
            return Err(place.error(format!(
                "{} is not DATASET POLYDATA or DATASET UNSTRUCTURED_GRID",
                shown(&both)
            )));
        }
    };
    if binary {
        cursor.line();
        cursor.set_binary();
    }
    Ok(grid)
}

impl Reader<'_> {
    /// Reads what the next keyword announces; false where the geometry has ended.
    fn read_section(&mut self) -> Result<bool, ReadMeshError> {
        let (word, place) = self.cursor.word("a keyword")?;
        let (cursor, draft, limits) = (&mut self.cursor, &mut self.draft, self.limits);
        match (word.to_ascii_uppercase().as_slice(), self.grid) {
            (b"POINT_DATA" | b"CELL_DATA", _) => return Ok(false),
            (b"METADATA", _) => skip_metadata(cursor),
            (b"FIELD", _) => skip_field(cursor)?,
            (b"POINTS", _) => self.read_points()?,
            (b"POLYGONS", false) => read_cells(cursor, "faces", limits, &mut |corners, place| {
                draft.polygon(corners, place)
            })?,
            (b"TRIANGLE_STRIPS", false) => {
                read_cells(cursor, "strips", limits, &mut |corners, place| {
                    draft.strip(corners, place)
                })?;
            }
            (b"VERTICES" | b"LINES", false) => {
                read_cells(cursor, "points and lines", limits, &mut |_, _| {
                    draft.skip_points_and_lines(1);
                    Ok(())
                })?;
            }
            (b"CELLS", true) => self.read_grid_cells()?,
            (b"CELL_TYPES", true) => self.read_cell_types(place)?,
            _ => return Err(place.error(format!("unknown keyword {}", shown(word)))),
        }
        Ok(true)
    }

    fn read_points(&mut self) -> Result<(), ReadMeshError> {
        let points = self.cursor.count()?;
        let (kind, place) = self.cursor.word("a type")?;
        let kind = scalar(kind, place)?;
        self.cursor.begin_numbers();
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

    fn read_grid_cells(&mut self) -> Result<(), ReadMeshError> {
        let (cells, all_corners) = (&mut self.cells, &mut self.cell_corners);
        // as many as quads have, so that they fit into memory before their types are known
        let most = 4 * self.limits.faces;
        read_cells(
            &mut self.cursor,
            "faces",
            self.limits,
            &mut |corners, place| {
                all_corners.extend_from_slice(corners);
                check_count("corners of cells", all_corners.len() as u64, most)?;
                cells.push(PendingCell {
                    end: all_corners.len(),
                    place,
                });
                Ok(())
            },
        )
    }

    fn read_cell_types(&mut self, place: FilePosition) -> Result<(), ReadMeshError> {
        let types = self.cursor.count()?;
        self.cursor.begin_numbers();
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
                count(kind, place)?,
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
    cell_place: FilePosition,
    type_place: FilePosition,
) -> Result<(), ReadMeshError> {
    let (name, needed) = match kind {
        0 if corners.is_empty() => return Ok(()),
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
