//! All pairs of poses, in parallel, with the same bits for any number of threads.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::analysis::alignment::{
    LeftOut, comparable_subjects, cross_covariance, rotation_from_covariance,
};
use crate::analysis::metrics::{Metric, PairScratch, PreparedPose};
use crate::analysis::transport::transport_cohort;
use crate::mesh::Faces;
use crate::numeric::in_waves;
use crate::progress::{Progress, Stopped};
use crate::study::Study;

use super::bands::{Bands, PREPARED_BYTES, WAVE};
use super::known::KnownRows;
use super::smooth::smoothed_study;
use super::source::{Source, own_sources, poses_of, transported_sources};
use super::{
    CheckedPoseDistanceParams, DistanceMatrix, KnownDistances, PoseDistanceError, PoseDistances,
    PoseId,
};

/// Share of the whole time that transporting motions onto one subject takes.
const TRANSPORT_SHARE: f32 = 0.8;

/// Rows and columns of a block of pairs that one thread does in one go: its 16 poses of some
/// 0.4 MB fit into the cache that cores share, and each is used eight times while it is there.
const BLOCK: usize = 8;

/// One-step distances of all poses of the largest group of corresponding subjects.
///
/// 0. **Smoothing** ([`smoothed_study`]): what is finer than a radius is taken out of every surface.
/// 1. **Size.** Coordinates are divided by one scale per sequence
///    ([`SizeScale`](crate::analysis::alignment::SizeScale)): the largest box side at end-diastole, as
///    stated by the subject, else frame 0.
/// 2. **Transport**, if asked for: every motion is transported onto one subject ([`transport_cohort`]).
/// 3. **Alignment.** Each pair is aligned by itself: the rigid motion that lays the second pose onto
///    the first, of least squares over vertices. So a distance depends on its two poses alone (and on
///    the subject that they were transported onto): moving an input, or adding a subject, changes no other
///    number, and `metric --align rigid` gives the same one of smoothed poses. Aligning all to a mean would be
///    cheaper by little, and would make every distance depend on the whole cohort and not be the
///    least of the pair.
/// 4. **Metric.** √((⟨⟨X, X⟩⟩ at A + ⟨⟨X, X⟩⟩ at B) / 2), X = B − A.
///
/// Which subjects take part is said by [`comparable_subjects`].
///
/// # Errors
/// If stopped, or the subject that all motions were to be transported onto is not usable. The flag is
/// heard once per pose and per pair.
pub fn pose_distances(
    study: &Study,
    params: &CheckedPoseDistanceParams,
    progress: &Progress,
) -> Result<PoseDistances, PoseDistanceError> {
    Ok(pose_distances_knowing(study, params, None, progress)?.distances)
}

/// [`pose_distances`] of those pairs alone that are `needed`; the others stand as 0 in the matrix, whatever they are.
///
/// # Errors
/// As [`pose_distances`].
pub fn pose_distances_where(
    study: &Study,
    params: &CheckedPoseDistanceParams,
    needed: &Needed<'_>,
    progress: &Progress,
) -> Result<PoseDistances, PoseDistanceError> {
    Ok(computed(study, params, (None, needed), PREPARED_BYTES, progress)?.distances)
}

/// Which pairs are computed.
pub type Needed<'a> = dyn Fn(PoseId, PoseId) -> bool + Sync + 'a;

/// Distances and how much work they were.
#[derive(Clone, Debug, PartialEq)]
pub struct ComputedDistances {
    /// The answer, the same bits as without anything known.
    pub distances: PoseDistances,
    /// Pairs that were computed; the others were known.
    pub new_pairs: usize,
}

/// [`pose_distances`], given an earlier answer to the same settings on another state of the study:
/// only pairs with a pose that is not among its poses are computed.
///
/// # Errors
/// As [`pose_distances`].
pub fn pose_distances_knowing(
    study: &Study,
    params: &CheckedPoseDistanceParams,
    known: Option<&KnownDistances<'_>>,
    progress: &Progress,
) -> Result<ComputedDistances, PoseDistanceError> {
    computed(
        study,
        params,
        (known, &|_, _| true),
        PREPARED_BYTES,
        progress,
    )
}

