//! The 3D view: its header, what lies over it, and what it says where nothing is open.

pub mod empty_state;
pub mod header;
pub mod overlay;
