//! What the time bar shows, as plain values.

use crate::panes::cycle_axis::CycleAxis;

/// What the time bar shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TimeBarView {
    /// Whether the motion plays.
    pub playing: bool,
    /// Speed relative to the recorded motion.
    pub speed: f32,
    /// Whether playing starts over.
    pub looping: bool,
    /// First and last frame of the part that plays, where not all of the cycle does.
    pub loop_frames: Option<[usize; 2]>,
    /// Whether Esc ends that part: a filter of the cohort goes first.
    pub escape_ends_range: bool,
    /// Position in frames, in `0..frame_count`.
    pub position: f64,
    /// Times of the frames within the cycle.
    pub axis: CycleAxis,
    /// Frame of end-diastole.
    pub end_diastole: Option<usize>,
    /// Frame of end-systole.
    pub end_systole: Option<usize>,
    /// Time after the R peak, where the study states it.
    pub time_ms: Option<f64>,
    /// Length of the cycle (R-R), where the study states it.
    pub cycle_ms: Option<f64>,
    /// What is shown between frames, such as `interpolated`; `None` on a frame.
    pub between: Option<&'static str>,
    /// Positions of interpolated poses, ascending; each has a small mark.
    pub interpolated_poses: Vec<f64>,
    /// More about the interpolated poses, for whoever points at the line; may be empty.
    pub note: String,
}
