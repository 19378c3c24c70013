//! What the distances within a beat are made of.

use rayon::prelude::*;

use crate::analysis::alignment::{Comparable, comparable_subjects, rigid_motion};
use crate::analysis::metrics::{EnergyShares, Metric, PairScratch};
use crate::mesh::Point3;
use crate::numeric::lower_median;
use crate::progress::{Progress, Stopped};
use crate::study::Study;

use super::CheckedPoseDistanceParams;
use super::smooth::smoothed_study;

/// Shares of the energy of distances within a beat: medians over the beats of a study, each share by itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BeatShares {
    /// Beats whose poses differ.
    pub beats: usize,
    /// From end-diastole to end-systole.
    pub phases: Option<EnergyShares>,
    /// From each frame to the next, summed over the beat.
    pub steps: Option<EnergyShares>,
}

/// Shares of every usable beat; poses are smoothed, sizes normalised and each pair is aligned as in
/// [`super::pose_distances`] without a transport. End-systole is the frame that the subject states, else that which lies
/// farthest from end-diastole.
///
/// # Errors
/// If stopped.
pub fn beat_shares(
    study: &Study,
    params: &CheckedPoseDistanceParams,
    progress: &Progress,
) -> Result<BeatShares, Stopped> {
    let smooth = smoothed_study(study, params.smoothing, progress)?;
    let (members, _) = comparable_subjects(&smooth);
    let Some(first) = members.first() else {
        return Ok(BeatShares::default());
    };
    let metric = Metric::new(&first.subject.sequence.joined_faces(), params.metric);
    let beats = (members.par_iter())
        .map(|member| {
            progress.check()?;
            Ok(of_beat(&metric, member))
        })
        .collect::<Result<Vec<_>, Stopped>>()?;
    let [phases, steps] = [0, 1].map(|which| {
        let found = beats.iter().filter_map(|beat| beat[which]);
        found.collect::<Vec<EnergyShares>>()
    });
    Ok(BeatShares {
        beats: steps.len(),
        phases: medians(&phases),
        steps: medians(&steps),
    })
}

/// From end-diastole to end-systole, and from frame to frame; `None` where nothing moves or a pose has no distances.
fn of_beat(metric: &Metric, member: &Comparable<'_>) -> [Option<EnergyShares>; 2] {
    let frames = member.subject.sequence.frame_count();
    let pose = |frame: usize| -> Vec<Point3> {
        let pose = member.subject.sequence.pose(frame).unwrap_or_default();
        pose.iter().map(|p| member.scale.normalised(p)).collect()
    };
    let scratch = &mut PairScratch::default();
    let mut between = |a: &[Point3], b: &[Point3]| pair(metric, a, b, scratch);
    let rest = pose(member.end_diastole);
    let phases = match member.subject.end_systole.filter(|&frame| frame < frames) {
        Some(frame) => between(&rest, &pose(frame)),
        None => {
            let all = (0..frames).filter_map(|frame| between(&rest, &pose(frame)));
            all.max_by(|a, b| a.0.total_cmp(&b.0))
        }
    };
    let mut sums = [0.0; 4];
    let mut before = pose(0);
    for frame in 1..=frames {
        // Frames of a beat go round: the last one is followed by the first.
        let here = pose(frame % frames);
        if let Some((energy, shares)) = between(&before, &here) {
            let EnergyShares {
                own,
                curvature,
                displacement,
            } = shares;
            for (sum, share) in sums.iter_mut().zip([1.0, own, curvature, displacement]) {
                *sum += energy * share;
            }
        }
        before = here;
    }
    let [energy, own, curvature, displacement] = sums;
    let steps = (energy > 0.0).then(|| EnergyShares {
        own: own / energy,
        curvature: curvature / energy,
        displacement: displacement / energy,
    });
    [phases.map(|(_, shares)| shares), steps]
}

/// Energy of a pair that is aligned first, and its shares.
fn pair(
    metric: &Metric,
    a: &[Point3],
    b: &[Point3],
    scratch: &mut PairScratch,
) -> Option<(f64, EnergyShares)> {
    let motion = rigid_motion(b, a).ok()?;
    let moved: Vec<Point3> = b.iter().map(|point| motion.apply(point)).collect();
    let (a, b) = (metric.prepare(a).ok()?, metric.prepare(&moved).ok()?);
    let energy = metric.pair(&a, &b, scratch).energy();
    // An energy of round-off has no parts worth telling.
    Some((energy, metric.shares(&a, &b, scratch)?)).filter(|_| energy > ROUND_OFF)
}

/// Squared distances below this, of poses of size 1, are round-off of an alignment.
const ROUND_OFF: f64 = 1e-20;

fn medians(beats: &[EnergyShares]) -> Option<EnergyShares> {
    let median = |share: fn(&EnergyShares) -> f64| lower_median(beats.iter().map(share).collect());
    (!beats.is_empty()).then(|| EnergyShares {
        own: median(|shares| shares.own),
        curvature: median(|shares| shares.curvature),
        displacement: median(|shares| shares.displacement),
    })
}
