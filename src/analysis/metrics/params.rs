//! Which metric, in which form, with which weights.

/// What a metric charges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum MetricKind {
    /// Change of edge lengths (2.3.6).
    Isometric,
    /// Displacement that no rigid motion explains (2.3.7).
    Rigid,
    /// Change of angles (eq. 3.3, 3.4).
    AnglePreserving,
    /// Change of angles and of Gaussian curvature (eq. 3.5).
    #[default]
    QuasiConformal,
}

/// How the terms of a metric are put together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Form {
    /// Absolute values as printed in the text. Not an inner product.
    Printed,
    /// Sums of products of the same terms, curvature change as a factor.
    Bilinear,
    /// Curvature weights frozen for the pair of poses: an inner product for that pair.
    Frozen,
    /// Angle term plus μ times the curvature-change term: an inner product everywhere.
    #[default]
    Additive,
}

/// Units of the corner terms of eq. 3.3.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Corners {
    /// As printed: grows with the fourth power of size.
    Raw,
    /// Divided by |pq|²|pr|²: size does not matter.
    #[default]
    ScaleFree,
}

/// How the regularising term Σ Xₚ·Yₚ counts vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Regulariser {
    /// Every vertex the same.
    Uniform,
    /// By the area around the vertex.
    #[default]
    Area,
}

/// Settings of a metric; [`MetricParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MetricParams {
    /// What is charged.
    pub kind: MetricKind,
    /// How terms combine; only angle-preserving and quasi-conformal metrics have forms.
    pub form: Form,
    /// Raw or scale-free corners.
    pub corners: Corners,
    /// Whether faces and vertices count by their share of the whole area.
    pub area_weights: bool,
    /// Weight μ of the curvature term in the additive form.
    pub mu: f64,
    /// Rings of neighbours over which curvature change is averaged.
    pub curvature_rings: u32,
    /// Weight λ of the regulariser.
    pub lambda: f64,
    /// How the regulariser counts vertices.
    pub regulariser: Regulariser,
}

impl Default for MetricParams {
    fn default() -> Self {
        Self {
            kind: MetricKind::default(),
            form: Form::default(),
            corners: Corners::default(),
            area_weights: true,
            mu: 1.0,
            curvature_rings: 2,
            lambda: 1e-4,
            regulariser: Regulariser::default(),
        }
    }
}

/// Settings that have been checked; read them like the fields of [`MetricParams`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedMetricParams(MetricParams);

impl std::ops::Deref for CheckedMetricParams {
    type Target = MetricParams;

    fn deref(&self) -> &MetricParams {
        &self.0
    }
}

/// Rings past which an average spans any heart; each ring costs a pass over all edges.
const MOST_RINGS: u32 = 100;

impl MetricParams {
    /// Makes settings usable.
    ///
    /// # Errors
    /// If μ or λ is negative or not finite, or there are more than 100 rings.
    pub fn check(self) -> Result<CheckedMetricParams, ParamError> {
        for (name, value) in [("mu", self.mu), ("lambda", self.lambda)] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(ParamError::Weight { name, value });
            }
        }
        if self.curvature_rings > MOST_RINGS {
            return Err(ParamError::Rings {
                rings: self.curvature_rings,
                most: MOST_RINGS,
            });
        }
        Ok(CheckedMetricParams(self))
    }
}

/// Why settings cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ParamError {
    /// A weight is negative or not a number.
    #[error("{name} must be zero or positive and finite, not {value}")]
    Weight {
        /// Name of the weight.
        name: &'static str,
        /// What it was.
        value: f64,
    },
    /// Averages over so many rings are not computed.
    #[error("curvature is averaged over at most {most} rings, not {rings}")]
    Rings {
        /// What was asked for.
        rings: u32,
        /// The limit.
        most: u32,
    },
}
