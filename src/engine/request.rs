//! What can be asked of a study.

use std::sync::Arc;

use crate::analysis::classification::ClassesParams;
use crate::analysis::deformations::DeformationMapParams;
use crate::analysis::embedding::{Embedding, MapMethod};
use crate::analysis::geodesics::GeodesicParams;
use crate::analysis::medial::MedialParams;
use crate::analysis::medial_space::RatioForm;
use crate::analysis::metrics::{Corners, CurvatureRole, Form, MetricParams};
use crate::analysis::pose_distances::{PoseDistanceParams, PoseDistances, PoseId};
use crate::analysis::thickening::ThickeningParams;
use crate::analysis::thickness_methods::ThicknessParams;
use crate::analysis::transport::{Reference, TransportParams};
use crate::analysis::verdicts::VerdictParams;
use crate::engine::activity::WorkKind;
use crate::engine::medial_map::MedialMapParams;
use crate::engine::settings::{ClassesSettings, DeformationMapSettings, PoseMapParams};
use crate::engine::thickening::ThickeningSettings;
use crate::engine::thickness::ThicknessSettings;
use crate::engine::verdicts::VerdictSettings;
use crate::progress::Stopped;

/// One question to a study. Subjects are indices into it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnalysisRequest {
    /// Clinical measures of every subject.
    Measures,
    /// Distances of all poses.
    PoseDistances(PoseDistanceParams),
    /// The map of all poses.
    PoseMap(PoseMapParams),
    /// The map of whole deformations.
    DeformationMap(DeformationMapSettings),
    /// How well classes can be told apart.
    Classes(ClassesSettings),
    /// Poses within every interval between frames of a beat.
    InBetweens {
        /// Whose beat.
        subject: usize,
        /// What the way costs, and how many poses.
        params: GeodesicParams,
    },
    /// Poses within one interval; those of a whole beat are made of these.
    Interval {
        /// Whose beat.
        subject: usize,
        /// From this frame to the next, from the last to the first.
        interval: usize,
        /// What the way costs, and how many poses.
        params: GeodesicParams,
    },
    /// The beat of one heart on another.
    Transfer {
        /// Whose beat.
        from: usize,
        /// Which heart.
        onto: usize,
        /// Along which path, and what is kept.
        params: TransportParams,
    },
    /// Which faces make two poses differ.
    Contribution {
        /// One pose.
        a: PoseId,
        /// The other.
        b: PoseId,
        /// How they are compared; faces are those of the hearts themselves, whatever is said of a
        /// transfer.
        distances: PoseDistanceParams,
    },
    /// The middle of one heart's wall over the beat: atoms and their radii.
    MedialBeat {
        /// Whose wall.
        subject: usize,
        /// How balls are laid into it.
        params: MedialParams,
    },
    /// How one heart's wall thickens, and which patches of it do not.
    Thickening {
        /// Whose wall.
        subject: usize,
        /// How balls are laid into it, and what counts as still.
        params: ThickeningSettings,
    },
    /// Whether each heart has an abnormal patch, by a rule of the labelled ones.
    Verdicts(VerdictSettings),
    /// The paths of all hearts in the medial shape space.
    MedialPaths(ThickeningSettings),
    /// The map of the poses of the medial shape space.
    MedialMap(MedialMapParams),
    /// Thickness of one heart's wall at a frame in all ways of measuring it.
    FrameThickness {
        /// Whose wall.
        subject: usize,
        /// At which frame.
        frame: usize,
        /// How it is measured.
        params: ThicknessSettings,
    },
}

/// How much of a subject an answer depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reads {
    /// Its surfaces.
    Surfaces,
    /// And its end-diastole.
    Shape,
    /// And its end-systole, unit and landmarks: all but its label and what is said of the patient.
    Heart,
}

/// The map of all poses.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseMap {
    /// What the map shows; rows correspond.
    pub distances: Arc<PoseDistances>,
    /// Two coordinates per pose.
    pub embedding: Embedding,
}

