//! The orientation cube; a click on a face is a view from there.

use egui::{Align2, Color32, Pos2, Rect, Role, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, vec2};
use glam::{Quat, Vec3};

use crate::panes::commands::{Command, ViewCommand};
use crate::picture::AnatomicalView;
use crate::ui::style::note_font;
use crate::ui::theme::{Colours, colours, line};

/// Orientation of the heart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubeView {
    /// Rotation from camera axes (x right, y up, z towards the viewer) to the world.
    pub world_from_camera: Quat,
    /// Unit direction in the world from apex to base.
    pub base: Vec3,
    /// Unit direction towards the septum, square to `base`.
    pub septal: Vec3,
    /// Unit direction towards the anterior wall, square to both.
    pub anterior: Vec3,
    /// Whether these directions are known; if not, faces have no names.
    pub known: bool,
}

/// Half the side of the cube in points.
const HALF: f32 = 21.0;
/// Side of the place that it turns in.
pub const SIDE: f32 = 4.0 * HALF * 0.92;

/// One face on screen.
struct Face {
    view: AnatomicalView,
    name: &'static str,
    corners: [Pos2; 4],
    centre: Pos2,
    /// 1 when it faces the viewer.
    towards_viewer: f32,
}

/// Draws the cube in the lower right corner.
pub fn cube_ui(ui: &mut Ui, inner: Rect, view: &CubeView, commands: &mut Vec<Command>) {
    let rect = Rect::from_min_max(inner.max - Vec2::splat(SIDE), inner.max);
    let faces = visible_faces(view, rect.center());
    let response = ui.interact(rect, ui.scope_id().with("orientation cube"), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, "Orientation cube"));
    let pointed = response.hover_pos().and_then(|pointer| {
        faces
            .iter()
            .position(|face| contains(&face.corners, pointer))
    });
    let colours = colours(ui);
    for (index, face) in faces.iter().enumerate() {
        draw_face(ui, face, pointed == Some(index), view.known, colours);
    }
    crate::ui::controls::focus_ring(ui, &response);
    if response.clicked() {
        // From the keyboard, the face that is nearest the viewer.
        let nearest = faces
            .iter()
            .max_by(|a, b| a.towards_viewer.total_cmp(&b.towards_viewer));
        let chosen = match response.interact_pointer_pos() {
            Some(pointer) => faces.iter().find(|face| contains(&face.corners, pointer)),
            None => nearest,
        };
        if let Some(face) = chosen {
            commands.push(ViewCommand::ViewFrom(face.view).into());
        }
    }
    let hint = match pointed {
        Some(index) if view.known => format!("View from {}", faces[index].name),
        _ if view.known => "Orientation of the heart".to_owned(),
        _ => "Orientation of the heart; anatomical directions unknown".to_owned(),
    };
    response.on_hover_text(hint);
}

/// The faces turned towards the viewer, at most three.
fn visible_faces(view: &CubeView, centre: Pos2) -> Vec<Face> {
    let camera_from_world = view.world_from_camera.inverse();
    let on_screen = |world: Vec3| {
        let camera = camera_from_world * world;
        (centre + HALF * vec2(camera.x, -camera.y), camera.z)
    };
    sides(view)
        .into_iter()
        .filter_map(|(out, u, v, view, name)| {
            let (middle, towards_viewer) = on_screen(out);
            (towards_viewer > 0.02).then(|| Face {
                view,
                name,
                corners: [u + v, u - v, -u - v, v - u].map(|along| on_screen(out + along).0),
                centre: middle,
                towards_viewer,
            })
        })
        .collect()
}

/// Outward direction, the two directions along it, and what each face is.
#[rustfmt::skip]
fn sides(cube: &CubeView) -> [(Vec3, Vec3, Vec3, AnatomicalView, &'static str); 6] {
    let CubeView { base, septal, anterior, .. } = *cube;
    [
        (base, septal, anterior, AnatomicalView::Base, "base"),
        (-base, septal, anterior, AnatomicalView::Apex, "apex"),
        (septal, base, anterior, AnatomicalView::Septal, "septal"),
        (-septal, base, anterior, AnatomicalView::Lateral, "lateral"),
        (anterior, base, septal, AnatomicalView::Anterior, "anterior"),
        (-anterior, base, septal, AnatomicalView::Inferior, "inferior"),
    ]
}

fn draw_face(ui: &Ui, face: &Face, pointed: bool, known: bool, colours: &Colours) {
    let lit = 0.25 + 0.75 * face.towards_viewer;
    let fill: Color32 = if pointed {
        colours.accent.lerp_to_gamma(colours.pane, 0.45)
    } else {
        colours.line.lerp_to_gamma(colours.control_hovered, lit)
    };
    let edge = Stroke::new(line::THIN, colours.muted.gamma_multiply(0.6));
    ui.painter()
        .add(Shape::convex_polygon(face.corners.to_vec(), fill, edge));
    if known && face.towards_viewer > 0.34 {
        let strength = ((face.towards_viewer - 0.34) / 0.25).clamp(0.55, 1.0);
        let text = match face.view {
            AnatomicalView::Base | AnatomicalView::Apex => face.name.to_owned(),
            // The words are wider than a face; they are in the tooltip.
            _ => face.name[..1].to_uppercase(),
        };
        let colour = colours.text.gamma_multiply(strength);
        ui.painter().text(
            face.centre,
            Align2::CENTER_CENTER,
            text,
            note_font(),
            colour,
        );
    }
}

/// Whether a point lies within a convex quadrilateral given in either sense of rotation.
fn contains(corners: &[Pos2; 4], point: Pos2) -> bool {
    let side = |i: usize| {
        let (a, b) = (corners[i], corners[(i + 1) % 4]);
        (b - a).x * (point - a).y - (b - a).y * (point - a).x
    };
    let signs: Vec<f32> = (0..4).map(side).collect();
    signs.iter().all(|s| *s >= 0.0) || signs.iter().all(|s| *s <= 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    fn looking_at_the_front() -> CubeView {
        CubeView {
            world_from_camera: Quat::IDENTITY,
            base: Vec3::Y,
            septal: Vec3::NEG_X,
            anterior: Vec3::Z,
            known: true,
        }
    }

    #[test]
    fn the_face_towards_the_viewer_is_the_one_looked_at() {
        let faces = visible_faces(&looking_at_the_front(), pos2(0.0, 0.0));
        assert_eq!(faces.len(), 1);
        assert_eq!(faces[0].view, AnatomicalView::Anterior);
        assert!(contains(&faces[0].corners, pos2(5.0, -5.0)));
        assert!(!contains(&faces[0].corners, pos2(HALF + 1.0, 0.0)));
    }

    #[test]
    fn from_a_corner_three_faces_show() {
        let mut view = looking_at_the_front();
        view.world_from_camera = Quat::from_euler(glam::EulerRot::YXZ, 0.6, -0.5, 0.0);
        assert_eq!(visible_faces(&view, pos2(0.0, 0.0)).len(), 3);
    }
}
