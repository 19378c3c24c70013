//! One mesh file of any format: what it holds, or why it cannot be read.

use crate::mesh::{MeshError, TriMesh};
use crate::study::Notice;

/// The meshes in one file: one, or the frames of a sequence (glTF morph targets).
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// At least one.
    pub frames: Vec<TriMesh>,
    /// Time of each frame, where the file says so.
    pub times_s: Option<Vec<f64>>,
    /// What was left out or assumed: polygons triangulated, faces with a repeated corner dropped…
    pub notices: Vec<Notice>,
}

/// Why a mesh file cannot be read; shown after the file's name.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ReadMeshError {
    /// Neither the extension nor the first bytes fit a format.
    #[error("not a mesh format that can be read ({known})")]
    UnknownFormat {
        /// Names of those that can.
        known: String,
    },
    /// The file is larger than the limit.
    #[error("{size} bytes; the limit is {most}")]
    TooLarge {
        /// Its size.
        size: u64,
        /// The limit.
        most: u64,
    },
    /// It declares or holds more items than the limit.
    #[error("{count} {what}; the limit is {most}")]
    TooMany {
        /// `vertices`, `faces`, …
        what: &'static str,
        /// How many.
        count: u64,
        /// The limit.
        most: u64,
    },
    /// A text file is wrong at a line, counted from 1.
    #[error("line {line}: {reason}")]
    AtLine {
        /// The line.
        line: usize,
        /// What is wrong there.
        reason: String,
    },
    /// A binary file is wrong at a byte, counted from 0.
    #[error("byte {byte}: {reason}")]
    AtByte {
        /// The offset.
        byte: usize,
        /// What is wrong there.
        reason: String,
    },
    /// A part of a structured file is wrong, whose line cannot be told: `accessors[3]`…
    #[error("{item}: {reason}")]
    InItem {
        /// Its path in the file.
        item: String,
        /// What is wrong there.
        reason: String,
    },
    /// What was read is not a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// It holds no vertices or no faces.
    #[error("holds no triangles")]
    Empty,
}
