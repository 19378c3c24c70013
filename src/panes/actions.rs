//! Every action once: its name, its key, its menu; menus, palette and shortcut sheet read this table.

use egui::{Key, KeyboardShortcut, Modifiers};

use crate::analysis::embedding::MapMethod;
use crate::analysis::metrics::MetricKind;
use crate::panes::command::{Command, Pane, ThemeChoice, ViewMode};
use crate::picture::Quantity;
use crate::picture::{AnatomicalView, BullsEyeQuantity};

/// A menu of the bar; also the group in the sheet of shortcuts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Menu {
    /// Opening and leaving.
    File,
    /// Undo and selection.
    Edit,
    /// What is seen, and from where.
    View,
    /// Playback and analyses.
    Analysis,
    /// What leaves the program.
    Export,
    /// How it is used.
    Help,
}

impl Menu {
    /// All menus in the order of the bar.
    pub const ALL: [Self; 6] = [
        Self::File,
        Self::Edit,
        Self::View,
        Self::Analysis,
        Self::Export,
        Self::Help,
    ];

    /// The title in the menu bar.
    pub fn name(self) -> &'static str {
        match self {
            Self::File => "File",
            Self::Edit => "Edit",
            Self::View => "View",
            Self::Analysis => "Analysis",
            Self::Export => "Export",
            Self::Help => "Help",
        }
    }
}

/// One thing that can be done.
#[derive(Clone, Debug)]
pub struct Action {
    /// Sentence case; ends in `…` when it asks for more.
    pub name: &'static str,
    /// Its menu.
    pub menu: Menu,
    /// Groups of a menu are divided by a line.
    pub group: u8,
    /// The key that does it.
    pub shortcut: Option<KeyboardShortcut>,
    /// What it does.
    pub command: Command,
}

const NONE: Modifiers = Modifiers::NONE;
const CTRL: Modifiers = Modifiers::COMMAND;
const SHIFT: Modifiers = Modifiers::SHIFT;

const fn action(
    menu: Menu,
    group: u8,
    name: &'static str,
    shortcut: Option<(Modifiers, Key)>,
    command: Command,
) -> Action {
    let shortcut = match shortcut {
        Some((modifiers, key)) => Some(KeyboardShortcut::new(modifiers, key)),
        None => None,
    };
    Action {
        name,
        menu,
        group,
        shortcut,
        command,
    }
}

