//! Panels, plots and widgets: they draw prepared views and push commands.

mod command;

pub use command::{AnatomicalView, Command, JobKind, Pane, ThemeChoice, ViewMode};
