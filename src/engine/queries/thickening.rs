//! How one wall thickens: atoms over the beat compared with end-diastole, and the patches that do not thicken.

use crate::analysis::measures::{SubjectMeasures, measure_subject};
use crate::analysis::thickening::ThickeningSettings;
use crate::analysis::verdicts::{SubjectThickening, VerdictParams};
use crate::engine::queries::measures::MeasuresQuery;
use crate::engine::queries::medial_surfaces::{MedialSurfacesQuery, beat_bytes};
use crate::engine::queries::subject::{NoSubject, subject_of};
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query, Urgency};
use crate::report::thickening_words;
use crate::study::Study;

/// Share of the time of a subject's thickening that its atoms take.
const ATOMS_SHARE: f32 = 0.8;

/// How one subject's wall thickens, and which patches of it do not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallThickeningQuery {
    /// Whose wall.
    pub subject: usize,
    /// How medial spheres are fitted, and what counts as a patch.
    pub settings: ThickeningSettings,
}

/// Memory that an answer holds without its atoms, which other answers share.
fn own_bytes(wall: &SubjectThickening) -> usize {
    let thickening = &wall.thickening;
    let steps: usize = (thickening.steps.iter())
        .map(|step| size_of_val(step) + size_of_val(&*step.pt) + size_of_val(&*step.akinetic))
        .sum();
    let patches: usize = (thickening.patches.iter())
        .map(|patch| size_of_val(patch) + size_of_val(&*patch.atoms) + size_of_val(&*patch.path))
        .sum();
    let atoms = size_of_val(&*thickening.ed_to_es) + size_of_val(&*thickening.averaged);
    steps + patches + atoms + size_of_val(&*wall.segments) + size_of_val(&*wall.polar)
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
        let verdicts = VerdictParams::default().check()?;
        let progress = part.progress();
        Ok(SubjectThickening::new(
            subject, beat, &measures, &params, &verdicts, progress,
        )?)
    }

    fn memory(wall: &SubjectThickening, memory: &mut Memory) {
        memory.shared(&wall.beat, beat_bytes(&wall.beat));
        memory.own(own_bytes(wall));
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

#[cfg(test)]
mod tests;
