//! All pairs of poses, in parallel, with the same bits for any number of threads.

use rayon::prelude::*;

use crate::analysis::alignment::{
    LeftOut, SizeScale, comparable_subjects, cross_covariance, rotation_from_covariance,
};
use crate::analysis::metrics::{Metric, PairScratch, PreparedPose};
use crate::mesh::Point3;
use crate::progress::{Progress, Stopped};
use crate::study::{Study, Subject};

use super::{CheckedPoseDistanceParams, DistanceMatrix, PoseDistances, PoseId};

/// Rows and columns of a block of pairs that one thread does in one go: its 16 poses of some
/// 0.4 MB fit into the cache that cores share, and each is used eight times while it is there.
const BLOCK: usize = 8;

/// One-step distances of all poses of the largest group of corresponding subjects.
///
/// 1. **Size.** Coordinates are divided by one scale per sequence ([`SizeScale`]): the largest box
///    side at end-diastole, as stated by the subject, else frame 0.
/// 2. **Alignment.** Each pair is aligned by itself: the rigid motion that lays the second pose onto
///    the first, of least squares over vertices. So a distance depends on its two poses alone: moving
///    an input, or adding a subject, changes no other number, and `metric --align rigid` gives the same
///    one. Aligning all poses to a mean would be cheaper by little, and would make every
///    distance depend on the whole cohort and not be the least of the pair.
/// 3. **Metric.** √((⟨⟨X, X⟩⟩ at A + ⟨⟨X, X⟩⟩ at B) / 2), X = B − A.
///
/// Which subjects take part is said by [`comparable_subjects`].
///
/// # Errors
/// If stopped; the flag is heard once per pose and per pair.
pub fn pose_distances(
    study: &Study,
    params: &CheckedPoseDistanceParams,
    progress: &Progress,
) -> Result<PoseDistances, Stopped> {
    let (comparable, mut left_out) = comparable_subjects(study);
    let mut sources = Vec::new();
    for member in comparable {
        let frames = 0..member.subject.sequence.frame_count();
        sources.extend(frames.map(|frame| Source {
            pose: PoseId {
                subject: member.index,
                frame,
            },
            subject: member.subject,
            scale: member.scale,
        }));
    }
    let metric = sources.first().map(|source| {
        let faces = source.subject.sequence.joined_faces();
        Metric::new(&faces, params.metric)
    });
    let pairs = sources.len() * sources.len().saturating_sub(1) / 2;
    progress.expect_steps(sources.len() + pairs);
    let prepared = match &metric {
        Some(metric) => prepare(metric, &sources, progress)?,
        None => Vec::new(),
    };
    leave_out_unprepared(&sources, &prepared, &mut left_out);
    let (poses, prepared): (Vec<PoseId>, Vec<PreparedPose>) = (sources.iter().zip(prepared))
        .filter(|(source, _)| {
            left_out
                .iter()
                .all(|left| left.subject != source.pose.subject)
        })
        .filter_map(|(source, prepared)| Some((source.pose, prepared?)))
        .unzip();
    let distances = match &metric {
        Some(metric) => all_pairs(metric, &prepared, progress)?,
        None => DistanceMatrix::empty(),
    };
    Ok(PoseDistances {
        poses,
        distances,
        left_out,
    })
}

/// A pose before anything is computed of it.
struct Source<'a> {
    pose: PoseId,
    subject: &'a Subject,
    scale: SizeScale,
}

/// One entry per source: `None` where lengths overflow.
fn prepare(
    metric: &Metric,
    sources: &[Source<'_>],
    progress: &Progress,
) -> Result<Vec<Option<PreparedPose>>, Stopped> {
    sources
        .par_iter()
        .map(|source| {
            progress.step()?;
            let points = source.subject.sequence.pose(source.pose.frame);
            let normalised: Vec<Point3> = (points.unwrap_or_default().iter())
                .map(|point| source.scale.normalised(point))
                .collect();
            Ok(metric.prepare(&normalised).ok())
        })
        .collect()
}

fn leave_out_unprepared(
    sources: &[Source<'_>],
    prepared: &[Option<PreparedPose>],
    left_out: &mut Vec<LeftOut>,
) {
    for (source, prepared) in sources.iter().zip(prepared) {
        let subject = source.pose.subject;
        if prepared.is_none() && left_out.iter().all(|left| left.subject != subject) {
            left_out.push(LeftOut {
                subject,
                reason: format!(
                    "lengths of frame {} overflow against its size at end-diastole",
                    source.pose.frame
                ),
            });
        }
    }
    left_out.sort_by_key(|left| left.subject);
}

/// Every pair once, block by block; blocks are placed by number, whoever did them.
fn all_pairs(
    metric: &Metric,
    poses: &[PreparedPose],
    progress: &Progress,
) -> Result<DistanceMatrix, Stopped> {
    let count = poses.len();
    let blocks = count.div_ceil(BLOCK);
    let tasks: Vec<[usize; 2]> = (0..blocks)
        .flat_map(|row| (row..blocks).map(move |column| [row, column]))
        .collect();
    let done: Vec<Vec<f64>> = tasks
        .par_iter()
        .map_init(PairScratch::default, |scratch, &task| {
            block_pairs(task, count)
                .map(|(i, j)| {
                    progress.step()?;
                    Ok(aligned_distance(metric, &poses[i], &poses[j], scratch))
                })
                .collect()
        })
        .collect::<Result<_, Stopped>>()?;
    let mut upper = vec![0.0; count * count.saturating_sub(1) / 2];
    for (task, values) in tasks.into_iter().zip(done) {
        for ((i, j), value) in block_pairs(task, count).zip(values) {
            upper[i * count - i * (i + 1) / 2 + j - i - 1] = value;
        }
    }
    Ok(DistanceMatrix::from_upper(count, upper).unwrap_or_else(DistanceMatrix::empty))
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
    let covariance = cross_covariance(b.axes(), b.centroid(), a.axes(), a.centroid());
    let (rotation, _) = rotation_from_covariance(&covariance);
    let translation = a.centroid() - rotation * b.centroid();
    metric
        .pair_moved(a, b, &rotation, &translation, scratch)
        .distance()
}

#[cfg(test)]
mod tests;
