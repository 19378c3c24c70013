//! Cameras that fit subjects into their cells, kept while subject, direction and shape of the view stay.

use std::sync::Arc;

use egui::Rect;

use crate::document::ViewMode;
use crate::render::Camera;

use crate::document::viewpoint::Viewpoint;
use crate::panes::viewport::queries::PlacedSubject;

/// Room left and right, above and below a fitted subject, in points: name and scale stand there.
const ROOM: [f32; 2] = [24.0, 46.0];
/// The same in a grid, whose names stand above it.
const GRID_ROOM: [f32; 2] = [8.0, 10.0];

/// A camera that fits a subject.
struct Fit {
    subject: Arc<PlacedSubject>,
    world_from_camera: glam::Quat,
    aspect: f32,
    camera: Camera,
}

/// The cameras of the subjects on screen.
#[derive(Default)]
pub struct Fits(Vec<Fit>);

impl Fits {
    /// Forgets the cameras of all other subjects.
    pub fn keep(&mut self, subjects: &[Arc<PlacedSubject>]) {
        self.0.retain(|fit| {
            subjects
                .iter()
                .any(|subject| Arc::ptr_eq(subject, &fit.subject))
        });
    }

    /// The camera that fitted a subject last.
    pub fn latest(&self, subject: &Arc<PlacedSubject>) -> Option<Camera> {
        let fit = self.0.iter().find(|fit| Arc::ptr_eq(&fit.subject, subject));
        fit.map(|fit| fit.camera)
    }

    /// A camera for every subject in its cell. Subjects beside each other have one scale.
    pub fn cameras(
        &mut self,
        viewpoint: &Viewpoint,
        mode: ViewMode,
        shown: &[Arc<PlacedSubject>],
        rects: &[Rect],
    ) -> Vec<Camera> {
        let mut fitted: Vec<Camera> = shown
            .iter()
            .zip(rects)
            .map(|(subject, rect)| {
                let rotation = viewpoint.rotation(&subject.prepared.axes);
                self.fitted(mode, subject, rotation, *rect)
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
            .map(|(subject, fitted)| viewpoint.camera(&subject.frame, fitted))
            .collect()
    }

    /// A camera that fits a subject into a cell, with room around it for name, scale and cube.
    fn fitted(
        &mut self,
        mode: ViewMode,
        subject: &Arc<PlacedSubject>,
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
        let camera = self.tightly_fitted(subject, rotation, inner.x / inner.y);
        Camera {
            half_height: camera.half_height * rect.height().max(1.0) / inner.y,
            ..camera
        }
    }

    fn tightly_fitted(
        &mut self,
        subject: &Arc<PlacedSubject>,
        rotation: glam::Quat,
        aspect: f32,
    ) -> Camera {
        let found = self.0.iter().find(|fit| {
            Arc::ptr_eq(&fit.subject, subject)
                && fit.world_from_camera == rotation
                && (fit.aspect - aspect).abs() < 1e-4
        });
        if let Some(fit) = found {
            return fit.camera;
        }
        let camera = subject.fitted(rotation, aspect);
        self.0.retain(|fit| !Arc::ptr_eq(&fit.subject, subject));
        self.0.push(Fit {
            subject: Arc::clone(subject),
            world_from_camera: rotation,
            aspect,
            camera,
        });
        camera
    }
}
