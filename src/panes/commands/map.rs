//! Commands about metric and maps.

use super::Command;
use super::action::{Action, Menu, action};
use crate::analysis::deformations::DeformationMapParams;
use crate::analysis::embedding::MapMethod;
use crate::analysis::metrics::MetricKind;
use crate::engine::PoseMapParams;

/// Commands about metric and maps.
#[derive(Clone, Debug, PartialEq)]
pub enum MapCommand {
    /// How poses are compared and mapped.
    SetPoseMap(PoseMapParams),
    /// Which metric compares poses.
    SetMetric(MetricKind),
    /// How distances become the map of poses.
    SetMapMethod(MapMethod),
    /// How whole deformations are mapped.
    SetDeformationMap(DeformationMapParams),
    /// All settings of metric and maps as they were at the start.
    ResetMaps,
    /// Show or hide the clusters of the map of deformations.
    ToggleClusters,
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Action] = &[
    action(Menu::Analysis, 2, "Clusters of deformations", None, Command::Map(MapCommand::ToggleClusters)),
    action(Menu::Analysis, 3, "Metric: quasi-conformal", None, Command::Map(MapCommand::SetMetric(MetricKind::QuasiConformal))),
    action(Menu::Analysis, 3, "Metric: angle-preserving", None, Command::Map(MapCommand::SetMetric(MetricKind::AnglePreserving))),
    action(Menu::Analysis, 3, "Metric: isometric", None, Command::Map(MapCommand::SetMetric(MetricKind::Isometric))),
    action(Menu::Analysis, 3, "Metric: rigid", None, Command::Map(MapCommand::SetMetric(MetricKind::Rigid))),
    action(Menu::Analysis, 3, "Map of poses by SMACOF", None, Command::Map(MapCommand::SetMapMethod(MapMethod::Smacof))),
    action(Menu::Analysis, 3, "Map of poses by classical MDS", None, Command::Map(MapCommand::SetMapMethod(MapMethod::ClassicalMds))),
    action(Menu::Analysis, 3, "Map of poses by Isomap", None, Command::Map(MapCommand::SetMapMethod(MapMethod::ISOMAP))),
    action(Menu::Analysis, 3, "Reset metric and maps", None, Command::Map(MapCommand::ResetMaps)),
];
