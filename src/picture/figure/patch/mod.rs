//! The patch figure: a heart, its bull's-eye, its patches in a table, the verdict, and how all of it was made.

mod bulls_eye;
mod content;
mod draw;
mod frame;
mod make;
mod order;

pub use bulls_eye::BullsEyeContent;
pub(in crate::picture) use bulls_eye::draw_bulls_eye;
pub use make::rendered_patch_figure;
pub use order::PatchOrder;
