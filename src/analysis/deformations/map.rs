//! From the pose map to the map of whole deformations.

use std::sync::Arc;

use crate::analysis::embedding::{
    Embedding, EmbeddingError, LleParamError, LleParams, MapMethod, classical_mds, embed, lle,
};
use crate::analysis::pose_distances::{DistanceMatrix, PoseId};
use crate::progress::{Progress, Stopped};
use crate::study::Study;

use super::beats::{Beat, beats};
use super::params::{default_neighbours, neighbours_of_curves};
use super::{
    CheckedDeformationMapParams, DeformationMap, MappedParts, PartDistances, PartWeights, resampled,
};

/// The map is a plane.
const DIMENSIONS: usize = 2;

/// Fewest subjects that have a deformation map. The columns of coordinates of locally linear embedding have mean 0 and
/// length 1 and are orthogonal: three subjects are the corners of one and the same triangle however they move.
pub const FEWEST_DEFORMATIONS: usize = 4;

/// Why there is no deformation map.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DeformationMapError {
    /// It was asked to stop.
    #[error("{0}")]
    Stopped(#[from] Stopped),
    /// Few subjects lie alike however they move.
    #[error(
        "a deformation map needs at least {FEWEST_DEFORMATIONS} subjects, and there are {deformations}"
    )]
    TooFew {
        /// Subjects with a deformation.
        deformations: usize,
    },
    /// The pose map is of other poses.
    #[error("a map of {items} poses was given for {poses} poses")]
    Poses {
        /// Rows of the map.
        items: usize,
        /// Poses.
        poses: usize,
    },
    /// The embedding refuses its settings.
    #[error(transparent)]
    Settings(#[from] LleParamError),
    /// There is no embedding.
    #[error(transparent)]
    Embedding(EmbeddingError),
}

impl From<EmbeddingError> for DeformationMapError {
    fn from(error: EmbeddingError) -> Self {
        match error {
            EmbeddingError::Stopped(stopped) => Self::Stopped(stopped),
            other => Self::Embedding(other),
        }
    }
}

/// Axes of the space that neighbourhoods are looked up in; what further ones hold is noise.
const MAX_AXES: usize = 64;

/// The map of distances of whole deformations: one point per row, by locally linear embedding ([`lle()`]) of the space in
/// which the distances are Euclidean (classical scaling of all axes that are not zero, at most 64).
///
/// Settings that ask for more neighbours than there are other rows get all of them; how many were used stands in the result.
///
/// Where neighbourhoods fall into parts that do not see each other, as kinds of motion do that are far apart, a plane has
/// no room for what locally linear embedding would show: which part a row lies in, one axis for each part but one. Then
/// the map is that of the distances by stress majorisation, its axes of length 1 as well.
///
/// # Errors
/// If stopped, there are fewer than [`FEWEST_DEFORMATIONS`] rows, or the embedding fails.
pub fn map_of_distances(
    distances: &DistanceMatrix,
    params: &CheckedDeformationMapParams,
    progress: &Progress,
) -> Result<Embedding, DeformationMapError> {
    let count = distances.size();
    refuse_too_few(count)?;
    let space = classical_mds(distances, MAX_AXES.min(count - 1), progress)?;
    let settings = embedding_params(params, count, default_neighbours).check()?;
    let map = lle(&space.coordinates, count, &settings, progress)?;
    if map.parts.is_none_or(|parts| parts < 2) {
        return Ok(map);
    }
    let plane = embed(distances, MapMethod::Smacof, DIMENSIONS, progress)?;
    Ok(Embedding {
        coordinates: with_unit_axes(&plane),
        stress: plane.stress,
        reconstruction_error: None,
        eigenvalues: None,
        ..map
    })
}

/// Coordinates with every axis of length 1; an axis without length stays zero.
fn with_unit_axes(map: &Embedding) -> Vec<f64> {
    let mut lengths = vec![0.0; map.dimensions];
    for (at, x) in map.coordinates.iter().enumerate() {
        lengths[at % map.dimensions] += x * x;
    }
    let unit = |(at, x): (usize, &f64)| match lengths[at % map.dimensions].sqrt() {
        length if length > 0.0 => x / length,
        _ => 0.0,
    };
    map.coordinates.iter().enumerate().map(unit).collect()
}

/// [`map_of_distances`] of both parts with these weights.
///
/// # Errors
/// As [`map_of_distances`].
pub fn map_of_parts(
    parts: &Arc<PartDistances>,
    weights: PartWeights,
    params: &CheckedDeformationMapParams,
    progress: &Progress,
) -> Result<DeformationMap, DeformationMapError> {
    let distances = parts.weighted(weights);
    Ok(DeformationMap {
        subjects: parts.subjects.clone(),
        embedding: map_of_distances(&distances, params, progress)?,
        curves: Vec::new(),
        time_weight: None,
        parts: Some(MappedParts {
            distances,
            parts: Arc::clone(parts),
        }),
    })
}

