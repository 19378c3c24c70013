//! The wall of each subject as tables: its atoms over the beat, and its patches.
//!
//! Rows are made of one subject after the other, so that a cohort never is in memory as a whole.

use std::sync::Arc;

use super::column::{Cell, Column, Digits, Unit, column};
use super::shared;
use super::table::Row;
use crate::analysis::medial::MedialBeat;
use crate::analysis::segments::{LongAxis, Segment};
use crate::analysis::thickening::{Patch, PatchSegment, Thickening};
use crate::mesh::Point3;
use crate::units::LengthUnit;

/// One subject whose wall is assessed.
#[derive(Clone, Copy, Debug)]
pub struct AssessedWall<'a> {
    /// Its pseudonym.
    pub subject: &'a str,
    /// What one unit of its coordinates is.
    pub unit: LengthUnit,
    /// Its atoms over the beat.
    pub beat: &'a MedialBeat,
    /// How they thicken.
    pub thickening: &'a Thickening,
    /// Its long axis at end-diastole, where it is known.
    pub axis: Option<&'a LongAxis>,
    /// Per atom, its segment at end-diastole.
    pub segments: &'a [Option<Segment>],
}

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

/// One patch.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatchRow {
    /// Pseudonym.
    pub subject: String,
    /// Number in the list by falling area, from 0.
    pub patch: usize,
    /// Area at end-diastole; `None` where the unit of coordinates is not known.
    pub area_cm2: Option<f64>,
    /// Share of the regular medial surface at end-diastole.
    pub share: f64,
    /// Segments by falling share of the patch; empty where the orientation is not known.
    pub segments: Vec<PatchSegment>,
    /// Centroid at end-diastole in coordinates.
    pub centroid: Point3,
    /// Share of noise redraws in which it is detected again.
    pub stability: f64,
    /// Area in the shown unit of the subject.
    pub area: f64,
    /// Unit of coordinates.
    pub unit: LengthUnit,
    /// How many atoms it has.
    pub atoms: usize,
    /// Geometric mean of r(ES) / r(ED).
    pub thickness_ratio: f64,
}

impl PatchRow {
    /// Its area in cm².
    pub const AREA_CM2: Column<Self> = column("area_cm2", "Area", |row: &Self| row.area_cm2.into())
        .with(
            Unit::Symbol("cm²"),
            Digits::OneBelowTen,
            "Area on the medial surface at end-diastole; empty where coordinates are not in mm",
        )
        .or_short("cm²");
    /// Its share of the wall.
    pub const SHARE: Column<Self> = column("share", "LV share", |row: &Self| row.share.into())
        .share("Share of the medial surface of the left ventricle at end-diastole")
        .or_short("% LV");
    /// How stable its detection is.
    pub const STABILITY: Column<Self> =
        column("confidence", "Stability", |row: &Self| row.stability.into())
            .share(
                "Detection stability: share of noise redraws in which the patch is detected again",
            )
            .or_short("stab.");
    /// Its thickness ratio.
    pub const THICKNESS_RATIO: Column<Self> = column("pt", "PT", |row: &Self| {
        row.thickness_ratio.into()
    })
    .plain("PT: thickness at end-systole relative to end-diastole, geometric mean over the patch")
    .in_unit("×");
    /// Its thickening.
    pub const THICKENING: Column<Self> =
        column("thickening_percent", "Thickening", |row: &Self| {
            (100.0 * (row.thickness_ratio - 1.0)).into()
        })
        .with(
            Unit::Percent,
            Digits::Places(0),
            "Thickening from end-diastole to end-systole, 100 (PT − 1)",
        )
        .or_short("thick.");

    /// All patches of one wall, by falling area.
    pub fn of_wall(wall: &AssessedWall<'_>) -> Vec<Self> {
        let patches = wall.thickening.patches.iter().enumerate();
        patches
            .map(|(index, patch)| Self::new(wall.subject, wall.unit, index, patch))
            .collect()
    }

    /// One of them.
    pub fn new(subject: &str, unit: LengthUnit, index: usize, patch: &Patch) -> Self {
        Self {
            subject: subject.to_owned(),
            patch: index,
            area_cm2: patch.area_cm2,
            share: patch.share,
            segments: patch.segments.clone(),
            centroid: patch.centroid,
            stability: patch.confidence,
            area: patch.area * unit.area_from_square(),
            unit,
            atoms: patch.atoms.len(),
            thickness_ratio: patch.thickening.exp(),
        }
    }

    /// One value per segment, with spaces between.
    fn listed(&self, value: impl Fn(&PatchSegment) -> String) -> Cell<'static> {
        let values: Vec<String> = self.segments.iter().map(value).collect();
        values.join(" ").into()
    }
}

impl Row for PatchRow {
    const FILES: &'static [&'static str] = &["patches.csv"];
    const ROW: &'static str =
        "Patches: regions of low wall thickening, by falling area, a row per patch";
    const COLUMNS: &'static [Column<Self>] = &[
        shared::subject(|row| (&row.subject).into()),
        column("patch", "Patch", |row: &Self| row.patch.into())
            .plain("Number of the patch, from 0"),
        Self::AREA_CM2,
        Self::SHARE,
        column("segments", "Segments", |row: &Self| {
            row.listed(|part| part.segment.number().to_string())
        })
        .plain("AHA segments that the patch touches, by falling share of the patch"),
        column("x", "Centroid x", |row: &Self| row.centroid.x.into())
            .length("x of the centroid at end-diastole"),
        column("y", "Centroid y", |row: &Self| row.centroid.y.into())
            .length("y of the centroid at end-diastole"),
        column("z", "Centroid z", |row: &Self| row.centroid.z.into())
            .length("z of the centroid at end-diastole"),
        Self::STABILITY,
        column("segment_shares", "Shares of segments", |row: &Self| {
            row.listed(|part| part.of_patch.to_string())
        })
        .plain("Share of the patch in each of these segments, 0 to 1"),
        column("area", "Area", |row: &Self| row.area.into())
            .area("Area on the medial surface at end-diastole, in area_unit"),
        column("area_unit", "Unit", |row: &Self| {
            row.unit.area_symbol().into()
        })
        .plain("Unit of area: cm² where coordinates are in mm, else units²"),
        column("atoms", "Atoms", |row: &Self| row.atoms.into())
            .plain("Number of atoms of the patch"),
        Self::THICKNESS_RATIO,
        Self::THICKENING,
    ];
}

#[cfg(test)]
mod tests;
