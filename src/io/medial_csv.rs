//! Atoms of a wall as a table for scripts.

use crate::analysis::medial::MedialSurface;

use super::report_csv::Table;

/// Atoms of one pose, a row per vertex of the template: centre and radius in coordinates, unit spokes to the inner and the
/// outer side, unit normal from the inner to the outer side; `end` is 1 where the sheet ends and r is no thickness.
pub fn medial_csv(surface: &MedialSurface) -> String {
    let mut table = Table::new(&[
        "vertex", "x", "y", "z", "r", "s0x", "s0y", "s0z", "s1x", "s1y", "s1z", "nx", "ny", "nz",
        "end",
    ]);
    let atoms = surface.atoms.iter().zip(&surface.normals);
    for (vertex, ((atom, normal), end)) in atoms.zip(&surface.end).enumerate() {
        let [inner, outer] = atom.spokes;
        let mut row = vec![vertex.to_string()];
        row.extend(atom.position.iter().map(f64::to_string));
        row.push(atom.radius.to_string());
        row.extend((inner.iter().chain(&outer).chain(normal)).map(f64::to_string));
        row.push(u8::from(end.is_some()).to_string());
        table.row(row);
    }
    table.text
}
