//! Bytes to study and results to files, one file per format, both ways.

mod limits;
mod mesh_file;
mod opened;

pub use limits::Limits;
pub use mesh_file::{MeshFile, ReadMeshError};
pub use opened::{OpenError, Opened};
