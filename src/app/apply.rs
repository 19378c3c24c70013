//! The one place where commands change the state.

use std::path::PathBuf;

use crate::engine::OpenSource;
use crate::engine::Topic;
use crate::panes::{Command, Pane, ThemeChoice};
use crate::study::Revision;

use super::document::Document;
use super::export::FigureKind;
use super::state::State;
use super::undo::Gesture;
use super::{apply_beat, apply_carry, apply_view, apply_wall, apply_window, saved_views};

/// What surrounds a command.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    /// A clock that runs forward.
    pub now_s: f64,
    /// Whether a pointer button is down: changes of one drag are one step of undo.
    pub pointer_held: bool,
    /// A revision that no study has yet, for edits.
    pub fresh_revision: Revision,
}

/// What must be done outside the state.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Ask for files.
    ChooseFiles,
    /// Ask for a folder.
    ChooseFolder,
    /// Ask where a picture goes.
    ChooseFigure(FigureKind),
    /// Ask where tables go.
    ChooseTables,
    /// Read or make a study.
    Open(OpenSource),
    /// Write a picture.
    WriteFigure(FigureKind, PathBuf),
    /// Read the view that a picture carries.
    ReadPicture(PathBuf),
    /// Write all tables.
    WriteTables(PathBuf),
    /// Stop background work.
    Stop(Topic),
    /// Begin stopped or failed work again.
    Retry(Topic),
    /// Light or dark.
    SetTheme(ThemeChoice),
    /// Show or hide a tile.
    TogglePane(Pane),
    /// Open a tile, or bring it before other tabs.
    ShowPane(Pane),
    /// Put all tiles back.
    ResetLayout,
    /// Full screen or window.
    SetFullScreen(bool),
    /// Close the window.
    Quit,
}

/// Carries out one command; what reaches beyond the state comes back as effects.
pub fn apply(state: &mut State, command: Command, moment: &Moment) -> Vec<Effect> {
    use Command as C;
    match command {
        C::Undo => {
            let step = state.history.undo(&state.document);
            restore(state, step);
        }
        C::Redo => {
            let step = state.history.redo(&state.document);
            restore(state, step);
        }

        C::SelectPose { .. }
        | C::SelectSubject(_)
        | C::StepSubject(_)
        | C::CompareWith(_)
        | C::SetPosition(_)
        | C::StepFrame(_)
        | C::GoToEndDiastole
        | C::GoToEndSystole
        | C::StateEndDiastole(_)
        | C::StateEndSystole(_)
        | C::TogglePlay
        | C::SetSpeed(_)
        | C::ToggleLoop => apply_beat::apply(state, &command, moment),

        C::SetViewMode(_)
        | C::SetCamera { .. }
        | C::ViewFrom(_)
        | C::FitView
        | C::ToggleFreeCamera
        | C::ToggleEndocardium
        | C::ToggleEpicardium
        | C::ToggleWireframe
        | C::ToggleVertices
        | C::SetShading(_)
        | C::SetQuantity(_)
        | C::NextQuantity
        | C::SetColourLimits(_)
        | C::SetPoseMap(_)
        | C::SetMetric(_)
        | C::SetMapMethod(_)
        | C::SetDeformationMap(_)
        | C::ResetMaps
        | C::ToggleClusters
        | C::SetSearch(_)
        | C::SortCohort(_) => apply_view::apply(state, command, moment),

        C::ToggleAtoms
        | C::ToggleSpokes
        | C::TogglePatches
        | C::ToggleDirection
        | C::SetThickening(_)
        | C::ResetThickening
        | C::SelectPart(_)
        | C::ShowPatch { .. }
        | C::SetBullsEye(_)
        | C::NextBullsEye
        | C::ToggleBullsEyeSegments => apply_wall::apply(state, &command, moment),

        C::RestoreView(view) => saved_views::apply(state, &view, moment),

        C::TransportMotion { .. }
        | C::TransportToOther
        | C::StopTransport
        | C::SetInBetweens(_)
        | C::StepPose(_) => return apply_carry::apply(state, &command, moment),

        C::ChooseFiles
        | C::ChooseFolder
        | C::Open(_)
        | C::OpenBuiltIn
        | C::ExportFigure(_)
        | C::ExportPatchFigure(_)
        | C::ExportTables(_)
        | C::Retry(_)
        | C::Cancel(_)
        | C::DismissError(_)
        | C::SetTheme(_)
        | C::TogglePane(_)
        | C::ShowPane(_)
        | C::ResetLayout
        | C::TogglePalette
        | C::ToggleShortcuts
        | C::ToggleLoadReport
        | C::ToggleAbout
        | C::ToggleFullScreen
        | C::Quit => return apply_window::apply(state, command),
    }
    Vec::new()
}

/// Changes the document as one step of undo; a change that changes nothing leaves no step.
pub(super) fn change(
    state: &mut State,
    moment: &Moment,
    gesture: Option<Gesture>,
    edit: impl FnOnce(&mut Document),
) {
    let before = state.document.clone();
    edit(&mut state.document);
    state.document.end_carrying_out_of_sight();
    if state.document != before {
        state
            .history
            .record(before, gesture, moment.pointer_held, moment.now_s);
    }
}

fn restore(state: &mut State, step: Option<Document>) {
    if let Some(document) = step {
        state.document = document;
        state.play.playing = false;
    }
}
