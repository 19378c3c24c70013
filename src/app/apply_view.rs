//! Commands that change how the study is looked at: camera, colours, map, table.

use crate::analysis::deformations::DeformationMapParams;
use crate::engine::PoseMapParams;
use crate::panes::Command;

use super::apply::{Moment, change};
use super::look::{Direction, Look};
use super::state::State;
use super::undo::Gesture;

/// Carries out a command about the picture, the map or the table.
pub fn apply(state: &mut State, command: Command, moment: &Moment) {
    let gesture = match &command {
        Command::SetCamera { .. } => Some(Gesture::Camera),
        Command::SetSearch(_) => Some(Gesture::Search),
        Command::SetColourLimits(_) => Some(Gesture::Limits),
        _ => None,
    };
    let moment = Moment {
        // The viewport knows best whether its drag goes on.
        pointer_held: matches!(command, Command::SetCamera { drag: true, .. })
            || (moment.pointer_held && !matches!(command, Command::SetCamera { .. })),
        ..*moment
    };
    change(state, &moment, gesture, |d| {
        let visible = &mut d.visibility;
        match command {
            Command::SetViewMode(mode) => d.view_mode = mode,
            Command::SetCamera { camera, .. }
                if camera.half_height.is_finite() && camera.half_height > 0.0 =>
            {
                d.look = Look {
                    direction: Direction::Turned(camera.world_from_camera),
                    offset: camera.target,
                    half_height: Some(camera.half_height),
                };
            }
            Command::ViewFrom(side) => d.look.direction = Direction::From(side),
            Command::FitView => {
                d.look = Look {
                    direction: d.look.direction,
                    ..Look::default()
                }
            }
            Command::ToggleFreeCamera => d.free_camera = !d.free_camera,
            Command::ToggleEndocardium => visible.endocardium = !visible.endocardium,
            Command::ToggleEpicardium => visible.epicardium = !visible.epicardium,
            Command::ToggleWireframe => visible.wireframe = !visible.wireframe,
            Command::ToggleVertices => visible.vertices = !visible.vertices,
            Command::SetShading(shading) => visible.shading = shading,
            Command::SetQuantity(quantity) => d.quantity = quantity,
            Command::NextQuantity => d.quantity = d.quantity.next(),
            Command::SetColourLimits(limits) => d.set_limits(limits.filter(is_range)),
            Command::SetPoseMap(params) => d.map = params,
            Command::SetMetric(kind) => d.map.distances.metric.kind = kind,
            Command::SetMapMethod(method) => d.map.method = method,
            Command::SetDeformationMap(params) => d.deformation_map = params,
            Command::ResetMaps => {
                d.map = PoseMapParams::default();
                d.deformation_map = DeformationMapParams::default();
            }
            Command::ToggleClusters => d.shows_clusters = !d.shows_clusters,
            Command::SetSearch(text) => d.search = text,
            Command::SortCohort(column) => {
                let again = d.sorting.column == Some(column);
                d.sorting.descending = again && !d.sorting.descending;
                d.sorting.column = Some(column);
            }
            _ => {}
        }
    });
}

fn is_range(limits: &[f64; 2]) -> bool {
    limits.iter().all(|limit| limit.is_finite()) && limits[0] < limits[1]
}
