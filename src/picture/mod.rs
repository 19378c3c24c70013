//! A heart at a pose as a scene with colours, legends and labels: what the window and exported figures share.

mod quantity;

pub use quantity::Quantity;
