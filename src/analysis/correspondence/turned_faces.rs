//! Faces of a template that came to lie the wrong way round.

use rayon::prelude::*;

use super::target_surface::TargetSurface;
use crate::mesh::{Point3, Vector3, mean_point, vertex_normals};

/// Faces whose normal looks against that of the target beside them; where the target has none, against the mean of their
/// neighbours'. `outward` is 1 where faces are wound so that normals point out.
pub(super) fn turned_faces(
    points: &[Point3],
    triangles: &[[u32; 3]],
    target: &TargetSurface,
    outward: f64,
) -> Vec<usize> {
    let own = match target.is_oriented() {
        true => Vec::new(),
        false => vertex_normals(points, triangles),
    };
    let turned = |face: &usize| {
        let triangle = &triangles[*face];
        let [a, b, c] = triangle.map(|v| points[v as usize]);
        let normal = outward * (b - a).cross(&(c - a));
        let beside = match target.normal(target.nearest(middle(points, triangle)).face) {
            Some(normal) => normal,
            None => outward * triangle.iter().map(|&v| own[v as usize]).sum::<Vector3>(),
        };
        normal.dot(&beside) <= 0.0
    };
    let faces = (0..triangles.len()).into_par_iter();
    faces.filter(turned).collect()
}

/// The middle of a triangle.
pub(super) fn middle(points: &[Point3], triangle: &[u32; 3]) -> Point3 {
    mean_point(triangle.map(|v| points[v as usize]).into_iter())
}
