//! Atoms of one pose.

use rayon::prelude::*;

use super::error::MedialError;
use super::face_tree::FacesOfPose;
use super::params::CheckedMedialParams;
use super::preparation::Prepared;
use super::result::{Atom, MedialSurface};
use super::sheet_ends::end_spokes;
use super::spheres::{Fit, MedialSphere, WallOfPose};
use super::wall_atlas::{WallAtlas, joined_points};
use crate::mesh::{Point3, TriMesh, Vector3, vertex_normals};
use crate::progress::Progress;

/// Vertices between two questions whether to go on: some milliseconds.
const CHUNK: usize = 256;

/// Diameter of the largest sphere over the typical thickness: a wall four times as thick as its median is taken for none.
/// Larger finds thicker bulges, and more spheres that leak through openings. Not tuned.
const MAX_THICKNESS: f64 = 4.0;

/// Share of vertices that must have a sphere: a half, since of a wall that has fewer the usual vertex has no thickness. Not tuned.
const MIN_FITTING: f64 = 0.5;

/// Noise over the typical thickness from which lost atoms are put down to noise: the reason of a pose that fails, and what
/// refuses a cycle that has lost more than half of its atoms. Not tuned.
pub(super) const MAX_NOISE: f64 = 0.2;

/// Atoms of a wall at one pose, one per vertex of the template.
///
/// With `others`, the template is the inner surface, usually the endocardium, and the others the outer one. Without, it
/// is a closed wall, of which every vertex of both sides has its atom.
///
/// Surfaces are smoothed over [`smoothing`](super::MedialParams::smoothing), or more where they are rough; from every vertex p the largest sphere that
/// touches p and the side across gives x = p + r n, S₀ = −n, S₁ = (q − x) / r, q being where it touches across. Since the tangent plane of the
/// medial surface halves the angle between the spokes, its normal is N = (S₁ − S₀) / |S₁ − S₀|.
///
/// Of surfaces open at the base, spheres may run out; their atoms take the mean radius of their neighbours
/// and are end atoms. Where sides cross or coincide, r = 0, and atoms are end atoms too.
///
/// # Errors
/// If a surface has no area, a wall is open, half of the vertices have no sphere, or it was stopped.
pub fn medial_surface(
    template: &TriMesh,
    others: &[&TriMesh],
    params: &CheckedMedialParams,
    progress: &Progress,
) -> Result<MedialSurface, MedialError> {
    let meshes: Vec<&TriMesh> = std::iter::once(template)
        .chain(others.iter().copied())
        .collect();
    let frames = [meshes];
    let probes: Vec<u32> = (0..template.vertices().len() as u32).collect();
    let atlas = WallAtlas::new(&frames, probes, others.is_empty())?;
    progress.expect_steps(atlas.steps_per_frame());
    let pose = joined_points(&frames[0]);
    let prepared = atlas.plan(&[&pose], atlas.thickness(&pose), params, progress)?;
    atlas.surface(0, &pose, &prepared, params, progress)
}

impl WallAtlas {
    /// Steps of progress that [`Self::surface`] takes.
    pub fn steps_per_frame(&self) -> usize {
        self.probes.len().div_ceil(CHUNK)
    }

    /// Atoms at a pose of a wall that was prepared with its other poses.
    ///
    /// # Errors
    /// If half of the vertices have no sphere, or it was stopped.
    pub fn surface(
        &self,
        frame: usize,
        points: &[Point3],
        prepared: &Prepared,
        params: &CheckedMedialParams,
        progress: &Progress,
    ) -> Result<MedialSurface, MedialError> {
        let triangles = &self.connectivity.triangles;
        let Prepared {
            thickness, plan, ..
        } = *prepared;
        let smoothed = prepared.smoothed(&self.connectivity, frame, points);
        progress.check()?;
        // Of the smoother S alone: normals are derivatives, in which noise is larger than in positions.
        let normals = vertex_normals(&smoothed.once, triangles);
        let face_normals = mean_normals(&normals, triangles);
        let faces = FacesOfPose {
            points: &smoothed.points,
            triangles,
            normals: &face_normals,
        };
        let tree = self.tree.around(faces);
        let wall = WallOfPose {
            faces,
            tree: &tree,
            normals: &normals,
            boundary: &self.connectivity.boundary,
            // Angles are compared by cosines throughout, which saves an arc cosine for each face.
            cos_separation: params.separation_rad.cos(),
            max_radius: 0.5 * MAX_THICKNESS * thickness,
        };
        // Half the typical thickness is the radius where sides are parallel, and so the best first guess.
        let mut spheres = self.spheres(&wall, 0.5 * thickness, progress)?;
        let without = spheres.iter().filter(|sphere| !sphere.touches()).count();
        if without as f64 > (1.0 - MIN_FITTING) * spheres.len() as f64 {
            let atoms = spheres.len();
            return Err(
                // Noise far above the thickness is no noise but sides that coincide, which the other message
                // explains.
                if plan.noise > MAX_NOISE * thickness && plan.noise < 10.0 * thickness {
                    MedialError::Noise {
                        noise: plan.noise,
                        thickness,
                        lost: without,
                        atoms,
                    }
                } else {
                    MedialError::NoRoom {
                        frame,
                        without,
                        atoms,
                    }
                },
            );
        }
        // End atoms need some radius for the sheet to be a surface; they take no part in any number.
        self.lend_radii(&mut spheres);
        let (atoms, normals) = self.atoms(&wall, &spheres);
        let end = end_spokes(&wall, self, &spheres, &atoms, &normals, params);
        Ok(MedialSurface {
            atoms,
            normals,
            end,
        })
    }