/// The same of the pairs that are needed, with at most so many bytes of poses made ready for comparison at a time.
fn computed(
    study: &Study,
    params: &CheckedPoseDistanceParams,
    (known, needed): (Option<&KnownDistances<'_>>, &Needed<'_>),
    bytes: usize,
    progress: &Progress,
) -> Result<ComputedDistances, PoseDistanceError> {
    let (comparable, left_out) = comparable_subjects(study);
    let known = known.filter(|known| known.hold(study, params.transport.as_ref()));
    let all = poses_of(&comparable);
    // Asked before anything is smoothed: an edited label costs no work at all.
    let rows = KnownRows::of(known, study, &all);
    if rows.all_known() {
        return Ok(ComputedDistances {
            distances: PoseDistances {
                distances: assembled(&all, &rows),
                poses: all,
                left_out,
            },
            new_pairs: 0,
        });
    }
    let smooth = smoothed_study(study, params.smoothing, progress)?;
    // Sizes are those of the smoothed poses, as the distances are.
    let (comparable, left_out) = comparable_subjects(&smooth);
    let faces = comparable
        .first()
        .map(|m| m.subject.sequence.joined_faces());
    let metric = Metric::new(&faces.unwrap_or_else(|| Faces::joined(&[])), params.metric);
    let Some(transport) = &params.transport else {
        let sources = own_sources(&comparable);
        let within = (study, bytes);
        return compared(
            within,
            &metric,
            (known, needed),
            &sources,
            left_out,
            progress,
        );
    };
    let transporting = progress.part(
        "transporting all motions onto one subject",
        0.0,
        TRANSPORT_SHARE,
    );
    let cohort = transport_cohort(&smooth, &params.metric, transport, &transporting)?;
    let sources = transported_sources(&cohort);
    let left_out = cohort.left_out.clone();
    let comparing = progress.part("comparing poses", TRANSPORT_SHARE, 1.0);
    compared(
        (study, bytes),
        &metric,
        (known, needed),
        &sources,
        left_out,
        &comparing,
    )
}

