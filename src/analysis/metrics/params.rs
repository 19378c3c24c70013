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

/// Over which neighbourhood of a vertex curvature is averaged, nearer vertices weighing more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CurvatureMean {
    /// Standard deviation of the weights along a direction, as a share of the square root of the surface's area: the
    /// same neighbourhood on a coarse and on a fine mesh.
    Radius(f64),
    /// So many rings of neighbours, whatever the mesh.
    Rings(u32),
}

impl CurvatureMean {
    /// Rings of neighbours on a surface of so many vertices.
    ///
    /// A ring adds to each vertex its neighbours. On an even mesh of V triangles' corners these are six at the distance h,
    /// h² = 2/√3 · A/V, so that a ring adds 6/7 · h²/2 to the variance along a direction: n rings make
    /// σ² = n · (2√3/7) · A/V.
    pub(super) fn rings(self, vertex_count: usize) -> u32 {
        match self {
            Self::Rings(rings) => rings,
            Self::Radius(share) => {
                let ring = 2.0 * 3.0_f64.sqrt() / 7.0;
                let rings = (share * share * vertex_count as f64 / ring).round();
                rings.min(f64::from(MAX_RINGS)) as u32
            }
        }
    }
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
    /// Over which neighbourhood curvature is averaged; used with `area_weights` only.
    pub curvature: CurvatureMean,
    /// Weight λ of the regulariser λ Σ X·Y. Counting by area with scale-free corners, X is relative
    /// to the radius of the sphere with the pose's area, so that λ compares it with strain.
    pub lambda: f64,
    /// How the regulariser counts vertices.
    pub regulariser: Regulariser,
}

impl Default for MetricParams {
    /// Displacement, the metric by which deformations are classified best. How many are right by the nearest neighbour, by the
    /// linear classifier, by that in the plane and by clusters, deformations not smoothed
    /// (`cargo test --release --test it no_other_metric -- --nocapture`), and τ of the four motions of 40 synthetic hearts,
    /// clean and with 5 % noise (`tests/it/motions_and_shapes.rs`):
    ///
    /// | metric | ACDC, five labels, of 100 | normal or not | gated SPECT, same patient, of 20 | built-in, of 23 | motions |
    /// |---|---|---|---|---|---|
    /// | **displacement**, transported by lengths | 55, 64, 58, 53 | 71, 73, 65, 53 | 8, 5, 7, 14 | 18, 18, 17, 15 | 100, 100 % |
    /// | displacement, copied | 53, 62, 61, 54 | 69, 70, 65, 60 | 7, 6, 9, 13 | 18, 19, 16, 14 | 100, 100 % |
    /// | displacement, transported by angles | 54, 66, 54, 58 | 68, 75, 64, 52 | 13, 16, 15, 13 | | |
    /// | angle-preserving | 48, 71, 45, 45 | 67, 68, 62, 70 | 12, 16, 14, 16 | 19, 18, 12, 14 | 87, 98 % |
    /// | isometric | 46, 67, 50, 44 | 68, 71, 63, 68 | 5, 6, 8, 13 | | |
    /// | quasi-conformal, μ = 0.25, transported by lengths | 45, 66, 40, 44 | 69, 68, 61, 72 | 5, 6, 4, 12 | | |
    /// | the same, transported by itself | 39, 53, 44, 46 | 68, 72, 66, 58 | 2, 2, 3, 10 | | 96, 76 % |
    /// | quasi-conformal, μ = 0.001, λ = 3 | 47, 64, 53, 43 | 62, 72, 65, 70 | 10, 15, 11, 16 | 19, 19, 15, 15 | 100, 98 % |
    ///
    /// A step of five of 100, or of two or three of 20, is within chance. Patients are recognised by what is left of their
    /// shape as well: motions that are copied leave none, and those that are transported by angles leave most. What is
    /// lost against angles is that it knows no path but the straight line, and that size counts: sizes are normalised.
    fn default() -> Self {
        Self::of(MetricKind::default())
    }
}

