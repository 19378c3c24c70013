//! Commands about the images of the study: which are looked at, where, and how bright.

use super::action::{Menu, NONE, Row, row};
use crate::document::GreyWindow;
use crate::mesh::Point3;
use egui::Key;

/// Commands about the images of the study.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ImagesCommand {
    /// Show the images of this index, and select their subject if there is one.
    Show(usize),
    /// Show another of their series.
    ShowSeries(usize),
    /// Where the three slices cross, in the world of the image (LPS, millimetres).
    MoveTo(Point3),
    /// So many of the acquired slices on or back.
    StepSlice(i32),
    /// Which values are black and white; `None` as the values themselves suggest.
    SetWindow(Option<GreyWindow>),
    /// Show or hide the outlines of the surfaces over the slices.
    ToggleOutlines,
    /// Blend grey values between voxels, or show voxels as they are.
    ToggleSmooth,
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<ImagesCommand>] = &[
    row(Menu::View, 7, "Images: next slice", Some((NONE, Key::ArrowDown)), ImagesCommand::StepSlice(1)),
    row(Menu::View, 7, "Images: previous slice", Some((NONE, Key::ArrowUp)), ImagesCommand::StepSlice(-1)),
    row(Menu::View, 7, "Images: outlines of the surfaces", None, ImagesCommand::ToggleOutlines),
    row(Menu::View, 7, "Images: blend between voxels", None, ImagesCommand::ToggleSmooth),
    row(Menu::View, 7, "Images: reset window and level", None, ImagesCommand::SetWindow(None)),
];
