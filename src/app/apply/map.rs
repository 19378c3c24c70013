//! Commands about metric and maps.

use crate::analysis::deformations::DeformationMapParams;
use crate::document::state::State;
use crate::engine::PoseMapQuery;
use crate::panes::MapCommand;

use super::change::{Moment, change};

/// Applies a command about how poses and deformations are compared and mapped.
pub fn apply(state: &mut State, command: MapCommand, moment: &Moment) {
    if let MapCommand::ShowEstimate(at) = command {
        state.estimate_at = at;
        return;
    }
    change(state, moment, None, |d| match command {
        MapCommand::SetPoseMap(params) => d.map = params,
        MapCommand::SetMetric(kind) => {
            let metric = &mut d.map.distances.metric;
            *metric = metric.with_kind(kind);
        }
        MapCommand::SetMapMethod(method) => d.map.method = method,
        MapCommand::SetDeformationMap(params) => d.deformation_map = params,
        MapCommand::SetComparison(comparison) => d.deformation_map.comparison = comparison,
        MapCommand::ResetMaps => {
            d.map = PoseMapQuery::default();
            d.deformation_map = DeformationMapParams::default();
        }
        MapCommand::SetClassesBy(by) => d.chosen_classes = by,
        // Nothing that undo restores.
        MapCommand::ShowEstimate(_) => {}
        MapCommand::ToggleClusters => d.shows_clusters = !d.shows_clusters,
    });
}