/// All actions that need no more than a name. One line each: a table is read as a table.
#[rustfmt::skip]
pub static ACTIONS: &[Action] = &[
    action(Menu::File, 0, "Open files…", Some((CTRL, Key::O)), Command::ChooseFiles),
    action(Menu::File, 0, "Open folder…", Some((CTRL.plus(SHIFT), Key::O)), Command::ChooseFolder),
    action(Menu::File, 0, "Open the built-in cohort", None, Command::OpenBuiltIn),
    action(Menu::File, 1, "Load report", Some((CTRL, Key::L)), Command::ToggleLoadReport),
    action(Menu::File, 2, "Quit", Some((CTRL, Key::Q)), Command::Quit),
    action(Menu::Edit, 0, "Undo", Some((CTRL, Key::Z)), Command::Undo),
    action(Menu::Edit, 0, "Redo", Some((CTRL.plus(SHIFT), Key::Z)), Command::Redo),
    action(Menu::Edit, 1, "Next subject", Some((NONE, Key::Tab)), Command::StepSubject(1)),
    action(Menu::Edit, 1, "Previous subject", Some((SHIFT, Key::Tab)), Command::StepSubject(-1)),
    action(Menu::View, 0, "3D view", None, Command::SetViewMode(ViewMode::Single)),
    action(Menu::View, 0, "Side by side", None, Command::SetViewMode(ViewMode::SideBySide)),
    action(Menu::View, 0, "All frames", None, Command::SetViewMode(ViewMode::AllFrames)),
    action(Menu::View, 1, "From anterior", Some((NONE, Key::Num1)), Command::ViewFrom(AnatomicalView::Anterior)),
    action(Menu::View, 1, "From inferior", Some((NONE, Key::Num2)), Command::ViewFrom(AnatomicalView::Inferior)),
    action(Menu::View, 1, "From septal", Some((NONE, Key::Num3)), Command::ViewFrom(AnatomicalView::Septal)),
    action(Menu::View, 1, "From lateral", Some((NONE, Key::Num4)), Command::ViewFrom(AnatomicalView::Lateral)),
    action(Menu::View, 1, "From apex", Some((NONE, Key::Num5)), Command::ViewFrom(AnatomicalView::Apex)),
    action(Menu::View, 1, "From base", Some((NONE, Key::Num6)), Command::ViewFrom(AnatomicalView::Base)),
    action(Menu::View, 1, "Fit to view", Some((NONE, Key::Num0)), Command::FitView),
    action(Menu::View, 1, "Free rotation", None, Command::ToggleFreeCamera),
    action(Menu::View, 2, "Endocardium", Some((NONE, Key::S)), Command::ToggleEndocardium),
    action(Menu::View, 2, "Epicardium", Some((NONE, Key::W)), Command::ToggleEpicardium),
    action(Menu::View, 2, "Edges", None, Command::ToggleWireframe),
    action(Menu::View, 2, "Vertices", None, Command::ToggleVertices),
    action(Menu::View, 2, "Medial atoms", Some((NONE, Key::M)), Command::ToggleAtoms),
    action(Menu::View, 2, "Spokes of the atoms", None, Command::ToggleSpokes),
    action(Menu::View, 2, "Patch outlines", Some((NONE, Key::P)), Command::TogglePatches),
    action(Menu::View, 2, "ANV and MP of the patch", None, Command::ToggleDirection),
    action(Menu::View, 3, "Next colour quantity", Some((NONE, Key::C)), Command::NextQuantity),
    action(Menu::View, 3, "Colour: tissue", None, Command::SetQuantity(Quantity::Tissue)),
    action(Menu::View, 3, "Colour: displacement", None, Command::SetQuantity(Quantity::Displacement)),
    action(Menu::View, 3, "Colour: area ratio", None, Command::SetQuantity(Quantity::AreaRatio)),
    action(Menu::View, 3, "Colour: thickness ratio", None, Command::SetQuantity(Quantity::ThicknessRatio)),
    action(Menu::View, 3, "Colour: contribution to the distance", Some((NONE, Key::D)), Command::SetQuantity(Quantity::Contribution)),
    action(Menu::View, 3, "Colour: difference from own motion", None, Command::SetQuantity(Quantity::CarriedDistance)),
    action(Menu::View, 3, "Next bull's-eye quantity", Some((NONE, Key::B)), Command::NextBullsEye),
    action(Menu::View, 3, "Bull's-eye: PT of this pose", None, Command::SetBullsEye(BullsEyeQuantity::Ratio)),
    action(Menu::View, 3, "Bull's-eye: thickening", None, Command::SetBullsEye(BullsEyeQuantity::Thickening)),
    action(Menu::View, 3, "Bull's-eye: displacement", None, Command::SetBullsEye(BullsEyeQuantity::Displacement)),
    action(Menu::View, 3, "Bull's-eye: area ratio", None, Command::SetBullsEye(BullsEyeQuantity::AreaRatio)),
    action(Menu::View, 3, "Bull's-eye: segment values", None, Command::ToggleBullsEyeSegments),
    action(Menu::View, 4, "Theme: system", None, Command::SetTheme(ThemeChoice::System)),
    action(Menu::View, 4, "Theme: dark", None, Command::SetTheme(ThemeChoice::Dark)),
    action(Menu::View, 4, "Theme: light", None, Command::SetTheme(ThemeChoice::Light)),
    action(Menu::View, 5, "Pane: cohort", None, Command::TogglePane(Pane::Cohort)),
    action(Menu::View, 5, "Pane: activity", None, Command::TogglePane(Pane::Activity)),
    action(Menu::View, 5, "Pane: poses", None, Command::TogglePane(Pane::PoseMap)),
    action(Menu::View, 5, "Pane: deformations", None, Command::TogglePane(Pane::DeformationMap)),
    action(Menu::View, 5, "Pane: spatiotemporal plot", None, Command::TogglePane(Pane::SpaceTime)),
    action(Menu::View, 5, "Pane: medial map", None, Command::TogglePane(Pane::MedialMap)),
    action(Menu::View, 5, "Pane: metric", None, Command::TogglePane(Pane::Metric)),
    action(Menu::View, 5, "Pane: volume", None, Command::TogglePane(Pane::Curves)),
    action(Menu::View, 5, "Pane: measures", None, Command::TogglePane(Pane::Measures)),
    action(Menu::View, 5, "Pane: patch", None, Command::TogglePane(Pane::Patch)),
    action(Menu::View, 5, "Pane: verdict", None, Command::TogglePane(Pane::Verdict)),
    action(Menu::View, 5, "Pane: bull's-eye", None, Command::TogglePane(Pane::BullsEye)),
    action(Menu::View, 5, "Pane: thickness", None, Command::TogglePane(Pane::Thickness)),
    action(Menu::View, 5, "Reset layout", None, Command::ResetLayout),
    action(Menu::View, 6, "Full screen", Some((NONE, Key::F11)), Command::ToggleFullScreen),
    action(Menu::Analysis, 0, "Play or pause", Some((NONE, Key::Space)), Command::TogglePlay),
    action(Menu::Analysis, 0, "Loop", None, Command::ToggleLoop),
    action(Menu::Analysis, 0, "Next frame", Some((NONE, Key::ArrowRight)), Command::StepFrame(1)),
    action(Menu::Analysis, 0, "Previous frame", Some((NONE, Key::ArrowLeft)), Command::StepFrame(-1)),
    action(Menu::Analysis, 0, "Next pose, recorded or interpolated", Some((NONE, Key::Period)), Command::StepPose(1)),
    action(Menu::Analysis, 0, "Previous pose, recorded or interpolated", Some((NONE, Key::Comma)), Command::StepPose(-1)),
    action(Menu::Analysis, 0, "Go to end-diastole", Some((SHIFT, Key::ArrowLeft)), Command::GoToEndDiastole),
    action(Menu::Analysis, 0, "Go to end-systole", Some((SHIFT, Key::ArrowRight)), Command::GoToEndSystole),
    action(Menu::Analysis, 1, "End-diastole from the volume curve", None, Command::StateEndDiastole(None)),
    action(Menu::Analysis, 1, "End-systole from the volume curve", None, Command::StateEndSystole(None)),
    action(Menu::Analysis, 2, "Map of poses", None, Command::ShowPane(Pane::PoseMap)),
    action(Menu::Analysis, 2, "Map of deformations", None, Command::ShowPane(Pane::DeformationMap)),
    action(Menu::Analysis, 2, "Spatiotemporal plot (3D)", None, Command::ShowPane(Pane::SpaceTime)),
    action(Menu::Analysis, 2, "Medial map", None, Command::ShowPane(Pane::MedialMap)),
    action(Menu::Analysis, 2, "Clusters of deformations", None, Command::ToggleClusters),
    action(Menu::Analysis, 3, "Metric and maps…", None, Command::ShowPane(Pane::Metric)),
    action(Menu::Analysis, 3, "Metric: quasi-conformal", None, Command::SetMetric(MetricKind::QuasiConformal)),
    action(Menu::Analysis, 3, "Metric: angle-preserving", None, Command::SetMetric(MetricKind::AnglePreserving)),
    action(Menu::Analysis, 3, "Metric: isometric", None, Command::SetMetric(MetricKind::Isometric)),
    action(Menu::Analysis, 3, "Metric: rigid", None, Command::SetMetric(MetricKind::Rigid)),
    action(Menu::Analysis, 3, "Map of poses by SMACOF", None, Command::SetMapMethod(MapMethod::Smacof)),
    action(Menu::Analysis, 3, "Map of poses by classical MDS", None, Command::SetMapMethod(MapMethod::ClassicalMds)),
    action(Menu::Analysis, 3, "Map of poses by Isomap", None, Command::SetMapMethod(MapMethod::ISOMAP)),
    action(Menu::Analysis, 3, "Reset metric and maps", None, Command::ResetMaps),
    action(Menu::Analysis, 3, "Patch table and thresholds", None, Command::ShowPane(Pane::Patch)),
    action(Menu::Analysis, 3, "Verdict", None, Command::ShowPane(Pane::Verdict)),
    action(Menu::Analysis, 3, "Bull's-eye", None, Command::ShowPane(Pane::BullsEye)),
    action(Menu::Analysis, 3, "Wall thickness by five methods", None, Command::ShowPane(Pane::Thickness)),
    action(Menu::Analysis, 3, "Reset patch thresholds", None, Command::ResetThickening),
    action(Menu::Analysis, 4, "Interpolated poses: off", None, Command::SetInBetweens(0)),
    action(Menu::Analysis, 4, "Interpolated poses: 1 per interval", None, Command::SetInBetweens(1)),
    action(Menu::Analysis, 4, "Interpolated poses: 3 per interval", None, Command::SetInBetweens(3)),
    action(Menu::Analysis, 4, "Interpolated poses: 7 per interval", None, Command::SetInBetweens(7)),
    action(Menu::Analysis, 5, "Transport motion to the other subject", Some((NONE, Key::T)), Command::TransportToOther),
    action(Menu::Analysis, 5, "Show own motion", None, Command::StopTransport),
    action(Menu::Export, 0, "Patch figure…", Some((NONE, Key::F2)), Command::ExportPatchFigure(None)),
    action(Menu::Export, 0, "Figure of the 3D view…", Some((SHIFT, Key::F2)), Command::ExportFigure(None)),
    action(Menu::Export, 0, "Tables…", Some((CTRL, Key::E)), Command::ExportTables(None)),
    action(Menu::Help, 0, "Find a command", Some((CTRL, Key::K)), Command::TogglePalette),
    action(Menu::Help, 0, "Keyboard shortcuts", Some((NONE, Key::Questionmark)), Command::ToggleShortcuts),
    action(Menu::Help, 1, "About Cardiomorph", None, Command::ToggleAbout),
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn no_two_actions_share_a_name_or_a_key() {
        let mut names = HashSet::new();
        let mut keys = HashSet::new();
        for action in ACTIONS {
            assert!(names.insert(action.name), "{}", action.name);
            if let Some(shortcut) = action.shortcut {
                assert!(keys.insert(format!("{shortcut:?}")), "{}", action.name);
            }
        }
    }
}
