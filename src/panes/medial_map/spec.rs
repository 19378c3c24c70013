//! The pane in the window's table. The map of the medial shape space.

use egui::Ui;

use crate::document::State;
use crate::engine::MedialMapParams;
use crate::panes::commands::{Command, Pane};
use crate::panes::look::Look;
use crate::panes::look::motion;
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pose_map::spec::map_data;

use super::view::MedialMapData;
use super::{MedialMapView, medial_map_choosers_ui, medial_map_header_ui, medial_map_ui};

impl Pane {
    /// The map of the medial shape space.
    pub const MEDIAL_MAP: Self = Self::named("medial_map");
}

/// The map of the medial shape space.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::MEDIAL_MAP,
    title: "Medial",
    toggle: "Pane: medial map",
    place: Place::Above,
    header: Header::Own(header_ui, choosers_ui),
    ui,
};

/// What the pane asks the store.
pub fn medial_map_query(state: &State) -> MedialMapParams {
    MedialMapParams {
        thickening: state.document.thickening,
        method: state.document.map.method,
    }
}

/// Asks for the map, and hands what the pane shows to `draw`.
fn with_view(ui: &mut Ui, look: &Look<'_>, draw: impl FnOnce(&mut Ui, &MedialMapView<'_>)) {
    let state = look.state();
    let showing = look.ask_at_rest(&medial_map_query(state));
    let poses = map_data(ui, look);
    let poses = poses.borrow_mut();
    let data = look.memo().get::<MedialMapData>();
    let mut data = data.borrow_mut();
    let (now_s, moves) = motion(ui);
    if data.refresh(state, showing.latest(), now_s, moves) {
        ui.ctx().request_repaint();
    }
    let view = data.view(state, poses.subjects(), &showing);
    draw(ui, &view);
}

fn header_ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    with_view(ui, look, |ui, view| {
        medial_map_header_ui(ui, view, commands);
    });
}

fn choosers_ui(ui: &mut Ui, look: &Look<'_>, taken: f32, commands: &mut Vec<Command>) {
    if ui.available_width() - taken > 90.0 {
        with_view(ui, look, |ui, view| {
            medial_map_choosers_ui(ui, view, commands);
        });
    }
}

fn ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    with_view(ui, look, |ui, view| medial_map_ui(ui, view, commands));
}
