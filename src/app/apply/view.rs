//! Commands that change how the study is looked at: camera, colours, table.

use crate::app::saved_views;
use crate::document::CohortSort;
use crate::panes::ViewCommand;

use super::change::{Moment, change};
use crate::document::state::State;
use crate::document::undo::Gesture;
use crate::document::viewpoint::{Direction, Viewpoint};

/// Applies a command about the picture or the table.
pub fn apply(state: &mut State, command: ViewCommand, moment: &Moment) {
    if let ViewCommand::RestoreView(view) = &command {
        return saved_views::apply(state, view, moment);
    }
    let gesture = match &command {
        ViewCommand::SetCamera { .. } => Some(Gesture::Camera),
        ViewCommand::SetSearch(_) => Some(Gesture::Search),
        ViewCommand::SetColourLimits(_) => Some(Gesture::Limits),
        _ => None,
    };
    let moment = Moment {
        // The viewport knows best whether its drag goes on.
        pointer_held: matches!(command, ViewCommand::SetCamera { drag: true, .. })
            || (moment.pointer_held && !matches!(command, ViewCommand::SetCamera { .. })),
        ..*moment
    };
    change(state, &moment, gesture, |d| {
        let visible = &mut d.visibility;
        match command {
            ViewCommand::SetViewMode(mode) => d.view_mode = mode,
            ViewCommand::SetCamera { camera, .. } => {
                d.viewpoint = Viewpoint::through(&camera).unwrap_or(d.viewpoint);
            }
            ViewCommand::ViewFrom(side) => d.viewpoint.direction = Direction::From(side),
            ViewCommand::FitView => {
                d.viewpoint = Viewpoint {
                    direction: d.viewpoint.direction,
                    ..Viewpoint::default()
                }
            }
            ViewCommand::ToggleFreeCamera => d.free_camera = !d.free_camera,
            ViewCommand::ToggleEndocardium => visible.endocardium = !visible.endocardium,
            ViewCommand::ToggleEpicardium => visible.epicardium = !visible.epicardium,
            ViewCommand::ToggleWireframe => visible.wireframe = !visible.wireframe,
            ViewCommand::ToggleVertices => visible.vertices = !visible.vertices,
            ViewCommand::SetShading(shading) => visible.shading = shading,
            ViewCommand::SetQuantity(quantity) => d.quantity = quantity,
            ViewCommand::NextQuantity => d.quantity = d.quantity.next(),
            ViewCommand::SetColourLimits(limits) => d.set_limits(limits.filter(is_range)),
            ViewCommand::SetSearch(text) => d.search = text,
            ViewCommand::SortCohort(column) => {
                let ascending = CohortSort {
                    column,
                    descending: false,
                };
                let descending = d.sorting == Some(ascending);
                d.sorting = Some(CohortSort { column, descending });
            }
            ViewCommand::RestoreView(_) => {}
        }
    });
}

fn is_range(limits: &[f64; 2]) -> bool {
    limits.iter().all(|limit| limit.is_finite()) && limits[0] < limits[1]
}
