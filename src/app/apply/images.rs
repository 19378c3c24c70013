//! Commands about the images of the study.

use crate::document::document::Document;
use crate::document::state::State;
use crate::document::undo::Gesture;
use crate::mesh::Point3;
use crate::panes::ImagesCommand;

use super::change::{Moment, change};

/// The axis of the grid along which slices were acquired.
const SLICE_AXIS: usize = 2;

/// Applies a command about images.
pub fn apply(state: &mut State, command: ImagesCommand, moment: &Moment) {
    let gesture = match command {
        ImagesCommand::MoveTo(_) | ImagesCommand::StepSlice(_) => Some(Gesture::Crosshair),
        ImagesCommand::SetWindow(Some(_)) => Some(Gesture::GreyWindow),
        _ => None,
    };
    change(state, moment, gesture, |d| match command {
        ImagesCommand::Show(images) => d.show_images(images),
        ImagesCommand::ShowSeries(series) => show_series(d, series),
        ImagesCommand::MoveTo(at) => move_to(d, at),
        ImagesCommand::StepSlice(step) => step_slice(d, step),
        ImagesCommand::SetWindow(window) => {
            if window.is_none_or(|window| window.is_usable()) {
                d.slices.window = window;
            }
        }
        ImagesCommand::ToggleOutlines => d.slices.outlines = !d.slices.outlines,
        ImagesCommand::ToggleSmooth => d.slices.smooth = !d.slices.smooth,
    });
}

fn show_series(document: &mut Document, series: usize) {
    let count = document
        .shown_images()
        .map_or(0, |images| images.series.len());
    if series < count && series != document.slices.series {
        document.slices.series = series;
        // The series of one person share the world, not their greys.
        document.slices.window = None;
    }
}

/// Moves the crosshair to the place of the volume that is nearest to this one.
fn move_to(document: &mut Document, at: Point3) {
    let Some(frame) = document.image_frame() else {
        return;
    };
    let mut voxel = frame.voxel(at);
    for axis in 0..3 {
        voxel[axis] = voxel[axis].clamp(0.0, frame.size()[axis] as f64 - 1.0);
    }
    let at = frame.position(voxel);
    if at.iter().all(|x| x.is_finite()) {
        document.slices.crosshair = Some(at);
    }
}

fn step_slice(document: &mut Document, step: i32) {
    let Some((frame, at)) = document.image_frame().zip(document.crosshair()) else {
        return;
    };
    let mut voxel = frame.voxel(at);
    voxel[SLICE_AXIS] = voxel[SLICE_AXIS].round() + f64::from(step);
    let at = frame.position(voxel);
    move_to(document, at);
}
