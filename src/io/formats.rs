//! The formats of meshes: names, extensions, how content is recognised, reader and writer. Adding a format is one file
//! with its reader, and one entry here.

use std::io::{self, Write};

use super::csv_mesh::read_csv_mesh;
use super::gltf_file::read_gltf;
use super::obj::{read_obj, write_obj};
use super::ply::{read_ply, write_ply};
use super::stl::read_stl;
use super::vtk_legacy::{is_legacy_header, read_vtk_legacy};
use super::vtp::{read_vtp, write_pvd, write_vtp};
use super::{Limits, MeshFile, ReadMeshError};
use crate::mesh::TriMesh;

/// One format of meshes.
pub(super) struct Format {
    /// As people call it.
    pub name: &'static str,
    /// Lower case, without the dot; the first is written.
    pub extensions: &'static [&'static str],
    /// In half a sentence.
    pub description: &'static str,
    /// Whether such files usually hold something else: tables of numbers, for CSV.
    pub often_other: bool,
    /// Whether content that begins like this can be of no other format.
    pub recognises: fn(&Head<'_>) -> bool,
    /// Reads a whole file.
    pub read: fn(&Source<'_>) -> Result<MeshFile, ReadMeshError>,
    /// Writes, if this program can.
    pub writer: Option<Writer>,
}

/// The first bytes of a file.
pub(super) struct Head<'a> {
    /// Without a byte order mark, in UTF-8 if they are text.
    pub bytes: &'a [u8],
    /// The same without white space in front, shortened.
    pub text: &'a [u8],
}

/// A file to be read.
pub(super) struct Source<'a> {
    pub bytes: &'a [u8],
    pub limits: &'a Limits,
    /// The content of a file in the same folder, by its relative path.
    pub sibling: &'a dyn Fn(&str) -> Option<Vec<u8>>,
}

/// Writes files of one format.
#[derive(Clone, Copy)]
pub(super) struct Writer {
    pub mesh: fn(&mut dyn Write, &TriMesh) -> io::Result<()>,
    /// Lists the files of a sequence with their times, where the format has such a list.
    pub series: Option<SeriesWriter>,
}

/// Writes a list of files, each after its time in seconds.
type WriteSeries = fn(&mut dyn Write, &[(f64, String)]) -> io::Result<()>;

/// Lists of files with their times.
#[derive(Clone, Copy)]
pub(super) struct SeriesWriter {
    pub extension: &'static str,
    pub write: WriteSeries,
}

/// All of them. STL, OBJ and CSV have no first bytes that are surely theirs, as "solid" can begin a comment of any text.
pub(super) static FORMATS: [Format; 7] = [
    Format {
        name: "OBJ",
        extensions: &["obj"],
        description: "Wavefront, text",
        often_other: false,
        recognises: |_| false,
        read: |source| read_obj(source.bytes, source.limits),
        writer: Some(Writer {
            mesh: |mut out, mesh| write_obj(&mut out, mesh),
            series: None,
        }),
    },
    Format {
        name: "PLY",
        extensions: &["ply"],
        description: "Polygon file format, binary",
        often_other: false,
        recognises: |head| {
            let (name, after) = head.text.split_at(head.text.len().min(3));
            let ends = after.first().is_some_and(u8::is_ascii_whitespace);
            ends && name.eq_ignore_ascii_case(b"ply")
        },
        read: |source| read_ply(source.bytes, source.limits),
        writer: Some(Writer {
            mesh: |mut out, mesh| write_ply(&mut out, mesh),
            series: None,
        }),
    },
    Format {
        name: "STL",
        extensions: &["stl"],
        description: "Stereolithography",
        often_other: false,
        recognises: |_| false,
        read: |source| read_stl(source.bytes, source.limits),
        writer: None,
    },
    Format {
        name: "VTK",
        extensions: &["vtk"],
        description: "VTK legacy",
        often_other: false,
        recognises: |head| is_legacy_header(head.text),
        read: |source| read_vtk_legacy(source.bytes, source.limits),
        writer: None,
    },
    Format {
        name: "VTP",
        extensions: &["vtp"],
        description: "VTK XML, with a .pvd per surface that lists its frames by time",
        often_other: false,
        // Any XML may begin like this: pictures and pages do.
        recognises: |head| head.text.starts_with(b"<") && contains(head.text, b"<VTKFile"),
        read: |source| read_vtp(source.bytes, source.limits),
        writer: Some(Writer {
            mesh: |mut out, mesh| write_vtp(&mut out, mesh, &[]),
            series: Some(SeriesWriter {
                extension: "pvd",
                write: |mut out, entries| write_pvd(&mut out, entries),
            }),
        }),
    },
    Format {
        name: "glTF",
        extensions: &["gltf", "glb"],
        description: "glTF 2, with morph targets as frames",
        often_other: false,
        // Any JSON begins like this; the one object that every glTF file has may be its last.
        recognises: |head| {
            let json = || head.text.starts_with(b"{") && contains(head.bytes, b"\"asset\"");
            head.bytes.starts_with(b"glTF") || json()
        },
        read: |source| read_gltf(source.bytes, source.limits, source.sibling),
        writer: None,
    },
    Format {
        name: "CSV",
        extensions: &["csv"],
        description: "Points and faces",
        often_other: true,
        recognises: |_| false,
        read: |source| read_csv_mesh(source.bytes, source.limits),
        writer: None,
    },
];

