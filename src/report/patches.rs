//! The patches of each subject's wall: the columns of `patches.csv`, and which of them pane, figure and summary show.

use super::assessed_wall::AssessedWall;
use super::column::{Cell, Column, Digits, Unit, column};
use super::shared;
use super::table::Row;
use crate::analysis::thickening::{Patch, PatchSegment};
use crate::mesh::Point3;
use crate::units::LengthUnit;

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

    /// What the table of the patch pane shows, in its order. What has no room in a narrow pane comes last.
    pub const IN_PANE: [Column<Self>; 4] = [
        Self::AREA_CM2,
        Self::SHARE,
        Self::THICKENING,
        Self::STABILITY,
    ];
    /// What the table of a patch figure shows, in its order; the widths stand in `picture/figure/patch/content.rs`.
    pub const IN_FIGURE: [Column<Self>; 4] = [
        Self::AREA_CM2,
        Self::SHARE,
        Self::THICKNESS_RATIO,
        Self::STABILITY,
    ];
    /// The numbers of a patch in the summary of an analysis.
    pub(super) const IN_SUMMARY: [Column<Self>; 4] = [
        Self::AREA_CM2,
        Self::SHARE,
        Self::STABILITY,
        Self::THICKNESS_RATIO,
    ];

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
            stability: patch.stability,
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
