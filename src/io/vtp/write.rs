//! Writing VTP with raw appended arrays, and the `.pvd` list that plays such files over time.

use std::io::{self, Error, ErrorKind, Write};

use crate::mesh::TriMesh;

/// Writes positions as `Float64`, exact to the last bit, faces, and named numbers on vertices.
///
/// Each array is its size in bytes as `UInt64` and its numbers, least significant byte first.
///
/// # Errors
/// If `out` cannot be written to, or an array has not one number for each vertex.
pub fn write_vtp(
    out: &mut impl Write,
    mesh: &TriMesh,
    vertex_scalars: &[(&str, &[f64])],
) -> io::Result<()> {
    let (vertices, faces) = (mesh.vertices().len(), mesh.triangles().len());
    if let Some((name, values)) = vertex_scalars.iter().find(|(_, v)| v.len() != vertices) {
        let reason = format!(
            "{} values of {name:?} for {vertices} vertices",
            values.len()
        );
        return Err(Error::new(ErrorKind::InvalidInput, reason));
    }
    let mut offset = 0;
    let mut place = |bytes: usize| {
        let at = offset;
        offset += 8 + bytes;
        at
    };
    writeln!(
        out,
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\">\n<PolyData>\n\
         <Piece NumberOfPoints=\"{vertices}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" \
         NumberOfStrips=\"0\" NumberOfPolys=\"{faces}\">"
    )?;
    writeln!(out, "<PointData>")?;
    for (name, values) in vertex_scalars {
        writeln!(
            out,
            "<DataArray type=\"Float64\" Name=\"{}\" format=\"appended\" offset=\"{}\"/>",
            escaped(name),
            place(8 * values.len())
        )?;
    }
    writeln!(
        out,
        "</PointData>\n<Points>\n<DataArray type=\"Float64\" Name=\"Points\" \
         NumberOfComponents=\"3\" format=\"appended\" offset=\"{}\"/>\n</Points>\n<Polys>\n\
         <DataArray type=\"Int64\" Name=\"connectivity\" format=\"appended\" offset=\"{}\"/>\n\
         <DataArray type=\"Int64\" Name=\"offsets\" format=\"appended\" offset=\"{}\"/>\n</Polys>\n\
         </Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">",
        place(24 * vertices),
        place(24 * faces),
        place(8 * faces)
    )?;
    write!(out, "_")?;
    for (_, values) in vertex_scalars {
        write_array(out, values.len(), values.iter().map(|x| x.to_le_bytes()))?;
    }
    let coordinates = mesh
        .vertices()
        .iter()
        .flat_map(|point| [point.x, point.y, point.z]);
    write_array(out, 3 * vertices, coordinates.map(f64::to_le_bytes))?;
    let corners = mesh.triangles().iter().flatten();
    write_array(out, 3 * faces, corners.map(|&v| i64::from(v).to_le_bytes()))?;
    write_array(
        out,
        faces,
        (1..=faces as i64).map(|face| (3 * face).to_le_bytes()),
    )?;
    writeln!(out, "\n</AppendedData>\n</VTKFile>")
}

fn write_array(
    out: &mut impl Write,
    count: usize,
    values: impl Iterator<Item = [u8; 8]>,
) -> io::Result<()> {
    out.write_all(&(8 * count as u64).to_le_bytes())?;
    for value in values {
        out.write_all(&value)?;
    }
    Ok(())
}

/// Writes a ParaView list of files, each with its time in seconds; files are named relative to
/// the list.
///
/// # Errors
/// If `out` cannot be written to.
pub fn write_pvd(out: &mut impl Write, entries: &[(f64, String)]) -> io::Result<()> {
    writeln!(
        out,
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>"
    )?;
    for (time_s, file) in entries {
        writeln!(
            out,
            "<DataSet timestep=\"{time_s:?}\" group=\"\" part=\"0\" file=\"{}\"/>",
            escaped(file)
        )?;
    }
    writeln!(out, "</Collection>\n</VTKFile>")
}

fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            // no XML may hold these, not even escaped
            '\0'..='\x08' | '\x0b' | '\x0c' | '\x0e'..='\x1f' => escaped.push('\u{fffd}'),
            c => escaped.push(c),
        }
    }
    escaped
}
