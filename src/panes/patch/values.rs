//! What the pane of patches shows, as plain values.

use crate::engine::ThickeningSettings;
use crate::picture::PatchStanding;
use crate::render::Camera;
use crate::report::PatchRow;

/// State of the thickening of the selected subject.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum WallState {
    /// No subject is selected.
    #[default]
    Empty,
    /// What is shown is that of the settings.
    Ready,
    /// It is being computed; what is shown, if anything, is that of the settings before.
    Computing {
        /// Done share in `0..=1`.
        fraction: f32,
    },
    /// The user stopped it.
    Stopped,
    /// The wall cannot be assessed, and why.
    NotAssessed(String),
}

/// One patch.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatchLine {
    /// Its numbers.
    pub row: PatchRow,
    /// Segments in words, or why there are none.
    pub segments: String,
    /// Whether it is selected.
    pub selected: bool,
    /// The camera that looks at it, in the heart's axes; `None` while the heart is not on screen.
    pub camera: Option<Camera>,
}

/// What the pane shows.
#[derive(Clone, Debug)]
pub struct PatchPanelView<'a> {
    /// The selected subject.
    pub subject: Option<&'a str>,
    /// State of its measurement.
    pub state: &'a WallState,
    /// What the parts may be called.
    pub standing: PatchStanding,
    /// "1 patch · 31 % of the LV"; empty while nothing is known.
    pub heading: &'a str,
    /// What the whole wall does.
    pub note: &'a str,
    /// The patches, by falling area.
    pub rows: &'a [PatchLine],
    /// The thresholds.
    pub settings: ThickeningSettings,
    /// Standard deviation of the noise of ln r.
    pub noise: Option<f64>,
    /// Tolerance of |ln PT| in force.
    pub tolerance: Option<f64>,
    /// Thickening of remote myocardium, 0.5 for 50 %.
    pub well: Option<f64>,
}
