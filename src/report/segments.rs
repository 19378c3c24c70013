//! The 17 segments of each subject, or four levels where the orientation is not known.

use super::assessed_wall::AssessedWall;
use super::column::{Column, Digits, Unit, column};
use super::shared;
use super::table::Row;
use crate::analysis::segments::{Level, Segment, level};
use crate::analysis::thickening::{PlaceThickening, thickening_of_levels, thickening_of_segments};
use crate::units::LengthUnit;

/// One segment, or one level where septum and anterior wall are not known.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SegmentRow {
    /// Pseudonym.
    pub subject: String,
    /// AHA number; `None` for a level.
    pub segment: Option<u8>,
    /// Its name.
    pub name: &'static str,
    /// Unit of coordinates.
    pub unit: LengthUnit,
    /// What its atoms do; `None` where it has none.
    pub thickening: Option<PlaceThickening>,
}

impl SegmentRow {
    /// The 17 segments of one subject, or its four levels where septum and anterior wall are not known; nothing
    /// where there is no long axis.
    pub fn of_wall(wall: &AssessedWall<'_>) -> Vec<Self> {
        let Some(axis) = wall.axis else {
            return Vec::new();
        };
        let row = |segment, name, thickening| Self {
            subject: wall.subject.to_owned(),
            segment,
            name,
            unit: wall.unit,
            thickening,
        };
        if axis.is_oriented() {
            let found = thickening_of_segments(wall.beat, wall.thickening, wall.segments);
            let segments = Segment::all();
            segments
                .map(|place| row(Some(place.number()), place.name(), found[place.index()]))
                .collect()
        } else {
            let atoms = &wall.beat.frames[wall.thickening.end_diastole].atoms;
            let levels: Vec<Option<Level>> = (atoms.iter())
                .map(|atom| level(axis, atom.position))
                .collect();
            let found = thickening_of_levels(wall.beat, wall.thickening, &levels);
            (Level::ALL.into_iter())
                .map(|place| row(None, place.name(), found[place.index()]))
                .collect()
        }
    }
}

impl Row for SegmentRow {
    const FILES: &'static [&'static str] = &["segments.csv"];
    const ROW: &'static str = "Wall thickening of the 17 AHA segments, or of four levels where the orientation is not known, a row per \
         segment; empty without atoms";
    const COLUMNS: &'static [Column<Self>] = &[
        shared::subject(|row| (&row.subject).into()),
        column("segment", "Segment", |row: &Self| {
            row.segment.map(usize::from).into()
        })
        .plain("AHA number of the segment; empty for a level"),
        column("name", "Name", |row: &Self| row.name.into()).plain("Name of the segment or level"),
        column("thickness_ed", "Thickness at ED", |row: &Self| {
            row.thickening
                .map(|place| place.thickness.end_diastole)
                .into()
        })
        .length("Mean wall thickness at end-diastole, area-weighted"),
        column("thickness_es", "Thickness at ES", |row: &Self| {
            row.thickening
                .map(|place| place.thickness.end_systole)
                .into()
        })
        .length("Mean wall thickness at end-systole, area-weighted"),
        column("length_unit", "Unit", |row: &Self| {
            row.unit.length_symbol().into()
        })
        .plain("Unit of thickness: mm, or units where the files do not say"),
        column("thickening_percent", "Thickening", |row: &Self| {
            row.thickening
                .and_then(|place| place.thickness.percent())
                .into()
        })
        .with(
            Unit::Percent,
            Digits::Places(0),
            "Thickening of the mean thickness from \
                     end-diastole to end-systole",
        ),
        column("pt", "Thickness ratio PT", |row: &Self| {
            row.thickening.map(|place| place.pt).into()
        })
        .plain(
            "Thickness ratio PT: thickness at end-systole relative to end-diastole, \
                     geometric mean over the segment",
        )
        .in_unit("×"),
        column("patch_share", "In patches", |row: &Self| {
            row.thickening.map(|place| place.patch_share).into()
        })
        .share("Share of the segment's area that lies in patches"),
    ];
}
