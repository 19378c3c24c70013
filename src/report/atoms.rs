//! The atoms of each subject's wall over the beat, as `analyze` writes them; those of one pose are in `medial_atoms.rs`.

use std::sync::Arc;

use super::assessed_wall::AssessedWall;
use super::column::{Column, column};
use super::shared;
use super::table::Row;
use crate::mesh::Point3;

/// One atom of one frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AtomRow {
    /// Pseudonym.
    pub subject: Arc<str>,
    /// From 0.
    pub frame: usize,
    /// Vertex of the endocardium or of the inner side of a wall.
    pub vertex: u32,
    /// Centre of its sphere in coordinates.
    pub position: Point3,
    /// Radius of its sphere in coordinates.
    pub radius: f64,
    /// Radius over that at end-diastole.
    pub thickness_ratio: f64,
    /// Whether it takes part: it never lies where the medial surface ends.
    pub regular: bool,
    /// Number of its patch, from 0.
    pub patch: Option<usize>,
}

impl AtomRow {
    /// All atoms of one frame.
    pub fn of_frame(wall: &AssessedWall<'_>, frame: usize) -> Vec<Self> {
        let (beat, found) = (wall.beat, wall.thickening);
        let mut patch_of: Vec<Option<usize>> = vec![None; beat.vertices.len()];
        for (number, patch) in found.patches.iter().enumerate() {
            for &atom in &patch.atoms {
                patch_of[atom as usize] = Some(number);
            }
        }
        let end_diastole = &beat.frames[found.end_diastole].atoms;
        // Shared: a name of its own for each of half a million atoms takes longer than its numbers.
        let subject: Arc<str> = wall.subject.into();
        let atoms = beat.frames[frame].atoms.iter().enumerate();
        atoms
            .map(|(place, atom)| Self {
                subject: Arc::clone(&subject),
                frame,
                vertex: beat.vertices[place],
                position: atom.position,
                radius: atom.radius,
                thickness_ratio: atom.thickness_ratio(&end_diastole[place]),
                regular: beat.regular[place],
                patch: patch_of[place],
            })
            .collect()
    }
}

impl Row for AtomRow {
    const FILES: &'static [&'static str] = &["atoms.csv"];
    const ROW: &'static str =
        "Atoms of the medial surface, a row per vertex of the endocardium and frame";
    const COLUMNS: &'static [Column<Self>] = &[
        shared::subject(|row| (&*row.subject).into()),
        shared::frame(|row| row.frame.into()),
        column("vertex", "Vertex", |row: &Self| row.vertex.into())
            .plain("Vertex of the endocardium, numbered from 0"),
        shared::centre_x(|row| row.position.x.into()),
        shared::centre_y(|row| row.position.y.into()),
        shared::centre_z(|row| row.position.z.into()),
        shared::radius(|row| row.radius.into()),
        column("pt", "Thickness ratio PT", |row: &Self| {
            row.thickness_ratio.into()
        })
        .plain("Thickness ratio PT: radius relative to end-diastole")
        .in_unit("×"),
        column("in_patch", "In patch", |row: &Self| {
            row.patch.is_some().into()
        })
        .plain("1 if the atom lies in a patch, else 0"),
        column("regular", "Regular", |row: &Self| row.regular.into())
            .plain("1 if the atom is used; 0 if the medial surface ends there in any frame"),
        column("patch", "Patch", |row: &Self| row.patch.into())
            .plain("Number of the patch as in patches.csv; empty outside patches"),
    ];
}
