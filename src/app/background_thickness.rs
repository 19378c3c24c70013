//! Background work on the ways of measuring thickness: the poses that its pane shows, one after the other.

use std::sync::Arc;

use crate::engine::{AnalysisRequest, Engine, Showing, ThicknessSettings, WorkKind};
use crate::study::Subject;
use crate::ui::Pane;

use super::background_medial::Seen;
use super::state::State;

/// What was asked for last.
#[derive(Clone, Debug)]
struct AskedPose {
    subject: Arc<Subject>,
    index: usize,
    frame: usize,
    settings: ThicknessSettings,
}

impl AskedPose {
    fn request(&self) -> AnalysisRequest {
        AnalysisRequest::FrameThickness {
            subject: self.index,
            frame: self.frame,
            params: self.settings,
        }
    }
}

/// What the answers that come in belong to.
#[derive(Debug, Default)]
pub struct AskedThickness(Option<AskedPose>);

impl AskedThickness {
    /// Asks for the first pose that the pane lacks, while the pane is seen. What was begun for the same heart is
    /// finished first: stepping through the frames stops nothing.
    pub fn request(&mut self, state: &State, engine: &mut Engine, seen: &Seen) {
        if !seen.panes.contains(&Pane::Thickness) {
            return;
        }
        let Some(wanted) = wanted(state) else {
            return;
        };
        let computing = matches!(
            engine.showing(WorkKind::Thickness),
            Showing::Computing { .. }
        );
        let same_heart =
            (self.0.as_ref()).is_some_and(|asked| Arc::ptr_eq(&asked.subject, &wanted.subject));
        if computing && same_heart {
            return;
        }
        engine.request(state.document.study(), wanted.request());
        self.0 = Some(wanted);
    }

    /// What the user asks to be measured again.
    pub fn retry(&mut self, state: &State) -> Option<AnalysisRequest> {
        let wanted = wanted(state)?;
        let request = wanted.request();
        self.0 = Some(wanted);
        Some(request)
    }

    /// The frame that is asked for, of the selected heart.
    pub fn frame(&self, state: &State) -> Option<usize> {
        let asked = self.0.as_ref()?;
        let selected = state.document.selected()?;
        Arc::ptr_eq(&asked.subject, selected).then_some(asked.frame)
    }

    /// Takes in what was measured since the last frame.
    pub fn take(&self, state: &mut State, engine: &Engine) {
        let Some(asked) = &self.0 else {
            return;
        };
        let store = &mut state.results.thickness;
        let (subject, settings) = (&asked.subject, &asked.settings);
        if store.get(subject, settings, asked.frame).is_some() {
            return;
        }
        match engine.showing(WorkKind::Thickness) {
            Showing::Ready(outcome) => {
                if let Some(found) = outcome.frame_thickness() {
                    store.put(subject, settings, asked.frame, Ok(Arc::clone(found)));
                }
            }
            Showing::Failed { error, .. } => {
                store.put(subject, settings, asked.frame, Err(error.to_string()));
            }
            _ => {}
        }
    }
}

/// How thickness is measured.
pub fn settings(state: &State) -> ThicknessSettings {
    ThicknessSettings {
        medial: state.document.thickening.medial,
        ..ThicknessSettings::default()
    }
}

/// The poses that the pane shows: end-diastole, end-systole, and the one on screen; while the beat plays only
/// the first two, for the third is gone before it is measured.
pub fn poses(state: &State) -> Vec<usize> {
    let document = &state.document;
    let (end_diastole, end_systole) = state.phases_of(document.subject);
    let on_screen = (!state.play.playing).then(|| document.frame());
    let mut frames: Vec<usize> = Vec::new();
    for frame in [end_diastole, end_systole, on_screen].into_iter().flatten() {
        if !frames.contains(&frame) {
            frames.push(frame);
        }
    }
    frames
}

/// The first pose that is not known. Without measures the phases of the beat are not known yet.
fn wanted(state: &State) -> Option<AskedPose> {
    state.measures()?;
    let subject = state.document.selected()?;
    let settings = settings(state);
    let unknown = |frame: &usize| {
        let store = &state.results.thickness;
        store.get(subject, &settings, *frame).is_none()
    };
    let frame = poses(state).into_iter().find(unknown)?;
    Some(AskedPose {
        subject: Arc::clone(subject),
        index: state.document.subject,
        frame,
        settings,
    })
}