impl AnalysisRequest {
    /// The kind of work that it is.
    pub fn kind(&self) -> WorkKind {
        match self {
            Self::Measures => WorkKind::Measures,
            Self::PoseDistances(_) | Self::PoseMap(_) => WorkKind::PoseMap,
            Self::DeformationMap(_) => WorkKind::DeformationMap,
            Self::Classes(_) => WorkKind::Classes,
            Self::InBetweens { .. } | Self::Interval { .. } => WorkKind::InBetweens,
            Self::Transfer { .. } => WorkKind::Transfer,
            Self::Contribution { .. } => WorkKind::Contribution,
            Self::MedialBeat { .. } | Self::Thickening { .. } => WorkKind::Medial,
            Self::Verdicts(_) => WorkKind::Verdicts,
            Self::MedialPaths(_) | Self::MedialMap(_) => WorkKind::MedialMap,
            Self::FrameThickness { .. } => WorkKind::Thickness,
        }
    }

    /// The subjects on whose shapes alone the answer depends: it stays true while these stay as they
    /// are. `None` where it depends on the whole study.
    pub fn subjects(&self) -> Option<[usize; 2]> {
        match *self {
            Self::InBetweens { subject, .. }
            | Self::Interval { subject, .. }
            | Self::MedialBeat { subject, .. }
            | Self::Thickening { subject, .. }
            | Self::FrameThickness { subject, .. } => Some([subject, subject]),
            Self::Transfer { from, onto, .. } => Some([from, onto]),
            Self::Contribution { a, b, .. } => Some([a.subject, b.subject]),
            _ => None,
        }
    }

    /// How much of [its subjects](Self::subjects) the answer depends on.
    pub(super) fn reads(&self) -> Reads {
        match self {
            Self::MedialBeat { .. } => Reads::Surfaces,
            Self::Thickening { .. } | Self::FrameThickness { .. } => Reads::Heart,
            _ => Reads::Shape,
        }
    }

    /// What the activity list calls it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Measures => "Volumes and ejection fraction",
            Self::PoseDistances(_) => "Pose distances",
            Self::PoseMap(_) => "Pose map",
            Self::DeformationMap(_) => "Deformation map",
            Self::Classes(_) => "Classes",
            Self::InBetweens { .. } | Self::Interval { .. } => "Poses between frames",
            Self::Transfer { .. } => "Transfer of a beat",
            Self::Contribution { .. } => "Contributions to a distance",
            Self::MedialBeat { .. } => "Medial surface",
            Self::Thickening { .. } => "Thickening",
            Self::Verdicts(_) => "Verdicts",
            Self::MedialPaths(_) => "Paths of still parts",
            Self::MedialMap(_) => "Medial map",
            Self::FrameThickness { .. } => "Ways of measuring thickness",
        }
    }

    /// Its settings in words; empty where it has none.
    pub fn parameters(&self) -> String {
        match self {
            Self::Measures => String::new(),
            Self::PoseDistances(params) => distance_words(params),
            Self::PoseMap(params) => map_words(params),
            Self::DeformationMap(settings) => deformation_words(settings),
            Self::Classes(settings) => {
                let ClassesParams {
                    permutations, seed, ..
                } = settings.classes;
                let map = deformation_words(&settings.deformations);
                format!("{map}, {permutations} permutations, seed {seed}")
            }
            Self::InBetweens { params, .. } | Self::Interval { params, .. } => {
                let metric = metric_words(&params.metric);
                format!("{} per interval, {metric}", params.in_betweens)
            }
            Self::Transfer { params, .. } => {
                let metric = metric_words(&params.metric);
                format!("{} poses between the hearts, {metric}", params.in_betweens)
            }
            Self::Contribution { distances, .. } => metric_words(&distances.metric),
            Self::MedialBeat { params, .. } => medial_words(params),
            Self::Thickening { params, .. } => thickening_words(params),
            Self::Verdicts(settings) => {
                let VerdictParams {
                    ridge,
                    permutations,
                    seed,
                    ..
                } = settings.verdicts;
                let walls = thickening_words(&settings.thickening);
                format!("{walls}; ridge {ridge}, {permutations} permutations, seed {seed}")
            }
            Self::MedialPaths(settings) => thickening_words(settings),
            Self::MedialMap(params) => {
                let walls = thickening_words(&params.thickening);
                format!("{walls}; {}", method_words(params.method))
            }
            Self::FrameThickness { frame, params, .. } => thickness_words(*frame, params),
        }
    }
}

/// How poses are compared, as summaries and the activity list say it.
pub fn distance_words(params: &PoseDistanceParams) -> String {
    let mut metric = metric_words(&params.metric);
    if params.smoothing > 0.0 {
        metric += &format!(", smoothed over {} √area", params.smoothing);
    }
    match params.transport {
        None => metric,
        Some(transport) => match transport.reference {
            Reference::Mean => format!("{metric}, carried onto the mean"),
            Reference::Subject(index) => format!("{metric}, carried onto subject {index}"),
        },
    }
}

