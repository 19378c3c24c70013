//! Options that name a metric, the same for every command; defaults are those of the window.

use clap::Args;

use crate::analysis::metrics::{CheckedMetricParams, CurvatureMean, MetricKind, MetricParams};
use crate::cli::outcome::CliError;
use crate::cli::words::{CornersWord, FormWord, MetricWord, RegulariserWord, Switch};

/// Which metric, in which form, with which weights.
#[derive(Clone, Debug, Args)]
pub struct MetricOptions {
    /// What the metric penalises [default: displacement; isometric for geodesics and parallel transport]
    #[arg(long, value_enum)]
    pub metric: Option<MetricWord>,
    /// How terms combine, in metrics that have forms
    #[arg(long, value_enum, default_value_t = FormWord::Additive)]
    pub form: FormWord,
    /// Scaling of the corner terms
    #[arg(long, value_enum, default_value_t = CornersWord::ScaleFree)]
    pub corners: CornersWord,
    /// Whether faces and vertices are area-weighted
    #[arg(long, value_enum, default_value_t = Switch::On)]
    pub area_weights: Switch,
    /// Weight of the curvature term in the additive form [default: 0.125]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    pub mu: Option<f64>,
    /// Radius over which curvature is averaged, with area weights, as a share of the square root of the area [default: 0.08]
    #[arg(long, value_name = "R", conflicts_with = "curvature_rings")]
    pub curvature_radius: Option<f64>,
    /// The same as rings of neighbours, whatever the mesh
    #[arg(long, value_name = "N")]
    pub curvature_rings: Option<u32>,
    /// Weight of the regulariser [default: that of the metric: 0.25 for quasi-conformal, 0.5 for isometric, 1 for angle-preserving, 0 for displacement]
    #[arg(long, value_name = "L", allow_negative_numbers = true)]
    pub lambda: Option<f64>,
    /// How the regulariser weights vertices
    #[arg(long, value_enum, default_value_t = RegulariserWord::Area)]
    pub regulariser: RegulariserWord,
}

impl MetricOptions {
    /// The settings that they name.
    pub fn params(&self) -> MetricParams {
        self.over(MetricParams::default())
    }

    /// The settings that they name for geodesics and parallel transport.
    pub fn of_paths(&self) -> MetricParams {
        self.over(MetricParams::default().of_paths())
    }

    fn over(&self, default: MetricParams) -> MetricParams {
        let kind = self.metric.map_or(default.kind, MetricKind::from);
        let usual = MetricParams::of(kind);
        MetricParams {
            form: self.form.into(),
            corners: self.corners.into(),
            area_weights: self.area_weights == Switch::On,
            mu: self.mu.unwrap_or(usual.mu),
            curvature: match (self.curvature_rings, self.curvature_radius) {
                (Some(rings), _) => CurvatureMean::Rings(rings),
                (None, Some(radius)) => CurvatureMean::Radius(radius),
                (None, None) => usual.curvature,
            },
            lambda: self.lambda.unwrap_or(usual.lambda),
            regulariser: self.regulariser.into(),
            ..usual
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
