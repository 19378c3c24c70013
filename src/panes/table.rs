//! The panes of the window: menus, palette, layout and tests read this table.

use super::commands::Pane;
use super::pane::PaneSpec;
use super::{
    activity, bulls_eye, cohort, curves, deformation_map, import, measures, medial_map, metric,
    patch, pose_map, slices, spatiotemporal, thickness, verdict, viewport,
};

/// All panes, in the order of their tabs.
pub const PANES: &[PaneSpec] = &[
    cohort::spec::PANE,
    activity::spec::PANE,
    metric::spec::PANE,
    import::spec::PANE,
    viewport::spec::PANE,
    slices::spec::PANE,
    import::spec::BATCH_PANE,
    pose_map::spec::PANE,
    deformation_map::spec::PANE,
    spatiotemporal::spec::PANE,
    medial_map::spec::PANE,
    measures::spec::PANE,
    patch::spec::PANE,
    verdict::spec::PANE,
    bulls_eye::spec::PANE,
    curves::spec::PANE,
    thickness::spec::PANE,
];

/// The line of a pane.
pub fn spec_of(pane: Pane) -> Option<&'static PaneSpec> {
    PANES.iter().find(|spec| spec.pane == pane)
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn words_titles_and_toggles_of_panes_are_their_own() {
        for name in [
            |spec: &PaneSpec| spec.pane.word(),
            |spec: &PaneSpec| spec.title,
            |spec: &PaneSpec| spec.toggle,
        ] {
            let names: HashSet<&str> = PANES.iter().map(name).collect();
            assert_eq!(names.len(), PANES.len());
        }
    }

    #[test]
    fn saved_layouts_know_panes_by_words_that_never_change() {
        let words: Vec<&str> = PANES.iter().map(|spec| spec.pane.word()).collect();
        let known = [
            "cohort",
            "activity",
            "metric",
            "import",
            "viewport",
            "slices",
            "batch",
            "pose_map",
            "deformation_map",
            "space_time",
            "medial_map",
            "measures",
            "patch",
            "verdict",
            "bulls_eye",
            "curves",
            "thickness",
        ];
        assert_eq!(words[..known.len()], known);
    }
}
