//! What the window shows, as plain values. It knows neither widgets nor how commands are applied.
//!
//! Begin with [`State`]: the [`Document`], which holds what the user chose and is what undo restores ([`History`]); the
//! [`PlayClock`]; and the [`Answers`] of the store in this frame, which no undo touches. Panes read it, `app::apply`
//! changes it.

pub(crate) mod answers;
pub(crate) mod cohort_sort;
pub(crate) mod differences;
#[expect(
    clippy::module_inception,
    reason = "the room's main type carries the room's name"
)]
pub(crate) mod document;
pub(crate) mod editing;
pub(crate) mod error_card;
pub(crate) mod images;
pub(crate) mod import;
pub(crate) mod interpolated_poses;
pub(crate) mod loop_range;
pub(crate) mod path_entry;
pub(crate) mod play;
mod reading;
pub(crate) mod relisting;
pub(crate) mod slice_view;
pub(crate) mod state;
#[cfg(test)]
pub(crate) mod testing;
pub(crate) mod theme_choice;
pub(crate) mod transported;
pub(crate) mod undo;
pub(crate) mod verdicts;
pub(crate) mod view_mode;
pub(crate) mod viewpoint;
pub(crate) mod visibility;
pub(crate) mod visible_poses;

pub use {
    answers::*, cohort_sort::*, differences::*, document::*, editing::*, error_card::*, images::*,
    import::*, interpolated_poses::*, loop_range::*, path_entry::*, play::*,
};
pub use {
    slice_view::*, state::*, theme_choice::*, transported::*, undo::*, view_mode::*, viewpoint::*,
};
pub use {visibility::*, visible_poses::*};
