//! Writing PLY, binary with the least significant byte first.

use std::io::{self, Write};

use crate::mesh::TriMesh;

/// Writes positions as doubles, exact to the last bit, and faces.
///
/// # Errors
/// If `out` cannot be written to.
pub fn write_ply(out: &mut impl Write, mesh: &TriMesh) -> io::Result<()> {
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment Cardiomorph\n\
         element vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.vertices().len(),
        mesh.triangles().len()
    )?;
    for point in mesh.vertices() {
        for x in point.iter() {
            out.write_all(&x.to_le_bytes())?;
        }
    }
    for triangle in mesh.triangles() {
        out.write_all(&[3])?;
        for vertex in triangle {
            out.write_all(&vertex.to_le_bytes())?;
        }
    }
    Ok(())
}
