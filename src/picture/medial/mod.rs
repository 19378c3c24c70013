//! The middle of the wall in pictures: atoms as discs, spokes, patches outlined, and PT on every surface.

mod discs;
mod facing;
mod marks;
mod nearest;
mod outline;
mod prepared;
mod settings;
#[cfg(test)]
mod tests;

pub use facing::facing_patch;
pub(super) use marks::{add_marks, atom_legend};
pub(in crate::picture) use outline::rounded;
pub use prepared::PreparedMedial;
pub use settings::{MedialSettings, PatchLook, SubjectMedial, WallPart};
