//! What lies over the window: sheets and cards.

mod about;
mod command_palette;
mod error_cards;
mod load_report;
pub(crate) mod report_view;
mod shortcut_sheet;

pub use about::about_ui;
pub use command_palette::{CommandPaletteView, command_palette_ui};
pub use error_cards::error_cards_ui;
pub use load_report::{ReportSubject, load_report_ui};
pub use shortcut_sheet::shortcut_sheet_ui;