impl MetricParams {
    /// A kind with the weights that go with it.
    pub fn of(kind: MetricKind) -> Self {
        Self {
            kind,
            form: Form::default(),
            corners: Corners::default(),
            area_weights: true,
            // On real beats curvature is then a fifth to three fifths of the energy, see `SHARES.md` of the experiments.
            mu: 0.125,
            curvature: CurvatureMean::Radius(0.08),
            lambda: kind.lambda(),
            regulariser: Regulariser::default(),
        }
    }

    /// The metric of geodesics and of parallel transport where this one is that of distances: displacement knows no path
    /// but the straight line, so that lengths of edges take its place.
    ///
    /// From the endocardium of one subject in cine MRI onto that of another, and the same of the epicardium: by how much
    /// the transported motion changes, in percent of it, from 0 to 1, 3, 7 and 15 interpolated poses
    /// (`cargo test --release --test it interpolated_poses_change -- --nocapture`); and how far synthetic motions that are
    /// transported onto another object lie from the truth, mean of 24, where copying them without any metric leaves 18.9 %:
    ///
    /// | metric | endocardium | epicardium | error |
    /// |---|---|---|---|
    /// | **isometric, λ = 0.5** | 9.0, 6.4, 3.0, 2.3 | 6.7, 4.1, 2.1, 1.3 | 18.0 % |
    /// | isometric, λ = 0.25 | 10.3, 7.6, 4.1, 3.4 | 7.5, 6.0, 2.3, 1.9 | 18.6 % |
    /// | isometric, λ = 1 | 7.5, 4.8, 1.8, 1.9 | 5.1, 3.0, 1.7, 0.8 | 17.6 % |
    /// | angle-preserving, λ = 0.25 | 13.6, 9.5, 7.6, 7.0 | 9.4, 9.6, 5.7, 3.3 | 20.8 % |
    /// | angle-preserving, λ = 1 | 5.4, 4.6, 2.1, 1.7 | 4.5, 3.4, 1.8, 1.1 | 19.2 % |
    /// | quasi-conformal, μ = 0.25 | 46, 34, 49, 143 | 106, 66, 128, 96 | |
    /// | quasi-conformal, μ = 0.001, λ = 3 | 9.2, 4.8, 2.4, 6.0 | | 17.9 % |
    ///
    /// By the quasi-conformal metric transport does not settle at all: curvature, averaged over a radius, lets wrinkles
    /// below it bend the path for nothing.
    pub fn of_paths(self) -> Self {
        match self.kind.penalises_displacement() {
            true => self.with_kind(MetricKind::Isometric),
            false => self,
        }
    }

    /// Another kind with its weights, everything else as it is.
    pub fn with_kind(self, kind: MetricKind) -> Self {
        let Self {
            mu,
            curvature,
            lambda,
            ..
        } = Self::of(kind);
        Self {
            kind,
            mu,
            curvature,
            lambda,
            ..self
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

/// Rings past which none are added, since each costs a pass over all edges.
const MAX_RINGS: u32 = 400;

/// A radius past which an average spans any subject.
const LARGEST_RADIUS: f64 = 0.5;

impl MetricParams {
    /// Checks the settings once; an algorithm takes the checked type only.
    ///
    /// # Errors
    /// If μ or λ is negative or not finite, or curvature is averaged over more than half of √area or 400 rings.
    pub fn check(self) -> Result<CheckedMetricParams, ParamError> {
        for (name, value) in [("mu", self.mu), ("lambda", self.lambda)] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(ParamError::Weight { name, value });
            }
        }
        // Past this a mean covers any surface, and only costs time.
        match self.curvature {
            CurvatureMean::Rings(rings) if rings > MAX_RINGS => Err(ParamError::Rings {
                rings,
                most: MAX_RINGS,
            }),
            CurvatureMean::Radius(radius) if !(0.0..=LARGEST_RADIUS).contains(&radius) => {
                Err(ParamError::Radius(radius))
            }
            CurvatureMean::Rings(_) | CurvatureMean::Radius(_) => Ok(CheckedMetricParams(self)),
        }
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
    /// Not a radius.
    #[error("curvature is averaged over a radius between 0 and {LARGEST_RADIUS} of √area, not {0}")]
    Radius(f64),
    /// Averages over so many rings are not computed.
    #[error("curvature is averaged over at most {most} rings, not {rings}")]
    Rings {
        /// What was asked for.
        rings: u32,
        /// The limit.
        most: u32,
    },
}
