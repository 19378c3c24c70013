//! Why a template cannot be laid onto a subject.

use crate::mesh::MeshError;
use crate::progress::Stopped;
use crate::study::{SequenceError, SurfaceKind};

/// Why a surface gives no target.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TargetError {
    /// Too coarse to have a form.
    #[error("{faces} faces are too few: at least {needed} are needed")]
    FewFaces {
        /// How many there are.
        faces: usize,
        /// How many are needed.
        needed: usize,
    },
    /// All vertices in one place or on a line, or too far out for arithmetic.
    #[error("the surface has no area")]
    NoExtent,
    /// Nobody knows which piece is meant.
    #[error("the surface has {pieces} separate pieces of similar size")]
    SeveralPieces {
        /// How many.
        pieces: usize,
    },
    /// A tube, or a surface that is mostly hole.
    #[error("the surface has {openings} openings of similar length: only the base may be open")]
    SeveralOpenings {
        /// How many.
        openings: usize,
    },
    /// Nothing tells the apex from the base.
    #[error("the surface does not show where its apex and its base are: mark both")]
    NoAxis,
    /// The axis leaves the surface, or the surface does not go around it.
    #[error("the surface does not go around its long axis: {landmark} was not found")]
    NoLandmark {
        /// The first landmark that is missing.
        landmark: &'static str,
    },
    /// A coordinate that is no number.
    #[error("{landmark} has a coordinate that is not a finite number")]
    LandmarkNotFinite {
        /// The first such landmark.
        landmark: &'static str,
    },
    /// Landmarks that make no map.
    #[error("the landmarks give no map: {0}")]
    Landmarks(String),
    /// The surface and the template are too different.
    #[error(
        "the template does not fit: mean distance {mean:.2}, 95th percentile {p95:.2}, {foldovers} foldovers; allowed are {max_mean:.2}, {max_p95:.2} and {max_foldovers}"
    )]
    Misfit {
        /// In the unit of the coordinates.
        mean: f64,
        /// In the unit of the coordinates.
        p95: f64,
        /// Faces.
        foldovers: usize,
        /// Limit of the mean.
        max_mean: f64,
        /// Limit of the 95th percentile.
        max_p95: f64,
        /// Limit of foldovers.
        max_foldovers: usize,
    },
    /// A wall in one surface whose sides are not known.
    #[error("{0}")]
    Wall(String),
    /// Faces that are no mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Stopped.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}

/// Why a subject is not registered.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CorrespondenceError {
    /// Nothing to do.
    #[error("the subject has no surface that the template has")]
    NoSurface,
    /// Nothing to lay onto others.
    #[error("the template has neither an endocardium nor an epicardium")]
    NoTemplate,
    /// Landmarks of another subject.
    #[error(
        "the landmarks are those of {given} frames and {given_surfaces} surfaces, but there are {frames} and {surfaces}"
    )]
    LandmarkCounts {
        /// Frames of the landmarks.
        given: usize,
        /// Surfaces of the landmarks.
        given_surfaces: usize,
        /// Frames of the subject.
        frames: usize,
        /// Surfaces of the subject that the template has.
        surfaces: usize,
    },
    /// Two surfaces with different numbers of frames.
    #[error("{kind} has {frames} frames, but {first_kind} has {first_frames}")]
    FrameCounts {
        /// The word for the second surface.
        kind: &'static str,
        /// Its frames.
        frames: usize,
        /// The word for the first surface.
        first_kind: &'static str,
        /// Its frames.
        first_frames: usize,
    },
    /// One surface at one frame.
    #[error("{surface}, frame {frame}: {reason}")]
    Frame {
        /// The word for the surface.
        surface: &'static str,
        /// From 0.
        frame: usize,
        /// Why.
        reason: TargetError,
    },
    /// Meshes that make no sequence.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// A surface of the template.
    #[error("{surface} of the template: {reason}")]
    Template {
        /// The word for the surface.
        surface: &'static str,
        /// Why.
        reason: TargetError,
    },
    /// A setting out of range.
    #[error("{name} must lie in {range}, but is {value}")]
    Setting {
        /// Which.
        name: &'static str,
        /// Where it must lie.
        range: &'static str,
        /// What it is.
        value: f64,
    },
    /// It was asked to stop; no error to show.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}

impl CorrespondenceError {
    /// A reason with its surface and frame; being asked to stop is none.
    pub(super) fn at(kind: SurfaceKind, frame: usize, reason: TargetError) -> Self {
        match reason {
            TargetError::Stopped(stopped) => Self::Stopped(stopped),
            reason => Self::Frame {
                surface: kind.name(),
                frame,
                reason,
            },
        }
    }
}
