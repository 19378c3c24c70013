//! Reading VTP: points, polygons and strips of all pieces.

use std::cell::Cell;

use roxmltree::Node;

use super::appended::cut_appended;
use super::array::{byte_order, scalar};
use super::encoded::{Compressor, Encoding};
use super::file::VtpFile;
use crate::io::binary_cursor::{Scalar, vertex_index};
use crate::io::mesh_draft::{FilePosition, MeshDraft, check_count, missing_vertex};
use crate::io::text_encoding::xml_text;
use crate::io::text_lines::{count, shown};
use crate::io::xml::{LineIndex, parse_xml};
use crate::io::{Limits, MeshFile, ReadMeshError};
use crate::study::Notice;

/// Reads all pieces as one surface; arrays on points and cells are passed over.
pub(crate) fn read_vtp(bytes: &[u8], limits: &Limits) -> Result<MeshFile, ReadMeshError> {
    let (xml, appended) = cut_appended(bytes)?;
    let xml = xml_text(&xml)?;
    let document = parse_xml(&xml)?;
    let root = document.root_element();
    let lines = LineIndex::new(&xml);
    let place = FilePosition::Line(lines.line(root.range().start));
    check_root(root, place)?;
    let file = VtpFile {
        lines,
        appended,
        encoding: read_encoding(root, place)?,
        budget: Cell::new(limits.unpacked_times.saturating_mul(bytes.len() as u64)),
    };
    let poly_data = child(root, "PolyData").ok_or_else(|| place.error("PolyData is missing"))?;
    let mut draft = MeshDraft::new(limits, 0);
    let mut pieces = 0;
    for piece in poly_data
        .children()
        .filter(|node| node.has_tag_name("Piece"))
    {
        pieces += 1;
        check_count("pieces", pieces, limits.pieces)?;
        read_piece(&file, piece, limits, &mut draft)?;
    }
    if pieces > 1 {
        draft.notice(Notice::info(format!(
            "{pieces} pieces joined into one surface"
        )));
    }
    draft.finish()
}

fn check_root(root: Node<'_, '_>, place: FilePosition) -> Result<(), ReadMeshError> {
    if !root.has_tag_name("VTKFile") {
        let name = shown(root.tag_name().name().as_bytes());
        return Err(place.error(format!("the file is a {name}, not a VTKFile")));
    }
    match root.attribute("type").unwrap_or_default() {
        "PolyData" => Ok(()),
        other => Err(place.error(format!("holds {}, not PolyData", shown(other.as_bytes())))),
    }
}

fn read_encoding<'a>(
    root: Node<'a, '_>,
    place: FilePosition,
) -> Result<Encoding<'a>, ReadMeshError> {
    let header = scalar(root.attribute("header_type").unwrap_or("UInt32"), place)?;
    if !matches!(header, Scalar::U32 | Scalar::U64) {
        return Err(place.error("the header type is neither UInt32 nor UInt64"));
    }
    let compressor = match root.attribute("compressor") {
        None | Some("") => Compressor::None,
        Some("vtkZLibDataCompressor") => Compressor::Zlib,
        Some(other) => Compressor::Other(other, place),
    };
    Ok(Encoding {
        order: byte_order(
            root.attribute("byte_order").unwrap_or("LittleEndian"),
            place,
        )?,
        header,
        compressor,
    })
}

