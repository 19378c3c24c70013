//! How one wall thickens: atoms over the beat compared with end-diastole, and the patches that do not thicken.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::analysis::measures::{SubjectMeasures, measure_subject};
use crate::analysis::medial::{MedialBeat, MedialParams};
use crate::analysis::medial_space::RatioForm;
use crate::analysis::segments::{LongAxis, Polar, Segment, long_axis, polar, segment};
use crate::analysis::thickening::{Thickening, ThickeningParams, phases, thickening};
use crate::analysis::verdicts::{NotAssessed, VerdictInput, VerdictParams, examine, wall_in_doubt};
use crate::engine::queries::measures::MeasuresQuery;
use crate::engine::queries::medial_surfaces::{MedialSurfacesQuery, beat_bytes, medial_words};
use crate::engine::queries::subject::{NoSubject, subject_of};
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query, Urgency};
use crate::study::Study;

/// Share of the time of a subject's thickening that its atoms take.
const ATOMS_SHARE: f32 = 0.8;

/// Settings of the search for patches, from the surfaces on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ThickeningSettings {
    /// How medial spheres are fitted.
    pub medial: MedialParams,
    /// What is akinetic, and what is a patch.
    // The name in pictures that were saved.
    #[serde(rename = "thickening")]
    pub patches: ThickeningParams,
}

/// How one subject's wall thickens, and which patches of it do not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallThickeningQuery {
    /// Whose wall.
    pub subject: usize,
    /// How medial spheres are fitted, and what counts as a patch.
    pub settings: ThickeningSettings,
}

/// What window, tables and figures read of one subject.
#[derive(Clone, Debug, PartialEq)]
pub struct SubjectThickening {
    /// Its atoms at every frame.
    pub beat: Arc<MedialBeat>,
    /// How they thicken, and where they do not.
    pub thickening: Thickening,
    /// Why there is no verdict on its wall, where it is not resolved: patches in it may be blur or noise.
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
    fn own_bytes(&self) -> usize {
        let thickening = &self.thickening;
        let steps: usize = (thickening.steps.iter())
            .map(|step| size_of_val(step) + size_of_val(&*step.pt) + size_of_val(&*step.akinetic))
            .sum();
        let patches: usize = (thickening.patches.iter())
            .map(|patch| {
                size_of_val(patch) + size_of_val(&*patch.atoms) + size_of_val(&*patch.path)
            })
            .sum();
        let atoms = size_of_val(&*thickening.ed_to_es) + size_of_val(&*thickening.averaged);
        steps + patches + atoms + size_of_val(&*self.segments) + size_of_val(&*self.polar)
    }
}

impl Query for WallThickeningQuery {
    type Answer = SubjectThickening;
    const TITLE: &'static str = "Thickening";
    // Thresholds are dragged while the patches are looked at.
    const URGENCY: Urgency = Urgency::Interactive;

    fn parameters(&self) -> String {
        thickening_words(&self.settings)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::geometry(study, [self.subject])
    }

    fn run(&self, cx: &Context<'_>) -> Result<SubjectThickening, Interrupted> {
        let params = self.settings.patches.check()?;
        let subject = subject_of(cx.study(), self.subject)?;
        let atoms = MedialSurfacesQuery {
            subject: self.subject,
            params: self.settings.medial,
        };
        // Other thresholds find the atoms known.
        let (beat, share) = cx.first("fitting medial spheres", &atoms, ATOMS_SHARE)?;
        let part = cx.part("computing thickening", share, 1.0);
        let measures = self.measures(cx)?;
        let end_diastole = phases(&beat, &measures)[0];
        let (axis, without_axis) = match long_axis(subject, end_diastole) {
            Ok(axis) => (Some(axis), None),
            Err(error) => (None, Some(error.to_string())),
        };
        let assessed = thickening(&beat, &measures, axis.as_ref(), &params, part.progress())?;
        let centres = beat.frames[end_diastole].positions();
        let verdicts = VerdictParams::default().check()?;
        let input = VerdictInput {
            beat: &beat,
            thickening: &assessed,
        };
        Ok(SubjectThickening {
            not_assessed: wall_in_doubt(subject).or_else(|| examine(&input, &verdicts).err()),
            beat,
            thickening: assessed,
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

    fn memory(wall: &SubjectThickening, memory: &mut Memory) {
        memory.shared(&wall.beat, beat_bytes(&wall.beat));
        memory.own(wall.own_bytes());
    }

    fn subjects(&mut self) -> Vec<&mut usize> {
        vec![&mut self.subject]
    }

    fn replaces(&self, other: &Self) -> bool {
        self.subject == other.subject
    }

    /// While a threshold is dragged, patches follow the drag; other spheres take too long for that.
    fn lets_finish(&self, begun: &Self) -> bool {
        self.subject == begun.subject && self.settings.medial == begun.settings.medial
    }
}

impl WallThickeningQuery {
    /// The measures of the subject: of the whole study where they are known, otherwise of it alone; both are equal.
    fn measures(&self, cx: &Context<'_>) -> Result<SubjectMeasures, NoSubject> {
        let known = cx.known(&MeasuresQuery);
        match known.and_then(|all| all.get(self.subject).cloned()) {
            Some(measures) => Ok(measures),
            None => Ok(measure_subject(subject_of(cx.study(), self.subject)?)),
        }
    }
}

/// Settings of the search for patches, as summaries and the activity list say it.
pub fn thickening_words(settings: &ThickeningSettings) -> String {
    let ThickeningParams {
        tolerance,
        ratio,
        core_threshold,
        akinetic_threshold,
        extent_threshold,
        min_share,
        min_thickening,
        smoothing,
        redraws,
        seed,
    } = settings.patches;
    let tolerance =
        tolerance.map_or_else(|| "estimated from noise".to_owned(), |t| format!("± {t}"));
    let ratio = match ratio {
        RatioForm::GeometricMean => "geometric mean",
        RatioForm::Product => "product",
    };
    format!(
        "{}, tolerance of ln PT {tolerance}, ratio as {ratio}, core threshold {core_threshold}, akinetic threshold {akinetic_threshold:.3}, \
         extent threshold {extent_threshold}, minimum area {min_share}, minimum thickening {min_thickening:.3}, \
         averaged over {smoothing}, \
         {redraws} redraws, seed {seed}",
        medial_words(&settings.medial)
    )
}

#[cfg(test)]
mod tests;
