//! The window's picture, kept from frame to frame: only the places where something changed are drawn again.
//!
//! egui draws the whole window anew for every move of the pointer. Where the processor draws (remote desktops, virtual
//! machines, computers without a driver), nearly all of a frame's time goes into those pixels.

mod changes;
mod hook;
mod kept;
mod target;
#[cfg(test)]
mod tests;

pub use hook::KeepPicture;
pub use kept::install;