/// Prepares poses and computes the pairs that are not known.
fn compared(
    (study, bytes): (&Study, usize),
    metric: &Metric,
    (known, needed): (Option<&KnownDistances<'_>>, &Needed<'_>),
    sources: &[Source<'_>],
    mut left_out: Vec<LeftOut>,
    progress: &Progress,
) -> Result<ComputedDistances, PoseDistanceError> {
    let pairs = sources.len() * sources.len().saturating_sub(1) / 2;
    progress.expect_steps(sources.len() + pairs);
    // Once per pose, not once per pair: areas, edges and curvature depend on one pose alone.
    let (mut bands, usable) = Bands::new(metric, sources, (bytes, BLOCK), progress)?;
    leave_out_unprepared(sources, &usable, &mut left_out);
    // One unusable frame takes the whole subject out, since its motion would have a gap.
    let kept: Vec<bool> = (sources.iter())
        .map(|source| {
            let mut others = left_out.iter();
            others.all(|left| left.subject != source.pose.subject)
        })
        .collect();
    bands.keep(&usable, &kept);
    let poses: Vec<PoseId> = bands.sources().iter().map(|source| source.pose).collect();
    let rows = KnownRows::of(known, study, &poses);
    let needed = |i: usize, j: usize| needed(poses[i], poses[j]);
    let (distances, new_pairs) = all_pairs(metric, &bands, &rows, needed, progress)?;
    Ok(ComputedDistances {
        distances: PoseDistances {
            poses,
            distances,
            left_out,
        },
        new_pairs,
    })
}

fn leave_out_unprepared(sources: &[Source<'_>], usable: &[bool], left_out: &mut Vec<LeftOut>) {
    for (source, usable) in sources.iter().zip(usable) {
        let subject = source.pose.subject;
        if !usable && left_out.iter().all(|left| left.subject != subject) {
            left_out.push(LeftOut {
                subject,
                reason: format!(
                    "lengths of frame {} overflow against its size at end-diastole",
                    source.pose.frame
                ),
            });
        }
    }
    // Reasons come from two steps; readers see them in the order of the study.
    left_out.sort_by_key(|left| left.subject);
}

/// The matrix of poses of which every pair is known.
fn assembled(poses: &[PoseId], rows: &KnownRows<'_>) -> DistanceMatrix {
    DistanceMatrix::of_pairs(poses.len(), |i, j| rows.distance(i, j).unwrap_or(0.0))
        .unwrap_or_else(DistanceMatrix::empty)
}

/// Every pair that is needed once, band by band and block by block; numbers are placed by their pair, whoever did it.
fn all_pairs(
    metric: &Metric,
    bands: &Bands<'_>,
    known: &KnownRows<'_>,
    needed: impl Fn(usize, usize) -> bool + Sync,
    progress: &Progress,
) -> Result<(DistanceMatrix, usize), Stopped> {
    let (count, length) = (bands.sources().len(), bands.length());
    let computed = AtomicUsize::new(0);
    let mut upper = vec![0.0; count * count.saturating_sub(1) / 2];
    for row in 0..count.div_ceil(length) {
        let ours = bands.band(row, progress)?;
        for column in row..count.div_ceil(length) {
            let theirs = match row == column {
                true => Arc::clone(&ours),
                false => bands.band(column, progress)?,
            };
            // Blocks on and right of the diagonal: the matrix is symmetric.
            let blocks = |band: usize| {
                let end = ((band + 1) * length).min(count);
                (band * length / BLOCK)..end.div_ceil(BLOCK)
            };
            let tasks: Vec<[usize; 2]> = blocks(row)
                .flat_map(|row| blocks(column).map(move |column| [row, column]))
                .filter(|[row, column]| row <= column)
                .collect();
            let pair =
                |(i, j): (usize, usize), scratch: &mut PairScratch| -> Result<f64, Stopped> {
                    progress.step()?;
                    if !needed(i, j) {
                        return Ok(0.0);
                    }
                    if let Some(distance) = known.distance(i, j) {
                        return Ok(distance);
                    }
                    // Only a count; nothing is ordered by it.
                    computed.fetch_add(1, Ordering::Relaxed);
                    let (a, b) = (&ours[i - row * length], &theirs[j - column * length]);
                    Ok(aligned_distance(metric, a, b, scratch))
                };
            let done: Vec<Vec<f64>> = in_waves(&tasks, WAVE, |wave| {
                (wave.par_iter())
                    .map_init(PairScratch::default, |scratch, &task| {
                        let pairs = block_pairs(task, count);
                        pairs.map(|ij| pair(ij, scratch)).collect()
                    })
                    .collect()
            })?;
            for (task, values) in tasks.into_iter().zip(done) {
                for ((i, j), value) in block_pairs(task, count).zip(values) {
                    upper[i * count - i * (i + 1) / 2 + j - i - 1] = value;
                }
            }
        }
    }
    let matrix = DistanceMatrix::from_upper(count, upper).unwrap_or_else(DistanceMatrix::empty);
    Ok((matrix, computed.into_inner()))
}

/// Pairs i < j with i in one block of rows and j in one of columns.
fn block_pairs([row, column]: [usize; 2], count: usize) -> impl Iterator<Item = (usize, usize)> {
    let of = move |block: usize| block * BLOCK..((block + 1) * BLOCK).min(count);
    of(row).flat_map(move |i| of(column).filter(move |&j| i < j).map(move |j| (i, j)))
}

fn aligned_distance(
    metric: &Metric,
    a: &PreparedPose,
    b: &PreparedPose,
    scratch: &mut PairScratch,
) -> f64 {
    // Closed form: no search, so that the rotation has the same bits on every thread.
    let covariance = cross_covariance(b.axes(), b.centroid(), a.axes(), a.centroid());
    let (rotation, _) = rotation_from_covariance(&covariance);
    let translation = a.centroid() - rotation * b.centroid();
    metric
        .pair_moved(a, b, &rotation, &translation, scratch)
        .distance()
}

#[cfg(test)]
mod known_tests;
#[cfg(test)]
mod tests;
