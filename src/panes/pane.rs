//! What the window knows of a pane: its name, its place, and how it is drawn.

use egui::Ui;

use super::commands::{Command, Pane};
use super::figure::PaneFigure;
use super::pane_context::PaneContext;

/// Draws a part of a pane: it may look, and push commands.
pub type Draw = fn(&mut Ui, &PaneContext<'_>, &mut Vec<Command>);

/// One pane. Adding one takes a folder with such a value, and a line in [`PANES`](super::PANES).
#[derive(Clone, Copy, Debug)]
pub struct PaneSpec {
    /// The word that saved layouts know it by; it never changes.
    pub pane: Pane,
    /// The word on its tab.
    pub title: &'static str,
    /// The action that shows or hides it.
    pub toggle: &'static str,
    /// The action that opens it from the menu *Analysis*, with its group there.
    pub open: Option<(u8, &'static str)>,
    /// Where a fresh layout has it: panes of one place are tabs of one strip, in the order of the table.
    pub place: Place,
    /// What stands in its header.
    pub header: Header,
    /// What it can be exported as, beside what the 3D view is.
    pub figure: Option<PaneFigure>,
    /// What stands in it.
    pub ui: Draw,
}

/// The strips of tabs of a fresh layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// The left column.
    Left,
    /// The middle of the window.
    Middle,
    /// The right column, above.
    Above,
    /// The right column, below on the left.
    BelowLeft,
    /// The right column, below on the right.
    BelowRight,
}

/// Draws what stands right of the title or the tabs, which take so many points of the width.
pub type DrawBeside = fn(&mut Ui, &PaneContext<'_>, f32, &mut Vec<Command>);

/// What stands in the header of a pane.
#[derive(Clone, Copy, Debug)]
pub enum Header {
    /// Its title alone.
    Title,
    /// Its title, and something drawn at the right.
    Beside(DrawBeside),
    /// The same with the title as plain words, where no tabs stand in place of it.
    Named(DrawBeside),
    /// A header of its own, even below tabs.
    Always(Draw),
}
