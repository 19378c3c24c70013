//! What the pane of patches shows, as plain values.

use crate::analysis::thickening::ThickeningSettings;
use crate::panes::work_state::WorkState;
use crate::picture::PatchStanding;
use crate::render::Camera;
use crate::report::PatchRow;

/// One patch.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatchLine {
    /// Its numbers.
    pub row: PatchRow,
    /// Segments in words, or why there are none.
    pub segments: String,
    /// Whether it is selected.
    pub selected: bool,
    /// The camera that looks at it, in the subject's axes; `None` while the subject is not on screen.
    pub camera: Option<Camera>,
}

/// What the pane shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatchPanelView<'a> {
    /// The selected subject.
    pub subject: Option<&'a str>,
    /// State of its measurement; a wall that cannot be assessed is unanswerable.
    pub state: WorkState,
    /// What the parts may be called.
    pub standing: PatchStanding,
    /// "1 patch · 31 % of the LV"; empty while nothing is known.
    pub heading: String,
    /// What the whole wall does.
    pub note: String,
    /// The patches, by falling area.
    pub rows: Vec<PatchLine>,
    /// The thresholds.
    pub settings: ThickeningSettings,
    /// Standard deviation of the noise of ln r.
    pub noise: Option<f64>,
    /// Tolerance of |ln PT| in force.
    pub tolerance: Option<f64>,
    /// Thickening of remote myocardium, 0.5 for 50 %.
    pub remote: Option<f64>,
}
