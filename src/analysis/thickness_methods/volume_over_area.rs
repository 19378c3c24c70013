//! LWT = V / A: volume of a piece of the wall over the mean of its inner and outer area.

use crate::analysis::segments::{LongAxis, Segment};
use crate::mesh::{CappedSheet, MeshError, Point3, TriMesh, Vector3, area, sheets};
use crate::progress::{Progress, Stopped};

use super::label_grid::VoxelLabel;
use super::wall_voxels::WallVoxels;

/// Pieces into which the wall is cut: as the segments lie, whether their names are known or not.
pub(super) const PIECES: usize = Segment::COUNT;

/// Triangles are cut this often in four before each part is given to the piece in which it lies.
const CUTS: u32 = 3;

/// Places within a voxel by which it is shared out among pieces.
const SAMPLES: u32 = 2;

/// Steps of a sequence that fills a cube evenly, from which these places, and those within parts of
/// triangles, are taken: were it their middle, a border along the grid or along a row of triangles would
/// take or leave whole layers at once.
///
/// Source: powers of 1/1.22074408, where 1.22074408⁴ = 1.22074408 + 1 (Roberts 2018, the R₃ sequence).
const SPREAD: [f64; 3] = [0.819_172_513, 0.671_043_607, 0.549_700_478];

/// The piece of a point between base and apex; `None` above the base.
pub(super) fn piece(axis: &LongAxis, point: Point3) -> Option<usize> {
    let depth = axis.depth(point);
    (depth >= 0.0).then(|| Segment::at(depth, axis.angle_rad(point)).index())
}

/// V / A of each piece, in coordinates; `None` where a piece has no wall or misses a side.
///
/// Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.1.2: V the volume of a small element of the
/// myocardium, A the average area of its inner and outer surface. Volumes are counted in voxels.
pub(super) fn volume_over_area(
    inner: &TriMesh,
    outer: &TriMesh,
    voxels: &WallVoxels,
    axis: &LongAxis,
    progress: &Progress,
) -> Result<[Option<f64>; PIECES], Stopped> {
    let mut volumes = [0.0; PIECES];
    let cube = voxels.spacing.powi(3);
    let mut counted = 0.0;
    for (voxel, &label) in voxels.grid.labels.iter().enumerate() {
        if voxel % 65_536 == 0 {
            progress.check()?;
        }
        if label == VoxelLabel::Wall {
            let centre = voxels.centre(voxel);
            // A voxel on a border belongs to both pieces; spread points share it out without bias.
            for _ in 0..SAMPLES {
                let within = SPREAD.map(|share| (counted * share).fract() - 0.5);
                counted += 1.0;
                let place = centre + voxels.spacing * Vector3::from(within);
                if let Some(piece) = piece(axis, place) {
                    volumes[piece] += cube / f64::from(SAMPLES);
                }
            }
        }
    }
    let mut areas = [[0.0; 2]; PIECES];
    for (side, mesh) in [inner, outer].into_iter().enumerate() {
        for triangle in mesh.triangles() {
            let corners = triangle.map(|v| mesh.vertices()[v as usize]);
            // Large faces reach over several pieces; small parts of them lie in one.
            add_area(corners, CUTS, &mut |[a, b, c], area| {
                let [mut u, mut v, _] = SPREAD.map(|share| (counted * share).fract());
                counted += 1.0;
                // Folded back into the triangle, which keeps the points evenly spread.
                if u + v > 1.0 {
                    (u, v) = (1.0 - u, 1.0 - v);
                }
                if let Some(piece) = piece(axis, a + (b - a) * u + (c - a) * v) {
                    areas[piece][side] += area;
                }
            });
        }
        progress.check()?;
    }
    Ok(std::array::from_fn(|piece| {
        let [inside, outside] = areas[piece];
        // The end of the cavity has a cap outside only; there the inner area is nil by nature.
        let measurable = volumes[piece] > 0.0 && inside > 0.0 && outside > 0.0;
        measurable.then(|| volumes[piece] / (0.5 * (inside + outside)))
    }))
}

/// Hands out the parts of a triangle with their areas.
fn add_area([a, b, c]: [Point3; 3], cuts: u32, add: &mut impl FnMut([Point3; 3], f64)) {
    if cuts == 0 {
        add([a, b, c], 0.5 * (b - a).cross(&(c - a)).norm());
        return;
    }
    let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(p, q)| nalgebra::center(&p, &q));
    for corners in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
        add_area(corners, cuts - 1, add);
    }
}

/// V / A of the whole wall between two sides, in coordinates: exact volumes inside sides and lids, areas
/// without lids. `None` if a side has no inside or the wall no volume.
pub fn mean_wall_thickness(inner: &TriMesh, outer: &TriMesh) -> Option<f64> {
    let volume = |mesh: &TriMesh| -> Option<f64> {
        let capped: Result<Vec<CappedSheet>, MeshError> = (sheets(mesh.faces()).ok()?.iter())
            .map(|sheet| CappedSheet::new(mesh.vertices().len(), sheet))
            .collect();
        let volumes = (capped.ok()?.into_iter()).map(|c| c.signed_volume(mesh.vertices()).abs());
        Some(volumes.sum())
    };
    let areas = [inner, outer].map(|mesh| area(mesh.vertices(), mesh.triangles()));
    let thickness = (volume(outer)? - volume(inner)?) / (0.5 * (areas[0] + areas[1]));
    (thickness.is_finite() && thickness > 0.0).then_some(thickness)
}
