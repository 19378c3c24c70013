//! Round corners of panes, over pictures too.

use egui::epaint::Mesh;
use egui::{Color32, Rect, pos2};

/// What lies outside the rounded corners of a rectangle, so that pictures have round corners too.
pub fn corner_masks(rect: Rect, radius: f32, colour: Color32) -> Mesh {
    const STEPS: u32 = 6;
    let mut mesh = Mesh::default();
    for (corner, x, y) in [
        (rect.left_top(), 1.0, 1.0),
        (rect.right_top(), -1.0, 1.0),
        (rect.right_bottom(), -1.0, -1.0),
        (rect.left_bottom(), 1.0, -1.0),
    ] {
        let start = mesh.vertices.len() as u32;
        mesh.colored_vertex(corner, colour);
        for step in 0..=STEPS {
            let angle = std::f32::consts::FRAC_PI_2 * step as f32 / STEPS as f32;
            let place = pos2(
                corner.x + x * radius * (1.0 - angle.cos()),
                corner.y + y * radius * (1.0 - angle.sin()),
            );
            mesh.colored_vertex(place, colour);
        }
        for step in 0..STEPS {
            mesh.add_triangle(start, start + 1 + step, start + 2 + step);
        }
    }
    mesh
}