fn read_piece(
    file: &VtpFile<'_>,
    piece: Node<'_, '_>,
    limits: &Limits,
    draft: &mut MeshDraft,
) -> Result<(), ReadMeshError> {
    let place = file.place(piece);
    let number = |name: &str| match piece.attribute(name) {
        Some(word) => count(word.trim().as_bytes(), place).map(Some),
        None => Ok(None),
    };
    let first_vertex = draft.point_count();
    let points = number("NumberOfPoints")?;
    let points = points.ok_or_else(|| place.error("NumberOfPoints is missing"))?;
    draft.expect_points(points, 0, 1)?;
    draft.expect_faces(number("NumberOfPolys")?.unwrap_or_default())?;
    let (verts, lines) = (number("NumberOfVerts")?, number("NumberOfLines")?);
    let lone = verts
        .unwrap_or_default()
        .saturating_add(lines.unwrap_or_default());
    draft.skip_points_and_lines(usize::try_from(lone).unwrap_or(usize::MAX));
    if points > 0 {
        let array = child(piece, "Points").and_then(|node| child(node, "DataArray"));
        let array = array.ok_or_else(|| place.error("the piece has no Points"))?;
        read_points(file, array, points, draft)?;
    }
    for (name, tag, strips) in [
        ("NumberOfPolys", "Polys", false),
        ("NumberOfStrips", "Strips", true),
    ] {
        let cells = number(name)?;
        if cells == Some(0) {
            continue;
        }
        let Some(node) = child(piece, tag).filter(|node| child(*node, "DataArray").is_some())
        else {
            if cells.is_some() {
                return Err(place.error(format!("{tag} is missing")));
            }
            continue; // nobody said that there are any
        };
        for_each_cell(file, node, cells, limits, &mut |corners, place| {
            let mut shifted = Vec::with_capacity(corners.len());
            for &corner in corners {
                if u64::from(corner) >= points {
                    let reason = missing_vertex(u64::from(corner), points as usize, 0);
                    return Err(place.error(reason));
                }
                shifted.push(corner + first_vertex as u32);
            }
            if strips {
                draft.strip(&shifted, place)
            } else {
                draft.polygon(&shifted, place)
            }
        })?;
    }
    Ok(())
}

fn read_points(
    file: &VtpFile<'_>,
    array: Node<'_, '_>,
    points: u64,
    draft: &mut MeshDraft,
) -> Result<(), ReadMeshError> {
    let numbers = file.numbers(array, 3 * points)?;
    if numbers.values.len() as u64 != 3 * points {
        return Err(numbers.place.error(format!(
            "{} coordinates for {points} points",
            numbers.values.len()
        )));
    }
    for (index, xyz) in numbers.values.chunks_exact(3).enumerate() {
        draft.point([xyz[0], xyz[1], xyz[2]], numbers.place_of(3 * index))?;
    }
    Ok(())
}

/// Called with the corners of each cell and where they stand.
type EachCell<'f> = &'f mut dyn FnMut(&[u32], FilePosition) -> Result<(), ReadMeshError>;

/// Calls `each` with the corners of every cell and where they stand; of as many cells as there are offsets, if the
/// piece does not say how many.
fn for_each_cell(
    file: &VtpFile<'_>,
    node: Node<'_, '_>,
    cells: Option<u64>,
    limits: &Limits,
    each: EachCell<'_>,
) -> Result<(), ReadMeshError> {
    let place = file.place(node);
    let array = |name: &str| {
        node.children()
            .find(|child| {
                let found = child.attribute("Name").unwrap_or_default();
                found.trim().eq_ignore_ascii_case(name)
            })
            .ok_or_else(|| place.error(format!("the array \"{name}\" is missing")))
    };
    let max_corners = 3 * limits.faces as u64;
    let corners = file.numbers(array("connectivity")?, max_corners)?;
    let ends = file.numbers(array("offsets")?, cells.unwrap_or(limits.faces as u64))?;
    let cells = cells.unwrap_or(ends.values.len() as u64);
    if ends.values.len() as u64 != cells {
        let reason = format!("{} offsets for {cells} cells", ends.values.len());
        return Err(ends.place.error(reason));
    }
    let mut start = 0;
    let mut cell = Vec::new();
    for (index, &end) in ends.values.iter().enumerate() {
        let count = corners.values.len();
        if !(end.fract() == 0.0 && end >= start as f64 && end <= count as f64) {
            return Err(ends
                .place_of(index)
                .error(format!("offset {end} is not between {start} and {count}")));
        }
        cell.clear();
        for (at, &corner) in corners.values[start..end as usize].iter().enumerate() {
            cell.push(vertex_index(corner, corners.place_of(start + at))?);
        }
        each(&cell, corners.place_of(start))?;
        start = end as usize;
    }
    Ok(())
}

fn child<'a, 'input>(node: Node<'a, 'input>, tag: &str) -> Option<Node<'a, 'input>> {
    node.children().find(|child| child.has_tag_name(tag))
}
