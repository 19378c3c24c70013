//! How well classes are separated, from distances, a map and labels.

use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::analysis::embedding::{Embedding, EmbeddingError, classical_mds};
use crate::analysis::pose_distances::DistanceMatrix;
use crate::progress::{Progress, Stopped};

use super::linear_classifier::{LinearClassifier, Scratch, labelled_rows};
use super::nearest::NearestCases;
use super::nested_classifier::NestedClassifier;
use super::{Accuracy, Classes, k_means, tau};

/// Coordinates of the classical scaling that the linear classifier sees at most: 25, of which it takes as many as do best
/// without the case that is told.
pub const MAX_COMPONENTS: usize = 25;
/// Share of the largest eigenvalue below which a coordinate is round-off.
const MIN_COMPONENT: f64 = 1e-9;
/// Coordinates from here on are refused: their squares would not be numbers.
const TOO_LARGE: f64 = 1e150;
/// τ, nearest neighbour, linear classifier on the distances, linear classifier in the plane.
const CRITERIA: usize = 4;

/// Settings; [`ClassesParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClassesParams {
    /// Clusters to look for; `None` means as many as there are classes, and two where there are fewer.
    pub clusters: Option<u16>,
    /// Starts of k-means; the least inertia wins.
    pub restarts: u16,
    /// Permutations of the labels for the baselines.
    pub permutations: u32,
    /// Share of the mean variance in the covariance of the linear classifiers.
    pub shrinkage: f64,
    /// Seed of the starts and of the permutations.
    pub seed: u64,
}

impl Default for ClassesParams {
    /// A thousand permutations tell a share of 1 % to a third of itself.
    fn default() -> Self {
        Self {
            clusters: None,
            restarts: 50,
            permutations: 1000,
            shrinkage: 0.1,
            seed: 0,
        }
    }
}

/// Settings that have been checked.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CheckedClassesParams(pub(super) ClassesParams);

/// Why settings cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ClassesParamError {
    /// No clusters.
    #[error("at least 1 cluster is needed")]
    Clusters,
    /// No permutation, and so no baseline.
    #[error("at least 1 permutation of the labels is needed")]
    Permutations,
    /// No start.
    #[error("at least 1 start of k-means is needed")]
    Restarts,
    /// The tolerance is no share of the stress.
    #[error("shrinkage must be above 0 and at most 1, not {0}")]
    Shrinkage(f64),
}

impl ClassesParams {
    /// Checks the settings once; an algorithm takes the checked type only.
    ///
    /// # Errors
    /// If there are no clusters, starts or permutations, or the shrinkage is not in 0..=1 or is 0.
    pub fn check(self) -> Result<CheckedClassesParams, ClassesParamError> {
        if self.clusters == Some(0) {
            return Err(ClassesParamError::Clusters);
        }
        if self.restarts == 0 {
            return Err(ClassesParamError::Restarts);
        }
        if self.permutations == 0 {
            return Err(ClassesParamError::Permutations);
        }
        if !(self.shrinkage > 0.0 && self.shrinkage <= 1.0) {
            return Err(ClassesParamError::Shrinkage(self.shrinkage));
        }
        Ok(CheckedClassesParams(self))
    }
}

/// Why classes cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ClassifyError {
    /// It was asked to stop.
    #[error("{0}")]
    Stopped(#[from] Stopped),
    /// The coordinates for the linear classifier cannot be computed.
    #[error(transparent)]
    Embedding(EmbeddingError),
    /// Distances, map and labels are not of the same rows.
    #[error(
        "{distances} rows of distances, {plane} of the map and {labels} labels do not correspond"
    )]
    Rows {
        /// Rows of the distances.
        distances: usize,
        /// Items on the map.
        plane: usize,
        /// Labels, those that are missing included.
        labels: usize,
    },
    /// A coordinate that is not a finite number.
    #[error("coordinate {axis} of row {row} is not a finite number of moderate size")]
    NotFinite {
        /// The row.
        row: usize,
        /// The axis.
        axis: usize,
    },
}

