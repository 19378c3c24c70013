//! The surface beside the slices: what the import has so far, or the walls of the subject, turned by a drag.

use std::sync::{Arc, Weak};

use egui::{Color32, Rect, Role, Sense, Ui, WidgetInfo};
use glam::{Mat3, Quat, Vec3};

use super::overlays::Shown;
use crate::mesh::{TriMesh, vertex_normals};
use crate::panes::pane_context::PaneContext;
use crate::panes::viewport::paint::{ScenePaint, pixels};
use crate::panes::viewport::viewport::Viewport;
use crate::render::{
    Camera, Geometry, GeometryPose, Scene, Shading, Surface, SurfaceColour, ViewId,
};
use crate::study::{SequenceId, SurfaceKind};
use crate::ui::theme::{Colours, colours};

/// The view of this picture: beyond those of the 3D view.
pub const SURFACE_VIEW: ViewId = ViewId(u32::MAX);
/// A drag over a point turns the surface by this much.
const TURN_RAD: f32 = 0.01;
/// At first it is seen from the front, from a little to the left and from above.
const FIRST_TURN: [f32; 2] = [-0.5, 0.35];
/// How much of the height is left free around it.
const AIR: f32 = 1.15;
/// How much the outer side covers the inner one.
const OUTER_OPACITY: f32 = 0.25;

/// What a picture was made of.
#[derive(Clone, PartialEq)]
enum Made {
    Walls(SequenceId),
    Preview(usize),
}

/// Shapes that were sent to the graphics card, as long as the same ones are shown.
#[derive(Default)]
pub struct SurfaceShapes {
    of: Option<Made>,
    // Keeps the place of a mesh in memory its own.
    preview: Weak<TriMesh>,
    shapes: Vec<(Arc<Geometry>, Option<SurfaceKind>)>,
    centre: Vec3,
    radius: f32,
    turn: Option<[f32; 2]>,
}

/// Draws the surface; nothing where there is none or no device to draw with.
pub fn surface_ui(ui: &mut Ui, cx: &PaneContext<'_>, rect: Rect, shown: &Shown) {
    let kept = cx.memo().get::<SurfaceShapes>();
    let mut kept = kept.borrow_mut();
    let Some(frame) = kept.take(shown) else {
        return;
    };
    let response = ui.interact(rect, ui.scope_id().with("surface"), Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, "Surface in the images"));
    let mut turn = kept.turn.unwrap_or(FIRST_TURN);
    let delta = response.drag_delta();
    turn[0] += TURN_RAD * delta.x;
    turn[1] = (turn[1] + TURN_RAD * delta.y).clamp(-1.5, 1.5);
    kept.turn = Some(turn);
    let has_device = cx.memo().get::<Viewport>().borrow_mut().has_device();
    if !has_device || rect.width() < 1.0 || rect.height() < 1.0 {
        return;
    }
    let paint = ScenePaint {
        view: SURFACE_VIEW,
        views: 1,
        scene: kept.scene(frame, colours(ui).pane),
        camera: kept.camera(turn),
        rect,
        size: pixels(rect, ui.pixels_per_point()),
        ctx: ui.ctx().clone(),
        meter: Arc::clone(cx.meter()),
    };
    ui.painter().add(paint.shape());
}

impl SurfaceShapes {
    /// Makes the shapes of what is shown, unless they are there; the frame of it.
    fn take(&mut self, shown: &Shown) -> Option<usize> {
        let (made, frame) = match shown {
            Shown::Nothing | Shown::Contours(_) => return None,
            Shown::Walls(subject, frame) => (Made::Walls(subject.sequence.id()), *frame),
            Shown::Preview(mesh) => (Made::Preview(Arc::as_ptr(mesh) as usize), 0),
        };
        if self.of.as_ref() == Some(&made) {
            return Some(frame);
        }
        self.shapes = match shown {
            Shown::Walls(subject, _) => (subject.sequence.surfaces().iter())
                .map(|surface| (shape(surface.frames()), Some(surface.kind())))
                .collect(),
            Shown::Preview(mesh) => {
                self.preview = Arc::downgrade(mesh);
                vec![(shape(std::slice::from_ref(&**mesh)), None)]
            }
            Shown::Nothing | Shown::Contours(_) => Vec::new(),
        };
        self.of = Some(made);
        self.place();
        Some(frame)
    }

