//! Which actions can be done now, and which are switched on.

use std::mem::discriminant;

use crate::document::State;
use crate::panes::commands::{
    ClassifierCommand, Command, EditCommand, FileCommand, ImagesCommand, ImportCommand, MapCommand,
    Pane, Phase, PhaseFrame, PlaybackCommand, TransportCommand, ViewCommand, WallCommand, Whose,
    WindowCommand,
};
use crate::picture::Quantity;
use crate::study::Subject;

/// What menus and the palette need to know of the program.
#[derive(Debug)]
pub struct ActionState<'a> {
    /// Everything the window shows.
    pub state: &'a State,
    /// Panes that are closed.
    pub hidden_panes: Vec<Pane>,
}

impl ActionState<'_> {
    /// Whether a command would do anything now.
    pub fn enabled(&self, command: &Command) -> bool {
        let document = &self.state.document;
        match command {
            Command::Edit(EditCommand::Undo) => self.state.history.can_undo(),
            Command::Edit(EditCommand::Redo) => self.state.history.can_redo(),
            Command::Edit(command) => self.edits(command),
            Command::Transport(TransportCommand::TransportToOther) => document.compared().is_some(),
            Command::Transport(TransportCommand::StopTransport) => {
                document.visible_transport().is_some()
            }
            Command::Playback(PlaybackCommand::SetLoopRange(None)) => document.loop_range.is_some(),
            Command::Map(MapCommand::SetClassesBy(by)) => {
                document.classes_by() == *by || document.study().has_other_classes_than_labels()
            }
            Command::View(ViewCommand::SetQuantity(Quantity::Contribution)) => {
                document.compared_on_screen().is_some()
            }
            Command::View(ViewCommand::SetQuantity(Quantity::MotionDifference)) => {
                document.visible_transport().is_some()
            }
            Command::File(FileCommand::ChooseFiles)
            | Command::File(FileCommand::ChooseFolder)
            | Command::File(FileCommand::Open(_))
            | Command::File(FileCommand::OpenBuiltIn)
            | Command::File(FileCommand::FollowLinks)
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
            Command::Images(_) | Command::Import(_) => document.shown_series().is_some(),
            Command::Playback(_) if document.shown_series().is_some() => true,
            Command::Classifier(ClassifierCommand::Forget) => document.rule.is_some(),
            Command::Classifier(ClassifierCommand::Export(_))
            | Command::File(FileCommand::ExportStudy(_) | FileCommand::ChooseFilesToAdd)
            | Command::File(FileCommand::ChooseFolderToAdd) => {
                !document.study().subjects.is_empty() && document.study().unread.is_empty()
            }
            _ => !document.study().subjects.is_empty(),
        }
    }

    /// Whether an edit of the selected subject would do anything.
    fn edits(&self, command: &EditCommand) -> bool {
        let document = &self.state.document;
        let Some(subject) = document.selected() else {
            return false;
        };
        let excluded = document.study().is_excluded(document.subject);
        match command {
            EditCommand::SetClass(..) => subject.label.is_some(),
            EditCommand::Exclude(_) | EditCommand::Include(_) | EditCommand::Delete(_)
                if !document.study().unread.is_empty() =>
            {
                false
            }
            EditCommand::Exclude(_) => !excluded && document.study().subjects.len() > 1,
            EditCommand::Include(_) => excluded,
            EditCommand::Delete(_) => excluded || document.study().subjects.len() > 1,
            EditCommand::SetLandmark(_) => self.state.picked.is_some(),
            EditCommand::ClearLandmarks(_) => subject.has_landmarks(),
            EditCommand::SetPhase(_, phase, PhaseFrame::Found) => stated(subject, *phase).is_some(),
            _ => true,
        }
    }

    /// Whether a switch is on; `None` for what is no switch.
    pub fn checked(&self, command: &Command) -> Option<bool> {
        match command {
            Command::Window(WindowCommand::TogglePane(pane)) => {
                Some(!self.hidden_panes.contains(pane))
            }
            _ => is_on(self.state, command),
        }
    }
}