/// Separation of classes by clusters, neighbours and linear classifiers, each with its permutation mean.
///
/// `labels` names the class of each row of the distances and of the map; rows without one are clustered,
/// and otherwise left out. Clusters are those of [`k_means()`](super::k_means()) in the plane, τ is by the best match
/// ([`tau()`]), the nearest neighbour is by the distances ([`leave_one_out_nearest`](super::leave_one_out_nearest)). The linear classifier on the
/// distances is [`leave_one_out_linear`](super::leave_one_out_linear) on the leading coordinates of their classical scaling: at
/// most [`MAX_COMPONENTS`], and fewer than half the cases; how many, 5, 10, … of them, is chosen for each fifth of the
/// cases by the other four, so that the own label of a case has no say in it. The one in the plane takes the map as it is.
/// Both see coordinates made from all cases, though of no label: the baseline does, too.
///
/// The baseline of each: the mean accuracy over permutations of the labels, and how many of
/// these do as well as the labels as they are. Clusters, neighbours and coordinates stay.
///
/// # Errors
/// If stopped, or if the rows do not correspond or hold what is not a finite number.
pub fn classify(
    distances: &DistanceMatrix,
    plane: &Embedding,
    labels: &[Option<&str>],
    params: &CheckedClassesParams,
    progress: &Progress,
) -> Result<Classes, ClassifyError> {
    check_rows(distances, plane, labels)?;
    let params = params.0;
    let (names, of_row) = named(labels);
    // As many clusters as classes, or τ could not reach 1.
    let wanted = params.clusters.map_or(names.len().max(2), usize::from);
    let clustering = k_means(
        &plane.coordinates,
        plane.dimensions,
        wanted,
        usize::from(params.restarts),
        params.seed,
        progress,
    )?;
    let matching = tau(&clustering.clusters, &of_row);
    let mut classes = Classes {
        names,
        of_row,
        clustering,
        confusion: matching.confusion,
        class_of_cluster: matching.class_of_cluster,
        ..Classes::default()
    };
    // With one class there is nothing to separate.
    if classes.names.len() < 2 {
        return Ok(classes);
    }
    let criteria = Criteria::new(distances, plane, &classes, params.shrinkage, progress)?;
    let [tau, nearest, linear, in_plane] = criteria.accuracies(&params, progress)?;
    classes.tau = Some(tau);
    classes.nearest_neighbour = Some(nearest);
    classes.linear_classifier = Some(linear);
    classes.plane_classifier = Some(in_plane);
    Ok(classes)
}

fn check_rows(
    distances: &DistanceMatrix,
    plane: &Embedding,
    labels: &[Option<&str>],
) -> Result<(), ClassifyError> {
    if distances.size() != plane.len() || labels.len() != plane.len() {
        return Err(ClassifyError::Rows {
            distances: distances.size(),
            plane: plane.len(),
            labels: labels.len(),
        });
    }
    // Squares of such numbers overflow, and with them every distance to a mean.
    let too_large = |x: &f64| x.is_nan() || x.abs() >= TOO_LARGE;
    match plane.coordinates.iter().position(too_large) {
        Some(at) => Err(ClassifyError::NotFinite {
            row: at / plane.dimensions,
            axis: at % plane.dimensions,
        }),
        None => Ok(()),
    }
}

/// The different labels in alphabetical order, and which of them each row has.
fn named(labels: &[Option<&str>]) -> (Vec<String>, Vec<Option<usize>>) {
    let mut names: Vec<&str> = labels.iter().copied().flatten().collect();
    // By name, so that numbers of classes do not depend on the order of the study.
    names.sort_unstable();
    names.dedup();
    let of_row = labels
        .iter()
        .map(|label| names.binary_search(&(*label)?).ok());
    (
        names.iter().copied().map(str::to_owned).collect(),
        of_row.collect(),
    )
}

/// All criteria, prepared for any labels of the same cases.
struct Criteria {
    clusters: Vec<usize>,
    nearest: NearestCases,
    linear: NestedClassifier,
    in_plane: LinearClassifier,
    classes: Vec<usize>,
}

#[derive(Default)]
struct CriteriaScratch {
    votes: Vec<usize>,
    linear: Scratch,
    labels: Vec<usize>,
    optional: Vec<Option<usize>>,
}