fn map_words(params: &PoseMapParams) -> String {
    let method = method_words(params.method);
    format!("{}, {method}", distance_words(&params.distances))
}

fn method_words(method: MapMethod) -> String {
    match method {
        MapMethod::ClassicalMds => "classical MDS".to_owned(),
        MapMethod::Smacof => "SMACOF".to_owned(),
        MapMethod::Isomap { neighbours } => format!("Isomap of {neighbours} neighbours"),
    }
}

fn thickness_words(frame: usize, settings: &ThicknessSettings) -> String {
    let ThicknessParams {
        slices,
        chords,
        voxels_across,
    } = settings.methods;
    format!(
        "frame {frame}, {}, {slices} slices of {chords} chords, {voxels_across} voxels across the wall",
        medial_words(&settings.medial)
    )
}

fn deformation_words(settings: &DeformationMapSettings) -> String {
    let DeformationMapParams {
        time_weight,
        neighbours,
        ..
    } = settings.map;
    let chosen = |typed: Option<String>| typed.unwrap_or_else(|| "by itself".to_owned());
    let time = chosen(time_weight.map(|w| w.to_string()));
    let neighbours = chosen(neighbours.map(|k| k.to_string()));
    let poses = map_words(&settings.poses);
    format!("{poses}, weight of time {time}, neighbours {neighbours}")
}

/// A metric with the settings that matter to it, as the activity list and figures say it.
pub fn metric_words(metric: &MetricParams) -> String {
    let kind = metric.kind.words().id;
    if !metric.kind.has_forms() {
        return kind.to_owned();
    }
    let form = match metric.form {
        Form::Printed => "printed form".to_owned(),
        Form::Bilinear => "bilinear form".to_owned(),
        Form::Frozen => "frozen form".to_owned(),
        Form::Additive if metric.curvature_role() == CurvatureRole::Term => {
            format!("additive form, μ = {}", metric.mu)
        }
        Form::Additive => "additive form".to_owned(),
    };
    let corners = match metric.corners {
        Corners::Raw => "raw corners",
        Corners::ScaleFree => "scale-free corners",
    };
    format!("{kind}, {form}, {corners}, λ = {}", metric.lambda)
}

/// How balls are laid into the wall, as summaries and the activity list say it.
pub fn medial_words(params: &MedialParams) -> String {
    let smoothing = match params.smoothing {
        0.0 => "surfaces as they are".to_owned(),
        share => format!("smoothed over {share} thicknesses"),
    };
    format!(
        "{smoothing}, separation {}, end {}",
        degrees(params.separation_rad),
        degrees(params.end_rad)
    )
}

/// Settings of the search for patches, as summaries and the activity list say it.
pub fn thickening_words(settings: &ThickeningSettings) -> String {
    let ThickeningParams {
        tolerance,
        ratio,
        core,
        still,
        border,
        min_share,
        min_thickening,
        smoothing,
        redraws,
        seed,
    } = settings.thickening;
    let tolerance = tolerance.map_or_else(|| "by noise".to_owned(), |t| format!("± {t}"));
    let ratio = match ratio {
        RatioForm::GeometricMean => "geometric mean",
        RatioForm::Product => "product",
    };
    format!(
        "{}, tolerance of ln PT {tolerance}, ratio as {ratio}, core {core}, still {still:.3}, border {border}, \
         least share {min_share}, least thickening {min_thickening:.3}, averaged over {smoothing}, \
         {redraws} redraws, seed {seed}",
        medial_words(&settings.medial)
    )
}

/// An angle as a person would say it; rounding of radians leaves no trace.
fn degrees(angle_rad: f64) -> String {
    format!("{}°", (angle_rad.to_degrees() * 1e6).round() / 1e6)
}

/// Why a request brought no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AnalysisError {
    /// It was asked to stop; no error to show.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// The study cannot answer it.
    #[error("{0}")]
    Unanswerable(String),
}

impl AnalysisError {
    /// An error of an analysis, in its words.
    pub(super) fn unanswerable(error: impl std::fmt::Display) -> Self {
        Self::Unanswerable(error.to_string())
    }
}

#[cfg(test)]
mod tests;
