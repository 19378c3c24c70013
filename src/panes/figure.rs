//! The figure of a pane: what it shows as a page, fixed at the moment it is asked for.

use std::sync::Arc;

use crate::engine::MeasuresQuery;
use crate::picture::plot::PlotFigure;

use super::pane_context::PaneContext;

/// What a pane can be exported as.
#[derive(Clone, Copy, Debug)]
pub struct PaneFigure {
    /// The action of the menu Export.
    pub action: &'static str,
    /// What the dialog is called that asks for its place.
    pub save: &'static str,
    /// What a card says where there is none.
    pub none: &'static str,
    /// What it holds now, or why there is none; it asks for nothing that is not computed.
    pub content: fn(&PaneContext<'_>) -> Result<PlotFigure, String>,
}

/// Why a pane has no figure while its answer is not there.
pub fn not_computed() -> String {
    "it is not computed yet with these settings: open its pane and wait until it is".to_owned()
}

/// Whether the volumes on screen are those of the study as it is now: end-diastole and end-systole are read from them.
///
/// # Errors
/// If they are still being measured.
pub fn check_measured(cx: &PaneContext<'_>) -> Result<(), String> {
    let (shown, known) = (cx.state().measures(), cx.known(&MeasuresQuery));
    match (shown, known) {
        (Some(shown), Some(known)) if Arc::ptr_eq(shown, &known) => Ok(()),
        _ => Err("volumes are still being measured: try again when they are known".to_owned()),
    }
}