/// The map of curves of poses: one point per subject.
///
/// 1. **Curves.** The poses of each subject on their map, from end-diastole to the end-diastole of the
///    next beat, with the share t of the beat as third coordinate: (x, y, w t). Without a typed w,
///    w = root mean square distance of all poses from their mean / standard deviation of their t.
/// 2. **Arc length.** Each curve is resampled at equal steps of its length in (x, y, w t). Sampled at
///    equal times instead, t would be the same number in all curves and cancel in every difference;
///    so it says where along its way a subject is slow or fast.
/// 3. **Plane.** The points of a curve one after the other are one vector per subject, and locally linear
///    embedding ([`lle()`]) maps them. Settings that ask for more neighbours than there are other
///    subjects get all of them; how many were used stands in the result.
///
/// # Errors
/// If stopped, there are fewer than [`FEWEST_DEFORMATIONS`] subjects, or the embedding fails.
pub fn deformation_map(
    study: &Study,
    poses: &[PoseId],
    map: &Embedding,
    params: &CheckedDeformationMapParams,
    progress: &Progress,
) -> Result<DeformationMap, DeformationMapError> {
    if map.len() != poses.len() {
        return Err(DeformationMapError::Poses {
            items: map.len(),
            poses: poses.len(),
        });
    }
    let beats = beats(study, poses);
    let count = beats.len();
    refuse_too_few(count)?;
    // Without this the axis with the larger numbers would decide the arc length alone.
    let time_weight = (params.time_weight).unwrap_or_else(|| balancing_weight(&beats, map));
    let curves: Vec<Vec<[f64; 3]>> = (beats.iter())
        .map(|beat| {
            progress.check()?;
            let curve = closed_curve(beat, map, time_weight);
            Ok(resampled(&curve, usize::from(params.samples)))
        })
        .collect::<Result<_, Stopped>>()?;
    let settings = embedding_params(params, count, neighbours_of_curves);
    let vectors: Vec<f64> = curves.iter().flatten().flatten().copied().collect();
    Ok(DeformationMap {
        subjects: beats.iter().map(|beat| beat.subject).collect(),
        embedding: lle(&vectors, count, &settings.check()?, progress)?,
        curves,
        time_weight: Some(time_weight),
        parts: None,
    })
}

fn refuse_too_few(deformations: usize) -> Result<(), DeformationMapError> {
    if deformations < FEWEST_DEFORMATIONS {
        return Err(DeformationMapError::TooFew { deformations });
    }
    Ok(())
}

fn embedding_params(
    params: &CheckedDeformationMapParams,
    deformations: usize,
    by_default: fn(usize) -> usize,
) -> LleParams {
    let neighbours = params.neighbours.map(usize::from);
    LleParams {
        // A deformation cannot be put together from itself.
        neighbours: (neighbours.unwrap_or_else(|| by_default(deformations))).min(deformations - 1),
        regularisation: params.regularisation,
        dimensions: DIMENSIONS,
    }
}

/// (x, y, w t) of the poses of a beat and, at t = 1, of its first pose again.
fn closed_curve(beat: &Beat, map: &Embedding, time_weight: f64) -> Vec<[f64; 3]> {
    // The cycle is periodic: without the way back the last interval would count for nothing.
    let again = beat.rows.first().map(|row| (row, &1.0));
    (beat.rows.iter().zip(&beat.times))
        .chain(again)
        .map(|(row, time)| {
            let [x, y] = place(map, *row);
            [x, y, time_weight * time]
        })
        .collect()
}

/// The weight with which place and time spread alike; 0 where there is no time.
fn balancing_weight(beats: &[Beat], map: &Embedding) -> f64 {
    let times: Vec<f64> = beats.iter().flat_map(|beat| &beat.times).copied().collect();
    let spread = |axis: usize| {
        let values: Vec<f64> = (0..map.len()).map(|row| place(map, row)[axis]).collect();
        variance(&values)
    };
    let time = variance(&times);
    if time > 0.0 {
        // Both coordinates of the plane together against the one of time.
        ((spread(0) + spread(1)) / time).sqrt()
    } else {
        0.0
    }
}

/// Mean squared distance from the mean.
fn variance(values: &[f64]) -> f64 {
    let count = values.len().max(1) as f64;
    let mean = values.iter().sum::<f64>() / count;
    values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / count
}

fn place(map: &Embedding, row: usize) -> [f64; 2] {
    let point = map.point(row);
    [0, 1].map(|axis| point.get(axis).copied().unwrap_or(0.0))
}
