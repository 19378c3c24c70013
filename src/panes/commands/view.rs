//! Commands about what is seen, and from where.

use super::Command;
use super::action::{Action, Menu, NONE, action};
use crate::document::ViewMode;
use crate::picture::AnatomicalView;
use crate::picture::Quantity;
use crate::picture::figure::SavedView;
use crate::render::Camera;
use crate::render::Shading;
use egui::Key;

/// Commands about what is seen, and from where.
#[derive(Clone, Debug, PartialEq)]
pub enum ViewCommand {
    /// One subject, two, or all frames of one.
    SetViewMode(ViewMode),
    /// Move the camera; `drag` groups the steps of one drag for undo.
    SetCamera {
        /// The new camera.
        camera: Camera,
        /// Whether a drag goes on.
        drag: bool,
    },
    /// Look from an anatomical direction.
    ViewFrom(AnatomicalView),
    /// Fit everything into view.
    FitView,
    /// Turntable, or free rotation.
    ToggleFreeCamera,
    /// Show or hide the endocardium.
    ToggleEndocardium,
    /// Show or hide the epicardium or the wall.
    ToggleEpicardium,
    /// Show or hide edges.
    ToggleWireframe,
    /// Show or hide vertices as discs.
    ToggleVertices,
    /// Smooth or flat.
    SetShading(Shading),
    /// The quantity shown in colour.
    SetQuantity(Quantity),
    /// The next quantity shown in colour.
    NextQuantity,
    /// Typed limits of the colours; `None` goes back to the fixed range.
    SetColourLimits(Option<[f64; 2]>),
    /// Filter the cohort table.
    SetSearch(String),
    /// Sort the cohort table by a column; again turns the order.
    SortCohort(usize),
    /// Show what a picture shows.
    RestoreView(Box<SavedView>),
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Action] = &[
    action(Menu::View, 0, "3D view", None, Command::View(ViewCommand::SetViewMode(ViewMode::Single))),
    action(Menu::View, 0, "Side by side", None, Command::View(ViewCommand::SetViewMode(ViewMode::SideBySide))),
    action(Menu::View, 0, "All frames", None, Command::View(ViewCommand::SetViewMode(ViewMode::AllFrames))),
    action(Menu::View, 1, "From anterior", Some((NONE, Key::Num1)), Command::View(ViewCommand::ViewFrom(AnatomicalView::Anterior))),
    action(Menu::View, 1, "From inferior", Some((NONE, Key::Num2)), Command::View(ViewCommand::ViewFrom(AnatomicalView::Inferior))),
    action(Menu::View, 1, "From septal", Some((NONE, Key::Num3)), Command::View(ViewCommand::ViewFrom(AnatomicalView::Septal))),
    action(Menu::View, 1, "From lateral", Some((NONE, Key::Num4)), Command::View(ViewCommand::ViewFrom(AnatomicalView::Lateral))),
    action(Menu::View, 1, "From apex", Some((NONE, Key::Num5)), Command::View(ViewCommand::ViewFrom(AnatomicalView::Apex))),
    action(Menu::View, 1, "From base", Some((NONE, Key::Num6)), Command::View(ViewCommand::ViewFrom(AnatomicalView::Base))),
    action(Menu::View, 1, "Fit to view", Some((NONE, Key::Num0)), Command::View(ViewCommand::FitView)),
    action(Menu::View, 1, "Free rotation", None, Command::View(ViewCommand::ToggleFreeCamera)),
    action(Menu::View, 2, "Endocardium", Some((NONE, Key::S)), Command::View(ViewCommand::ToggleEndocardium)),
    action(Menu::View, 2, "Epicardium", Some((NONE, Key::W)), Command::View(ViewCommand::ToggleEpicardium)),
    action(Menu::View, 2, "Edges", None, Command::View(ViewCommand::ToggleWireframe)),
    action(Menu::View, 2, "Vertices", None, Command::View(ViewCommand::ToggleVertices)),
    action(Menu::View, 3, "Next colour quantity", Some((NONE, Key::C)), Command::View(ViewCommand::NextQuantity)),
    action(Menu::View, 3, "Colour: tissue", None, Command::View(ViewCommand::SetQuantity(Quantity::Tissue))),
    action(Menu::View, 3, "Colour: displacement", None, Command::View(ViewCommand::SetQuantity(Quantity::Displacement))),
    action(Menu::View, 3, "Colour: area ratio", None, Command::View(ViewCommand::SetQuantity(Quantity::AreaRatio))),
    action(Menu::View, 3, "Colour: thickness ratio", None, Command::View(ViewCommand::SetQuantity(Quantity::ThicknessRatio))),
    action(Menu::View, 3, "Colour: contribution to the distance", Some((NONE, Key::D)), Command::View(ViewCommand::SetQuantity(Quantity::Contribution))),
    action(Menu::View, 3, "Colour: difference from own motion", None, Command::View(ViewCommand::SetQuantity(Quantity::CarriedDistance))),
];
