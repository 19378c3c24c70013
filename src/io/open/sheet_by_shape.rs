//! Whether a surface that is only called a ventricle is its wall or its cavity.

use crate::mesh::{Point3, TriMesh, mean_point, winding_number};
use crate::study::{Notice, SurfaceKind};

/// The sheet that a ventricle's surface is by its shape, with the sentence that says so.
///
/// The middle of a ventricle's vertices lies in the blood. The surface winds once around it if it
/// encloses the blood, and not at all if it encloses the myocardium, whose inner side takes back what
/// the outer side gives.
pub(super) fn sheet_by_shape(mesh: &TriMesh) -> (SurfaceKind, Notice) {
    let middle = mean_point(mesh.vertices().iter().copied());
    let turns = turns_around(mesh, middle).abs();
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

/// How often the surface winds around a point.
fn turns_around(mesh: &TriMesh, point: Point3) -> f64 {
    let at = |vertex: u32| mesh.vertices()[vertex as usize];
    winding_number(mesh.triangles().iter().map(|face| face.map(at)), point)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, phantom};

    #[test]
    fn a_ball_and_an_open_bowl_are_cavities() {
        let ball = phantom::sphere(2, 30.0);
        assert!((turns_around(&ball, Point3::origin()) - 1.0).abs() < 1e-12);
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
