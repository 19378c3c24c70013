//! The closed surface of a volume at a threshold.

use rayon::prelude::*;

use super::SurfaceError;
use super::cell_polygons::{CELL_POLYGONS, EDGES, FACES};
use super::crossings::Crossings;
use crate::image::{Mask, VolumeFrame};
use crate::mesh::{Faces, Point3, TriMesh};
use crate::progress::{Progress, Stopped};

/// Vertices of one surface, as many as a file of a mesh may have.
const MAX_VERTICES: u64 = 5_000_000;

/// Least distance of a vertex from the ends of its edge, as a share of the edge: where a value is the threshold itself
/// several vertices would lie in one place and faces have no area. Far below what any image resolves.
const MIN_SHARE: f64 = 1e-5;

/// The surface of a volume at a threshold, in millimetres: closed, manifold, with normals pointing outwards, from greater
/// values to smaller ones.
///
/// Inside is what lies above the threshold. Each edge of the grid between a voxel inside and one outside has one vertex,
/// where linear interpolation gives the threshold. Where a face of the grid has two voxels inside on one diagonal and two
/// outside on the other, those inside are connected if the bilinear interpolation at its saddle lies above the
/// threshold, f₀ f₂ > f₁ f₃ for values relative to it: cells on both sides of the face decide alike.
/// Voxels without a value (NaN or infinite) and places beyond the grid have a value below the threshold by as much as the
/// greatest value is above it: there the surface of the greatest value runs half way between voxels, as that of a mask does.
///
/// Source: Lorensen and Cline (1987), Computer Graphics 21(4), 163–169; Nielson and Hamann (1991), Visualization '91,
/// 83–91, for the saddle. The triangles within a cell are this program's own, see `cell_polygons`.
///
/// # Errors
/// If counts differ, there is no value, nothing lies on one side of the threshold, there are more than 5 million vertices,
/// or it is stopped.
pub fn isosurface(
    frame: &VolumeFrame,
    values: &[f32],
    threshold: f64,
    progress: &Progress,
) -> Result<TriMesh, SurfaceError> {
    if values.len() != frame.voxel_count() {
        return Err(SurfaceError::Count {
            values: values.len(),
            voxels: frame.voxel_count(),
        });
    }
    if !threshold.is_finite() {
        return Err(SurfaceError::Threshold);
    }
    let [smallest, greatest] = range(values).ok_or(SurfaceError::NoValues)?;
    if smallest == greatest {
        return Err(SurfaceError::Constant { value: smallest });
    }
    if f64::from(greatest) <= threshold {
        return Err(SurfaceError::NothingInside {
            threshold,
            greatest,
        });
    }
    if f64::from(smallest) > threshold {
        return Err(SurfaceError::NothingOutside {
            threshold,
            smallest,
        });
    }
    Field::new(frame, values, threshold, greatest).surface(progress)
}

/// The closed surface of a mask, half way between its voxels and those around it; see [`isosurface`]. Voxels that touch
/// along an edge or in a corner only are apart.
///
/// # Errors
/// If the mask is empty or not on the grid, there are more than 5 million vertices, or it is stopped.
pub fn mask_surface(
    frame: &VolumeFrame,
    mask: &Mask,
    progress: &Progress,
) -> Result<TriMesh, SurfaceError> {
    if mask.size() != frame.size() {
        return Err(SurfaceError::Count {
            values: mask.inside().len(),
            voxels: frame.voxel_count(),
        });
    }
    if mask.bounds().is_none() {
        return Err(SurfaceError::EmptyMask);
    }
    Field::new(frame, &mask.values(), 0.5, 1.0).surface(progress)
}

/// The smallest and the greatest finite value.
fn range(values: &[f32]) -> Option<[f32; 2]> {
    const NOTHING: [f32; 2] = [f32::INFINITY, f32::NEG_INFINITY];
    let joined = |[a, b]: [f32; 2], [c, d]: [f32; 2]| [a.min(c), b.max(d)];
    let of_some = |values: &[f32]| {
        let finite = values.iter().filter(|value| value.is_finite());
        finite.fold(NOTHING, |range, &value| joined(range, [value; 2]))
    };
    let found = values
        .par_chunks(1 << 16)
        .map(of_some)
        .reduce(|| NOTHING, joined);
    (found[0] <= found[1]).then_some(found)
}

/// Values relative to a threshold, also beyond the grid.
struct Field<'a> {
    frame: &'a VolumeFrame,
    values: &'a [f32],
    threshold: f64,
    /// Relative to the threshold, where there is no value.
    missing: f64,
}

