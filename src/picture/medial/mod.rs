//! The middle of the wall in pictures: atoms as discs, spokes, patches outlined, and PT on every surface.

mod discs;
mod marks;
mod nearest;
mod outline;
mod prepared;
#[cfg(test)]
mod tests;

pub use marks::{HeartMedial, MedialSettings, PatchLook, WallPart};
pub(super) use marks::{add_marks, atom_legend};
pub use prepared::PreparedMedial;
