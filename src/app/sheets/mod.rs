//! What lies over the window: sheets and cards.

mod about;
mod command_palette;
mod error_cards;
mod figure_sheet;
mod leaving;
mod load_report;
mod path_sheet;
pub(crate) mod report_view;
mod shortcut_sheet;

pub use {
    about::*, command_palette::*, error_cards::*, leaving::*, load_report::*, shortcut_sheet::*,
};
pub use {figure_sheet::*, path_sheet::*};
