//! What is asked and answered about the wall of one heart: atoms over the beat, thickening, patches.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::analysis::measures::{SubjectMeasures, measure_subject};
use crate::analysis::medial::{MedialBeat, MedialError, MedialParams, medial_beat};
use crate::analysis::segments::{LongAxis, Polar, Segment, long_axis, polar, segment};
use crate::analysis::thickening::{
    Thickening, ThickeningError, ThickeningParams, phases, thickening,
};
use crate::analysis::verdicts::{NotAssessed, VerdictInput, VerdictParams, examine};
use crate::engine::cache::Cache;
use crate::engine::request::{AnalysisError, AnalysisRequest};
use crate::engine::run::run;
use crate::engine::run_pairs::subject_of;
use crate::mesh::Point3;
use crate::progress::{Progress, Stopped};
use crate::study::Study;

/// Share of the time of a heart's thickening that its atoms take.
const ATOMS_SHARE: f32 = 0.8;

/// Settings of the search for patches, from the surfaces on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ThickeningSettings {
    /// How balls are laid into the wall.
    pub medial: MedialParams,
    /// What counts as still, and as a patch.
    pub thickening: ThickeningParams,
}

/// What window, tables and figures read of one heart.
#[derive(Clone, Debug, PartialEq)]
pub struct SubjectThickening {
    /// Its atoms at every frame.
    pub beat: Arc<MedialBeat>,
    /// How they thicken, and where they do not.
    pub thickening: Thickening,
    /// Why its wall carries no verdict, where it is not resolved: what is found in it may be blur or noise.
    pub not_assessed: Option<NotAssessed>,
    /// The long axis at end-diastole.
    pub axis: Option<LongAxis>,
    /// Why there is no axis, where there is none.
    pub without_axis: Option<String>,
    /// Per atom, in which segment it lies at end-diastole; all `None` where septum and anterior wall are not known.
    pub segments: Vec<Option<Segment>>,
    /// Per atom, its place on the bull's-eye at end-diastole; all `None` without an axis.
    pub polar: Vec<Option<Polar>>,
}

impl SubjectThickening {
    /// Memory that it holds without its atoms, which other answers share.
    pub(super) fn own_bytes(&self) -> usize {
        let found = &self.thickening;
        let steps: usize = (found.steps.iter())
            .map(|step| size_of_val(step) + size_of_val(&*step.pt) + size_of_val(&*step.still))
            .sum();
        let patches: usize = (found.patches.iter())
            .map(|patch| {
                size_of_val(patch) + size_of_val(&*patch.atoms) + size_of_val(&*patch.path)
            })
            .sum();
        let atoms = size_of_val(&*found.ed_to_es) + size_of_val(&*found.thickening);
        steps + patches + atoms + size_of_val(&*self.segments) + size_of_val(&*self.polar)
    }
}

/// Memory that atoms over a beat hold.
pub(super) fn beat_bytes(beat: &MedialBeat) -> usize {
    let frames: usize = (beat.frames.iter())
        .map(|frame| {
            size_of_val(&*frame.atoms) + size_of_val(&*frame.normals) + size_of_val(&*frame.end)
        })
        .sum();
    frames + size_of_val(&*beat.vertices) + size_of_val(&*beat.regular)
}

/// The atoms of a heart over its beat.
pub(super) fn atoms(
    study: &Study,
    subject: usize,
    params: &MedialParams,
    progress: &Progress,
) -> Result<MedialBeat, AnalysisError> {
    let params = params.check().map_err(AnalysisError::unanswerable)?;
    let subject = subject_of(study, subject)?;
    progress.begin_phase("laying balls into the wall", 0.0, 1.0);
    medial_beat(subject, &params, progress).map_err(|error| match error {
        MedialError::Stopped(stopped) => AnalysisError::Stopped(stopped),
        other => AnalysisError::unanswerable(other),
    })
}

/// Thickening of a heart, with its atoms as a request of their own: other settings of thickening find
/// them in the cache.
pub(super) fn subject_thickening(
    study: &Study,
    index: usize,
    settings: &ThickeningSettings,
    cache: &Cache,
    progress: &Progress,
) -> Result<SubjectThickening, AnalysisError> {
    let params = (settings.thickening.check()).map_err(AnalysisError::unanswerable)?;
    let subject = subject_of(study, index)?;
    let request = AnalysisRequest::MedialBeat {
        subject: index,
        params: settings.medial,
    };
    let known = cache.get(study, &request).is_some();
    let share = if known { 0.0 } else { ATOMS_SHARE };
    let part = progress.part("laying balls into the wall", 0.0, share);
    let outcome = run(study, &request, cache, &part)?;
    let beat = outcome
        .medial_beat()
        .ok_or(AnalysisError::Stopped(Stopped))?;
    let part = progress.part("comparing thickness", share, 1.0);
    let measures = measures_of(study, index, cache)?;
    let end_diastole = phases(beat, &measures)[0];
    let (axis, without_axis) = match long_axis(subject, end_diastole) {
        Ok(axis) => (Some(axis), None),
        Err(error) => (None, Some(error.to_string())),
    };
    let found =
        thickening(beat, &measures, axis.as_ref(), &params, &part).map_err(
            |error| match error {
                ThickeningError::Stopped(stopped) => AnalysisError::Stopped(stopped),
                other => AnalysisError::unanswerable(other),
            },
        )?;
    let centres: Vec<Point3> = (beat.frames[end_diastole].atoms.iter())
        .map(|atom| atom.position)
        .collect();
    let verdicts = (VerdictParams::default().check()).map_err(AnalysisError::unanswerable)?;
    let heart = VerdictInput {
        beat,
        thickening: &found,
    };
    Ok(SubjectThickening {
        beat: Arc::clone(beat),
        not_assessed: examine(&heart, &verdicts).err(),
        thickening: found,
        segments: (centres.iter())
            .map(|&point| segment(axis.as_ref()?, point))
            .collect(),
        polar: (centres.iter())
            .map(|&point| Some(polar(axis.as_ref()?, point)))
            .collect(),
        axis,
        without_axis,
    })
}

/// The measures of one heart: of the whole study where they are at hand, otherwise of it alone.
fn measures_of(
    study: &Study,
    index: usize,
    cache: &Cache,
) -> Result<SubjectMeasures, AnalysisError> {
    let known = cache.get(study, &AnalysisRequest::Measures);
    let known = known.and_then(|outcome| outcome.measures()?.get(index).cloned());
    match known {
        Some(measures) => Ok(measures),
        None => Ok(measure_subject(subject_of(study, index)?)),
    }
}

#[cfg(test)]
mod tests;