    /// The middle of the shapes at their first pose, and how far they reach.
    fn place(&mut self) {
        let shapes = self.shapes.iter();
        let first = shapes.filter_map(|(shape, _)| shape.positions.first());
        let points: Vec<Vec3> = first.flatten().map(|point| Vec3::from(*point)).collect();
        let low = points.iter().copied().fold(Vec3::INFINITY, Vec3::min);
        let high = points.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
        self.centre = if points.is_empty() {
            Vec3::ZERO
        } else {
            0.5 * (low + high)
        };
        let far = points.iter().map(|point| point.distance(self.centre));
        self.radius = far.fold(1.0, f32::max);
    }

    fn camera(&self, [yaw, pitch]: [f32; 2]) -> Camera {
        // From the front, the head above: the left of the patient is at the right.
        let front = Mat3::from_cols(Vec3::X, Vec3::Z, Vec3::NEG_Y);
        let camera = Camera {
            target: self.centre,
            world_from_camera: Quat::from_mat3(&front),
            half_height: AIR * self.radius,
            ..Camera::default()
        };
        camera.turned(Vec3::Z, yaw, pitch)
    }

    fn scene(&self, frame: usize, background: Color32) -> Scene {
        let colours = Colours::of(true);
        let inner = |kind: &Option<SurfaceKind>| *kind != Some(SurfaceKind::Epicardium);
        let has_inner = self.shapes.iter().any(|(_, kind)| inner(kind));
        let surfaces = self.shapes.iter().map(|(geometry, kind)| {
            let colour = match kind {
                Some(SurfaceKind::Epicardium) => colours.epicardium,
                Some(_) => colours.endocardium,
                None => colours.selection,
            };
            let through = has_inner && !inner(kind);
            let frame = frame.min(geometry.positions.len().saturating_sub(1));
            Surface {
                geometry: Arc::clone(geometry),
                pose: GeometryPose {
                    from: frame,
                    to: frame,
                    blend: 0.0,
                },
                colour: SurfaceColour::Uniform(rgb(colour)),
                opacity: if through { OUTER_OPACITY } else { 1.0 },
                shading: Shading::Smooth,
                wireframe: None,
                silhouette: 0.4,
                pickable: false,
            }
        });
        let [red, green, blue] = rgb(background);
        Scene {
            surfaces: surfaces.collect(),
            lines: Vec::new(),
            points: Vec::new(),
            background: [red, green, blue, 1.0],
        }
    }
}

fn rgb(colour: Color32) -> [f32; 3] {
    [colour.r(), colour.g(), colour.b()].map(|part| f32::from(part) / 255.0)
}

/// A surface over its frames, as the graphics card takes it.
fn shape(frames: &[TriMesh]) -> Arc<Geometry> {
    let single = |v: &nalgebra::Vector3<f64>| [v.x as f32, v.y as f32, v.z as f32];
    let positions = frames.iter().map(|mesh| {
        let points = mesh.vertices().iter();
        points.map(|point| single(&point.coords)).collect()
    });
    let normals = frames.iter().map(|mesh| {
        let normals = vertex_normals(mesh.vertices(), mesh.triangles());
        normals.iter().map(single).collect()
    });
    Arc::new(Geometry {
        triangles: frames
            .first()
            .map_or_else(Vec::new, |mesh| mesh.triangles().to_vec()),
        positions: positions.collect(),
        normals: normals.collect(),
    })
}
