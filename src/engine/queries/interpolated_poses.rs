//! Interpolated poses between the frames of a beat, interval by interval, beginning with the one on screen.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::analysis::geodesics::{GeodesicParams, GeodesicPath, geodesic};
use crate::engine::queries::pose_distances::metric_words;
use crate::engine::queries::subject::subject_of;
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::study::{MeshSequence, Study};

/// The interval of the beat that somebody looks at. It changes the order in which intervals are computed and no
/// answer, so that all are equal; work under way turns to it after the interval that it is at.
#[derive(Clone, Debug, Default)]
pub struct LookedAt(Arc<AtomicUsize>);

impl LookedAt {
    /// Says which interval is looked at.
    pub fn set(&self, interval: usize) {
        self.0.store(interval, Ordering::Relaxed);
    }

    fn get(&self) -> usize {
        self.0.load(Ordering::Relaxed)
    }
}

impl PartialEq for LookedAt {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// Poses within every interval between frames of a beat: one path per interval.
#[derive(Clone, Debug, PartialEq)]
pub struct InterpolatedPosesQuery {
    /// Whose beat.
    pub subject: usize,
    /// What the path minimises, and how many poses.
    pub params: GeodesicParams,
    /// The interval that is computed first.
    pub looked_at: LookedAt,
}

/// Poses within one interval; those of a whole beat are made of these.
#[derive(Clone, Debug, PartialEq)]
pub struct IntervalQuery {
    /// Whose beat.
    pub subject: usize,
    /// From this frame to the next, from the last to the first.
    pub interval: usize,
    /// What the path minimises, and how many poses.
    pub params: GeodesicParams,
}

/// A question names an interval that the motion does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no interval {interval} in a sequence of {frames} frames")]
struct NoInterval {
    interval: usize,
    frames: usize,
}

impl Query for InterpolatedPosesQuery {
    type Answer = Vec<Arc<GeodesicPath>>;
    const TITLE: &'static str = "Interpolated poses";
    const FAILURE: Option<&'static str> = Some("The interpolated poses could not be computed");

    fn parameters(&self) -> String {
        words(&self.params)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::shapes(study, [self.subject])
    }

    fn run(&self, cx: &Context<'_>) -> Result<Self::Answer, Interrupted> {
        let count = interval_count(&subject_of(cx.study(), self.subject)?.sequence);
        let mut paths: Vec<Option<Arc<GeodesicPath>>> = vec![None; count];
        for done in 0..count {
            let looked_at = self.looked_at.get();
            let next = (0..count)
                .map(|ahead| (looked_at + ahead) % count)
                .find(|&interval| paths[interval].is_none());
            let Some(interval) = next else { break };
            let [from, to] = [done, done + 1].map(|done| done as f32 / count as f32);
            let part = cx.part("interpolating poses", from, to);
            paths[interval] = Some(part.get(&IntervalQuery {
                subject: self.subject,
                interval,
                params: self.params,
            })?);
        }
        Ok(paths.into_iter().flatten().collect())
    }

    fn memory(paths: &Self::Answer, memory: &mut Memory) {
        for path in paths {
            memory.shared(path, path_bytes(path));
        }
    }

    fn subjects(&mut self) -> Vec<&mut usize> {
        vec![&mut self.subject]
    }

    fn replaces(&self, other: &Self) -> bool {
        self.subject == other.subject
    }
}

impl Query for IntervalQuery {
    type Answer = GeodesicPath;
    const TITLE: &'static str = "Interpolated poses of an interval";

    fn parameters(&self) -> String {
        words(&self.params)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::shapes(study, [self.subject])
    }

    fn run(&self, cx: &Context<'_>) -> Result<GeodesicPath, Interrupted> {
        let progress = cx.progress();
        progress.begin_phase("interpolating poses", 0.0, 1.0);
        let path = self.path(cx)?;
        // The best path so far is not the answer.
        if path.stopped {
            return Err(Interrupted::Stopped);
        }
        Ok(path)
    }

    fn memory(path: &GeodesicPath, memory: &mut Memory) {
        memory.own(path_bytes(path));
    }

    fn subjects(&mut self) -> Vec<&mut usize> {
        vec![&mut self.subject]
    }

    fn replaces(&self, other: &Self) -> bool {
        (self.subject, self.interval) == (other.subject, other.interval)
    }
}

impl IntervalQuery {
    fn path(&self, cx: &Context<'_>) -> Result<GeodesicPath, Interrupted> {
        let params = self.params.check()?;
        let sequence = &subject_of(cx.study(), self.subject)?.sequence;
        let frames = sequence.frame_count();
        let next = (self.interval + 1) % frames;
        let ends = (sequence.pose(self.interval)).zip(sequence.pose(next));
        let Some((start, end)) = ends.filter(|_| self.interval < interval_count(sequence)) else {
            let interval = self.interval;
            return Err(NoInterval { interval, frames }.into());
        };
        let faces = sequence.joined_faces();
        Ok(geodesic(&faces, &start, &end, &params, cx.progress())?)
    }
}

/// Intervals between frames; the last frame of more than two runs into the first.
fn interval_count(sequence: &MeshSequence) -> usize {
    match sequence.frame_count() {
        0 | 1 => 0,
        2 => 1,
        frames => frames,
    }
}

fn words(params: &GeodesicParams) -> String {
    let metric = metric_words(&params.metric);
    format!("{} per interval, {metric}", params.interpolated_poses)
}

/// Memory that a path holds.
fn path_bytes(path: &GeodesicPath) -> usize {
    path.poses.iter().map(|pose| size_of_val(&**pose)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::{SurfaceKind, SurfaceSequence};

    #[test]
    fn one_frame_has_no_interval_two_have_one_and_more_close_the_cycle() {
        for (frames, intervals) in [(1, 0), (2, 1), (3, 3), (4, 4)] {
            let frames = vec![phantom::sphere(1, 1.0); frames];
            let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
            let sequence = MeshSequence::new(vec![surface]).unwrap();
            assert_eq!(interval_count(&sequence), intervals);
        }
    }
}
