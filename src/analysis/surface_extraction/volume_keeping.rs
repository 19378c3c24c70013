//! Moves a surface along its normals until it encloses a given volume.

use crate::mesh::{Faces, Point3, Vector3, sheets, vertex_normals};

/// Newton steps; smooth closed surfaces need three.
const MAX_STEPS: usize = 20;
/// Difference of volumes, as a share, at which they are the same: rounding of the sum over faces of the largest meshes.
const SAME_VOLUME: f64 = 1e-11;

/// The connected closed parts of a surface with the volume that each encloses.
pub(super) struct EnclosedVolumes {
    parts: Vec<Part>,
}

struct Part {
    /// Its vertices in the surface, ascending.
    vertices: Vec<u32>,
    /// Over places in `vertices`.
    triangles: Vec<[u32; 3]>,
    volume: f64,
}

impl EnclosedVolumes {
    /// Of points on connectivity. Parts with a rim, and surfaces that branch or have one side only, enclose nothing.
    pub fn of(points: &[Point3], faces: &Faces) -> Self {
        let on_rim = faces.boundary_vertices();
        let parts = sheets(faces)
            .unwrap_or_default()
            .into_iter()
            .filter_map(|sheet| {
                let corners = || sheet.triangles.iter().flatten().copied();
                if corners().any(|v| on_rim[v as usize]) {
                    return None;
                }
                let mut vertices: Vec<u32> = corners().collect();
                vertices.sort_unstable();
                vertices.dedup();
                let place = |v: u32| vertices.binary_search(&v).unwrap_or_default() as u32;
                let triangles = sheet.triangles.iter().map(|triangle| triangle.map(place));
                let mut part = Part {
                    triangles: triangles.collect(),
                    volume: 0.0,
                    vertices,
                };
                part.volume = part.volume_and_slope(&part.taken(points), None).0;
                Some(part)
            });
        Self {
            parts: parts.collect(),
        }
    }

    /// The volumes of these parts for the parts of a mesh made of some of the vertices, those `kept`.
    pub fn for_kept(&self, kept: &[u32], points: &[Point3], faces: &Faces) -> Self {
        let all = self.parts.iter().flat_map(|part| &part.vertices);
        let mut volumes = vec![None; all.max().map_or(0, |&v| v as usize + 1)];
        for part in &self.parts {
            for &vertex in &part.vertices {
                volumes[vertex as usize] = Some(part.volume);
            }
        }
        let mut coarse = Self::of(points, faces);
        for part in &mut coarse.parts {
            let before = part.vertices.first().and_then(|&v| kept.get(v as usize));
            let volume = before.and_then(|&v| volumes.get(v as usize).copied().flatten());
            part.volume = volume.unwrap_or(part.volume);
        }
        coarse
    }

    /// Moves the points of each part along their normals, all of a part equally far, until it encloses its volume again.
    ///
    /// A part of which less than half or more than twice its volume is left is put back to where its points were `before`:
    /// smoothing shrinks a speck of few voxels to a needle or a point, and there is nothing to smooth on it.
    pub fn restore(&self, points: &mut [Point3], before: &[Point3]) {
        for part in &self.parts {
            let own = part.taken(points);
            let left = part.volume_and_slope(&own, None).0 / part.volume;
            let restored = if (0.5..=2.0).contains(&left) {
                part.offset(own)
            } else {
                None
            };
            let restored = restored.unwrap_or_else(|| part.taken(before));
            for (&vertex, point) in part.vertices.iter().zip(restored) {
                points[vertex as usize] = point;
            }
        }
    }
}

impl Part {
    fn taken(&self, points: &[Point3]) -> Vec<Point3> {
        self.vertices.iter().map(|&v| points[v as usize]).collect()
    }

    /// Its own points moved along their normals until it encloses its volume; `None` where Newton's method does not get there.
    fn offset(&self, mut own: Vec<Point3>) -> Option<Vec<Point3>> {
        for _ in 0..MAX_STEPS {
            let normals = vertex_normals(&own, &self.triangles);
            let (volume, slope) = self.volume_and_slope(&own, Some(&normals));
            let lacks = self.volume - volume;
            if lacks.abs() <= SAME_VOLUME * self.volume.abs() {
                return Some(own);
            }
            let step = lacks / slope;
            if !step.is_finite() {
                return None;
            }
            for (point, normal) in own.iter_mut().zip(&normals) {
                *point += normal * step;
            }
        }
        None
    }

    /// The volume that it encloses, and how it grows with a move along normals, of its own points.
    fn volume_and_slope(&self, own: &[Point3], normals: Option<&[Vector3]>) -> (f64, f64) {
        // Near the surface rounding stays small.
        let origin = own.first().copied().unwrap_or_default();
        let (mut volume, mut slope) = (0.0, 0.0);
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|v| own[v as usize] - origin);
            volume += a.dot(&b.cross(&c));
            if let Some(normals) = normals {
                let [p, q, r] = triangle.map(|v| normals[v as usize]);
                slope += p.dot(&b.cross(&c)) + q.dot(&c.cross(&a)) + r.dot(&a.cross(&b));
            }
        }
        (volume / 6.0, slope / 6.0)
    }
}
