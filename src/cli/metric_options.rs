//! Options that name a metric, the same for every command; defaults are those of the window.

use clap::Args;

use crate::analysis::metrics::{CheckedMetricParams, MetricParams};
use crate::cli::outcome::CliError;
use crate::cli::words::{CornersWord, FormWord, MetricWord, RegulariserWord, Switch};

/// Which metric, in which form, with which weights.
#[derive(Clone, Debug, Args)]
pub struct MetricOptions {
    /// What the metric penalises
    #[arg(long, value_enum, default_value_t = MetricWord::default())]
    pub metric: MetricWord,
    /// How terms combine, in metrics that have forms
    #[arg(long, value_enum, default_value_t = FormWord::Additive)]
    pub form: FormWord,
    /// Scaling of the corner terms
    #[arg(long, value_enum, default_value_t = CornersWord::ScaleFree)]
    pub corners: CornersWord,
    /// Whether faces and vertices are area-weighted
    #[arg(long, value_enum, default_value_t = Switch::On)]
    pub area_weights: Switch,
    /// Weight of the curvature term in the additive form
    #[arg(long, value_name = "M", default_value_t = MetricParams::default().mu, allow_negative_numbers = true)]
    pub mu: f64,
    /// Rings of neighbours over which curvature is averaged, with area weights
    #[arg(long, value_name = "N", default_value_t = MetricParams::default().curvature_rings)]
    pub curvature_rings: u32,
    /// Weight of the regulariser
    #[arg(long, value_name = "L", default_value_t = MetricParams::default().lambda, allow_negative_numbers = true)]
    pub lambda: f64,
    /// How the regulariser weights vertices
    #[arg(long, value_enum, default_value_t = RegulariserWord::Area)]
    pub regulariser: RegulariserWord,
}

impl MetricOptions {
    /// The settings that they name.
    pub fn params(&self) -> MetricParams {
        MetricParams {
            kind: self.metric.into(),
            form: self.form.into(),
            corners: self.corners.into(),
            area_weights: self.area_weights == Switch::On,
            mu: self.mu,
            curvature_rings: self.curvature_rings,
            lambda: self.lambda,
            regulariser: self.regulariser.into(),
        }
    }

    /// The settings, if they can be used.
    ///
    /// # Errors
    /// Wrong usage, if a weight is negative or not finite.
    pub fn checked(&self) -> Result<CheckedMetricParams, CliError> {
        let checked = self.params().check();
        checked.map_err(|error| CliError::Usage(error.to_string()))
    }
}
