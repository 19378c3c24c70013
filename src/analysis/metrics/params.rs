//! Which metric, in which form, with which weights.

use super::kind::MetricKind;

/// How the terms of a metric are put together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Form {
    /// Absolute values as printed in the text, for one-step distances only. Not an inner product: the term of
    /// −X is that of X; and along paths of several steps the quasi-conformal energy can be made to vanish.
    Printed,
    /// Sums of products of the same terms, curvature change as a factor; quasi-conformal for one-step
    /// distances only, since the factor depends on the field.
    Bilinear,
    /// Curvature weights of the two poses of a pair, which are then given: with them an inner product, with others another.
    Frozen,
    /// Sums of products, of the quasi-conformal metric the angle term plus μ times the curvature-change term: an inner
    /// product everywhere. The form of metrics of lengths and of displacements, too, which have no other.
    #[default]
    Additive,
}

impl Form {
    /// Name in files, in running text and as a value of `--form`.
    pub fn id(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::Bilinear => "bilinear",
            Self::Frozen => "frozen",
            Self::Additive => "additive",
        }
    }

    /// Name in the window.
    pub fn name(self) -> &'static str {
        match self {
            Self::Printed => "As printed",
            Self::Bilinear => "Bilinear",
            Self::Frozen => "Frozen weights",
            Self::Additive => "Additive",
        }
    }
}

/// What a metric uses curvature for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurvatureRole {
    /// Nothing.
    Unused,
    /// Its change is a term of its own, with weight μ.
    Term,
    /// Its change in a step multiplies the corner terms of that step.
    StepFactor,
    /// Its change between the two ends of a path multiplies the corner terms of all steps.
    FrozenFactor,
}

impl CurvatureRole {
    /// Whether curvature change multiplies corner terms.
    pub fn is_factor(self) -> bool {
        match self {
            Self::Unused | Self::Term => false,
            Self::StepFactor | Self::FrozenFactor => true,
        }
    }
}

/// Units of the corner terms of eq. 3.3.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Corners {
    /// As printed: grows with the fourth power of size.
    Raw,
    /// Divided by |pq|²|pr|²: scale-invariant.
    #[default]
    ScaleFree,
}

/// How the regularising term Σ Xₚ·Yₚ counts vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Regulariser {
    /// Every vertex the same.
    Uniform,
    /// By the share of the whole area around the vertex.
    #[default]
    Area,
}

/// Settings of a metric; [`MetricParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MetricParams {
    /// What is penalised.
    pub kind: MetricKind,
    /// How terms combine; only angle-preserving and quasi-conformal metrics have forms.
    pub form: Form,
    /// Raw or scale-free corners.
    pub corners: Corners,
    /// Whether sums stand for integrals over the surface: faces, edges and vertices count by their
    /// share of the whole area, and curvature is a density averaged over rings. If not, sums are
    /// those of the text: everything counts once, and curvature is the raw angle deficit.
    pub area_weights: bool,
    /// Weight μ of the curvature term in the additive form.
    pub mu: f64,
    /// Rings of neighbours over which curvature is averaged; used with `area_weights` only.
    pub curvature_rings: u32,
    /// Weight λ of the regulariser λ Σ X·Y. Counting by area with scale-free corners, X is relative
    /// to the radius of the sphere with the pose's area, so that λ compares it with strain.
    pub lambda: f64,
    /// How the regulariser counts vertices.
    pub regulariser: Regulariser,
}

impl Default for MetricParams {
    /// Weights chosen on real subjects, all sizes normalised and pairs aligned.
    ///
    /// | metric | partner | five labels | infarct or dilated |
    /// |---|---|---|---|
    /// | printed (eq. 3.5), scale-free corners | 6 of 20 | 42 and 46 of 100 | 50 and 48 of 60 |
    /// | additive, μ = 1, 2 rings, λ = 10⁻⁴ | 7 | 43, 46 | 50, 50 |
    /// | additive, μ = 10⁻², 4 rings, λ = 10⁻⁴ | 12 | 57, 59 | 54, 53 |
    /// | additive, μ = 10⁻³, 4 rings, λ = 10⁻⁴ | 14 | 54, 59 | 51, 52 |
    /// | angle-preserving, λ = 10⁻⁴ | 14 | 54, 60 | 50, 54 |
    /// | **additive, μ = 10⁻³, 4 rings, λ = 3** | 17 | 56, 60 | 52, 56 |
    /// | additive, μ = 10⁻³, 4 rings, λ = 10 | 18 | 59, 57 | 52, 58 |
    /// | rigid: displacement alone | 19 | 65, 54 | 55, 57 |
    ///
    /// *Partner:* gated SPECT, 10 patients at rest and under stress, 8 gates: how many of the 20
    /// sequences have the same patient's other one as the nearest. *Five labels* and *infarct or
    /// dilated* (against normal): ACDC walls at end-diastole and end-systole, leave-one-out, by one and
    /// by five neighbours. A step of two or three in a column is within chance. Poses were not smoothed
    /// then; what partners are by today's defaults, `cardiomorph experiment partners` prints.
    ///
    /// So curvature as measured on meshes of some hundred vertices helps only in a small dose and
    /// averaged over several rings, and displacement must count about as much as strain.
    fn default() -> Self {
        Self {
            kind: MetricKind::default(),
            form: Form::default(),
            corners: Corners::default(),
            area_weights: true,
            mu: 1e-3,
            curvature_rings: 4,
            lambda: 3.0,
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

/// Rings past which an average spans any subject; each ring costs a pass over all edges.
const MAX_RINGS: u32 = 100;

impl MetricParams {
    /// Checks the settings once; an algorithm takes the checked type only.
    ///
    /// # Errors
    /// If μ or λ is negative or not finite, or there are more than 100 rings.
    pub fn check(self) -> Result<CheckedMetricParams, ParamError> {
        for (name, value) in [("mu", self.mu), ("lambda", self.lambda)] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(ParamError::Weight { name, value });
            }
        }
        // Past this a mean covers any surface, and only costs time.
        if self.curvature_rings > MAX_RINGS {
            return Err(ParamError::Rings {
                rings: self.curvature_rings,
                most: MAX_RINGS,
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
        /// The value that was given.
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
