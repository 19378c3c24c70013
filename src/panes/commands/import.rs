//! Commands about the import of images: steps, settings, tools, and the subject that comes of them.

use std::sync::Arc;

use super::action::{Menu, Row, row};
use crate::analysis::preparation::Preparation;
use crate::document::{ImageTool, ImportStep};

/// Commands about the import of images.
#[derive(Clone, Debug, PartialEq)]
pub enum ImportCommand {
    /// Open a step.
    GoTo(ImportStep),
    /// One step on or back.
    Step(i32),
    /// The settings of images.
    Set {
        /// Index of the images.
        images: usize,
        /// Their settings.
        settings: Arc<Preparation>,
        /// Whether it is part of a drag, which is one step of undo.
        drag: bool,
    },
    /// The settings of these images as they were proposed.
    Reset(usize),
    /// Give all images the settings of one; each keeps its own points, edits and outlines.
    SetAll {
        /// Their settings, one for each of the images.
        settings: Vec<Arc<Preparation>>,
    },
    /// What a click into a slice does; `None` moves the crosshair.
    UseTool(Option<ImageTool>),
    /// Radius of the eraser in millimetres.
    SetEraser(f64),
    /// Make the walls of all images, or of those on screen alone.
    ToggleBatch,
    /// Put the walls that were made of images by these settings into the study: a further subject, or the surfaces of the one
    /// of its name.
    Add(Vec<(usize, Arc<Preparation>)>),
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<ImportCommand>] = &[
    row(Menu::Analysis, 4, "Import: next step", None, ImportCommand::Step(1)),
    row(Menu::Analysis, 4, "Import: step back", None, ImportCommand::Step(-1)),
    row(Menu::Analysis, 4, "Import: mark the apex", None, ImportCommand::UseTool(Some(ImageTool::Apex))),
    row(Menu::Analysis, 4, "Import: mark the base", None, ImportCommand::UseTool(Some(ImageTool::Base))),
    row(Menu::Analysis, 4, "Import: mark the septum", None, ImportCommand::UseTool(Some(ImageTool::Septum))),
    row(Menu::Analysis, 4, "Import: mark the blood", None, ImportCommand::UseTool(Some(ImageTool::Blood))),
    row(Menu::Analysis, 4, "Import: eraser", None, ImportCommand::UseTool(Some(ImageTool::Eraser))),
    row(Menu::Analysis, 4, "Import: cut plane", None, ImportCommand::UseTool(Some(ImageTool::Cut))),
    row(Menu::Analysis, 4, "Import: walls of all images", None, ImportCommand::ToggleBatch),
];
