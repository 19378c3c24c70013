//! Settings of the map of whole deformations.

use crate::analysis::embedding::{LleParamError, LleParams};
use crate::analysis::pose_distances::{PoseDistanceParamError, PoseDistanceParams};

/// How much each part of a distance of two beats counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartWeights {
    /// Of motion relative to the own end-diastole.
    pub deformation: f64,
    /// Of the end-diastolic shape.
    pub shape: f64,
}

impl PartWeights {
    /// How hearts deform, whatever their shape.
    pub const DEFORMATION: Self = Self {
        deformation: 1.0,
        shape: 0.0,
    };
    /// Both alike.
    pub const BOTH: Self = Self {
        deformation: 1.0,
        shape: 1.0,
    };
    /// How hearts are shaped at end-diastole, whatever they do.
    pub const SHAPE: Self = Self {
        deformation: 0.0,
        shape: 1.0,
    };
}

/// What of two beats is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Comparison {
    /// Deformation and shape apart, see [`super::PartDistances::weighted`]; the map is made of the distances.
    Parts(PartWeights),
    /// Poses at equal phases, in which both are mixed: the map is made of curves on the pose map, as in the text.
    Poses,
}

impl Comparison {
    /// Those with a name, the default first.
    pub const NAMED: [Self; 4] = [
        Self::Parts(PartWeights::DEFORMATION),
        Self::Parts(PartWeights::BOTH),
        Self::Parts(PartWeights::SHAPE),
        Self::Poses,
    ];

    /// What is compared, in a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Parts(weights) if weights.shape <= 0.0 => "deformation",
            Self::Parts(weights) if weights.deformation <= 0.0 => "shape",
            Self::Parts(_) => "deformation + shape",
            Self::Poses => "curves of poses",
        }
    }
}

impl Default for Comparison {
    fn default() -> Self {
        Self::Parts(PartWeights::DEFORMATION)
    }
}

/// Settings of the deformation map; [`DeformationMapParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeformationMapParams {
    /// What of two beats is compared.
    pub comparison: Comparison,
    /// Radius, in shares of the square root of a surface's area, below which poses are smoothed before deformations are
    /// compared; that of the pose map counts for shapes and where poses are compared.
    pub smoothing: f64,
    /// Weight w of time in the curves (x, y, w t), t the share of the beat. `None`: the root mean
    /// square radius of all poses on their map over the standard deviation of their t, so that place
    /// and time count alike. 0 leaves time out.
    pub time_weight: Option<f64>,
    /// Points of each curve, at equal steps of spatiotemporal arc length.
    pub samples: u16,
    /// Neighbours from which each deformation is put together in the embedding; `None`: by the
    /// number of deformations, see [`default_neighbours`].
    pub neighbours: Option<u16>,
    /// Regularisation of the neighbours' weights, relative to the trace of their Gram matrix.
    pub regularisation: f64,
}

impl Default for DeformationMapParams {
    /// Deformations as they are: no radius is best everywhere. How many are right by the nearest neighbour, by the linear
    /// classifier, by that in the plane and by clusters (`cargo test --release --test it real_deformations -- --nocapture`):
    ///
    /// | smoothing, √area | ACDC, five labels, of 100 | gated SPECT, same patient, of 20 |
    /// |---|---|---|
    /// | **0** | 55, 64, 58, 53 | 8, 5, 7, 14 |
    /// | 0.01 | 55, 64, 59, 54 | 8, 5, 5, 14 |
    /// | 0.02 | 54, 63, 57, 51 | 8, 5, 8, 14 |
    /// | 0.03 | 53, 67, 57, 60 | 8, 6, 7, 12 |
    /// | 0.05 | 58, 66, 56, 54 | 8, 6, 10, 12 |
    /// | 0.07 | 55, 62, 53, 49 | 6, 4, 6, 13 |
    /// | 0.1 | 57, 61, 54, 55 | 6, 3, 7, 12 |
    /// | 0.15 | 54, 65, 48, 47 | 6, 2, 4, 11 |
    /// | chosen without the case (nearest neighbour) | 56 | 8 |
    ///
    /// What the metric does stands at [`MetricParams::default`](crate::analysis::metrics::MetricParams).
    ///
    /// 64 points: four for each of 16 frames, so that the corners that resampling cuts are small
    /// against the steps between frames.
    fn default() -> Self {
        Self {
            comparison: Comparison::default(),
            smoothing: 0.0,
            time_weight: None,
            samples: 64,
            neighbours: None,
            regularisation: 1e-3,
        }
    }
}

