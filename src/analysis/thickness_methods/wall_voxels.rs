//! The wall between two surfaces as voxels, with the exact places at which links cross the surfaces.

use rayon::prelude::*;

use crate::mesh::{
    CappedSheet, ClosestPoint, Point3, ScanGrid, TriMesh, bounding_box, scan_lines, sheets,
};
use crate::progress::{Progress, Stopped};

use super::ThicknessError;
use super::label_grid::{Border, LabelGrid, Link, VoxelLabel, WallGraph};
use super::laplace_field::LaplaceField;

/// Voxels of a grid at most; 16 bytes are held for each.
const MAX_VOXELS: f64 = 3e7;

/// A side is not nearer to a voxel than this share of a link, so that one that touches it does not
/// outweigh all others; it moves the side by a hundredth of a voxel.
const MIN_SHARE: f64 = 0.01;

/// Share of the corners around a place, by weight, that must be known for its value to be known.
const MIN_TOLD: f64 = 0.25;

/// The wall between two sides on a grid along the axes of the coordinates.
#[derive(Clone, Debug)]
pub(super) struct WallVoxels {
    pub grid: LabelGrid,
    /// Middle of the first voxel.
    pub origin: Point3,
    /// Side of a voxel.
    pub spacing: f64,
}

impl WallVoxels {
    /// A voxel whose middle lies inside the outer side and not inside the inner one is wall. Open
    /// sides are closed by lids.
    pub fn new(
        inner: &TriMesh,
        outer: &TriMesh,
        spacing: f64,
        progress: &Progress,
    ) -> Result<Self, ThicknessError> {
        let [inner, outer] = [
            closed(inner).map_err(|reason| reason.named("inner"))?,
            closed(outer).map_err(|reason| reason.named("outer"))?,
        ];
        let corners = inner.iter().chain(&outer).flatten();
        let [low, high] = bounding_box(corners).unwrap_or_default();
        // Room for a voxel outside on every side, and no centre on the box itself.
        let origin = low.map(|x| x - 1.5 * spacing);
        let sides = (high - origin) / spacing;
        let voxels = sides.iter().map(|side| side + 3.0).product::<f64>();
        if !(spacing > 0.0 && voxels <= MAX_VOXELS) {
            return Err(ThicknessError::TooManyVoxels {
                voxels,
                most: MAX_VOXELS,
            });
        }
        let dims: [usize; 3] = std::array::from_fn(|axis| sides[axis] as usize + 3);
        progress.check()?;
        let lines = ScanGrid {
            origin: [origin.x, origin.y],
            spacing: [spacing; 2],
            lines: [dims[0], dims[1]],
        };
        let (inner, outer) =
            rayon::join(|| scan_lines(&inner, &lines), || scan_lines(&outer, &lines));
        progress.check()?;
        let plane = dims[0] * dims[1];
        let mut labels = vec![VoxelLabel::Outside; plane * dims[2]];
        labels
            .par_chunks_mut(plane)
            .enumerate()
            .for_each(|(layer, labels)| {
                let z = origin.z + spacing * layer as f64;
                // An odd number of crossings below: inside.
                let within = |line: &Vec<f64>| line.iter().filter(|&&c| c < z).count() % 2 == 1;
                for (label, (inner, outer)) in labels.iter_mut().zip(inner.iter().zip(&outer)) {
                    if within(inner) {
                        // The cavity first: it lies inside both surfaces.
                        *label = VoxelLabel::Cavity;
                    } else if within(outer) {
                        *label = VoxelLabel::Wall;
                    }
                }
            });
        let grid = LabelGrid::new(dims, [spacing; 3], labels)?;
        let voxels = grid.wall_voxels();
        if voxels == 0 {
            return Err(ThicknessError::NoWall { voxels, spacing });
        }
        Ok(Self {
            grid,
            origin,
            spacing,
        })
    }

    /// Middle of a voxel.
    pub fn centre(&self, voxel: usize) -> Point3 {
        let [nx, ny, _] = self.grid.dims;
        let place = [voxel % nx, voxel / nx % ny, voxel / (nx * ny)];
        self.origin + self.spacing * nalgebra::Vector3::from(place.map(|x| x as f64))
    }

