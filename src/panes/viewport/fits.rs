//! Cameras that fit hearts into their cells, kept while heart, direction and shape of the view stay.

use std::sync::Arc;

use egui::Rect;

use crate::document::ViewMode;
use crate::render::Camera;

use crate::document::viewpoint::Look;
use crate::panes::viewport::pictures::Heart;

/// Room left and right, above and below a fitted heart, in points: name and scale stand there.
const ROOM: [f32; 2] = [24.0, 46.0];
/// The same in a grid, whose names stand above it.
const GRID_ROOM: [f32; 2] = [8.0, 10.0];

/// A camera that fits a heart.
struct Fit {
    heart: Arc<Heart>,
    world_from_camera: glam::Quat,
    aspect: f32,
    camera: Camera,
}

/// The cameras of the hearts on screen.
#[derive(Default)]
pub struct Fits(Vec<Fit>);

impl Fits {
    /// Forgets the cameras of all other hearts.
    pub fn keep(&mut self, hearts: &[Arc<Heart>]) {
        self.0
            .retain(|fit| hearts.iter().any(|heart| Arc::ptr_eq(heart, &fit.heart)));
    }

    /// The camera that fitted a heart last.
    pub fn latest(&self, heart: &Arc<Heart>) -> Option<Camera> {
        let fit = self.0.iter().find(|fit| Arc::ptr_eq(&fit.heart, heart));
        fit.map(|fit| fit.camera)
    }

    /// A camera for every heart in its cell. Hearts beside each other have one scale.
    pub fn cameras(
        &mut self,
        look: &Look,
        mode: ViewMode,
        shown: &[Arc<Heart>],
        rects: &[Rect],
    ) -> Vec<Camera> {
        let mut fitted: Vec<Camera> = shown
            .iter()
            .zip(rects)
            .map(|(heart, rect)| {
                let rotation = look.rotation(&heart.prepared.axes);
                self.fitted(mode, heart, rotation, *rect)
            })
            .collect();
        let greatest = fitted
            .iter()
            .map(|camera| camera.half_height)
            .fold(0.0, f32::max);
        for camera in &mut fitted {
            camera.half_height = greatest;
        }
        shown
            .iter()
            .zip(fitted)
            .map(|(heart, fitted)| look.camera(&heart.frame, fitted))
            .collect()
    }

    /// A camera that fits a heart into a cell, with room around it for name, scale and cube.
    fn fitted(
        &mut self,
        mode: ViewMode,
        heart: &Arc<Heart>,
        rotation: glam::Quat,
        rect: Rect,
    ) -> Camera {
        let room = if mode == ViewMode::AllFrames {
            GRID_ROOM
        } else {
            ROOM.map(|room| room.min(0.12 * rect.height()))
        };
        let inner =
            (rect.size() - egui::vec2(2.0 * room[0], 2.0 * room[1])).max(egui::Vec2::splat(1.0));
        let camera = self.tightly_fitted(heart, rotation, inner.x / inner.y);
        Camera {
            half_height: camera.half_height * rect.height().max(1.0) / inner.y,
            ..camera
        }
    }

    fn tightly_fitted(&mut self, heart: &Arc<Heart>, rotation: glam::Quat, aspect: f32) -> Camera {
        let found = self.0.iter().find(|fit| {
            Arc::ptr_eq(&fit.heart, heart)
                && fit.world_from_camera == rotation
                && (fit.aspect - aspect).abs() < 1e-4
        });
        if let Some(fit) = found {
            return fit.camera;
        }
        let camera = heart.fitted(rotation, aspect);
        self.0.retain(|fit| !Arc::ptr_eq(&fit.heart, heart));
        self.0.push(Fit {
            heart: Arc::clone(heart),
            world_from_camera: rotation,
            aspect,
            camera,
        });
        camera
    }
}
