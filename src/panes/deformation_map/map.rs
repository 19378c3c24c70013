//! The deformation map with the card below it.

use egui::Ui;

use crate::analysis::deformations::Comparison;
use crate::engine::ClassesBy;
use crate::panes::commands::Command;
use crate::panes::scatter_map::{ScatterView, scatter_map_ui};

use super::classes::{self, ClassesView};
use super::words::DeformationFit;

/// What the deformation map shows.
#[derive(Clone, Debug)]
pub struct DeformationMapView<'a> {
    /// Its points, and how the map stands.
    pub map: ScatterView<'a>,
    /// What of two beats is compared.
    pub comparison: Comparison,
    /// What the map keeps, and how well.
    pub fit: DeformationFit,
    /// How well classifiers find the labels.
    pub classes: ClassesView<'a>,
    /// What subjects are classified by, where the study offers labels and classes.
    pub classes_by: Option<ClassesBy>,
}

/// Draws the map with its legend and, below, how well classifiers find the labels.
pub fn deformation_map_ui(ui: &mut Ui, view: &DeformationMapView, commands: &mut Vec<Command>) {
    let card = classes::height(ui.available_size(), &view.classes);
    scatter_map_ui(ui, &view.map, card, commands);
    if card > 0.0 && !view.map.points.is_empty() {
        classes::classes_ui(ui, &view.classes, view.classes_by, card, commands);
    }
}
