//! The orientation cube, drawn onto a canvas: which side of the heart faces the viewer.

use crate::picture::axes::CubeFace;
use crate::picture::figure::canvas::Canvas;
use crate::picture::figure::text::{FigureFonts, Weight};
use crate::picture::tokens::PictureTheme;

/// A side faces the viewer enough for its letter to be read: 14°.
const READABLE: f32 = 0.25;

/// Draws the sides of a cube that face the viewer into a square of `size` pixels about `centre`.
pub(super) fn draw_cube(
    canvas: &mut Canvas,
    fonts: &FigureFonts,
    faces: &[CubeFace],
    world_from_camera: glam::Quat,
    centre: [f32; 2],
    size: f32,
    theme: &PictureTheme,
) {
    let camera_from_world = world_from_camera.inverse();
    // A cube of this half side turned any way stays inside the square: √3 · half = size / 2.
    let half = 0.5 * size / 3.0_f32.sqrt();
    let seen: Vec<(glam::Vec3, &str)> = faces
        .iter()
        .map(|face| (camera_from_world * face.normal, face.label))
        .collect();
    for &(normal, label) in seen.iter().filter(|(normal, _)| normal.z > 0.02) {
        let corners = face_corners(normal, &seen, half).map(|corner| on_canvas(corner, centre));
        // Faces towards the viewer are lighter, so that the cube reads as one.
        let light = 0.75 + 0.25 * normal.z;
        canvas.fill(&corners, theme.cube.map(|channel| channel * light), 1.0);
        for (i, &corner) in corners.iter().enumerate() {
            canvas.line(
                corner,
                corners[(i + 1) % 4],
                (size / 90.0).max(1.0),
                theme.line,
            );
        }
        if normal.z > READABLE {
            let letters = size * if label.len() > 1 { 0.16 } else { 0.22 };
            let middle = on_canvas(normal * half, centre);
            let width = fonts.width(label, Weight::SemiBold, letters);
            let at = [middle[0] - 0.5 * width, middle[1] + 0.36 * letters];
            fonts.draw(canvas, label, Weight::SemiBold, letters, at, theme.text);
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
fn on_canvas(point: glam::Vec3, centre: [f32; 2]) -> [f32; 2] {
    [centre[0] + point.x, centre[1] - point.y]
}
