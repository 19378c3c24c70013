//! Commands about the wall: medial atoms, patches, segments, the bull's-eye.

use super::action::{Menu, NONE, Row, row};
use crate::analysis::thickening::ThickeningSettings;
use crate::picture::BullsEyeQuantity;
use crate::picture::WallPart;
use crate::render::Camera;
use egui::Key;

/// Commands about the wall: medial atoms, patches, segments, the bull's-eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WallCommand {
    /// Show or hide atoms of the medial surface.
    ToggleAtoms,
    /// Show or hide spokes from the atoms to the wall.
    ToggleSpokes,
    /// Show or hide the borders of patches.
    TogglePatches,
    /// Show or hide ANV and MP.
    ToggleDirection,
    /// Thresholds of patches.
    SetThickening(ThickeningSettings),
    /// Settings of patches as they were at the start.
    ResetThickening,
    /// Select a patch of this subject or a segment of every subject.
    SelectPart(Option<WallPart>),
    /// Select a patch and look at it.
    ShowPatch {
        /// Its place in the list.
        patch: usize,
        /// From where, in the axes of the subject.
        camera: Camera,
    },
    /// What the bull's-eye shows.
    SetBullsEye(BullsEyeQuantity),
    /// The next thing that the bull's-eye can show.
    NextBullsEye,
    /// One colour for each segment, or every place its own.
    ToggleBullsEyeSegments,
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<WallCommand>] = &[
    row(Menu::View, 2, "Medial atoms", Some((NONE, Key::M)), WallCommand::ToggleAtoms),
    row(Menu::View, 2, "Spokes of the atoms", None, WallCommand::ToggleSpokes),
    row(Menu::View, 2, "Patch outlines", Some((NONE, Key::P)), WallCommand::TogglePatches),
    row(Menu::View, 2, "ANV and MP of the patch", None, WallCommand::ToggleDirection),
    row(Menu::View, 3, "Next bull's-eye quantity", Some((NONE, Key::B)), WallCommand::NextBullsEye),
    row(Menu::View, 3, "Bull's-eye: PT of this pose", None, WallCommand::SetBullsEye(BullsEyeQuantity::ThicknessRatio)),
    row(Menu::View, 3, "Bull's-eye: thickening", None, WallCommand::SetBullsEye(BullsEyeQuantity::Thickening)),
    row(Menu::View, 3, "Bull's-eye: displacement", None, WallCommand::SetBullsEye(BullsEyeQuantity::Displacement)),
    row(Menu::View, 3, "Bull's-eye: area ratio", None, WallCommand::SetBullsEye(BullsEyeQuantity::AreaRatio)),
    row(Menu::View, 3, "Bull's-eye: segment values", None, WallCommand::ToggleBullsEyeSegments),
    row(Menu::Analysis, 3, "Reset patch thresholds", None, WallCommand::ResetThickening),
];