/// Neighbours from which a deformation is put together on a map of distances where nothing is typed: a tenth of the
/// deformations, at least 8 and at most 12, and less than all.
pub fn default_neighbours(deformations: usize) -> usize {
    // One fewer than all: a deformation is no neighbour of itself.
    (deformations / 10)
        .clamp(8, 12)
        .min(deformations.saturating_sub(1))
}

/// The same on a map of curves: half of the
/// deformations, at least 4 and less than all, so that no class of up to half of them finds all its
/// neighbours within itself.
///
/// Where classes are far apart, as they should be, fewer neighbours make each class a neighbourhood of
/// its own, M has nearly as many vectors of eigenvalue zero as there are classes, and a plane shows a
/// random two of them: some classes fall onto each other. On 60 synthetic deformations in four classes τ
/// falls with 12 neighbours to 63 % on single draws, and on average to 97 % on clean data
/// and 85 % with 20 % noise, against 100 % and 95 % with 30.
///
/// On the built-in cohort (23 subjects) the nearest neighbour on the plane has the same label, by the
/// number of neighbours, for
///
/// | pose map | 3 | 4 | 5 | 6 | 8 | 10 | 12 | 16 | 20 | the curves themselves |
/// |---|---|---|---|---|---|---|---|---|---|---|
/// | SMACOF | 11 | 15 | 16 | 20 | 18 | 19 | 18 | 18 | 18 | 20 |
/// | classical MDS | 20 | 20 | 19 | 18 | 21 | 20 | 20 | 21 | 21 | 21 |
pub(super) fn neighbours_of_curves(deformations: usize) -> usize {
    // Half of them reach beyond any class of up to half.
    let half = deformations.div_ceil(2).max(4);
    // One fewer than all: a deformation is no neighbour of itself.
    half.min(deformations.saturating_sub(1))
}

/// Fewer points do not make a curve.
const MIN_SAMPLES: u16 = 2;

/// More points than frames of any beat; memory grows with them.
const MAX_SAMPLES: u16 = 1_024;

/// Settings that have been checked; read them like the fields of [`DeformationMapParams`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedDeformationMapParams(DeformationMapParams);

impl std::ops::Deref for CheckedDeformationMapParams {
    type Target = DeformationMapParams;

    fn deref(&self) -> &DeformationMapParams {
        &self.0
    }
}

impl DeformationMapParams {
    /// Checks the settings once; an algorithm takes the checked type only.
    ///
    /// # Errors
    /// If a weight or a count is out of range.
    pub fn check(self) -> Result<CheckedDeformationMapParams, DeformationParamError> {
        if let Comparison::Parts(PartWeights { deformation, shape }) = self.comparison {
            for weight in [deformation, shape] {
                if !(weight.is_finite() && weight >= 0.0) {
                    return Err(DeformationParamError::PartWeight(weight));
                }
            }
            if deformation + shape <= 0.0 {
                return Err(DeformationParamError::NoPart);
            }
        }
        let weight = self.time_weight.unwrap_or(0.0);
        if !(weight.is_finite() && weight >= 0.0) {
            return Err(DeformationParamError::TimeWeight(weight));
        }
        if !(MIN_SAMPLES..=MAX_SAMPLES).contains(&self.samples) {
            return Err(DeformationParamError::Samples {
                samples: self.samples,
                fewest: MIN_SAMPLES,
                most: MAX_SAMPLES,
            });
        }
        let neighbours = self.neighbours.map_or(1, usize::from);
        let embedding = LleParams {
            neighbours,
            regularisation: self.regularisation,
            ..LleParams::default()
        };
        embedding.check()?;
        let smoothing = PoseDistanceParams {
            smoothing: self.smoothing,
            ..PoseDistanceParams::default()
        };
        smoothing.check()?;
        Ok(CheckedDeformationMapParams(self))
    }
}

/// Why settings cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DeformationParamError {
    /// The radius of smoothing is out of range.
    #[error(transparent)]
    Smoothing(#[from] PoseDistanceParamError),
    /// The weight of a part is negative or not a number.
    #[error("weights of deformation and shape must be zero or positive and finite, not {0}")]
    PartWeight(f64),
    /// Nothing is compared.
    #[error("one of the weights of deformation and shape must be above zero")]
    NoPart,
    /// The weight of time is negative or not a number.
    #[error("the weight of time must be zero or positive and finite, not {0}")]
    TimeWeight(f64),
    /// So few or so many points are not computed.
    #[error("a curve has {fewest} to {most} points, not {samples}")]
    Samples {
        /// What was asked for.
        samples: u16,
        /// The least.
        fewest: u16,
        /// The most.
        most: u16,
    },
    /// The embedding refuses its settings.
    #[error(transparent)]
    Embedding(#[from] LleParamError),
}
