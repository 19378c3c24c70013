//! Which metric, how many interpolated poses, and when the search ends.

use crate::analysis::metrics::{CheckedMetricParams, MetricParams, ParamError};

/// Settings of a geodesic; [`GeodesicParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeodesicParams {
    /// The metric of the path energy.
    pub metric: MetricParams,
    /// Poses between the two ends.
    pub interpolated_poses: u16,
    /// Stop when eight iterations lowered the energy by less than this share of itself, and the next one
    /// is not expected to lower it by more.
    pub tolerance: f64,
    /// Stop after so many iterations of each search.
    pub max_iterations: u32,
    /// Find the path on a decimated mesh of at most so many vertices first, prolong its offsets from the straight line
    /// to the whole, and go on there; `None`: on the mesh as it is. It changes how long the search takes, not what is
    /// searched for.
    pub max_vertices: Option<u32>,
}

impl Default for GeodesicParams {
    /// Three interpolated poses cut each interval of a beat into quarters: time and memory grow with their number, and the
    /// path between two frames of a cycle bends little. Not tuned.
    ///
    /// Tolerance: from frame 0 to 11 of a subject in cine MRI, with 7 interpolated poses, 1e-3 ends after 9 iterations
    /// on the endocardium and on the epicardium; 1e-6 takes 108 and 68, and lowers the energy by another
    /// 0.006 % and 0.003 % (`cardiomorph interpolate ED ES --poses 7 --tolerance T` says energy and iterations).
    fn default() -> Self {
        Self {
            metric: MetricParams::default().of_paths(),
            interpolated_poses: 3,
            tolerance: 1e-3,
            max_iterations: 1_000,
            max_vertices: None,
        }
    }
}

/// More interpolated poses than any screen shows; memory grows with them.
const MAX_INTERPOLATED_POSES: u16 = 1_023;

/// A coarser mesh would no longer have the shape of a ventricle.
const MIN_VERTICES: u32 = 12;

/// Settings that have been checked; read them like the fields of [`GeodesicParams`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedGeodesicParams {
    params: GeodesicParams,
    pub(super) metric: CheckedMetricParams,
}

impl std::ops::Deref for CheckedGeodesicParams {
    type Target = GeodesicParams;

    fn deref(&self) -> &GeodesicParams {
        &self.params
    }
}

impl CheckedGeodesicParams {
    /// The same on the mesh as it is.
    pub(super) fn on_all_vertices(mut self) -> Self {
        self.params.max_vertices = None;
        self
    }
}

impl GeodesicParams {
    /// Checks the settings once; an algorithm takes the checked type only.
    ///
    /// Forms without a least path are refused: from two interpolated poses on and without regulariser
    /// (λ = 0), raw corners cost nothing at size 0, since they grow with the eighth power of size:
    /// shrinking, deforming and growing back by s costs s⁸ of the direct way. And
    /// where curvature change is a factor, steps that change curvature but no angle alternate with
    /// steps that change angles but no curvature, at no cost.
    ///
    /// # Errors
    /// If a weight, the tolerance or a count is out of range, or there is no least path.
    pub fn check(self) -> Result<CheckedGeodesicParams, GeodesicParamError> {
        let metric = self.metric.check()?;
        if self.interpolated_poses > MAX_INTERPOLATED_POSES {
            return Err(GeodesicParamError::InterpolatedPoses {
                interpolated_poses: self.interpolated_poses,
                most: MAX_INTERPOLATED_POSES,
            });
        }
        if !(self.tolerance.is_finite() && self.tolerance >= 0.0) {
            return Err(GeodesicParamError::Tolerance(self.tolerance));
        }
        if let Some(vertices) = self.max_vertices.filter(|&v| v < MIN_VERTICES) {
            return Err(GeodesicParamError::Vertices {
                vertices,
                fewest: MIN_VERTICES,
            });
        }
        // With one interpolated pose both steps touch a fixed end, and cannot be made free.
        if self.interpolated_poses >= 2
            && self.metric.lambda == 0.0
            && self.metric.path_energy_can_vanish()
        {
            return Err(GeodesicParamError::NoLeastPath {
                interpolated_poses: self.interpolated_poses,
            });
        }
        Ok(CheckedGeodesicParams {
            params: self,
            metric,
        })
    }
}

/// Why settings of a geodesic cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GeodesicParamError {
    /// The metric's own settings are wrong.
    #[error(transparent)]
    Metric(#[from] ParamError),
    /// So many interpolated poses are not computed.
    #[error("at most {most} interpolated poses are computed, not {interpolated_poses}")]
    InterpolatedPoses {
        /// What was asked for.
        interpolated_poses: u16,
        /// The limit.
        most: u16,
    },
    /// The tolerance is negative or not a number.
    #[error("the tolerance must be zero or positive and finite, not {0}")]
    Tolerance(f64),
    /// A mesh of so few vertices says nothing.
    #[error("a path is found on at least {fewest} vertices, not {vertices}")]
    Vertices {
        /// What was asked for.
        vertices: u32,
        /// The limit.
        fewest: u32,
    },
    /// The energy has no minimum above zero.
    #[error(
        "with {interpolated_poses} interpolated poses this form has no shortest path: poses can collapse at no cost; \
         set lambda above 0, use at most one interpolated pose, or the additive form"
    )]
    NoLeastPath {
        /// What was asked for.
        interpolated_poses: u16,
    },
}
