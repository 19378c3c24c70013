//! What the pane of metric and maps shows, as plain values.

use crate::analysis::deformations::DeformationMapParams;
use crate::engine::PoseMapQuery;
use crate::panes::cohort::rows::CohortRow;

/// What the panel shows.
#[derive(Clone, Debug)]
pub struct MetricPanelView<'a> {
    /// How poses are compared and mapped.
    pub poses: PoseMapQuery,
    /// How deformations are mapped.
    pub deformations: DeformationMapParams,
    /// What distances within beats are made of, once it is known.
    pub shares: Option<String>,
    /// All subjects of the study: one may be the reference.
    pub subjects: &'a [CohortRow],
    /// The selected subject: first among the references.
    pub selected: Option<usize>,
    /// The neighbours that the deformation map has now.
    pub neighbours: Option<usize>,
    /// The weight of time that the deformation map has now.
    pub time_weight: Option<f64>,
}
