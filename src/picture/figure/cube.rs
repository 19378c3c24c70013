//! The orientation cube, drawn onto a page: which side of the heart faces the viewer.

use crate::picture::axes::CubeFace;
use crate::picture::figure::pen::Pen;
use crate::picture::page::Anchor;

/// A side faces the viewer enough for its letter to be read: 14°.
const READABLE: f32 = 0.25;

/// Draws the sides of a cube that face the viewer into a square of `size` pixels about `centre`.
pub(super) fn draw_cube(
    pen: &mut Pen<'_>,
    faces: &[CubeFace],
    world_from_camera: glam::Quat,
    centre: [f32; 2],
    size: f32,
) {
    let theme = pen.theme;
    let camera_from_world = world_from_camera.inverse();
    // A cube of this half side turned any way stays inside the square: √3 · half = size / 2.
    let half = 0.5 * size / 3.0_f32.sqrt();
    let seen: Vec<(glam::Vec3, &str)> = faces
        .iter()
        .map(|face| (camera_from_world * face.normal, face.label))
        .collect();
    for &(normal, label) in seen.iter().filter(|(normal, _)| normal.z > 0.02) {
        let corners = face_corners(normal, &seen, half).map(|corner| on_page(corner, centre));
        // Faces towards the viewer are lighter, so that the cube reads as one.
        let light = 0.75 + 0.25 * normal.z;
        pen.page
            .fill(&corners, theme.cube.map(|channel| channel * light));
        let width = (size / 90.0).max(1.0);
        pen.page.line(&corners, true, width, theme.line);
        if normal.z > READABLE {
            let letters = size * if label.len() > 1 { 0.16 } else { 0.22 };
            let middle = on_page(normal * half, centre);
            let at = [middle[0], middle[1] + 0.36 * letters];
            let set = pen.strong(theme.text, letters);
            pen.write(label, set, Anchor::Middle, at);
        }
    }
}

/// The four corners of the side with this normal, in order around it.
fn face_corners(normal: glam::Vec3, seen: &[(glam::Vec3, &str)], half: f32) -> [glam::Vec3; 4] {
    let across = seen
        .iter()
        .map(|(other, _)| *other)
        .find(|other| other.dot(normal).abs() < 0.5)
        .unwrap_or_else(|| normal.any_orthonormal_vector());
    let along = normal.cross(across);
    [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)]
        .map(|(a, b)| (normal + a * across + b * along) * half)
}

/// Camera axes to pixels: x right, y down; seen in parallel.
fn on_page(point: glam::Vec3, centre: [f32; 2]) -> [f32; 2] {
    [centre[0] + point.x, centre[1] - point.y]
}
