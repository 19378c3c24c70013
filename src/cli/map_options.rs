//! Options for the maps of poses and deformations; defaults are those of the window.

use clap::Args;

use crate::analysis::deformations::{Comparison, DeformationMapParams, PartWeights};
use crate::analysis::embedding::MapMethod;
use crate::analysis::metrics::MetricKind;
use crate::analysis::pose_distances::PoseDistanceParams;
use crate::analysis::transport::{CohortTransportParams, Reference};
use crate::cli::metric_options::MetricOptions;
use crate::cli::outcome::CliError;
use crate::cli::words::{ComparisonWord, MetricWord};
use crate::engine::{DeformationMapQuery, PoseMapQuery};
use crate::study::Study;

/// How poses are transported, and how motions are compared.
#[derive(Clone, Debug, Args)]
pub struct MapOptions {
    /// Parallel transport of all motions before poses are compared, onto: none, mean, or the id of a subject.
    /// Deformations are transported in any case, with none onto the mean
    #[arg(long, value_name = "REFERENCE", default_value = "none")]
    pub transfer: String,
    /// Metric of that transport, with its own weights [default: that of distances; isometric for displacement]
    #[arg(long, value_enum, value_name = "METRIC")]
    pub transfer_metric: Option<MetricWord>,
    /// Smoothing length of poses before they are compared, in √area; 0: no smoothing
    #[arg(long, value_name = "R", default_value_t = PoseDistanceParams::default().smoothing, allow_negative_numbers = true)]
    pub smoothing: f64,
    /// What of two beats is compared in the deformation map and the classification
    #[arg(long, value_enum, value_name = "PARTS", default_value_t = ComparisonWord::default())]
    pub compare: ComparisonWord,
    /// Weight of shape relative to that of deformation where both are compared, each over its median
    #[arg(
        long,
        value_name = "W",
        default_value_t = 1.0,
        allow_negative_numbers = true
    )]
    pub shape_weight: f64,
    /// Smoothing length of poses before deformations are compared, in √area; 0: no smoothing
    #[arg(long, value_name = "R", default_value_t = DeformationMapParams::default().smoothing, allow_negative_numbers = true)]
    pub deformation_smoothing: f64,
    /// Also embed poses by Isomap with K nearest neighbours
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u16).range(1..))]
    pub isomap: Option<u16>,
    /// Weight of time in the curves of poses, with --compare poses [default: RMS radius over standard deviation of time]
    #[arg(long, value_name = "W", allow_negative_numbers = true)]
    pub time_weight: Option<f64>,
    /// Nearest neighbours in the deformation map [default: from the number of subjects]
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u16).range(1..))]
    pub neighbours: Option<u16>,
    /// Regularisation of the weights of the deformation map, as a share of the trace
    #[arg(long, value_name = "R", default_value_t = DeformationMapParams::default().regularisation, allow_negative_numbers = true)]
    pub regularisation: f64,
}

impl MapOptions {
    /// The settings that they name, on poses mapped by `method`.
    ///
    /// # Errors
    /// Wrong usage, if a setting is out of range or no subject has the id.
    pub fn settings(
        &self,
        metric: &MetricOptions,
        method: MapMethod,
        study: &Study,
    ) -> Result<DeformationMapQuery, CliError> {
        metric.checked()?;
        let transfer = self
            .reference(study)?
            .map(|reference| CohortTransportParams {
                reference,
                kind: self.transfer_metric.map(MetricKind::from),
                ..CohortTransportParams::default()
            });
        let map = DeformationMapParams {
            comparison: self.comparison(),
            smoothing: self.deformation_smoothing,
            time_weight: self.time_weight,
            neighbours: self.neighbours,
            regularisation: self.regularisation,
            ..DeformationMapParams::default()
        };
        map.check()
            .map_err(|error| CliError::Usage(error.to_string()))?;
        let distances = PoseDistanceParams {
            metric: metric.params(),
            transport: transfer,
            smoothing: self.smoothing,
        };
        distances
            .check()
            .map_err(|error| CliError::Usage(error.to_string()))?;
        Ok(DeformationMapQuery {
            poses: PoseMapQuery { distances, method },
            map,
        })
    }

    fn comparison(&self) -> Comparison {
        match self.compare {
            ComparisonWord::Deformation => Comparison::default(),
            ComparisonWord::DeformationAndShape => Comparison::Parts(PartWeights {
                shape: self.shape_weight,
                ..PartWeights::DEFORMATION
            }),
            ComparisonWord::Shape => Comparison::Parts(PartWeights::SHAPE),
            ComparisonWord::Poses => Comparison::Poses,
        }
    }

    fn reference(&self, study: &Study) -> Result<Option<Reference>, CliError> {
        reference(&self.transfer, study)
    }
}

/// What `--transfer none|mean|ID` names.
///
/// # Errors
/// Wrong usage, if no subject has the id.
pub(super) fn reference(word: &str, study: &Study) -> Result<Option<Reference>, CliError> {
    let index = match word {
        "none" => return Ok(None),
        "mean" => return Ok(Some(Reference::Mean)),
        id => study.subjects.iter().position(|subject| subject.id == id),
    };
    let index = index.ok_or_else(|| {
        CliError::Usage(format!(
            "--transfer takes none, mean or the id of a subject; there is no {word:?}"
        ))
    })?;
    Ok(Some(Reference::Subject(index)))
}
