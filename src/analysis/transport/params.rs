//! Along which path a motion is transported, and what is kept on the way.

use crate::analysis::geodesics::{CheckedGeodesicParams, GeodesicParamError, GeodesicParams};
use crate::analysis::metrics::{CheckedMetricParams, Form, MetricKind, MetricParams, ParamError};

/// For which displacements of a beat a geodesic between the subjects is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Geodesics {
    /// Once, from M₀ to N₀. The path from M_i to N_i is the straight one bent as much as the first.
    #[default]
    First,
    /// From every M_i to every N_i, as the text says: takes several times as long.
    EveryStep,
}

/// In which norm the field changes as little as possible from sample to sample; the text does not
/// say.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Nearness {
    /// In the metric's own norm: the field changes along the path only.
    #[default]
    Metric,
    /// In the sum of squares of coordinates; slow on fine meshes, for comparison.
    Coordinates,
}

/// Where searches for geodesics end. From the endocardium of one subject in cine MRI to that of another, with 3
/// interpolated poses, 1e-3 takes 21 iterations and leaves 0.981 of the straight line's energy, 1e-6 takes 213 and
/// leaves 0.980 (`cardiomorph transfer --from A --onto B --tolerance T --json`).
const TOLERANCE: f64 = 1e-3;

/// Settings of a transport from one subject to another; [`TransportParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransportParams {
    /// What lengths and angles of displacements are. Transport needs an inner product: forms that
    /// are none (see [`crate::analysis::metrics`]) stand for the additive one.
    pub metric: MetricParams,
    /// Poses of the geodesic between the subjects; 0: the straight line.
    pub interpolated_poses: u16,
    /// Whether the norm of a displacement is kept, not only its product with the path's direction.
    pub keep_norm: bool,
    /// In which norm the field changes least.
    pub nearness: Nearness,
    /// For which displacements a geodesic is computed.
    pub geodesics: Geodesics,
    /// Begin the search for geodesics on a decimated mesh of about so many vertices; `None`: on the mesh as it is.
    pub max_vertices: Option<u32>,
    /// Relative decrease of energy at which the search for geodesics ends, as in [`GeodesicParams`].
    pub tolerance: f64,
}

impl Default for TransportParams {
    /// Measured, see [`CohortTransportParams::default`].
    fn default() -> Self {
        let cohort = CohortTransportParams::default();
        cohort.with_metric(MetricParams::default())
    }
}

/// What the motions of a cohort are transported onto.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Reference {
    /// The mean of all end-diastolic shapes, sizes normalised, aligned with each other.
    #[default]
    Mean,
    /// The end-diastolic shape of one subject, by its index in the study.
    Subject(usize),
}

/// Settings of a transport of all subjects onto one; the metric is given beside them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CohortTransportParams {
    /// What all are transported onto.
    pub reference: Reference,
    /// As in [`TransportParams`].
    pub interpolated_poses: u16,
    /// As in [`TransportParams`].
    pub keep_norm: bool,
    /// As in [`TransportParams`].
    pub geodesics: Geodesics,
    /// As in [`TransportParams`].
    pub max_vertices: Option<u32>,
    /// The metric by which motions are transported, with its own weights; `None`: that by which they are compared, or
    /// what takes its place on paths ([`MetricParams::of_paths`]).
    pub kind: Option<MetricKind>,
}

impl Default for CohortTransportParams {
    /// What a transport needs, and no more: few interpolated poses, and one geodesic per subject, since those of later
    /// steps bend alike. From one subject in cine MRI to another, transported poses differ by 9 % of the motion between
    /// the straight line and 1 interpolated pose, by 6 % between 1 and 3, by 3 % between 3 and 7, and by 2 % between 7 and
    /// 15 (root mean square over vertices, largest of all frames;
    /// `cargo test --release --test it interpolated_poses_change -- --nocapture`).
    fn default() -> Self {
        Self {
            reference: Reference::Mean,
            interpolated_poses: 3,
            keep_norm: true,
            geodesics: Geodesics::First,
            max_vertices: None,
            kind: None,
        }
    }
}

impl CohortTransportParams {
    /// The same settings for one pair of subjects.
    pub fn with_metric(self, metric: MetricParams) -> TransportParams {
        TransportParams {
            metric: match self.kind {
                None => metric.of_paths(),
                Some(kind) if kind == metric.kind => metric,
                Some(kind) => MetricParams::of(kind),
            },
            interpolated_poses: self.interpolated_poses,
            keep_norm: self.keep_norm,
            nearness: Nearness::Metric,
            geodesics: self.geodesics,
            max_vertices: self.max_vertices,
            tolerance: TOLERANCE,
        }
    }
}

/// Settings that have been checked; read them like the fields of [`TransportParams`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedTransportParams {
    params: TransportParams,
    pub(super) metric: CheckedMetricParams,
    /// `None` where the way is straight.
    pub(super) geodesic: Option<CheckedGeodesicParams>,
}

impl std::ops::Deref for CheckedTransportParams {
    type Target = TransportParams;

    fn deref(&self) -> &TransportParams {
        &self.params
    }
}

impl TransportParams {
    /// Makes settings usable; a form that is no inner product becomes the additive one.
    ///
    /// # Errors
    /// If those of the metric or of the geodesic are not.
    pub fn check(mut self) -> Result<CheckedTransportParams, TransportParamError> {
        if !self.metric.is_inner_product() {
            // Transport is by inner products; a refusal would only make every user change the same setting.
            self.metric.form = Form::Additive;
        }
        let geodesic = GeodesicParams {
            metric: self.metric,
            interpolated_poses: self.interpolated_poses,
            max_vertices: self.max_vertices,
            tolerance: self.tolerance,
            ..GeodesicParams::default()
        };
        let geodesic = geodesic.check()?;
        Ok(CheckedTransportParams {
            params: self,
            metric: self.metric.check()?,
            // Without poses in between the straight line is the path, and nothing is searched.
            geodesic: (self.interpolated_poses > 0).then_some(geodesic),
        })
    }
}

/// Why settings of a transport cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TransportParamError {
    /// The metric's own settings are wrong.
    #[error(transparent)]
    Metric(#[from] ParamError),
    /// Those of the geodesic are.
    #[error(transparent)]
    Geodesic(#[from] GeodesicParamError),
}
