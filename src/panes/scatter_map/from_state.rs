//! What all maps of a study share: what their points are made from, who is not on them, and who is selected.

use std::sync::Arc;

use egui::Ui;

use crate::analysis::measures::SubjectMeasures;
use crate::document::play::pose_at;
use crate::document::state::State;
use crate::panes::cohort::rows::CohortRow;
use crate::panes::pane_context::motion;
use crate::panes::same::Same;
use crate::panes::scatter_map::{
    MapWords, ScatterData, ScatterPoint, ScatterView, Turn, places_between,
};
use crate::panes::work_state::WorkState;
use crate::study::{Revision, Study};

/// What points depend on beside their map: the study, and its measures for the phases.
pub type Details = (Revision, Option<Same<Vec<SubjectMeasures>>>);

/// Points of the map `M` of the study on screen, made of it and of a further detail `D`, with who is not on it.
#[derive(Debug)]
pub struct MapPoints<M, D = ()> {
    data: ScatterData<Option<Same<M>>, (Details, D)>,
    left_out: Vec<String>,
}

impl<M, D> Default for MapPoints<M, D> {
    fn default() -> Self {
        Self {
            data: ScatterData::default(),
            left_out: Vec::new(),
        }
    }
}

impl<M, D: PartialEq> MapPoints<M, D> {
    /// Has `make` make points and the list of who is missing again where the study, the map or a detail changed; moves
    /// points that are on their way, and asks for another picture while any are.
    pub fn refresh(
        &mut self,
        ui: &Ui,
        state: &State,
        map: Option<&Arc<M>>,
        detail: D,
        make: impl FnOnce(&M) -> (Vec<ScatterPoint>, Vec<String>),
    ) {
        let (now_s, moves) = motion(ui);
        let document = &state.document;
        let details = (document.study().revision, Same::of(state.measures()));
        let sources = (document.study.listing, Same::of(map), (details, detail));
        self.data.refresh(sources, now_s, moves, || {
            let (points, left_out) = map.map_or_else(Default::default, |map| make(map));
            self.left_out = left_out;
            points
        });
        if self.data.advance(now_s) {
            ui.ctx().request_repaint();
        }
    }

    /// All points, where they are now.
    pub fn points(&self) -> &[ScatterPoint] {
        self.data.points()
    }

    /// How the map is turned onto the screen; `None` while points are on their way.
    pub fn turn(&self) -> Option<Turn> {
        self.data.turn()
    }

    /// How the points of a map are turned onto the screen; not at all where another map is there.
    pub fn turn_of(&self, map: &Arc<M>) -> Turn {
        self.data.turn_of(&Same::of(Some(map)))
    }

    /// Who is not on the map, and why.
    pub fn left_out(&self) -> &[String] {
        &self.left_out
    }

    /// The map as the document shows it.
    pub fn view<'a>(
        &'a self,
        state: &State,
        words: &'static MapWords,
        work: WorkState,
        subjects: &'a [CohortRow],
    ) -> ScatterView<'a> {
        let (document, points) = (&state.document, self.data.points());
        let pose = pose_at(document.position, document.frame_count());
        let frames = [pose.from, pose.to];
        ScatterView {
            state: if document.study().subjects.is_empty() {
                WorkState::Empty
            } else {
                work
            },
            selected: document.selected_index(),
            compared: document.compared_on_screen(),
            current: places_between(points, document.subject, frames, f64::from(pose.blend)),
            shows_clusters: document.shows_clusters,
            left_out: &self.left_out,
            ..ScatterView::new(words, subjects, points)
        }
    }
}

/// The first two coordinates of a point.
pub fn plane(point: &[f64]) -> [f64; 2] {
    [0, 1].map(|axis| point.get(axis).copied().unwrap_or_default())
}

/// One line for each subject that is not on a map, with the reason.
pub fn left_out<R: std::fmt::Display>(
    study: &Study,
    left_out: impl Iterator<Item = (usize, R)>,
) -> Vec<String> {
    left_out
        .filter_map(|(subject, reason)| {
            let subject = study.subjects.get(subject)?;
            Some(format!("{}: {reason}", subject.id))
        })
        .collect()
}
