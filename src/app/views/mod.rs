//! What each panel shows, built from the state: one file per panel.

mod beat_view;
mod bulls_eye_view;
mod cohort_view;
mod deformation_view;
mod evidence;
mod header_view;
mod map_view;
mod medial_map_view;
mod menu_view;
pub(super) mod overlay_view;
mod patch_view;
mod patch_words;
mod report_view;
mod scatter;
mod status_view;
mod thickness_view;
mod verdict_view;

pub use beat_view::{BeatData, measures_view};
pub use bulls_eye_view::BullsEyeData;
pub use cohort_view::{CohortData, visible_subjects};
pub use deformation_view::{DeformationData, enough_subjects, metric_panel_view};
pub use header_view::viewport_header_view;
pub use map_view::MapData;
pub use medial_map_view::MedialMapData;
pub use menu_view::{action_state, menu_bar_view};
pub use overlay_view::phase_name;
pub use patch_view::PatchData;
pub use report_view::report_entries;
pub use status_view::{StatusData, activity_rows};
pub use thickness_view::ThicknessData;
pub use verdict_view::VerdictData;
