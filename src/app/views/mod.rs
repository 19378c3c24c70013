//! What each panel shows, built from the state: one file per panel.

mod beat_view;
mod cohort_view;
mod menu_view;
mod status_view;

pub use beat_view::BeatData;
pub use cohort_view::{CohortData, visible_subjects};
pub use menu_view::{action_state, menu_bar_view};
pub use status_view::{StatusData, activity_rows};
