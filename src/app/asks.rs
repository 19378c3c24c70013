//! What the window asks the store every frame, whatever is on screen: maps, measures, walls, verdicts.

use std::collections::HashSet;

use crate::analysis::classification::ClassesParams;
use crate::engine::{
    ClassesQuery, DeformationMapQuery, FrameThickness, MeasuresQuery, PoseThicknessQuery, Showing,
    Store, ThicknessSettings, VerdictQuery, WallThickeningQuery,
};
use crate::panes::Pane;

use super::asks_motions::MotionAsks;
use crate::document::answers::{Answers, WallAnswer};
use crate::document::document::Document;
use crate::document::state::State;
use crate::document::visible_poses;
use crate::panes::deformation_map::view::enough_subjects;
use crate::panes::pane_context::ask_at_rest;

/// What of the window is looked at: work for panes that nobody sees waits.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    /// Panes in front of other tabs.
    pub panes: HashSet<Pane>,
    /// Whether something may be dragged.
    pub pointer_held: bool,
}

/// Asks, with what is made of answers once and kept as long as the answer stays the same.
#[derive(Debug, Default)]
pub struct Asks {
    motions: MotionAsks,
}

impl Asks {
    /// The answers to what the state on screen needs.
    pub fn ask(&mut self, state: &State, store: &Store, seen: &Seen) -> Answers {
        let study = state.document.study();
        let mut answers = Answers {
            listing: state.document.study.listing,
            ..Answers::default()
        };
        if study.subjects.is_empty() {
            return answers;
        }
        answers.measures = Some(store.ask(study, &MeasuresQuery));
        answers.map = Some(store.ask(study, &state.document.map));
        self.motions.ask(state, store, &mut answers);
        answers.walls = walls(state, store);
        if enough_subjects(state) {
            let deformations = deformation_settings(state);
            answers.deformations = Some(store.ask(study, &deformations));
            let classes = ClassesQuery {
                deformations,
                classes: ClassesParams::default(),
                ..ClassesQuery::default()
            };
            answers.classes = Some(store.ask(study, &classes));
        }
        if seen.panes.contains(&Pane::THICKNESS) {
            answers.thickness = thickness(state, store);
        }
        let verdicts = verdict_settings(&state.document);
        answers.verdicts = Some(ask_at_rest(store, study, seen.pointer_held, &verdicts));
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
        ..VerdictQuery::default()
    }
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

/// Thickness at the poses that the pane shows, one after the other: their times are shown, and two at a time would
/// disturb each other.
fn thickness(state: &State, store: &Store) -> Vec<(usize, Showing<FrameThickness>)> {
    let study = state.document.study();
    let mut waits = false;
    let poses = thickness_poses(state).into_iter().map(|frame| {
        let query = PoseThicknessQuery {
            subject: state.document.subject,
            frame,
            settings: ThicknessSettings {
                medial: state.document.thickening.medial,
                ..ThicknessSettings::default()
            },
        };
        let showing = match waits {
            true => store.watch(study, &query),
            false => store.ask(study, &query),
        };
        waits |= showing.computing() || showing.stopped();
        (frame, showing)
    });
    poses.collect()
}

/// End-diastole, end-systole, and the pose on screen; while the motion plays only the first two, for the third is gone
/// before it is measured. None while the phases are not known.
fn thickness_poses(state: &State) -> Vec<usize> {
    let document = &state.document;
    if state.measures().is_none() {
        return Vec::new();
    }
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
