//! Tests of the mesh formats together: files of other programs, round trips, damage.

mod attacks;
mod by_hand;
mod damage;
mod damaged_images;
mod gltf_by_hand;
mod no_numbers;
mod other_habits;
mod other_programs;
mod round_trips;
mod text_habits;

use super::{Limits, MeshFile, read_mesh};

/// Reads a file that has to be read.
fn read(name: &str, bytes: impl AsRef<[u8]>) -> MeshFile {
    read_mesh(name, bytes.as_ref(), &Limits::default()).unwrap_or_else(|error| {
        let text = String::from_utf8_lossy(bytes.as_ref());
        panic!("{name}: {error}\n{text}")
    })
}

/// The error of a file that has to be refused.
fn error(name: &str, bytes: impl AsRef<[u8]>) -> String {
    match read_mesh(name, bytes.as_ref(), &Limits::default()) {
        Ok(_) => panic!(
            "{name} is read:\n{}",
            String::from_utf8_lossy(bytes.as_ref())
        ),
        Err(error) => error.to_string(),
    }
}

/// One triangle in every text format. `X` stands for a coordinate that is 1, which is the same place in all.
const TRIANGLES: [(&str, &str); 6] = [
    ("a.obj", "# one\nv 0 0 0\nv X 0 0\nv 0 1 0\nf 1 2 3\n"),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
         property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
         0 0 0\nX 0 0\n0 1 0\n3 0 1 2\n",
    ),
    (
        "a.stl",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex X 0 0\nvertex 0 1 0\n\
         endloop\nendfacet\nendsolid a\n",
    ),
    (
        "a.vtk",
        "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0\nX 0 0\n\
         0 1 0\nPOLYGONS 1 4\n3 0 1 2\n",
    ),
    (
        "a.vtp",
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">\n<PolyData>\n\
         <Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\">\n<Points>\n\
         <DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">\n0 0 0\nX 0 0\n\
         0 1 0\n</DataArray>\n</Points>\n<Polys>\n\
         <DataArray type=\"Int32\" Name=\"connectivity\">0 1 2</DataArray>\n\
         <DataArray type=\"Int32\" Name=\"offsets\">3</DataArray>\n\
         </Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n",
    ),
    ("a.csv", "kind,x,y,z\nv,0,0,0\nv,X,0,0\nv,0,1,0\nf,0,1,2\n"),
];

/// The triangle in one format, with a word where the coordinate is, and the line of that word.
fn triangle(name: &str, coordinate: &str) -> (String, usize) {
    let (_, text) = TRIANGLES.iter().find(|(other, _)| *other == name).unwrap();
    let at = text.find('X').unwrap();
    let line = text[..=at].lines().count();
    (text.replacen('X', coordinate, 1), line)
}
