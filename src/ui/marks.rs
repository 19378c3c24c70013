//! Shapes that stand for phases and actions; drawn, so that they need no font.

use egui::epaint::Mesh;
use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, pos2, vec2};

use crate::study::LabelClass;
use crate::ui::theme::line;

/// What a class is called.
pub fn class_name(class: LabelClass) -> &'static str {
    match class {
        LabelClass::Normal => "normal",
        LabelClass::Abnormal => "abnormal",
        LabelClass::Neither => "other",
    }
}

/// Drawn symbols on buttons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Icon {
    /// A triangle to the right.
    Play,
    /// Two bars.
    Pause,
    /// A bar and a triangle to the left: one frame back.
    StepBack,
    /// A triangle and a bar: one frame on.
    StepForward,
    /// An arrow in a ring.
    Loop,
    /// A cross.
    Close,
    /// A small triangle that points down.
    Open,
}

/// Draws an icon into a square of side `size` around `centre`.
pub fn icon(painter: &Painter, centre: Pos2, size: f32, icon: Icon, colour: Color32) {
    let h = 0.5 * size;
    let triangle = |tip: f32, tail: f32, half: f32| {
        let corners = vec![
            pos2(centre.x + tip, centre.y),
            pos2(centre.x + tail, centre.y + half),
            pos2(centre.x + tail, centre.y - half),
        ];
        Shape::convex_polygon(corners, colour, Stroke::NONE)
    };
    let bar = |x: f32, width: f32, half: f32| {
        let rect = Rect::from_center_size(centre + vec2(x, 0.0), vec2(width, 2.0 * half));
        Shape::rect_filled(rect, 0.5, colour)
    };
    let thin = Stroke::new(line::MARK, colour);
    match icon {
        Icon::Play => {
            painter.add(triangle(h, -0.7 * h, h));
        }
        Icon::Pause => {
            painter.add(bar(-0.5 * h, 0.55 * h, 0.9 * h));
            painter.add(bar(0.5 * h, 0.55 * h, 0.9 * h));
        }
        Icon::StepBack => {
            painter.add(bar(-0.75 * h, 0.3 * h, 0.8 * h));
            painter.add(triangle(-0.5 * h, 0.7 * h, 0.8 * h));
        }
        Icon::StepForward => {
            painter.add(bar(0.75 * h, 0.3 * h, 0.8 * h));
            painter.add(triangle(0.5 * h, -0.7 * h, 0.8 * h));
        }
        Icon::Loop => {
            let ring: Vec<Pos2> = (0..=20)
                .map(|i| {
                    let angle = 0.6 + 5.1 * i as f32 / 20.0;
                    centre + 0.85 * h * vec2(angle.cos(), angle.sin())
                })
                .collect();
            let end = ring.last().copied().unwrap_or(centre);
            painter.add(Shape::line(ring, thin));
            let head = vec![
                end + vec2(-0.55 * h, -0.05 * h),
                end + vec2(0.25 * h, -0.5 * h),
                end + vec2(0.25 * h, 0.4 * h),
            ];
            painter.add(Shape::convex_polygon(head, colour, Stroke::NONE));
        }
        Icon::Close => {
            let arm = 0.65 * h;
            painter.line_segment([centre - vec2(arm, arm), centre + vec2(arm, arm)], thin);
            painter.line_segment([centre - vec2(arm, -arm), centre + vec2(arm, -arm)], thin);
        }
        Icon::Open => {
            let corners = vec![
                centre + vec2(-0.7 * h, -0.35 * h),
                centre + vec2(0.7 * h, -0.35 * h),
                centre + vec2(0.0, 0.5 * h),
            ];
            painter.add(Shape::convex_polygon(corners, colour, Stroke::NONE));
        }
    }
}

/// A strip of colours between two rows of places: colour bars, and sectors of a ring.
pub fn colour_strip(columns: impl IntoIterator<Item = ([Pos2; 2], Color32)>) -> Shape {
    let mut mesh = Mesh::default();
    for (ends, colour) in columns {
        let next = mesh.vertices.len() as u32;
        for end in ends {
            mesh.colored_vertex(end, colour);
        }
        if next > 0 {
            mesh.add_triangle(next - 2, next - 1, next);
            mesh.add_triangle(next - 1, next + 1, next);
        }
    }
    Shape::mesh(mesh)
}

/// How far a place is from a straight line, and how far along it the nearest place lies.
pub fn distance_to(from: Pos2, to: Pos2, place: Pos2) -> (f32, f32) {
    let line = to - from;
    let length_squared = line.length_sq();
    let along = if length_squared > 0.0 {
        ((place - from).dot(line) / length_squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    ((from + along * line - place).length(), along)
}
