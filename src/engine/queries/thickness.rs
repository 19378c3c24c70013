//! Thickness of one wall at one frame by all methods, beside each other.

use std::sync::Arc;
use std::time::Instant;

use crate::analysis::medial::{MedialBeat, MedialParams, medial_beat};
use crate::analysis::thickness_methods::{
    Agreement, CheckedThicknessParams, ThicknessError, ThicknessMethod, ThicknessParams,
    ThicknessSpread, thickness,
};
use crate::engine::queries::medial_surfaces::MedialSurfacesQuery;
use crate::engine::queries::subject::subject_of;
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::progress::{Progress, Stopped};
use crate::report::medial_words;
use crate::study::{MeshSequence, Study, Subject, SurfaceSequence};

/// Share of the work that medial spheres take; field lines take most of the rest.
const MEDIAL_SHARE: f32 = 0.2;

/// Settings of the methods.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThicknessSettings {
    /// How medial spheres are fitted.
    pub medial: MedialParams,
    /// Slices, chords and voxels of the other methods.
    pub methods: ThicknessParams,
}

/// A method of measuring wall thickness: medial spheres, or one that is compared with them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ComparedMethod {
    /// Twice the radius of the medial atoms that take part: the reference.
    Medial,
    /// Another method, compared with the reference.
    Other(ThicknessMethod),
}

impl ComparedMethod {
    /// Its name in the pane.
    pub fn name(self) -> &'static str {
        match self {
            Self::Medial => "medial spheres",
            Self::Other(method) => method.name(),
        }
    }
}

/// Wall thickness at a frame by one method.
#[derive(Clone, Debug, PartialEq)]
pub struct MethodResult {
    /// The method that measured it.
    pub method: ComparedMethod,
    /// Distribution of the thicknesses, in coordinates, or why there are none.
    pub thickness: Result<ThicknessSpread, String>,
    /// How it differs from twice the medial radius at the same vertices; `None` for that itself, and
    /// where either has no value.
    pub agreement: Option<Agreement>,
    /// Seconds that it took for this frame; they differ from run to run.
    pub seconds: f64,
}

/// Wall thickness at a frame by all methods.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameThickness {
    /// Index of the frame.
    pub frame: usize,
    /// The medial radius first.
    pub results: Vec<MethodResult>,
}

/// Thickness of one subject's wall at a frame by all methods.
#[derive(Clone, Copy, Debug)]
pub struct PoseThicknessQuery {
    /// Whose wall.
    pub subject: usize,
    /// At which frame.
    pub frame: usize,
    /// How it is measured.
    pub settings: ThicknessSettings,
    /// Frames that are measured before this one, the last of them first: two at a time would disturb each other's times,
    /// which are shown.
    pub after: [Option<usize>; 2],
}

/// In which order frames are measured is no part of the question.
impl PartialEq for PoseThicknessQuery {
    fn eq(&self, other: &Self) -> bool {
        (self.subject, self.frame, self.settings) == (other.subject, other.frame, other.settings)
    }
}

impl Query for PoseThicknessQuery {
    type Answer = FrameThickness;
    const TITLE: &'static str = "Thickness methods";

    fn parameters(&self) -> String {
        let ThicknessParams {
            slices,
            chords,
            voxels_across,
        } = self.settings.methods;
        format!(
            "frame {}, {}, {slices} slices of {chords} chords, {voxels_across} voxels across the wall",
            self.frame,
            medial_words(&self.settings.medial)
        )
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::geometry(study, [self.subject])
    }

    fn run(&self, cx: &Context<'_>) -> Result<FrameThickness, Interrupted> {
        self.wait_for_others(cx)?;
        let params = self.settings.methods.check()?;
        let subject = subject_of(cx.study(), self.subject)?;
        let (frame, frames) = (self.frame, subject.sequence.frame_count());
        if frame >= frames {
            return Err(ThicknessError::NoFrame { frame, frames }.into());
        }
        let part = cx.part("fitting medial spheres", 0.0, MEDIAL_SHARE);
        let medial = self.medial(subject, &part)?;
        let mut results = vec![MethodResult {
            method: ComparedMethod::Medial,
            thickness: medial.spread.clone(),
            agreement: None,
            seconds: medial.seconds,
        }];
        let count = ThicknessMethod::ALL.len();
        for (place, method) in ThicknessMethod::ALL.into_iter().enumerate() {
            let share =
                |done: usize| MEDIAL_SHARE + (1.0 - MEDIAL_SHARE) * done as f32 / count as f32;
            let part = cx.part(method.name(), share(place), share(place + 1));
            results.push(other(
                subject,
                frame,
                method,
                &params,
                &medial,
                part.progress(),
            )?);
        }
        Ok(FrameThickness { frame, results })
    }