fn contains(bytes: &[u8], words: &[u8]) -> bool {
    bytes.windows(words.len()).any(|window| window == words)
}

/// Extensions of files that list the files of a sequence.
pub(super) const SERIES_EXTENSIONS: [&str; 2] = ["pvd", "series"];
/// Extension of files that describe a study.
pub(super) const MANIFEST_EXTENSION: &str = "toml";

/// The format of files with an extension, in any case.
pub(super) fn format_of_extension(extension: &str) -> Option<&'static Format> {
    let known = |format: &&Format| {
        let mut extensions = format.extensions.iter();
        extensions.any(|known| known.eq_ignore_ascii_case(extension))
    };
    FORMATS.iter().find(known)
}

/// Names of all formats, as people read them in a list.
pub fn mesh_format_names() -> Vec<&'static str> {
    FORMATS.iter().map(|format| format.name).collect()
}

/// Extensions of mesh files, lower case, without the dot.
pub fn mesh_file_endings() -> Vec<&'static str> {
    let extensions = FORMATS.iter().flat_map(|format| format.extensions);
    extensions.copied().collect()
}

/// Extensions of all files that can be opened: meshes, series, studies.
pub fn openable_extensions() -> Vec<&'static str> {
    let mut extensions = mesh_file_endings();
    extensions.extend(SERIES_EXTENSIONS);
    extensions.push(MANIFEST_EXTENSION);
    extensions
}

/// A format that meshes can be written in.
#[derive(Clone, Copy)]
pub struct MeshFormat {
    format: &'static Format,
    pub(super) writer: Writer,
}

impl MeshFormat {
    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> {
        FORMATS.iter().filter_map(|format| {
            let writer = format.writer?;
            Some(Self { format, writer })
        })
    }

    /// The format of files with an extension, if it can be written.
    pub fn of_extension(extension: &str) -> Option<Self> {
        Self::all().find(|format| format.extension() == extension)
    }

    /// The extension of its files, without the dot.
    pub fn extension(self) -> &'static str {
        self.format.extensions.first().copied().unwrap_or_default()
    }

    /// What it is, in half a sentence.
    pub fn description(self) -> &'static str {
        self.format.description
    }
}

impl std::fmt::Debug for MeshFormat {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.format.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_extension_belongs_to_two_formats() {
        let mut extensions = openable_extensions();
        let count = extensions.len();
        extensions.sort_unstable();
        extensions.dedup();
        assert_eq!(extensions.len(), count);
        for extension in mesh_file_endings() {
            assert!(format_of_extension(&extension.to_uppercase()).is_some());
        }
        assert!(format_of_extension("nii").is_none());
    }

    #[test]
    fn other_xml_and_json_are_neither_vtp_nor_gltf() {
        let drawing = b"<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"/>";
        let settings = b"{\"theme\": \"dark\"}";
        for content in [&drawing[..], settings] {
            let read = |name: &str| {
                let read = crate::io::read_mesh(name, content, &Limits::default());
                read.unwrap_err().to_string()
            };
            let unknown = read("saved.data");
            assert!(unknown.contains("not a mesh format"), "{unknown}");
            // What is named as a mesh is refused as one of that format.
            let obj = read("heart.obj");
            assert!(!obj.contains("glTF") && !obj.contains("VTK"), "{obj}");
        }
        // By their content, whatever they are called.
        let late = b"{\"scene\": 0, \"asset\": {\"version\": \"2.0\"}}";
        let poly = b"<?xml version=\"1.0\"?>\n<!-- a comment -->\n<VTKFile type=\"PolyData\"/>";
        for (content, name) in [(&late[..], "glTF"), (poly, "VTP")] {
            let head = Head {
                bytes: content,
                text: content,
            };
            let found = FORMATS.iter().find(|format| (format.recognises)(&head));
            assert_eq!(found.unwrap().name, name);
        }
    }

    #[test]
    fn what_can_be_written_is_read_back_by_the_same_entry() {
        let mesh = crate::mesh::phantom::bowl(20.0, 4, 7);
        for format in MeshFormat::all() {
            let mut bytes = Vec::new();
            (format.writer.mesh)(&mut bytes, &mesh).unwrap();
            let source = Source {
                bytes: &bytes,
                limits: &Limits::default(),
                sibling: &|_| None,
            };
            let read = (format.format.read)(&source).unwrap();
            assert_eq!(read.frames[0].vertices(), mesh.vertices(), "{format:?}");
        }
    }
}
