//! The segments that patches touch, a row each, for programs that do not take lists apart.

use super::column::{Column, Digits, Unit};
use super::table::Row;
use super::wall::AssessedWall;

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
        Column::plain("subject", "Subject", "Pseudonym of the subject", |row| {
            (&row.subject).into()
        }),
        Column::plain(
            "patch",
            "Patch",
            "Number of the patch as in patches.csv",
            |row| row.patch.into(),
        ),
        Column::plain("segment", "Segment", "AHA number of the segment", |row| {
            usize::from(row.segment).into()
        }),
        Column::plain("name", "Name", "Name of the segment", |row| row.name.into()),
        share(
            "share_of_patch",
            "Share of patch",
            "Share of the patch's area that lies in the segment",
            |row| row.of_patch.into(),
        ),
        share(
            "share_of_segment",
            "Share of segment",
            "Share of the segment's area that lies in the patch",
            |row| row.of_segment.into(),
        ),
    ];
}

const fn share(
    key: &'static str,
    heading: &'static str,
    explanation: &'static str,
    cell: fn(&PatchSegmentRow) -> super::column::Cell,
) -> Column<PatchSegmentRow> {
    let digits = Digits::Places(0);
    Column::new(key, heading, Unit::Share, digits, explanation, cell)
}
