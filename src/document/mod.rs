//! What the window shows, as plain values. It knows neither widgets nor how commands are applied.
//!
//! Begin with [`State`]: the [`Document`], which holds what the user chose and is what undo restores ([`History`]); the
//! [`PlayClock`]; and the [`Answers`] of the store in this frame, which no undo touches. Panes read it, `app::apply`
//! changes it.

pub(crate) mod answers;
pub(crate) mod differences;
#[expect(
    clippy::module_inception,
    reason = "the room's main type carries the room's name"
)]
pub(crate) mod document;
pub(crate) mod error_card;
pub(crate) mod in_betweens;
pub(crate) mod play;
pub(crate) mod state;
#[cfg(test)]
pub(crate) mod testing;
pub(crate) mod theme_choice;
pub(crate) mod transported;
pub(crate) mod undo;
pub(crate) mod verdicts;
pub(crate) mod view_mode;
pub(crate) mod viewpoint;
pub(crate) mod visible_poses;

pub use answers::{Answers, FoundWall};
pub use differences::{PosePair, hindrance, pair_on_screen};
pub use document::{
    Document, OpeningReport, Sorting, StudyRef, TransportedMotion, Visibility, nearest_frame,
    phase_of, position_at_phase,
};
pub use error_card::ErrorCard;
pub use in_betweens::{
    BeatInBetweens, BeatMemo, BetweenWords, between_words, geodesic_params, interval_count,
};
pub use play::{PlayClock, SPEEDS, beat_s, is_between, pose_at, pose_in};
pub use state::{Sheets, State};
pub use theme_choice::ThemeChoice;
pub use transported::{TransportState, TransportedSubject, transport_params, transported_title};
pub use undo::{Gesture, History};
pub use view_mode::ViewMode;
pub use viewpoint::{Direction, Look};
pub use visible_poses::{VisiblePose, visible_poses};
