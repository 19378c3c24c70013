//! Atoms of one wall at one pose, as the `medial` command writes them.

use super::column::{Column, column};
use super::shared;
use super::table::Row;
use crate::analysis::medial::{Atom, MedialSurface};
use crate::mesh::Vector3;

/// One atom of one pose.
#[derive(Clone, Debug, PartialEq)]
pub struct MedialAtomRow {
    /// Vertex of the template, from 0.
    pub vertex: usize,
    /// Its sphere and spokes.
    pub atom: Atom,
    /// Unit normal of the medial surface, from the inner to the outer side.
    pub normal: Vector3,
    /// Whether the medial surface ends here; then the radius is no wall thickness.
    pub end: bool,
}

impl MedialAtomRow {
    /// All atoms of a pose.
    pub fn of_surface(surface: &MedialSurface) -> Vec<Self> {
        let atoms = surface.atoms.iter().zip(&surface.normals);
        (atoms.zip(&surface.end).enumerate())
            .map(|(vertex, ((atom, normal), end))| Self {
                vertex,
                atom: *atom,
                normal: *normal,
                end: end.is_some(),
            })
            .collect()
    }
}

impl Row for MedialAtomRow {
    const FILES: &'static [&'static str] = &["the file of `medial --out`"];
    const ROW: &'static str = "Atoms of one pose, a row per vertex of the template";
    const COLUMNS: &'static [Column<Self>] = &[
        column("vertex", "Vertex", |row: &Self| row.vertex.into())
            .plain("Vertex of the template, numbered from 0"),
        shared::centre_x(|row| row.atom.position.x.into()),
        shared::centre_y(|row| row.atom.position.y.into()),
        shared::centre_z(|row| row.atom.position.z.into()),
        shared::radius(|row| row.atom.radius.into()),
        column("s0x", "Inner spoke x", |row: &Self| {
            row.atom.spokes[0].x.into()
        })
        .coordinate("x of the unit spoke to the inner side"),
        column("s0y", "Inner spoke y", |row: &Self| {
            row.atom.spokes[0].y.into()
        })
        .coordinate("y of the unit spoke to the inner side"),
        column("s0z", "Inner spoke z", |row: &Self| {
            row.atom.spokes[0].z.into()
        })
        .coordinate("z of the unit spoke to the inner side"),
        column("s1x", "Outer spoke x", |row: &Self| {
            row.atom.spokes[1].x.into()
        })
        .coordinate("x of the unit spoke to the outer side"),
        column("s1y", "Outer spoke y", |row: &Self| {
            row.atom.spokes[1].y.into()
        })
        .coordinate("y of the unit spoke to the outer side"),
        column("s1z", "Outer spoke z", |row: &Self| {
            row.atom.spokes[1].z.into()
        })
        .coordinate("z of the unit spoke to the outer side"),
        column("nx", "Normal x", |row: &Self| row.normal.x.into())
            .coordinate("x of the unit normal from the inner to the outer side"),
        column("ny", "Normal y", |row: &Self| row.normal.y.into())
            .coordinate("y of the unit normal from the inner to the outer side"),
        column("nz", "Normal z", |row: &Self| row.normal.z.into())
            .coordinate("z of the unit normal from the inner to the outer side"),
        column("end", "End", |row: &Self| row.end.into())
            .plain("1 where the medial surface ends and r is no wall thickness, else 0"),
    ];
}
