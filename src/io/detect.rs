//! Which format a file is, told by its content and its ending.

use super::csv_mesh::read_csv_mesh;
use super::gltf_file::read_gltf;
use super::obj::read_obj;
use super::ply::read_ply;
use super::stl::read_stl;
use super::vtk_legacy::read_vtk_legacy;
use super::vtp::read_vtp;
use super::{Limits, MeshFile, ReadMeshError};
use crate::study::Notice;

/// A format that meshes are read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Obj,
    Ply,
    Stl,
    VtkLegacy,
    Vtp,
    Gltf,
    Csv,
}

impl Format {
    fn name(self) -> &'static str {
        match self {
            Self::Obj => "OBJ",
            Self::Ply => "PLY",
            Self::Stl => "STL",
            Self::VtkLegacy => "VTK",
            Self::Vtp => "VTP",
            Self::Gltf => "glTF",
            Self::Csv => "CSV",
        }
    }
}

/// Endings of mesh files, lower case, without the dot.
pub fn mesh_file_endings() -> &'static [&'static str] {
    &["obj", "ply", "stl", "vtk", "vtp", "gltf", "glb", "csv"]
}

/// Reads one file, of which `file_name` only serves to tell the format by its ending.
///
/// Content that clearly is another format than the ending says is read as what it is, with a
/// notice. A glTF file that keeps its numbers in other files needs [`read_mesh_with_siblings`].
///
/// # Errors
/// With the line or byte that is wrong, and why.
pub fn read_mesh(
    file_name: &str,
    bytes: &[u8],
    limits: &Limits,
) -> Result<MeshFile, ReadMeshError> {
    read_mesh_with_siblings(file_name, bytes, limits, &|_| None)
}

/// As [`read_mesh`]; `sibling` returns the content of a file beside this one by its name
/// (a relative path without `..`), or `None` if there is none.
///
/// # Errors
/// As [`read_mesh`].
pub fn read_mesh_with_siblings(
    file_name: &str,
    bytes: &[u8],
    limits: &Limits,
    sibling: &dyn Fn(&str) -> Option<Vec<u8>>,
) -> Result<MeshFile, ReadMeshError> {
    let size = bytes.len() as u64;
    if size > limits.file_bytes {
        return Err(ReadMeshError::TooLarge {
            size,
            most: limits.file_bytes,
        });
    }
    // faces number vertices in 32 bits
    let limits = &Limits {
        vertices: limits.vertices.min(u32::MAX as usize),
        ..*limits
    };
    let ending = format_of_ending(file_name);
    let content = format_of_content(bytes);
    let format = content.or(ending).ok_or(ReadMeshError::UnknownFormat)?;
    let mut file = read_as(format, bytes, limits, sibling).map_err(on_one_line)?;
    if ending.is_some_and(|ending| ending != format) {
        file.notices.push(Notice::info(format!(
            "read as {} by its content, against its file name extension",
            format.name()
        )));
    }
    Ok(file)
}

fn read_as(
    format: Format,
    bytes: &[u8],
    limits: &Limits,
    sibling: &dyn Fn(&str) -> Option<Vec<u8>>,
) -> Result<MeshFile, ReadMeshError> {
    match format {
        Format::Obj => read_obj(bytes, limits),
        Format::Ply => read_ply(bytes, limits),
        Format::Stl => read_stl(bytes, limits),
        Format::VtkLegacy => read_vtk_legacy(bytes, limits),
        Format::Vtp => read_vtp(bytes, limits),
        Format::Csv => read_csv_mesh(bytes, limits),
        Format::Gltf => read_gltf(bytes, limits, sibling),
    }
}

/// Reasons of other crates quote the file: without what a screen cannot show, and not endless.
fn on_one_line(mut error: ReadMeshError) -> ReadMeshError {
    const MOST_CHARS: usize = 240;
    let shown = |text: &mut String| {
        *text = text
            .chars()
            .take(MOST_CHARS)
            .map(|c| if c.is_control() { '\u{fffd}' } else { c })
            .collect();
    };
    match &mut error {
        ReadMeshError::AtLine { reason, .. } | ReadMeshError::AtByte { reason, .. } => {
            shown(reason);
        }
        ReadMeshError::InItem { item, reason } => {
            shown(item);
            shown(reason);
        }
        _ => {}
    }
    error
}

fn format_of_ending(file_name: &str) -> Option<Format> {
    let (_, ending) = file_name.rsplit_once('.')?;
    Some(match ending.to_ascii_lowercase().as_str() {
        "obj" => Format::Obj,
        "ply" => Format::Ply,
        "stl" => Format::Stl,
        "vtk" => Format::VtkLegacy,
        "vtp" => Format::Vtp,
        "gltf" | "glb" => Format::Gltf,
        "csv" => Format::Csv,
        _ => return None,
    })
}

/// The format whose first bytes these are. STL, OBJ and CSV have no first bytes that are surely
/// theirs, as "solid" can begin a comment of any text.
fn format_of_content(bytes: &[u8]) -> Option<Format> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let text = bytes[..bytes.len().min(1024)].trim_ascii_start();
    if bytes.starts_with(b"glTF") {
        Some(Format::Gltf)
    } else if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r") {
        Some(Format::Ply)
    } else if text.starts_with(b"# vtk DataFile") {
        Some(Format::VtkLegacy)
    } else if text.starts_with(b"<?xml") || text.starts_with(b"<VTKFile") {
        Some(Format::Vtp)
    } else if text.starts_with(b"{") {
        Some(Format::Gltf)
    } else {
        None
    }
}
