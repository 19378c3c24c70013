//! The panes of the window, by name.

/// A tile of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pane {
    /// The list of subjects.
    Cohort,
    /// Finished and running work.
    Activity,
    /// The 3D view.
    Viewport,
    /// The map of poses.
    PoseMap,
    /// The map of whole deformations.
    DeformationMap,
    /// The spatiotemporal plot: poses and time in three dimensions.
    SpaceTime,
    /// How poses and deformations are compared and mapped.
    Metric,
    /// Volumes over the cardiac cycle.
    Curves,
    /// Clinical measures of the selected subject.
    Measures,
    /// Regions of low thickening, and the thresholds.
    Patch,
    /// The verdict on the selected subject, with its evidence.
    Verdict,
    /// The polar map of the wall, by AHA segment.
    BullsEye,
    /// The map of the medial shape space.
    MedialMap,
    /// Wall thickness by several methods.
    Thickness,
}
