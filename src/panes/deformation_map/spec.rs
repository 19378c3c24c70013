//! The pane in the window's table. The map of whole deformations.

use egui::Ui;

use crate::panes::commands::{Command, Pane};
use crate::panes::look::Look;
use crate::panes::look::motion;
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pose_map::spec::map_data;

use super::view::DeformationData;
use super::{DeformationMapView, deformation_map_ui, deformation_note};

impl Pane {
    /// The map of whole deformations.
    pub const DEFORMATION_MAP: Self = Self::named("deformation_map");
}

/// The map of whole deformations.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::DEFORMATION_MAP,
    title: "Deformations",
    toggle: "Pane: deformations",
    place: Place::Above,
    header: Header::Beside(note_ui),
    ui,
};

/// Hands what the pane shows to `draw`; asks for another picture while points walk.
fn with_view(ui: &mut Ui, look: &Look<'_>, draw: impl FnOnce(&mut Ui, &DeformationMapView<'_>)) {
    let poses = map_data(ui, look);
    let poses = poses.borrow_mut();
    let data = look.memo().get::<DeformationData>();
    let mut data = data.borrow_mut();
    let (now_s, moves) = motion(ui);
    if data.refresh(look.state(), now_s, moves) {
        ui.ctx().request_repaint();
    }
    let view = data.view(look.state(), poses.subjects(), poses.left_out());
    draw(ui, &view);
}

fn note_ui(ui: &mut Ui, look: &Look<'_>, taken: f32, _commands: &mut Vec<Command>) {
    with_view(ui, look, |ui, view| deformation_note(ui, view, taken));
}

fn ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    with_view(ui, look, |ui, view| deformation_map_ui(ui, view, commands));
}
