//! Commands about metric and maps.

use super::action::{Menu, Row, row};
use crate::analysis::deformations::{Comparison, DeformationMapParams, PartWeights};
use crate::analysis::embedding::MapMethod;
use crate::analysis::metrics::{METRICS, MetricKind};
use crate::engine::{ClassesBy, PoseMapQuery};

/// Commands about metric and maps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MapCommand {
    /// How poses are compared and mapped.
    SetPoseMap(PoseMapQuery),
    /// Which metric compares poses.
    SetMetric(MetricKind),
    /// How distances become the pose map.
    SetMapMethod(MapMethod),
    /// How whole deformations are mapped.
    SetDeformationMap(DeformationMapParams),
    /// What of two beats is compared.
    SetComparison(Comparison),
    /// All settings of metric and maps as they were at the start.
    ResetMaps,
    /// Whether subjects are classified by their labels or by the classes of these.
    SetClassesBy(ClassesBy),
    /// Show the pose that the pose map implies at a place, in the coordinates of its embedding, until another command
    /// comes; `None` shows what was there before.
    ShowEstimate(Option<[f64; 2]>),
    /// Show or hide the clusters of the deformation map.
    ToggleClusters,
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<MapCommand>] = &[
    row(Menu::Analysis, 2, "Clusters of deformations", None, MapCommand::ToggleClusters),
    row(Menu::Analysis, 3, "Deformation map: deformation", None, MapCommand::SetComparison(Comparison::Parts(PartWeights::DEFORMATION))),
    row(Menu::Analysis, 3, "Deformation map: deformation + shape", None, MapCommand::SetComparison(Comparison::Parts(PartWeights::BOTH))),
    row(Menu::Analysis, 3, "Deformation map: shape", None, MapCommand::SetComparison(Comparison::Parts(PartWeights::SHAPE))),
    row(Menu::Analysis, 3, "Deformation map: curves of poses", None, MapCommand::SetComparison(Comparison::Poses)),
    row(Menu::Analysis, 2, "Classify by label", None, MapCommand::SetClassesBy(ClassesBy::Label)),
    row(Menu::Analysis, 2, "Classify normal and abnormal", None, MapCommand::SetClassesBy(ClassesBy::Class)),
    row(Menu::Analysis, 3, "Pose map: SMACOF", None, MapCommand::SetMapMethod(MapMethod::Smacof)),
    row(Menu::Analysis, 3, "Pose map: classical MDS", None, MapCommand::SetMapMethod(MapMethod::ClassicalMds)),
    row(Menu::Analysis, 3, "Pose map: Isomap", None, MapCommand::SetMapMethod(MapMethod::ISOMAP)),
    row(Menu::Analysis, 3, "Reset metric and maps", None, MapCommand::ResetMaps),
];

/// One for each metric there is.
pub(super) fn of_metrics() -> impl Iterator<Item = Row<MapCommand>> {
    METRICS.into_iter().map(|kind| {
        // Made once, and read until the program ends.
        let name = format!("Metric: {}", kind.words().id).leak();
        row(Menu::Analysis, 3, name, None, MapCommand::SetMetric(kind))
    })
}
