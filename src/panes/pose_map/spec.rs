//! The pane in the window's table. The pose map.

use egui::Ui;

use crate::panes::commands::{Command, Pane};
use crate::panes::look::Look;
use crate::panes::look::{Kept, motion};
use crate::panes::pane::{Header, PaneSpec, Place};

use super::view::MapData;
use super::{pose_map_choosers_ui, pose_map_header_ui, pose_map_ui};

impl Pane {
    /// The pose map.
    pub const POSE_MAP: Self = Self::named("pose_map");
}

/// The pose map.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::POSE_MAP,
    title: "Poses",
    toggle: "Pane: poses",
    place: Place::Above,
    header: Header::Own(header_ui, choosers_ui),
    ui,
};

/// The points of the pose map, which other panes show, too; asks for another picture while they walk.
pub fn map_data(ui: &Ui, look: &Look<'_>) -> Kept<MapData> {
    let data = look.memo().get::<MapData>();
    let (now_s, moves) = motion(ui);
    if data.borrow_mut().refresh(look.state(), now_s, moves) {
        ui.ctx().request_repaint();
    }
    data
}

fn header_ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let data = map_data(ui, look);
    let data = data.borrow_mut();
    let map = look.state().answers.map.as_ref();
    pose_map_header_ui(ui, &data.view(look.state(), map), commands);
}

fn choosers_ui(ui: &mut Ui, look: &Look<'_>, taken: f32, commands: &mut Vec<Command>) {
    let room = ui.available_width() - taken;
    if room > 90.0 {
        let data = map_data(ui, look);
        let data = data.borrow_mut();
        let map = look.state().answers.map.as_ref();
        pose_map_choosers_ui(ui, &data.view(look.state(), map), room > 250.0, commands);
    }
}

fn ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let data = map_data(ui, look);
    let data = data.borrow_mut();
    let map = look.state().answers.map.as_ref();
    pose_map_ui(ui, &data.view(look.state(), map), commands);
}