impl Criteria {
    fn new(
        distances: &DistanceMatrix,
        plane: &Embedding,
        classes: &Classes,
        shrinkage: f64,
        progress: &Progress,
    ) -> Result<Self, ClassifyError> {
        let rows: Vec<usize> = (0..classes.of_row.len())
            .filter(|&row| classes.of_row[row].is_some())
            .collect();
        progress.step()?;
        // A linear classifier needs coordinates; classical scaling gives those of the distances.
        let (components, width) = components(distances, &rows, progress)?;
        let (in_plane, own) = labelled_rows(&plane.coordinates, plane.dimensions, &classes.of_row);
        Ok(Self {
            clusters: rows
                .iter()
                .map(|&row| classes.clustering.clusters[row])
                .collect(),
            nearest: NearestCases::new(distances, &rows),
            linear: NestedClassifier::new(&components, width, shrinkage),
            in_plane: LinearClassifier::new(&in_plane, plane.dimensions, shrinkage),
            classes: own,
        })
    }

    /// Correct cases of each criterion with the labels of `scratch`.
    fn correct(&self, scratch: &mut CriteriaScratch) -> [usize; CRITERIA] {
        let CriteriaScratch {
            votes,
            linear,
            labels,
            optional,
        } = scratch;
        optional.clear();
        optional.extend(labels.iter().copied().map(Some));
        [
            tau(&self.clusters, optional).correct,
            self.nearest.correct(labels, votes),
            self.linear.correct(labels, linear),
            self.in_plane.correct(labels, linear),
        ]
    }

    fn accuracies(
        &self,
        params: &ClassesParams,
        progress: &Progress,
    ) -> Result<[Accuracy; CRITERIA], Stopped> {
        let mut scratch = CriteriaScratch {
            labels: self.classes.clone(),
            ..CriteriaScratch::default()
        };
        let correct = self.correct(&mut scratch);
        progress.expect_steps(params.permutations as usize);
        let permuted = (0..params.permutations)
            .into_par_iter()
            .map_init(CriteriaScratch::default, |scratch, number| {
                progress.step()?;
                let mut random = ChaCha8Rng::seed_from_u64(params.seed);
                // Streams of their own, and others than those of the starts of k-means.
                random.set_stream(u64::from(number) | 1 << 32);
                scratch.labels.clone_from(&self.classes);
                scratch.labels.shuffle(&mut random);
                Ok(self.correct(scratch))
            })
            .collect::<Result<Vec<_>, Stopped>>()?;
        Ok(std::array::from_fn(|criterion| {
            let of = self.classes.len();
            let sum: usize = permuted.iter().map(|correct| correct[criterion]).sum();
            let as_good = permuted
                .iter()
                // As good counts as better: with few cases ties are common.
                .filter(|p| p[criterion] >= correct[criterion])
                .count();
            let count = f64::from(params.permutations);
            Accuracy {
                correct: correct[criterion],
                of,
                baseline: sum as f64 / (count * of as f64),
                // The labels as they are count as one permutation, so that no p-value is zero.
                p_value: (1.0 + as_good as f64) / (1.0 + count),
            }
        }))
    }
}

/// Leading coordinates of the classical scaling of some rows, and how many of them each row has.
fn components(
    distances: &DistanceMatrix,
    rows: &[usize],
    progress: &Progress,
) -> Result<(Vec<f64>, usize), ClassifyError> {
    let among = DistanceMatrix::of_pairs(rows.len(), |i, j| distances.get(rows[i], rows[j]))
        .unwrap_or_else(DistanceMatrix::empty);
    // With half as many components as cases a plane would separate labels drawn at random.
    let most = MAX_COMPONENTS.min(rows.len().saturating_sub(1) / 2);
    let map = classical_mds(&among, most, progress).map_err(|error| match error {
        EmbeddingError::Stopped(stopped) => ClassifyError::Stopped(stopped),
        other => ClassifyError::Embedding(other),
    })?;
    let values = map.eigenvalues.as_deref().unwrap_or_default();
    let largest = values.first().copied().unwrap_or(0.0);
    let width = (values.iter().take(most))
        // What is left is round-off, and would be weighted like the rest by the scatter.
        .take_while(|value| **value > MIN_COMPONENT * largest)
        .count();
    let coordinates = (0..map.len()).flat_map(|row| map.point(row)[..width].iter().copied());
    Ok((coordinates.collect(), width))
}

#[cfg(test)]
mod tests;
