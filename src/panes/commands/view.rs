//! Commands about what is seen, and from where.

use super::action::{Menu, NONE, Row, row};
use crate::document::{CohortColumn, ViewMode};
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
    SortCohort(CohortColumn),
    /// Show what a picture shows.
    RestoreView(Box<SavedView>),
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<ViewCommand>] = &[
    row(Menu::View, 0, "3D view", None, ViewCommand::SetViewMode(ViewMode::Single)),
    row(Menu::View, 0, "Side by side", None, ViewCommand::SetViewMode(ViewMode::SideBySide)),
    row(Menu::View, 0, "All frames", None, ViewCommand::SetViewMode(ViewMode::AllFrames)),
    row(Menu::View, 1, "From anterior", Some((NONE, Key::Num1)), ViewCommand::ViewFrom(AnatomicalView::Anterior)),
    row(Menu::View, 1, "From inferior", Some((NONE, Key::Num2)), ViewCommand::ViewFrom(AnatomicalView::Inferior)),
    row(Menu::View, 1, "From septal", Some((NONE, Key::Num3)), ViewCommand::ViewFrom(AnatomicalView::Septal)),
    row(Menu::View, 1, "From lateral", Some((NONE, Key::Num4)), ViewCommand::ViewFrom(AnatomicalView::Lateral)),
    row(Menu::View, 1, "From apex", Some((NONE, Key::Num5)), ViewCommand::ViewFrom(AnatomicalView::Apex)),
    row(Menu::View, 1, "From base", Some((NONE, Key::Num6)), ViewCommand::ViewFrom(AnatomicalView::Base)),
    row(Menu::View, 1, "Fit to view", Some((NONE, Key::Num0)), ViewCommand::FitView),
    row(Menu::View, 1, "Free rotation", None, ViewCommand::ToggleFreeCamera),
    row(Menu::View, 2, "Endocardium", Some((NONE, Key::S)), ViewCommand::ToggleEndocardium),
    row(Menu::View, 2, "Epicardium", Some((NONE, Key::W)), ViewCommand::ToggleEpicardium),
    row(Menu::View, 2, "Edges", None, ViewCommand::ToggleWireframe),
    row(Menu::View, 2, "Vertices", None, ViewCommand::ToggleVertices),
    row(Menu::View, 3, "Next colour quantity", Some((NONE, Key::C)), ViewCommand::NextQuantity),
    row(Menu::View, 3, "Colour: tissue", None, ViewCommand::SetQuantity(Quantity::Tissue)),
    row(Menu::View, 3, "Colour: displacement", None, ViewCommand::SetQuantity(Quantity::Displacement)),
    row(Menu::View, 3, "Colour: area ratio", None, ViewCommand::SetQuantity(Quantity::AreaRatio)),
    row(Menu::View, 3, "Colour: thickness ratio", None, ViewCommand::SetQuantity(Quantity::ThicknessRatio)),
    row(Menu::View, 3, "Colour: contribution to the distance", Some((NONE, Key::D)), ViewCommand::SetQuantity(Quantity::Contribution)),
    row(Menu::View, 3, "Colour: difference from own motion", None, ViewCommand::SetQuantity(Quantity::MotionDifference)),
];
