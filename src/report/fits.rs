//! The table of `mesh` and `register`: how surfaces lie on what they were made from.

use super::column::{Cell, Column, column};
use super::table::Row;
use crate::analysis::walls_from_masks::SurfaceFit;
use crate::study::SurfaceKind;

/// One surface of one subject at one frame.
#[derive(Clone, Debug, PartialEq)]
pub struct FitRow {
    /// Whose.
    pub subject: String,
    /// How it lies.
    pub fit: SurfaceFit,
}

impl Row for FitRow {
    const FILES: &'static [&'static str] = &["fit.csv"];
    const ROW: &'static str = "`mesh` and `register`: a row per subject, frame and surface";
    const COLUMNS: &'static [Column<Self>] = &[
        column("subject", "Subject", |row: &Self| row.subject.as_str().into())
            .plain("Pseudonym of the subject"),
        column("frame", "Frame", |row: &Self| row.fit.frame.into())
            .plain("Number of the frame, from 0"),
        column("surface", "Surface", |row: &Self| word(row.fit.kind)).plain("endo or epi"),
        column("mean_mm", "Mean distance", |row: &Self| row.fit.mean_mm.into()).length(
            "Mean distance from the surface: of the mask's outlines, after slices of other breath-holds were put back, or of the mesh",
        ),
        column("p95_mm", "95th percentile", |row: &Self| row.fit.p95_mm.into())
            .length("Distance that 95 % of the outlines, or of the mesh, keep from the surface"),
        column("foldovers", "Foldovers", |row: &Self| row.fit.foldovers.into())
            .plain("Faces that are turned inwards, and pairs of faces that cross"),
        column("volume_ml", "Volume", |row: &Self| row.fit.volume_ml.into())
            .volume("Volume of the surface up to the plane of the valve; 1000 cubic units where the unit is not known"),
        column("mask_volume_ml", "Volume of the mask", |row: &Self| row.fit.mask_volume_ml.into()).volume(
            "Volume of all voxels of the mask (cavity, or cavity and wall), or of the mesh; 1000 cubic units where the unit is not known",
        ),
    ];
}

fn word(kind: SurfaceKind) -> Cell<'static> {
    match kind {
        SurfaceKind::Endocardium => "endo",
        SurfaceKind::Epicardium => "epi",
        other => other.name(),
    }
    .into()
}
