//! Where the slices of a gamma camera's tomogram stand (PS3.3, C.8.4.11 and C.8.4.15).

use super::element::DataSet;
use super::layout::Layout;
use super::plane::{directions, spacing};
use super::tag::{
    DETECTOR_INFORMATION, ORIENTATION, PIXEL_SPACING, POSITION, SLICE_THICKNESS,
    SPACING_BETWEEN_SLICES,
};
use crate::image::VolumeFrame;
use crate::io::image_file::{Provenance, ReadImageError};
use crate::mesh::{Point3, Vector3};
use crate::study::Notice;

/// The grid of a file, and what of it the file says.
pub(super) struct NuclearGrid {
    pub(super) frame: VolumeFrame,
    pub(super) spacing: Provenance,
    pub(super) position_known: bool,
}

/// The grid of `slices` slices. Slice k, counted from 0, stands at position + k · distance · (row × column): the distance
/// keeps its sign, which says on which side of the first the second slice lies (rordenlab/dcm2niix#885).
///
/// Position and orientation stand in the description of the detector (ClearCanvas/ClearCanvas#209).
///
/// # Errors
/// If the numbers make no grid.
pub(super) fn nuclear_grid(
    set: &DataSet<'_>,
    layout: &Layout,
    slices: usize,
    notices: &mut Vec<Notice>,
) -> Result<NuclearGrid, ReadImageError> {
    let detector = set.item(DETECTOR_INFORMATION);
    let numbers = |tag| {
        let inside = detector.as_ref().and_then(|detector| detector.numbers(tag));
        inside.or_else(|| set.numbers(tag))
    };
    let position = numbers(POSITION).and_then(|p| p.first_chunk().copied());
    let directions = directions(numbers(ORIENTATION));
    let in_plane = spacing(numbers(PIXEL_SPACING));
    let mut source = Provenance::Stated;
    if in_plane.is_none() {
        source = Provenance::Missing;
        notices.push(Notice::warning(
            "the file does not say the distance of its pixels",
        ));
    }
    let nonzero = |tag| set.number(tag).filter(|&mm| mm != 0.0);
    let distance = match (nonzero(SPACING_BETWEEN_SLICES), nonzero(SLICE_THICKNESS)) {
        (Some(distance), _) => distance,
        (None, Some(thickness)) => {
            notices.push(Notice::warning(format!(
                "the file does not say the distance of its slices; their thickness of {thickness} mm stands for it"
            )));
            thickness.abs()
        }
        (None, None) => {
            source = Provenance::Missing;
            notices.push(Notice::warning(
                "the file does not say the distance of its slices",
            ));
            1.0
        }
    };
    let position_known = position.is_some() && directions.is_some();
    if !position_known {
        let what = match (position, directions) {
            (None, None) => "neither position nor orientation of its slices",
            (None, Some(_)) => "no position of its slices",
            _ => "no orientation of its slices",
        };
        notices.push(Notice::warning(format!(
            "the file says {what}: only distances are known, not where the volume stands in the patient"
        )));
    }
    let axes = [Vector3::x(), Vector3::y()];
    let [row, column] = directions.unwrap_or(axes);
    if position_known && [row, column] == axes {
        notices.push(Notice::info(
            "the orientation is that of the patient's own axes; some programs write it also for slices of other directions",
        ));
    }
    let [rows_mm, columns_mm] = in_plane.unwrap_or([1.0; 2]);
    let [x, y, z] = position.filter(|_| position_known).unwrap_or([0.0; 3]);
    let steps = [
        row * columns_mm,
        column * rows_mm,
        row.cross(&column).normalize() * distance,
    ];
    let size = [layout.columns, layout.rows, slices];
    Ok(NuclearGrid {
        frame: VolumeFrame::new(size, Point3::new(x, y, z), steps)?,
        spacing: source,
        position_known,
    })
}
