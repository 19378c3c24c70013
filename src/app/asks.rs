//! What the window asks the store every frame, whatever is on screen: maps, measures, walls, verdicts.

use std::sync::Arc;

use crate::analysis::classification::ClassesParams;
use crate::analysis::measures::SubjectMeasures;
use crate::engine::{
    ClassesQuery, DeformationMapQuery, EstimatedPoseQuery, MeasuresQuery, Showing, Store,
    SubjectMeasuresQuery, VerdictQuery, WallThickeningQuery,
};

use super::asks_motions::MotionAsks;
use crate::document::answers::{Answers, WallAnswer};
use crate::document::document::Document;
use crate::document::state::State;
use crate::document::visible_poses;
use crate::panes::deformation_map::view::enough_subjects;
use crate::panes::pane_context::ask_at_rest;

/// Asks, with what is made of answers once and kept as long as the answer stays the same.
#[derive(Debug, Default)]
pub struct Asks {
    motions: MotionAsks,
}

impl Asks {
    /// The answers to what the state on screen needs; `pointer_held` says whether something may be dragged.
    pub fn ask(&mut self, state: &State, store: &Store, pointer_held: bool) -> Answers {
        let study = state.document.study();
        let mut answers = Answers {
            listing: state.document.study.listing,
            ..Answers::default()
        };
        if study.subjects.is_empty() {
            return answers;
        }
        let measures = store.ask(study, &MeasuresQuery);
        if measures.latest().is_none() {
            answers.measures_of_one = measures_on_screen(state, store);
        }
        answers.measures = Some(measures);
        answers.map = Some(store.ask(study, &state.document.map));
        answers.estimate = state.estimate_at.map(|at| {
            let map = state.document.map;
            store.ask(study, &EstimatedPoseQuery { map, at })
        });
        self.motions.ask(state, store, &mut answers);
        answers.walls = walls(state, store);
        if enough_subjects(state) {
            let deformations = deformation_settings(state);
            answers.deformations = Some(store.ask(study, &deformations));
            let classes = ClassesQuery {
                deformations,
                classes: ClassesParams::default(),
                by: state.document.classes_by(),
            };
            answers.classes = Some(store.ask(study, &classes));
        }
        let verdicts = verdict_settings(&state.document);
        answers.verdicts = Some(ask_at_rest(store, study, pointer_held, &verdicts));
        answers
    }
}

/// How whole deformations are compared and mapped.
pub fn deformation_settings(state: &State) -> DeformationMapQuery {
    DeformationMapQuery {
        poses: state.document.map,
        map: state.document.deformation_map,
    }
}

/// How the subjects are classified.
pub fn verdict_settings(document: &Document) -> VerdictQuery {
    VerdictQuery {
        thickening: document.thickening,
        rule: document.rule.clone(),
        ..VerdictQuery::default()
    }
}

/// The measures of the subjects on screen, each alone.
fn measures_on_screen(state: &State, store: &Store) -> Vec<(usize, Showing<SubjectMeasures>)> {
    let mut measures: Vec<(usize, Showing<SubjectMeasures>)> = Vec::new();
    for place in visible_poses(state) {
        if measures.iter().all(|(index, _)| *index != place.subject)
            && let Some(subject) = state.subject(place.subject)
        {
            let query = SubjectMeasuresQuery(Arc::clone(subject));
            measures.push((place.subject, store.ask(state.document.study(), &query)));
        }
    }
    measures
}

/// The walls of the subjects on screen.
fn walls(state: &State, store: &Store) -> Vec<WallAnswer> {
    let mut walls: Vec<WallAnswer> = Vec::new();
    for place in visible_poses(state)
        .into_iter()
        .filter(|place| !place.transported)
    {
        if walls.iter().all(|wall| wall.subject != place.subject) {
            let query = WallThickeningQuery {
                subject: place.subject,
                settings: state.document.thickening,
            };
            let showing = store.ask(state.document.study(), &query);
            walls.push(WallAnswer::new(place.subject, showing));
        }
    }
    walls
}
