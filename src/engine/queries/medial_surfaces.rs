//! The medial surface of one wall over the beat: atoms and their radii.

use crate::analysis::medial::{MedialBeat, MedialParams, medial_beat};
use crate::engine::queries::subject::subject_of;
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::report::medial_words;
use crate::study::Study;

/// The medial surface of one subject's wall at every frame.
#[derive(Clone, Debug, PartialEq)]
pub struct MedialSurfacesQuery {
    /// Whose wall.
    pub subject: usize,
    /// How medial spheres are fitted.
    pub params: MedialParams,
}

impl Query for MedialSurfacesQuery {
    type Answer = MedialBeat;
    const TITLE: &'static str = "Medial surface";

    fn parameters(&self) -> String {
        medial_words(&self.params)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::surfaces(study, [self.subject])
    }

    fn run(&self, cx: &Context<'_>) -> Result<MedialBeat, Interrupted> {
        let params = self.params.check()?;
        let subject = subject_of(cx.study(), self.subject)?;
        cx.progress()
            .begin_phase("fitting medial spheres", 0.0, 1.0);
        Ok(medial_beat(subject, &params, cx.progress())?)
    }

    fn memory(beat: &MedialBeat, memory: &mut Memory) {
        memory.own(beat_bytes(beat));
    }

    fn subjects(&mut self) -> Vec<&mut usize> {
        vec![&mut self.subject]
    }

    fn replaces(&self, other: &Self) -> bool {
        self.subject == other.subject
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