    /// The wall as a graph whose links end where they cross the sides; a link that leaves through a lid
    /// rather than through a side, which then is more than a voxel away, meets the end of the wall.
    pub fn graph(
        &self,
        inner: &ClosestPoint,
        outer: &ClosestPoint,
        progress: &Progress,
    ) -> Result<WallGraph, Stopped> {
        let to_inner = self.distances(VoxelLabel::Cavity, inner, progress)?;
        let to_outer = self.distances(VoxelLabel::Outside, outer, progress)?;
        Ok(self.grid.graph(|voxel, next, _| {
            let Some(next) = next else {
                return Link::End;
            };
            let cavity = self.grid.labels[next] == VoxelLabel::Cavity;
            let away = if cavity { &to_inner } else { &to_outer };
            // That voxel touches its label elsewhere, such as across the base: no side crosses this link.
            if away[next] > self.spacing {
                return Link::End;
            }
            let share = away[voxel] / (away[voxel] + away[next]);
            let border = Border {
                // A crossing at the very centre would make its equation singular.
                share: if share.is_finite() { share } else { 0.5 }.clamp(MIN_SHARE, 1.0),
                beyond: 0.0,
            };
            if cavity {
                Link::Inner(border)
            } else {
                Link::Outer(border)
            }
        }))
    }

    /// Distance to a side of the voxels on both ends of links between the wall and a label; infinite
    /// elsewhere.
    fn distances(
        &self,
        label: VoxelLabel,
        side: &ClosestPoint,
        progress: &Progress,
    ) -> Result<Vec<f64>, Stopped> {
        // Voxels between two looks at the progress: some milliseconds.
        const PIECE: usize = 1_024;
        let labels = &self.grid.labels;
        let ends = [VoxelLabel::Wall, label];
        // Only where a link crosses a side: distances are the dear part.
        let wanted: Vec<usize> = (0..labels.len())
            .filter(|&voxel| {
                let other = match ends.iter().position(|&end| end == labels[voxel]) {
                    Some(place) => ends[1 - place],
                    None => return false,
                };
                (0..6).any(|direction| {
                    (self.grid.neighbour(voxel, direction))
                        .is_some_and(|next| labels[next] == other)
                })
            })
            .collect();
        let found: Vec<Vec<f64>> = (wanted.par_chunks(PIECE))
            .map(|voxels| {
                progress.check()?;
                Ok((voxels.iter())
                    .map(|&voxel| side.distance(self.centre(voxel)))
                    .collect())
            })
            .collect::<Result<_, Stopped>>()?;
        let mut distances = vec![f64::INFINITY; labels.len()];
        for (voxel, distance) in wanted.into_iter().zip(found.into_iter().flatten()) {
            distances[voxel] = distance;
        }
        Ok(distances)
    }

    /// Thickness at a place, linear between the voxels of the wall around it.
    pub fn sample(&self, field: &LaplaceField, place: Point3) -> Option<f64> {
        let at = (place - self.origin) / self.spacing;
        let low = at.map(f64::floor);
        let part = at - low;
        let [nx, ny, nz] = self.grid.dims;
        let (mut whole, mut sum) = (0.0, 0.0);
        for corner in 0..8_usize {
            let step = [corner & 1, corner >> 1 & 1, corner >> 2];
            let mut weight = 1.0;
            let mut index = [0_usize; 3];
            for axis in 0..3 {
                let up = step[axis] == 1;
                weight *= if up { part[axis] } else { 1.0 - part[axis] };
                let place = low[axis] + step[axis] as f64;
                if !(0.0..[nx, ny, nz][axis] as f64).contains(&place) {
                    return None;
                }
                index[axis] = place as usize;
            }
            let voxel = index[0] + nx * (index[1] + ny * index[2]);
            let solved = field.nodes[voxel].map(|node| field.thickness[node as usize]);
            // Corners outside the wall have no thickness; the rest share their weight.
            if let Some(thickness) = solved.filter(|value| value.is_finite()) {
                whole += weight;
                sum += weight * thickness;
            }
        }
        (whole >= MIN_TOLD).then(|| sum / whole)
    }
}

/// Why a side is not closed, before it is said which.
enum NotClosed {
    Sheet(crate::mesh::SheetError),
    Mesh(crate::mesh::MeshError),
}

impl NotClosed {
    fn named(self, side: &'static str) -> ThicknessError {
        match self {
            Self::Sheet(reason) => ThicknessError::NoInside { side, reason },
            Self::Mesh(reason) => reason.into(),
        }
    }
}

/// Corners of the triangles of all sheets, with lids.
fn closed(mesh: &TriMesh) -> Result<Vec<[Point3; 3]>, NotClosed> {
    let mut corners = Vec::new();
    for sheet in sheets(mesh.faces()).map_err(NotClosed::Sheet)? {
        let capped = CappedSheet::new(mesh.vertices().len(), &sheet).map_err(NotClosed::Mesh)?;
        corners.extend(capped.closed(mesh.vertices()));
    }
    Ok(corners)
}
