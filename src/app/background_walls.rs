//! Background work on walls: atoms and thickening of the hearts on screen, verdicts on all hearts.

use std::sync::Arc;

use crate::engine::{AnalysisRequest, Engine, Showing, ThickeningSettings, WorkKind};
use crate::study::Subject;

use super::found_verdicts::VerdictKey;
use super::stage::on_stage;
use super::state::State;

/// What was asked for last.
#[derive(Clone, Debug)]
struct AskedWall {
    subject: Arc<Subject>,
    index: usize,
    settings: ThickeningSettings,
}

impl AskedWall {
    fn only_thresholds_differ(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.subject, &other.subject)
            && self.settings.medial == other.settings.medial
            && self.settings != other.settings
    }

    fn request(&self) -> AnalysisRequest {
        AnalysisRequest::Thickening {
            subject: self.index,
            params: self.settings,
        }
    }
}

/// What the answers that come in belong to.
#[derive(Debug, Default)]
pub struct AskedWalls(Option<AskedWall>);

impl AskedWalls {
    /// Asks for the wall of the selected heart, then for that of the one beside it; free if it is there or
    /// under way. While a threshold is dragged, what was begun is finished first: patches follow the drag, where
    /// each step would stop the one before.
    pub fn request(&mut self, state: &State, engine: &mut Engine) {
        let computing = engine.computes(WorkKind::Medial);
        if let Some(wanted) = wanted(state) {
            if computing
                && self
                    .0
                    .as_ref()
                    .is_some_and(|asked| asked.only_thresholds_differ(&wanted))
            {
                return;
            }
            engine.request(state.document.study(), wanted.request());
            self.0 = Some(wanted);
        }
    }

    /// What the user asks to be computed again.
    pub fn retry(&mut self, state: &State) -> Option<AnalysisRequest> {
        let wanted = wanted(state)?;
        let request = wanted.request();
        self.0 = Some(wanted);
        Some(request)
    }

    /// Takes in what was computed since the last frame. What cannot be told of a wall is an answer too:
    /// "not assessed", with its reason.
    pub fn take(&self, state: &mut State, engine: &Engine) {
        let Some(asked) = &self.0 else {
            return;
        };
        let store = &mut state.results.walls;
        if store.get(&asked.subject, &asked.settings).is_some() {
            return;
        }
        match engine.showing(WorkKind::Medial) {
            Showing::Ready(outcome) => {
                if let Some(found) = outcome.thickening() {
                    // Colours and borders of a wall that is not resolved would look like findings.
                    let told = match &found.not_assessed {
                        Some(reason) => Err(reason.to_string()),
                        None => Ok(Arc::clone(found)),
                    };
                    store.put(&asked.subject, &asked.settings, told);
                }
            }
            Showing::Failed { error, .. } => {
                store.put(&asked.subject, &asked.settings, Err(error.to_string()));
            }
            _ => {}
        }
    }
}

/// Work that comes before verdicts on all hearts: what is on screen, and what is asked for at once.
const BEFORE_VERDICTS: [WorkKind; 5] = [
    WorkKind::Measures,
    WorkKind::Medial,
    WorkKind::PoseMap,
    WorkKind::DeformationMap,
    WorkKind::Classes,
];

/// What the verdicts that come in belong to.
#[derive(Debug, Default)]
pub struct AskedVerdicts {
    key: Option<VerdictKey>,
    /// Whether what was begun was stopped here, and not by the user.
    set_aside: bool,
}

impl AskedVerdicts {
    /// Asks for verdicts once nothing on screen waits any more; free if they are there or under way. Those of
    /// thresholds that were left are stopped at once, so that they do not hold up the new patches.
    pub fn request(&mut self, state: &State, engine: &mut Engine, pointer_held: bool) {
        let wanted = VerdictKey::wanted(state);
        if self.key != Some(wanted) && engine.computes(WorkKind::Verdicts) {
            engine.cancel(WorkKind::Verdicts);
            *self = Self {
                key: None,
                set_aside: true,
            };
        }
        if self.key == Some(wanted) || state.measures().is_none() || pointer_held {
            return;
        }
        if !BEFORE_VERDICTS.iter().any(|&kind| engine.computes(kind)) {
            let request = AnalysisRequest::Verdicts(wanted.settings());
            if self.set_aside {
                engine.retry(state.document.study(), request);
            } else {
                engine.request(state.document.study(), request);
            }
            *self = Self {
                key: Some(wanted),
                set_aside: false,
            };
        }
    }

    /// What the user asks to be computed again.
    pub fn retry(&mut self, state: &State) -> AnalysisRequest {
        let wanted = VerdictKey::wanted(state);
        *self = Self {
            key: Some(wanted),
            set_aside: false,
        };
        AnalysisRequest::Verdicts(wanted.settings())
    }

    /// Takes in what was computed since the last frame.
    pub fn take(&self, state: &mut State, engine: &Engine) {
        let store = &mut state.results.verdicts;
        store.asked = self.key;
        let Some(asked) = self.key else {
            return;
        };
        if let Showing::Ready(outcome) = engine.showing(WorkKind::Verdicts)
            && let Some(value) = outcome.verdicts()
            && store.found.as_ref().is_none_or(|(key, _)| *key != asked)
        {
            store.found = Some((asked, Arc::clone(value)));
        }
    }
}

/// The first heart on screen whose wall is not known with today's settings. Without measures the phases
/// of the beat are not known yet.
fn wanted(state: &State) -> Option<AskedWall> {
    state.measures()?;
    let settings = state.document.thickening;
    let unknown = on_stage(state).into_iter().find_map(|place| {
        let subject = state.subject(place.subject).filter(|_| !place.carried)?;
        let known = state.results.walls.get(subject, &settings).is_some();
        (!known).then(|| (Arc::clone(subject), place.subject))
    });
    unknown.map(|(subject, index)| AskedWall {
        subject,
        index,
        settings,
    })
}
