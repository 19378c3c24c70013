//! Atoms of shells whose atoms are known, and of walls that are hardly any.

mod beats;
mod damage;
mod known;
mod laws;
mod parts;
mod roughness;

use super::*;
use crate::mesh::{Faces, Point3, TriMesh, Vector3, phantom};
use crate::progress::Progress;

fn checked(smoothing: f64) -> CheckedMedialParams {
    let params = MedialParams {
        smoothing,
        ..MedialParams::default()
    };
    params.check().unwrap()
}

fn usual() -> CheckedMedialParams {
    MedialParams::default().check().unwrap()
}

fn surface(
    template: &TriMesh,
    others: &[&TriMesh],
    params: &CheckedMedialParams,
) -> Result<MedialSurface, MedialError> {
    medial_surface(template, others, params, &Progress::default())
}

fn moved(mesh: &TriMesh, by: impl Fn(usize, Point3) -> Point3) -> TriMesh {
    let points: Vec<Point3> = (mesh.vertices().iter().enumerate())
        .map(|(vertex, &point)| by(vertex, point))
        .collect();
    TriMesh::new(points, mesh.faces().clone()).unwrap()
}

/// Numbers between −1 and 1 that look like chance and are the same every time.
fn roughness(vertex: usize, seed: f64) -> Vector3 {
    let hash = |k: f64| {
        let x = ((vertex as f64 + 1.0) * 12.9898 + (k + seed) * 78.233).sin() * 43758.5453;
        2.0 * (x - x.floor()) - 1.0
    };
    Vector3::new(hash(0.0), hash(1.0), hash(2.0))
}

fn rough(mesh: &TriMesh, most: f64, seed: f64) -> TriMesh {
    moved(mesh, |vertex, point| point + most * roughness(vertex, seed))
}

/// A closed half shell: two bowls, joined by a flat rim.
fn closed_cup(inner: f64, outer: f64, rings: u32, around: u32) -> TriMesh {
    let sides = [inner, outer].map(|radius| phantom::bowl(radius, rings, around));
    let count = sides[0].vertices().len() as u32;
    let mut triangles: Vec<[u32; 3]> = sides[0]
        .triangles()
        .iter()
        .map(|&[a, b, c]| [a, c, b])
        .collect();
    triangles.extend(sides[1].triangles().iter().map(|t| t.map(|v| v + count)));
    for step in 0..around {
        let first = count - around;
        let [a, b] = [first + step, first + (step + 1) % around];
        triangles.extend([[a, b, count + b], [a, count + b, count + a]]);
    }
    let points: Vec<Point3> = sides.iter().flat_map(TriMesh::vertices).copied().collect();
    TriMesh::new(points, Faces::new(2 * count as usize, triangles).unwrap()).unwrap()
}

fn all_finite(surface: &MedialSurface) -> bool {
    let unit = |vector: &Vector3| (vector.norm() - 1.0).abs() < 1e-9;
    surface.atoms.iter().all(|atom| {
        atom.position.iter().all(|x| x.is_finite())
            && atom.radius.is_finite()
            && atom.radius >= 0.0
            && atom.spokes.iter().all(unit)
    }) && surface.normals.iter().all(unit)
        && (surface.end.iter().flatten())
            .all(|end| unit(&end.direction) && (1.0..=10.0).contains(&end.eta))
}
