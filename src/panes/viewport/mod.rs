//! The 3D view: its header, what lies over it, and what it says where nothing is open.

pub(crate) mod camera_drag;
pub mod empty_state;
pub(crate) mod fits;
pub mod header;
pub mod overlay;
pub(crate) mod overlay_view;
pub(crate) mod pace;
pub(crate) mod paint;
pub(crate) mod pick_label;
pub(crate) mod places;
pub(crate) mod queries;
pub(crate) mod shown_subject;
pub(crate) mod spec;
#[expect(
    clippy::module_inception,
    reason = "the folder's main type carries the folder's name"
)]
pub(crate) mod viewport;

pub use {empty_state::*, header::*, overlay::*};
