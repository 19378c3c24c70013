//! Outlines to contours in the world of one series.

use std::collections::BTreeMap;

use super::images::{Images, SlicePlace};
use super::instants::Instants;
use super::outline::{FrameName, ImageName, Outline, OutlinePlace};
use crate::image::{Contour, VolumeFrame};
use crate::mesh::Point3;
use crate::study::Notice;
use crate::study::checks::counted;

/// Millimetres by which a contour may stand off a slice for the series to be the one that it was drawn in.
const OFF_MM: f64 = 1.5;

/// Contours and where they stand.
pub(super) struct Placed {
    /// The series; `None` where they stand in none.
    pub series: Option<usize>,
    pub contours: Vec<Contour>,
    pub notices: Vec<Notice>,
    /// Outlines whose image is not there.
    pub homeless: usize,
}

/// Finds the series that most outlines lie in, and puts them there.
pub(super) fn placed(outlines: &[Outline], images: &Images) -> Placed {
    let homes: Vec<Option<SlicePlace>> = outlines.iter().map(|o| home(o, images)).collect();
    let in_images = |outline: &&Outline| matches!(outline.place, OutlinePlace::InImage { .. });
    let mut found = Placed {
        series: series_of(outlines, &homes, images),
        contours: Vec::new(),
        notices: Vec::new(),
        homeless: (outlines.iter().filter(in_images).count())
            .saturating_sub(homes.iter().flatten().count()),
    };
    let series = found.series.unwrap_or(usize::MAX);
    let chosen = images.series.get(series);
    let frames = outlines.iter().filter_map(|outline| match &outline.place {
        OutlinePlace::InWorld { frame, .. } => Some(frame),
        OutlinePlace::InImage { .. } => None,
    });
    let instants = Instants::of(
        frames.clone(),
        chosen.map(|series| series.image.volumes().len()),
    );
    let mut elsewhere = found.homeless;
    let mut absent = 0;
    for (outline, home) in outlines.iter().zip(homes) {
        match (&outline.place, home, chosen) {
            (OutlinePlace::InImage { corners, .. }, Some(home), Some(chosen))
                if home.series == series =>
            {
                found.contours.push(Contour {
                    instant: home.instant,
                    part: outline.part,
                    points: in_the_world(chosen.image.frame(), home.slice, corners),
                });
            }
            (OutlinePlace::InImage { .. }, Some(_), _) => elsewhere += 1,
            (OutlinePlace::InImage { .. }, None, _) => {}
            (OutlinePlace::InWorld { frame, points }, _, _) => {
                match instants.instant(frame, series, images) {
                    Some(instant) => found.contours.push(Contour {
                        instant,
                        part: outline.part,
                        points: points.clone(),
                    }),
                    None => absent += 1,
                }
            }
        }
    }
    found.notices = instants.notices(frames, images);
    found.tell(
        elsewhere,
        "they were drawn in images that are not in the series",
    );
    found.tell(absent, "the series has no such instant");
    found
}

impl Placed {
    fn tell(&mut self, count: usize, why: &str) {
        if count > 0 {
            self.notices.push(Notice::warning(format!(
                "{} left out: {why}",
                counted(count, "outline", "outlines")
            )));
        }
    }
}

fn home(outline: &Outline, images: &Images) -> Option<SlicePlace> {
    match &outline.place {
        OutlinePlace::InImage { image, .. } => images.place(image),
        OutlinePlace::InWorld { frame, .. } => match frame {
            FrameName::Instance(name) => images.place(&ImageName::Instance(name.clone())),
            _ => None,
        },
    }
}

/// The series of the most images that outlines name; where they name none, that in whose slices the most of them lie.
fn series_of(outlines: &[Outline], homes: &[Option<SlicePlace>], images: &Images) -> Option<usize> {
    let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
    for home in homes.iter().flatten() {
        *counts.entry(home.series).or_default() += 1;
    }
    if counts.is_empty() {
        for (series, held) in images.series.iter().enumerate() {
            let inside = outlines.iter().filter(|outline| match &outline.place {
                OutlinePlace::InWorld { points, .. } => lies_in(held.image.frame(), points),
                OutlinePlace::InImage { .. } => false,
            });
            counts.insert(series, inside.count());
        }
    }
    let most = counts.into_iter().filter(|(_, count)| *count > 0);
    most.max_by_key(|&(series, count)| (count, usize::MAX - series))
        .map(|(series, _)| series)
}

/// Whether points lie in one slice of a grid, whichever axis is across.
fn lies_in(frame: &VolumeFrame, points: &[Point3]) -> bool {
    let voxels: Vec<Point3> = points.iter().map(|&point| frame.voxel(point)).collect();
    let size = frame.size();
    let spacing = frame.spacing();
    let inside = |axis: usize| {
        let most = size[axis] as f64 + 0.5;
        voxels
            .iter()
            .all(|voxel| (-1.5..=most).contains(&voxel[axis]))
    };
    let flat = |axis: usize| {
        let first = voxels.first().map_or(0.0, |voxel| voxel[axis].round());
        (voxels.iter()).all(|voxel| (voxel[axis] - first).abs() * spacing[axis] <= OFF_MM)
    };
    (0..3).all(inside) && (0..3).any(flat)
}

fn in_the_world(frame: &VolumeFrame, slice: usize, corners: &[[f64; 2]]) -> Vec<Point3> {
    let point = |&[column, row]: &[f64; 2]| frame.position(Point3::new(column, row, slice as f64));
    corners.iter().map(point).collect()
}
