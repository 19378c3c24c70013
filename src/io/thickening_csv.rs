//! The wall of each heart as tables: its atoms over the beat, its patches, its segments.
//!
//! Tables are made of one heart after the other, so that a cohort never is in memory as a whole.

use crate::analysis::medial::MedialBeat;
use crate::analysis::segments::{Level, LongAxis, Segment, level};
use crate::analysis::thickening::{
    PlaceThickening, Thickening, thickening_of_levels, thickening_of_segments,
};
use crate::units::LengthUnit;

use super::report_csv::{Table, number};

/// One heart whose wall was assessed.
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
    /// Its long axis at end-diastole, where it can be told.
    pub axis: Option<&'a LongAxis>,
    /// Per atom, its segment at end-diastole.
    pub segments: &'a [Option<Segment>],
}

/// The columns of [`atoms_csv`].
pub fn atoms_csv_header() -> String {
    let columns = [
        "subject", "frame", "vertex", "x", "y", "z", "r", "pt", "in_patch", "regular", "patch",
    ];
    Table::new(&columns).text
}

/// Atoms of one frame, a row per vertex of the endocardium or of the inner side of a wall: centre and radius in
/// coordinates, `pt` = r over r at end-diastole. `in_patch` and `regular` are 1 or 0; what is not regular
/// ends the medial surface at some frame and takes no part. `patch` is the number of the patch, from 0.
pub fn atoms_csv(wall: &AssessedWall<'_>, frame: usize) -> String {
    let (beat, found) = (wall.beat, wall.thickening);
    let mut patch_of: Vec<Option<usize>> = vec![None; beat.vertices.len()];
    for (number, patch) in found.patches.iter().enumerate() {
        for &atom in &patch.atoms {
            patch_of[atom as usize] = Some(number);
        }
    }
    let at_rest = &beat.frames[found.end_diastole].atoms;
    let mut table = Table::empty();
    for (place, atom) in beat.frames[frame].atoms.iter().enumerate() {
        let [x, y, z] = [0, 1, 2].map(|axis| atom.position[axis].to_string());
        let flag = |yes: bool| u8::from(yes).to_string();
        table.row([
            wall.subject.to_owned(),
            frame.to_string(),
            beat.vertices[place].to_string(),
            x,
            y,
            z,
            atom.radius.to_string(),
            atom.thickness_ratio(&at_rest[place]).to_string(),
            flag(patch_of[place].is_some()),
            flag(beat.regular[place]),
            patch_of[place].map_or_else(String::new, |patch| patch.to_string()),
        ]);
    }
    table.text
}

/// The columns of [`patches_csv`].
pub fn patches_csv_header() -> String {
    let columns = [
        "subject",
        "patch",
        "area_cm2",
        "share",
        "segments",
        "x",
        "y",
        "z",
        "confidence",
        "segment_shares",
        "area",
        "area_unit",
        "atoms",
        "pt",
    ];
    Table::new(&columns).text
}

/// The patches of one heart, by falling area, numbered from 0.
///
/// `share` is that of the regular medial surface at end-diastole; `segments` are AHA numbers by falling share of
/// the patch, which `segment_shares` gives; x, y, z its centroid at end-diastole in coordinates;
/// `pt` its geometric mean of r(ES) / r(ED) as the whole beat tells it. `area_cm2` is empty where the unit of
/// coordinates is not known, `area` then is in `area_unit`.
pub fn patches_csv(wall: &AssessedWall<'_>) -> String {
    let mut table = Table::empty();
    for (index, patch) in wall.thickening.patches.iter().enumerate() {
        let told = |cell: &dyn Fn(usize) -> String| -> String {
            let cells: Vec<String> = (0..patch.segments.len()).map(cell).collect();
            cells.join(" ")
        };
        let [x, y, z] = [0, 1, 2].map(|axis| patch.centroid[axis].to_string());
        table.row([
            wall.subject.to_owned(),
            index.to_string(),
            number(patch.area_cm2),
            patch.share.to_string(),
            told(&|place| patch.segments[place].segment.number().to_string()),
            x,
            y,
            z,
            patch.confidence.to_string(),
            told(&|place| patch.segments[place].of_patch.to_string()),
            (patch.area * wall.unit.area_from_square()).to_string(),
            wall.unit.area_symbol().to_owned(),
            patch.atoms.len().to_string(),
            patch.thickening.exp().to_string(),
        ]);
    }
    table.text
}

/// The columns of [`segments_csv`].
pub fn segments_csv_header() -> String {
    let columns = [
        "subject",
        "segment",
        "name",
        "thickness_ed",
        "thickness_es",
        "length_unit",
        "thickening_percent",
        "pt",
        "patch_share",
    ];
    Table::new(&columns).text
}

/// The 17 segments of one heart, or, where septum and anterior wall are not known, its four levels without a
/// number; nothing where there is no long axis.
///
/// Thickness is 2 r, means are weighted by area at end-diastole; `thickening_percent` is that of the
/// mean thickness, `pt` the geometric mean of r(ES) / r(ED), `patch_share` the share of its area
/// that lies in patches. Cells are empty where a place has no atoms.
pub fn segments_csv(wall: &AssessedWall<'_>) -> String {
    let mut table = Table::empty();
    let Some(axis) = wall.axis else {
        return table.text;
    };
    if axis.is_oriented() {
        let found = thickening_of_segments(wall.beat, wall.thickening, wall.segments);
        for segment in Segment::all() {
            let number = segment.number().to_string();
            table.row(place_row(
                wall,
                number,
                segment.name(),
                found[segment.index()],
            ));
        }
    } else {
        let atoms = &wall.beat.frames[wall.thickening.end_diastole].atoms;
        let levels: Vec<Option<Level>> = (atoms.iter())
            .map(|atom| level(axis, atom.position))
            .collect();
        let found = thickening_of_levels(wall.beat, wall.thickening, &levels);
        for level in Level::ALL {
            table.row(place_row(
                wall,
                String::new(),
                level.name(),
                found[level.index()],
            ));
        }
    }
    table.text
}

fn place_row(
    wall: &AssessedWall<'_>,
    segment: String,
    name: &str,
    place: Option<PlaceThickening>,
) -> [String; 9] {
    let thickness = place.map(|place| place.thickness);
    [
        wall.subject.to_owned(),
        segment,
        name.to_owned(),
        number(thickness.map(|thickness| thickness.end_diastole)),
        number(thickness.map(|thickness| thickness.end_systole)),
        wall.unit.length_symbol().to_owned(),
        number(thickness.and_then(|thickness| thickness.percent())),
        number(place.map(|place| place.pt)),
        number(place.map(|place| place.patch_share)),
    ]
}

#[cfg(test)]
mod tests;
