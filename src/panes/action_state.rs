//! Which actions can be done now, and which are switched on.

use std::mem::discriminant;

use crate::analysis::embedding::MapMethod;
use crate::analysis::metrics::MetricKind;
use crate::document::{ThemeChoice, ViewMode};
use crate::panes::commands::{
    BeatCommand, Command, EditCommand, FileCommand, MapCommand, Pane, TransportCommand,
    ViewCommand, WallCommand, WindowCommand,
};
use crate::picture::{BullsEyeQuantity, Quantity};
use crate::render::Shading;

/// What menus and the palette need to know of the program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ActionState {
    /// Whether any subject is open.
    pub has_study: bool,
    /// Whether there is something to undo.
    pub can_undo: bool,
    /// Whether an undo can be taken back.
    pub can_redo: bool,
    /// Whether the motion plays.
    pub playing: bool,
    /// Whether playing starts over.
    pub looping: bool,
    /// Whether the endocardium is shown.
    pub shows_endocardium: bool,
    /// Whether the epicardium or the wall is shown.
    pub shows_epicardium: bool,
    /// Whether edges are shown.
    pub shows_wireframe: bool,
    /// Whether vertices are shown.
    pub shows_vertices: bool,
    /// Whether atoms of the medial surface are shown.
    pub shows_atoms: bool,
    /// Whether their spokes are shown.
    pub shows_spokes: bool,
    /// Whether borders of patches are shown.
    pub shows_patches: bool,
    /// Whether ANV and MP are shown.
    pub shows_direction: bool,
    /// What the bull's-eye shows.
    pub bulls_eye: BullsEyeQuantity,
    /// Whether it shows segments.
    pub bulls_eye_segments: bool,
    /// Whether the camera rotates freely.
    pub free_camera: bool,
    /// Whether the window fills the screen.
    pub full_screen: bool,
    /// Smooth or flat.
    pub shading: Shading,
    /// One subject, two, or all frames of one.
    pub view_mode: ViewMode,
    /// The quantity shown in colour.
    pub quantity: Quantity,
    /// Which metric compares poses.
    pub metric: MetricKind,
    /// How distances become the pose map.
    pub map_method: MapMethod,
    /// Poses computed between two frames.
    pub in_betweens: u16,
    /// Whether there is another subject to show beside the selected one.
    pub has_other: bool,
    /// Whether a motion is transported.
    pub transporting: bool,
    /// Light or dark.
    pub theme: ThemeChoice,
    /// Whether clusters of deformations are shown.
    pub shows_clusters: bool,
    /// Panes that are closed.
    pub hidden_panes: Vec<Pane>,
}

impl ActionState {
    /// Whether a command would do anything now.
    pub fn enabled(&self, command: &Command) -> bool {
        match command {
            Command::Edit(EditCommand::Undo) => self.can_undo,
            Command::Edit(EditCommand::Redo) => self.can_redo,
            Command::Transport(TransportCommand::TransportToOther) => self.has_other,
            Command::Transport(TransportCommand::StopTransport) => self.transporting,
            Command::View(ViewCommand::SetQuantity(Quantity::Contribution)) => {
                self.has_other && self.view_mode == ViewMode::SideBySide
            }
            Command::View(ViewCommand::SetQuantity(Quantity::MotionDifference)) => {
                self.transporting
            }
            Command::File(FileCommand::ChooseFiles)
            | Command::File(FileCommand::ChooseFolder)
            | Command::File(FileCommand::Open(_))
            | Command::File(FileCommand::OpenBuiltIn)
            | Command::Window(WindowCommand::SetTheme(_))
            | Command::Window(WindowCommand::TogglePane(_))
            | Command::Window(WindowCommand::ShowPane(_))
            | Command::Window(WindowCommand::ResetLayout)
            | Command::Window(WindowCommand::TogglePalette)
            | Command::Window(WindowCommand::ToggleShortcuts)
            | Command::Window(WindowCommand::ToggleLoadReport)
            | Command::Window(WindowCommand::ToggleAbout)
            | Command::Window(WindowCommand::ToggleFullScreen)
            | Command::File(FileCommand::Quit) => true,
            _ => self.has_study,
        }
    }

    /// Whether a switch is on; `None` for what is no switch.
    pub fn checked(&self, command: &Command) -> Option<bool> {
        match command {
            Command::View(ViewCommand::SetViewMode(mode)) => Some(self.view_mode == *mode),
            Command::View(ViewCommand::SetQuantity(quantity)) => Some(self.quantity == *quantity),
            Command::Transport(TransportCommand::SetInBetweens(count)) => {
                Some(self.in_betweens == *count)
            }
            Command::Map(MapCommand::SetMetric(kind)) => Some(self.metric == *kind),
            // Isomap is Isomap, whatever its neighbours.
            Command::Map(MapCommand::SetMapMethod(method)) => {
                Some(discriminant(&self.map_method) == discriminant(method))
            }
            Command::Window(WindowCommand::SetTheme(theme)) => Some(self.theme == *theme),
            Command::View(ViewCommand::SetShading(shading)) => Some(self.shading == *shading),
            Command::Window(WindowCommand::TogglePane(pane)) => {
                Some(!self.hidden_panes.contains(pane))
            }
            Command::Map(MapCommand::ToggleClusters) => Some(self.shows_clusters),
            Command::Beat(BeatCommand::ToggleLoop) => Some(self.looping),
            Command::View(ViewCommand::ToggleFreeCamera) => Some(self.free_camera),
            Command::View(ViewCommand::ToggleEndocardium) => Some(self.shows_endocardium),
            Command::View(ViewCommand::ToggleEpicardium) => Some(self.shows_epicardium),
            Command::View(ViewCommand::ToggleWireframe) => Some(self.shows_wireframe),
            Command::View(ViewCommand::ToggleVertices) => Some(self.shows_vertices),
            Command::Wall(WallCommand::ToggleAtoms) => Some(self.shows_atoms),
            Command::Wall(WallCommand::ToggleSpokes) => Some(self.shows_spokes),
            Command::Wall(WallCommand::TogglePatches) => Some(self.shows_patches),
            Command::Wall(WallCommand::ToggleDirection) => Some(self.shows_direction),
            Command::Wall(WallCommand::SetBullsEye(quantity)) => Some(self.bulls_eye == *quantity),
            Command::Wall(WallCommand::ToggleBullsEyeSegments) => Some(self.bulls_eye_segments),
            Command::Window(WindowCommand::ToggleFullScreen) => Some(self.full_screen),
            _ => None,
        }
    }
}
