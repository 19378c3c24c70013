//! The segments that patches touch, a row each, for programs that do not take lists apart.

use super::assessed_wall::AssessedWall;
use super::column::{Column, column};
use super::shared;
use super::table::Row;

/// One segment that a patch touches.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatchSegmentRow {
    /// Pseudonym.
    pub subject: String,
    /// Number of the patch, from 0.
    pub patch: usize,
    /// AHA number of the segment.
    pub segment: u8,
    /// Its name.
    pub name: &'static str,
    /// Share of the patch that lies in the segment.
    pub of_patch: f64,
    /// Share of the segment that lies in the patch.
    pub of_segment: f64,
}

impl PatchSegmentRow {
    /// The segments of all patches of one wall, by falling share of the patch; none where the orientation is not known.
    pub fn of_wall(wall: &AssessedWall<'_>) -> Vec<Self> {
        let patches = wall.thickening.patches.iter().enumerate();
        patches
            .flat_map(|(patch, found)| {
                found.segments.iter().map(move |part| Self {
                    subject: wall.subject.to_owned(),
                    patch,
                    segment: part.segment.number(),
                    name: part.segment.name(),
                    of_patch: part.of_patch,
                    of_segment: part.of_segment,
                })
            })
            .collect()
    }
}

impl Row for PatchSegmentRow {
    const FILES: &'static [&'static str] = &["patch_segments.csv"];
    const ROW: &'static str = "AHA segments that patches touch, by falling share of the patch, a row per patch and segment; none where the \
         orientation is not known";
    const COLUMNS: &'static [Column<Self>] = &[
        shared::subject(|row| (&row.subject).into()),
        column("patch", "Patch", |row: &Self| row.patch.into())
            .plain("Number of the patch as in patches.csv"),
        column("segment", "Segment", |row: &Self| {
            usize::from(row.segment).into()
        })
        .plain("AHA number of the segment"),
        column("name", "Name", |row: &Self| row.name.into()).plain("Name of the segment"),
        column("share_of_patch", "Share of patch", |row: &Self| {
            row.of_patch.into()
        })
        .share("Share of the patch's area that lies in the segment"),
        column("share_of_segment", "Share of segment", |row: &Self| {
            row.of_segment.into()
        })
        .share("Share of the segment's area that lies in the patch"),
    ];
}
