//! Reading VTP: points, polygons and strips of all pieces.

use roxmltree::{Document, Node, ParsingOptions};

use super::appended::cut_appended;
use super::array::{VtpFile, byte_order, scalar, utf8};
use super::encoded::Encoding;
use crate::io::binary_cursor::{Scalar, vertex_index};
use crate::io::mesh_draft::{MeshDraft, Place};
use crate::io::text_lines::{count, shown};
use crate::io::{Limits, MeshFile, ReadMeshError};
use crate::study::Notice;

/// More elements than any VTP file has; keeps a file of nothing but tags from taking memory.
const MAX_XML_NODES: u32 = 100_000;

/// Reads all pieces as one surface; arrays on points and cells are passed over.
pub(crate) fn read_vtp(bytes: &[u8], limits: &Limits) -> Result<MeshFile, ReadMeshError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let (xml, appended) = cut_appended(bytes)?;
    let xml = utf8(&xml)?;
    let options = ParsingOptions {
        nodes_limit: MAX_XML_NODES,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(&xml, options)
        .map_err(|error| Place::Line(error.pos().row as usize).error(error.to_string()))?;
    let root = document.root_element();
    let place = Place::Line(document.text_pos_at(root.range().start).row as usize);
    check_root(root, place)?;
    let file = VtpFile {
        document: &document,
        appended,
        encoding: read_encoding(root, place)?,
    };
    let poly_data = child(root, "PolyData").ok_or_else(|| place.error("PolyData is missing"))?;
    let mut draft = MeshDraft::new(limits, 0);
    let mut pieces = 0;
    for piece in poly_data
        .children()
        .filter(|node| node.has_tag_name("Piece"))
    {
        read_piece(&file, piece, limits, &mut draft)?;
        pieces += 1;
    }
    if pieces > 1 {
        draft.notice(Notice::info(format!(
            "{pieces} pieces joined into one surface"
        )));
    }
    draft.finish()
}

fn check_root(root: Node<'_, '_>, place: Place) -> Result<(), ReadMeshError> {
    if !root.has_tag_name("VTKFile") {
        let name = shown(root.tag_name().name().as_bytes());
        return Err(place.error(format!("the file is a {name}, not a VTKFile")));
    }
    match root.attribute("type").unwrap_or_default() {
        "PolyData" => Ok(()),
        other => Err(place.error(format!("holds {}, not PolyData", shown(other.as_bytes())))),
    }
}

fn read_encoding(root: Node<'_, '_>, place: Place) -> Result<Encoding, ReadMeshError> {
    let header = scalar(root.attribute("header_type").unwrap_or("UInt32"), place)?;
    if !matches!(header, Scalar::U32 | Scalar::U64) {
        return Err(place.error("the header type is neither UInt32 nor UInt64"));
    }
    let zlib = match root.attribute("compressor") {
        None | Some("") => false,
        Some("vtkZLibDataCompressor") => true,
        Some(other) => {
            return Err(place.error(format!(
                "compressed by {}; only vtkZLibDataCompressor or none is read",
                shown(other.as_bytes())
            )));
        }
    };
    Ok(Encoding {
        order: byte_order(
            root.attribute("byte_order").unwrap_or("LittleEndian"),
            place,
        )?,
        header,
        zlib,
    })
}

fn read_piece(
    file: &VtpFile<'_>,
    piece: Node<'_, '_>,
    limits: &Limits,
    draft: &mut MeshDraft,
) -> Result<(), ReadMeshError> {
    let place = file.place(piece);
    let number = |name: &str| {
        count(
            piece.attribute(name).unwrap_or("0").trim().as_bytes(),
            place,
        )
    };
    let first_vertex = draft.point_count();
    let points = number("NumberOfPoints")?;
    draft.expect_points(points, 0, 1)?;
    draft.expect_faces(number("NumberOfPolys")?)?;
    let lone = number("NumberOfVerts")?.saturating_add(number("NumberOfLines")?);
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
        if cells > 0 {
            let node = child(piece, tag).ok_or_else(|| place.error(format!("{tag} is missing")))?;
            let max_corners = 3 * limits.faces as u64;
            for_each_cell(file, node, cells, max_corners, &mut |corners, place| {
                let mut shifted = Vec::with_capacity(corners.len());
                for &corner in corners {
                    if u64::from(corner) >= points {
                        let reason = crate::io::mesh_draft::missing_vertex(
                            u64::from(corner),
                            points as usize,
                            0,
                        );
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
type EachCell<'f> = &'f mut dyn FnMut(&[u32], Place) -> Result<(), ReadMeshError>;

/// Calls `each` with the corners of every cell and where they stand.
fn for_each_cell(
    file: &VtpFile<'_>,
    node: Node<'_, '_>,
    cells: u64,
    max_corners: u64,
    each: EachCell<'_>,
) -> Result<(), ReadMeshError> {
    let place = file.place(node);
    let array = |name: &str| {
        node.children()
            .find(|child| child.attribute("Name") == Some(name))
            .ok_or_else(|| place.error(format!("the array \"{name}\" is missing")))
    };
    let corners = file.numbers(array("connectivity")?, max_corners)?;
    let ends = file.numbers(array("offsets")?, cells)?;
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