    /// One sphere per probe. Each starts from the one before it in its chunk.
    fn spheres(
        &self,
        wall: &WallOfPose<'_>,
        radius: f64,
        progress: &Progress,
    ) -> Result<Vec<MedialSphere>, MedialError> {
        let found: Result<Vec<Vec<MedialSphere>>, _> = (self.order.par_chunks(CHUNK))
            .map(|chunk| {
                progress.step()?;
                // A chunk starts anew, so that what it finds does not depend on which thread did the one before.
                let (mut radius, mut hint) = (radius, None);
                Ok(chunk
                    .iter()
                    .map(|&probe| {
                        let sphere = wall.sphere(self.vertex(probe as usize), radius, hint);
                        if sphere.touches() {
                            (radius, hint) = (sphere.radius, sphere.face);
                        }
                        sphere
                    })
                    .collect())
            })
            .collect();
        let found = found.map_err(MedialError::Stopped)?;
        let mut spheres: Vec<Option<MedialSphere>> = vec![None; self.probes.len()];
        for (&probe, sphere) in self.order.iter().zip(found.into_iter().flatten()) {
            spheres[probe as usize] = Some(sphere);
        }
        // Every probe stands in the order once.
        Ok(spheres.into_iter().flatten().collect())
    }

    /// Spheres that leak take the mean radius of their neighbours that have one, from these outwards.
    fn lend_radii(&self, spheres: &mut [MedialSphere]) {
        let mut open: Vec<usize> = (0..spheres.len())
            .filter(|&probe| spheres[probe].fit == Fit::Leaks)
            .collect();
        if open.is_empty() {
            return;
        }
        let rows = &self.connectivity.rows;
        let mut radius_of: Vec<Option<f64>> = vec![None; self.connectivity.vertex_count()];
        let mut fitting = (0.0, 0_usize);
        for (probe, sphere) in spheres
            .iter()
            .enumerate()
            .filter(|(_, sphere)| sphere.touches())
        {
            radius_of[self.vertex(probe) as usize] = Some(sphere.radius);
            fitting = (fitting.0 + sphere.radius, fitting.1 + 1);
        }
        let mean = fitting.0 / fitting.1.max(1) as f64;
        // From those that touch outwards, one ring a round, so that a hole is filled from all its sides alike.
        while !open.is_empty() {
            let lent: Vec<Option<f64>> = (open.iter())
                .map(|&probe| {
                    let known = rows.neighbours[rows.of(self.vertex(probe) as usize)]
                        .iter()
                        .filter_map(|&other| radius_of[other as usize]);
                    let (sum, count) = known.fold((0.0, 0), |(s, n), r| (s + r, n + 1));
                    (count > 0).then(|| sum / f64::from(count))
                })
                .collect();
            // A sheet without a single sphere has no neighbour to lend: the mean ends the loop.
            let stuck = lent.iter().all(Option::is_none);
            let mut left = Vec::new();
            for (&probe, radius) in open.iter().zip(lent) {
                let Some(radius) = radius.or(stuck.then_some(mean)) else {
                    left.push(probe);
                    continue;
                };
                let vertex = self.vertex(probe) as usize;
                radius_of[vertex] = Some(radius);
                spheres[probe].radius = radius;
            }
            open = left;
        }
    }

    /// Atoms and normals from spheres.
    fn atoms(&self, wall: &WallOfPose<'_>, spheres: &[MedialSphere]) -> (Vec<Atom>, Vec<Vector3>) {
        let middle = middle_of(wall.faces);
        (spheres.iter().enumerate())
            .map(|(probe, sphere)| {
                let vertex = self.vertex(probe) as usize;
                let inwards = match wall.normals[vertex] {
                    normal if normal == Vector3::zeros() => Vector3::z(),
                    normal => normal,
                };
                let position = wall.faces.points[vertex] + sphere.radius * inwards;
                let across = sphere.across.try_normalize(0.0).unwrap_or(inwards);
                let mut spokes = [-inwards, across];
                // S₁ − S₀ vanishes where both spokes agree; the direction into the myocardium is then the only one known.
                let mut normal = (across + inwards).try_normalize(1e-9).unwrap_or(inwards);
                // Of a closed wall both sides have atoms, whose normals would point against each other.
                if self.both_sides && normal.dot(&(position - middle)) < 0.0 {
                    spokes.swap(0, 1);
                    normal = -normal;
                }
                let atom = Atom {
                    position,
                    radius: sphere.radius,
                    spokes,
                };
                (atom, normal)
            })
            .unzip()
    }
}

/// Unit means of the normals of each face's corners, steadier than its own where roughness is left.
fn mean_normals(normals: &[Vector3], triangles: &[[u32; 3]]) -> Vec<Vector3> {
    triangles
        .iter()
        .map(|triangle| {
            let sum: Vector3 = triangle.iter().map(|&v| normals[v as usize]).sum();
            sum.try_normalize(0.0).unwrap_or_default()
        })
        .collect()
}

/// Area-weighted centroid of all faces: of a cup, a point of its cavity.
fn middle_of(faces: FacesOfPose<'_>) -> Point3 {
    let (sum, whole) =
        faces
            .triangles
            .iter()
            .fold((Vector3::zeros(), 0.0), |(sum, whole), triangle| {
                let [a, b, c] = triangle.map(|v| faces.points[v as usize]);
                let area = (b - a).cross(&(c - a)).norm();
                (
                    sum + area / 3.0 * (a.coords + b.coords + c.coords),
                    whole + area,
                )
            });
    Point3::from(sum / f64::max(whole, f64::MIN_POSITIVE))
}