    fn memory(thickness: &FrameThickness, memory: &mut Memory) {
        memory.own(size_of_val(&*thickness.results));
    }

    fn subjects(&mut self) -> Vec<&mut usize> {
        vec![&mut self.subject]
    }

    fn replaces(&self, other: &Self) -> bool {
        (self.subject, self.frame) == (other.subject, other.frame)
    }

    /// Stepping through the frames stops nothing.
    fn lets_finish(&self, begun: &Self) -> bool {
        (self.subject, self.settings) == (begun.subject, begun.settings)
    }
}

/// Twice the medial radii at a frame.
struct Medial {
    /// Vertex of the inner side and thickness there, of each atom that takes part.
    twice_radius: Vec<(u32, f64)>,
    spread: Result<ThicknessSpread, String>,
    seconds: f64,
}

impl PoseThicknessQuery {
    /// Returns once the frames before are measured, whatever came of it.
    fn wait_for_others(&self, cx: &Context<'_>) -> Result<(), Interrupted> {
        let [Some(frame), before] = self.after else {
            return Ok(());
        };
        let earlier = Self {
            frame,
            after: [before, None],
            ..*self
        };
        match cx.get(&earlier) {
            Err(Interrupted::Stopped) => Err(Interrupted::Stopped),
            Ok(_) | Err(Interrupted::Failed(_)) => Ok(()),
        }
    }

    fn medial(&self, subject: &Subject, cx: &Context<'_>) -> Result<Medial, Interrupted> {
        let params = self.settings.medial;
        let surfaces = MedialSurfacesQuery {
            subject: self.subject,
            params,
        };
        let beat: Arc<MedialBeat> = match cx.get(&surfaces) {
            Ok(beat) => beat,
            Err(Interrupted::Stopped) => return Err(Interrupted::Stopped),
            // The other methods may still measure the wall.
            Err(Interrupted::Failed(failure)) => {
                return Ok(Medial {
                    twice_radius: Vec::new(),
                    spread: Err(failure.to_string()),
                    seconds: 0.0,
                });
            }
        };
        let twice_radius = twice_radii(&beat, self.frame);
        let spread =
            ThicknessSpread::of(twice_radius.iter().map(|&(_, thickness)| Some(thickness)));
        Ok(Medial {
            spread: spread.ok_or_else(|| "no medial atom can be used".to_owned()),
            seconds: seconds_of_one(subject, self.frame, &params, cx.progress())?,
            twice_radius,
        })
    }
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

/// How long the medial spheres of one frame take, whether or not those of the beat were known.
fn seconds_of_one(
    subject: &Subject,
    frame: usize,
    params: &MedialParams,
    progress: &Progress,
) -> Result<f64, Interrupted> {
    let params = params.check()?;
    let surfaces = subject.sequence.surfaces().iter();
    let at_frame = surfaces.map(|surface| {
        SurfaceSequence::new(surface.kind(), surface.frames()[frame..=frame].to_vec())
    });
    let at_frame = at_frame
        .collect::<Result<_, _>>()
        .and_then(MeshSequence::new);
    let mut alone = subject.clone();
    alone.sequence = at_frame?;
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
) -> Result<MethodResult, Stopped> {
    let begin = Instant::now();
    let map = thickness(subject, frame, method, params, progress);
    let seconds = begin.elapsed().as_secs_f64();
    let compared = ComparedMethod::Other(method);
    let map = match map {
        Ok(map) => map,
        Err(ThicknessError::Stopped(stopped)) => return Err(stopped),
        Err(reason) => {
            return Ok(MethodResult {
                method: compared,
                thickness: Err(reason.to_string()),
                agreement: None,
                seconds,
            });
        }
    };
    let at_atoms = (medial.twice_radius.iter())
        .map(|&(vertex, _)| map.thickness.get(vertex as usize).copied().flatten());
    let reference = medial
        .twice_radius
        .iter()
        .map(|&(_, thickness)| Some(thickness));
    let spread = ThicknessSpread::of(map.thickness.iter().copied());
    Ok(MethodResult {
        method: compared,
        agreement: Agreement::of(at_atoms, reference),
        thickness: spread.ok_or_else(|| "no vertex has a thickness".to_owned()),
        seconds,
    })
}

#[cfg(test)]
mod tests;
