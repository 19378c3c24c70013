//! Reading PLY: vertices and polygons, past everything else.

use super::body::{BinaryBody, Body, TextBody};
use super::header::{Element, Encoding, Header, Storage, read_header};
use crate::io::binary_cursor::{Scalar, count, vertex_index};
use crate::io::mesh_draft::{FilePosition, MeshDraft};
use crate::io::{Limits, MeshFile, ReadMeshError};
use crate::study::Notice;

/// Reads `vertex` with `x`, `y`, `z`, `face` with `vertex_indices`, and `tristrips`; other elements and properties are
/// passed over.
pub(crate) fn read_ply(bytes: &[u8], limits: &Limits) -> Result<MeshFile, ReadMeshError> {
    let header = read_header(bytes)?;
    let draft = MeshDraft::new(limits, 0);
    match header.encoding {
        Encoding::Text => read_elements(TextBody::new(header.body.clone()), &header, draft),
        Encoding::Binary(order) => {
            let start = bytes.len() - header.body.rest().len();
            // where lines end in CR alone, a LF behind the header is a byte of the first number
            let lf_is_number =
                bytes[..start].ends_with(b"\n") && !bytes[..start - 1].contains(&b'\n');
            let start = start - usize::from(lf_is_number);
            read_elements(BinaryBody::new(bytes, start, order), &header, draft)
        }
    }
}

fn read_elements(
    mut body: impl Body,
    header: &Header<'_>,
    mut draft: MeshDraft,
) -> Result<MeshFile, ReadMeshError> {
    for element in &header.elements {
        match element.name.as_str() {
            "vertex" => {
                let bytes_each = element.min_bytes(header.encoding);
                draft.expect_points(element.count, body.bytes_left(), bytes_each)?;
                read_vertices(&mut body, element, &mut draft)?;
            }
            "face" => {
                draft.expect_faces(element.count)?;
                read_faces(&mut body, element, &mut draft)?;
            }
            "tristrips" => read_strips(&mut body, element, &mut draft)?,
            _ => pass_over(&mut body, element)?,
        }
    }
    let left = body.finish()?;
    if left > 0 {
        let text = format!("{left} bytes after the last element ignored");
        draft.notice(Notice::warning(text));
    }
    draft.finish()
}

fn read_vertices(
    body: &mut impl Body,
    element: &Element,
    draft: &mut MeshDraft,
) -> Result<(), ReadMeshError> {
    let mut axes = [0; 3];
    for (axis, name) in axes.iter_mut().zip(["x", "y", "z"]) {
        *axis = element
            .property(&[name])
            .filter(|&at| matches!(element.properties[at].storage, Storage::One(_)))
            .ok_or_else(|| {
                element
                    .place
                    .error(format!("vertices have no number \"{name}\""))
            })?;
    }
    for index in 0..element.count {
        body.begin(&element.name, index == 0)?;
        let place = body.place();
        let mut xyz = [0.0; 3];
        for (at, property) in element.properties.iter().enumerate() {
            match property.storage {
                Storage::One(scalar) if axes.contains(&at) => {
                    let number = body.number(scalar)?;
                    for axis in (0..3).filter(|&axis| axes[axis] == at) {
                        xyz[axis] = number;
                    }
                }
                other => pass_over_property(body, other)?,
            }
        }
        body.end()?;
        draft.point(xyz, place)?;
    }
    Ok(())
}

fn read_faces(
    body: &mut impl Body,
    element: &Element,
    draft: &mut MeshDraft,
) -> Result<(), ReadMeshError> {
    let mut corners = Vec::new();
    each_list(body, element, |body, count, item, place| {
        draft.check_corners(count, place)?;
        corners.clear();
        for _ in 0..count {
            let place = body.place();
            corners.push(vertex_index(body.number(item)?, place)?);
        }
        draft.polygon(&corners, place)
    })
}

/// The list of corners: the one of that name, else the only list of whole numbers.
fn corners_of(element: &Element) -> Result<usize, ReadMeshError> {
    let lists = || {
        let properties = element.properties.iter().enumerate();
        properties.filter_map(|(at, property)| match property.storage {
            Storage::List { item, .. } => Some((at, item)),
            Storage::One(_) => None,
        })
    };
    let named = element.property(&["vertex_indices", "vertex_index"]);
    let named = named.filter(|at| lists().any(|(list, _)| list == *at));
    let mut whole = lists().filter(|(_, item)| !matches!(item, Scalar::F32 | Scalar::F64));
    let only = whole.next().filter(|_| whole.next().is_none());
    named.or(only.map(|(at, _)| at)).ok_or_else(|| {
        let name = &element.name;
        element
            .place
            .error(format!("{name} without a list \"vertex_indices\""))
    })
}

/// Strips of triangles, one after the other in one list or in several, each ended by −1.
fn read_strips(
    body: &mut impl Body,
    element: &Element,
    draft: &mut MeshDraft,
) -> Result<(), ReadMeshError> {
    let mut strip = Vec::new();
    each_list(body, element, |body, count, item, place| {
        for _ in 0..count {
            let place = body.place();
            match body.number(item)? {
                -1.0 => draft.strip(&std::mem::take(&mut strip), place)?,
                corner => strip.push(vertex_index(corner, place)?),
            }
        }
        match strip.is_empty() {
            true => Ok(()),
            false => draft.strip(&std::mem::take(&mut strip), place),
        }
    })
}

/// Reads the list of corners of each element: `read` takes its numbers, so many of one kind, at a place.
fn each_list<B: Body>(
    body: &mut B,
    element: &Element,
    mut read: impl FnMut(&mut B, u64, Scalar, FilePosition) -> Result<(), ReadMeshError>,
) -> Result<(), ReadMeshError> {
    let corners_at = corners_of(element)?;
    for index in 0..element.count {
        body.begin(&element.name, index == 0)?;
        let place = body.place();
        for (at, property) in element.properties.iter().enumerate() {
            match property.storage {
                Storage::List { length, item } if at == corners_at => {
                    let count = count(body.number(length)?, place)?;
                    read(body, count, item, place)?;
                }
                storage => pass_over_property(body, storage)?,
            }
        }
        body.end()?;
    }
    Ok(())
}

/// Goes past elements of no interest. Those without properties take no room in a binary file.
fn pass_over(body: &mut impl Body, element: &Element) -> Result<(), ReadMeshError> {
    if element.properties.is_empty() {
        return Ok(());
    }
    for index in 0..element.count {
        body.begin(&element.name, index == 0)?;
        for property in &element.properties {
            pass_over_property(body, property.storage)?;
        }
        body.end()?;
    }
    Ok(())
}

fn pass_over_property(body: &mut impl Body, storage: Storage) -> Result<(), ReadMeshError> {
    match storage {
        Storage::One(scalar) => body.skip(scalar)?,
        Storage::List { length, item } => {
            let place = body.place();
            for _ in 0..count(body.number(length)?, place)? {
                body.skip(item)?;
            }
        }
    }
    Ok(())
}
