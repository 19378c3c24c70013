//! Thickness of one wall at one frame in all ways of measuring it, beside each other.

use std::time::Instant;

use crate::analysis::medial::{MedialBeat, MedialParams, medial_beat};
use crate::analysis::thickness_methods::{
    Agreement, CheckedThicknessParams, ThicknessError, ThicknessMethod, ThicknessParams,
    ThicknessSpread, thickness,
};
use crate::engine::cache::Cache;
use crate::engine::request::{AnalysisError, AnalysisRequest};
use crate::engine::run::run;
use crate::engine::run_pairs::subject_of;
use crate::progress::{Progress, Stopped};
use crate::study::{MeshSequence, Study, Subject, SurfaceSequence};

/// Share of the work that balls take; field lines take most of the rest.
const MEDIAL_SHARE: f32 = 0.2;

/// Settings of the ways of measuring.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThicknessSettings {
    /// How balls are laid into the wall.
    pub medial: MedialParams,
    /// Slices, chords and voxels of the other ways.
    pub methods: ThicknessParams,
}

/// A way of telling how thick the wall is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ThicknessWay {
    /// Twice the radius of the medial atoms that take part: what the others are compared with.
    Medial,
    /// Any of the others.
    Other(ThicknessMethod),
}

impl ThicknessWay {
    /// The words for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Medial => "medial balls",
            Self::Other(method) => method.name(),
        }
    }
}

/// What one way says of the wall at a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct WayAnswer {
    /// Which way.
    pub way: ThicknessWay,
    /// Its thicknesses in coordinates, or why it says nothing.
    pub found: Result<ThicknessSpread, String>,
    /// How it differs from twice the medial radius at the same vertices; `None` for that itself, and
    /// where either says nothing.
    pub agreement: Option<Agreement>,
    /// Seconds that it took for this frame; they differ from run to run.
    pub seconds: f64,
}

/// What all ways say of the wall at a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameThickness {
    /// The frame.
    pub frame: usize,
    /// The medial radius first.
    pub answers: Vec<WayAnswer>,
}

/// Thickness of a heart at a frame in every way.
pub(super) fn frame_thickness(
    study: &Study,
    index: usize,
    frame: usize,
    settings: &ThicknessSettings,
    cache: &Cache,
    progress: &Progress,
) -> Result<FrameThickness, AnalysisError> {
    let params = (settings.methods.check()).map_err(AnalysisError::unanswerable)?;
    let subject = subject_of(study, index)?;
    let frames = subject.sequence.frame_count();
    if frame >= frames {
        let error = ThicknessError::NoFrame { frame, frames };
        return Err(AnalysisError::unanswerable(error));
    }
    let part = progress.part("laying balls into the wall", 0.0, MEDIAL_SHARE);
    let medial = medial(study, index, frame, &settings.medial, cache, &part)?;
    let mut answers = vec![WayAnswer {
        way: ThicknessWay::Medial,
        found: medial.told.clone(),
        agreement: None,
        seconds: medial.seconds,
    }];
    let count = ThicknessMethod::ALL.len();
    for (place, method) in ThicknessMethod::ALL.into_iter().enumerate() {
        let share = |done: usize| MEDIAL_SHARE + (1.0 - MEDIAL_SHARE) * done as f32 / count as f32;
        let part = progress.part(method.name(), share(place), share(place + 1));
        answers.push(other(subject, frame, method, &params, &medial, &part)?);
    }
    Ok(FrameThickness { frame, answers })
}

/// Twice the medial radii at a frame.
struct Medial {
    /// Vertex of the inner side and thickness there, of each atom that takes part.
    twice_radius: Vec<(u32, f64)>,
    told: Result<ThicknessSpread, String>,
    seconds: f64,
}

fn medial(
    study: &Study,
    index: usize,
    frame: usize,
    params: &MedialParams,
    cache: &Cache,
    progress: &Progress,
) -> Result<Medial, AnalysisError> {
    let request = AnalysisRequest::MedialBeat {
        subject: index,
        params: *params,
    };
    let nothing = |reason: String| Medial {
        twice_radius: Vec::new(),
        told: Err(reason),
        seconds: 0.0,
    };
    let outcome = match run(study, &request, cache, progress) {
        Ok(outcome) => outcome,
        Err(AnalysisError::Stopped(stopped)) => return Err(stopped.into()),
        Err(AnalysisError::Unanswerable(reason)) => return Ok(nothing(reason)),
    };
    let beat = outcome
        .medial_beat()
        .ok_or(AnalysisError::Stopped(Stopped))?;
    let twice_radius = twice_radii(beat, frame);
    let spread = ThicknessSpread::of(twice_radius.iter().map(|&(_, thickness)| Some(thickness)));
    let told = spread.ok_or_else(|| "no atom takes part in the analysis".to_owned());
    Ok(Medial {
        told,
        seconds: seconds_of_one(subject_of(study, index)?, frame, params, progress)?,
        twice_radius,
    })
}

/// Vertex and thickness of the atoms that take part.
fn twice_radii(beat: &MedialBeat, frame: usize) -> Vec<(u32, f64)> {
    let Some(surface) = beat.frames.get(frame) else {
        return Vec::new();
    };
    let atoms = surface.atoms.iter().zip(&beat.vertices).zip(&beat.regular);
    atoms
        .filter(|(_, regular)| **regular)
        .map(|((atom, &vertex), _)| (vertex, 2.0 * atom.radius))
        .collect()
}

/// How long the balls of one frame take, whether or not those of the beat were at hand.
fn seconds_of_one(
    subject: &Subject,
    frame: usize,
    params: &MedialParams,
    progress: &Progress,
) -> Result<f64, AnalysisError> {
    let params = params.check().map_err(AnalysisError::unanswerable)?;
    let surfaces = subject.sequence.surfaces().iter();
    let at_frame = surfaces.map(|surface| {
        SurfaceSequence::new(surface.kind(), surface.frames()[frame..=frame].to_vec())
    });
    let at_frame = at_frame
        .collect::<Result<_, _>>()
        .and_then(MeshSequence::new);
    let mut alone = subject.clone();
    alone.sequence = at_frame.map_err(AnalysisError::unanswerable)?;
    let begin = Instant::now();
    // What it says is known; only the time is new.
    medial_beat(&alone, &params, &progress.within()).ok();
    progress.check()?;
    Ok(begin.elapsed().as_secs_f64())
}

fn other(
    subject: &Subject,
    frame: usize,
    method: ThicknessMethod,
    params: &CheckedThicknessParams,
    medial: &Medial,
    progress: &Progress,
) -> Result<WayAnswer, Stopped> {
    let begin = Instant::now();
    let map = thickness(subject, frame, method, params, progress);
    let seconds = begin.elapsed().as_secs_f64();
    let way = ThicknessWay::Other(method);
    let map = match map {
        Ok(map) => map,
        Err(ThicknessError::Stopped(stopped)) => return Err(stopped),
        Err(reason) => {
            return Ok(WayAnswer {
                way,
                found: Err(reason.to_string()),
                agreement: None,
                seconds,
            });
        }
    };
    let at_atoms = (medial.twice_radius.iter())
        .map(|&(vertex, _)| map.thickness.get(vertex as usize).copied().flatten());
    let reference = medial.twice_radius.iter().map(|&(_, told)| Some(told));
    let spread = ThicknessSpread::of(map.thickness.iter().copied());
    Ok(WayAnswer {
        way,
        agreement: Agreement::of(at_atoms, reference),
        found: spread.ok_or_else(|| "it tells the thickness of no vertex".to_owned()),
        seconds,
    })
}

#[cfg(test)]
mod tests;
