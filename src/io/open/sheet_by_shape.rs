//! Whether a surface that is only called a ventricle is its wall or its cavity.

use std::f64::consts::TAU;

use crate::mesh::{Point3, TriMesh};
use crate::study::{Notice, SurfaceKind};

/// The sheet that a ventricle's surface is by its shape, with the sentence that says so.
///
/// The middle of a ventricle's vertices lies in the blood. The surface winds once around it if it
/// encloses the blood, and not at all if it encloses the myocardium, whose inner side takes back what
/// the outer side gives.
pub(super) fn sheet_by_shape(mesh: &TriMesh) -> (SurfaceKind, Notice) {
    let middle = middle(mesh);
    let turns = winding_number(mesh, &middle).abs();
    // Openings at the base take up to a third of the view from the middle.
    if turns < 0.4 {
        let text =
            "identified as a wall by its shape: one closed surface with an inner and an outer side";
        (SurfaceKind::Wall, Notice::info(text))
    } else {
        let text = "identified as a cavity by its shape: one surface around one space; it may be the blood or the whole heart";
        (SurfaceKind::Cavity, Notice::warning(text))
    }
}

fn middle(mesh: &TriMesh) -> Point3 {
    let count = mesh.vertices().len().max(1) as f64;
    let sum: crate::mesh::Vector3 = mesh.vertices().iter().map(|p| p.coords).sum();
    Point3::from(sum / count)
}

/// How often the surface winds around a point: the sum of signed solid angles over 4π, each by
/// tan(Ω/2) = a·(b×c) / (|a||b||c| + (a·b)|c| + (b·c)|a| + (c·a)|b|).
///
/// Source: van Oosterom and Strackee (1983), IEEE Trans. Biomed. Eng. 30(2).
fn winding_number(mesh: &TriMesh, point: &Point3) -> f64 {
    let half_angles: f64 = mesh
        .triangles()
        .iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|vertex| mesh.vertices()[vertex as usize] - point);
            let (la, lb, lc) = (a.norm(), b.norm(), c.norm());
            let volume = a.dot(&b.cross(&c));
            let rest = la * lb * lc + a.dot(&b) * lc + b.dot(&c) * la + c.dot(&a) * lb;
            volume.atan2(rest)
        })
        .sum();
    half_angles / TAU
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, phantom};

    #[test]
    fn a_ball_and_an_open_bowl_are_cavities() {
        let ball = phantom::sphere(2, 30.0);
        assert!((winding_number(&ball, &Point3::origin()) - 1.0).abs() < 1e-12);
        assert_eq!(sheet_by_shape(&ball).0, SurfaceKind::Cavity);
        assert_eq!(
            sheet_by_shape(&phantom::bowl(30.0, 8, 16)).0,
            SurfaceKind::Cavity
        );
    }

    #[test]
    fn a_shell_is_a_wall() {
        let (inner, outer) = (phantom::sphere(2, 20.0), phantom::sphere(2, 30.0));
        let turned: Vec<[u32; 3]> = inner
            .triangles()
            .iter()
            .map(|&[a, b, c]| [a, c, b])
            .collect();
        let turned = Faces::new(inner.vertices().len(), turned).unwrap();
        let faces = Faces::joined(&[&turned, outer.faces()]);
        let points = [inner.vertices(), outer.vertices()].concat();
        let shell = TriMesh::new(points, faces).unwrap();
        assert_eq!(sheet_by_shape(&shell).0, SurfaceKind::Wall);
    }
}
