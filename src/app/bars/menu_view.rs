//! The menu bar, and what menus and the palette must know to grey and tick their lines.

use crate::app::MenuBarView;
use crate::app::layout::Layout;
use crate::document::state::State;
use crate::panes::{ActionState, PANES};

/// Which actions can be done now and which switches are on.
pub fn action_state(state: &State, layout: &Layout) -> ActionState {
    let document = &state.document;
    ActionState {
        has_study: !document.study().subjects.is_empty(),
        can_undo: state.history.can_undo(),
        can_redo: state.history.can_redo(),
        playing: state.play.playing,
        looping: state.play.repeat,
        shows_endocardium: document.visibility.endocardium,
        shows_epicardium: document.visibility.epicardium,
        shows_wireframe: document.visibility.wireframe,
        shows_vertices: document.visibility.vertices,
        shows_atoms: document.visibility.atoms,
        shows_spokes: document.visibility.spokes,
        shows_patches: document.visibility.patches,
        shows_direction: document.visibility.direction,
        bulls_eye: document.bulls_eye,
        bulls_eye_segments: document.bulls_eye_segments,
        free_camera: document.free_camera,
        full_screen: state.full_screen,
        shading: document.visibility.shading,
        view_mode: document.view_mode,
        quantity: document.quantity,
        in_betweens: document.in_betweens,
        has_other: document.compared().is_some(),
        transporting: document.visible_transport().is_some(),
        theme: state.theme,
        metric: document.map.distances.metric.kind,
        map_method: document.map.method,
        shows_clusters: document.shows_clusters,
        hidden_panes: PANES
            .iter()
            .map(|spec| spec.pane)
            .filter(|pane| !layout.is_open(*pane))
            .collect(),
    }
}

/// What the menu bar shows.
pub fn menu_bar_view<'a>(state: &'a State, actions: &'a ActionState) -> MenuBarView<'a> {
    let study = state.document.study();
    MenuBarView {
        study_name: (!study.subjects.is_empty()).then_some(study.name.as_str()),
        subject_count: study.subjects.len(),
        pose_count: study
            .subjects
            .iter()
            .map(|subject| subject.sequence.frame_count())
            .sum(),
        recent: &state.recent,
        actions,
    }
}
