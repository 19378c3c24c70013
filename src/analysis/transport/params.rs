//! Along which path a motion is carried, and what is kept on the way.

use crate::analysis::geodesics::{CheckedGeodesicParams, GeodesicParamError, GeodesicParams};
use crate::analysis::metrics::{CheckedMetricParams, Form, MetricKind, MetricParams, ParamError};

/// For which displacements of a beat a geodesic between the hearts is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Geodesics {
    /// Once, from M₀ to N₀. The path from M_i to N_i is the straight one bent as much as the first.
    #[default]
    First,
    /// From every M_i to every N_i, as the text says: three to eight times as long.
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

/// Settings of a transfer from one heart to another; [`TransportParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransportParams {
    /// What lengths and angles of displacements are. Transport needs an inner product: forms that
    /// are none (see [`crate::analysis::metrics`]) stand for the additive one.
    pub metric: MetricParams,
    /// Poses of the geodesic between the hearts; 0: the straight way.
    pub in_betweens: u16,
    /// Whether the norm of a displacement is kept, not only its product with the path's direction.
    pub keep_norm: bool,
    /// In which norm the field changes least.
    pub nearness: Nearness,
    /// For which displacements a geodesic is computed.
    pub geodesics: Geodesics,
    /// Find geodesics on a decimated mesh of about so many vertices; `None`: on the mesh as it is.
    pub most_vertices: Option<u32>,
}

impl Default for TransportParams {
    /// Measured, see [`CohortTransferParams::default`].
    fn default() -> Self {
        let cohort = CohortTransferParams::default();
        cohort.with_metric(MetricParams::default())
    }
}

/// What the motions of a cohort are carried onto.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Reference {
    /// The mean of all end-diastolic shapes, sizes normalised, laid onto each other.
    #[default]
    Mean,
    /// The end-diastolic shape of one subject, by its index in the study.
    Subject(usize),
}

/// Settings of a transfer of all hearts onto one; the metric is given beside them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CohortTransferParams {
    /// What all are carried onto.
    pub reference: Reference,
    /// As in [`TransportParams`].
    pub in_betweens: u16,
    /// As in [`TransportParams`].
    pub keep_norm: bool,
    /// As in [`TransportParams`].
    pub geodesics: Geodesics,
    /// As in [`TransportParams`].
    pub most_vertices: Option<u32>,
}

impl Default for CohortTransferParams {
    /// What a transfer needs, measured with the default metric onto the mean of each cohort.
    ///
    /// | geodesics, in-betweens, vertices | error, mean (worst heart) | partner: nearest, above median |
    /// |---|---|---|
    /// | straight way | 3.2 % (8.7 %) | 2, 18 of 20 |
    /// | first, 1, 500 | 1.5 % (4.2 %) | 7, 17 |
    /// | first, 3, 200 | 0.93 % (2.8 %) | 6, 19 |
    /// | **first, 3, 500** | 0.85 % (2.6 %) | 10, 18 |
    /// | first, 3, all | 0.79 % (2.6 %) | 11, 17 |
    /// | first, 7, 500 | 0.77 % (2.6 %) | 10, 18 |
    /// | first, 7, all | 0.71 % (2.6 %) | 11, 18 |
    /// | every step, 1, 500 | 1.5 % (3.9 %) | 5, 18 |
    /// | every step, 3, 500 | 0.60 % (1.6 %) | 5, 18 |
    ///
    /// *Error:* built-in cohort, 23 beats of 8 poses of 2,450 vertices, sizes normalised; root mean square
    /// distance from the poses that geodesics for every step with 7 in-betweens on all vertices give
    /// (which took some 25 times as long as the default), over the root mean square
    /// displacement from end-diastole. The error falls with the length of a step, as forward differences do.
    /// *Partner:* gated SPECT, 10 patients at rest and under stress, 898 vertices: sequences of which
    /// the same patient's other one is the nearest, and nearer than the median of the others, by the
    /// root mean square distance over equal phases. Without any transfer they are 17 and 20, since
    /// the shape of the heart itself tells the patient; displacement alone added to the mean gives 3
    /// and 16.
    ///
    /// So few in-betweens and a coarse mesh do, and one geodesic per heart: those of later steps
    /// bend alike, and on meshes of real hearts they follow noise. There the poses themselves have not
    /// settled, though: SPECT beats carried with the default are 19 % of the
    /// displacement away from those of 7 in-betweens on all vertices, and 35 % without
    /// in-betweens. Of 23 built-in hearts, 18 have a nearest neighbour that is normal or not as
    /// they are, whatever the row; 20 without transfer, and 18 by displacement alone.
    fn default() -> Self {
        Self {
            reference: Reference::Mean,
            in_betweens: 3,
            keep_norm: true,
            geodesics: Geodesics::First,
            most_vertices: Some(500),
        }
    }
}

impl CohortTransferParams {
    /// The same settings for one pair of hearts.
    pub fn with_metric(self, metric: MetricParams) -> TransportParams {
        TransportParams {
            metric,
            in_betweens: self.in_betweens,
            keep_norm: self.keep_norm,
            nearness: Nearness::Metric,
            geodesics: self.geodesics,
            most_vertices: self.most_vertices,
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
        if !is_inner_product(&self.metric) {
            self.metric.form = Form::Additive;
        }
        let geodesic = GeodesicParams {
            metric: self.metric,
            in_betweens: self.in_betweens,
            most_vertices: self.most_vertices,
            // Ways of neighbouring steps must differ by their ends alone, not by where a search ended.
            tolerance: 1e-6,
            ..GeodesicParams::default()
        };
        let geodesic = geodesic.check()?;
        Ok(CheckedTransportParams {
            params: self,
            metric: self.metric.check()?,
            geodesic: (self.in_betweens > 0).then_some(geodesic),
        })
    }
}

/// Whether products of this metric are linear in each field.
pub(super) fn is_inner_product(metric: &MetricParams) -> bool {
    match metric.kind {
        MetricKind::Isometric | MetricKind::Rigid => true,
        MetricKind::AnglePreserving => metric.form != Form::Printed,
        MetricKind::QuasiConformal => metric.form == Form::Additive,
    }
}

/// Why settings of a transfer cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TransportParamError {
    /// The metric's own settings are wrong.
    #[error(transparent)]
    Metric(#[from] ParamError),
    /// Those of the geodesic are.
    #[error(transparent)]
    Geodesic(#[from] GeodesicParamError),
}