impl<'a> Field<'a> {
    fn new(frame: &'a VolumeFrame, values: &'a [f32], threshold: f64, greatest: f32) -> Self {
        Self {
            frame,
            values,
            threshold,
            missing: threshold - f64::from(greatest),
        }
    }

    fn surface(&self, progress: &Progress) -> Result<TriMesh, SurfaceError> {
        // A value of single precision lies above the threshold just where it lies above the greatest such number below it.
        let mut bound = self.threshold as f32;
        if f64::from(bound) > self.threshold {
            bound = bound.next_down();
        }
        let is_inside = |value: f32| value > bound && value <= f32::MAX;
        let crossings = Crossings::new(self.frame.size(), self.values, is_inside);
        if crossings.vertex_count() > MAX_VERTICES {
            return Err(SurfaceError::TooManyVertices {
                vertices: crossings.vertex_count(),
                limit: MAX_VERTICES,
            });
        }
        let layers = crossings.size()[2];
        progress.expect_steps(2 * layers - 1);
        let points: Vec<Vec<Point3>> = (0..layers)
            .into_par_iter()
            .map(|k| {
                progress.step()?;
                Ok(crossings
                    .edges(k)
                    .map(|(axis, from)| self.vertex(axis, from))
                    .collect())
            })
            .collect::<Result<_, Stopped>>()?;
        let triangles: Vec<Vec<[u32; 3]>> = (0..layers - 1)
            .into_par_iter()
            .map(|k| {
                progress.step()?;
                Ok(self.triangles(&crossings, k))
            })
            .collect::<Result<_, Stopped>>()?;
        let points = points.concat();
        let faces = Faces::new(points.len(), triangles.concat())?;
        Ok(TriMesh::new(points, faces)?)
    }

    /// The value at a corner of the padded grid, relative to the threshold.
    fn relative(&self, [i, j, k]: [usize; 3]) -> f64 {
        let [nx, ny, nz] = self.frame.size();
        let within = (1..=nx).contains(&i) && (1..=ny).contains(&j) && (1..=nz).contains(&k);
        // Corner 1 of the padded grid is voxel 0.
        let value = within.then(|| self.values[i - 1 + nx * (j - 1 + ny * (k - 1))]);
        match value.filter(|value| value.is_finite()) {
            Some(value) => f64::from(value) - self.threshold,
            None => self.missing,
        }
    }

    /// Where the surface crosses the edge along an axis from a corner of the padded grid.
    fn vertex(&self, axis: usize, from: [usize; 3]) -> Point3 {
        let mut to = from;
        to[axis] += 1;
        let [a, b] = [from, to].map(|corner| self.relative(corner));
        let share = (a / (a - b)).clamp(MIN_SHARE, 1.0 - MIN_SHARE);
        let mut place = from.map(|n| n as f64 - 1.0);
        place[axis] += share;
        self.frame.position(Point3::from(place))
    }

    /// The triangles in the cells above layer k of the padded grid.
    fn triangles(&self, crossings: &Crossings, k: usize) -> Vec<[u32; 3]> {
        let mut triangles = Vec::new();
        let [a, b, c] = self.frame.steps();
        let left_handed = a.cross(&b).dot(&c) < 0.0;
        for j in 0..crossings.size()[1] - 1 {
            for (i, pattern) in crossings.cells(j, k) {
                let corner = |c: usize| [i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)];
                let connected = self.connected(CELL_POLYGONS.ambiguous(pattern), corner);
                for edges in CELL_POLYGONS.triangles(pattern, connected) {
                    let [a, b, c] = edges.map(|edge| {
                        let (axis, lower) = EDGES[usize::from(edge)];
                        crossings.vertex(axis, corner(lower))
                    });
                    triangles.push(if left_handed { [a, c, b] } else { [a, b, c] });
                }
            }
        }
        triangles
    }

    /// Which of the ambiguous faces of a cell have their corners inside connected.
    fn connected(&self, ambiguous: u8, corner: impl Fn(usize) -> [usize; 3]) -> u8 {
        let mut connected = 0;
        for (face, corners) in FACES.iter().enumerate() {
            if ambiguous >> face & 1 == 1 {
                let [a, b, c, d] = corners.map(|c| self.relative(corner(c)));
                let (one, other) = (a * c, b * d);
                let (inside, outside) = if a > 0.0 { (one, other) } else { (other, one) };
                connected |= u8::from(inside > outside) << face;
            }
        }
        connected
    }
}