/// The frame of a phase that the user or the study set.
fn stated(subject: &Subject, phase: Phase) -> Option<usize> {
    match phase {
        Phase::EndDiastole => subject.end_diastole,
        Phase::EndSystole => subject.end_systole,
    }
}

/// Whether a switch that is no pane is on; `None` for what is no switch.
pub fn is_on(state: &State, command: &Command) -> Option<bool> {
    let document = &state.document;
    let visible = &document.visibility;
    Some(match command {
        Command::View(ViewCommand::SetViewMode(mode)) => document.view_mode == *mode,
        Command::View(ViewCommand::SetQuantity(quantity)) => document.quantity == *quantity,
        Command::View(ViewCommand::SetShading(shading)) => visible.shading == *shading,
        Command::View(ViewCommand::ToggleFreeCamera) => document.free_camera,
        Command::View(ViewCommand::ToggleEndocardium) => visible.endocardium,
        Command::View(ViewCommand::ToggleEpicardium) => visible.epicardium,
        Command::View(ViewCommand::ToggleWireframe) => visible.wireframe,
        Command::View(ViewCommand::ToggleVertices) => visible.vertices,
        Command::Wall(WallCommand::ToggleAtoms) => visible.atoms,
        Command::Wall(WallCommand::ToggleSpokes) => visible.spokes,
        Command::Wall(WallCommand::TogglePatches) => visible.patches,
        Command::Wall(WallCommand::ToggleDirection) => visible.direction,
        Command::Wall(WallCommand::SetBullsEye(quantity)) => document.bulls_eye == *quantity,
        Command::Wall(WallCommand::ToggleBullsEyeSegments) => document.bulls_eye_segments,
        Command::Transport(TransportCommand::SetInterpolatedPoses(count)) => {
            document.interpolated_poses == *count
        }
        Command::Map(MapCommand::SetMetric(kind)) => document.map.distances.metric.kind == *kind,
        // Isomap is Isomap, whatever its neighbours.
        Command::Map(MapCommand::SetMapMethod(method)) => {
            discriminant(&document.map.method) == discriminant(method)
        }
        Command::Map(MapCommand::SetComparison(comparison)) => {
            document.deformation_map.comparison.name() == comparison.name()
        }
        Command::Map(MapCommand::SetClassesBy(by)) => document.classes_by() == *by,
        Command::Map(MapCommand::ToggleClusters) => document.shows_clusters,
        Command::Edit(EditCommand::SetClass(_, class)) => {
            let labelled = document
                .selected()
                .filter(|subject| subject.label.is_some());
            labelled.is_some_and(|subject| document.study().class_of(subject) == *class)
        }
        Command::Edit(EditCommand::SetUnit(Whose::All, unit)) => {
            let mut all = document.study().all();
            document.study().count() > 0 && all.all(|subject| subject.coordinate_unit() == *unit)
        }
        Command::Edit(EditCommand::SetUnit(_, unit)) => {
            (document.selected()).is_some_and(|subject| subject.coordinate_unit() == *unit)
        }
        Command::Images(ImagesCommand::ToggleOutlines) => document.slices.outlines,
        Command::Import(ImportCommand::UseTool(tool)) => {
            state.image_tool.is_some() && state.image_tool == *tool
        }
        Command::Import(ImportCommand::ToggleBatch) => document.import.batch,
        Command::Images(ImagesCommand::ToggleSmooth) => document.slices.smooth,
        Command::Playback(PlaybackCommand::ToggleLoop) => state.play.repeat,
        Command::Window(WindowCommand::SetTheme(theme)) => state.theme == *theme,
        Command::Window(WindowCommand::ToggleFullScreen) => state.full_screen,
        _ => return None,
    })
}
