//! Atoms of one wall at one pose, as the `medial` command writes them.

use super::column::{Cell, Column, Digits, Unit};
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
        Column::plain(
            "vertex",
            "Vertex",
            "Vertex of the template, numbered from 0",
            |row| row.vertex.into(),
        ),
        Column::length(
            "x",
            "Centre x",
            "x of the centre of the inscribed sphere",
            |row| row.atom.position.x.into(),
        ),
        Column::length(
            "y",
            "Centre y",
            "y of the centre of the inscribed sphere",
            |row| row.atom.position.y.into(),
        ),
        Column::length(
            "z",
            "Centre z",
            "z of the centre of the inscribed sphere",
            |row| row.atom.position.z.into(),
        ),
        Column::length(
            "r",
            "Radius",
            "Radius of the inscribed sphere, half of the wall thickness",
            |row| row.atom.radius.into(),
        ),
        direction(
            "s0x",
            "Inner spoke x",
            "x of the unit spoke to the inner side",
            |row| row.atom.spokes[0].x.into(),
        ),
        direction(
            "s0y",
            "Inner spoke y",
            "y of the unit spoke to the inner side",
            |row| row.atom.spokes[0].y.into(),
        ),
        direction(
            "s0z",
            "Inner spoke z",
            "z of the unit spoke to the inner side",
            |row| row.atom.spokes[0].z.into(),
        ),
        direction(
            "s1x",
            "Outer spoke x",
            "x of the unit spoke to the outer side",
            |row| row.atom.spokes[1].x.into(),
        ),
        direction(
            "s1y",
            "Outer spoke y",
            "y of the unit spoke to the outer side",
            |row| row.atom.spokes[1].y.into(),
        ),
        direction(
            "s1z",
            "Outer spoke z",
            "z of the unit spoke to the outer side",
            |row| row.atom.spokes[1].z.into(),
        ),
        direction(
            "nx",
            "Normal x",
            "x of the unit normal from the inner to the outer side",
            |row| row.normal.x.into(),
        ),
        direction(
            "ny",
            "Normal y",
            "y of the unit normal from the inner to the outer side",
            |row| row.normal.y.into(),
        ),
        direction(
            "nz",
            "Normal z",
            "z of the unit normal from the inner to the outer side",
            |row| row.normal.z.into(),
        ),
        Column::plain(
            "end",
            "End",
            "1 where the medial surface ends and r is no wall thickness, else 0",
            |row| row.end.into(),
        ),
    ];
}

const fn direction(
    key: &'static str,
    heading: &'static str,
    explanation: &'static str,
    cell: fn(&MedialAtomRow) -> Cell,
) -> Column<MedialAtomRow> {
    Column::new(
        key,
        heading,
        Unit::None,
        Digits::Places(3),
        explanation,
        cell,
    )
}
