//! Contours to masks on a grid that is fine enough for their areas.

use std::collections::BTreeSet;
use std::sync::Arc;

use rayon::prelude::*;

use super::ContourError;
use super::coverage::Coverage;
use super::placing::{Placed, Placing, area, plane_distances_mm};
use crate::analysis::walls_from_masks::{Masks, Tissue};
use crate::image::{Contour, ContourPart, VolumeFrame};
use crate::mesh::{Point3, Vector3};

/// Voxels of the smallest contour: as many as its area says, to the nearest whole one, which is 0.25 % of 200.
const MIN_PIXELS: f64 = 200.0;
/// Voxels of the largest contour: its outline then has steps of half a millimetre in an adult.
const MIN_PIXELS_OF_LARGEST: f64 = 8_000.0;
/// Longest voxel within slices relative to the distance of slices, so that it is plain what is a slice.
const MAX_SHARE_OF_STEP: f64 = 0.6;
/// Finest parts of a voxel along an axis.
const MAX_PARTS: usize = 32;
/// Voxels of all instants, one byte each.
const MAX_VOXELS: u64 = 1 << 27;
/// Voxels of the image that are kept around the contours.
const MARGIN: f64 = 2.0;

/// Masks of what contours enclose: cavity within the endocardium, wall between endocardium and epicardium, right ventricle
/// outside of both. Slices are those of `frame`, of which the part around the contours is kept, on a grid that divides its
/// voxels within the slices. Several contours of one part in a slice count together.
///
/// The voxels of a contour are as many as its area over that of a voxel, rounded: areas are exact to half a voxel, which is
/// at most 0.25 % (less than 200 voxels has only what is far smaller than the largest contour of very many slices and
/// instants, which bound the grid).
///
/// # Errors
/// If there is no contour, or one that encloses no area, is oblique, lies between slices, outside of the image, or at an
/// instant that is not there; or if the contours reach over too many voxels.
pub fn masks_of_contours(
    frame: &VolumeFrame,
    instants: usize,
    contours: &[Contour],
) -> Result<Masks, ContourError> {
    let placing = Placing::of(frame, instants, contours)?;
    let grid = FineGrid::of(frame, &placing)?;
    // Of a beat often two instants are drawn: all others share one empty mask.
    let empty: Arc<[Tissue]> = grid.painted(&std::iter::empty()).into();
    let masks: Vec<Arc<[Tissue]>> = (0..instants)
        .into_par_iter()
        .map(|instant| {
            let own = placing.contours.iter().filter(|c| c.instant == instant);
            match own.clone().next() {
                Some(_) => grid.painted(&own).into(),
                None => empty.clone(),
            }
        })
        .collect();
    Ok(Masks::new(grid.frame, masks)?)
}

/// The grid of the masks.
struct FineGrid {
    frame: VolumeFrame,
    /// Two axes within slices, and the one across.
    axes: [usize; 3],
    /// The lowest corner of the kept part, in voxels of the image.
    corner: [f64; 2],
    /// Parts that each voxel is divided into along both axes.
    parts: usize,
}

impl FineGrid {
    fn of(frame: &VolumeFrame, placing: &Placing) -> Result<Self, ContourError> {
        let [u, v, across] = placing.axes;
        let all = || placing.contours.iter().flat_map(|c| &c.corners);
        let low = [0, 1].map(|axis| {
            let least = all()
                .map(|corner| corner[axis])
                .fold(f64::INFINITY, f64::min);
            (least + 0.5).floor() - MARGIN - 0.5
        });
        let size = [0, 1].map(|axis| {
            let greatest = all()
                .map(|corner| corner[axis])
                .fold(f64::NEG_INFINITY, f64::max);
            // Contours lie within the image but for a voxel, so that this is a small number.
            ((greatest + 0.5).ceil() + MARGIN - 0.5 - low[axis]).round() as usize
        });
        let slices = frame.size()[across];
        let drawn = placing
            .contours
            .iter()
            .map(|c| c.instant)
            .collect::<BTreeSet<_>>();
        let drawn = drawn.len() as u64;
        let coarse = (size[0] as u64)
            .saturating_mul(size[1] as u64)
            .saturating_mul(slices as u64)
            .saturating_mul(drawn + 1);
        if coarse > MAX_VOXELS {
            return Err(ContourError::TooLarge {
                voxels: coarse,
                most: MAX_VOXELS,
            });
        }
        let mut parts = wanted_parts(frame, placing);
        while parts > 1 && coarse.saturating_mul((parts * parts) as u64) > MAX_VOXELS {
            parts -= 1;
        }
        let fine = parts as f64;
        let mut origin = Point3::origin();
        for (axis, low) in [u, v].into_iter().zip(low) {
            origin[axis] = low + 0.5 / fine;
        }
        let mut fine_size = [slices; 3];
        let mut steps: [Vector3; 3] = frame.steps();
        for (axis, size) in [u, v].into_iter().zip(size) {
            fine_size[axis] = size * parts;
            steps[axis] /= fine;
        }
        Ok(Self {
            frame: VolumeFrame::new(fine_size, frame.position(origin), steps)?,
            axes: placing.axes,
            corner: low,
            parts,
        })
    }

    /// The tissues of one instant.
    fn painted<'a>(&self, contours: &(impl Iterator<Item = &'a Placed> + Clone)) -> Vec<Tissue> {
        let mut voxels = vec![Tissue::Other; self.frame.voxel_count()];
        // What comes later lies within or before what came.
        for (part, tissue) in [
            (ContourPart::RightCavity, Tissue::RightCavity),
            (ContourPart::Epicardium, Tissue::Wall),
            (ContourPart::Endocardium, Tissue::Cavity),
        ] {
            for contour in contours.clone().filter(|c| c.part == part) {
                self.paint(contour, tissue, &mut voxels);
            }
        }
        voxels
    }

    fn paint(&self, contour: &Placed, tissue: Tissue, voxels: &mut [Tissue]) {
        let [u, v, across] = self.axes;
        let size = self.frame.size();
        let strides = [1, size[0], size[0] * size[1]];
        let fine = self.parts as f64;
        let corners: Vec<[f64; 2]> = (contour.corners.iter())
            .map(|c| [0, 1].map(|axis| (c[axis] - self.corner[axis]) * fine))
            .collect();
        let Some(coverage) = Coverage::of(&corners, [size[u], size[v]]) else {
            return;
        };
        for [i, j] in coverage.pixels() {
            let place = i * strides[u] + j * strides[v] + contour.slice * strides[across];
            if let Some(voxel) = voxels.get_mut(place) {
                *voxel = tissue;
            }
        }
    }
}

/// Parts of a voxel that the areas of the contours and the distance of slices call for.
fn wanted_parts(frame: &VolumeFrame, placing: &Placing) -> usize {
    let areas = placing.contours.iter().map(|c| area(&c.corners).abs());
    let least = areas.clone().fold(f64::INFINITY, f64::min);
    let greatest = areas.fold(0.0, f64::max);
    let [u, v, across] = placing.axes;
    let spacing = frame.spacing();
    let by_step =
        spacing[u].max(spacing[v]) / (MAX_SHARE_OF_STEP * plane_distances_mm(frame)[across]);
    let wanted = (MIN_PIXELS / least)
        .max(MIN_PIXELS_OF_LARGEST / greatest)
        .sqrt()
        .max(by_step);
    (wanted.ceil().min(MAX_PARTS as f64) as usize).max(1)
}
